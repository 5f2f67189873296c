"""The velocity of a point of a rotating body: omega x p about an axis through the origin, and v = -omega x p at the origin."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.bodies import circle


def draw_point_velocity(omega: ArrayLike, p: ArrayLike, *, moment: bool = False) -> Picture:
    """Draw an axis, the arrow p, a point of a body that rotates about the axis, its circle, and its velocity, as long as the radius.

    omega   (3,) the angular velocity
    p       (3,) the point, whose velocity is omega x p, while the axis passes through the origin
    moment  whether p is a point on the axis instead, and the velocity that of the point at the origin, v = -omega x p

    Raises ValueError if omega or p does not have shape (3,), or if the point is on the axis.

    >>> draw_point_velocity([0, 0, 1], [2, 0, 1], moment=True).alt           # doctest: +NORMALIZE_WHITESPACE
    'A body rotates about the axis through (2, 0, 1) with omega = (0, 0, 1). The arrow p leads from the origin to (2, 0, 1). The
    point of the body at (0, 0, 0) moves on a circle of radius 2 about the axis. Its velocity v = -omega x p = (0, -2, 0) is
    perpendicular to omega and p.'
    """
    w, arrow = (validation.vectors(x, name, 3) for x, name in ((omega, "omega"), (p, "p")))
    through, at = (arrow, np.zeros(3)) if moment else (np.zeros(3), arrow)
    velocity, axis = np.cross(w, at - through), w / np.linalg.norm(w)
    centre = through + axis @ (at - through) * axis
    radius = float(np.linalg.norm(at - centre))
    if radius < 1e-9:
        raise ValueError(
            f"the circle must have a radius; got an axis through {vector_text(through)} that contains {vector_text(at)}."
        )
    path = centre + radius * circle(axis, 72)[np.arange(73) % 72]
    ends = sorted([0.0, float(axis @ (through - centre))])
    low, high = centre + (ends[0] - 0.5 * radius) * axis, centre + (ends[1] + 0.9 * radius) * axis
    canvas = Canvas([*path, low, high, np.zeros(3), through], size=(560, 420))
    canvas.line(path, GREY, 1.4, level=1)
    canvas.line([centre, at], GREY, 1.4, ":", level=1)
    canvas.axis(low, high, "$\\omega$", width=1.8)
    canvas.triad(np.eye(4), "s", 0.17 * canvas.size)
    canvas.arrow(np.zeros(3), arrow, ORANGE, 2.6, level=6)
    canvas.label(arrow / 2, "$p$", ORANGE, size=14)
    tip = at + velocity / np.linalg.norm(w)
    canvas.arrow(at, tip, INK, 2.6, level=6)
    canvas.label(tip, "$v$ = −$\\omega$ × $p$" if moment else "$\\omega$ × $p$", INK, size=14)
    canvas.dot(arrow, INK, 7)
    return canvas.picture(
        f"A body rotates about the axis through {vector_text(through)} with omega = {vector_text(w)}. The arrow p leads from the "
        f"origin to {vector_text(arrow)}. The point of the body at {vector_text(at)} moves on a circle of radius {radius:.3g} about "
        f"the axis. Its velocity {'v = -omega' if moment else 'omega'} x p = {vector_text(velocity)} is perpendicular to omega and p.",
        cropped=True,
    )
