"""Numbers and names in SymPy: the exact number that a float means, the symbols of joint values, and the shorthand c_1, s_23."""

import re
from numbers import Rational
from typing import Any

import numpy as np
import sympy as sp

from kinlib.arrays import validation


def exact(x: Any) -> Any:
    """Read floats as the exact numbers that they mean: 0.25 as 1/4, 1.5707963267948966 as pi/2, 0.7071067811865476 as sqrt(2)/2.

    A number, an expression, or an array of them -> the same in SymPy, without a float. Vectors become columns.
    If a float is within about fifty roundings of a number with at most 9 decimals, it becomes this number; if not, then pi times
    a fraction with a denominator of at most 360; if not, then the square root of a fraction with a denominator of at most 10000.
    Any other float becomes the simplest fraction that is the same double.

    Raises ValueError for NaN, infinity, and anything that is not a number.

    >>> exact([0.30000000000000004, -np.pi / 3, np.sqrt(3) / 2]).T
    Matrix([[3/10, -pi/3, sqrt(3)/2]])
    """
    if isinstance(x, sp.MatrixBase):
        return sp.Matrix(x).applyfunc(exact)
    if isinstance(x, sp.Expr):
        if x.has(sp.nan, sp.zoo, sp.oo):
            raise ValueError(f"An exact number must be finite; got {x}. Was there a division by zero before this step?")
        return x.xreplace({number: _exact_number(float(number)) for number in x.atoms(sp.Float)})
    if isinstance(x, Rational):
        return sp.Rational(x.numerator, x.denominator)
    if isinstance(x, list | tuple | np.ndarray) and (dimensions := np.ndim(x)):
        if dimensions > 2:
            raise ValueError(f"x must be a number, a vector or a matrix; got an array of shape {np.shape(x)}.")
        rows = np.asarray(x, dtype=object).reshape(len(x), -1)
        return sp.Matrix(*rows.shape, [exact(entry) for entry in rows.flat])
    return _exact_number(float(validation.array(x, "x")))


def joints(n: int) -> tuple[sp.Symbol, ...]:
    """Return symbols for the n joint values of an arm: real symbols q_1 ... q_n.

    >>> joints(3)
    (q_1, q_2, q_3)
    """
    return tuple(sp.symbols(f"q_1:{n + 1}", real=True))


def shorthand(expression: Any) -> Any:
    """Abbreviate cos(q_1) as c_1 and sin(q_2 + q_3) as s_23, as on a blackboard: symbols that notebooks print as `$s_{23}$`.

    An expression or a matrix in q_i or theta_i -> the same, for display only: compute with the original. Angles with an index
    above 9 have no shorthand, because s_12 could then mean the sine of one angle or of the sum of two.

    >>> q_1, q_2, a_2 = sp.symbols("q_1 q_2 a_2")
    >>> shorthand(a_2 * sp.cos(q_1 + q_2) - sp.sin(q_1) ** 2)
    a_2*c_12 - s_1**2
    """
    if isinstance(expression, sp.MatrixBase):
        return expression.applyfunc(shorthand)
    return expression.replace(lambda part: bool(_abbreviation(part)), lambda part: sp.Symbol(_abbreviation(part)))


def _abbreviation(part: Any) -> str:
    """The shorthand of a sine or cosine of numbered angles, or "" for anything else."""
    if not isinstance(part, sp.cos | sp.sin):
        return ""
    matches = [re.fullmatch(r"(q|theta)_?([1-9])", str(angle)) for angle in sp.Add.make_args(part.args[0])]
    if not all(matches) or len({match[1] for match in matches if match}) > 1:
        return ""
    digits = "".join(sorted(match[2] for match in matches if match))
    return f"{'c' if isinstance(part, sp.cos) else 's'}_{digits}"


def _exact_number(x: float) -> sp.Expr:
    candidates = (
        lambda: sp.Rational(repr(round(x, 9))),
        lambda: sp.Rational(x / np.pi).limit_denominator(360) * sp.pi,
        lambda: sp.sign(x) * sp.sqrt(sp.Rational(x * x).limit_denominator(10_000)),
    )
    for candidate in candidates:
        if abs(float(number := candidate()) - x) <= 1e-14 * max(1.0, abs(x)):
            return number
    fractions = (sp.Rational(x).limit_denominator(10**size) for size in range(3, 18, 3))
    return next((fraction for fraction in fractions if float(fraction) == x), sp.Rational(x))
