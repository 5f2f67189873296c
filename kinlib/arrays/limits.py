"""Limits of joint values: which are refused, and which look like degrees."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array

DEGREE_LIMITS = (60, 720)
"""The larger limit of a joint is between these, if it is taken to be in degrees: 50 rad are the eight turns of a spindle."""


def validate_limits(limits: ArrayLike, joint_types: str) -> Array:
    """Read limits as an array (n, 2), the lower and the upper limit of each joint, which may be infinite.

    joint_types  a letter for each joint: those of revolute joints, R, must not look like degrees

    Raises ValueError for another shape, for limits that are swapped or NaN, and for those that look like degrees.
    """
    limits, n = validation.real_array(limits, "limits"), len(joint_types)
    if limits.shape != (n, 2):
        raise ValueError(f"limits must have one row (lower, upper) per joint, shape ({n}, 2); got {limits.shape}.")
    for joint, (letter, (lower, upper)) in enumerate(zip(joint_types, limits.tolist(), strict=True), start=1):
        if not lower <= upper:  # also for NaN
            raise ValueError(
                f"The limits of joint {joint} must be (lower, upper); got {[lower, upper]}. Are they swapped?"
            )
        if letter == "R" and look_like_degrees(lower, upper):
            raise ValueError(
                f"The limits of joint {joint} must be in radians; got {[lower, upper]}, which look like degrees. Try "
                "np.radians(limits), or infinite limits for a joint that rotates without end."
            )
    return limits


def look_like_degrees(lower: float, upper: float) -> bool:
    """Return whether the limits of a revolute joint are probably in degrees: whole numbers, and beyond nine turns in radians.

    Full hundreds are not, because some files write them for a wheel, which rotates without end. No file of airo-models, rtb-data
    and example-robot-data has another limit between 10 and 1e5.
    """
    ends = [end for end in (lower, upper) if np.isfinite(end)]
    size = max(map(abs, ends), default=0)
    is_whole = all(end % 1 == 0 for end in ends)
    least, most = DEGREE_LIMITS
    return bool(is_whole and least <= size <= most and size % 100)
