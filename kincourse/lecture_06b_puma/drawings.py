"""The three axes of a sequence of rotations, such as Z-Y-Z or roll, pitch and yaw, and where two of them become one."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text

SINGULAR_ANGLE_RAD = 1e-6
"""The angle up to which axes 1 and 3 count as collinear."""

AXIS_3_SHARE = 0.72
"""The length of the arrow of axis 3, as a share of that of axis 1, so that both are seen where they are collinear."""


def rotation_axes(order: str, angles: ArrayLike) -> Array:
    """Return the axes about which three successive rotations act, each rotated by those before, (3, 3) with an axis per row.

    order   the axes of the moving frame, such as "zyz"
    angles  (3,) in radians: the rotation is R_1(angles[0]) R_2(angles[1]) R_3(angles[2])

    >>> rotation_axes("zyx", [0, np.pi / 2, 0]).round(6)[2] + 0.0
    array([ 0.,  0., -1.])
    """
    units = np.eye(3)[["xyz".index(letter) for letter in order]]
    first, second, _ = exp(np.asarray(angles, dtype=float)[:, None] * units)
    return np.stack([units[0], first @ units[1], first @ second @ units[2]])


def draw_rotation_axes(order: str, angles: ArrayLike, names: tuple[str, str, str] = ("1", "2", "3")) -> Picture:
    """Draw the axes of three successive rotations in their present directions, with the circle in which axis 3 can lie.

    order   the axes of the moving frame, such as "zyz"
    angles  (3,) in radians
    names   the names of the axes, such as the joints of a wrist

    >>> draw_rotation_axes("zyz", [0, 0, 0.3]).alt[-65:]
    'Axes 1 and 3 are collinear: the sequence is at its singular case.'
    >>> draw_rotation_axes("zyz", [0, 1, 0]).caption
    'axes 1 and 3 make an angle of 57.3 degrees'
    """
    axes = rotation_axes(order, angles)
    cosine = float(np.clip(axes[0] @ axes[2], -1, 1))
    angle = float(np.arctan2(np.linalg.norm(np.cross(axes[0], axes[2])), cosine))
    is_singular = min(angle, np.pi - angle) < SINGULAR_ANGLE_RAD
    # margins take the rest of the arrows
    canvas = Canvas(0.57 * np.concatenate([np.eye(3), -np.eye(3)]), size=(250, 250))
    circle = np.linspace(0, 2 * np.pi, 60)[:, None]
    start = axes[2] * AXIS_3_SHARE
    canvas.line(np.cos(circle) * start + np.sin(circle) * np.cross(axes[1], start), PALE_GREY, 1.4, level=0.5)
    for axis, name, colour, share in zip(axes, names, (VIOLET, GREY, ORANGE), (1.0, 1.0, AXIS_3_SHARE), strict=True):
        canvas.line([-0.25 * axis, 0 * axis], colour, 1.4, "--", level=2)
        canvas.arrow(
            0 * axis, share * axis, colour, 2.4 if colour != ORANGE else 4.0, level=3 if colour != ORANGE else 2.5
        )
        canvas.label(share * axis, name, INK, size=13)
    canvas.dot(np.zeros(3), INK, 7)
    one, _, three = names
    result = f"axes {one} and {three} " + (
        "are collinear" if is_singular else f"make an angle of {np.degrees(angle):.3g} degrees"
    )
    directions = "; ".join(
        f"axis {name} along {vector_text(axis.round(3) + 0.0)}" for name, axis in zip(names, axes, strict=True)
    )
    return canvas.picture(
        f"The axes of a sequence {'-'.join(order.upper())}: {directions}. {result.capitalize()}"
        + (": the sequence is at its singular case." if is_singular else "."),
        result,
    )
