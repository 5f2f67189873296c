"""Frames that a slider moves, in three dimensions: the reader can rotate the view and compare directions."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.frames import draw_frames
from kinlib.view.viewer.scene import half_height
from kinlib.view.viewer.viewer import ViewerBase

V = TypeVar("V")

AXIS_SHARE, SMALLEST_M = 0.3, 0.3
"""The length of the axes as a share of the extent of the origins, and the least extent, if the frames share an origin."""


class FramesViewer(ViewerBase):
    """Frames on the page. Make one with `slide_frames`.

    at  the index of the value that is selected; the page and Python can both set it
    """

    at = traitlets.Int(0).tag(sync=True)
    _set_by_reader = ("at",)

    @traitlets.validate("at")
    def _validate_at(self, proposal: Any) -> int:
        index: int = proposal["value"]
        if index not in range(len(self.mode["values"])):
            raise ValueError(f"at must be the index of a value, 0 to {len(self.mode['values']) - 1}; got {index!r}.")
        return index

    @property
    def poses(self) -> dict[str, Array]:
        """The frames that are shown, by name."""
        poses = np.reshape(self.mode["poses"][self.at], (-1, 4, 4))
        return dict(zip(self.mode["names"], poses, strict=True))

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        return " ".join([self.mode["captions"][self.at], *map(frame_text, self.poses.items())]).strip()

    def _picture(self) -> Picture:
        length = self.mode["length"] * self.scene["size"]
        caption = self.mode["captions"][self.at]
        return draw_frames(self.poses, arrows=self.mode["arrows"], axis_length=length, alt=self.alt, caption=caption)


def slide_frames(
    frames_at: Callable[[V], Mapping[str, ArrayLike]],
    label: str,
    values: Sequence[V],
    *,
    caption: Callable[[V], str] | None = None,
    arrows: bool = False,
    after: Any = None,
) -> FramesViewer:
    """Show frames in three dimensions, with one slider that moves them.

    frames_at  a function from a value to {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame; always the same names
    label      what the values are
    values     the values of the slider, in order
    caption    a function from a value to the caption
    arrows     whether an arrow leads from the origin of each frame to that of the next
    after      a question; the picture stays covered until a prediction is committed

    Raises ValueError if there are no values, if a frame is not a pose, or if the names are not the same for all values.

    >>> from kinlib.rigid.lie import homogeneous
    >>> shown = slide_frames(lambda x: {"s": np.eye(4), "b": homogeneous(np.eye(3), (x, 0, 0))}, "x (m)", [0.0, 0.5, 1.0])
    >>> shown.at = 1
    >>> shown.alt[-58:]
    'Frame {b} at (0.5, 0, 0), x along x, y along y, z along z.'
    """
    if len(values) == 0:
        raise ValueError("values must contain at least one value; got none.")
    names = list(frames_at(values[0]))
    frames = [frames_at(value) for value in values]
    if wrong := [list(one) for one in frames if list(one) != names]:
        raise ValueError(f"frames_at must return the same names for all values, {names}; got {wrong[0]}.")
    poses = np.array([[validation.poses(T, f"frame {name}") for name, T in one.items()] for one in frames]) + 0.0
    origins = poses[..., :3, 3].reshape(-1, 3)
    extent = max(float(np.ptp(origins, axis=0).max()), SMALLEST_M)
    tips = (poses[..., :3, 3, None] + AXIS_SHARE * extent * poses[..., :3, :3]).swapaxes(-1, -2).reshape(-1, 3)
    points = np.concatenate([origins, tips])
    low, high = points.min(axis=0), points.max(axis=0)
    middle = (low + high) / 2
    radius = half_height(points - middle) + 0.12 * extent
    return FramesViewer(
        {
            "name": "frames",
            "size": radius,
            "arms": [{"columns": [], "joints": [], "home": T.ravel().tolist()} for T in poses[0]],
            "room": {"centre": middle.tolist(), "radius": radius, "constant": True},
            "floor": float(low[2]) - 0.1 * extent,
            "offered": [],
        },
        after=after,
        mode={
            "kind": "frames",
            "label": label,
            "values": [f"{value:.4g}" if isinstance(value, float) else str(value) for value in values],
            "captions": [caption(value) if caption else "" for value in values],
            "names": names,
            "poses": poses.reshape(len(values), len(names), 16).tolist(),
            "arrows": arrows,
            "length": AXIS_SHARE * extent / radius,
        },
    )
