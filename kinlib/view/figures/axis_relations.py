"""The six ways in which two joint axes can be related, drawn: the axes, their common normals, and what these leave open."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.arrays.validation import Array
from kinlib.dh.common_normal import Case, CommonNormal, common_normal
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Gallery, Picture, vector_text
from kinlib.view.figures.arm import direction_text
from kinlib.view.figures.joint_bodies import draw_joint_body

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
    (z, origin), (w, point) = ((np.asarray(v, dtype=float) for v in axis) for axis in (first, second))
    normal = common_normal((z, origin), (w, point), X, at_other_point=True)
    size = float(np.linalg.norm(point - origin)) + 0.3
    canvas = Canvas(
        [origin, origin + 0.7 * size * z, point + 0.3 * size * w, normal.end + 0.3 * size * normal.x], size=(250, 235)
    )
    for axis, place, name, reach in ((z, origin, "1", 0.95), (w, point, "2", 0.6)):
        before = max(0.35, (place - normal.end) @ axis / size + 0.15)
        canvas.line([place - before * size * axis, place], VIOLET, 1.6, "--", level=2)
        canvas.axis(place, place + reach * size * axis, f"$z_{name}$", width=2, size=12)
        draw_joint_body(canvas, "R", axis, place)
    _draw_normals(canvas, normal, z, size)
    return canvas.picture(_describe(normal, (z, origin), (w, point)), RELATIONS[normal.case])


def _draw_normals(canvas: Canvas, normal: CommonNormal, z: Array, size: float) -> None:
    if normal.case in {"parallel", "antiparallel"}:
        for step in (-0.25, 0.25, 0.5):
            canvas.line([normal.start + step * size * z, normal.end + step * size * z], GREY, 1.4, ":", level=2.5)
    if normal.case in {"coincident", "anti-coincident"}:
        y = np.cross(z, normal.x)
        turn = np.linspace(0, 2 * np.pi, 40)[:, None]
        canvas.line(normal.start + 0.3 * size * (np.cos(turn) * normal.x + np.sin(turn) * y), GREY, 1.4, ":", level=2.5)
    canvas.line([normal.start, normal.end], ORANGE, 3.0, level=3.2)
    tip = normal.end + 0.3 * size * normal.x
    canvas.arrow(normal.end, tip, ORANGE, 2.2, level=4)
    canvas.label(tip, "$x$", ORANGE, size=12)
    for foot in (normal.start, normal.end):
        canvas.dot(foot, INK, 7)


def _describe(normal: CommonNormal, first: tuple[Array, Array], second: tuple[Array, Array]) -> str:
    axes = [f"along {direction_text(z)} through {vector_text(point)}" for z, point in (first, second)]
    length = format_number(float(np.linalg.norm(normal.end - normal.start)), 3)
    return (
        f"Axis 1 {axes[0]}, axis 2 {axes[1]}. They are {RELATIONS[normal.case]}. The one "
        f"that is drawn leads from {vector_text(normal.start)} to {vector_text(normal.end)}, its length is {length} m, and its x "
        f"points along {direction_text(normal.x)}."
    )


def draw_moving_normal(tilt: float, side: float) -> Picture:
    """Draw a vertical axis and a tilted one beside it, with their common normal and its feet, all on the same canvas.

    tilt  the angle between the axes in radians; 0 for parallel axes, of which all common normals are alike
    side  the distance of the axes in metres

    >>> draw_moving_normal(np.pi / 2, 0.8).alt
    'Axis 1 along z, axis 2 at 90 degrees to it. The common normal leads from (0, 0, 0.5) to (0.8, 0, 0.5), its length is 0.8 m.'
    """
    w = np.cos(tilt) * Z + np.sin(tilt) * Y
    point = side * X + 0.4 * Y + 0.5 * Z
    normal = common_normal((Z, 0 * Z), (w, point), X, at_other_point=True)
    canvas = Canvas([(-0.3, -0.7, -1.6), (1.3, 1.0, 1.5)])
    for axis, place, name, ends in ((Z, 0 * Z, "1", (-1.7, 1.5)), (w, point, "2", (-2.2, 1.1))):
        canvas.line([place + ends[0] * axis, place], VIOLET, 1.6, "--", level=2)
        canvas.axis(place, place + ends[1] * axis, f"$z_{name}$", width=2, size=12)
        draw_joint_body(canvas, "R", axis, place)
    if normal.is_unique and max(abs(normal.start[2]), abs(normal.end[2])) > FARTHEST_FOOT_M:
        where = f"The common normal is outside of the picture, from {vector_text(normal.start)} to {vector_text(normal.end)}"
    elif normal.is_unique:
        canvas.line([normal.start, normal.end], ORANGE, 3.2, level=3.2)
        for foot in (normal.start, normal.end):
            canvas.dot(foot, INK, 9)
        where = f"The common normal leads from {vector_text(normal.start)} to {vector_text(normal.end)}"
    else:
        for height in np.linspace(-1.2, 1.2, 7):
            canvas.line([normal.start + height * Z, normal.end + height * Z], ORANGE, 2.0, ":", level=3.2)
        where = "Every line between them that is perpendicular to both is a common normal"
    length = format_number(float(np.linalg.norm(normal.end - normal.start)), 3)
    return canvas.picture(
        f"Axis 1 along z, axis 2 at {np.degrees(tilt):.0f} degrees to it. {where}, its length is {length} m."
    )
