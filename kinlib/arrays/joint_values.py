"""Joint values q of a robot: an array in the order of its joints, or a mapping from their names to values, and their limits."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.tolerances import MAX_ROTATION_RAD
from kinlib.arrays.validation import Array

JointValues = ArrayLike | Mapping[str, ArrayLike]
"""The values q (..., n) of n joints, or the value (...) of each of them by its name."""


class TakesJointValues(ABC):
    """A robot with n joint values, which its methods take as an array in order or as a mapping by name."""

    name: str

    @property
    @abstractmethod
    def n(self) -> int:
        """The number of joint values."""

    @property
    @abstractmethod
    def _values_in_words(self) -> str:
        """What they are, such as "5 joints (RRRRR)"."""

    @property
    @abstractmethod
    def _value_names(self) -> Sequence[str]:
        """What they are called, () if they have no names."""

    def in_order(self, q: JointValues, argument: str = "q") -> Array:
        """Read joint values as an array (..., n) in the order of the joints, from an array or a mapping by name.

        argument  its name, for messages

        Raises ValueError for joint values of another size, for NaN, and for a missing or an unknown name.

        >>> from kinlib import DHTable
        >>> DHTable([[0.4, 0, 0, 0], [0.3, 0, 0, 0]], "standard").in_order({"q2": 0.5, "q1": [1, 2]})
        array([[1. , 0.5],
               [2. , 0.5]])
        """
        names = self._value_names
        q = _stacked(q, names, self.name) if isinstance(q, Mapping) else validation.array(q, argument)
        if q.shape[-1:] != (self.n,):
            advice = f"Pass one value for each of {_listed(names)}" if names else "Pass one value per joint"
            if q.ndim > 1 and q.shape[-2] == self.n:
                advice = f"Joints go in the last dimension: try {argument}.T"
            raise ValueError(
                f"{self.name} has {self._values_in_words}, so {argument} must have shape (..., {self.n}); got {q.shape}. {advice}."
            )
        return q


class TakesLimitedValues(TakesJointValues):
    """A robot whose joint values have limits."""

    @property
    @abstractmethod
    def _limits(self) -> Array:
        """The lower and the upper limit of each joint value, (n, 2), infinite where there is none."""

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


def _stacked(values: Mapping[str, ArrayLike], names: Sequence[str], robot: str) -> Array:
    """Return values by name in the order of the names, (..., n); single numbers are repeated for every configuration."""
    if values and not names:
        raise ValueError(
            f"q must be an array, because the joints of {robot} have no names; got {validation.describe(values)}. Pass their "
            "values in order, or name the joints of a chain first, chain.changed(joint_names=[...])."
        )
    if unknown := [name for name in values if name not in names]:
        raise ValueError(
            f"q must have the names of the joint values of {robot}; got {unknown[0]!r}.{suggest_name(unknown[0], names, 'joint values')}"
        )
    if missing := [name for name in names if name not in values]:
        raise ValueError(
            f"q must have a value for each joint of {robot}; got none for {_listed(missing)}. "
            "Where no other value is given, it is 0 with dict.fromkeys(names, 0.0) | {...}."
        )
    columns = [validation.array(values[name], f"q[{name!r}]") for name in names]
    try:
        columns = [*np.broadcast_arrays(*columns)]
    except ValueError as error:
        shapes = ", ".join(f"{name} {column.shape}" for name, column in zip(names, columns, strict=True))
        raise ValueError(f"The values in q must have one shape, or be single numbers; got {shapes}.") from error
    return np.stack(columns, axis=-1) if columns else np.zeros(0)


def suggest_name(name: object, names: Sequence[str], what: str) -> str:
    """Return a sentence with the name that a wrong one may mean, or with all names if none is similar.

    >>> suggest_name("bsae", ["base", "tool"], "links"), suggest_name("hand", ["base", "tool"], "links")
    (' Did you mean base?', ' The links are base, tool.')
    """
    from difflib import get_close_matches

    close = get_close_matches(str(name), names, n=1)
    return f" Did you mean {close[0]}?" if close else f" The {what} are {_listed(names)}" + "." * (len(names) <= 12)


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:12]) + ", ..." * (len(names) > 12)
