"""Write numbers, vectors and angles as text for people: few digits, and 0 for rounding errors."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.tolerances import ROUNDING_ERROR


def format_number(value: float, digits: int = 4, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a number with at most this many significant digits, and never as -0.

    zero  a number up to this size is written as 0

    >>> format_number(-0.0), format_number(0.25), format_number(np.pi), format_number(-1e-17), format_number(3e-8)
    ('0', '0.25', '3.142', '0', '3e-08')
    """
    return f"{float(value):.{digits}g}" if abs(value) > zero else "0"


def format_vector(values: ArrayLike, digits: int = 4, *, zero: float = ROUNDING_ERROR) -> str:
    """Write a vector as its components in parentheses.

    >>> format_vector([0.5, -1e-17, 3])
    '(0.5, 0, 3)'
    """
    components = np.asarray(values, dtype=float).tolist()
    return "(" + ", ".join(format_number(value, digits, zero=zero) for value in components) + ")"


def format_degrees(angle: float, digits: int = 4, *, zero: float = ROUNDING_ERROR) -> str:
    """Write an angle, given in radians, in degrees; zero is written without a degree sign.

    >>> format_degrees(np.pi / 2), format_degrees(-1e-17)
    ('90°', '0')
    """
    text = format_number(float(np.degrees(angle)), digits, zero=zero)
    return text if text == "0" else f"{text}°"
