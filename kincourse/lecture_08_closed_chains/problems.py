"""Sheet 08: loop closure, assembly modes, Grashof's condition, dead points, and the mobility by formula, rank and motion."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from operator import sub

import numpy as np

from kincourse.answers.screws import TwistAnswer
from kincourse.expressions.planar import (
    bars,
    both_modes,
    closing_twist,
    corner_angle,
    coupler_directions,
    direction_of,
    kutzbach,
    length,
    polar,
    rocker_directions,
    rotated,
    slider_place,
    with_other_bars,
)
from kincourse.expressions.poses import exp, point, pose
from kincourse.expressions.screws import screw_axes
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.four_bar_geometry import FourBar
from kincourse.sampling.linkages import (
    PLANAR_LEGS,
    SPATIAL_LEGS,
    crank_rocker,
    four_bar_of_kind,
    limited_crank,
    overconstrained_case,
)
from kinlib.arrays.validation import Array
from kinlib.mechanisms import linkages
from kinlib.rigid.angles import wrap_angle
from kinlib.view.figures.linkage import draw_linkage
from misstep.answers.angle import Angles
from misstep.answers.base import Named
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import number, vector
from misstep.mistakes import mistake
from misstep.mutants.expression import Expression, given
from misstep.mutants.operations import ANGLE, LENGTH, radians
from misstep.problem import Problem
from misstep.sheet import Sheet

ANGLES_NOTE = (
    "$A$ and $D$ are the angles of crank and rocker from the $x$ axis, $B$ is the angle of the coupler from the crank, and $C$ "
    "the angle of the coupler from the rocker."
)

CHECK_TOLERANCE = 0.005
"""How far a length in metres may be off that a student computes from an answer with three decimals."""

ANTICLOCKWISE = "Angles are positive anticlockwise."
MIRRORED = (
    f"This belongs to the mirror image in the ground line, whose crank points below the $x$ axis. {ANTICLOCKWISE}"
)


def describe_lengths(four_bar: FourBar) -> str:
    """State the lengths in a sentence."""
    ground, crank, coupler, rocker = (number(length) for length in four_bar)
    return f"A four-bar linkage has a ground of {ground} m, a crank of {crank} m, a coupler of {coupler} m and a rocker of {rocker} m."


def open_configuration(A: float) -> Array:
    """A configuration for drawings that must not show where C is: the coupler along x, the rocker upright."""
    return np.array([A, -A, np.pi / 2, 0.0])


@problem(
    "08.1",
    "The residual of an open loop",
    points=3,
    lecture="08_closed_chains#Loop closure",
    further="How large may the residual be if the lengths are measured to a millimetre?",
)
def residual(sampler: ArmSampler) -> Problem:
    four_bar = crank_rocker(sampler)
    linkage = linkages.four_bar(*four_bar)
    degrees = np.array(
        [sampler.degrees(20, 80), sampler.degrees(-60, -20), sampler.degrees(85, 130), sampler.degrees(-75, -25)]
    )
    S = {joint.name: joint.screws[0] for joint in linkage.joints}
    G = linkage.joints[3].closing_offset
    q = {name: radians(given(name, float(angle), ANGLE)) for name, angle in zip("ABDC", degrees, strict=True)}
    for name, first, bar in (("B", "A", "crank"), ("C", "D", "rocker")):
        for text, wrong in (
            (f"add ${first}$ to ${name}$, as if it had to be measured from the $x$ axis", q[name] + q[first]),
            (f"subtract ${first}$ from ${name}$, as if it were measured from the $x$ axis", q[name] - q[first]),
        ):
            advice = f"${name}$ is measured from the {bar}, as a joint value is: relative to the body before."
            q[name] = q[name].mistaken_for(("relative angle", text, wrong, advice))
    A, B, D, C = (exp(screw_axes(f"S_{name}", S[name]), q[name]) for name in "ABDC")
    r = closing_twist([D, C, pose("G", G)], [A, B])
    listed = ", ".join(f"${name} = {angle}°$" for name, angle in zip("ABDC", degrees, strict=True))
    return Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} The loop is not closed yet: {listed}. Go round the loop "
        "from the ground over D and C to the coupler, and back over B and A. What is the residual, the twist "
        "$r = \\log(e^{[S_D]D}\\, e^{[S_C]C}\\, G\\, e^{-[S_B]B}\\, e^{-[S_A]A})$?",
        figure=partial(draw_linkage, linkage, np.radians(degrees)),
        given={"S": S, "G": G, "degrees": dict(zip("ABDC", degrees.tolist(), strict=True))},
        answer=TwistAnswer(r.value, scale=1),
        solution=r,
        invisible=["rotation transposed"],  # G is a translation
        advice={
            "inverse left out": "On the way back the joints B and A are passed backwards, so their factors are inverted.",
            "order": "The loop goes over D, C and $G$ to the coupler, and back over B and then A.",
            "leave out $G$": "In the drawing at $q = 0$ the loop is open, and $G$ is the pose that closes it.",
        },
    )


@problem(
    "08.2",
    "Both assembly modes",
    points=3,
    lecture="08_closed_chains#The smallest loop",
    further="At which crank angle do both modes meet?",
)
def both_ways(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    A = radians(given("A", degrees, ANGLE))
    D = with_other_bars(lambda four: both_modes(*rocker_directions(four, A)), bars(four_bar))
    coupler, rocker = coupler_directions(bars(four_bar), A), D.arguments
    line = direction_of(np.array([four_bar.ground, 0.0]) - polar(given("a", four_bar.crank), A))
    pins = [polar(given("d", four_bar.rocker), q) + np.array([four_bar.ground, 0.0]) for q in rocker]
    at_D, at_B = rocker[1] - line - np.pi, coupler[0] - line
    for name, text, angles in (
        ("coupler's angles", "give the coupler's angles from the $x$ axis", coupler),
        ("coupler's angles", "give the coupler's angles from the crank", tuple(k - A for k in coupler)),
        ("coupler's angles", "give the coupler's angles from the rocker", tuple(map(sub, coupler, rocker))),
        ("coupler's angles", "give the coupler's angles in degrees", tuple(180 / np.pi * k for k in coupler)),
        ("crank's angle", "give the crank's angle and its negative", (A, -A)),
        ("angles at A", "give the angles of C as seen from A", tuple(map(direction_of, pins))),
        ("angles from the crank", "measure the rocker's angle from the crank", tuple(q - A for q in rocker)),
        ("angles from BD", "give the angles from the line BD instead of the $x$ axis", tuple(q - line for q in rocker)),
        ("angles from DB", "give the angles from the line DB instead of the $x$ axis", (-at_D, at_D)),
        ("coupler's angles", "give the coupler's angles from the line BD", (at_B, -at_B)),
        ("inner angles", "give the inner angles at D in degrees", tuple(180 - 180 / np.pi * q for q in rocker)),
    ):
        D = D.mistaken_for(
            (name, text, both_modes(*angles), "The rocker's angle is measured from the $x$ axis, in radians.")
        )
    return Problem(
        statement=f"{describe_lengths(four_bar)} The angle of its crank from the $x$ axis is {degrees} degrees. Give "
        "the rocker's angle $D$, also from the $x$ axis but in radians, in both assembly modes, in any order. (The picture shows "
        "the linkage before the pin C is put in.)",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), open_configuration(np.radians(degrees))),
        given={"bars": tuple(four_bar), "degrees": degrees},
        answer=Angles(D.value, any_order=True, test=partial(_coupler_at, four_bar, np.radians(degrees))),
        solution=D,
        advice={
            "lengths swapped": "C lies on a circle about B, whose radius is the coupler, and on one about D, whose radius is the rocker.",
            "sign of an angle": MIRRORED,
            "sine and cosine swapped": "At 0 degrees the crank lies along $x$.",
        },
    )


def _coupler_at(four_bar: FourBar, A: float, D: float) -> str:
    """Say how long the coupler would have to be at an angle of the rocker, if it is not as long as that."""
    B = four_bar.crank * np.array([np.cos(A), np.sin(A)])
    C = four_bar.rocker * np.array([np.cos(D), np.sin(D)]) + [four_bar.ground, 0.0]
    return _bar("With this angle, the coupler would have to be", float(np.linalg.norm(C - B)), four_bar.coupler)


def _bar(begin: str, length: float, right: float) -> str:
    return f"{begin} {length:.3g} m long." if abs(length - right) > CHECK_TOLERANCE else ""


@problem(
    "08.3",
    "A point of the coupler",
    points=3,
    lecture="08_closed_chains#The smallest loop",
    further="Where is P in the other assembly mode?",
)
def coupler_point(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    along, left = sampler.length(0.1, 0.25), sampler.length(0.1, 0.25)
    linkage, lengths = linkages.four_bar(*four_bar), bars(four_bar)
    A = radians(given("A", degrees, ANGLE))

    def coupler(mode: int) -> Expression:
        k = with_other_bars(lambda four: coupler_directions(four, A)[mode], lengths)
        for text, wrong in (
            ("rotate by $B$, the coupler's angle from the crank, alone", k - A),
            ("rotate by the crank's angle", A),
            ("rotate by the crank's angle twice", k + A),
            ("rotate by the rocker's angle", rocker_directions(lengths, A)[mode]),
        ):
            k = k.mistaken_for(("another angle", text, wrong, "From the $x$ axis the coupler's angle is $A + B$."))
        return k

    angle = coupler(0).mistaken_for(
        ("other mode", "take the other assembly mode, with C to the right of the arrow from B to D", coupler(1))
    )
    p = point("p", np.array([along, left]))
    for text, wrong in (
        ("measure $p$ from C, towards B", (four_bar.coupler - along, left)),
        ("measure $p$ from C, away from B", (four_bar.coupler + along, left)),
        ("take $p$ along the coupler only", (along, 0.0)),
        ("take $p$ across the coupler only", (0.0, left)),
        ("give C instead of P", (four_bar.coupler, 0.0)),
    ):
        p = p.mistaken_for(
            ("another point", text, np.array(wrong), "P's distance along the coupler is measured from B.")
        )
    start = polar(lengths[1], A).named("B")
    start = start.mistaken_for(
        ("from D", "add $p$ to the position of D instead of B", np.array([four_bar.ground, 0.0]))
    )
    in_degrees = np.radians(degrees) * 180 / np.pi
    P = start + rotated(angle, p)
    P = P.mistaken_for(
        ("mirror image", "give the mirror image of P in the ground line", P * np.array([1.0, -1.0]), MIRRORED)
    )
    P = P.mistaken_for(("from D", "measure P from D instead of A", P - np.array([four_bar.ground, 0.0])))
    wrong_B = four_bar.crank * np.array([np.cos(in_degrees), np.sin(in_degrees)])
    C = start.value + four_bar.coupler * np.array([np.cos(angle.value), np.sin(angle.value)])
    for text, k in (
        ("", 180 / np.pi * angle),
        (" for the crank's angle in the position of B", angle),
        (" for the position of B, and point from there to C", direction_of(given("BC", C - wrong_B))),
    ):
        P = P.mistaken_for(("degrees", f"use degrees as radians{text}", wrong_B + rotated(k, p)))
    drawn = {"P": ("coupler", (four_bar.crank + along, left, 0.0))}

    def distance_from_B(P: Array) -> str:
        distance, right = float(np.linalg.norm(P - start.value)), float(np.hypot(along, left))
        text = f"Your P is {distance:.3g} m from B; the two given distances along and across the coupler make it {right:.3g} m."
        return text if abs(distance - right) > CHECK_TOLERANCE else ""

    return Problem(
        statement=f"{describe_lengths(four_bar)} The angle of its crank is {degrees} degrees, and C lies to the left of the "
        f"arrow from B to D. A point P of the coupler lies {number(along)} m from B along the coupler, towards C, and {number(left)} m "
        "to the left of the coupler. Call these two distances $p$. What is the position of P, as $[x, y]$ from A?",
        figure=partial(draw_linkage, linkage, four_bar.assembly_modes(np.radians(degrees))[0], points=drawn),
        given={"bars": tuple(four_bar), "degrees": degrees, "along": along, "left": left},
        answer=Numbers(P.value, unit="m", test=distance_from_B),
        solution=P,
        advice={
            "take the $y$ of $p$ with the opposite sign": "P lies to the left of the arrow from B to C.",
            "sine and cosine swapped": "At 0 degrees a bar lies along $x$.",
        },
    )


@problem(
    "08.4",
    "A slider-crank with an offset",
    points=2,
    lecture="08_closed_chains#A worked example",
    further="At which crank angle is the slider farthest away?",
)
def slider(sampler: ArmSampler) -> Problem:
    crank, rod, offset = (
        sampler.length(0.2, 0.35),
        sampler.length(0.6, 0.8),
        sampler.choice((-1, 1)) * sampler.length(0.1, 0.2),
    )
    degrees = sampler.choice((sampler.degrees(20, 70), sampler.degrees(110, 160)))  # near 90 the crank has no part in x
    x = slider_place(
        length("crank", crank),
        length("rod", rod),
        length("offset", offset, LENGTH),
        radians(given("A", degrees, ANGLE)),
    )
    swapped = rod * np.cos(np.radians(degrees)) + np.sqrt(
        abs(crank**2 - (rod * np.sin(np.radians(degrees)) - offset) ** 2)
    )
    x = x.mistaken_for(
        ("lengths swapped", "swap crank and rod, and take the root of the size of a negative number", swapped)
    )
    for text, wrong in (
        ("measure $x$ from the leftmost place of B", x + crank),
        ("measure $x$ from B", x - crank * np.cos(np.radians(degrees))),
    ):
        x = x.mistaken_for(("another origin", text, wrong, "$x$ is measured from A."))
    linkage = linkages.slider_crank(crank, rod, offset)
    side = "above" if offset > 0 else "below"
    mirrored = float(
        np.sqrt(rod**2 - (-offset - crank * np.sin(np.radians(degrees))) ** 2) + crank * np.cos(np.radians(degrees))
    )
    other_side = "below" if offset > 0 else "above"
    text = f"place the line of the slider {other_side} A"
    x = x.mistaken_for(
        ("sign of a length", text, mirrored, f"Here the slider moves {side} A: its offset is {number(offset)} m.")
    )
    A = np.radians(degrees)

    def rod_to(x: Array) -> str:
        needed = float(np.hypot(x - crank * np.cos(A), offset - crank * np.sin(A)))
        return _bar("With this $x$, the rod would have to be", needed, rod)

    return Problem(
        statement=f"A slider-crank has a crank of {number(crank)} m and a rod of {number(rod)} m. Its slider moves parallel to "
        f"$x$, {number(abs(offset))} m {side} A. The angle of the crank from the $x$ axis is {degrees} degrees. What is the $x$ coordinate "
        "of the slider, from A, in the assembly mode with the slider to the right of B? (The picture shows the linkage before the pin C "
        "is put in.)",
        figure=partial(draw_linkage, linkage, np.array([A, -A, 1.1 * (crank + rod), 0.0])),
        given={"crank": crank, "rod": rod, "offset": offset, "degrees": degrees},
        answer=Numbers(np.array(x.value), unit="m", test=rod_to),
        solution=x,
        advice={
            "sign of an angle": f"This is right for the mirror image, with the crank below the $x$ axis. {ANTICLOCKWISE}",
            "sign of a length": f"This is right for the mirror image. Here the slider moves {side} A.",
            "leave out $\\mathrm{offset}$": "The line of the slider does not pass through A.",
            "sine and cosine swapped": "At 0 degrees the crank lies along $x$.",
        },
    )


@problem(
    "08.5",
    "Which configuration is drawn?",
    points=2,
    lecture="08_closed_chains#The smallest loop",
    further="Which single measurement tells the two modes apart?",
)
def which_mode(sampler: ArmSampler) -> Problem:
    four_bar, degrees, drawn, named = _distinct_modes(sampler)
    q = four_bar.assembly_modes(np.radians(degrees))[drawn]
    letters = dict(zip("abcd", sampler.shuffled(list(named)), strict=True))
    listed = {letter: np.degrees(wrap_angle(named[name])).round(1) for letter, name in letters.items()}
    shown = "\n".join(f"- {letter}) $D = {number(D)}°$, $C = {number(C)}°$" for letter, (D, C) in listed.items())
    why = {
        "other mode": "These values close the loop too, but in the other assembly mode. Check on which side of the line BD the pin C lies.",
        "inner angle": "This $D$ is the inner angle of the quadrilateral. The rocker's angle is measured from the direction of $x$.",
        "sign of C": "$D$ is right, but $C$ has the wrong sign. It is the angle from the rocker to the coupler, positive anticlockwise.",
    }
    A = np.radians(degrees)
    C = four_bar.pin_positions(A)[2][drawn]
    problem = Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} It is assembled with the crank at {degrees} degrees, and "
        f"then C is at ${vector(C.round(2))}$, measured to a centimetre. Which joint values belong to this "
        f"configuration?\n\n{shown}\n\nAnswer with a letter and the position of B, such as `('a', [0.3, 0.2])`.",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), q),
        given={
            "bars": tuple(four_bar),
            "C": C.round(2),
            "options": {letter: values.tolist() for letter, values in listed.items()},
        },
        answer=Choice(
            next(letter for letter, name in letters.items() if name == "right"), dict.fromkeys("abcd", "joint values")
        ),
        mistakes=[mistake(name, letter, why[name]) for letter, name in letters.items() if name != "right"],
    )
    return problem.with_reason(Numbers(four_bar.crank * np.array([np.cos(A), np.sin(A)]), unit="m"))


def _distinct_modes(sampler: ArmSampler) -> tuple[FourBar, int, int, dict[str, Array]]:
    """Draw a four-bar, its crank angle in degrees, a mode, and four pairs (D, C) that differ by more than a reading error."""
    while True:
        four_bar, degrees, drawn = crank_rocker(sampler), sampler.degrees(25, 155), sampler.integer(0, 1)
        q, other = four_bar.assembly_modes(np.radians(degrees))[[drawn, 1 - drawn]]
        named = {
            "right": np.array([q[2], q[3]]),
            "other mode": np.array([other[2], other[3]]),
            "inner angle": np.array([np.pi - q[2], q[3]]),
            "sign of C": np.array([q[2], -q[3]]),
        }
        pairs = np.array(list(named.values()))
        apart = np.abs(wrap_angle(pairs[:, None] - pairs[None])).max(axis=-1) + 2 * np.eye(4)
        if apart.min() > 0.2:
            return four_bar, degrees, drawn, named


KINDS = {
    "a": "crank-rocker: the crank makes full turns, and the rocker swings",
    "b": "double crank: crank and rocker both make full turns",
    "c": "Grashof double rocker: crank and rocker swing, and the coupler makes full turns",
    "d": "non-Grashof: no bar makes full turns relative to another",
    "e": "change point: all four bars can lie on one line",
}


@problem(
    "08.6",
    "What kind of four-bar is it?",
    points=2,
    lecture="08_closed_chains#Grashof's condition",
    further="Change one length by as little as possible to get another kind of four-bar.",
)
def which_kind(sampler: ArmSampler) -> Problem:
    right = sampler.choice(list(KINDS))
    four_bar = four_bar_of_kind(sampler, right)
    listed = "\n".join(f"- {letter}) {kind}" for letter, kind in KINDS.items())
    problem = Problem(
        statement=f"{describe_lengths(four_bar)} What kind of four-bar is it?\n\n{listed}\n\nAnswer with a letter, and with the sum of "
        "the shortest and the longest bar in metres, such as `('a', 0.7)`.",
        given={"bars": tuple(four_bar)},
        answer=Choice(right, KINDS),
        mistakes=[mistake(f"kind {wrong}", wrong, _kind_message(wrong, right)) for wrong in KINDS if wrong != right],
    )
    return problem.with_reason(Numbers(np.array(min(four_bar) + max(four_bar)), unit="m"))


def _kind_message(wrong: str, right: str) -> str:
    if right == "e":
        return "Shortest plus longest is equal to the sum of the other two, so this is the limit of Grashof's condition, a change point."
    if right == "d":
        return "Shortest plus longest is more than the sum of the other two, so no bar makes full turns."
    if wrong == "d":
        return "Shortest plus longest is less than the sum of the other two, so the shortest bar makes full turns."
    if wrong == "e":
        return "At a change point, shortest plus longest is equal to the sum of the other two."
    shortest = {"a": "the crank", "b": "the ground", "c": "the coupler"}[right]
    return f"Grashof's condition holds, so the shortest bar makes full turns relative to all others. Here it is {shortest}."


@problem(
    "08.7",
    "The range of a crank",
    points=3,
    lecture="08_closed_chains#The configuration-space curve",
    further="What changes if the longest bar is the ground?",
)
def dead_point(sampler: ArmSampler) -> Problem:
    four_bar = limited_crank(sampler)
    lengths = ground, crank, coupler, rocker = bars(four_bar)

    def stretched(four: Sequence[Expression]) -> Expression:
        reach = (four[2] + four[3]).mistaken_for(
            ("folded", "take the difference of coupler and rocker, as if they were folded", four[2] - four[3])
        )
        return corner_angle(four[0], four[1], reach)

    A = with_other_bars(stretched, lengths, [(0, 2), (0, 3), (1, 2), (1, 3)])
    A = A.mistaken_for(
        ("mirror image", "give the least angle instead of the greatest", -A),
        ("another bar", "stretch crank and coupler into one line", corner_angle(ground, crank + coupler, rocker)),
        (
            "another corner",
            "give the angle at D in degrees",
            180 / np.pi * corner_angle(ground, coupler + rocker, crank),
        ),
        ("supplement", "give the supplement in degrees", 180 - 180 / np.pi * A),
        (
            "another corner",
            "give the supplement of the angle at D",
            np.pi - corner_angle(ground, coupler + rocker, crank),
        ),
        (
            "another corner",
            "give the supplement of the angle at B",
            np.pi - corner_angle(crank, coupler + rocker, ground),
        ),
        (
            "square of the sum",
            "add the squares of coupler and rocker instead of squaring their sum",
            corner_angle(ground, crank, float(np.hypot(four_bar.coupler, four_bar.rocker))),
        ),
        ("full turn", "assume that the crank makes full turns", np.pi),
    )

    def reach(A: Array) -> str:
        distance = float(np.linalg.norm(four_bar.crank * np.array([np.cos(A), np.sin(A)]) - [four_bar.ground, 0.0]))
        together = four_bar.coupler + four_bar.rocker
        text = f"At this angle B is {distance:.3g} m from D, and coupler and rocker together are {together:.3g} m long."
        return text if abs(distance - together) > CHECK_TOLERANCE else ""

    advice = "At the dead point of the crank, coupler and rocker lie on one line and together reach from B to D."
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank cannot make full turns. What is the greatest angle $A$ "
        "from the $x$ axis, between $-\\pi$ and $\\pi$ and in radians, at which the loop still closes?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), four_bar.assembly_modes(0.6 * A.value)[0]),
        given={"bars": tuple(four_bar)},
        answer=Angles(np.array(A.value), test=reach),
        solution=A,
        advice={
            "mirror image": "The least angle belongs to the mirror image, with the crank below the ground line.",
            "another corner": "The crank's angle is the angle at A, opposite the stretched bars.",
            **dict.fromkeys(("folded", "another bar", "term left out", "lengths swapped"), advice),
        },
    )


DEGREES_OF_FREEDOM_NOTE = (
    "Revolute and prismatic joints have one degree of freedom, universal joints two, and spherical joints three."
)


@problem(
    "08.8",
    "Mobility by counting",
    points=3,
    lecture="08_closed_chains#The Gruebler-Kutzbach formula",
    further="Add a leg with six degrees of freedom. What happens to the mobility, and why?",
)
def counting(sampler: ArmSampler) -> Problem:
    d, kinds = sampler.choice([(3, PLANAR_LEGS), (6, SPATIAL_LEGS), (6, SPATIAL_LEGS)])
    one, other = sampler.shuffled(kinds)[:2]
    legs = [one] * sampler.integer(1, 3) + [other] * sampler.integer(1, 3)
    f = [f_i for leg in legs for f_i in leg.degrees_of_freedom]
    place = "in the plane" if d == 3 else "in space"
    right = kutzbach(d, [leg.degrees_of_freedom for leg in legs])
    counts = [(legs.count(leg), leg.description) for leg in (one, other)]
    listed = " and ".join(f"{k} of them {'has' if k == 1 else 'have'} {joints}" for k, joints in counts)
    return Problem(
        statement=f"A platform moves {place}. It is connected to the ground by {len(legs)} legs: {listed}. The joints are listed from the "
        f"ground to the platform, and between two neighbouring joints of a leg there is one body. {DEGREES_OF_FREEDOM_NOTE} "
        "Which mobility does the Gruebler-Kutzbach formula give? Here $N$ is the number of bodies, $J$ that of the joints, and "
        "$f$ the degrees of freedom of a joint.",
        given={"d": d, "legs": [leg.degrees_of_freedom for leg in legs]},
        answer=Numbers(np.array(float(right.value))),
        solution=right,
        advice={
            "another d": f"A body that moves {place} has {d} degrees of freedom when it is free.",
            "leave out $-1$": "The ground is one of the $N$ bodies, and it does not move.",
            "bodies": f"The ground and the platform are bodies too, so there are $N = {2 + len(f) - len(legs)}$.",
        },
    )


@problem(
    "08.9",
    "Three kinds of mobility",
    points=3,
    lecture="08_closed_chains#Where counting fails",
    further="Which small change of the lengths would make all three counts equal?",
)
def three_mobilities(sampler: ArmSampler) -> Problem:
    case = overconstrained_case(sampler)
    linkage, loops = case.linkage, len(case.linkage.loops)
    mobility = linkage.mobility(case.q)
    kutzbach_count, infinitesimal, finite = mobility.kutzbach, mobility.infinitesimal, case.finite_mobility
    rank = linkage.n - infinitesimal
    d = (linkage.n - kutzbach_count) // loops
    shown = ", ".join(f"{value:.3f}" if value > 1e-6 else "0" for value in mobility.singular_values)
    moves = f"This linkage moves {'in the plane' if d == 3 else 'in space'}, so $d = {d}$."
    return Problem(
        statement=f"The drawing shows {case.description}, with {linkage.n} joint variables and {loops} loop{'s' * (loops > 1)}. In this "
        f"configuration the Jacobian $J$ of the loop closure has the singular values {shown}. Give three numbers: the mobility by the "
        "Gruebler-Kutzbach formula (*kutzbach*), the infinitesimal mobility in this configuration (*infinitesimal*), and the finite "
        "mobility, that is, the number of degrees of freedom with which the linkage can move to other configurations (*finite*).",
        figure=partial(draw_linkage, linkage, case.q, names=False),
        given={"joint_values": linkage.n, "loops": loops, "singular_values": mobility.singular_values.round(3)},
        answer=CountsAnswer(
            np.array([kutzbach_count, infinitesimal, finite], dtype=float),
            names=["kutzbach", "infinitesimal", "finite"],
        ),
        mistakes=[
            mistake(
                "count for all three",
                [kutzbach_count] * 3,
                "This is the count of the formula for all three. The formula is right only if the equations of the loops are "
                "independent. The infinitesimal mobility is the number of joint variables minus the rank of $J$.",
                "This is the count of the formula, which is right only if the equations of the loops are independent.",
                spoils=True,
            ),
            mistake(
                "rank",
                [kutzbach_count, rank, finite],
                f"You gave the rank of $J$, {rank}, as the infinitesimal mobility. It is the number of joint variables minus the rank.",
                f"This is the rank of $J$, {rank}. The infinitesimal mobility is the number of joint variables minus the rank.",
            ),
            mistake(
                "the wrong d",
                [linkage.n - (9 - d) * loops, infinitesimal, finite],
                f"This is the count with $d = {9 - d}$. {moves}",
                f"This is the count with $d = {9 - d}$. {moves}",
            ),
            mistake(
                "no loops",
                [linkage.n, infinitesimal, finite],
                f"You counted the joint variables only. Each loop has $d = {d}$ equations, which are subtracted.",
                f"This is the number of joint variables. Each loop has $d = {d}$ equations, which are subtracted.",
            ),
            mistake(
                "infinitesimal mobility",
                [infinitesimal, infinitesimal, finite],
                "You gave the infinitesimal mobility as the count. The formula counts joint variables and loops; it does not use $J$.",
                "This is the infinitesimal mobility. The formula counts joint variables and loops; it does not use $J$.",
            ),
            mistake(
                "order of the numbers",
                [finite, infinitesimal, kutzbach_count],
                "You gave the three numbers in the reverse order.",
                spoils=True,
            ),
            mistake("finite mobility", [kutzbach_count, infinitesimal, 1 - finite], case.explanation, case.explanation),
            *(
                mistake(name, wrong, f"You counted {text}.", f"This is the result if you count {text}.")
                for name, wrong, text in (
                    ("one loop too many", [kutzbach_count - d, infinitesimal, finite], "one loop too many"),
                    ("rank", [kutzbach_count, infinitesimal + 1, finite], "one singular value too many as zero"),
                    (
                        "rank",
                        [kutzbach_count, linkage.n - np.count_nonzero(mobility.singular_values > 1), finite],
                        "the singular values below 1 as zero",
                    ),
                )
            ),
        ],
    ).without_duplicates()


@dataclass(frozen=True, eq=False)
class CountsAnswer(Numbers):
    """Named integers, shape (k,); each is a part."""

    names: Sequence[str] = ()

    def seen(self, given: Array, part: int | None) -> Named | None:
        """Return whether all are 1. A single 1 is a count like any other, and so is 0, even three times."""
        if part is not None or (given != 1).any() or all(self.agrees(given, self.value)):
            return None
        return "placeholder", "All three numbers are 1, but each of them is found in its own way."

    def resemblance(self, given: Array, part: int | None) -> Named | None:
        """Return nothing of the whole: counts that are equal to others are no order."""
        return None if part is None else super().resemblance(given, part)

    @property
    def expected(self) -> str:
        return f"{len(self.names)} whole numbers, {', '.join(self.names)}"

    def place(self, index: Sequence[int]) -> str:
        return self.names[index[0]]

    @property
    def parts(self) -> Sequence[str]:
        return self.names

    def part_indices(self) -> list[int]:
        return list(range(len(self.names)))


SHEET = Sheet(
    "08_closed_chains",
    "Closed chains",
    [residual, both_ways, coupler_point, slider, which_mode, which_kind, dead_point, counting, three_mobilities],
)
