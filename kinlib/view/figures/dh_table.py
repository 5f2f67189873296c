"""Drawings of DH tables: one row as the four numbers between two axes, and a whole table as its arm with its frames."""

from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention, DHTable, dh_transform
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import direction_text, pose_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies

TRANSLATE_X, ROTATE_X, TRANSLATE_Z, ROTATE_Z = range(4)
"""The columns of a row, a, alpha, d, theta, named by their motions."""

MOTION_ORDER: dict[Convention, tuple[int, ...]] = {
    "standard": (ROTATE_Z, TRANSLATE_Z, TRANSLATE_X, ROTATE_X),
    "modified": (ROTATE_X, TRANSLATE_X, ROTATE_Z, TRANSLATE_Z),
}
"""The four motions in the order of each convention, each about or along an axis of the moving frame."""


def poses_along_row(row: ArrayLike, convention: Convention) -> Array:
    """Return the pose of a frame after 0, 1, ..., 4 motions of a DH row, (5, 4, 4).

    row  (4,) a, alpha, d, theta, in metres and radians

    Raises ValueError if row does not have shape (4,) or the convention is unknown.

    >>> poses_along_row([0.4, 0, 0, np.pi / 2], "standard")[3, :3, 3].round(3) + 0.0
    array([0. , 0.4, 0. ])
    """
    values = validation.vectors(row, "row", 4)
    dh_transform(*values, convention=convention)  # raises ValueError if the convention is unknown
    stops = [np.eye(4)]
    for motion in MOTION_ORDER[convention]:
        stops.append(stops[-1] @ dh_transform(*np.where(np.arange(4) == motion, values, 0.0), convention=convention))
    return np.array(stops)


