"""Drawings of DH tables: one row as the four numbers between two axes, and a whole table as its arm with its frames."""

from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import DHTable, joint_transform, normal_transform
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import direction_text, pose_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies
from kinlib.view.figures.parts import ranks


def draw_row(row: ArrayLike, *, caption: str = "") -> Picture:
    """Draw what the four numbers of a standard row, a, alpha, d, theta (4,), measure, and frame i at its end.

    The axes z_{i-1} and z_i are violet, their common normal is orange, and x_{i-1} is red.

    >>> draw_row([0.8, 0, 0.6, np.pi / 2]).alt
    'One row of a table, with all four numbers. The frame is at (0, 0.8, 0.6), its x along y, its z along z.'
    """
    a, alpha, d, theta = validation.vectors(row, "row", 4)
    foot = joint_transform(d, theta)  # on z_{i-1}
    end = foot @ normal_transform(a, alpha)  # on z_i
    start, corner, tip = np.zeros(3), foot[:3, 3], end[:3, 3]
    canvas = Canvas([start, corner, tip])
    size, length = canvas.size, 0.38 * canvas.size
    canvas.axis((0, 0, -0.1 * size), (0, 0, max(0.0, d) + 0.62 * size), "$z_{i-1}$", width=1.4, level=2)
    canvas.axis(tip - 0.45 * size * end[:3, 2], tip + 0.62 * size * end[:3, 2], "$z_i$", width=1.4, level=2)
    canvas.line([corner, tip], ORANGE, 2.0, ":", level=2.5)
    canvas.arrow(start, (length, 0, 0), AXIS_COLOURS[0], 2.2)
    canvas.label((length, 0, 0), "$x_{i-1}$", AXIS_COLOURS[0])
    canvas.line([start, 0.9 * length * foot[:3, 0]], GREY, 1.2, ":", level=2.5)
    _arc(canvas, start, 0.7 * length * np.eye(3)[:, :2], theta, "θ")
    canvas.line([start, corner], VIOLET, 3.4, level=3)
    canvas.label(corner / 2, "$d$", VIOLET, [(-14, 0), (14, 0)], 13)
    canvas.line([corner, tip], ORANGE, 3.4, level=3)
    canvas.label((corner + tip) / 2, "$a$", ORANGE, [(0, 13), (0, -13)], 13)
    canvas.line([tip, tip + 0.9 * length * foot[:3, 2]], GREY, 1.2, ":", level=2.5)
    _arc(canvas, tip, 0.9 * length * np.stack([foot[:3, 2], -foot[:3, 1]], axis=1), alpha, "α")
    canvas.dot(corner, GREY)
    canvas.dot(tip, GREY)
    canvas.triad(end, "", length)
    directions = f"its x along {direction_text(end[:3, 0])}, its z along {direction_text(end[:3, 2])}"
    head = "One row of a table, with all four numbers."
    return canvas.picture(f"{head} The frame is at {vector_text(tip)}, {directions}.", caption, cropped=True)


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
    standard = table.convention == "standard"
    # where the translation along one axis ends and the other begins
    first = frames[:-1, :3, 2 if standard else 0]
    corners = origins[:-1] + (np.diff(origins, axis=0) * first).sum(axis=1, keepdims=True) * first
    floor = origins * (1, 1, 0) if numbers else origins
    seen = np.concatenate([np.zeros((1, 3)), origins, corners, tip[None, :3, 3], floor])
    canvas = Canvas(seen if around is None else around, view)
    canvas.floor(seen if around is None else around, numbers=numbers)
    if numbers:
        canvas.measure(origins, GREY)
    canvas.line([np.zeros(3), origins[0]], PALE_GREY, 5.0, level=1)
    canvas.line([origins[-1], tip[:3, 3]], PALE_GREY, 5.0, level=1)
    if path:
        colours = (VIOLET, ORANGE) if standard else (ORANGE, VIOLET)
        for stops in zip(origins, corners, origins[1:], strict=False):
            for ends, colour in zip(pairwise(stops), colours, strict=True):
                canvas.line(ends, colour, 4.0, level=2.5)
        chain = table.to_chain()
        draw_joint_bodies(canvas, chain, chain.link_poses(q))
    for i, (T, rank) in enumerate(zip(frames, ranks(origins), strict=True)):
        for k, letter in ((0, "x"), (2, "z")):
            end = T[:3, 3] + (0.2 + 0.09 * rank) * canvas.size * T[:3, k]
            canvas.arrow(T[:3, 3], end, AXIS_COLOURS[k], 2.0, level=4 + 0.01 * k)
            canvas.label(end, f"${letter}_{i}$", AXIS_COLOURS[k])
    for name, T in {"s": np.eye(4), "b": tip}.items():
        if not np.allclose(T, frames[0 if name == "s" else -1]):
            canvas.triad(T, name, 0.16 * canvas.size)
    said = " ".join([f"{table.name}.", *(f"Frame {i} {pose_text(T)}." for i, T in enumerate(frames))])
    return canvas.picture(said, caption, cropped=around is None)


def _arc(canvas: Canvas, centre: Array, plane: Array, angle: float, name: str) -> None:
    """Draw an angle, from the plane's first direction towards its second; their length is the radius."""
    angles = np.linspace(0, angle, 24)
    points = centre + np.stack([np.cos(angles), np.sin(angles)], axis=1) @ plane.T
    canvas.line(points[:-1], INK, 1.6, level=3)
    canvas.arrow(points[-2], points[-1], INK, 1.6, level=3)
    places = [(0, 0), (6, 4), (-6, -4), (0, 14), (14, 10), (0, -14), (-14, -10)]
    canvas.label(centre + 1.22 * (points[12] - centre), name, INK, places, 13)
