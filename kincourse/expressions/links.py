r"""Link transforms in solutions: the matrix of a DH row in either convention, and the product of the matrices of a table."""

from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from kincourse.expressions.poses import inverse
from kinlib.arrays.validation import Array
from kinlib.dh.table import Convention
from kinlib.dh.table import joint_transform as z_motion
from kinlib.dh.table import normal_transform as x_motion
from kinlib.rigid.lie import exp as exponential
from misstep.mutants.expression import Expression, Operation, Slip, Slips, given, negative, product
from misstep.mutants.operations import DEGREES_ADVICE, function

CONVENTION_ADVICE = (
    "A standard row is $R_z(\\theta)\\,T_z(d)\\,T_x(a)\\,R_x(\\alpha)$, joint first; a modified row is "
    "$R_x(\\alpha)\\,T_x(a)\\,R_z(\\theta)\\,T_z(d)$, common normal first."
)
LENGTHS_ADVICE = "$d$ is measured along $z$, the axis of the joint, and $a$ along $x$, the common normal."
ANGLES_ADVICE = (
    "$\\theta$ is measured about $z_{i-1}$, from $x_{i-1}$ to $x_i$; $\\alpha$ about $x_i$, from $z_{i-1}$ to $z_i$."
)
ROW_ADVICE = "Here the order is $a, \\alpha, d, \\theta$."
BACKWARDS = "measure from the second frame to the first, which gives the opposite signs"
BACKWARDS_ADVICE = (
    "A row leads from frame $i-1$ to frame $i$: $d$ is positive along $z_{i-1}$, $a$ along $x_i$, and the angles are positive "
    "about these axes by the right-hand rule."
)
ALPHA_ADVICE = "In a standard table row $i$ holds $\\alpha_i$, in a modified one $\\alpha_{i-1}$."
RADIANS_ADVICE = "Angles are typed in radians: a right angle is `np.pi / 2`."
OFFSET_ADVICE = "In a row with an offset $c$, $\\theta = q + c$: the offset is added to $q$."

Rows = Array | Sequence[Sequence[float]]

Link = Callable[[float, float, float, float], Array]
"""A function from a, alpha, d and theta to a pose (4, 4)."""


def link(row: Array | Sequence[float | Expression], convention: Convention, i: int = 1, label: str = "") -> Expression:
    r"""The link transform of row i: a, alpha, d, theta in metres and radians, as numbers or expressions.

    label  its own name in LaTeX; the numbers of its row then have no index

    >>> link([1, 0, 0, np.pi / 2], "standard").value.round(6)[:3, 3]
    array([0., 1., 0.])
    >>> [slip.name for slip in link([1, 0, 0, np.pi / 2], "standard").slips()][:2]
    ['the other convention', 'a and d swapped']
    """
    k = i - 1 if convention == "modified" else i
    names, kinds = (f"a_{k}", f"\\alpha_{k}", f"d_{i}", f"\\theta_{i}"), (_A, _ALPHA, _D, _THETA)
    if label:
        names = "a", "\\alpha", "d", "\\theta"
    entries = [
        entry if isinstance(entry, Expression) else given(name, float(entry), kind)
        for entry, name, kind in zip(row, names, kinds, strict=True)
    ]
    label = label or (f"A_{i}" if convention == "standard" else f"{{}}^{{{i - 1}}}T_{{{i}}}")
    return _link_operation(convention, label)(*entries)


def joint_variable(joint: str, i: int, q: float, constant: float) -> Expression:
    """The theta of a revolute joint ("R"), or the d of a prismatic one ("P"): its value q and the constant of the table.

    >>> joint_variable("R", 1, 0.5, 0.25).value
    0.75
    """
    variable = given(f"q_{i}", float(q), _Q_ANGLE if joint == "R" else _Q_LENGTH)
    letter = "\\theta" if joint == "R" else "d"
    return _joint_variable(variable, given(f"the constant of ${letter}_{i}$", float(constant)))


