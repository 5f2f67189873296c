"""The formulas of the course in SymPy, under the same names: they take and return symbols, and do not round.

The joint values of an arm are the symbols q_1 ... q_n of `joints`. Floats are read as exact numbers: see `exact`. Rows of a table may
have symbols, also for link lengths. Results are not simplified, and need not be: `kinlib.symbolic.merge_rotations` explains why.

There is no log here, because its arccosine loses full turns and signs, and SymPy cannot know which were meant. For numbers use
`kl.log`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from numbers import Rational
from typing import Any

import numpy as np
import sympy as sp

from kinlib.arrays import tolerances, validation
from kinlib.chains.chain import Chain
from kinlib.dh.parsing import is_plausible_angle
from kinlib.dh.table import Convention, validate_convention
from kinlib.symbolic.merge_rotations import AxisRotation, Factors, homogeneous, multiply, rotation

__all__ = ["exact", "exp", "fk", "joints", "screw", "shorthand", "table_fk"]


def exp(x: Any) -> sp.Matrix:
    """Compute the matrix exponential of a rotation vector or a twist: 3 -> 3x3, 6 -> 4x4, as kl.exp.

    With theta = |omega|, w = omega / theta and u = v / theta:
    R = I + sin(theta) [w] + (1 - cos(theta)) [w]^2,  p = (I theta + (1 - cos(theta)) [w] + (theta - sin(theta)) [w]^2) u.

    If omega has symbols, the result is right for all their values with omega != 0, and its limit is right at omega = 0.

    Source: Modern Robotics, (3.51) and (3.88).

    >>> exp(screw((0, 0, 1), point=(1, 0, 0)) * sp.Symbol("q", real=True))[:, 3].T
    Matrix([[1 - cos(q), -sin(q), 0, 1]])
    """
    x = _matrix(x, "x", (3, 1), (6, 1))
    theta = _length(x[:3, 0])
    if theta == 0:
        return sp.eye(3) if len(x) == 3 else homogeneous(sp.eye(3), x[3:, 0])
    w = x[:3, 0] / theta
    R = rotation(w, theta)
    if len(x) == 3:
        return R
    W = w.hat()
    G = theta * sp.eye(3) + (1 - sp.cos(theta)) * W + (theta - sp.sin(theta)) * W * W
    return homogeneous(R, (G * (x[3:, 0] / theta)).applyfunc(sp.expand))


def screw(axis: Any, point: Any = (0, 0, 0), pitch: Any = 0) -> sp.Matrix:
    """Write the screw axis of a joint from a direction, a point on its axis and a pitch, as kl.screw: a column of 6.

    pitch 0: (axis, -axis x point), h: (axis, -axis x point + h axis), infinity: (0, axis).

    Raises ValueError for an axis that is a vector of numbers and not of unit length.

    >>> screw((0, 1, 0), point=(sp.Symbol("a_2"), 0, 0)).T
    Matrix([[0, 1, 0, 0, 0, a_2]])
    """
    axis, point = _matrix(axis, "axis", (3, 1)), _matrix(point, "point", (3, 1))
    length = _length(axis)
    if length.is_number and abs(float(length) - 1) > tolerances.UNIT_LENGTH_TOL:
        raise ValueError(f"axis must be a unit vector; its length is {length}. Divide it by its norm.")
    if pitch in (np.inf, sp.oo):
        return sp.zeros(3, 1).col_join(axis)
    return axis.col_join(point.cross(axis) + exact(pitch) * axis)


def fk(arm: Chain) -> sp.Matrix:
    """Compute the forward kinematics of an arm in the space form: T(q) = e^[S1]q1 ... e^[Sn]qn M, 4x4.

    Source: Modern Robotics, (4.14).

    >>> shorthand(fk(kl.robots.rpr_lecture7()))[0, :3]
    Matrix([[c_13, -s_13, 0]])
    """
    validation.instance(arm, "arm", Chain)
    factors: Factors = []
    for S, q in zip(map(exact, arm.screws), joints(arm.n), strict=True):
        w, v = S[:3, 0], S[3:, 0]
        point, pitch = w.cross(v), w.dot(v)
        # Each exponential is a translation to the axis, the motion about and along it, and the translation back.
        factors += [v * q] if w.is_zero_matrix else [point + pitch * q * w, AxisRotation(w, q), -point]
    return multiply(factors, exact(arm.home))


def table_fk(rows: Iterable[Any], convention: Convention) -> sp.Matrix:
    """Compute the forward kinematics of the rows of a DH table: A_1 ... A_m, 4x4.

    rows  (a, alpha, d, theta), in which the joint values are symbols; of a DHTable take fk(table.to_chain())

    Raises ValueError if a row does not have four entries, for an unknown convention, and if alpha is in degrees.
    Source: EduFill manipulation module (standard), DH example with n = 5 and Kinematics under DH (modified).

    >>> q_1, q_2, a_1, a_2 = sp.symbols("q_1 q_2 a_1 a_2")
    >>> shorthand(table_fk([(a_1, 0, 0, q_1), (a_2, 0, 0, q_2)], "standard"))[:2, 3].T
    Matrix([[a_1*c_1 + a_2*c_12, a_1*s_1 + a_2*s_12]])
    """
    validation.instance(rows, "rows", Iterable)
    factors: Factors = []
    x, _, z = (sp.Matrix(column) for column in np.eye(3, dtype=int))
    for number, row in enumerate(rows, start=1):
        a, alpha, d, theta = _matrix(row, f"row {number}", (4, 1))
        if alpha.is_number and not is_plausible_angle(float(alpha)):
            raise ValueError(f"alpha must be at most a full turn; got {alpha} rad. In degrees, write {alpha}*pi/180.")
        about_x, about_z = [AxisRotation(x, alpha), a * x], [AxisRotation(z, theta), d * z]
        factors += about_z + about_x[::-1] if validate_convention(convention) == "standard" else about_x + about_z
    return multiply(factors, sp.eye(4))


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


def _length(vector: sp.Matrix) -> sp.Expr:
    """The length of a vector, with q for the square root of q^2: every use of it here is an even function of q."""
    root = sp.powdenest(sp.sqrt(sp.factor(sp.trigsimp(vector.dot(vector)))), force=True)
    return root.replace(sp.Abs, lambda inside: inside)


def _matrix(x: Any, name: str, *shapes: tuple[int, int]) -> sp.Matrix:
    """Read x as a matrix of one of these shapes; a row vector becomes a column."""
    values = sp.Matrix([x]) if isinstance(x, sp.Expr) else exact(x)
    values = values.T if isinstance(values, sp.MatrixBase) and values.rows == 1 else values
    if not isinstance(values, sp.MatrixBase) or values.shape not in shapes:
        expected = " or ".join(f"{rows}x{columns}" for rows, columns in shapes)
        given = "x".join(map(str, values.shape)) if isinstance(values, sp.MatrixBase) else "one number"
        raise ValueError(f"{name} must have {expected} entries; got {given}.")
    return values


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
