"""Drawings of the exponential series: its terms as arrows, head to tail, from a point to where the motion takes it."""

import numpy as np
from numpy.typing import ArrayLike

from kincourse.lecture_02_matrix_exponential.drawings.screw_motions import motion_path
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import hat
from kinlib.rigid.screw import line
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text


def partial_sums(S: ArrayLike, q: float, point: ArrayLike, terms: int) -> Array:
    """Return where the first 1, 2, ... terms of e^[S]q = I + [S]q + [S]^2 q^2 / 2! + ... take a point, (terms, 3).

    >>> partial_sums([0, 0, 1, 0, 0, 0], 1.0, [1, 0, 0], 3)
    array([[1. , 0. , 0. ],
           [1. , 1. , 0. ],
           [0.5, 1. , 0. ]])
    """
    step, term = hat(np.asarray(S) * q), np.append(np.asarray(point, dtype=float), 1.0)
    added = [term, *(term := step @ term / k for k in range(1, terms))]
    return np.cumsum(added, axis=0)[:, :3]


def draw_series(
    S: ArrayLike, q: float, point: ArrayLike, terms: int, *, most: int | None = None, view: str = "default"
) -> Picture:
    """Draw the first terms of e^[S]q as arrows, head to tail, from a point towards where the motion takes it.

    S     (6,) the axis of a revolute joint
    most  how many terms fit into the picture, so that pictures of different sums have the same scale

    The pale circle is where rotations about S take the point. If a sum ends off the circle, it is not a rotation.

    >>> draw_series(kl.robots.rpr().screws[0], np.pi / 2, (0, 0, 1), 2).alt        # doctest: +NORMALIZE_WHITESPACE
    'Terms of the exponential as arrows, head to tail, for a rotation by 90 degrees. 2 terms take the point from
    (0, 0, 1) to (-1.57, 0, 7.28). That is 4.75 m from its goal (-5, 0, 4), and 3.55 m off the circle.'
    """
    S = np.asarray(S)
    axis, foot, _ = line(S)
    sums = partial_sums(S, q, point, max(terms, most or terms))
    circle = motion_path(S * 2 * np.pi, sums[0])
    goal, reached = motion_path(S * q, sums[0])[-1], sums[terms - 1]
    seen = np.concatenate([sums, circle])
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    # No axis or frame extends beyond the points, so a smaller margin is enough.
    canvas = Canvas(middle + 0.7 * (seen - middle), view)
    canvas.line(circle, PALE_GREY, 2.0, level=1)
    canvas.line(motion_path(S * q, sums[0]), GREY, 3.0, level=1.5)
    centre = foot + axis * (axis @ (sums[0] - foot))
    canvas.dot(centre, VIOLET, 6)
    canvas.label(centre, "$S$", VIOLET)
    canvas.label(reached, "sum", INK)
    canvas.label(goal, "goal", GREY)
    for k in range(1, terms):
        colour = (VIOLET, ORANGE)[k % 2]
        canvas.arrow(sums[k - 1], sums[k], colour, 1.6)
        if np.linalg.norm(sums[k] - sums[k - 1]) > 0.06 * canvas.size:
            canvas.label((sums[k - 1] + sums[k]) / 2, str(k), colour, size=9)
    canvas.dot(goal, GREY, 9, level=4)
    canvas.dot(sums[0], INK, 4)
    canvas.dot(reached, INK, 6)
    far = float(np.linalg.norm(reached - goal))
    off = float(np.linalg.norm(reached - centre) - np.linalg.norm(sums[0] - centre))
    distance = f"{_metres(far)} from its goal"
    alt = (
        f"Terms of the exponential as arrows, head to tail, for a rotation by {np.degrees(q):.4g} degrees. "
        f"{terms} term{'s take' if terms > 1 else ' takes'} the point from {vector_text(sums[0])} to {vector_text(reached)}. "
        f"That is {distance} {vector_text(goal)}, and {_metres(abs(off))} off the circle."
    )
    caption = f"{terms} term{'s' * (terms > 1)}: the sum is {distance}, {_metres(abs(off))} off the circle"
    return canvas.picture(alt, caption)


def _metres(x: float) -> str:
    if x < 1e-12:
        return "less than 1e-12 m"  # below this the digits are rounding errors
    return f"{x:.1e} m" if x < 1e-3 else f"{x:.3g} m"
