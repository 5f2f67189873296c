"""Limits of joint values: read them, ask whether values are within them, and draw values between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.tolerances import MAX_ROTATION_RAD
from kinlib.arrays.validation import Array

DEGREE_LIMITS = (60, 720)
"""The larger limit of a joint is between these, if it is taken to be in degrees: 50 rad are the eight turns of a spindle."""


def validate_limits(limits: ArrayLike, joint_types: str) -> Array:
    """Read limits as an array (n, 2), the lower and the upper limit of each joint, which may be infinite.

    joint_types  a letter for each joint: those of revolute joints, R, must not look like degrees

    Raises ValueError for another shape, for limits that are swapped or NaN, and for those that look like degrees.

    >>> validate_limits([[-np.pi, np.pi], [0, 180]], "RP")[1]
    array([  0., 180.])
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

    >>> [look_like_degrees(-x, x) for x in (90, 180, 360, 50, 62.83, 100, 1e16, np.inf)]
    [True, True, True, False, False, False, False, False]
    """
    ends = [end for end in (lower, upper) if np.isfinite(end)]
    size = max(map(abs, ends), default=0)
    is_whole = all(end % 1 == 0 for end in ends)
    least, most = DEGREE_LIMITS
    return bool(is_whole and least <= size <= most and size % 100)


def are_within(q: Array, limits: Array) -> NDArray[np.bool_]:
    """Return for each configuration (..., n) whether all its values are within the limits (n, 2): (...).

    >>> are_within(np.array([[0.5], [1.5]]), np.array([[-1, 1]]))
    array([ True, False])
    """
    lower, upper = limits.T
    inside: NDArray[np.bool_] = ((lower <= q) & (q <= upper)).all(axis=-1)
    return inside


def random_values(limits: Array, count: int, seed: int) -> Array:
    """Draw configurations (count, n) within the limits (n, 2), the same ones for the same seed.

    A value without limits is between -pi and pi, and one with a single limit up to 2 pi from it. A limit beyond MAX_ROTATION_RAD
    is none.

    Raises ValueError if count or seed is not a whole number from 0 on.

    >>> random_values(np.array([[0, 1], [5, np.inf]]), 3, seed=0).round(2)
    array([[ 0.64,  6.7 ],
           [ 0.04,  5.1 ],
           [ 0.81, 10.74]])
    """
    count, seed = validation.whole_number(count, "count"), validation.whole_number(seed, "seed")
    lower, upper = limits.T
    has_lower, has_upper = (np.abs(limit) < MAX_ROTATION_RAD for limit in (lower, upper))
    low = np.where(has_lower, lower, np.where(has_upper, upper - 2 * np.pi, -np.pi))
    high = np.where(has_upper, upper, np.where(has_lower, lower + 2 * np.pi, np.pi))
    return np.random.default_rng(seed).uniform(low, high, (count, len(limits)))
