"""Validation of values that students give: arrays of numbers, blanks, and descriptions for error messages."""

import re
import reprlib
from functools import partial
from types import BuiltinFunctionType, FunctionType, MethodType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

FUNCTIONS = (FunctionType, BuiltinFunctionType, MethodType, partial, np.ufunc)
"""The classes of functions that a student may give. Others can be called too, such as symbols of SymPy."""

TRUTH = (bool, np.bool_)
"""The classes of True and False."""


def array(x: ArrayLike, name: str) -> Array:
    """Read x as an array of finite real numbers.

    Raises ValueError for anything else, with the index of the first NaN or infinity.
    """
    try:
        values = np.asarray(x)
        if any(isinstance(one, TRUTH) for one in np.asarray(x, dtype=object).ravel().tolist()):
            raise TypeError("True and False are no numbers")
        if values.dtype.kind == "c" and (np.abs(values.imag) <= 1e-12 * np.abs(values)).all():
            values = values.real  # as np.linalg.eigvals gives them, up to round-off
        if values.dtype.kind not in "iufO":
            raise TypeError(f"{values.dtype} is not a real number")
        # astype alone would read None as NaN and "1" as 1. Adding zero first refuses both.
        with np.errstate(over="ignore"):  # a long double beyond 1e308 becomes infinity, which is refused below
            values = np.asarray(values + 0.0).astype(float, copy=False)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(
            f"{name} must be an array of real numbers; got {brief(x)}. "
            "Is there None, a symbol, a string, True or a row of another length among them?"
        ) from error
    if not np.isfinite(values).all():
        place = f" at index {np.argwhere(~np.isfinite(values))[0].tolist()}" if values.ndim else ""
        raise ValueError(f"{name} contains NaN or infinity{place}. Was there a division by zero before this step?")
    return values


def brief(x: Any) -> str:
    """Describe a value in a few words, for an error message, without its address in memory.

    >>> brief([1, 2, 3]), brief(brief), brief(object()), brief(range(10**9))
    ('list [1, 2, 3]', 'the function brief', 'an object of class object', 'range range(0, 1000000000)')
    """
    if isinstance(x, FUNCTIONS):
        return f"the function {getattr(x, '__name__', '')[:40]}".rstrip()
    x = x.item() if isinstance(x, np.number) else x  # float 2.0, and not float64 np.float64(2.0)
    name = type(x).__name__
    try:
        text = re.sub(r" at 0x[0-9a-fA-F]+", "", reprlib.repr(x))
    except Exception:  # a student's object may raise any exception, and an integer of 5000 digits does
        text = "<>"
    return f"an object of class {name}" if text.startswith("<") else f"{name} {text}"


def is_blank(given: Any) -> bool:
    """Return whether a student has typed nothing yet: the ... of a fresh sheet, or None."""
    return given is None or given is ...
