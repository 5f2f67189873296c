"""Angles, which are the same after a full turn."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array


def wrap_angle(angle: ArrayLike) -> Array:
    """Bring angles into the interval (-pi, pi] by full turns.

    angle (...) in radians -> (...). An angle that lies between -pi and pi comes back to the last bit.

    >>> wrap_angle([np.pi, -np.pi, 3 * np.pi / 2, 0.5])
    array([ 3.14159265,  3.14159265, -1.57079633,  0.5       ])
    """
    angle = np.asarray(angle, dtype=float)
    # Beside -pi the quotient is rounded to -1/2, so that what lies in the interval already has to be left out.
    is_inside = (-np.pi < angle) & (angle <= np.pi)
    return np.where(is_inside, angle, angle - 2 * np.pi * np.ceil(angle / (2 * np.pi) - 0.5))
