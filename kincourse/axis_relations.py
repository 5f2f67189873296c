"""Two joint axes with their common normal, and what it leaves open in each of the six relations of axes: for lectures 05 and 07."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.formatting import format_number
from kinlib.dh.common_normal import Case, common_normal
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import direction_text
from kinlib.view.figures.bodies import circle
from kinlib.view.figures.joint_bodies import draw_joint_body

X = np.array([1.0, 0, 0])

FILM_CORNERS, FARTHEST_FOOT_M = [(-0.3, -0.7, -1.6), (1.3, 1.0, 1.5)], 1.9
"""What a film shows, and how far from its middle the foot of a common normal is still drawn."""

RELATIONS: dict[Case, str] = {
    "skew": "skew: one common normal",
    "intersecting": "intersecting: one common normal, of length 0",
    "parallel": "parallel: many common normals, all alike",
    "antiparallel": "antiparallel: many common normals, all alike",
    "coincident": "coincident: every perpendicular direction",
    "anti-coincident": "coincident, opposite: every perpendicular direction",
}
"""Each relation of two axes in words, with what their common normals are."""


def draw_axis_relation(
    first: tuple[ArrayLike, ArrayLike], second: tuple[ArrayLike, ArrayLike], *, film: bool = False
) -> Picture:
    """Draw two axes, each given by a unit direction and the point of its joint, and the common normal from first to second.

    film  whether it is a picture of a film about a vertical axis and one that moves beside it: all of them have the same scale,
          and they leave out x, for which the films ask

    Of parallel axes some more of their common normals are drawn dotted; of coincident axes, a circle of directions.

    >>> draw_axis_relation(((0, 0, 1), (0, 0, 0)), ((0, 0, -1), (2, 0, 1))).alt          # doctest: +NORMALIZE_WHITESPACE
    'Axis 1 along z through (0, 0, 0), axis 2 along -z through (2, 0, 1). They are antiparallel: many common normals, all
    alike. The one that is drawn leads from (0, 0, 1) to (2, 0, 1), its length is 2 m, and its x points along x.'
    """
    one, other = ((np.asarray(z, dtype=float), np.asarray(point, dtype=float)) for z, point in (first, second))
    normal = common_normal(one, other, X, at_other_point=True)
    (z, origin), (w, point) = one, other
    size = 1.6 if film else float(np.linalg.norm(point - origin)) + 0.3
    tip = normal.end + 0.3 * size * normal.x
    around = [origin, origin + 0.7 * size * z, point + 0.3 * size * w, tip]
    canvas = Canvas(FILM_CORNERS) if film else Canvas(around, size=(250, 235))
    for name, (axis, place), high in (("1", one, 0.95), ("2", other, 0.6)):
        low = -1.3 * size if film else -max(0.35 * size, (place - normal.end) @ axis + 0.15 * size)
        canvas.line([place + low * axis, place], VIOLET, 1.6, "--", level=2)
        canvas.axis(place, place + high * size * axis, f"$z_{name}$", width=2)
        draw_joint_body(canvas, "R", axis, place)
    if normal.case in {"parallel", "antiparallel"}:
        for step in (-0.5, -0.25, 0.25, 0.5):
            canvas.line([normal.start + step * size * z, normal.end + step * size * z], GREY, 1.4, ":", level=2.5)
    if normal.case in {"coincident", "anti-coincident"}:
        canvas.line(normal.start + 0.3 * size * circle(z, 40)[np.arange(41) % 40], GREY, 1.4, ":", level=2.5)
    is_far = film and max(abs(normal.start[2]), abs(normal.end[2])) > FARTHEST_FOOT_M
    if not film:
        canvas.arrow(normal.end, tip, ORANGE, 2.2, level=4)
        canvas.label(tip, "$x$", ORANGE, size=12)
    if not is_far:
        canvas.line([normal.start, normal.end], ORANGE, 3.0, level=3.2)
        for foot in (normal.start, normal.end):
            canvas.dot(foot, INK, 7)
    axes = [f"along {direction_text(along)} through {vector_text(place)}" for along, place in (one, other)]
    length = format_number(float(np.linalg.norm(normal.end - normal.start)), 3)
    ways = f"from {vector_text(normal.start)} to {vector_text(normal.end)}, its length is {length} m"
    drawn = "It is outside of the picture, and leads" if is_far else "The one that is drawn leads"
    return canvas.picture(
        f"Axis 1 {axes[0]}, axis 2 {axes[1]}. They are {RELATIONS[normal.case]}. {drawn} "
        f"{ways}{'' if film else f', and its x points along {direction_text(normal.x)}'}.",
        "" if film else RELATIONS[normal.case],
    )
