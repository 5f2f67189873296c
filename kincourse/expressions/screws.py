"""Screw axes in solutions: axes of joints, the adjoint, and the product of exponentials."""

from collections.abc import Sequence

import numpy as np

from kincourse.expressions.poses import exp
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import adjoint
from misstep.mutants.expression import Change, Changes, Expression, Operation, given, negative
from misstep.mutants.operations import ANGLE, SLIDE, VECTOR, radians

MOMENT_ADVICE = "The point of the body at the origin moves with $v = -\\omega \\times p$."


def direction(label: str, x: Array) -> Expression:
    """A given direction or axis, (3,).

    >>> [change.name for change, _ in direction("d", np.ones(3)).changes()]
    ['sign of a vector']
    """
    return given(label, x, VECTOR)


def screw_axes(label: str, S: Array) -> Expression:
    """Given screw axes, (6,) or (n, 6).

    >>> [change.name for change, _ in screw_axes("S", np.eye(6)).changes()]
    ['halves swapped']
    """
    return given(label, S, _SCREWS)


def joint_values(types: str, typed: Sequence[float], letter: str = "q") -> list[Expression]:
    """The values of joints: "R" in degrees, to be converted; "P" in metres.

    >>> [float(round(value.value, 4)) for value in joint_values("RP", [90, 0.5])]
    [1.5708, 0.5]
    """
    return [
        radians(given(f"{letter}_{i}", float(value), ANGLE))
        if kind == "R"
        else given(f"{letter}_{i}", float(value), SLIDE)
        for i, (kind, value) in enumerate(zip(types, typed, strict=True), start=1)
    ]


def exponentials(screws: Array, values: Sequence[Expression], letters: str | Sequence[str] = "S") -> list[Expression]:
    """The exponentials of the joints, e^{[S_i] q_i}.

    screws   (n, 6)
    letters  the letter of each screw

    >>> exponentials(np.eye(2, 6), joint_values("RR", [10, 20]))[1].latex
    'e^{[S_2]q_2}'
    """
    names = [letters] * len(screws) if isinstance(letters, str) else letters
    numbered = enumerate(zip(names, screws, values, strict=True), start=1)
    return [exp(screw_axes(f"{letter}_{i}", S), value) for i, (letter, S, value) in numbered]


def _screws_changes(node: Expression) -> Changes:
    text = f"swap the halves of ${node.latex}$"
    yield Change("halves swapped", text, "swap the halves of the screws"), _swap_halves(node)


def _screw_changes(node: Expression) -> Changes:
    omega, v = node.arguments
    advice = (
        "Here a screw is $(\\omega, v)$, the rotation first, as in Modern Robotics; some books use the other order."
    )
    yield Change("halves swapped", "write $(v, \\omega)$", "write $(v, \\omega)$", advice), screw(v, omega)


def _moment_changes(node: Expression) -> Changes:
    omega, p = node.arguments
    for name, text, wrong in (
        ("omega x p", "take $v = \\omega \\times p$, without the minus sign", negative(node)),
        ("point as moment", "take the point itself as $v$", p),
        ("no moment", "leave $v$ at zero", 0 * omega),
    ):
        yield Change(name, text, text, MOMENT_ADVICE), wrong


def _slide_changes(node: Expression) -> Changes:
    d, p = node.arguments
    advice = "A prismatic joint does not rotate: its screw is $(0, d)$."
    for name, text, wrong in (
        ("direction in omega", "put the direction of a slide into $\\omega$", screw(d, 0 * d)),
        ("slide as turn", "treat a prismatic joint as a revolute one", revolute(d, p)),
        ("moment of a slide", "take the moment of a slide, which has none", screw(0 * d, moment(d, p))),
    ):
        yield Change(name, text, text, advice), wrong


def _change_of_frame_changes(node: Expression) -> Changes:
    T, S = node.arguments
    Ad = f"$\\mathrm{{Ad}}_{{{T.latex}}}$"
    text = f"multiply rows by {Ad} from the right, without its transpose"
    yield (
        Change("adjoint not transposed", text, advice="The screws are rows: `S @ Ad.T`, not `S @ Ad`."),
        _rows_by_adjoint(T, S),
    )
    yield Change("only rotated", "rotate both halves, and leave out the change of origin"), _rotate_only(T, S)
    yield Change("only moved", "change the origin, and keep the directions of the axes"), _translate_only(T, S)
    yield Change("frame not changed", f"use ${S.latex}$ as it is"), S


def revolute(omega: Expression, p: Expression) -> Expression:
    """The screw of a revolute joint: (omega, -omega x p)."""
    return screw(omega, moment(omega, p))


def helical(omega: Expression, p: Expression, h: Expression) -> Expression:
    """The screw of a helical joint of pitch h: (omega, -omega x p + h omega)."""
    return screw(omega, moment(omega, p) + h * omega)


def _rotated(T: Array, S: Array) -> Array:
    R = T[:3, :3]
    return np.concatenate([S[..., :3] @ R.T, S[..., 3:] @ R.T], axis=-1)


def _moved(T: Array, S: Array) -> Array:
    """The moments about the new origin, in the old axes: with T = (R, p), the new origin stands at -R^T p."""
    R, p = T[:3, :3], T[:3, 3]
    return np.concatenate([S[..., :3], S[..., 3:] + np.cross(R.T @ p, S[..., :3])], axis=-1)


screw = Operation("screw", lambda w, v: np.concatenate([w, v]), "({0}, {1})".format, _screw_changes)
"""The screw (omega, v)."""

moment = Operation("moment", lambda w, p: -np.cross(w, p), "-{0} \\times {1}".format, _moment_changes)
"""The moment of an axis omega through p: -omega x p."""

prismatic = Operation("prismatic", lambda d, _: np.concatenate([0 * d, d]), "(0, {0})".format, _slide_changes)
"""The screw (0, d) of a prismatic joint; the point where it is mounted plays no part, but people use it."""

change_frame = Operation(
    "adjoint", lambda T, S: S @ adjoint(T).T, "\\mathrm{{Ad}}_{{{0}}} {1}".format, _change_of_frame_changes
)
"""Screws S (6,) or (n, 6) in another frame: Ad_T S."""

_swap_halves = Operation("halves swapped", lambda S: np.roll(S, 3, axis=-1), "{0}".format)
_rows_by_adjoint = Operation("rows by adjoint", lambda T, S: S @ adjoint(T), "{1}".format)
_rotate_only = Operation("only rotated", _rotated, "{1}".format)
_translate_only = Operation("only moved", _moved, "{1}".format)
_SCREWS = Operation("given screws", lambda: None, str, _screws_changes)
