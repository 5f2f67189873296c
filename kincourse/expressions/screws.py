"""Screw axes in solutions: axes of joints, the adjoint, and the product of exponentials."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np

from kincourse.expressions.poses import exp, inverse
from kincourse.sampling.drawn_machines import STEP_M
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import hat
from misstep.mutants.expression import (
    ALL_AT_ONCE,
    MAY_COINCIDE,
    SUM,
    Expression,
    Operation,
    Slip,
    Slips,
    given,
    multiple,
    negative,
    product,
    table,
    total,
)
from misstep.mutants.operations import ANGLE, LENGTH, SLIDE, VECTOR, radians, stack

MIN_SHIFT_M = 0.01
"""By how much another origin must change a moment, so that it can be seen that the points were measured from it."""

ROWS_ADVICE = "The screws are rows: `S @ Ad.T`, not `S @ Ad`."
ADJOINT_ADVICE = "The adjoint of $(R, p)$ has the blocks $R$ and $0$ above $[p]R$ and $R$."
ORDER_ADVICE = (
    "Here a screw is $(\\omega, v)$, the rotation first, as in Modern Robotics; some books use the other order."
)
MOMENT_ADVICE = (
    "The moment of an axis through $p$ is $-\\omega \\times p$, the velocity that the rotation gives to the origin."
)
SUM_ADVICE = "You can rely on $e^A e^B = e^{A+B}$ only where $AB = BA$, and the joints of an arm seldom commute."
UNITS_ADVICE = "The joint values are in radians and metres, as the exponential needs them."
SLIDE_ADVICE = "A prismatic joint does not rotate: its screw is $(0, d)$."
ADVANCE_ADVICE = "The body also translates along the axis: add ${3}\\,{1}$."
PITCH_ADVICE = "The pitch is part of $v$: $v = -\\omega \\times p + h\\,\\omega$."
RAD = np.pi / 180
UNIT_ADVICE = "The direction of an axis is a unit vector, with the components $\\cos$ and $\\sin$ of the angle."


direction = partial(given, kind=VECTOR)
"""A given direction or axis, (3,)."""


def joint_values(types: str, typed: Sequence[float] | Array, letter: str = "q") -> list[Expression]:
    """The values of joints: "P" in metres, all others in degrees, which are to be converted."""
    values = [
        given(f"{letter}_{i}", float(x), SLIDE if kind == "P" else ANGLE) for i, (kind, x) in _numbered(types, typed)
    ]
    return [value if value.operation is SLIDE else radians(value) for value in values]


def values_in_radians(types: str, q: Sequence[float] | Array) -> list[Expression]:
    """The values of joints in radians and metres, as they are needed."""
    return [joint_value(kind, i, x) for i, (kind, x) in _numbered(types, q)]


def joint_value(kind: str, i: int, x: float) -> Expression:
    """The value of joint i in metres ("P") or radians, as it is needed."""
    return given(f"q_{i}", float(x), JOINT_LENGTH if kind == "P" else JOINT_ANGLE)


def _numbered(*columns: Any) -> Iterator[tuple[int, Any]]:
    return enumerate(zip(*columns, strict=True), start=1)


def exponentials(screws: Array, values: Sequence[Expression], letters: str = "S") -> list[Expression]:
    """The exponentials of the joints, e^{[S_i] q_i}.

    screws   (n, 6)
    letters  the letter of all screws, or one for each
    """
    names = letters if len(letters) == len(screws) else letters * len(screws)
    return [exp(screw_axes(f"{letter}_{i}", S), value) for i, (letter, S, value) in _numbered(names, screws, values)]


def forward_kinematics(before: Sequence[Expression], home: Expression, after: Sequence[Expression] = ()) -> Expression:
    """The product of exponentials with the home pose after those of the screws in {s} and before those of the screws in {b}."""
    n = len(before)
    factors = [*before, *after]
    values = [factor.arguments[1] for factor in factors]

    def with_values(values: Sequence[Expression]) -> Expression:
        changed = [exp(factor.arguments[0], value) for factor, value in zip(factors, values, strict=True)]
        return product(*changed[:n], home, *changed[n:])

    others = [
        ("another joint value", f"use ${other.latex}$, where ${value.latex}$ belongs", with_values([*values[:i], other, *values[i + 1 :]]))
        for i, value in enumerate(values)
        for other in values[max(i - 1, 0) : i] + values[i + 1 : i + 2]
    ]  # fmt: skip
    others += [
        ("another joint value", "take for each joint the value of the next one", with_values([*values[1:], values[0]])),
        ("another joint value", f"use ${values[0].latex}$ for all joints", with_values([values[0]] * len(values))),
    ]
    sides = [list(side) for side in (before, after)]
    added = [[total(*side)] if len(side) > 1 else side for side in sides]
    at_once = [[_once(*(multiple(*e.arguments) for e in side))] if len(side) > 1 else side for side in sides]
    T = product(*before, home, *after).mistaken_for(*others, may_coincide=True)
    return T.mistaken_for(
        ("one exponential", "take one exponential of the sum of the twists", product(*at_once[0], home, *at_once[1]), SUM_ADVICE),
        ("sum for product", "add the exponentials", product(*added[0], home, *added[1])),
        ("sign of a joint value", "take every joint value with the opposite sign", with_values([negative(value) for value in values])),
        ("joint values reversed", "use the joint values in the reverse order", with_values(values[::-1])),
        ("at home", f"give ${home.latex}$, the pose at home", home, "The joints have moved since."),
    )  # fmt: skip


def joint_screws(
    axes: Array, points: Array | Sequence[Expression], pitches: Array, numbers: Sequence[int] = ()
) -> Expression:
    """The screws of joints in rows, (n, 6).

    axes     (n, 3), unit vectors
    points   (n, 3), a point on each axis
    pitches  (n,), 0 for a revolute joint and infinite for a prismatic one
    numbers  the numbers of the joints; by default 1, 2, ...
    """
    numbers = numbers or range(1, len(axes) + 1)
    letters = ["d" if np.isinf(h) else "\\omega" for h in pitches]
    directions = [direction(f"{x}_{i}", axis) for x, i, axis in zip(letters, numbers, axes, strict=True)]

    def rows_with(places: Sequence[Any]) -> Expression:
        rows = []
        for i, axis, place, h in zip(numbers, directions, places, pitches, strict=True):
            label = f"the place of joint ${i}$" if np.isinf(h) else f"p_{i}"  # words: a solution does not list it
            p = place if isinstance(place, Expression) else given(label, place)
            row = helical(axis, p, given(f"h_{i}", h)) if h else screw(axis, moment(axis, p).named(f"v_{i}"))
            rows.append(prismatic(axis, p) if np.isinf(h) else row)
        return stack(*rows)

    places, rows = list(points), rows_with(list(points))
    slips = [("halves swapped", "write $(v, \\omega)$ in every row", _swap_halves(rows), ORDER_ADVICE)]
    for which, order in (("next", [*places[1:], places[0]]), ("previous", [places[-1], *places[:-1]])):
        if len(places) > 1:
            slips.append(
                ("another point", f"combine each axis with the point of the {which} joint", rows_with(order), "")
            )
    if isinstance(points, np.ndarray):
        for i, p in zip(numbers, points, strict=True):
            other = rows_with(list(points - p))
            if np.abs(other.value - rows.value).max() > MIN_SHIFT_M:
                advice = "The points are given in {s}, each from its origin."
                slips.append(("another origin", f"measure each point from joint {i}", other, advice))
    return rows.mistaken_for(*slips)


def drawn_revolute(omega: Array, p: Array, others: Mapping[str, Array]) -> Expression:
    """The screw of a revolute joint whose axis omega (3,) through p (3,) is read off a drawing with whole coordinates.

    others  the points that people take for p, in words
    """
    axis = direction("\\omega", omega).mistaken_for(
        *(("another axis", f"take the axis along ${text}{name}$", sign * np.eye(3)[i])
          for sign, text in ((1, ""), (-1, "-")) for i, name in enumerate("xyz") if abs(omega[i]) < 0.5)
    )  # fmt: skip
    misread = [*_misread(p), *(("another point", f"take {text} as the point", other) for text, other in others.items())]
    return screw(axis, moment(axis, given("p", p).mistaken_for(*_off_the_axis(misread, omega, p))))


def read_screws(
    axes: Array, points: Array, numbers: Sequence[int], frame: str, marks: Array | Sequence[Array] = ()
) -> Expression:
    """The screws (n, 6) of revolute joints that are read off a dimensioned drawing, in rows.

    marks  other marks that people take for a point
    """
    joints, pitches = zip(numbers, points, axes, strict=True), np.zeros(len(axes))
    read = [_read_point(f"P_{i}", p, axis, marks) for i, p, axis in joints]
    text, advice = f"measure the points from $P_{numbers[0]}$", f"Points are measured from the origin of {{{frame}}}."
    from_first = joint_screws(axes, points - points[0], pitches).value
    return joint_screws(axes, read, pitches, numbers).mistaken_for(("another origin", text, from_first, advice))


def _read_point(label: str, p: Array, axis: Array, marks: Array | Sequence[Array]) -> Expression:
    """A point of a joint axis that is read off."""
    views = "The top view shows $x$ and $y$, the front view $x$ and $z$."
    slips = [
        ("views swapped", f"swap $y$ and $z$ of ${label}$", p[[0, 2, 1]], views),
        ("depth reversed", f"take the $y$ of ${label}$ with the opposite sign", p * (1, -1, 1), views),
        *(("another mark", f"read another mark instead of ${label}$", mark, "") for mark in marks),
    ]
    return given(label, p, LENGTH).mistaken_for(*_off_the_axis(slips, axis, p))


def _off_the_axis(slips: Iterable[tuple[Any, ...]], axis: Array, p: Array) -> Iterator[tuple[Any, ...]]:
    """Yield the slips that take a point off the axis through p: another point of the axis is as good."""
    return (slip for slip in slips if np.abs(np.cross(axis, slip[2] - p)).max() > STEP_M)


def _misread(p: Array) -> Iterator[tuple[str, str, Array]]:
    """Yield the name, the text and the value of each mistake that people make when they read a point off a drawing."""
    for name, unit, x in zip("xyz", np.eye(3), p, strict=True):
        yield "sign of a coordinate", f"read the ${name}$ of the point with the opposite sign", p - 2 * x * unit
        yield "coordinate left out", f"take the ${name}$ of the point as 0", p - x * unit
        yield "coordinate read wrong", f"misread the ${name}$ of the point by one metre", p + unit
        yield "coordinate read wrong", f"misread the ${name}$ of the point by one metre", p - unit
    for i, j in combinations(range(3), 2):
        order = np.arange(3)
        order[[i, j]] = j, i
        yield "coordinates swapped", f"swap ${'xyz'[i]}$ and ${'xyz'[j]}$ of the point", p[order]


def _moment_slips(node: Expression) -> Slips:
    yield from _MOMENTS(node)
    if abs(node.value[1]) > 1e-9 and np.abs(node.value[[0, 2]]).max() > 1e-9:  # otherwise it is the sign of the moment
        text = "take the middle entry of a cross product with the wrong sign"
        yield Slip("sign in the cross product", text, node * np.array([1, -1, 1]), everywhere=text)


def _change_of_frame_slips(node: Expression) -> Slips:
    T, S = node.arguments
    Ad = f"$\\mathrm{{Ad}}_{{{T.latex}}}$"
    text, advice = f"use the transpose of {Ad}", ""
    if np.ndim(S.value) > 1:
        text, advice = f"multiply rows by {Ad} from the right, without its transpose", ROWS_ADVICE
        back = inverse(T)
        text_back = f"multiply rows by $\\mathrm{{Ad}}_{{{back.latex}}}$ from the right"
        yield Slip("adjoint not transposed", text_back, _by_transposed_adjoint(back, S), advice=advice)
        if len(S.value) > 1:
            yield Slip("rows reversed", "list the screws from the last joint to the first", node[::-1])
    yield Slip("adjoint not transposed", text, _by_transposed_adjoint(T, S), advice=advice)
    for name, said, blocks in _OTHER_MATRICES:
        advice = ADJOINT_ADVICE if "{Ad}" in said else ""
        yield Slip(
            name, said.replace("{Ad}", Ad), Operation(name, partial(_by, blocks), "{1}".format)(T, S), advice=advice
        )
    yield Slip("frame not changed", f"use ${S.latex}$ as it is given", S)
    yield Slip("halves swapped", "swap the halves of the result", _swap_halves(node), advice=ORDER_ADVICE)
    yield Slip("entry by entry", f"multiply {Ad} entry by entry (`*` instead of `@`)", _entry_by_entry(T, S))


def revolute(omega: Expression, p: Expression) -> Expression:
    """The screw of a revolute joint: (omega, -omega x p)."""
    return screw(omega, moment(omega, p))


def helical(omega: Expression, p: Expression, h: Expression) -> Expression:
    """The screw of a helical joint of pitch h: (omega, -omega x p + h omega)."""
    turning = moment(omega, p)
    return screw(omega, _advancing(turning, omega, p, h)).mistaken_for(
        ("pitch in omega", f"multiply $\\omega$ by the pitch ${h.latex}$", screw(h * omega, turning)),
        ("revolute as prismatic", "leave $\\omega$ and the moment at zero", screw(0 * omega, h * omega)),
        advice=PITCH_ADVICE,
    )


def _joined(omega: Array, v: Array) -> Array:
    return np.concatenate([omega, v], axis=-1)


def _moments_negated(S: Array) -> Array:
    turns = S[..., :3].any(axis=-1, keepdims=True)
    return np.where(turns & (np.arange(6) >= 3), -S, S)


def _joint_value_slips(several: str) -> Sequence[tuple[Any, ...]]:
    return (
        ("sign of a joint value", "take ${}$ with the opposite sign |take every joint value with the opposite sign", negative),
        ("joint at zero", "leave ${}$ at 0 |leave every joint at zero", lambda q: 0.0 * q),
        ("converted twice", f"use `np.radians` on ${{}}$ |use `np.radians` on {several}", lambda q: RAD * q, UNITS_ADVICE, ALL_AT_ONCE),
        ("degrees", f"use ${{}}$ in degrees |use {several} in degrees", lambda q: q / RAD, UNITS_ADVICE, ALL_AT_ONCE),
    )  # fmt: skip


def unless_unchanged(slips: Callable[[Expression], Slips], node: Expression) -> Slips:
    """Yield the slips in a value or a row; where it has zeros many of them change nothing, and are no mistakes there."""
    is_full = all(np.all(entry.value) for entry in node.arguments or (node,))
    yield from (one for one in slips(node) if is_full or not np.allclose(one.wrong.value, node.value))


Blocks = Callable[[Array, Array], tuple[Any, Any, Any, Any]]
"""The blocks of a matrix (6, 6), row after row, from R and [p]; 0 is a block of zeros."""


def _matrix(blocks: Blocks, T: Array) -> Array:
    if T[3, :3].any():
        raise ValueError(f"The last row of a pose must be 0 0 0 1; got {T[3]}.")
    A = np.zeros((6, 6))
    A[:3, :3], A[:3, 3:], A[3:, :3], A[3:, 3:] = blocks(T[:3, :3], hat(T[:3, 3]))
    return A


def _by(blocks: Blocks, T: Array, S: Array) -> Array:
    changed: Array = S @ _matrix(blocks, T).T
    return changed


def _adjoint(R: Array, P: Array) -> tuple[Any, Any, Any, Any]:
    return R, 0, P @ R, R


# fmt: off
_OTHER_MATRICES: Sequence[tuple[str, str, Blocks]] = (
    ("position left out", "rotate both halves without the change of origin", lambda R, _: (R, 0, 0, R)),
    ("rotation left out", "change the origin without rotating the axes", lambda R, P: (np.eye(3), 0, R.T @ P @ R, np.eye(3))),
    ("block on the wrong side", "put the block $[p]R$ of {Ad} in the upper right corner", lambda R, P: (R, P @ R, 0, R)),
    ("sign in the adjoint", "take the block $[p]R$ of {Ad} with the opposite sign", lambda R, P: (R, 0, -P @ R, R)),
    ("order in the adjoint", "write $R[p]$ instead of $[p]R$ in {Ad}", lambda R, P: (R, 0, R @ P, R)),
)
"""The matrices that people multiply screws by in place of the adjoint, and how they come about."""

tilted: Operation = Operation(
    "tilted axis", lambda u, t, angle: np.cos(angle) * u + np.sin(angle) * t, "\\cos {2}\\,{0} + \\sin {2}\\,{1}".format, table(
        ("sine and cosine swapped", "swap sine and cosine of ${2}$", lambda u, t, angle: tilted(t, u, angle),
         "At 0 degrees the axis is ${0}$, so ${0}$ has the cosine."),
        ("not a unit vector", "add ${0}$ and ${1}$ without the cosine and the sine of the angle", lambda u, t, _: u + t, UNIT_ADVICE),
        ("tilt left out", "take the axis along ${0}$, without its tilt", lambda u, _t, _: u),
        ("sign of a vector", "take ${}$ with the opposite sign", lambda *all_of_it: negative(tilted(*all_of_it))),
    ), SUM,
)
"""A unit vector that is tilted from a unit vector u towards a perpendicular one t by an angle in radians."""

screw: Operation = Operation("screw", _joined, "({0}, {1})".format, table(
    ("halves swapped", "write $(v, \\omega)$ |write $(v, \\omega)$ for revolute joints", lambda w, v: screw(v, w), ORDER_ADVICE),
    ("revolute as prismatic", "write the screw of a prismatic joint, $(0, \\omega)$", lambda w, _: screw(0 * w, w)),
    ("sign of omega", "take $\\omega$ with the opposite sign, but not $v$", lambda w, v: screw(negative(w), v)),
))
"""The screw (omega, v)."""

_MOMENTS = table(
    ("omega x p", "take the moment as $\\omega \\times p$, without the minus sign |", lambda w, p: negative(moment(w, p)), MOMENT_ADVICE),
    ("point as moment", "take the point itself as the moment |", lambda _, p: p, MOMENT_ADVICE),
    ("point as moment", "take $-p$ as the moment |", lambda _, p: negative(p), MOMENT_ADVICE),
    ("no moment", "leave out the moment |", lambda w, _: 0 * w, MOMENT_ADVICE),
)
moment: Operation = Operation("moment", lambda w, p: -np.cross(w, p), "-{0} \\times {1}".format, _moment_slips)
"""The moment of an axis omega through p: -omega x p."""

prismatic: Operation = Operation("prismatic", lambda d, _: _joined(0 * d, d), "(0, {0})".format, table(
    ("direction in omega", "put the direction of a prismatic joint into $\\omega$ |", lambda d, _: screw(d, 0 * d), SLIDE_ADVICE),
    ("prismatic as revolute", "treat a prismatic joint as a revolute one |", lambda d, p: revolute(d, p), SLIDE_ADVICE),
    ("moment of a slide", "take the moment of a prismatic joint, which has none |", lambda d, p: screw(0 * d, moment(d, p)), SLIDE_ADVICE),
))
"""The screw (0, d) of a prismatic joint; the point where it is mounted plays no part, but people use it."""

change_frame: Operation = Operation("adjoint", partial(_by, _adjoint), "\\mathrm{{Ad}}_{{{0}}} {1}".format, _change_of_frame_slips)
"""A screw S (6,) in another frame: Ad_T S."""

change_frame_of_rows: Operation = replace(change_frame, latex="{1}\\,\\mathrm{{Ad}}_{{{0}}}^T".format)
"""Screws (n, 6), one in each row, in another frame."""

_advancing: Operation = Operation("velocity", lambda turning, omega, _, h: turning + h * omega, "{0} + {3}\\,{1}".format, table(
    ("no pitch", "leave out ${3}\\,{1}$", lambda turning, *_: turning, "A helical joint also translates along its axis."),
    ("left-handed", "take ${3}\\,{1}$ with the opposite sign", lambda turning, w, _, h: total(turning, negative(h) * w), ADVANCE_ADVICE),
    ("direction of the pitch", "add the pitch ${3}$ to each entry of $v$", lambda turning, _w, _p, h: total(turning, h), ADVANCE_ADVICE),
    ("direction of the pitch", "add ${3}\\,{2}$ instead of ${3}\\,{1}$", lambda turning, _, p, h: total(turning, h * p), ADVANCE_ADVICE),
))
_swap_halves: Operation = Operation("halves swapped", lambda S: np.roll(S, 3, axis=-1), "{0}".format)
_GIVEN_SCREWS = table(
    ("halves swapped", "swap the halves of ${}$ |swap the halves of the screws", lambda S: _swap_halves(S)),
    ("sign of v", "take the moments of ${}$ with the opposite sign |take all moments with the opposite sign",
     lambda S: Operation("moments negated", _moments_negated, "{0}".format)(S), "", ALL_AT_ONCE | MAY_COINCIDE),
)
JOINT_LENGTH: Operation = Operation("joint value", lambda: None, str, partial(unless_unchanged, table(
    *_joint_value_slips("the joint values"),
    ("length in radians", "convert ${}$ from degrees to radians, although it is a length", lambda q: RAD * q),
)))
JOINT_ANGLE: Operation = Operation("joint value", lambda: None, str, partial(unless_unchanged, table(
    *_joint_value_slips("the joint values"), *_joint_value_slips("the angles")[2:]
)))
_by_transposed_adjoint: Operation = Operation("transposed adjoint", lambda T, S: S @ _matrix(_adjoint, T), "{1}".format)
_entry_by_entry: Operation = Operation("entry by entry", lambda T, S: S * _matrix(_adjoint, T).sum(axis=0), "{1}".format)
_once: Operation = Operation("one exponential", lambda *twists: exponential(sum(twists)), lambda *_: "")

screw_axes = partial(given, kind=Operation("given screws", lambda: None, str, _GIVEN_SCREWS))
"""Given screw axes, (6,) or (n, 6)."""
# fmt: on
