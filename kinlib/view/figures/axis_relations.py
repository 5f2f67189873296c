"""The six ways in which two joint axes can be related, drawn: the axes, their common normals, and what these leave open."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.dh.common_normal import Case, CommonNormal, common_normal
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Gallery, Picture, vector_text
from kinlib.view.figures.arm import direction_text
from kinlib.view.figures.joint_bodies import around, draw_joint_body

X, Y, Z = np.eye(3)

FARTHEST_FOOT_M = 1.9
"""How far from the middle of the picture the foot of a common normal is still drawn."""

RELATIONS: dict[Case, str] = {
    "skew": "skew: one common normal",
    "intersecting": "intersecting: one common normal, of length 0",
    "parallel": "parallel: many common normals, all alike",
    "antiparallel": "antiparallel: many common normals, all alike",
    "coincident": "coincident: every perpendicular direction",
    "anti-coincident": "coincident, opposite: every perpendicular direction",
}
"""Each relation of two axes in words, with what their common normals are."""

SECOND_AXES: dict[Case, tuple[Array, Array]] = {
    "skew": ((Z + Y) / np.sqrt(2), 0.8 * X + 0.5 * Z),
    "intersecting": (X, X + 0.6 * Z),
    "parallel": (Z, 0.8 * X + 0.3 * Z),
    "antiparallel": (-Z, 0.8 * X + 0.3 * Z),
    "coincident": (Z, 0.9 * Z),
    "anti-coincident": (-Z, 0.9 * Z),
}
"""For each relation an axis, as direction and point, that has it with the z axis."""


def draw_axis_relations() -> Gallery:
    """Draw the six relations of two axes, one picture each.

    >>> [picture.caption.split(":")[0] for picture in draw_axis_relations().pictures][3:]
    ['antiparallel', 'coincident', 'coincident, opposite']
    """
    return Gallery(tuple(draw_axis_relation((Z, 0 * Z), second) for second in SECOND_AXES.values()))


def draw_axis_relation(first: tuple[ArrayLike, ArrayLike], second: tuple[ArrayLike, ArrayLike]) -> Picture:
    """Draw two axes, each given by a unit direction and the point of its joint, and the common normal from first to second.

    Of parallel axes some more of their common normals are drawn dotted; of coincident axes, a circle of directions.

    >>> draw_axis_relation((Z, (0, 0, 0)), (-Z, (2, 0, 1))).alt          # doctest: +NORMALIZE_WHITESPACE
    'Axis 1 along z through (0, 0, 0), axis 2 along -z through (2, 0, 1). They are antiparallel: many common normals, all
    alike. The one that is drawn leads from (0, 0, 1) to (2, 0, 1), its length is 2 m, and its x points along x.'
    """
    one, other = ((np.asarray(z, dtype=float), np.asarray(point, dtype=float)) for z, point in (first, second))
    normal = common_normal(one, other, X, at_other_point=True)
    (z, origin), (w, point) = one, other
    size = float(np.linalg.norm(point - origin)) + 0.3
    tip = normal.end + 0.3 * size * normal.x
    canvas = Canvas([origin, origin + 0.7 * size * z, point + 0.3 * size * w, tip], size=(250, 235))
    low = [-max(0.35 * size, (place - normal.end) @ axis + 0.15 * size) for axis, place in (one, other)]
    _draw_pair(canvas, (one, other), [(low[0], 0.95 * size), (low[1], 0.6 * size)])
    if normal.case in {"parallel", "antiparallel"}:
        for step in (-0.25, 0.25, 0.5):
            canvas.line([normal.start + step * size * z, normal.end + step * size * z], GREY, 1.4, ":", level=2.5)
    if normal.case in {"coincident", "anti-coincident"}:
        circle = around(z, 0.3 * size, np.linspace(0, 2 * np.pi, 40))
        canvas.line(normal.start + circle, GREY, 1.4, ":", level=2.5)
    _draw_normal(canvas, normal, 3.0, 7)
    canvas.arrow(normal.end, tip, ORANGE, 2.2, level=4)
    canvas.label(tip, "$x$", ORANGE, size=12)
    axes = [f"along {direction_text(along)} through {vector_text(place)}" for along, place in (one, other)]
    ways = f"from {vector_text(normal.start)} to {vector_text(normal.end)}, {_length(normal)}"
    head = f"Axis 1 {axes[0]}, axis 2 {axes[1]}. They are {RELATIONS[normal.case]}. The one that is drawn leads"
    return canvas.picture(f"{head} {ways}, and its x points along {direction_text(normal.x)}.", RELATIONS[normal.case])


def draw_moving_normal(tilt: float, side: float, turn: float = 0.0) -> Picture:
    """Draw a vertical axis and a tilted one beside it, with their common normal and its feet, all on the same canvas.

    tilt  the angle between the axes in radians; 0 for parallel axes, of which all common normals are alike
    side  the distance of the axes in metres; turn is the angle in radians by which axis 2 has rotated about axis 1

    >>> draw_moving_normal(np.pi / 2, 0.8).alt
    'Axis 1 along z, axis 2 at 90 degrees to it. The common normal leads from (0, 0, 0.5) to (0.8, 0, 0.5), its length is 0.8 m.'
    """
    x, y = np.cos(turn) * X + np.sin(turn) * Y, np.cos(turn) * Y - np.sin(turn) * X
    pair = (Z, 0 * Z), (np.cos(tilt) * Z + np.sin(tilt) * y, side * x + 0.4 * y + 0.5 * Z)
    normal = common_normal(*pair, X, at_other_point=True)
    canvas = Canvas([(-0.3, -0.7, -1.6), (1.3, 1.0, 1.5)])
    _draw_pair(canvas, pair, [(-1.7, 1.5), (-2.2, 1.1)])
    feet = f"from {vector_text(normal.start)} to {vector_text(normal.end)}"
    if normal.is_unique and max(abs(normal.start[2]), abs(normal.end[2])) > FARTHEST_FOOT_M:
        where = f"The common normal is outside of the picture, {feet}"
    elif normal.is_unique:
        _draw_normal(canvas, normal, 3.2, 9)
        where = f"The common normal leads {feet}"
    else:
        for height in np.linspace(-1.2, 1.2, 7):
            canvas.line([normal.start + height * Z, normal.end + height * Z], ORANGE, 2.0, ":", level=3.2)
        where = "Every line between them that is perpendicular to both is a common normal"
    head = f"Axis 1 along z, axis 2 at {np.degrees(tilt):.0f} degrees to it."
    return canvas.picture(f"{head} {where}, {_length(normal)}.")


def _draw_pair(canvas: Canvas, axes: Sequence[tuple[Array, Array]], ends: Sequence[tuple[float, float]]) -> None:
    """Draw two axes, each from one end to the other, measured from the point of its joint."""
    for name, (axis, place), (low, high) in zip("12", axes, ends, strict=True):
        canvas.line([place + low * axis, place], VIOLET, 1.6, "--", level=2)
        canvas.axis(place, place + high * axis, f"$z_{name}$", width=2)
        draw_joint_body(canvas, "R", axis, place)


def _draw_normal(canvas: Canvas, normal: CommonNormal, width: float, foot_px: float) -> None:
    canvas.line([normal.start, normal.end], ORANGE, width, level=3.2)
    for foot in (normal.start, normal.end):
        canvas.dot(foot, INK, foot_px)


def _length(normal: CommonNormal) -> str:
    return f"its length is {format_number(float(np.linalg.norm(normal.end - normal.start)), 3)} m"
