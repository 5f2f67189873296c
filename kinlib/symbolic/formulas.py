"""The formulas of the course in SymPy: the same names, symbols in and symbols out, and no rounding on the way.

What is a float on the way in is an exact number on the way out: `exact` says how. An arm may be a Chain or a DHTable, or
stand in symbols, link lengths and all. Nothing is simplified, and nothing needs to be: `kinlib.symbolic.merge_rotations` says why.

There is no log here: its arccosine forgets whole turns and signs, and SymPy cannot know which were meant. For numbers there
is `kl.log`.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from kinlib.arrays import tolerances, validation
from kinlib.chains.chain import Chain
from kinlib.dh.table import Convention, DHTable, convention_of
from kinlib.symbolic.merge_rotations import Turn, Word, pose, product, rotation, skew
from kinlib.symbolic.numbers import exact, joints, shorthand

__all__ = [
    "adjoint",
    "dh_transform",
    "exact",
    "exp",
    "fk",
    "fk_body",
    "hat",
    "inverse",
    "joints",
    "screw",
    "shorthand",
    "table_fk",
    "vee",
]

X, Y, Z = (sp.Matrix(column) for column in np.eye(3, dtype=int))


# --- rigid motions ---


def hat(x: Any) -> sp.Matrix:
    """Write a rotation vector or a twist as the matrix by which it acts: 3 -> 3x3, 6 -> 4x4, as kl.hat.

    Raises ValueError for any other size.

    >>> hat(sp.symbols("w_1:4"))[0, :]
    Matrix([[0, -w_3, w_2]])
    """
    x = _sized(x, "x", (3, 1), (6, 1))
    W = skew(x[:3, 0])
    return W if len(x) == 3 else W.row_join(x[3:, 0]).col_join(sp.zeros(1, 4))


def vee(matrix: Any) -> sp.Matrix:
    """Read the rotation vector or the twist back from its matrix: the inverse of hat.

    Raises ValueError for a matrix that no vector has.

    >>> vee(hat(sp.symbols("w_1:4"))).T
    Matrix([[w_1, w_2, w_3]])
    """
    matrix = _sized(matrix, "matrix", (3, 3), (4, 4))
    W, last = matrix[:3, :3], matrix[3:, :]
    if any(sp.simplify(entry) != 0 for entry in [*(W + W.T), *last]):
        raise ValueError(
            "vee takes a skew block over a row of zeros, and this matrix has another form. Is it a pose, before its log?"
        )
    return sp.Matrix([W[2, 1], W[0, 2], W[1, 0], *matrix[:3, 3:]])


def exp(x: Any) -> sp.Matrix:
    """Move along a rotation vector or a twist for one unit of time: 3 -> 3x3, 6 -> 4x4, as kl.exp.

    With theta = |omega|, w = omega / theta and u = v / theta:
    R = I + sin(theta) [w] + (1 - cos(theta)) [w]^2,  p = (I theta + (1 - cos(theta)) [w] + (theta - sin(theta)) [w]^2) u.

    Symbols in omega stand for any numbers but zero: there, exp(x) is the limit. Raises ValueError for any other size.
    Source: Modern Robotics, (3.51) and (3.88).

    >>> exp(screw((0, 0, 1), point=(1, 0, 0)) * sp.Symbol("q", real=True))[:, 3].T
    Matrix([[1 - cos(q), -sin(q), 0, 1]])
    """
    x = _sized(x, "x", (3, 1), (6, 1))
    theta = _length(x[:3, 0])
    if theta == 0:
        return sp.eye(3) if len(x) == 3 else pose(sp.eye(3), x[3:, 0])
    w = x[:3, 0] / theta
    R = rotation(w, theta)
    if len(x) == 3:
        return R
    W = skew(w)
    G = theta * sp.eye(3) + (1 - sp.cos(theta)) * W + (theta - sp.sin(theta)) * W * W
    return pose(R, (G * (x[3:, 0] / theta)).applyfunc(sp.expand))


def inverse(motion: Any) -> sp.Matrix:
    """Undo a rotation or a rigid motion: T_ab becomes T_ba, as kl.inverse.

    Raises ValueError for another shape or a last row that is not 0 0 0 1.

    >>> inverse(exp((0, 0, 0, *sp.symbols("x y z"))))[:3, 3].T
    Matrix([[-x, -y, -z]])
    """
    motion = _motion(motion, "motion")
    Rt = motion[:3, :3].T
    return Rt if motion.rows == 3 else pose(Rt, -Rt * motion[:3, 3])


def adjoint(motion: Any) -> sp.Matrix:
    """Write the matrix that carries twists from one frame to another: 3x3 -> 3x3, 4x4 -> 6x6, as kl.adjoint.

    Raises ValueError for another shape or a last row that is not 0 0 0 1.

    >>> (adjoint(exp((0, 0, 0, sp.Symbol("x"), 0, 0))) * sp.Matrix([0, 0, 1, 0, 0, 0])).T
    Matrix([[0, 0, 1, 0, -x, 0]])
    """
    motion = _motion(motion, "motion")
    R = motion[:3, :3]
    if motion.rows == 3:
        return R
    return R.row_join(sp.zeros(3)).col_join((skew(motion[:3, 3]) * R).row_join(R))


def screw(axis: Any, point: Any = (0, 0, 0), pitch: Any = 0) -> sp.Matrix:
    """Write the screw axis of a joint from a direction, a point on its axis and a pitch, as kl.screw: a column of 6.

    pitch 0: (axis, -axis x point), h: (axis, -axis x point + h axis), infinity: (0, axis).

    Raises ValueError for an axis that is a vector of numbers and not of unit length.

    >>> screw((0, 1, 0), point=(sp.Symbol("a_2"), 0, 0)).T
    Matrix([[0, 1, 0, 0, 0, a_2]])
    """
    axis, point = _sized(axis, "axis", (3, 1)), _sized(point, "point", (3, 1))
    length = _length(axis)
    if length.is_number and abs(float(length) - 1) > tolerances.UNIT_LENGTH_TOL:
        raise ValueError(f"axis should be a unit vector; its length is {length}. Divide it by its norm.")
    if pitch in (np.inf, sp.oo):
        return sp.zeros(3, 1).col_join(axis)
    return axis.col_join(point.cross(axis) + exact(pitch) * axis)


def dh_transform(a: Any, alpha: Any, d: Any, theta: Any, *, convention: Convention) -> sp.Matrix:
    """Write the transform of one DH row, as kl.dh_transform.

    standard: Rz(theta) Tz(d) Tx(a) Rx(alpha);  modified: Rx(alpha) Tx(a) Rz(theta) Tz(d).

    Raises ValueError for another convention.

    >>> dh_transform(0, np.pi / 2, 0, sp.Symbol("q_1"), convention="standard")[:3, 2].T
    Matrix([[sin(q_1), -cos(q_1), 0]])
    """
    a, alpha, d, theta = map(exact, (a, alpha, d, theta))
    about_z, about_x = pose(rotation(Z, theta), d * Z), pose(rotation(X, alpha), a * X)
    return about_z * about_x if convention_of(convention) == "standard" else about_x * about_z


# --- arms ---


def fk(arm: Chain | Iterable[Any], home: Any = None, q: Any = None) -> sp.Matrix:
    """Where the tool is: T(q) = e^[S1]q1 ... e^[Sn]qn M, the space form.

    arm   a Chain, or screw axes in {s}, six entries each, with `home` beside them: numbers or symbols
    q     joint values, n of them; symbols q_1 ... q_n unless given

    Raises ValueError for screw axes and poses that are none, and another number of joint values.
    Source: Modern Robotics, (4.14).

    >>> a = sp.Symbol("a_1")
    >>> shorthand(fk([screw((0, 0, 1)), screw((0, 0, 1), point=(a, 0, 0))], exp((0, 0, 0, 2 * a, 0, 0))))[:2, 3].T
    Matrix([[a_1*c_1 + a_1*c_12, a_1*s_1 + a_1*s_12]])
    """
    screws, M = _arm(arm, home)
    return product(_spelt(screws, q), M)


def fk_body(arm: Chain | Iterable[Any], home: Any = None, q: Any = None) -> sp.Matrix:
    """Where the tool is, by the body form: T(q) = M e^[B1]q1 ... e^[Bn]qn.

    arm   a Chain, or screw axes in {b}, six entries each, with `home` beside them
    q     joint values, n of them; symbols q_1 ... q_n unless given

    Raises ValueError as fk does.
    Source: Modern Robotics, (4.16).

    >>> from kinlib.chains.robots import rppr
    >>> fk_body(rppr())[:3, 3].T
    Matrix([[q_2 + 2, -q_3*sin(q_1) - 2*cos(q_1 + q_4) + 2, q_3*cos(q_1) - 2*sin(q_1 + q_4)]])
    """
    screws, M = _arm(arm, home)
    body = [adjoint(inverse(M)) * S for S in screws] if isinstance(arm, Chain) else screws
    return M * product(_spelt(body, q), sp.eye(4))


def table_fk(table: DHTable | Iterable[Any], convention: Convention | None = None, q: Any = None) -> sp.Matrix:
    """Where the tool is, by a DH table: base A_1 ... A_m tool.

    table   a DHTable, whose joint values are q, or symbols q_1 ... q_n;
            or rows (a, alpha, d, theta) with the symbols standing in them, and their convention

    Raises ValueError for a row without four entries, a missing convention, an alpha in degrees, and another number of
    joint values.
    Source: EduFill module (standard), deck n = 5 and Lecture 7 (modified).

    >>> q_1, q_2, a_1, a_2 = sp.symbols("q_1 q_2 a_1 a_2")
    >>> shorthand(table_fk([(a_1, 0, 0, q_1), (a_2, 0, 0, q_2)], "standard"))[:2, 3].T
    Matrix([[a_1*c_1 + a_2*c_12, a_1*s_1 + a_2*s_12]])
    """
    base = tool = sp.eye(4)
    rows: Iterable[Any]
    if isinstance(table, DHTable):
        convention, base, tool = table.convention, exact(table.base), exact(table.tool)
        rows = _rows_of(table, q)
    else:
        rows = [_sized(row, f"row {number}", (4, 1)) for number, row in enumerate(table, start=1)]
    word: Word = []
    for a, alpha, d, theta in rows:
        if alpha.is_number and abs(alpha) > 2 * sp.pi:
            raise ValueError(
                f"alpha = {alpha} rad is more than a full turn. Is it in degrees? Then write {alpha}*pi/180."
            )
        about_x, about_z = [Turn(X, alpha), a * X], [Turn(Z, theta), d * Z]
        word += about_z + about_x[::-1] if convention_of(convention) == "standard" else about_x + about_z
    return base * product(word, tool)


def _spelt(screws: Sequence[sp.Matrix], q: Any) -> Word:
    """Spell a product of exponentials as turns about lines: to the line, turn and climb, and back."""
    word: Word = []
    for S, value in zip(screws, _values(q, len(screws)), strict=True):
        w, v = S[:3, 0], S[3:, 0]
        if w.is_zero_matrix:
            word.append(v * value)
        else:
            point, pitch = w.cross(v), w.dot(v)
            word += [point + pitch * value * w, Turn(w, value), -point]
    return word


def _rows_of(table: DHTable, q: Any) -> Iterator[list[sp.Expr]]:
    values = iter(_values(q, table.n))
    for numbers, letter, sign in zip(table.rows, table.joints, table.signs, strict=True):
        a, alpha, d, theta = exact(numbers)
        moved = 0 if letter == "F" else int(sign) * next(values)
        yield [a, alpha, d + moved, theta] if letter == "P" else [a, alpha, d, theta + moved]


def _arm(arm: Chain | Iterable[Any], home: Any) -> tuple[list[sp.Matrix], sp.Matrix]:
    if isinstance(arm, Chain):
        return [exact(S) for S in arm.screws], exact(arm.home)
    if home is None:
        raise ValueError("Screw axes alone are no arm: give its home pose beside them, fk(screws, home).")
    M = _motion(home, "home")
    if M.rows == 3:
        raise ValueError("home should be a pose, 4x4; got a rotation, 3x3. Where is its origin?")
    screws = [arm[i, :] for i in range(arm.rows)] if isinstance(arm, sp.MatrixBase) else arm
    return [_screw_axis(S, f"screw {number}") for number, S in enumerate(screws, start=1)], M


def _screw_axis(S: Any, name: str) -> sp.Matrix:
    S = _sized(S, name, (6, 1))
    size = _length(S[3:, 0] if S[:3, 0].is_zero_matrix else S[:3, 0])
    if size.is_number and abs(float(size) - 1) > tolerances.UNIT_LENGTH_TOL:
        raise ValueError(f"{name} should have |omega| = 1, or omega = 0 and |v| = 1; its size is {size}.")
    return S


def _values(q: Any, n: int) -> Sequence[sp.Expr]:
    if q is None:
        return joints(n)
    return list(_sized(q, "q", (n, 1)))


# --- pieces ---


def _length(vector: sp.Matrix) -> sp.Expr:
    """The length of a vector, where q stands for the root of q^2: every use of it here is even in q."""
    root = sp.powdenest(sp.sqrt(sp.factor(sp.trigsimp(vector.dot(vector)))), force=True)
    return root.replace(sp.Abs, lambda inside: inside)


def _sized(x: Any, name: str, *shapes: tuple[int, int]) -> sp.Matrix:
    """Read x as a matrix of one of these shapes; a vector may lie in a row."""
    values = sp.Matrix([x]) if isinstance(x, sp.Expr) else exact(x)
    values = values.T if isinstance(values, sp.MatrixBase) and values.rows == 1 else values
    if not isinstance(values, sp.MatrixBase) or values.shape not in shapes:
        wanted = " or ".join(f"{rows}x{columns}" for rows, columns in shapes)
        came = "x".join(map(str, values.shape)) if isinstance(values, sp.MatrixBase) else "one number"
        raise ValueError(f"{name} should have {wanted} entries; got {came}.")
    return values


def _motion(x: Any, name: str) -> sp.Matrix:
    motion = _sized(x, name, (3, 3), (4, 4))
    if motion.rows == 4 and list(motion[3, :]) != [0, 0, 0, 1]:
        raise ValueError(f"{name} is not a pose: its last row should be 0 0 0 1; got {list(motion[3, :])}.")
    if not motion.free_symbols:
        validation.rotations_or_poses(np.array(motion.evalf(), dtype=float), name)
    return motion
