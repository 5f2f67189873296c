"""Limits of joint values: read them, ask whether values are within them, and draw values between them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.tolerances import MAX_ROTATION_RAD
from kinlib.arrays.validation import Array, JointValues, TakesJointValues


def validate_limits(limits: ArrayLike, n: int) -> Array:
    """Read limits as an array (n, 2), the lower and the upper limit of each joint, which may be infinite.

    Raises ValueError for another shape, and for limits that are swapped or NaN.
    """
    if isinstance(limits, list):  # `to_dict` writes None for infinity
        limits = [[(-np.inf, np.inf)[k] if x is None else x for k, x in enumerate(row)] for row in limits]
    limits = validation.real_array(limits, "limits")
    if limits.shape != (n, 2):
        raise ValueError(f"limits must have one row (lower, upper) per joint, shape ({n}, 2); got {limits.shape}.")
    for joint, (lower, upper) in enumerate(limits.tolist(), start=1):
        if not lower <= upper:  # also for NaN
            raise ValueError(
                f"The limits of joint {joint} must be (lower, upper); got {[lower, upper]}. Are they swapped?"
            )
    return limits


class TakesLimitedValues(TakesJointValues):
    """A robot whose joint values have limits."""

    limits: Any

    @property
    def _limits(self) -> Array:
        return np.tile([-np.inf, np.inf], (self.n, 1)) if self.limits is None else np.asarray(self.limits)

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

        >>> from kinlib import Chain
        >>> Chain([[0, 0, 1, 0, 0, 0]] * 2, np.eye(4), limits=[[0, 1], [5, np.inf]]).random_configurations(2).round(2)
        array([[0.64, 6.7 ],
               [0.04, 5.1 ]])
        """
        lower, upper = self._limits.T
        has_lower, has_upper = (np.abs(limit) < MAX_ROTATION_RAD for limit in (lower, upper))
        low = np.where(has_lower, lower, np.where(has_upper, upper - 2 * np.pi, -np.pi))
        high = np.where(has_upper, upper, np.where(has_lower, lower + 2 * np.pi, np.pi))
        return np.random.default_rng(seed).uniform(low, high, (count, self.n))
