"""Linkages in solutions: loop closure, and four-bars and slider-cranks in the plane.

A four-bar has the pin A at the origin, D on the x axis, B at the end of the crank, and C between coupler and rocker.
"""

from collections.abc import Callable, Iterable, Sequence
from itertools import combinations

import numpy as np

from kincourse.expressions.poses import exp, inverse, logarithm
from misstep.mutants.expression import (
    GIVEN,
    MAY_COINCIDE,
    Expression,
    Operation,
    Slip,
    Slips,
    given,
    negative,
    product,
    table,
    total,
)
from misstep.mutants.operations import cos, sin, sqrt, square

CORNER_ADVICE = (
    "In a triangle, the cosine of an angle is $(a^2 + b^2 - c^2) / 2ab$, where $c$ is the side opposite the angle."
)
MODES_ADVICE = "B and D are the same in both modes, and C is mirrored in the line from B to D."
BARS = ("ground", "crank", "coupler", "rocker")


def closing_twist(branch_2: Sequence[Expression], branch_1: Sequence[Expression]) -> Expression:
    """The residual of a loop of two branches, log(T_2 T_1^{-1}), as lecture 08 names them.

    branch_2  the factors of T_2: exponentials of joints, and fixed poses
    branch_1  the factors of T_1: exponentials of joints, which are passed backwards, so their signs are negated
    """
    products = product(*branch_1), product(*branch_2)
    T_1, T_2 = products[0].named("T_1"), products[1].named("T_2")
    back = [exp(S, negative(q)).named(f"e^{{-[{S.latex}]{q.latex}}}") for S, q in (e.arguments for e in branch_1[::-1])]
    T = product(*branch_2, *back).mistaken_for(
        ("another frame", "take $\\log(T_1^{-1}\\,T_2)$, the residual in coordinates of the coupler", inverse(T_1) @ T_2),
        ("sign", "take $\\log(T_1\\,T_2^{-1})$, the negative of the residual", T_1 @ inverse(T_2)),
        ("inverse left out", "take $\\log(T_2\\,T_1)$, without an inverse", T_2 @ T_1),
        ("inverse left out", "take $\\log(T_1\\,T_2)$, without an inverse", T_1 @ T_2),
        ("inverse left out", "leave out both minus signs of the way back", product(*branch_2, *branch_1[::-1])),
        ("way back left out", "leave out the way back, so that only the way there is left", T_2),
        advice=f"Here $T_1 = {products[0].latex}$ and $T_2 = {products[1].latex}$. The residual is $\\log(T_2\\,T_1^{{-1}})$.",
    )  # fmt: skip
    joints = [
        (sign, e.arguments) for sign, branch in ((1, branch_2), (-1, branch_1)) for e in branch if e.operation is exp
    ]
    added = total(*(sign * S * q for sign, (S, q) in joints))
    return logarithm(T).mistaken_for(("one exponential", "add the twists, without the exponentials", added))


def bars(lengths: Sequence[float]) -> list[Expression]:
    """The lengths of a four-bar: ground, crank, coupler, rocker."""
    return [length(name, x) for name, x in zip(BARS, lengths, strict=True)]


def length(name: str, x: float, kind: Operation = GIVEN) -> Expression:
    """A given length, named by a word.

    kind  LENGTH if it may be negative
    """
    return given(f"\\mathrm{{{name}}}", float(x), kind)


def coupler_directions(lengths: Sequence[Expression], A: Expression) -> tuple[Expression, Expression]:
    """The angles of the coupler from the x axis in both assembly modes, at the crank angle A in radians.

    lengths  of ground, crank, coupler, rocker

    In the first mode C lies to the left of the arrow from B to D.
    """
    ground, crank, coupler, rocker = lengths
    return _corners(_on_the_ground(ground).named("p_D") - polar(crank, A).named("p_B"), "BD", coupler, rocker)


def rocker_directions(lengths: Sequence[Expression], A: Expression) -> tuple[Expression, Expression]:
    """The angles of the rocker from the x axis in both assembly modes, as `coupler_directions`."""
    ground, crank, coupler, rocker = lengths
    return _corners(polar(crank, A).named("p_B") - _on_the_ground(ground).named("p_D"), "DB", rocker, coupler)[::-1]


def _corners(line: Expression, ends: str, bar: Expression, other: Expression) -> tuple[Expression, Expression]:
    """The angles of a bar that begins where a line does and meets another one at C, to the left of the line and to its right."""
    line = line.named(ends)
    corner, direction = corner_angle(_distance(line), bar, other).named(f"\\angle {ends[::-1]}C"), direction_of(line)
    return direction + corner, direction - corner


