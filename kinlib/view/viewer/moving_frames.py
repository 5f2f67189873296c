"""Frames that a slider moves, in three dimensions: the reader can rotate the view and compare directions."""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.frames import draw_frames
from kinlib.view.figures.parts import line_part
from kinlib.view.viewer.scene import half_height
from kinlib.view.viewer.steps import Steps, frame_arm, motion_scene

V = TypeVar("V")

AXIS_SHARE, SMALLEST_M = 0.3, 0.3
"""The length of the axes as a share of the extent of the origins, and the least extent, if the frames share an origin."""


class MovingFrames(Steps):
    """Frames on the page. Make one with `slide_frames`."""

    @property
    def poses(self) -> dict[str, Array]:
        """The frames that are shown, by name."""
        return dict(zip(self.mode["movers"], np.reshape(self.stop["poses"], (-1, 4, 4)), strict=True))

    def picture(self) -> Picture:
        """Draw the frames that are shown."""
        length = self.mode["length"] * self.scene["size"]
        caption = self.stop["texts"][0]
        return draw_frames(
            self.poses, arrows=bool(self.stop["parts"]), axis_length=length, alt=self.alt, caption=caption
        )


def slide_frames(
    frames_at: Callable[[V], Mapping[str, ArrayLike]],
    label: str,
    values: Sequence[V],
    *,
    caption: Callable[[V], str] | None = None,
    arrows: bool = False,
    after: Any = None,
) -> MovingFrames:
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
    frames = [frames_at(value) for value in values]
    names = list(frames[0])
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
    stops = []
    for value, shown in zip(values, poses, strict=True):
        said = caption(value) if caption else ""
        ends = [T[:3, 3] for T in shown]
        stops.append(
            {
                "title": f"{value:.4g}" if isinstance(value, float) else str(value),
                "texts": [said],
                "alt": " ".join([said, *map(frame_text, zip(names, shown, strict=True))]).strip(),
                "poses": shown.reshape(-1, 16).tolist(),
                "parts": [
                    line_part(a, b, "quiet", tip=True)
                    for a, b in pairwise(ends if arrows else [])
                    if np.linalg.norm(b - a) > 1e-6 * radius
                ],
            }
        )
    room = {"centre": middle.tolist(), "radius": radius, "constant": True}
    scene = motion_scene("frames", [frame_arm(T) for T in poses[0]], room, float(low[2]) - 0.1 * extent, radius)
    mode = {"variants": {"": {"stops": stops}}, "label": label, "movers": names, "length": AXIS_SHARE * extent / radius}
    return MovingFrames(scene, mode, after=after)
