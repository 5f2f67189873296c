"""Numbers and names in SymPy: what a float stands for, what the joint values are called, how a cosine is written short."""

import re
from numbers import Rational
from typing import Any

import numpy as np
import sympy as sp

from kinlib.arrays import validation

EQUAL = 1e-14
"""How far a float may lie from the exact number that it stands for, relative to its size above 1: some fifty roundings."""

DECIMALS, DIVISOR, SQUARE = 9, 360, 10_000
"""What an exact number is: so many decimals; pi times a fraction over so much; the root of a fraction over so much."""


def exact(x: Any) -> Any:
    """Read numbers as what they stand for: 0.25 as 1/4, 1.5707963267948966 as pi/2, 0.7071067811865476 as sqrt(2)/2.

    A number, an expression, or an array of them -> the same in SymPy, without a float. Vectors stand in columns.
    A float within some fifty roundings of them is at most 9 decimals, or else pi times a fraction over at most 360, or
    else the root of a fraction over at most 10000. Any other becomes the simplest fraction that is the same double.

    Raises ValueError for NaN, infinity, and what is no number.

    >>> exact([0.30000000000000004, -np.pi / 3, np.sqrt(3) / 2]).T
    Matrix([[3/10, -pi/3, sqrt(3)/2]])
    """
    if isinstance(x, sp.MatrixBase):
        return sp.Matrix(x).applyfunc(exact)
    if isinstance(x, sp.Expr):
        if x.has(sp.nan, sp.zoo, sp.oo):
            raise ValueError(f"An exact number is finite; got {x}. Was there a division by zero before this step?")
        return x.xreplace({number: _recognised(float(number)) for number in x.atoms(sp.Float)})
    if isinstance(x, Rational):
        return sp.Rational(x.numerator, x.denominator)
    if isinstance(x, list | tuple | np.ndarray) and (dimensions := np.ndim(x)):
        if dimensions > 2:
            raise ValueError(f"SymPy has numbers, vectors and matrices; got an array of shape {np.shape(x)}.")
        rows = np.asarray(x, dtype=object).reshape(len(x), -1)
        return sp.Matrix(*rows.shape, [exact(entry) for entry in rows.flat])
    return _recognised(float(validation.array(x, "x")))


def joints(n: int) -> tuple[sp.Symbol, ...]:
    """Name the joint values of an arm: real symbols q_1 ... q_n.

    >>> joints(3)
    (q_1, q_2, q_3)
    """
    return tuple(sp.symbols(f"q_1:{n + 1}", real=True))


def shorthand(expression: Any) -> Any:
    """Write c_1 for cos(q_1) and s_23 for sin(q_2 + q_3), as on a blackboard: symbols that notebooks print as $s_{23}$.

    An expression or a matrix in q_i or theta_i -> the same, to be read; to compute on, keep the original. Angles beyond 9
    have no shorthand: s_12 would be the sine of one or of two.

    >>> q_1, q_2, a_2 = sp.symbols("q_1 q_2 a_2")
    >>> shorthand(a_2 * sp.cos(q_1 + q_2) - sp.sin(q_1) ** 2)
    a_2*c_12 - s_1**2
    """
    if isinstance(expression, sp.MatrixBase):
        return expression.applyfunc(shorthand)
    return expression.replace(lambda part: bool(_short(part)), lambda part: sp.Symbol(_short(part)))


def _short(part: Any) -> str:
    """The shorthand of a sine or cosine of numbered angles, or nothing."""
    if not isinstance(part, sp.cos | sp.sin):
        return ""
    found = [re.fullmatch(r"(q|theta)_?([1-9])", str(angle)) for angle in sp.Add.make_args(part.args[0])]
    if not all(found) or len({angle[1] for angle in found if angle}) > 1:
        return ""
    digits = "".join(sorted(angle[2] for angle in found if angle))
    return f"{'c' if isinstance(part, sp.cos) else 's'}_{digits}"


def _recognised(x: float) -> sp.Expr:
    candidates = (
        lambda: sp.Rational(repr(round(x, DECIMALS))),
        lambda: sp.Rational(x / np.pi).limit_denominator(DIVISOR) * sp.pi,
        lambda: sp.sign(x) * sp.sqrt(sp.Rational(x * x).limit_denominator(SQUARE)),
    )
    for candidate in candidates:
        if abs(float(number := candidate()) - x) <= EQUAL * max(1.0, abs(x)):
            return number
    fractions = (sp.Rational(x).limit_denominator(10**size) for size in range(3, 18, 3))
    return next((fraction for fraction in fractions if float(fraction) == x), sp.Rational(x))
