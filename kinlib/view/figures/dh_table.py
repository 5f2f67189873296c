"""Drawings of DH tables: the arm of a table with its frames."""

from itertools import accumulate

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.dh.table import DHTable
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, LIGHT_AND_DARK, PALE_GREY
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import pose_text
from kinlib.view.figures.frame_assignment import translations
from kinlib.view.figures.joint_bodies import draw_joint_bodies
from kinlib.view.figures.parts import draw_parts, frame_part, ranks


def draw_table(
    table: DHTable,
    q: ArrayLike | None = None,
    *,
    numbers: bool = False,
    path: bool = True,
    caption: str = "",
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw the arm that a table describes at q (n,), zero by default, with the frames of the table: x_i and z_i, without y_i.

    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off
    path     whether the translations of the rows are drawn from frame to frame: d along z in violet, a along x in orange
    around   points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    >>> draw_table(DHTable([[1, 0, 0, 0]], convention="standard")).alt
    'table. Frame 0 at (0, 0, 0), x along (1, 0, 0), z along (0, 0, 1). Frame 1 at (1, 0, 0), x along (1, 0, 0), z along (0, 0, 1).'
    """
    q = np.zeros(table.n) if q is None else validation.vectors(q, "q", table.n)
    frames = np.stack([*accumulate(table.link_transforms(q), np.matmul, initial=table.base)])
    origins, tip = frames[:, :3, 3], frames[-1] @ table.tool
    ways = translations(frames, table.convention)
    corners = [part["to"] for part in ways]
    floor = origins * (1, 1, 0) if numbers else origins
    seen = np.array([np.zeros(3), *origins, *corners, tip[:3, 3], *floor])
    canvas = Canvas(seen if around is None else around, view)
    canvas.floor(seen if around is None else around, numbers=numbers)
    if numbers:
        canvas.measure(origins, GREY)
    canvas.line([np.zeros(3), origins[0]], PALE_GREY, 5.0, level=1)
    canvas.line([origins[-1], tip[:3, 3]], PALE_GREY, 5.0, level=1)
    if path:
        for part in ways:
            canvas.line([part["from"], part["to"]], LIGHT_AND_DARK[part["colour"]][0], 4.0, level=2.5)
        chain = table.to_chain()
        draw_joint_bodies(canvas, chain, chain.link_poses(q))
    shown = [
        frame_part(T, "xz", sub=str(i), rank=rank)
        for i, (T, rank) in enumerate(zip(frames, ranks(origins), strict=True))
    ]
    draw_parts(canvas, shown, canvas.size)
    for name, T in {"s": np.eye(4), "b": tip}.items():
        if not np.allclose(T, frames[0 if name == "s" else -1]):
            canvas.triad(T, name, 0.16 * canvas.size)
    said = " ".join([f"{table.name}.", *(f"Frame {i} {pose_text(T)}." for i, T in enumerate(frames))])
    return canvas.picture(said, caption, cropped=around is None)
