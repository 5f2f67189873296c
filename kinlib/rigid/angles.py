"""Angles modulo a full turn."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array


def wrap_angle(angle: ArrayLike) -> Array:
    """Wrap angles into the interval (-pi, pi] by adding multiples of a full turn.

    angle (...) in radians -> (...). An angle that is in the interval already is returned unchanged, to the last bit.
    """
    angle = np.asarray(angle, dtype=float)
    # Near -pi the quotient is rounded to -1/2, so the formula would change angles that are in the interval already.
    is_inside = (-np.pi < angle) & (angle <= np.pi)
    return np.where(is_inside, angle, angle - 2 * np.pi * np.ceil(angle / (2 * np.pi) - 0.5))