def links(
    rows: Rows, joints: str, q: Array | Sequence[float], convention: Convention, first: int = 1
) -> list[Expression]:
    """The link transforms of a table at the joint values q.

    rows    (n, 4): a, alpha, d, theta at q = 0, in metres and radians
    joints  "R" or "P" for each row
    first   the number of the first row

    >>> len(links(np.ones((2, 4)), "RP", [0.1, 0.2], "modified"))
    2
    """
    found = []
    for i, (row, joint, value) in enumerate(zip(rows, joints, q, strict=True), start=first):
        entries, k = list(row), 3 if joint == "R" else 2
        entries[k] = joint_variable(joint, i, value, row[k])
        found.append(link(entries, convention, i))
    return found


def table_product(  # noqa: PLR0917
    rows: Rows,
    joints: str,
    q: Array | Sequence[float],
    convention: Convention,
    before: Iterable[Expression] = (),
    after: Iterable[Expression] = (),
    first: int = 1,
) -> Expression:
    """The product of the link transforms of a table at q, between a base and a tool.

    >>> table_product([[1, 0, 0, 0], [2, 0, 0, 0]], "RR", [0.0, np.pi / 2], "standard").value.round(6)[:3, 3]
    array([1., 2., 0.])
    """
    before, after = list(before), list(after)

    def of(rows: Rows, values: Array | Sequence[float] = q, order: int = 1) -> Expression:
        return product(*before, *links(rows, joints, values, convention, first)[::order], *after)

    T, rows = of(rows), np.asarray(rows, dtype=float)
    if len(rows) > 1:
        for step, lost in ((1, 0), (-1, -1)):
            shifted = rows.copy()
            shifted[:, 1] = np.roll(rows[:, 1], step)
            shifted[lost, 1] = 0.0
            text = f"use each $\\alpha$ one row too {'low' if step == 1 else 'high'}"
            if not np.allclose(shifted, rows):
                T = T.mistaken_for(of(shifted), "alpha one row off", text, ALPHA_ADVICE)
        for i in range(len(rows) - 1):
            swapped = [*q[:i], q[i + 1], q[i], *q[i + 2 :]]
            text = f"swap $q_{first + i}$ and $q_{first + i + 1}$"
            if not np.allclose(of(rows, swapped).value, T.value):
                T = T.mistaken_for(of(rows, swapped), "joint values swapped", text)
        if len(rows) > 2:
            text = "use the joint values in the reverse order"
            T = T.mistaken_for(of(rows, q[::-1]), "joint values reversed", text)
        if before or after:
            T = T.mistaken_for(of(rows, order=-1), "reversed", "multiply the rows from the last one to the first")
    return T.mistaken_for(inverse(T), "inverse", "give the inverse")


def axial_twists(a: float, alpha: float, d: float, theta: float) -> Expression:
    """The twists of a modified row, (2, 6): along x by a and alpha, then along z by d and theta.

    >>> axial_twists(1.0, 2.0, 3.0, 4.0).value
    array([[2., 0., 0., 1., 0., 0.],
           [0., 0., 4., 0., 0., 3.]])
    """
    return _axial_twists(*_typed_entries(a, alpha, d, theta))


def dh_row(a: float, alpha: float, d: float, theta: float) -> Expression:
    """The entries of a row that is read off frames, (4,), in the order a, alpha, d, theta.

    >>> [slip.name for slip in dh_row(3.0, 0.5, 4.0, 0.25).slips()][:2]
    ['a and d swapped', 'angles swapped']
    """
    return _row(*_typed_entries(a, alpha, d, theta))


def _typed_entries(a: float, alpha: float, d: float, theta: float) -> tuple[Expression, ...]:
    """The entries of a row that a student types, and does not use in a formula."""
    angles = given("\\alpha", alpha, _TYPED_ALPHA), given("\\theta", theta, _TYPED_THETA)
    return given("a", a, _A), angles[0], given("d", d, _D), angles[1]


