"""Frames that a slider moves, in three dimensions: the reader can rotate the view and compare directions."""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.parts import draw_parts, frame_part, line_part
from kinlib.view.viewer.pictures import value_text
from kinlib.view.viewer.scene import room
from kinlib.view.viewer.steps import Steps, frame_arm

AXIS_SHARE, SMALLEST_M = 0.3, 0.3
"""The length of the axes as a share of the extent of the origins, and the least extent, if the frames share an origin."""


def slide_frames(
    frames_at: Callable[[Any], Mapping[str, ArrayLike]],
    label: str,
    values: Sequence[Any],
    *,
    caption: Callable[[Any], str] = lambda _: "",
    arrows: bool = False,
    after: Any = None,
) -> Steps:
    """Show frames in three dimensions, with one slider that moves them.

    frames_at  a function from a value to {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame; always the same names
    label      what the values are
    values     the values of the slider, in order
    caption    a function from a value to the caption
    arrows     whether an arrow leads from the origin of each frame to that of the next
    after      a question; the picture stays covered until a prediction is committed

    Raises ValueError if there are no values, or if a frame is not a pose.

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
    poses = np.array([[validation.poses(T, f"frame {name}") for name, T in one.items()] for one in frames]) + 0.0
    origins = poses[..., :3, 3].reshape(-1, 3)
    extent = max(float(np.ptp(origins, axis=0).max()), SMALLEST_M)
    length = AXIS_SHARE * extent
    tips = (poses[..., :3, 3, None] + length * poses[..., :3, :3]).swapaxes(-1, -2).reshape(-1, 3)
    points = np.concatenate([origins, tips])
    region = room(points, 0.12 * extent)
    radius = region["radius"]
    stops = []
    for value, shown in zip(values, poses, strict=True):
        said, ends = caption(value), pairwise(shown[:, :3, 3] if arrows else [])
        stops.append(
            {
                "title": value_text(value),
                "texts": [said],
                "alt": " ".join([said, *map(frame_text, zip(names, shown, strict=True))]).strip(),
                "poses": shown.reshape(-1, 16).tolist(),
                "parts": [line_part(a, b, "quiet", tip=True) for a, b in ends if np.linalg.norm(b - a) > 1e-6 * radius],
            }
        )

    def draw(player: Steps) -> Picture:
        canvas, stop = Canvas(points), player.stop
        canvas.floor(points)
        shown = zip(names, np.reshape(stop["poses"], (-1, 4, 4)), strict=True)
        frames = [frame_part(T, "Oxyz", name=name, length=length / radius) for name, T in shown]
        draw_parts(canvas, [*stop["parts"], *frames], radius)
        return canvas.picture(player.alt, stop["texts"][0], cropped=True)

    scene = {
        "name": "frames",
        "size": radius,
        "arms": [frame_arm(T) for T in poses[0]],
        "room": region | {"constant": True},
        "floor": float(points[:, 2].min()) - 0.1 * extent,
        "offered": [],
    }
    mode = {"variants": {"": {"stops": stops}}, "label": label, "movers": names, "length": length / radius}
    return Steps(scene, mode, draw, after=after)
