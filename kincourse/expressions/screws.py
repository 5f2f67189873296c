"""Screw axes in solutions: axes of joints, the adjoint, and the product of exponentials."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np

from kincourse.expressions.poses import exp, inverse, with_position
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import hat, homogeneous
from misstep.mutants.expression import (
    SUM,
    Expression,
    Operation,
    Slip,
    Slips,
    given,
    multiple,
    negative,
    product,
    total,
)
from misstep.mutants.operations import ANGLE, SLIDE, VECTOR, cross_product, radians, stack

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


def direction(label: str, x: Array) -> Expression:
    """A given direction or axis, (3,).

    >>> [slip.name for slip in direction("d", np.ones(3)).slips()]
    ['sign of a vector']
    """
    return given(label, x, VECTOR)


def screw_axes(label: str, S: Array) -> Expression:
    """Given screw axes, (6,) or (n, 6).

    >>> [slip.name for slip in screw_axes("S", np.eye(6)).slips()]
    ['halves swapped', 'sign of v']
    """
    return given(label, S, _SCREWS)


def joint_values(types: str, typed: Sequence[float] | Array, letter: str = "q") -> list[Expression]:
    """The values of joints: "P" in metres, all others in degrees, which are to be converted.

    >>> [float(round(value.value, 4)) for value in joint_values("RP", [90, 0.5])]
    [1.5708, 0.5]
    """
    return [
        radians(given(f"{letter}_{i}", float(value), ANGLE))
        if kind != "P"
        else given(f"{letter}_{i}", float(value), SLIDE)
        for i, (kind, value) in enumerate(zip(types, typed, strict=True), start=1)
    ]


def values_in_radians(types: str, q: Sequence[float] | Array) -> list[Expression]:
    """The values of joints in radians and metres, as they are needed.

    >>> [slip.name for slip in values_in_radians("P", [0.5])[0].slips()]
    ['sign of a joint value', 'converted twice', 'converted to degrees']
    """
    kinds = {"R": _JOINT_ANGLE, "P": _JOINT_LENGTH}
    return [
        given(f"q_{i}", float(value), kinds[kind])
        for i, (kind, value) in enumerate(zip(types, q, strict=True), start=1)
    ]


def exponentials(screws: Array, values: Sequence[Expression], letters: str = "S") -> list[Expression]:
    """The exponentials of the joints, e^{[S_i] q_i}.

    screws   (n, 6)
    letters  the letter of all screws, or one for each

    >>> exponentials(np.eye(2, 6), joint_values("RR", [10, 20]))[1].latex
    'e^{[S_2]q_2}'
    """
    names = letters if len(letters) == len(screws) else letters * len(screws)
    numbered = enumerate(zip(names, screws, values, strict=True), start=1)
    return [exp(screw_axes(f"{letter}_{i}", S), value) for i, (letter, S, value) in numbered]


def forward_kinematics(before: Sequence[Expression], home: Expression, after: Sequence[Expression] = ()) -> Expression:
    r"""The product of exponentials with the home pose after those of the screws in {s} and before those of the screws in {b}.

    >>> from kincourse.expressions.poses import pose
    >>> forward_kinematics(exponentials(np.eye(2, 6), joint_values("RR", [10, 20])), pose("M", np.eye(4))).latex
    'e^{[S_1]q_1}\\,e^{[S_2]q_2}\\,M'
    """
    n = len(before)
    factors = [*before, *after]
    values = [factor.arguments[1] for factor in factors]

    def with_values(values: Sequence[Expression]) -> Expression:
        changed = [exp(factor.arguments[0], value) for factor, value in zip(factors, values, strict=True)]
        return product(*changed[:n], home, *changed[n:])

    others = [
        (f"use ${other.latex}$, where ${value.latex}$ belongs", [*values[:i], other, *values[i + 1 :]])
        for i, value in enumerate(values)
        for other in values[max(i - 1, 0) : i] + values[i + 1 : i + 2]
    ]
    if len(values) > 1:
        others.append(("take for each joint the value of the next one", [*values[1:], values[0]]))
        others.append(("take for each joint the value of the one before", [values[-1], *values[:-1]]))
        others.append((f"use ${values[0].latex}$ for all joints", [values[0]] * len(values)))
    sides = [list(side) for side in (before, after)]
    added = [[total(*side)] if len(side) > 1 else side for side in sides]
    at_once = [[_once(*(multiple(*e.arguments) for e in side))] if len(side) > 1 else side for side in sides]
    advice = "You can rely on $e^A e^B = e^{A+B}$ only where $AB = BA$, and the joints of an arm seldom commute."
    T = product(*before, home, *after)
    for text, wrong in others:
        T = T.mistaken_for(with_values(wrong), "another joint value", text, may_coincide=True)
    return (
        T.mistaken_for(
            product(*at_once[0], home, *at_once[1]),
            "one exponential",
            "take one exponential of the sum of the twists",
            advice,
        )
        .mistaken_for(product(*added[0], home, *added[1]), "sum for product", "add the exponentials")
        .mistaken_for(
            with_values([negative(value) for value in values]),
            "sign of a joint value",
            "take every joint value with the opposite sign",
        )
        .mistaken_for(with_values(values[::-1]), "joint values reversed", "use the joint values in the reverse order")
        .mistaken_for(
            product(home, *factors, inverse(home)),
            "home and its inverse",
            f"put ${home.latex}$ in front and its inverse at the end",
        )
        .mistaken_for(home, "at home", f"give ${home.latex}$, the pose at home", "The joints have moved since.")
    )


def joint_screws(
    axes: Array, points: Array | Sequence[Expression], pitches: Array, numbers: Sequence[int] = ()
) -> Expression:
    """The screws of joints in rows, (n, 6).

    axes     (n, 3), unit vectors
    points   (n, 3), a point on each axis
    pitches  (n,), 0 for a revolute joint and infinite for a prismatic one
    numbers  the numbers of the joints; by default 1, 2, ...

    >>> joint_screws(np.eye(2, 3), np.ones((2, 3)), np.array([0, np.inf])).value + 0.0
    array([[ 1.,  0.,  0.,  0.,  1., -1.],
           [ 0.,  0.,  0.,  0.,  1.,  0.]])
    """
    numbers = numbers or range(1, len(axes) + 1)
    letters = ["d" if np.isinf(h) else "\\omega" for h in pitches]
    directions = [direction(f"{x}_{i}", axis) for x, i, axis in zip(letters, numbers, axes, strict=True)]

    places = [p if isinstance(p, Expression) else given(f"p_{i}", p) for i, p in zip(numbers, points, strict=True)]

    def rows_with(places: Sequence[Expression]) -> Expression:
        rows = []
        for i, axis, p, h in zip(numbers, directions, places, pitches, strict=True):
            rows.append(
                prismatic(axis, p) if np.isinf(h) else helical(axis, p, given(f"h_{i}", h)) if h else revolute(axis, p)
            )
        return stack(*rows)

    rows = rows_with(places)
    if len(places) > 1:
        for which, order in (("next", [*places[1:], places[0]]), ("previous", [places[-1], *places[:-1]])):
            text = f"combine each axis with the point of the {which} joint"
            rows = rows.mistaken_for(rows_with(order), "another point", text)
    if isinstance(points, np.ndarray):
        for text, wrong in (
            *((f"measure each point from joint {i}", points - p) for i, p in zip(numbers, points, strict=True)),
            ("add up the points, as if each were measured from the one before", points.cumsum(axis=0)),
            ("take the steps from point to point as the points", np.diff(points, axis=0, prepend=0 * points[:1])),
        ):
            other = rows_with([given(f"p_{i}", p) for i, p in zip(numbers, wrong, strict=True)])
            if np.abs(other.value - rows.value).max() > MIN_SHIFT_M:
                advice = "The points are given in {s}, each from its origin."
                rows = rows.mistaken_for(other, "another origin", text, advice)
    return rows.mistaken_for(_swap_halves(rows), "halves swapped", "write $(v, \\omega)$ in every row", ORDER_ADVICE)


def drawn_revolute(omega: Array, p: Array, others: Mapping[str, Array]) -> Expression:
    """The screw of a revolute joint whose axis omega (3,) through p (3,) is read off a drawing with whole coordinates.

    others  the points that people take for p, in words

    >>> S = drawn_revolute(np.array([0, 0, 1.0]), np.array([2.0, 3.0, 1.0]), {"the origin": np.zeros(3)})
    >>> [slip.wrong.value.tolist() for slip in S.arguments[1].arguments[1].slips()][-1]
    [0.0, 0.0, 0.0]
    """
    axis, point = direction("\\omega", omega), given("p", p)
    for sign, text in ((1, ""), (-1, "-")):
        for i, name in enumerate("xyz"):
            if abs(omega[i]) < 0.5:
                axis = axis.mistaken_for(sign * np.eye(3)[i], "another axis", f"take the axis along ${text}{name}$")
    misread = [*_misread(p), *(("another point", f"take {text} as the point", other) for text, other in others.items())]
    for name, text, wrong in misread:
        if np.abs(np.cross(omega, wrong - p)).max() > 0.1:  # another point of the axis is as good
            point = point.mistaken_for(wrong, name, text)
    foot = p - (omega @ p) * omega
    v = moment(axis, point).mistaken_for(
        foot, "point as moment", "take a point of the axis itself as the moment", MOMENT_ADVICE
    )
    return screw(axis, v)


def _misread(p: Array) -> Iterator[tuple[str, str, Array]]:
    """Yield the name, the text and the value of each mistake that people make when they read a point off a drawing."""
    for i, name in enumerate("xyz"):
        unit = np.eye(3)[i]
        yield "sign of a coordinate", f"read the ${name}$ of the point with the opposite sign", p - 2 * p[i] * unit
        yield "coordinate left out", f"take the ${name}$ of the point as 0", p - p[i] * unit
        yield "coordinate read wrong", f"misread the ${name}$ of the point by one metre", p + unit
        yield "coordinate read wrong", f"misread the ${name}$ of the point by one metre", p - unit
    for i, j in combinations(range(3), 2):
        order = np.arange(3)
        order[[i, j]] = j, i
        yield "coordinates swapped", f"swap ${'xyz'[i]}$ and ${'xyz'[j]}$ of the point", p[order]


def _joint_value_slips(node: Expression, which: Sequence[str] = ("the joint values",)) -> Slips:
    q = f"${node.latex}$"
    yield Slip("sign of a joint value", f"take {q} with the opposite sign", negative(node))
    advice = "The joint values are in radians and metres, as the exponential needs them."
    for name, text, factor in (
        ("converted twice", "use `np.radians` on {0}, as if in degrees", np.pi / 180),
        ("converted to degrees", "use `np.degrees` on {0}", 180 / np.pi),
    ):
        for several in which:
            yield Slip(
                name, text.format(q), factor * node, everywhere=text.format(several), advice=advice, one_by_one=False
            )


def _screws_slips(node: Expression) -> Slips:
    text = f"swap the halves of ${node.latex}$"
    yield Slip("halves swapped", text, _swap_halves(node), everywhere="swap the halves of the screws")
    if node.value[..., :3].any():
        text = f"take the moments of ${node.latex}$ with the opposite sign"
        everywhere = "take all moments with the opposite sign"
        yield Slip("sign of v", text, _negate_moments(node), everywhere=everywhere, one_by_one=False)


def _screw_slips(node: Expression) -> Slips:
    omega, v = node.arguments
    text, everywhere = "write $(v, \\omega)$", "write $(v, \\omega)$ for revolute joints"
    yield Slip("halves swapped", text, screw(v, omega), everywhere=everywhere, advice=ORDER_ADVICE)
    yield Slip("revolute as prismatic", "write the screw of a prismatic joint, $(0, \\omega)$", screw(0 * omega, omega))
    yield Slip("sign of omega", "take $\\omega$ with the opposite sign, but not $v$", screw(negative(omega), v))


def _moment_slips(node: Expression) -> Slips:
    omega, p = node.arguments
    for name, text, wrong in (
        ("omega x p", "take the moment as $\\omega \\times p$, without the minus sign", negative(node)),
        ("point as moment", "take the point itself as the moment", p),
        ("point as moment", "take $-p$ as the moment", negative(p)),
        ("no moment", "leave out the moment", 0 * omega),
        ("entry by entry", "multiply $\\omega$ and $p$ entry by entry (`*` instead of `np.cross`)", omega * p),
    ):
        if name != "entry by entry" or np.any(wrong.value):  # where it is zero, it is no moment at all
            yield Slip(name, text, wrong, everywhere=text, advice=MOMENT_ADVICE)
    if abs(node.value[1]) > 1e-9 and np.abs(node.value[[0, 2]]).max() > 1e-9:  # otherwise it is the sign of the moment
        text = "take the middle entry of a cross product with the wrong sign"
        yield Slip("sign in the cross product", text, node * np.array([1, -1, 1]), everywhere=text)


def _tilted_slips(node: Expression) -> Slips:
    upright, toward, angle = node.arguments
    u, t, a = upright.latex, toward.latex, angle.latex
    text = f"swap sine and cosine of ${a}$"
    advice = f"At 0 degrees the axis is ${u}$, so ${u}$ has the cosine."
    yield Slip("sine and cosine swapped", text, tilted(toward, upright, angle), advice=advice)
    advice = "Divide the direction by its length before you take the moment."
    for text, wrong in (
        (f"take ${u} + \\tan {a}\\,{t}$ as the axis, whose length is not 1", upright + _tan(angle) * toward),
        (f"add ${u}$ and ${t}$ without the cosine and the sine of the angle", upright + toward),
    ):
        yield Slip("not a unit vector", text, wrong, advice=advice)
    yield Slip("tilt left out", f"take the axis along ${u}$, without its tilt", upright)
    yield Slip("sign of a vector", f"take ${node.latex}$ with the opposite sign", negative(node))


def _slide_slips(node: Expression) -> Slips:
    d, p = node.arguments
    advice = "A prismatic joint does not rotate: its screw is $(0, d)$."
    for name, text, wrong in (
        ("direction in omega", "put the direction of a prismatic joint into $\\omega$", screw(d, 0 * d)),
        ("prismatic as revolute", "treat a prismatic joint as a revolute one", revolute(d, p)),
        ("moment of a slide", "take the moment of a prismatic joint, which has none", screw(0 * d, moment(d, p))),
        ("point of a slide", "take the point as the $v$ of a prismatic joint", screw(0 * d, p)),
        ("direction twice", "put the direction of a prismatic joint into both halves", screw(d, d)),
        ("slide left out", "leave the screw of a prismatic joint at zero", screw(0 * d, 0 * d)),
    ):
        yield Slip(name, text, wrong, everywhere=text, advice=advice)


def _advancing_slips(node: Expression) -> Slips:
    turning, omega, p, h = node.arguments
    advance = f"{h.latex}\\,{omega.latex}"
    advice = "A helical joint also translates along its axis."
    yield Slip("no pitch", f"leave out ${advance}$", turning, advice=advice)
    advice = f"The body also translates along the axis: add ${advance}$."
    for name, text, wrong in (
        ("left-handed", f"take ${advance}$ with the opposite sign", negative(h) * omega),
        ("direction of the pitch", f"add the pitch ${h.latex}$ to each entry of $v$", h),
        ("direction of the pitch", f"add ${h.latex}\\,{p.latex}$ instead of ${advance}$", h * p),
    ):
        yield Slip(name, text, total(turning, wrong), advice=advice)


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
    yield from _by_other_blocks(T, S, _OTHER_MATRICES)
    yield Slip("frame not changed", f"use ${S.latex}$ as it is given", S)
    yield Slip("halves swapped", "swap the halves of the result", _swap_halves(node), advice=ORDER_ADVICE)
    text = f"multiply {Ad} entry by entry (`*` instead of `@`)"
    yield Slip("entry by entry", text, _entry_by_entry(T, S))
    yield from _by_other_blocks(T, S, _WRONG_ADJOINTS)
    for text, pose in _WRONG_POSES.items() if T.operation is not inverse else ():
        instead = Operation("another pose", pose, "{0}".format)(T)
        yield Slip("position of the inverse", f"{text} ${T.latex}$", change_frame(instead, S), may_coincide=True)


def _by_other_blocks(T: Expression, S: Expression, table: Sequence[tuple[str, str, "Blocks"]]) -> Slips:
    for name, text, blocks in table:
        is_about_brackets = name == "p without brackets"
        advice = ADJOINT_ADVICE if is_about_brackets or "{Ad}" in text else ""
        said = text.replace("{Ad}", f"$\\mathrm{{Ad}}_{{{T.latex}}}$")
        wrong = Operation(name, partial(_by, blocks), "{1}".format)(T, S)
        yield Slip(name, said, wrong, advice=advice, may_coincide=is_about_brackets)


def revolute(omega: Expression, p: Expression) -> Expression:
    """The screw of a revolute joint: (omega, -omega x p)."""
    return screw(omega, moment(omega, p))


def helical(omega: Expression, p: Expression, h: Expression) -> Expression:
    """The screw of a helical joint of pitch h: (omega, -omega x p + h omega)."""
    turning, advice = moment(omega, p), "The pitch is part of $v$: $v = -\\omega \\times p + h\\,\\omega$."
    return (
        screw(omega, _advancing(turning, omega, p, h))
        .mistaken_for(
            screw(h * omega, turning), "pitch in omega", f"multiply $\\omega$ by the pitch ${h.latex}$", advice
        )
        .mistaken_for(
            screw(0 * omega, h * omega), "revolute as prismatic", "leave $\\omega$ and the moment at zero", advice
        )
    )


def _joined(omega: Array, v: Array) -> Array:
    return np.concatenate([omega, v], axis=-1)


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


_OTHER_MATRICES: Sequence[tuple[str, str, Blocks]] = (
    ("position left out", "rotate both halves without the change of origin", lambda R, _: (R, 0, 0, R)),
    (
        "position left out",
        "rotate both halves in the opposite direction, without the change of origin",
        lambda R, _: (R.T, 0, 0, R.T),
    ),
    (
        "rotation left out",
        "change the origin without rotating the axes",
        lambda R, P: (np.eye(3), 0, R.T @ P @ R, np.eye(3)),
    ),
    *(
        ("p without brackets", f"add ${sign}\\omega \\times p$, with the $p$ of the {which} pose, to $R\\,v$", blocks)
        for sign, which, blocks in (
            ("", "given", lambda R, P: (R, 0, -P, R)),
            ("", "inverse", lambda R, P: (R, 0, R.T @ P @ R, R)),
            ("-", "given", lambda R, P: (R, 0, P, R)),
            ("-", "inverse", lambda R, P: (R, 0, -R.T @ P @ R, R)),
        )
    ),
    ("only omega rotated", "rotate $\\omega$ only, with $v$ unchanged", lambda R, _: (R, 0, 0, np.eye(3))),
    ("no moment", "rotate $\\omega$, with $v$ left at zero", lambda R, _: (R, 0, 0, 0)),
)
_WRONG_ADJOINTS: Sequence[tuple[str, str, Blocks]] = (
    (
        "block on the wrong side",
        "put the block $[p]R$ of {Ad} in the upper right corner",
        lambda R, P: (R, P @ R, 0, R),
    ),
    ("sign in the adjoint", "take the block $[p]R$ of {Ad} with the opposite sign", lambda R, P: (R, 0, -P @ R, R)),
    ("order in the adjoint", "write $R[p]$ instead of $[p]R$ in {Ad}", lambda R, P: (R, 0, R @ P, R)),
    ("rotation left out of the block", "write $[p]$ instead of $[p]R$ in {Ad}", lambda R, P: (R, 0, P, R)),
)
"""The matrices that people multiply screws by in place of the adjoint, and how they come about."""

_WRONG_POSES: dict[str, Callable[[Array], Array]] = {
    "use $-p$ and $R^T$ instead of $p$ and $R$ of": lambda T: homogeneous(T[:3, :3].T, -T[:3, 3]),
    "use $R^T p$ instead of the position $p$ of": lambda T: with_position(T, T[:3, :3].T @ T[:3, 3]),
    "use $-R^T p$, the position of the inverse, instead of the position $p$ of": lambda T: with_position(
        T, -T[:3, :3].T @ T[:3, 3]
    ),
}
"""Poses that people put into the adjoint in place of a given one."""

tilted = Operation(
    "tilted axis",
    lambda u, t, angle: np.cos(angle) * u + np.sin(angle) * t,
    "\\cos {2}\\,{0} + \\sin {2}\\,{1}".format,
    _tilted_slips,
    SUM,
)
"""A unit vector that is tilted from a unit vector u towards a perpendicular one t by an angle in radians."""

screw = Operation("screw", _joined, "({0}, {1})".format, _screw_slips)
"""The screw (omega, v)."""

moment = Operation("moment", lambda w, p: -cross_product(w, p), "-{0} \\times {1}".format, _moment_slips)
"""The moment of an axis omega through p: -omega x p."""

prismatic = Operation("prismatic", lambda d, _: _joined(0 * d, d), "(0, {0})".format, _slide_slips)
"""The screw (0, d) of a prismatic joint; the point where it is mounted plays no part, but people use it."""

change_frame = Operation("adjoint", partial(_by, _adjoint), "\\mathrm{{Ad}}_{{{0}}} {1}".format, _change_of_frame_slips)
"""Screws S (6,) or (n, 6) in another frame: Ad_T S."""

_negate_moments = Operation(
    "moments negated",
    lambda S: S * np.where(S[..., :3].any(axis=-1, keepdims=True) & (np.arange(6) >= 3), -1, 1),
    "{0}".format,
)
_tan = Operation("tangent", np.tan, "\\tan {0}".format)
_swap_halves = Operation("halves swapped", lambda S: np.roll(S, 3, axis=-1), "{0}".format)
_by_transposed_adjoint = Operation("transposed adjoint", lambda T, S: S @ _matrix(_adjoint, T), "{1}".format)
_entry_by_entry = Operation("entry by entry", lambda T, S: S * _matrix(_adjoint, T).sum(axis=0), "{1}".format)
_advancing = Operation("velocity", lambda turning, omega, _, h: turning + h * omega, lambda *_: "v", _advancing_slips)
_once = Operation("one exponential", lambda *twists: exponential(sum(twists)), lambda *_: "")
_JOINT_LENGTH = Operation("joint value", lambda: None, str, _joint_value_slips)
_JOINT_ANGLE = Operation(
    "joint value", lambda: None, str, partial(_joint_value_slips, which=("the joint values", "the angles"))
)
_SCREWS = Operation("given screws", lambda: None, str, _screws_slips)
