r"""Link transforms in solutions: the matrix of a DH row in either convention, and the product of the matrices of a table."""

from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from typing import Any

import numpy as np

from kincourse.expressions.poses import inverse
from kincourse.expressions.screws import JOINT_ANGLE, joint_value, unless_unchanged
from kinlib.arrays.validation import Array
from kinlib.dh.slips import OTHER_CONVENTION
from kinlib.dh.table import Convention, dh_transform
from misstep.mutants.expression import (
    ALL_AT_ONCE,
    Expression,
    Operation,
    Slips,
    given,
    negative,
    product,
    table,
)
from misstep.mutants.operations import DEGREES_ADVICE

CONVENTION_ADVICE = (
    "A standard row begins with the joint, a modified one with the common normal.\n"
    "A standard row is $R_z(\\theta)\\,T_z(d)\\,T_x(a)\\,R_x(\\alpha)$; a modified row is "
    "$R_x(\\alpha)\\,T_x(a)\\,R_z(\\theta)\\,T_z(d)$."
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
OFFSET_ADVICE = "In a row with an offset $c$, $\\theta = q + c$: the offset is added to $q$."
RADIANS_ADVICE = "Angles are in radians: a right angle is `np.pi / 2`, and `np.radians` converts degrees."
PRISMATIC_ADVICE = "A prismatic joint changes $d$; its $\\theta$ is a constant."
DEG, RAD = 180 / np.pi, np.pi / 180
IN_THE_WHOLE = {"in_parts": False}
"""The field of a slip that only a whole row shows."""

Rows = Array | Sequence[Sequence[float]]


def link(row: Array | Sequence[float | Expression], convention: Convention, i: int = 1, label: str = "") -> Expression:
    """The link transform of row i: a, alpha, d, theta in metres and radians, as numbers or expressions.

    label  its own name in LaTeX; the numbers of its row then have no index
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
    """The theta of a revolute joint ("R"), or the d of a prismatic one ("P"): its value q and the constant of the table."""
    variable = joint_value(joint, i, q)
    letter = "\\theta" if joint == "R" else "d"
    return _joint_variable(variable, given(f"the constant of ${letter}_{i}$", float(constant)))


def links(
    rows: Rows, joints: str, q: Array | Sequence[float], convention: Convention, first: int = 1
) -> list[Expression]:
    """The link transforms of a table at the joint values q.

    rows    (n, 4): a, alpha, d, theta at q = 0, in metres and radians
    joints  "R" or "P" for each row
    first   the number of the first row
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
    """The product of the link transforms of a table at q, between a base and a tool."""
    before, after, rows = list(before), list(after), np.asarray(rows, dtype=float)

    def of(rows: Rows, values: Array | Sequence[float] = q, order: int = 1) -> Expression:
        return product(*before, *links(rows, joints, values, convention, first)[::order], *after)

    T = of(rows)
    slips: list[tuple[Any, ...]] = [("inverse", "give the inverse", inverse(T))]
    for step, lost in ((1, 0), (-1, -1)) if len(rows) > 1 else ():
        shifted = rows.copy()
        shifted[:, 1] = np.roll(rows[:, 1], step)
        shifted[lost, 1] = 0.0
        text = f"use each $\\alpha$ one row too {'low' if step == 1 else 'high'}"
        slips.append(("alpha one row off", text, of(shifted), ALPHA_ADVICE))
    for i in range(len(rows) - 1):
        text, swapped = f"swap $q_{first + i}$ and $q_{first + i + 1}$", [*q[:i], q[i + 1], q[i], *q[i + 2 :]]
        slips.append(("joint values swapped", text, of(rows, swapped)))
    if len(rows) > 2:
        slips.append(("joint values reversed", "use the joint values in the reverse order", of(rows, q[::-1])))
    if len(rows) > 1 and (before or after):
        slips.append(("reversed", "multiply the rows from the last one to the first", of(rows, order=-1)))
    return T.mistaken_for(*(slip for slip in slips if not np.allclose(slip[2].value, T.value)))


def dh_row(a: float, alpha: float, d: float, theta: float) -> Expression:
    """The entries of a row that is read off frames, (4,), in the order a, alpha, d, theta."""
    return _row(given("a", a, _A), given("\\alpha", alpha, _ALPHA), given("d", d, _D), given("\\theta", theta, _THETA))


def _link_slips(convention: Convention, node: Expression) -> Slips:
    a, _, d, _ = node.arguments
    other = OTHER_CONVENTION[convention]
    of, in_the_other = node.operation, _link_operation(other, node.latex)
    rows: list[tuple[Any, ...]] = [
        ("the other convention", f"read ${{}}$ in the {other} convention |multiply the rows in the other convention",
         lambda *row: in_the_other(*row), CONVENTION_ADVICE),
        ("a and d swapped", "swap $a$ and $d$ in ${}$ |swap $a$ and $d$ in every row", lambda a, A, d, H: of(d, A, a, H), LENGTHS_ADVICE),
        ("angles swapped", "swap $\\alpha$ and $\\theta$ in ${}$ |swap $\\alpha$ and $\\theta$ in every row",
         lambda a, A, d, H: of(a, H, d, A)),
        *([("only the common normal", "leave out $d$ and $\\theta$ in ${}$", lambda a, A, _d, _H: of(a, A, 0.0, 0.0))] if d.value else []),
    ]  # fmt: skip
    if d.operation is _joint_variable:
        (q, constant), letter = d.arguments, f"${d.arguments[0].latex}$"
        rows += [
            ("prismatic variable in theta", f"add {letter} to $\\theta$ instead of $d$",
             lambda a, A, _d, H: of(a, A, constant, H + q), PRISMATIC_ADVICE),
            ("prismatic variable in a", f"add {letter} to $a$ instead of $d$",
             lambda a, A, _d, H: of(a + q, A, constant, H), LENGTHS_ADVICE),
            ("a and d swapped", f"swap {letter} and ${a.latex}$", lambda a, A, _d, H: of(q, A, a + constant, H), LENGTHS_ADVICE),
        ]  # fmt: skip
    yield from unless_unchanged(table(*rows), node)


def _entry_slips(letter: str, name: str) -> Callable[[Expression], Slips]:
    """The slips in an entry of a row."""
    sign, in_radians = "take ${}$ with the opposite sign", "use the degrees of ${}$ as radians"
    rows: list[tuple[Any, ...]] = [
        (f"sign of {name}", f"{sign} |take every ${letter}$ with the opposite sign", lambda x: negative(x)),
        (f"{name} left out", f"leave out ${{}}$ |leave out every ${letter}$", lambda x: 0.0 * x),
    ]
    if name in ("alpha", "theta"):
        rows += [
            ("degrees", f"{in_radians} |use the degrees of every ${letter}$ as radians", lambda x: DEG * x, RADIANS_ADVICE),
            ("degrees", f"{in_radians} |use degrees as radians", lambda x: DEG * x, RADIANS_ADVICE, ALL_AT_ONCE),
            ("converted twice", "convert ${}$ to radians twice |convert to radians twice", lambda x: RAD * x),
            ("sign of the angles", f"{sign} |take every angle with the opposite sign", lambda x: negative(x), "", ALL_AT_ONCE),
        ]  # fmt: skip
    return partial(unless_unchanged, table(*rows))


def _variable_slips(node: Expression) -> Slips:
    q, constant = node.arguments
    if constant.value:
        yield from _OFFSETS(node)
        if q.operation is JOINT_ANGLE:
            yield from _OFFSET_IN_DEGREES(node)


@cache
def _link_operation(convention: Convention, label: str) -> Operation:
    return Operation("link transform", _LINKS[convention], lambda *_: label, partial(_link_slips, convention))


# fmt: off
_LINKS = {
    "standard": partial(dh_transform, convention="standard"),
    "modified": partial(dh_transform, convention="modified"),
}

_ROWS = table(
    ("a and d swapped", "swap $a$ and $d$", lambda a, A, d, H: [d, A, a, H], LENGTHS_ADVICE),
    ("angles swapped", "swap $\\alpha$ and $\\theta$", lambda a, A, d, H: [a, H, d, A], ANGLES_ADVICE),
    ("order of the numbers", "give $\\theta, d, a, \\alpha$ in this order", lambda a, A, d, H: [H, d, a, A], ROW_ADVICE, IN_THE_WHOLE),
    ("the row backwards", BACKWARDS, lambda a, A, d, H: [-a, -A, -d, -H], BACKWARDS_ADVICE, IN_THE_WHOLE),
    ("x in the other direction", "take $x_i$ in the opposite direction", lambda a, A, d, H: [-a, -A, d, H + np.pi], "", IN_THE_WHOLE),
    ("off the normal", "take the distance of the origins as $a$", lambda a, A, d, H: [np.hypot(a, d), A, d, H], LENGTHS_ADVICE),
    of_values=True,
)
_OFFSETS = table(
    ("no offset", "leave out {1} |leave out the offsets", lambda q, _: q, OFFSET_ADVICE),
    ("offset subtracted", "subtract {1} instead of adding it |subtract the offsets", lambda q, c: q - c, OFFSET_ADVICE),
)
_OFFSET_IN_DEGREES = table(
    ("degrees", "use the degrees of {1} as radians |use the degrees of the offsets as radians", lambda q, c: q + DEG * c, DEGREES_ADVICE),
)

_row: Operation = Operation(
    "row", lambda *entries: np.array(entries, dtype=float), lambda *_: "(a, \\alpha, d, \\theta)", partial(unless_unchanged, _ROWS)
)
_joint_variable: Operation = Operation("joint variable", lambda q, constant: q + constant, lambda q, _: q, _variable_slips)
_A: Operation = Operation("a", lambda: None, str, _entry_slips("a", "a"))
_ALPHA: Operation = Operation("alpha", lambda: None, str, _entry_slips("\\alpha", "alpha"))
_D: Operation = Operation("d", lambda: None, str, _entry_slips("d", "d"))
_THETA: Operation = Operation("theta", lambda: None, str, _entry_slips("\\theta", "theta"))
# fmt: on