def _row_slips(node: Expression) -> Slips:
    a, alpha, d, theta = node.arguments
    hypotenuse = float(np.hypot(a.value, d.value))
    for name, text, advice, entries in (
        ("a and d swapped", "swap $a$ and $d$", LENGTHS_ADVICE, (d, alpha, a, theta)),
        ("angles swapped", "swap $\\alpha$ and $\\theta$", ANGLES_ADVICE, (a, theta, d, alpha)),
        ("both pairs swapped", "swap $a$ and $d$, and $\\alpha$ and $\\theta$", ANGLES_ADVICE, (d, theta, a, alpha)),
        ("order of the numbers", "give $\\theta, d, a, \\alpha$ in this order", ROW_ADVICE, (theta, d, a, alpha)),
        ("order of the numbers", "give $\\alpha, a, d, \\theta$ in this order", ROW_ADVICE, (alpha, a, d, theta)),
        ("the row backwards", BACKWARDS, BACKWARDS_ADVICE, (-a, -alpha, -d, -theta)),
        ("x in the other direction", "take $x_i$ in the opposite direction", "", (-a, -alpha, d, theta + np.pi)),
        ("off the normal", "take the distance of the origins as $a$", LENGTHS_ADVICE, (hypotenuse, alpha, d, theta)),
        ("off the normal", "take the distance of the origins as $a$, and 0 as $d$", LENGTHS_ADVICE, (hypotenuse, alpha, 0.0, theta)),
    ):  # fmt: skip
        wrong = _row(*entries)
        if np.all(node.value) or not np.allclose(wrong.value, node.value):
            in_parts = name in {
                "a and d swapped",
                "angles swapped",
                "off the normal",
            }  # others show in the whole row only
            yield Slip(name, text, wrong, advice=advice, in_parts=in_parts)


def _twists(w1: Any, v1: Any, w2: Any, v2: Any) -> Array:
    """Two twists in rows; a number is a size along the axis of its row, x and then z."""
    pairs = zip((w1, v1, w2, v2), np.eye(3)[[0, 0, 2, 2]], strict=True)
    return np.concatenate([part * axis if np.ndim(part) == 0 else np.asarray(part) for part, axis in pairs]).reshape(
        2, 6
    )


def _axial_slips(node: Expression) -> Slips:
    for name, text, twists in _WRONG_TWISTS:
        wrong = Operation("wrong twists", twists, lambda *_: "x", _rows_swapped)
        yield Slip(name, text, wrong(*node.arguments))
    yield from _rows_swapped(node)


def _rows_swapped(node: Expression) -> Slips:
    yield Slip("rows swapped", "put the joint first", node[::-1])


