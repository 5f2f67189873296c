"""Validation of values that students give: arrays of numbers, blanks, and descriptions for error messages."""

import reprlib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def array(x: ArrayLike, name: str) -> Array:
    """Read x as an array of finite real numbers.

    Raises ValueError for anything else, with the index of the first NaN or infinity.

    >>> array([1, 2, 3], "your answer")
    array([1., 2., 3.])
    """
    try:
        values = np.asarray(x)
        if values.dtype.kind not in "biufO":
            raise TypeError(f"{values.dtype} is not a real number")
        # astype alone would read None as NaN and "1" as 1. Adding zero first refuses both.
        values = np.asarray(values + 0.0).astype(float, copy=False)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(
            f"{name} must be an array of real numbers; got {brief(x)}. "
            "Is there None, a symbol, a string or a row of another length among them?"
        ) from error
    if not np.isfinite(values).all():
        place = f" at index {np.argwhere(~np.isfinite(values))[0].tolist()}" if values.ndim else ""
        raise ValueError(f"{name} contains NaN or infinity{place}. Was there a division by zero before this step?")
    return values


def brief(x: Any) -> str:
    """Describe a value in a few words, for an error message.

    >>> brief([1, 2, 3])
    'list [1, 2, 3]'
    """
    return f"{type(x).__name__} {reprlib.repr(x)}"


def is_blank(given: Any) -> bool:
    """Return whether a student has typed nothing yet: the ... of a fresh sheet, or None.

    >>> is_blank(...), is_blank(0)
    (True, False)
    """
    return given is None or given is ...
