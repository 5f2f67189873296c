"""Poses and rotations in solutions: inverses, exponentials, and the parts of a pose."""

from functools import partial
from itertools import combinations

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import hat, homogeneous
from misstep.mutants.expression import SUM, Expression, Operation, Slip, Slips, given, negative, power, transpose
from misstep.mutants.operations import function

INVERSE_ADVICE = "The inverse of $(R, p)$ is $(R^T, -R^T p)$."


def pose(label: str, T: Array) -> Expression:
    """A given pose, (4, 4).

    >>> [slip.name for slip in pose("T_{ab}", np.eye(4)).slips()]
    ['inverse', 'transposed', 'rotation transposed', 'rotation left out', 'position left out']
    """
    return given(label, T, _POSE)


def rotation(label: str, R: Array) -> Expression:
    """A given rotation, (2, 2) or (3, 3).

    >>> [slip.name for slip in rotation("R", np.eye(3)).slips()]
    ['rotation transposed']
    """
    return given(label, R, _ROTATION)


def point(label: str, p: Array) -> Expression:
    """A given point or vector, (2,) or (3,), whose coordinates are typed one by one.

    >>> [slip.did for slip in point("p", np.ones(2)).slips()][1:]
    ['take the $x$ of $p$ with the opposite sign', 'take the $y$ of $p$ with the opposite sign', 'swap the $x$ and the $y$ of $p$']
    """
    return given(label, p, _POINT)


def rotation_about(axis: int, angle: Expression) -> Expression:
    """The rotation (3, 3) by an angle in radians about axis 0, 1 or 2: x, y or z.

    >>> rotation_about(2, given("q", np.pi / 2)).value.round(9)[:, 0]
    array([0., 1., 0.])
    """
    return Operation(
        f"rotation about {'xyz'[axis]}",
        partial(_plane_rotation, axis),
        f"R_{'xyz'[axis]}({{0}})".format,
        _about_slips,
    )(angle)


def with_position(T: Array, p: Array) -> Array:
    """Return a pose (4, 4) with another position p (3,).

    >>> with_position(np.eye(4), [1, 2, 3])[:3, 3]
    array([1., 2., 3.])
    """
    return homogeneous(T[:3, :3], p)


def _pose_slips(node: Expression) -> Slips:
    yield Slip("inverse", f"use the inverse of ${node.latex}$ instead of ${node.latex}$", inverse(node))
    yield Slip("transposed", f"use the transpose of ${node.latex}$ instead of ${node.latex}$", transpose(node))
    transposed = function("rotation transposed", lambda T: homogeneous(T[:3, :3].T, T[:3, 3]), "{0}")
    yield Slip("rotation transposed", f"use ${node.latex}$ with the transpose of its rotation", transposed(node))
    R, p = node.value[:3, :3], node.value[:3, 3]
    for name, what, wrong in (
        ("rotation left out", "rotation", homogeneous(np.eye(3), p)),
        ("position left out", "position", homogeneous(R, 0 * p)),
    ):
        yield Slip(name, f"leave out the {what} of ${node.latex}$", given(node.latex, wrong), may_coincide=True)


def _rotation_slips(node: Expression) -> Slips:
    text = f"use the transpose of ${node.latex}$ instead of ${node.latex}$"
    yield Slip("rotation transposed", text, transpose(node))


def _inverse_slips(node: Expression) -> Slips:
    inner = node.arguments[0]
    T = inner.latex
    yield Slip("inverse left out", f"use ${T}$, where its inverse belongs", inner, everywhere="leave out every inverse")
    for name, verb, instead in (
        ("transpose for inverse", "transpose", transpose(inner)),
        ("negative for inverse", "negate", negative(inner)),
    ):
        everywhere = f"{verb} poses instead of inverting them"
        yield Slip(name, f"{verb} ${T}$ instead of inverting it", instead, everywhere=everywhere, advice=INVERSE_ADVICE)
    if inner.arguments:  # a given pose has this change itself
        text = f"use the rotation of ${T}$, where its transpose belongs"
        yield Slip("rotation transposed", text, _rotation_kept(inner), advice=INVERSE_ADVICE)
    for template, wrong in _WRONG_POSITIONS.items():
        everywhere = template.format("each pose")
        instead = function("wrong inverse", wrong, "{0}")(inner)
        yield Slip("position of the inverse", template.format(f"${T}$"), instead, everywhere, INVERSE_ADVICE)


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
    for k in (1, 2):
        about = (axis + k) % 3
        text = f"rotate about the ${'xyz'[about]}$ axis instead of the ${'xyz'[axis]}$ axis"
        yield Slip("another axis", text, rotation_about(about, angle))
    mirrored = partial(_plane_rotation, axis, swapped=True)
    by_complement = lambda q: _plane_rotation(axis, np.copysign(np.pi / 2, q) - q)  # noqa: E731
    for swap in (mirrored, by_complement):
        yield Slip("sine and cosine swapped", "swap sine and cosine", Operation("swapped", swap, "{0}".format)(angle))


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
    for shift in range(1, len(axes)):
        order = [*axes[shift:], *axes[:shift]]
        listed = ", ".join(f"${axis.latex}$" for axis in order)
        yield Slip("columns in another order", f"write the columns in the order {listed}", columns(*order))


