"""Poses and rotations in solutions: inverses, exponentials, and the parts of a pose."""

from functools import partial
from itertools import combinations

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import hat, homogeneous, log
from misstep.mutants.expression import (
    MAY_COINCIDE,
    SUM,
    Expression,
    Operation,
    Slip,
    Slips,
    given,
    negative,
    power,
    table,
    transpose,
)

INVERSE_ADVICE = "The inverse of $(R, p)$ is $(R^T, -R^T p)$."
POINT_ADVICE = "A point has a 1 as its last entry, which adds $p$: $R\\,x + p$."
DIRECTION_ADVICE = (
    "A direction has a 0 as its last entry, because it is a difference of two points: it is rotated only."
)


def rotation_about(axis: int, angle: Expression) -> Expression:
    """The rotation (3, 3) by an angle in radians about axis 0, 1 or 2: x, y or z."""
    name, turn = "xyz"[axis], partial(_plane_rotation, axis)
    return Operation(f"rotation about {name}", turn, f"R_{name}({{0}})".format, _about_slips)(angle)


def with_position(T: Array, p: Array) -> Array:
    """Return a pose (4, 4) with another position p (3,)."""
    return homogeneous(T[:3, :3], p)


def _point_slips(node: Expression) -> Slips:
    p, x = node.latex, node.value
    yield Slip("sign of a vector", f"take ${p}$ with the opposite sign", negative(node))
    for i in np.flatnonzero(x).tolist():
        signs = np.where(np.arange(len(x)) == i, -1, 1)
        negate = Operation("sign of a component", partial(np.multiply, signs), "{0}".format)
        yield Slip("sign of a component", f"take the ${'xyz'[i]}$ of ${p}$ with the opposite sign", negate(node))
    for i, j in combinations(range(len(x)), 2):
        order = np.arange(len(x))
        order[[i, j]] = j, i
        yield Slip("coordinates swapped", f"swap the ${'xyz'[i]}$ and the ${'xyz'[j]}$ of ${p}$", node[order])


