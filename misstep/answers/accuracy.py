"""How far a number in an answer may be off: by a thousandth, or exact, absolute, relative, decimals or digits."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

TOLERANCE = 1e-3
"""The accepted error of a number, relative to its size if that is above 1: three printed decimals are enough."""


@dataclass(frozen=True)
class Accuracy:
    """How far a number may be off.

    words  what is asked for, after "one number": "to 2 decimals"
    bound  takes the right numbers and returns the largest error of each

    >>> bool(decimals(2).bound(1 / 3) >= abs(0.33 - 1 / 3)), decimals(2).words
    (True, 'to 2 decimals')
    """

    words: str
    bound: Callable[[Any], Any]


def _round_off(right: Any) -> Any:
    """The error of the computer's own arithmetic, and less than the distance of two whole numbers or of two cents."""
    return np.minimum(np.maximum(1e-9 * np.abs(right), 1e-12), 1e-3)


exact = Accuracy("exactly, such as 12 or 2/3", _round_off)
"""The number itself: 5041 is wrong for 5040, 0.3333 is wrong for 1/3. What is typed as 1/3 has its sixteen digits, and is right."""


def absolute(error: float) -> Accuracy:
    """Up to a given error.

    >>> bool(abs(9.83 - 9.81) <= absolute(0.05).bound(9.81))
    True
    """
    return Accuracy(f"with an error of at most {_positive(error):g}", lambda right: error + _round_off(right))


def relative(error: float) -> Accuracy:
    """Up to a given share of the right number.

    >>> five_percent = relative(0.05)
    >>> five_percent.words, bool(abs(98 - 100) <= five_percent.bound(100)), bool(abs(90 - 100) <= five_percent.bound(100))
    ('with an error of at most 5 %', True, False)
    """
    return Accuracy(f"with an error of at most {100 * _positive(error):g} %", lambda right: error * np.abs(right))


def decimals(count: int) -> Accuracy:
    """To a number of decimals: at most half a unit of the last of them.

    >>> bool(abs(0.33 - 1 / 3) <= decimals(2).bound(1 / 3)), bool(abs(0.3 - 1 / 3) <= decimals(2).bound(1 / 3))
    (True, False)
    """
    unit = 10.0**-count
    return Accuracy(f"to {count} decimal{'s' * (count != 1)}", lambda right: 0.5 * unit + _round_off(right))


def digits(count: int) -> Accuracy:
    """To a number of significant digits: at most half a unit of the last of them.

    >>> bool(abs(6.02e23 - 6.02214e23) <= digits(3).bound(6.02214e23)), bool(abs(6.0e23 - 6.02214e23) <= digits(3).bound(6.02214e23))
    (True, False)
    """
    if count < 1:
        raise ValueError(f"There must be at least one significant digit; got {count}. Try digits(3).")

    def bound(right: Any) -> Any:
        size = np.abs(np.asarray(right)).astype(float)
        first = np.floor(np.log10(np.where(size > 0, size, 1.0)))
        return np.where(size > 0, 0.5 * 10.0 ** (first + 1 - count), 0.0) + _round_off(right)

    return Accuracy(f"to {count} significant digit{'s' * (count != 1)}", bound)


def _positive(error: float) -> float:
    if not 0 < error < np.inf:
        raise ValueError(f"An error must be a positive number; got {error!r}. For no error at all, take `exact`.")
    return error