def _assemble_slips(node: Expression) -> Slips:
    R, p = node.arguments
    yield Slip("inverse", "write the inverse of the right matrix", _inverted(node))
    if len(p.value) == 3:
        yield Slip("position in the other frame", "write $R^T p$ as the position", assemble(R, transpose(R) @ p))
    text = "write the position into the last row instead of the last column"
    yield Slip("last row", text, _last_row(node), in_parts=False)
    yield Slip("position left out", "leave out the position", assemble(R, 0 * p))
    yield Slip("rotation left out", "leave out the rotation", assemble(given("I", np.eye(len(R.value))), p))
    yield Slip("corner", "write a 0 at the end of the last row, where a 1 belongs", _without_corner(node))


def _point_map_slips(node: Expression) -> Slips:
    T, x = node.arguments
    R, p = rotation_of(T), position_of(T)
    advice = "A point has a 1 as its last entry, which adds $p$: $R\\,x + p$."
    yield Slip("point as a direction", f"leave out the position of ${T.latex}$ for a point", R @ x, advice=advice)
    yield Slip("sign", f"take the position of ${T.latex}$ with the opposite sign", R @ x - p)
    text = f"take ${x.latex}$, rotated, with the opposite sign"
    yield Slip("sign", text, p - R @ x, may_coincide=True)
    yield Slip("order", f"add the position of ${T.latex}$ in the wrong order, before rotating", R @ (x + p))
    yield from _map_slips(T, x, to_point)


def _direction_map_slips(node: Expression) -> Slips:
    T, x = node.arguments
    advice = "A direction has a 0 as its last entry, because it is a difference of two points: it is rotated only."
    text = f"add the position of ${T.latex}$ to a direction"
    yield Slip("direction as a point", text, to_point(T, x), advice=advice)
    yield from _map_slips(T, x, to_direction)


def _map_slips(T: Expression, x: Expression, of: Operation) -> Slips:
    unrotated = assemble(given("I", np.eye(3)), position_of(T))
    text = f"leave out the rotation of ${T.latex}$"
    yield Slip("rotation left out", f"{text} for ${x.latex}$", of(unrotated, x), everywhere=text)


def _exp_slips(node: Expression) -> Slips:
    S, q = node.arguments
    factor = f"${node.latex}$"
    yield Slip("joint value left out", f"leave out ${q.latex}$ in {factor}", exp(S, 1.0))
    if S.value[:3].any():  # for a prismatic joint, the series ends there
        for term, series in (("linear", _linear), ("quadratic", _quadratic)):
            text, everywhere = (
                f"stop the series of {one} after its {term} term" for one in (factor, "each exponential")
            )
            yield Slip("series cut short", text, series(S, q), everywhere=everywhere, one_by_one=False)
    text = f"take the exponential of each entry instead of {factor}"
    everywhere = "take the exponential of each entry (`np.exp`) instead of that of the matrix"
    yield Slip("exponential of each entry", text, _entrywise_exponential(S, q), everywhere=everywhere, one_by_one=False)


def _logarithm(T: Array) -> Array:
    """The twist (6,) of a pose whose angle is between 0 and pi; without the checks of kinlib's `log`, which take most of its time."""
    R, p = T[:3, :3], T[:3, 3]
    axial = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    sine, cosine = np.sqrt(axial @ axial), (np.trace(R) - 1) / 2
    angle = np.arctan2(sine, cosine)
    omega = x, y, z = axial * (angle / sine)
    W = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    v = p - W @ p / 2 + (1 / angle**2 - (1 + cosine) / (2 * angle * sine)) * (W @ (W @ p))
    return np.concatenate([omega, v])


def _logarithm_slips(node: Expression) -> Slips:
    [T] = node.arguments
    for name, text, of, advice in (
        (
            "translation for v",
            "take the position of the pose as $v$",
            lambda T: np.concatenate([_logarithm(T)[:3], T[:3, 3]]),
            "The $v$ of a logarithm differs from the position, because the motion rotates too.",
        ),
        (
            "first order",
            "take the entries of $T - I$ instead of the logarithm",
            lambda T: np.concatenate([[T[2, 1], T[0, 2], T[1, 0]], T[:3, 3]]),
            "They are those of the logarithm for infinitesimal motions only.",
        ),
        (
            "degrees",
            "give $\\omega$ in degrees",
            lambda T: _logarithm(T) * np.repeat((180 / np.pi, 1), 3),
            "A twist is in radians.",
        ),
        (
            "halves swapped",
            "write $(v, \\omega)$",
            lambda T: np.roll(_logarithm(T), 3),
            "Here a twist is $(\\omega, v)$.",
        ),
    ):
        yield Slip(name, text, function(name, of, "{0}")(T), advice=advice)


