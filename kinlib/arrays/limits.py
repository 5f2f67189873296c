"""Limits of joint values: read them, ask whether values are within them, and draw values between them."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.tolerances import MAX_ROTATION_RAD
from kinlib.arrays.validation import Array, JointValues, TakesJointValues

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


class TakesLimitedValues(TakesJointValues):
    """A robot whose joint values have limits."""

    @property
    @abstractmethod
    def _limits(self) -> Array: ...  # (n, 2), infinite where there is none

    def within_limits(self, q: JointValues) -> NDArray[np.bool_]:
        """Return for each configuration whether all its joint values are within the limits: q (..., n) -> (...).

        Raises ValueError for joint values of another size, and for NaN.

        >>> from kinlib import Chain
        >>> Chain([[0, 0, 1, 0, 0, 0]], np.eye(4), limits=[[-1, 1]]).within_limits([[0.5], [1.5]])
        array([ True, False])
        """
        lower, upper = self._limits.T
        q = self.in_order(q)
        inside: NDArray[np.bool_] = ((lower <= q) & (q <= upper)).all(axis=-1)
        return inside

    def random_configurations(self, count: int, seed: int = 0) -> Array:
        """Draw configurations within the limits, the same ones for the same seed: (count, n).

        A joint without limits takes values between -pi and pi, in radians or metres; one with a single limit, up to 2 pi from it.
        A limit beyond MAX_ROTATION_RAD, as some files have for a joint that rotates without end, is none.

        Raises ValueError if count or seed is not a whole number from 0 on.

        >>> from kinlib import Chain
        >>> Chain([[0, 0, 1, 0, 0, 0]] * 2, np.eye(4), limits=[[0, 1], [5, np.inf]]).random_configurations(2).round(2)
        array([[0.64, 6.7 ],
               [0.04, 5.1 ]])
        """
        count, seed = validation.whole_number(count, "count"), validation.whole_number(seed, "seed")
        lower, upper = self._limits.T
        has_lower, has_upper = (np.abs(limit) < MAX_ROTATION_RAD for limit in (lower, upper))
        low = np.where(has_lower, lower, np.where(has_upper, upper - 2 * np.pi, -np.pi))
        high = np.where(has_upper, upper, np.where(has_lower, lower + 2 * np.pi, np.pi))
        return np.random.default_rng(seed).uniform(low, high, (count, self.n))
