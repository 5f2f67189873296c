"""Poses and rotations in solutions: inverses, exponentials, and the parts of a pose."""

from collections.abc import Callable

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import hat, homogeneous
from kinlib.rigid.lie import inverse as pose_inverse
from misstep.mutants.expression import Change, Changes, Expression, Operation, given, transpose

INVERSE_ADVICE = "The inverse of $(R, p)$ is $(R^T, -R^T p)$."


def pose(label: str, T: Array) -> Expression:
    """A given pose, (4, 4).

    >>> [change.name for change, _ in pose("T_{ab}", np.eye(4)).changes()]
    ['inverted', 'rotation transposed']
    """
    return given(label, T, _POSE)


def rotation(label: str, R: Array) -> Expression:
    """A given rotation, (2, 2) or (3, 3).

    >>> [change.name for change, _ in rotation("R", np.eye(3)).changes()]
    ['rotation transposed']
    """
    return given(label, R, _ROTATION)


def with_position(T: Array, p: Array) -> Array:
    """Return a pose (4, 4) with another position p (3,).

    >>> with_position(np.eye(4), [1, 2, 3])[:3, 3]
    array([1., 2., 3.])
    """
    return homogeneous(T[:3, :3], p)


def _pose_changes(node: Expression) -> Changes:
    yield Change("inverted", f"use the inverse of ${node.latex}$, which belongs there as it is"), inverse(node)
    transposed = _of_pose("rotation transposed", lambda T: homogeneous(T[:3, :3].T, T[:3, 3]), "{0}")
    yield Change("rotation transposed", f"use ${node.latex}$ with the transpose of its rotation"), transposed(node)


def _rotation_changes(node: Expression) -> Changes:
    yield (
        Change("rotation transposed", f"use the transpose of ${node.latex}$, which belongs there as it is"),
        transpose(node),
    )


def _inverse_changes(node: Expression) -> Changes:
    inner = node.arguments[0]
    T = inner.latex
    yield Change("inverse left out", f"use ${T}$, where its inverse belongs", "leave out every inverse"), inner
    text = f"transpose ${T}$ instead of inverting it"
    yield (
        Change("transpose for inverse", text, "transpose poses instead of inverting them", INVERSE_ADVICE),
        transpose(inner),
    )
    for latex, wrong in _WRONG_POSITIONS.items():
        text = f"write ${latex}$ as the position of the inverse of ${T}$"
        yield (
            Change("position of the inverse", text, f"write ${latex}$ as the position of an inverse", INVERSE_ADVICE),
            wrong(inner),
        )


def _exp_changes(node: Expression) -> Changes:
    S, q = node.arguments
    factor = f"${node.latex}$"
    yield Change("joint value left out", f"leave out ${q.latex}$ in {factor}"), exp(S, 1.0)
    if S.value[:3].any():  # for a prismatic joint, the series ends there
        for term, series in (("linear", _linear), ("quadratic", _quadratic)):
            text = "stop the series of {0} after its {1} term"
            yield (
                Change("series cut short", text.format(factor, term), text.format("each exponential", term)),
                series(S, q),
            )
    text = f"take the exponential of each entry instead of {factor}"
    yield (
        Change(
            "exponential of each entry",
            text,
            "take the exponential of each entry (`np.exp`) instead of that of the matrix",
        ),
        _entrywise_exponential(S, q),
    )


def _of_pose(name: str, of: Callable[[Array], Array], latex: str) -> Operation:
    return Operation(name, of, latex.format)


inverse = Operation("inverse of a pose", pose_inverse, "{0}^{{-1}}".format, _inverse_changes, involution=True)
"""The inverse of a pose: (R^T, -R^T p)."""

exp = Operation("exponential", lambda S, q: exponential(S * q), "e^{{[{0}]{1}}}".format, _exp_changes)
"""The exponential of a screw S (6,) or rotation vector (3,) times a joint value: e^{[S] q}."""

_linear = Operation("series", lambda S, q: np.eye(len(hat(S))) + hat(S) * q, "I + [{0}]{1}".format)
_quadratic = Operation(
    "series",
    lambda S, q: np.eye(len(hat(S))) + hat(S) * q + hat(S) @ hat(S) * q**2 / 2,
    "I + [{0}]{1} + \\ldots".format,
)
_entrywise_exponential = Operation("entrywise exponential", lambda S, q: np.exp(hat(S) * q), "e^{{[{0}]{1}}}".format)

rotation_of = Operation("rotation of a pose", lambda T: T[:3, :3], "R({0})".format)
position_of = Operation("position of a pose", lambda T: T[:3, 3], "p({0})".format)
assemble = Operation("pose", homogeneous, "({0}, {1})".format)
"""The pose with a rotation R and a position p."""

_WRONG_POSITIONS = {
    "-p": _of_pose("inverse with -p", lambda T: homogeneous(T[:3, :3].T, -T[:3, 3]), "{0}"),
    "p": _of_pose("inverse with p", lambda T: homogeneous(T[:3, :3].T, T[:3, 3]), "{0}"),
    "-R\\,p": _of_pose("inverse with -R p", lambda T: homogeneous(T[:3, :3].T, -T[:3, :3] @ T[:3, 3]), "{0}"),
    "R^T p": _of_pose("inverse with R^T p", lambda T: homogeneous(T[:3, :3].T, T[:3, :3].T @ T[:3, 3]), "{0}"),
}
"""Positions that people write into the inverse of a pose, where -R^T p belongs."""

_POSE = Operation("given pose", lambda: None, str, _pose_changes)
_ROTATION = Operation("given rotation", lambda: None, str, _rotation_changes)