def with_other_bars(
    of: Callable[[Sequence[Expression]], Expression],
    lengths: Sequence[Expression],
    swaps: Iterable[tuple[int, int]] = tuple(combinations(range(4), 2)),
) -> Expression:
    """An expression of the lengths of a four-bar, mistaken for the same one with two bars swapped.

    swaps  the pairs of ground, crank, coupler and rocker that may be swapped
    """
    slips = []
    for i, j in swaps:
        order = list(lengths)
        order[i], order[j] = lengths[j], lengths[i]
        slips.append(("lengths swapped", f"swap the lengths of {BARS[i]} and {BARS[j]}", of(order)))
    return of(lengths).mistaken_for(*slips)


def slider_place(crank: Expression, rod: Expression, offset: Expression, A: Expression) -> Expression:
    """The x coordinate of the slider of a slider-crank, to the right of B, at the crank angle A in radians."""
    height = offset - crank * sin(A)
    along, reach = crank * cos(A), sqrt(square(rod) - square(height))
    x = along + reach
    return x.mistaken_for(
        ("other mode", "take the other assembly mode, with the slider to the left of B", along - reach),
        ("flat rod", "take the rod along $x$, although B and the slider have different heights", along + rod),
    )  # fmt: skip


def _cosine(one: float, two: float, opposite: float) -> float:
    return float((one**2 + two**2 - opposite**2) / (2 * one * two))


def _both_slips(node: Expression) -> Slips:
    for one in node.arguments:
        for name, text, wrong in (
            ("one mode twice", "give one mode twice", one),
            ("mirrored in the ground", "mirror one mode in the ground line to get the other", negative(one)),
            ("supplement", "take $\\pi$ minus the angle of one mode for the other mode", np.pi - one),
            ("half a turn", "add $\\pi$ to the angle of one mode for the other mode", np.pi + one),
        ):
            yield Slip(name, text, both_modes(one, wrong), advice=MODES_ADVICE)


# fmt: off
_CORNERS = table(
    ("another corner", "take the angle opposite ${1}$", lambda one, two, opposite: np.arccos(_cosine(one, opposite, two)), CORNER_ADVICE),
    ("another corner", "take the angle opposite ${0}$", lambda one, two, opposite: np.arccos(_cosine(two, opposite, one)), CORNER_ADVICE),
    ("cosine for angle", "give the cosine instead of the angle", _cosine, CORNER_ADVICE),
    ("factor left out", "leave out the factor 2 of the law of cosines", lambda *sides: np.arccos(2 * _cosine(*sides)), CORNER_ADVICE),
    ("sign", "take the law of cosines with the opposite sign", lambda *sides: np.arccos(-_cosine(*sides)), CORNER_ADVICE),
    ("no right triangle", "treat the triangle as right-angled", lambda one, two, _: np.arctan2(two, one), CORNER_ADVICE),
    of_values=True,
)
_DIRECTIONS = table(
    ("arguments of arctan2", "swap the two arguments of `np.arctan2`", lambda v: np.arctan2(*v)),
    ("arctan for arctan2", "take `np.arctan` of the quotient, which loses the quadrant",
     lambda v: np.arctan(v[1] / v[0]), "", MAY_COINCIDE),
    ("half a turn", "take the opposite direction of ${0}$", lambda v: np.pi + np.arctan2(*v[::-1])),
    of_values=True,
)
_POLAR = table(
    ("sine and cosine swapped", "swap sine and cosine of ${1}$", lambda r, angle: polar(r, np.pi / 2 - angle), "", MAY_COINCIDE),
)

corner_angle: Operation = Operation(
    "corner of a triangle",
    lambda *sides: np.arccos(_cosine(*sides)),
    "\\arccos(({0}^2 + {1}^2 - {2}^2) / (2\\,{0}\\,{1}))".format,
    _CORNERS,
)
"""The angle in radians between two sides of a triangle, by the law of cosines: corner_angle(one, two, opposite)."""

polar: Operation = Operation(
    "polar coordinates",
    lambda r, angle: r * np.array([np.cos(angle), np.sin(angle)]),
    "{0}\\,(\\cos {1}, \\sin {1})".format,
    _POLAR,
)
"""The point (2,) at a distance from the origin in the direction of an angle in radians."""

direction_of: Operation = Operation(
    "direction", lambda v: np.arctan2(v[1], v[0]), "\\angle(x, {0})".format, _DIRECTIONS
)
"""The angle in radians of a vector (2,) from the x axis."""

both_modes: Operation = Operation("both modes", lambda *angles: np.array(angles), "({0}, {1})".format, _both_slips)
"""The angles of both assembly modes of a linkage, (2,)."""

_on_the_ground: Operation = Operation("pin on the ground", lambda x: np.array([x, 0.0]), "({0}, 0)".format)
_distance: Operation = Operation("length", lambda v: np.hypot(*v), "|{0}|".format)
# fmt: on