def draw_row(row: ArrayLike, *, caption: str = "") -> Picture:
    """Draw what the four numbers of a standard row measure, and frame i at its end.

    row  (4,) a, alpha, d, theta in metres and radians

    The axes z_{i-1} and z_i are violet, their common normal is orange, and x_{i-1} is red.

    Raises ValueError if row does not have shape (4,).

    >>> draw_row([0.8, 0, 0.6, np.pi / 2]).alt
    'One row of a table, with all four numbers. The frame is at (0, 0.8, 0.6), its x along y, its z along z.'
    """
    row = validation.vectors(row, "row", 4)
    alpha, d, theta = row[1:]
    stops = poses_along_row(row, "standard")
    foot, end = stops[2], stops[4]  # the foot is on z_{i-1}, the end on z_i
    seen = np.array([[0, 0, 0], foot[:3, 3], end[:3, 3]])
    canvas = Canvas(seen)
    length = 0.38 * canvas.size
    for T, name, low in ((np.eye(4), "$z_{i-1}$", -0.1), (end, "$z_i$", -0.45)):
        far = max(0.0, d) + 0.62 * canvas.size if name == "$z_{i-1}$" else 0.62 * canvas.size
        ends = T[:3, 3] + np.outer((low * canvas.size, far), T[:3, 2])
        canvas.axis(ends[0], ends[1], name, width=1.4, level=2)
    canvas.line([foot[:3, 3], end[:3, 3]], ORANGE, 2.0, ":", level=2.5)
    canvas.arrow((0, 0, 0), (length, 0, 0), AXIS_COLOURS[0], 2.2)
    canvas.label((length, 0, 0), "$x_{i-1}$", AXIS_COLOURS[0])
    canvas.line([np.zeros(3), 0.9 * length * foot[:3, 0]], GREY, 1.2, ":", level=2.5)
    _arc(canvas, (0, 0, 0), 0.7 * length * np.eye(3)[:, :2], theta, "θ")
    canvas.line([np.zeros(3), foot[:3, 3]], VIOLET, 3.4, level=3)
    canvas.label(foot[:3, 3] / 2, "$d$", VIOLET, [(-14, 0), (14, 0)], 13)
    canvas.line([foot[:3, 3], end[:3, 3]], ORANGE, 3.4, level=3)
    canvas.label((foot[:3, 3] + end[:3, 3]) / 2, "$a$", ORANGE, [(0, 13), (0, -13)], 13)
    canvas.line([end[:3, 3], end[:3, 3] + 0.9 * length * foot[:3, 2]], GREY, 1.2, ":", level=2.5)
    _arc(canvas, end[:3, 3], 0.9 * length * np.stack([foot[:3, 2], -foot[:3, 1]], axis=1), alpha, "α")
    canvas.dot(foot[:3, 3], GREY)
    canvas.dot(end[:3, 3], GREY)
    canvas.triad(end, "", length)
    return canvas.picture(
        f"One row of a table, with all four numbers. The frame is at {vector_text(end[:3, 3])}, its x along "
        f"{direction_text(end[:3, 0])}, its z along {direction_text(end[:3, 2])}.",
        caption,
    )


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
    """Draw the arm that a table describes, with the frames of the table: x_i and z_i, without y_i.

    q        (n,) joint values, zero by default
    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off
    path     whether the translations of the rows are drawn from frame to frame: d along z in violet, a along x in orange
    around   points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    Raises ValueError if q does not have n values.

    >>> draw_table(DHTable([[1, 0, 0, 0]], convention="standard")).alt
    'table. Frame 0 at (0, 0, 0), x along (1, 0, 0), z along (0, 0, 1). Frame 1 at (1, 0, 0), x along (1, 0, 0), z along (0, 0, 1).'
    """
    q = np.zeros(table.n) if q is None else validation.vectors(q, "q", table.n)
    frames = np.stack([*accumulate(table.link_transforms(q), np.matmul, initial=table.base)])
    corners = _corners(table, frames)
    origins = frames[:, :3, 3]
    tip = frames[-1] @ table.tool
    floor = origins * (1, 1, 0) if numbers else origins
    seen = np.concatenate([np.zeros((1, 3)), origins, corners, tip[None, :3, 3], floor])
    canvas = Canvas(seen if around is None else around, view)
    canvas.floor(seen if around is None else around, numbers=numbers)
    if numbers:
        canvas.measure(origins, GREY)
    canvas.line([np.zeros(3), origins[0]], PALE_GREY, 5.0, level=1)
    canvas.line([origins[-1], tip[:3, 3]], PALE_GREY, 5.0, level=1)
    for start, corner, end in zip(origins, corners, origins[1:], strict=False) if path else ():
        first, second = (VIOLET, ORANGE) if table.convention == "standard" else (ORANGE, VIOLET)
        canvas.line([start, corner], first, 4.0, level=2.5)
        canvas.line([corner, end], second, 4.0, level=2.5)
    if path:
        chain = table.to_chain()
        draw_joint_bodies(canvas, chain, chain.link_poses(q))
    for i, T in enumerate(frames):
        # Frames with the same origin have arrows of different length, so that none hides another.
        rank = sum(bool(np.allclose(T[:3, 3], other[:3, 3], atol=1e-6)) for other in frames[:i])
        length = (0.2 + 0.09 * rank) * canvas.size
        for k, letter in ((0, "x"), (2, "z")):
            canvas.arrow(T[:3, 3], T[:3, 3] + length * T[:3, k], AXIS_COLOURS[k], 2.0, level=4 + 0.01 * k)
            canvas.label(T[:3, 3] + length * T[:3, k], f"${letter}_{i}$", AXIS_COLOURS[k])
    for name, T in {"s": np.eye(4), "b": tip}.items():
        if not np.allclose(T, frames[0 if name == "s" else -1]):
            canvas.triad(T, name, 0.16 * canvas.size)
    return canvas.picture(_describe(table, frames), caption, cropped=around is None)


def _arc(canvas: Canvas, centre: ArrayLike, plane: Array, angle: float, name: str) -> None:
    """Draw an angle, from the plane's first direction towards its second; their length is the radius."""
    angles = np.linspace(0, angle, 24)
    points = np.asarray(centre) + np.stack([np.cos(angles), np.sin(angles)], axis=1) @ plane.T
    for start, end in pairwise(points[:-1]):
        canvas.line([start, end], INK, 1.6, level=3)
    canvas.arrow(points[-2], points[-1], INK, 1.6, level=3)
    middle = np.asarray(centre) + 1.22 * (points[12] - np.asarray(centre))
    canvas.label(middle, name, INK, [(0, 0), (6, 4), (-6, -4), (0, 14), (14, 10), (0, -14), (-14, -10)], 13)


def _corners(table: DHTable, frames: Array) -> Array:
    """Return the point between two frames at which the translation along one axis ends and the other begins, (m, 3)."""
    first = frames[:-1, :3, 2 if table.convention == "standard" else 0]
    steps = np.diff(frames[:, :3, 3], axis=0)
    return np.asarray(frames[:-1, :3, 3] + (steps * first).sum(axis=1, keepdims=True) * first)


def _describe(table: DHTable, frames: Array) -> str:
    return " ".join([f"{table.name}.", *(f"Frame {i} {pose_text(T)}." for i, T in enumerate(frames))])
