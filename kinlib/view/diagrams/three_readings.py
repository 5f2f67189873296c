"""The three readings of one matrix T_ab: a pose, a change of coordinates and a motion."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

TITLES = ("pose", "change of coordinates", "motion")
FLAG = np.array([(0, 0, 0), (0.36, 0, 0), (0.36, 0.22, 0), (0, 0, 0)])
"""The outline of a body that shows how it is moved: a triangle with sides of different length."""


AXIS_LENGTH = 0.55


def draw_three_readings(T: ArrayLike, point: ArrayLike, *, caption: str = "") -> Picture:
    """Draw the three readings of a pose T_ab in the x-y plane, side by side.

    T      (4, 4) a rotation about z and a translation in the plane
    point  (3,) a point in the plane: its coordinates in {b}, and the point from which the motion starts

    On the left, {b} as {a} sees it. In the middle, one point with a vector to it from each frame. On the right, a body and
    the same body after the motion.

    Raises ValueError if T is not a pose, point does not have shape (3,), or they leave the x-y plane.

    >>> T = np.array([[0, -1, 0, 1], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    >>> draw_three_readings(T, [0.5, 0, 0]).alt[60:]
    'Change of coordinates: the point (0.5, 0, 0) in {b} is (1, 0.5, 0) in {a}. Motion: a body at (0.5, 0, 0) moves to (1, 0.5, 0).'
    """
    T, x_b = validation.poses(T, "T"), validation.vectors(point, "point", 3)
    if not np.allclose([*T[2], *T[:2, 2], x_b[2]], [0, 0, 1, 0, 0, 0, 0]):
        raise ValueError("T must be a rotation about z and a translation in x and y, and point must have z = 0.")
    x_a = T[:3, :3] @ x_b + T[:3, 3]
    body = FLAG + x_b
    corners = np.concatenate(
        [np.zeros((1, 3)), T[None, :3, 3], [x_a, x_b], body, _moved(T, body), T[:3, 3] + AXIS_LENGTH * T[:3, :2].T]
    )
    low, width = corners.min(axis=0), np.ptp(corners[:, 0]) + 0.7
    panels = [np.array([k * width, 0.0, 0.0]) for k in range(3)]
    canvas = Canvas([low, low + 2 * panels[1]], "top")
    for title, shift in zip(TITLES, panels, strict=True):
        _draw_axes(canvas, np.eye(4), "a", shift)
        if title != "motion":
            _draw_axes(canvas, T, "b", shift)
        canvas.label(np.add(shift, (low[0] + width / 2 - 0.4, low[1] - 0.5, 0)), title, INK, [(0, 0)], 14)
    pose, change, motion = panels
    canvas.arrow(pose, pose + T[:3, 3], VIOLET, 2.0)
    canvas.label(pose + T[:3, 3] / 2, "$p_{ab}$", VIOLET)
    canvas.arrow(change, change + x_a, ORANGE, 2.0)
    canvas.arrow(change + T[:3, 3], change + x_a, ORANGE, 2.0)
    canvas.dot(change + x_a, INK, 7)
    canvas.label(change + x_a / 2, "$x_a$", ORANGE)
    canvas.label(change + (T[:3, 3] + x_a) / 2, "$x_b$", ORANGE)
    canvas.line(motion + body, GHOST_GREY, 3.0)
    canvas.line(motion + _moved(T, body), INK, 3.0)
    canvas.arrow(motion + x_b, motion + x_a, VIOLET, 2.0, style="--")
    canvas.dot(motion + x_b, GHOST_GREY, 7)
    canvas.dot(motion + x_a, INK, 7)
    before, after = vector_text(x_b), vector_text(x_a)
    angle = np.degrees(np.arctan2(T[1, 0], T[0, 0]))
    return canvas.picture(
        f"Pose: frame {{b}} at {vector_text(T[:3, 3])} in {{a}}, rotated by {angle:.3g} degrees. Change of coordinates: the point "
        f"{before} in {{b}} is {after} in {{a}}. Motion: a body at {before} moves to {after}.",
        caption,
        cropped=True,
    )


def _moved(T: Array, points: Array) -> Array:
    moved: Array = points @ T[:3, :3].T + T[:3, 3]
    return moved


def _draw_axes(canvas: Canvas, T: Array, name: str, shift: Array) -> None:
    origin = shift + T[:3, 3]
    for axis, letter, colour in zip(T[:3, :2].T, "xy", AXIS_COLOURS, strict=False):
        tip = origin + AXIS_LENGTH * axis
        canvas.arrow(origin, tip, colour, 2.2)
        canvas.label(origin + 1.18 * AXIS_LENGTH * axis, letter, colour, [(0, 0), (8, 8), (-8, -8)], 10)
    canvas.label(origin, f"{{{name}}}", INK, [(-14, -12), (14, -14), (-16, 12)], 11)
