"""Many small steps along the velocity of a point: a polygon that leaves the circle of the motion."""

import numpy as np
from numpy.typing import ArrayLike

from kincourse.lecture_02_matrix_exponential.drawings.screw_motions import motion_path
from kinlib.rigid.lie import hat
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text


def draw_small_steps(S: ArrayLike, q: float, point: ArrayLike, steps: int, *, view: str = "default") -> Picture:
    """Draw the points (I + [S]q/n)^k p for k = 0 ... n as a polygon, and the circular arc that the point p really follows.

    S      (6,) the axis of a revolute joint
    steps  n, at least 1; pictures of different n have the same scale

    >>> draw_small_steps(kl.robots.rpr().screws[0], np.pi / 2, (0, 0, 1), 4).caption
    '4 steps: the polygon ends 1.41 m from the goal'
    """
    S, p = np.asarray(S), np.append(np.asarray(point, dtype=float), 1.0)
    step = np.eye(4) + hat(S * q) / steps
    corners = np.array([np.linalg.matrix_power(step, k) @ p for k in range(steps + 1)])[:, :3]
    arc, circle = motion_path(S * q, p[:3]), motion_path(S * 2 * np.pi, p[:3])
    single = (p + hat(S * q) @ p)[:3]
    seen = np.concatenate([circle, [single]])
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    # No axis extends beyond the points, so a smaller margin is enough.
    canvas = Canvas(middle + 0.7 * (seen - middle), view)
    canvas.line(circle, PALE_GREY, 2.0, level=1)
    canvas.line(arc, GREY, 3.0, level=1.5)
    canvas.line(corners, VIOLET, 1.8)
    for corner in corners:
        canvas.dot(corner, VIOLET, 5)
    canvas.dot(arc[-1], GREY, 9, level=4)
    canvas.label(arc[-1], "goal", GREY)
    canvas.label(corners[-1], f"after {steps}", INK)
    far = float(np.linalg.norm(corners[-1] - arc[-1]))
    caption = f"{steps} step{'s' * (steps > 1)}: the polygon ends {far:.3g} m from the goal"
    alt = f"The arc of a rotation from {vector_text(p[:3])} to the goal {vector_text(arc[-1])}, and a polygon that leaves it. "
    return canvas.picture(f"{alt}{caption}, at {vector_text(corners[-1])}.", caption)
