"""The three readings of one matrix T_ab, a pose, a change of coordinates and a motion, and a rotation about a coordinate axis."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.rigid.lie import exp, homogeneous
from kinlib.view.drawing.canvas import Canvas, moved, view_axes
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, INK, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

TITLES = ("pose", "change of coordinates", "motion")
FLAG = np.array([(0, 0, 0), (0.36, 0, 0), (0.36, 0.22, 0), (0, 0, 0)])
"""The outline of a body that shows how it is moved: a triangle with sides of different length."""

AXIS_LENGTH = 0.55


def draw_three_readings(T: ArrayLike, point: ArrayLike) -> Picture:
    """Draw the three readings of a pose T_ab in the x-y plane, side by side.

    T      (4, 4) a rotation about z and a translation in the plane
    point  (3,) a point in the plane: its coordinates in {b}, and the point from which the motion starts

    On the left, {b} as {a} sees it. In the middle, one point with a vector to it from each frame. On the right, a body and
    the same body after the motion.

    >>> T = np.array([[0, -1, 0, 1], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    >>> draw_three_readings(T, [0.5, 0, 0]).alt[60:]
    'Change of coordinates: the point (0.5, 0, 0) in {b} is (1, 0.5, 0) in {a}. Motion: a body at (0.5, 0, 0) moves to (1, 0.5, 0).'
    """
    T, x_b = np.asarray(T, dtype=float), np.asarray(point, dtype=float)
    x_a = moved(T, x_b)
    body = FLAG + x_b
    corners = np.concatenate(
        [np.zeros((1, 3)), T[None, :3, 3], [x_a, x_b], body, moved(T, body), T[:3, 3] + AXIS_LENGTH * T[:3, :2].T]
    )
    low, width = corners.min(axis=0), np.ptp(corners[:, 0]) + 0.7
    panels = [np.array([k * width, 0.0, 0.0]) for k in range(3)]
    canvas = Canvas([low, low + 2 * panels[1]], "top")
    for title, shift in zip(TITLES, panels, strict=True):
        canvas.triad(homogeneous(np.eye(3), shift), "a", AXIS_LENGTH, letters="xy")
        if title != "motion":
            canvas.triad(homogeneous(T[:3, :3], T[:3, 3] + shift), "b", AXIS_LENGTH, letters="xy")
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
    canvas.line(motion + moved(T, body), INK, 3.0)
    canvas.arrow(motion + x_b, motion + x_a, VIOLET, 2.0, style="--")
    canvas.dot(motion + x_b, GHOST_GREY, 7)
    canvas.dot(motion + x_a, INK, 7)
    before, after = vector_text(x_b), vector_text(x_a)
    angle = np.degrees(np.arctan2(T[1, 0], T[0, 0]))
    return canvas.picture(
        f"Pose: frame {{b}} at {vector_text(T[:3, 3])} in {{a}}, rotated by {angle:.3g} degrees. Change of coordinates: the point "
        f"{before} in {{b}} is {after} in {{a}}. Motion: a body at {before} moves to {after}.",
        cropped=True,
    )


def draw_rotation(axis: int, degrees: float) -> Picture:
    """Draw two frames with a common origin and one common axis, seen along that axis, and the angle between them.

    axis     the common axis: 0 for x, 1 for y, 2 for z; y points away from the viewer, x and z towards the viewer
    degrees  the angle of the rotation about that axis that takes the first frame to the second, by the right-hand rule

    >>> draw_rotation(2, 30).alt
    'Frames {a} and {b} share their z axis, which points at you. x_b is x_a rotated by 30 degrees towards y_a.'
    """
    view = ("side", "front", "top")[axis]
    first, second = (axis + 1) % 3, (axis + 2) % 3
    R_ab = exp(np.radians(degrees) * np.eye(3)[axis])
    corners = [np.eye(3)[k] * sign for k in (first, second) for sign in (-1.1, 1.1)]
    canvas = Canvas(np.array(corners), view, size=(640, 360))
    for R, name, width in ((np.eye(3), "a", 1.4), (R_ab, "b", 2.6)):
        for k in (first, second):
            canvas.arrow(np.zeros(3), R[:, k], AXIS_COLOURS[k], width)
            canvas.label(1.12 * R[:, k], f"${'xyz'[k]}_{name}$", AXIS_COLOURS[k], [(0, 0)], 13)
    start, side = 0.55 * np.eye(3)[first], 0.55 * np.eye(3)[second]
    arc = [np.cos(t) * start + np.sin(t) * side for t in np.linspace(0, np.radians(degrees), 20)]
    canvas.line(arc[:-1], INK, 1.4, level=3)
    canvas.arrow(arc[-2], arc[-1], INK, 1.4)
    canvas.label(arc[10], f"{abs(degrees):.3g}°", INK, [(24, 0), (-24, 0), (0, 18), (0, -18)])
    facing = view_axes(view)[0][axis] > 0
    canvas.arrow(np.zeros(3), 0.5 * np.eye(3)[axis], AXIS_COLOURS[axis], 2.2, level=6)
    shared = "xyz"[axis]
    canvas.label(np.zeros(3), f"${shared}_a = {shared}_b$", AXIS_COLOURS[axis], [(-44, -16), (44, -16)])
    towards = f"{'' if degrees > 0 else '-'}{'xyz'[second]}_a"
    return canvas.picture(
        f"Frames {{a}} and {{b}} share their {shared} axis, which points {'at' if facing else 'away from'} you. "
        f"{'xyz'[first]}_b is {'xyz'[first]}_a rotated by {abs(degrees):.3g} degrees towards {towards}.",
        cropped=True,
    )