def _assembled(R: Array, p: Array) -> Array:
    T = np.eye(len(p) + 1)
    T[:-1, :-1], T[:-1, -1] = R, p
    return T


def _with_last_row(T: Array) -> Array:
    moved = T.copy()
    moved[-1, :-1], moved[:-1, -1] = T[:-1, -1], 0
    return moved


inverse = Operation("inverse of a pose", np.linalg.inv, power("{-1}"), _inverse_slips, involution=True)
"""The inverse of a pose: (R^T, -R^T p)."""

exp = Operation("exponential", lambda S, q: exponential(S * q), "e^{{[{0}]{1}}}".format, _exp_slips)
"""The exponential of a screw S (6,) or rotation vector (3,) times a joint value: e^{[S] q}."""

logarithm = Operation("logarithm", _logarithm, "\\log({0})".format, _logarithm_slips, SUM)
"""The logarithm (6,) of a pose that is no translation: the twist whose exponential it is."""

_linear = Operation("series", lambda S, q: np.eye(len(hat(S))) + hat(S) * q, "I + [{0}]{1}".format)
_quadratic = Operation(
    "series",
    lambda S, q: np.eye(len(hat(S))) + hat(S) * q + hat(S) @ hat(S) * q**2 / 2,
    "I + [{0}]{1} + \\ldots".format,
)
_entrywise_exponential = Operation("entrywise exponential", lambda S, q: np.exp(hat(S) * q), "e^{{[{0}]{1}}}".format)

rotation_of = Operation("rotation of a pose", lambda T: T[:3, :3], "R({0})".format)
position_of = Operation("position of a pose", lambda T: T[:3, 3], "p({0})".format)
assemble = Operation("pose", _assembled, "({0}, {1})".format, _assemble_slips)
"""The pose with a rotation R and a position p, in the plane (3, 3) or in space (4, 4)."""

rotation_only = Operation("rotation as a pose", lambda R: _assembled(R, np.zeros(len(R))), "({0}, 0)".format)
translation = Operation("translation", lambda p: _assembled(np.eye(len(p)), p), "(I, {0})".format)
"""The pose that is a translation by p."""

columns = Operation(
    "columns", lambda *axes: np.column_stack(axes), lambda *axes: f"({', '.join(axes)})", _columns_slips
)
"""The rotation whose columns are the axes of a frame."""

to_point = Operation(
    "point in another frame", lambda T, x: T[:3, :3] @ x + T[:3, 3], "{0}\\,{1}".format, _point_map_slips
)
"""The coordinates R x + p of a point x in another frame."""

to_direction = Operation(
    "direction in another frame", lambda T, x: T[:3, :3] @ x, "{0}\\,{1}".format, _direction_map_slips
)
"""The components R x of a direction x in another frame."""

_inverted = Operation("inverse", np.linalg.inv, "{0}".format)
_last_row = Operation("last row", _with_last_row, "{0}".format)
_without_corner = Operation("corner", lambda T: T - np.diag([0.0] * (len(T) - 1) + [1.0]), "{0}".format)

_rotation_kept = function("inverse with R", lambda T: homogeneous(T[:3, :3], -T[:3, :3] @ T[:3, 3]), "{0}")
_WRONG_POSITIONS = {
    "write $-p$ as the position of the inverse of {}": lambda T: homogeneous(T[:3, :3].T, -T[:3, 3]),
    "leave the position unchanged in the inverse of {}": lambda T: homogeneous(T[:3, :3].T, T[:3, 3]),
    "write $-R\\,p$ as the position of the inverse of {}": lambda T: homogeneous(T[:3, :3].T, -T[:3, :3] @ T[:3, 3]),
    "leave out the minus sign of $-R^T p$ in the inverse of {}": lambda T: homogeneous(
        T[:3, :3].T, T[:3, :3].T @ T[:3, 3]
    ),
    "leave out the position of the inverse of {}": lambda T: homogeneous(T[:3, :3].T, 0 * T[:3, 3]),
}
"""Inverses of a pose with another position than -R^T p, and how they come about."""

_POSE = Operation("given pose", lambda: None, str, _pose_slips)
_POINT = Operation("given point", lambda: None, str, _point_slips)
_ROTATION = Operation("given rotation", lambda: None, str, _rotation_slips)