def _plane_rotation(axis: int, angle: float, swapped: bool = False) -> Array:
    c, s = (np.sin(angle), np.cos(angle)) if swapped else (np.cos(angle), np.sin(angle))
    R, i, j = np.eye(3), (axis + 1) % 3, (axis + 2) % 3
    R[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
    return R


def _about_slips(node: Expression) -> Slips:
    [angle] = node.arguments
    axis = "xyz".index(node.operation.name[-1])
    for about in ((axis + 1) % 3, (axis + 2) % 3):
        text = f"rotate about the ${'xyz'[about]}$ axis instead of the ${'xyz'[axis]}$ axis"
        yield Slip("another axis", text, rotation_about(about, angle))
    mirrored = partial(_plane_rotation, axis, swapped=True)
    yield Slip("sine and cosine swapped", "swap sine and cosine", Operation("swapped", mirrored, "{0}".format)(angle))


def _columns_slips(node: Expression) -> Slips:
    axes = node.arguments
    yield Slip("axes in rows", "write the axes into the rows", transpose(node), advice="They are the columns.")
    for i, j in combinations(range(len(axes)), 2):
        one, other = f"${axes[i].latex}$", f"${axes[j].latex}$"
        turned = [negative(axis) if k in (i, j) else axis for k, axis in enumerate(axes)]
        yield Slip("sign of two axes", f"take {one} and {other} with the opposite sign", columns(*turned))
        order = list(axes)
        order[i], order[j] = axes[j], axes[i]
        yield Slip("columns swapped", f"swap the columns {one} and {other}", columns(*order))


def _assemble_slips(node: Expression) -> Slips:
    R, p = node.arguments
    if len(p.value) == 3:
        yield Slip("position in the other frame", "write $R^T p$ as the position", assemble(R, transpose(R) @ p))
    yield Slip("rotation left out", "leave out the rotation", assemble(given("I", np.eye(len(R.value))), p))
    yield from _ASSEMBLED(node)


def _unrotated(T: Expression) -> Expression:
    return assemble(given("I", np.eye(3)), position_of(T))


def _exp_slips(node: Expression) -> Slips:
    S, q = node.arguments
    factor = f"${node.latex}$"
    yield Slip("joint value left out", f"leave out ${q.latex}$ in {factor}", exp(S, 1.0))
    text = f"take the exponential of each entry instead of {factor}"
    everywhere = "take the exponential of each entry (`np.exp`) instead of that of the matrix"
    yield Slip("exponential of each entry", text, _entrywise_exponential(S, q), everywhere=everywhere, one_by_one=False)


def _assembled(R: Array, p: Array) -> Array:
    T = np.eye(len(p) + 1)
    T[:-1, :-1], T[:-1, -1] = R, p
    return T


# fmt: off
_GIVEN_POSE = table(
    ("inverse", "use the inverse of ${}$ instead of ${}$", lambda T: inverse(T)),
    ("transposed", "use the transpose of ${}$ instead of ${}$", lambda T: transpose(T)),
    ("rotation transposed", "use ${}$ with the transpose of its rotation", lambda T: _with_transposed_rotation(T)),
    ("rotation left out", "leave out the rotation of ${}$", lambda T: _unrotated(T), "", MAY_COINCIDE),
    ("position left out", "leave out the position of ${}$", lambda T: rotation_only(rotation_of(T)), "", MAY_COINCIDE),
)
_ASSEMBLED = table(
    ("inverse", "write the inverse of the right matrix", lambda R, p: np.linalg.inv(_assembled(R, p))),
    ("position left out", "leave out the position", lambda R, p: _assembled(R, 0 * p)),
    ("corner", "write a 0 at the end of the last row, where a 1 belongs", lambda R, p: _assembled(R, p) - np.diag([0.0] * len(p) + [1.0])),
    of_values=True,
)
_NO_MINUS = "leave out the minus sign of $-R^T p$ in the inverse of"
_POSITION = "position of the inverse"
_INVERSES = table(
    ("inverse left out", "use ${0}$, where its inverse belongs |leave out every inverse", None),
    ("transpose for inverse", "transpose ${0}$ instead of inverting it |transpose poses instead of inverting them",
     np.transpose, INVERSE_ADVICE),
    ("negative for inverse", "negate ${0}$ instead of inverting it |negate poses instead of inverting them", lambda T: -T, INVERSE_ADVICE),
    (_POSITION, "write $-p$ as the position of the inverse of ${0}$ |write $-p$ as the position of the inverse of each pose",
     lambda T: homogeneous(T[:3, :3].T, -T[:3, 3]), INVERSE_ADVICE),
    (_POSITION, "leave the position unchanged in the inverse of ${0}$ |leave the position unchanged in the inverse of each pose",
     lambda T: homogeneous(T[:3, :3].T, T[:3, 3]), INVERSE_ADVICE),
    (_POSITION, "write $-R\\,p$ as the position of the inverse of ${0}$ |write $-R\\,p$ as the position of the inverse of each pose",
     lambda T: homogeneous(T[:3, :3].T, -T[:3, :3] @ T[:3, 3]), INVERSE_ADVICE),
    (_POSITION, f"{_NO_MINUS} ${{0}}$ |{_NO_MINUS} each pose",
     lambda T: homogeneous(T[:3, :3].T, T[:3, :3].T @ T[:3, 3]), INVERSE_ADVICE),
    of_values=True,
)
_UNROTATED = "leave out the rotation of ${0}$ for ${1}$ |leave out the rotation of ${0}$"
_POINT_MAP = table(
    ("point as a direction", "leave out the position of ${0}$ for a point", lambda T, x: rotation_of(T) @ x, POINT_ADVICE),
    ("sign", "take the position of ${0}$ with the opposite sign", lambda T, x: rotation_of(T) @ x - position_of(T)),
    ("sign", "take ${1}$, rotated, with the opposite sign", lambda T, x: position_of(T) - rotation_of(T) @ x, "", MAY_COINCIDE),
    ("order", "add the position of ${0}$ in the wrong order, before rotating", lambda T, x: rotation_of(T) @ (x + position_of(T))),
    ("rotation left out", _UNROTATED, lambda T, x: to_point(_unrotated(T), x)),
)
_DIRECTION_MAP = table(
    ("direction as a point", "add the position of ${0}$ to a direction", lambda T, x: to_point(T, x), DIRECTION_ADVICE),
    ("rotation left out", _UNROTATED, lambda T, x: to_direction(_unrotated(T), x)),
)
_LOGARITHMS = table(
    ("translation for v", "take the position of the pose as $v$", lambda T: np.concatenate([log(T)[:3], T[:3, 3]]),
     "The $v$ of a logarithm differs from the position, because the motion rotates too."),
    ("degrees", "give $\\omega$ in degrees", lambda T: log(T) * np.repeat((180 / np.pi, 1), 3), "A twist is in radians."),
    ("halves swapped", "write $(v, \\omega)$", lambda T: np.roll(log(T), 3), "Here a twist is $(\\omega, v)$."),
    of_values=True,
)


def _part(T: str, letter: str) -> str:
    """The rotation R_{ab} or the position p_{ab} of a pose T_{ab}."""
    return T.replace("T", letter, 1)


inverse: Operation = Operation("inverse of a pose", np.linalg.inv, power("{-1}"), _INVERSES, involution=True)
"""The inverse of a pose: (R^T, -R^T p)."""


def _exponential_latex(S: str, q: str) -> str:
    return f"e^{{[{S}]({q})}}" if q.startswith("-") else f"e^{{[{S}]{q}}}"


exp: Operation = Operation("exponential", lambda S, q: exponential(S * q), _exponential_latex, _exp_slips)
"""The exponential of a screw S (6,) or rotation vector (3,) times a joint value: e^{[S] q}."""

logarithm: Operation = Operation("logarithm", log, "\\log({0})".format, _LOGARITHMS, SUM)
"""The logarithm (6,) of a pose that is no translation: the twist whose exponential it is."""

_entrywise_exponential: Operation = Operation("entrywise exponential", lambda S, q: np.exp(hat(S) * q), "e^{{[{0}]{1}}}".format)
_with_transposed_rotation: Operation = Operation("rotation transposed", lambda T: homogeneous(T[:3, :3].T, T[:3, 3]), "{0}".format)

rotation_of: Operation = Operation("rotation of a pose", lambda T: T[:3, :3], "R({0})".format)
position_of: Operation = Operation("position of a pose", lambda T: T[:3, 3], "p({0})".format)
assemble: Operation = Operation("pose", _assembled, "({0}, {1})".format, _assemble_slips)
"""The pose with a rotation R and a position p, in the plane (3, 3) or in space (4, 4)."""

rotation_only: Operation = Operation("rotation as a pose", lambda R: _assembled(R, np.zeros(len(R))), "({0}, 0)".format)
translation: Operation = Operation("translation", lambda p: _assembled(np.eye(len(p)), p), "(I, {0})".format)
"""The pose that is a translation by p."""

columns: Operation = Operation("columns", lambda *axes: np.column_stack(axes), lambda *axes: f"({', '.join(axes)})", _columns_slips)
"""The rotation whose columns are the axes of a frame."""

to_point: Operation = Operation(
    "point in another frame", lambda T, x: T[:3, :3] @ x + T[:3, 3], lambda T, x: f"{_part(T, 'R')}\\,{x} + {_part(T, 'p')}", _POINT_MAP
)
"""The coordinates R x + p of a point x in another frame."""

to_direction: Operation = Operation(
    "direction in another frame", lambda T, x: T[:3, :3] @ x, lambda T, x: f"{_part(T, 'R')}\\,{x}", _DIRECTION_MAP
)
"""The components R x of a direction x in another frame."""

pose = partial(given, kind=Operation("given pose", lambda: None, str, _GIVEN_POSE))
"""A given pose, (4, 4)."""

point = partial(given, kind=Operation("given point", lambda: None, str, _point_slips))
"""A given point or vector, (2,) or (3,), whose coordinates are typed one by one."""

rotation = partial(given, kind=Operation("given rotation", lambda: None, str, table(
    ("rotation transposed", "use the transpose of ${}$ instead of ${}$", lambda R: transpose(R)),
)))
"""A given rotation, (2, 2) or (3, 3)."""
# fmt: on