def _link_slips(convention: Convention, node: Expression) -> Slips:
    a, alpha, d, theta = node.arguments
    other: Convention = "modified" if convention == "standard" else "standard"
    row, of = node.latex, node.operation
    found: list[Slip] = []

    def add(name: str, text: str, wrong: Expression, everywhere: str = "", advice: str = "") -> None:
        found.append(Slip(name, text, wrong, everywhere=everywhere, advice=advice))

    text, everywhere = f"read ${row}$ in the {other} convention", "multiply the rows in the other convention"
    in_the_other = _link_operation(other, row)(*node.arguments)
    add("the other convention", text, in_the_other, everywhere, CONVENTION_ADVICE)
    everywhere = "swap $a$ and $d$ in every row"
    add("a and d swapped", f"swap $a$ and $d$ in ${row}$", of(d, alpha, a, theta), everywhere, LENGTHS_ADVICE)
    text, everywhere = f"swap $\\alpha$ and $\\theta$ in ${row}$", "swap $\\alpha$ and $\\theta$ in every row"
    add("angles swapped", text, of(a, theta, d, alpha), everywhere)
    text, everywhere = f"leave out $a$ and $\\alpha$ in ${row}$", "leave out every $a$ and $\\alpha$"
    add("only the joint", text, of(0.0, 0.0, d, theta), everywhere)
    add("only the common normal", f"leave out $d$ and $\\theta$ in ${row}$", of(a, alpha, 0.0, 0.0))
    for name, text, in_order in _ORDERS[convention]:
        add(name, f"{text} in ${row}$", function(name, in_order, "A")(*node.arguments), text)
    about_y = function("alpha about y", _LINKS_ABOUT_Y[convention], "A")(*node.arguments)
    add("alpha about y", f"rotate by $\\alpha$ about the $y$ axis in ${row}$", about_y)
    for letter, wrong in (
        ("\\theta", of(a, alpha, d, np.pi / 2 - theta)),
        ("\\alpha", of(a, np.pi / 2 - alpha, d, theta)),
    ):
        add("sine and cosine swapped", f"swap the sine and the cosine of ${letter}$ in ${row}$", wrong)
    if d.operation is _joint_variable:
        variable, constant = d.arguments
        q = f"${variable.latex}$"
        advice = "A prismatic joint changes $d$; its $\\theta$ is a constant."
        text, wrong = f"add {q} to $\\theta$ instead of $d$", of(a, alpha, constant, theta + variable)
        add("prismatic variable in theta", text, wrong, advice=advice)
        text, wrong = f"add {q} to $a$ instead of $d$", of(a + variable, alpha, constant, theta)
        add("prismatic variable in a", text, wrong, advice=LENGTHS_ADVICE)
        text, wrong = f"swap {q} and ${a.latex}$", of(variable, alpha, a + constant, theta)
        add("a and d swapped", text, wrong, advice=LENGTHS_ADVICE)
    if theta.operation is _joint_variable:
        variable, constant = theta.arguments
        text = f"add ${variable.latex}$ to $d$ instead of $\\theta$"
        add("revolute variable in d", text, of(a, alpha, d + variable, constant), "add every joint value to $d$")
    # In a row with zeros many of these change nothing, and are no mistakes there.
    is_full = all(entry.value for entry in node.arguments)
    yield from (one for one in found if is_full or not np.allclose(one.wrong.value, node.value))


def _entry_slips(letter: str, name: str) -> Any:
    def changes(node: Expression) -> Slips:
        if not node.value:
            return
        x = f"${node.latex}$" if "$" not in node.latex else node.latex
        text = f"take {x} with the opposite sign"
        yield Slip(f"sign of {name}", text, negative(node), everywhere=f"take every ${letter}$ with the opposite sign")
        text = f"leave out {x}"
        yield Slip(f"{name} left out", text, 0.0 * node, everywhere=f"leave out every ${letter}$")
        if name in ("alpha", "theta"):
            if node.operation in (_TYPED_ALPHA, _TYPED_THETA):
                in_degrees, both = 180 / np.pi * node, "give the angles in degrees"
                yield Slip("degrees", f"give {x} in degrees", in_degrees, advice=RADIANS_ADVICE)
                yield Slip(
                    "degrees",
                    both,
                    in_degrees,
                    everywhere=both,
                    advice=RADIANS_ADVICE,
                    one_by_one=False,
                    in_parts=False,
                )
            else:
                yield from _degrees_slips(node, x, f"use the degrees of every ${letter}$ as radians")
            text = f"convert {x} to radians twice"
            yield Slip("converted twice", text, np.pi / 180 * node, everywhere="convert to radians twice")
            text = f"take {x} with the opposite sign"
            everywhere = "take every angle with the opposite sign"
            in_parts = node.operation in (_ALPHA, _THETA)  # of typed entries, one part cannot show it
            yield Slip(
                "sign of the angles", text, negative(node), everywhere=everywhere, one_by_one=False, in_parts=in_parts
            )

    return changes


