"""Numbers, vectors and matrices in statements: LaTeX in Markdown, with at most four significant digits."""

from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike


def number(x: float) -> str:
    """Write a number with at most four significant digits, and never as -0.

    >>> number(-0.0), number(0.25), number(np.pi), number(-3.7e-6)
    ('0', '0.25', '3.142', '0')
    """
    return f"{float(x):.4g}" if abs(x) > 1e-5 else "0"  # which is a hundredth of the tolerance of an answer


def points(x: float) -> str:
    """Write points as a whole number and a fraction, or with two decimals if the denominator is large.

    >>> points(2.0), points(2 / 3), points(4 / 3), points(0.0), points(0.43)
    ('2', '2/3', '1 1/3', '0', '0.43')
    """
    exact = Fraction(float(x)).limit_denominator(12)
    if abs(exact - Fraction(float(x))) > 1e-9:
        return f"{x:.2f}"
    whole, rest = divmod(exact, 1)
    return f"{whole} {rest}" if whole and rest else str(whole or rest)


def degrees(angle: float) -> str:
    """Write an angle, given in radians, in degrees."""
    return f"{number(float(np.degrees(angle)))}°"


def vector(x: ArrayLike) -> str:
    """Write a vector as a row, for use between dollar signs."""
    return "(" + ", ".join(number(value) for value in np.asarray(x, dtype=float)) + ")"


def matrix(X: ArrayLike) -> str:
    """Write a matrix in LaTeX, for use between dollar signs."""
    rows = r" \\ ".join(" & ".join(number(value) for value in row) for row in np.asarray(X, dtype=float))
    return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"
