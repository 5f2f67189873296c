"""Drawings of frames by name, and of the arm of a DH table with its frames."""

from collections.abc import Mapping
from itertools import accumulate

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import DHTable
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import ORANGE, PALE_GREY
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import frame_text
from kinlib.view.figures.frame_assignment import translations
from kinlib.view.figures.joint_bodies import draw_joint_bodies
from kinlib.view.figures.parts import draw_parts, frame_part, ranks, tips


def draw_frames(frames: Mapping[str, ArrayLike], *, numbers: bool = False) -> Picture:
    """Draw frames by name.

    frames   {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame
    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off

    Raises ValueError if a frame is not a pose.

    >>> draw_frames({"s": np.eye(4)}).alt
    'Frame {s} at (0, 0, 0), x along x, y along y, z along z.'
    """
    poses = {name: validation.poses(T, f"frame {name}") for name, T in frames.items()}
    every = np.array([*poses.values()])
    origins = every[:, :3, 3]
    canvas = _on_floor(np.concatenate([origins, tips(every, 0.5)]), origins[origins.any(axis=1)], numbers)
    for name, T in poses.items():
        canvas.triad(T, name, 0.25 * canvas.size)
    return canvas.picture(" ".join(map(frame_text, poses.items())), cropped=True)


def draw_table(
    table: DHTable,
    q: ArrayLike | None = None,
    *,
    numbers: bool = False,
    caption: str = "",
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw the arm that a table describes at q (n,), zero by default, with the frames of the table: x_i and z_i, without y_i.

    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off
    around   points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    The translations of the rows lead from frame to frame: d along z in violet, a along x in orange.

    >>> draw_table(DHTable([[1, 0, 0, 0]], convention="standard")).alt
    'table. Frame {0} at (0, 0, 0), x along x, y along y, z along z. Frame {1} at (1, 0, 0), x along x, y along y, z along z.'
    """
    q = np.zeros(table.n) if q is None else validation.vectors(q, "q", table.n)
    frames = np.stack([*accumulate(table.link_transforms(q), np.matmul, initial=table.base)])
    origins, tip, chain = frames[:, :3, 3], frames[-1] @ table.tool, table.to_chain()
    ways = translations(frames, table.convention)
    seen = np.array([np.zeros(3), *origins, *(part["to"] for part in ways), tip[:3, 3]])
    canvas = _on_floor(seen if around is None else np.reshape(around, (-1, 3)), origins, numbers, view)
    canvas.line([np.zeros(3), origins[0]], PALE_GREY, 5.0, level=1)
    canvas.line([origins[-1], tip[:3, 3]], PALE_GREY, 5.0, level=1)
    draw_joint_bodies(canvas, chain, chain.link_poses(q))
    numbered = enumerate(zip(frames, ranks(origins), strict=True))
    shown = [frame_part(T, "xz", sub=str(i), rank=rank) for i, (T, rank) in numbered]
    draw_parts(canvas, [*(part | {"name": ""} for part in ways), *shown], canvas.size)
    for name, T, own in (("s", np.eye(4), frames[0]), ("b", tip, frames[-1])):
        if not np.allclose(T, own):
            canvas.triad(T, name, 0.16 * canvas.size)
    said = " ".join([f"{table.name}.", *(frame_text((str(i), T)) for i, T in enumerate(frames))])
    return canvas.picture(said, caption, cropped=around is None)


def _on_floor(seen: Array, measured: Array, numbers: bool, view: str = "default") -> Canvas:
    """Return a canvas with a floor; with numbers, the coordinates of the measured points (m, 3) can be read off."""
    seen = np.concatenate([seen, measured * (1, 1, 0)]) if numbers else seen
    canvas = Canvas(seen, view)
    canvas.floor(seen, numbers=numbers)
    if numbers:
        canvas.measure(measured, ORANGE)
    return canvas