def _degrees_slips(node: Expression, x: str, of_kind: str) -> Slips:
    in_degrees = 180 / np.pi * node
    text = f"use the degrees of {x} as radians"
    yield Slip("degrees", text, in_degrees, everywhere=of_kind, advice=DEGREES_ADVICE)
    yield Slip(
        "degrees", text, in_degrees, everywhere="use degrees as radians", advice=DEGREES_ADVICE, one_by_one=False
    )


def _variable_slips(node: Expression) -> Slips:
    q, constant = node.arguments
    if constant.value:
        yield Slip(
            "no offset", f"leave out {constant.latex}", q, everywhere="leave out the offsets", advice=OFFSET_ADVICE
        )
        text = f"subtract {constant.latex} instead of adding it"
        yield Slip("offset subtracted", text, q - constant, everywhere="subtract the offsets", advice=OFFSET_ADVICE)
        if q.operation is _Q_ANGLE:
            text, all_of_them = (
                f"use the degrees of {constant.latex} as radians",
                "use the degrees of the offsets as radians",
            )
            yield Slip("degrees", text, q + 180 / np.pi * constant, everywhere=all_of_them, advice=DEGREES_ADVICE)


def _joint_value_slips(node: Expression) -> Slips:
    if not node.value:
        return
    q = f"${node.latex}$"
    text = f"take {q} with the opposite sign"
    yield Slip(
        "sign of a joint value", text, negative(node), everywhere="take every joint value with the opposite sign"
    )
    yield Slip("joint at zero", f"leave {q} at 0", 0.0 * node, everywhere="leave every joint at zero")
    if node.operation is _Q_LENGTH:
        text = f"convert {q} from degrees to radians, although it is a length"
        yield Slip("length in radians", text, np.pi / 180 * node)
    for name, text, factor in (
        ("converted twice", "use `np.radians` on {}", np.pi / 180),
        ("degrees", "use {} in degrees", 180 / np.pi),
    ):
        kinds = ["the joint values"] if node.operation is _Q_LENGTH else ["the joint values", "the angles"]
        for several in kinds:
            advice = DEGREES_ADVICE if name == "degrees" else ""
            yield Slip(
                name, text.format(q), factor * node, everywhere=text.format(several), advice=advice, one_by_one=False
            )


@cache
def _link_operation(convention: Convention, label: str) -> Operation:
    return Operation("link transform", _LINKS[convention], lambda *_: label, partial(_link_slips, convention))


_LINKS: dict[str, Link] = {
    "standard": lambda a, alpha, d, theta: z_motion(d, theta) @ x_motion(a, alpha),
    "modified": lambda a, alpha, d, theta: x_motion(a, alpha) @ z_motion(d, theta),
}

_ORDERS: dict[str, list[tuple[str, str, Link]]] = {
    "standard": [
        (
            "rotations first",
            "rotate by $\\theta$ and $\\alpha$ before both translations",
            lambda a, A, d, H: z_motion(0, H) @ x_motion(0, A) @ z_motion(d, 0) @ x_motion(a, 0),
        ),
        (
            "a along the old x",
            "move by $a$ along $x_{i-1}$ instead of $x_i$",
            lambda a, A, d, H: z_motion(d, 0) @ x_motion(a, 0) @ z_motion(0, H) @ x_motion(0, A),
        ),
    ],
    "modified": [
        (
            "rotations first",
            "rotate by $\\alpha$ and $\\theta$ before both translations",
            lambda a, A, d, H: x_motion(0, A) @ z_motion(0, H) @ x_motion(a, 0) @ z_motion(d, 0),
        ),
        (
            "d along the old z",
            "move by $d$ along $z_{i-1}$ instead of $z_i$",
            lambda a, A, d, H: x_motion(a, 0) @ z_motion(d, 0) @ x_motion(0, A) @ z_motion(0, H),
        ),
    ],
}
"""For each convention, other orders of the four factors that are no convention."""


