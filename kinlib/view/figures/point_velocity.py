"""The velocity of a point of a rotating body: omega x p about an axis through the origin, and v = -omega x p at the origin."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import around


def draw_point_velocity(omega: ArrayLike, p: ArrayLike) -> Picture:
    """Draw an axis through the origin, a point p of a body that rotates about it, its circle, and its velocity omega x p.

    omega  (3,) the angular velocity;  p  (3,) the point, not on the axis

    Raises ValueError if omega or p does not have shape (3,), or if p is on the axis.

    >>> draw_point_velocity([0, 0, 1], [2, 0, 1]).alt           # doctest: +NORMALIZE_WHITESPACE
    'A body rotates about the axis through the origin with omega = (0, 0, 1). The arrow p leads from the origin to the point
    (2, 0, 1), which moves on a circle of radius 2 about the axis. Its velocity omega x p = (0, 2, 0) is perpendicular to both
    arrows.'
    """
    w, point = (validation.vectors(x, name, 3) for x, name in ((omega, "omega"), (p, "p")))
    velocity = np.cross(w, point)
    canvas, foot = _rotating(w, np.zeros(3), point, p=point, velocity=velocity, name="$\\omega$ × $p$")
    return canvas.picture(
        f"A body rotates about the axis through the origin with omega = {vector_text(w)}. The arrow p leads from the origin to the "
        f"point {vector_text(point)}, which moves on a circle of radius {np.linalg.norm(point - foot):.3g} about the axis. Its "
        f"velocity omega x p = {vector_text(velocity)} is perpendicular to both arrows.",
        cropped=True,
    )


def draw_moment(omega: ArrayLike, p: ArrayLike) -> Picture:
    """Draw an axis omega through p, the arrow p from the origin to it, and v = -omega x p, the velocity of the point at the origin.

    omega  (3,) a unit vector;  p  (3,) a point on the axis, which does not pass through the origin

    Raises ValueError if omega or p does not have shape (3,), or if the axis passes through the origin.

    >>> draw_moment([0, 0, 1], [2, 0, 1]).alt                   # doctest: +NORMALIZE_WHITESPACE
    'A body rotates about the axis with direction omega = (0, 0, 1) through p = (2, 0, 1). The arrow p leads from the origin of
    {s} to the axis. The point of the body at the origin moves on a circle of radius 2 about the axis, and its velocity is
    v = -omega x p = (0, -2, 0), perpendicular to omega and p.'
    """
    w, point = (validation.vectors(x, name, 3) for x, name in ((omega, "omega"), (p, "p")))
    v = -np.cross(w, point)
    canvas, foot = _rotating(w, point, np.zeros(3), p=point, velocity=v, name="$v$ = −$\\omega$ × $p$")
    return canvas.picture(
        f"A body rotates about the axis with direction omega = {vector_text(w)} through p = {vector_text(point)}. The arrow p leads "
        f"from the origin of {{s}} to the axis. The point of the body at the origin moves on a circle of radius "
        f"{np.linalg.norm(foot):.3g} about the axis, and its velocity is v = -omega x p = {vector_text(v)}, perpendicular to omega "
        "and p.",
        cropped=True,
    )


def _rotating(w: Array, through: Array, at: Array, *, p: Array, velocity: Array, name: str) -> tuple[Canvas, Array]:
    """Draw {s}, an axis w through a point, the circle of a point `at` about it with its velocity, and p.

    The velocity is drawn as long as the radius. Returns the canvas and the centre of the circle.
    """
    axis = w / np.linalg.norm(w)
    centre = through + axis @ (at - through) * axis
    radius = float(np.linalg.norm(at - centre))
    if radius < 1e-9:
        raise ValueError(
            f"the circle must have a radius; got an axis through {vector_text(through)} that contains {vector_text(at)}."
        )
    circle = centre + around(axis, radius, np.linspace(0, 2 * np.pi, 73))
    ends = sorted([0.0, float(axis @ (through - centre))])
    low, high = centre + (ends[0] - 0.5 * radius) * axis, centre + (ends[1] + 0.9 * radius) * axis
    canvas = Canvas([*circle, low, high, np.zeros(3), through], size=(560, 420))
    canvas.line(circle, GREY, 1.4, level=1)
    canvas.line([centre, at], GREY, 1.4, ":", level=1)
    canvas.axis(low, high, "$\\omega$", width=1.8, level=2, size=14)
    canvas.triad(np.eye(4), "s", 0.17 * canvas.size)
    canvas.arrow(np.zeros(3), p, ORANGE, 2.6, level=6)
    canvas.label(p / 2, "$p$", ORANGE, size=14)
    tip = at + velocity / np.linalg.norm(w)
    canvas.arrow(at, tip, INK, 2.6, level=6)
    canvas.label(tip, name, INK, size=14)
    canvas.dot(p, INK, 7)
    return canvas, centre