def _about_y(alpha: float) -> Array:
    return exponential(np.array([0, alpha, 0, 0, 0, 0]))


_LINKS_ABOUT_Y: dict[str, Link] = {
    "standard": lambda a, alpha, d, theta: z_motion(d, theta) @ x_motion(a, 0) @ _about_y(alpha),
    "modified": lambda a, alpha, d, theta: _about_y(alpha) @ x_motion(a, 0) @ z_motion(d, theta),
}

_axial_twists = Operation(
    "axial twists", lambda a, alpha, d, theta: _twists(alpha, a, theta, d), lambda *_: "x", _axial_slips
)
_WRONG_TWISTS = (
    ("halves swapped", "write $(v, \\omega)$ in both rows", _twists),
    ("a and d swapped", "swap $a$ and $d$", lambda a, A, d, H: _twists(A, d, H, a)),
    ("angles swapped", "swap $\\alpha$ and $\\theta$", lambda a, A, d, H: _twists(H, a, A, d)),
    ("theta for alpha", "rotate about $x$ by $\\theta$", lambda a, _A, d, H: _twists(H, a, H, d)),
    (
        "axes swapped",
        "swap the axes $x$ and $z$",
        lambda a, A, d, H: _twists([0, 0, A], [0, 0, a], [H, 0, 0], [d, 0, 0]),
    ),
    (
        "lengths along other axes",
        "move by $a$ along $z$ and by $d$ along $x$",
        lambda a, A, d, H: _twists(A, [0, 0, a], H, [d, 0, 0]),
    ),
    ("lengths along other axes", "move along $y$", lambda a, A, d, H: _twists(A, [0, a, 0], H, [0, d, 0])),
    ("unit screws", "give unit screws, for an angle of 1 radian", lambda a, A, d, H: _twists(1, a / A, 1, d / H)),
    ("unit screws", "give unit axes instead of the axis times the angle", lambda a, _A, d, _H: _twists(1, a, 1, d)),
    (
        "pitch for length",
        "divide each length by its angle, as for a pitch",
        lambda a, A, d, H: _twists(A, a / A, H, d / H),
    ),
    ("length times angle", "multiply each length by its angle", lambda a, A, d, H: _twists(A, a * A, H, d * H)),
    ("lengths left out", "leave out both lengths", lambda _a, A, _d, H: _twists(A, 0, H, 0)),
    ("angles left out", "leave out both angles", lambda a, _A, d, _H: _twists(0, a, 0, d)),
    (
        "frame of the second twist",
        "write the second twist in frame $i-1$, where its $z$ is already rotated",
        lambda a, A, d, H: _twists(A, a, H * x_motion(0, A)[:3, 2], d * x_motion(0, A)[:3, 2]),
    ),
)
"""Twists that people take for those of a row, from a, alpha, d and theta."""

_row = Operation(
    "row", lambda *entries: np.array(entries, dtype=float), lambda *_: "(a, \\alpha, d, \\theta)", _row_slips
)
_joint_variable = Operation("joint variable", lambda q, constant: q + constant, lambda q, _: q, _variable_slips)
_A = Operation("a", lambda: None, str, _entry_slips("a", "a"))
_ALPHA = Operation("alpha", lambda: None, str, _entry_slips("\\alpha", "alpha"))
_TYPED_ALPHA = Operation("alpha", lambda: None, str, _entry_slips("\\alpha", "alpha"))
_TYPED_THETA = Operation("theta", lambda: None, str, _entry_slips("\\theta", "theta"))
_D = Operation("d", lambda: None, str, _entry_slips("d", "d"))
_THETA = Operation("theta", lambda: None, str, _entry_slips("\\theta", "theta"))
_Q_ANGLE = Operation("joint value", lambda: None, str, _joint_value_slips)
_Q_LENGTH = Operation("joint value", lambda: None, str, _joint_value_slips)
