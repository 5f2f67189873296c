"""Sheet 08: loop closure, assembly modes, Grashof's condition, dead points, and degrees of freedom by formula and in fact."""

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
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import number, vector
from misstep.mistakes import mistake
from misstep.mutants.expression import Expression, given
from misstep.mutants.operations import ANGLE, LENGTH, radians
from misstep.problem import Problem
from misstep.sheet import Sheet

ANGLES_NOTE = "$A$ and $D$ count from the $x$ axis, $B$ is the coupler's angle against the crank, $C$ its angle against the rocker."


ANTICLOCKWISE = "Angles are positive anticlockwise."
MIRRORED = f"This is the mirror image in the ground line, whose crank points below the $x$ axis. {ANTICLOCKWISE}"


def describe_lengths(four_bar: FourBar) -> str:
    """State the lengths in a sentence."""
    ground, crank, coupler, rocker = (number(length) for length in four_bar)
    return f"A four-bar has a ground of {ground} m, a crank of {crank} m, a coupler of {coupler} m and a rocker of {rocker} m."


def open_configuration(A: float) -> Array:
    """A configuration for drawings that must not show where C is: the coupler along x, the rocker upright."""
    return np.array([A, -A, np.pi / 2, 0.0])


@problem(
    "08.1", "The gap of a posture", points=3, lecture="08_closed_chains#A loop is an open chain that must come back"
)
def gap(sampler: ArmSampler) -> Problem:
    four_bar = crank_rocker(sampler)
    linkage = linkages.four_bar(*four_bar)
    degrees = np.array(
        [sampler.degrees(20, 80), sampler.degrees(-60, -20), sampler.degrees(85, 130), sampler.degrees(-75, -25)]
    )
    S = {joint.name: joint.screws[0] for joint in linkage.joints}
    G = linkage.joints[3].closing_offset
    A, B, D, C = (
        exp(screw_axes(f"S_{name}", S[name]), radians(given(name, float(angle), ANGLE)))
        for name, angle in zip("ABDC", degrees, strict=True)
    )
    r = closing_twist([D, C, pose("G", G)], [A, B])
    listed = ", ".join(f"${name} = {angle}°$" for name, angle in zip("ABDC", degrees, strict=True))
    return Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} It is not closed yet: {listed}. Walk round, from the "
        "ground over D and C to the coupler and "
        "back over B and A. What twist is left over, $r = \\log(e^{[S_D]D}\\, e^{[S_C]C}\\, G\\, e^{-[S_B]B}\\, e^{-[S_A]A})$?",
        figure=partial(draw_linkage, linkage, np.radians(degrees)),
        given={"S": S, "G": G, "degrees": dict(zip("ABDC", degrees.tolist(), strict=True))},
        answer=TwistAnswer(r.value, scale=1),
        solution=r,
        invisible=["rotation transposed"],  # G is a translation
        advice={
            "inverse left out": "On the way back every joint is undone, so the factors of A and B are inverted.",
            "order": "You walk over D, C and G to the coupler, and back over B and then A.",
            "leave out $G$": "The drawing is open: $G$ moves the coupler's drawing to where C has it.",
        },
    )


@problem("08.2", "Both ways to put it together", points=3, lecture="08_closed_chains#The smallest loop")
def both_ways(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    A = radians(given("A", degrees, ANGLE))
    D = with_other_bars(lambda four: both_modes(*rocker_directions(four, A)), bars(four_bar))
    coupler, rocker = coupler_directions(bars(four_bar), A), D.arguments
    line = direction_of(np.array([four_bar.ground, 0.0]) - polar(given("a", four_bar.crank), A))
    for name, text, angles in (
        ("coupler's angles", "give the coupler's angles from the $x$ axis", coupler),
        ("coupler's angles", "give the coupler's angles against the crank", tuple(k - A for k in coupler)),
        ("coupler's angles", "give the coupler's angles against the rocker", tuple(map(sub, coupler, rocker))),
        ("coupler's angles", "give the coupler's angles in degrees", tuple(180 / np.pi * k for k in coupler)),
        ("angles from BD", "give the angles from the line BD instead of the $x$ axis", tuple(q - line for q in rocker)),
        ("inner angles", "give the inner angles at D in degrees", tuple(180 - 180 / np.pi * q for q in rocker)),
    ):
        D = D.mistaken_for(both_modes(*angles), name, text, "The rocker's angle is that from the $x$ axis, in radians.")
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank stands at {degrees} degrees from the $x$ axis. Give the "
        "rocker's angle $D$, from the $x$ axis "
        "too and in radians, in both assembly modes, in any order. (Drawn before C is pinned.)",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), open_configuration(np.radians(degrees))),
        given={"bars": tuple(four_bar), "degrees": degrees},
        answer=Angles(D.value, any_order=True),
        solution=D,
        advice={
            "lengths swapped": "The circle about B has the coupler's radius, the one about D the rocker's.",
            "sign of an angle": MIRRORED,
            "sine and cosine swapped": "At 0 degrees the crank lies along $x$.",
        },
    )


@problem("08.3", "A point of the coupler", points=3, lecture="08_closed_chains#The smallest loop")
def coupler_point(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    along, left = sampler.length(0.1, 0.25), sampler.length(0.1, 0.25)
    linkage, lengths = linkages.four_bar(*four_bar), bars(four_bar)
    A = radians(given("A", degrees, ANGLE))

    def coupler(mode: int) -> Expression:
        k = with_other_bars(lambda four: coupler_directions(four, A)[mode], lengths)
        for text, wrong in (
            ("rotate by $B$, the coupler's angle against the crank, alone", k - A),
            ("rotate by the crank's angle", A),
            ("rotate by the crank's angle twice", k + A),
            ("rotate by the rocker's angle", rocker_directions(lengths, A)[mode]),
        ):
            k = k.mistaken_for(wrong, "another angle", text, "From the $x$ axis the coupler's angle is $A + B$.")
        return k

    angle = coupler(0).mistaken_for(
        coupler(1), "other mode", "take the other assembly mode, with C to the right of the arrow from B to D"
    )
    p = point("p", np.array([along, left]))
    for text, wrong in (
        ("measure $p$ from C, towards B", (four_bar.coupler - along, left)),
        ("measure $p$ from C, away from B", (four_bar.coupler + along, left)),
        ("take $p$ along the coupler only", (along, 0.0)),
        ("give C instead of P", (four_bar.coupler, 0.0)),
    ):
        p = p.mistaken_for(np.array(wrong), "another point", text, "P's distance along the coupler counts from B.")
    start = polar(lengths[1], A).named("B")
    start = start.mistaken_for(np.array([four_bar.ground, 0.0]), "from D", "add $p$ to the place of D instead of B")
    in_degrees = np.radians(degrees) * 180 / np.pi
    P = start + rotated(angle, p)
    P = P.mistaken_for(
        P * np.array([1.0, -1.0]), "mirror image", "give the mirror image of P in the ground line", MIRRORED
    )
    P = P.mistaken_for(P - np.array([four_bar.ground, 0.0]), "from D", "measure P from D instead of A")
    P = P.mistaken_for(
        four_bar.crank * np.array([np.cos(in_degrees), np.sin(in_degrees)]) + rotated(180 / np.pi * angle, p),
        "degrees",
        "use degrees as radians",
    )
    drawn = {"P": ("coupler", (four_bar.crank + along, left, 0.0))}
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank stands at {degrees} degrees, and C lies to the left of the "
        "arrow from B to D. A point P of the "
        f"coupler lies {number(along)} m from B along the coupler, towards C, and {number(left)} m to the left of it. Where is P, "
        "as $[x, y]$ from A?",
        figure=partial(draw_linkage, linkage, four_bar.assembly_modes(np.radians(degrees))[0], points=drawn),
        given={"bars": tuple(four_bar), "degrees": degrees, "along": along, "left": left},
        answer=Numbers(P.value, unit="m"),
        solution=P,
        advice={
            "take the $y$ of $p$ with the opposite sign": "P lies to the left of the way from B to C.",
            "sine and cosine swapped": "At 0 degrees a bar lies along $x$.",
        },
    )


@problem("08.4", "A slider-crank with an offset", points=2, lecture="08_closed_chains#A worked example")
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
    linkage = linkages.slider_crank(crank, rod, offset)
    side = "above" if offset > 0 else "below"
    A = np.radians(degrees)
    return Problem(
        statement=f"A slider-crank has a crank of {number(crank)} m and a rod of {number(rod)} m. Its slide runs along $x$, "
        f"{number(abs(offset))} m {side} A. The crank stands at {degrees} degrees from the $x$ axis. Where is the slider "
        "along $x$, from A, on the far side of B? (Drawn before C is pinned.)",
        figure=partial(draw_linkage, linkage, np.array([A, -A, 1.1 * (crank + rod), 0.0])),
        given={"crank": crank, "rod": rod, "offset": offset, "degrees": degrees},
        answer=Numbers(np.array(x.value), unit="m"),
        solution=x,
        advice={
            "sign of an angle": f"This is right for the mirror image, with the crank below the $x$ axis. {ANTICLOCKWISE}",
            "sign of a length": f"This is right for the mirror image. Here the slide runs {side} A.",
            "leave out $\\mathrm{offset}$": "The slide does not run through A.",
            "sine and cosine swapped": "At 0 degrees the crank lies along $x$.",
        },
    )


@problem("08.5", "Which posture is drawn?", points=2, lecture="08_closed_chains#The smallest loop")
def which_mode(sampler: ArmSampler) -> Problem:
    four_bar, degrees, drawn, named = _distinct_modes(sampler)
    q = four_bar.assembly_modes(np.radians(degrees))[drawn]
    letters = dict(zip("abcd", sampler.shuffled(list(named)), strict=True))
    listed = {letter: np.degrees(wrap_angle(named[name])).round(1) for letter, name in letters.items()}
    shown = "\n".join(f"- {letter}) $D = {number(D)}°$, $C = {number(C)}°$" for letter, (D, C) in listed.items())
    why = {
        "other mode": "These values close the loop too, in the other mode. Look on which side of the line from B to D the pin C lies.",
        "inner angle": "This $D$ is the inner angle of the quadrilateral. The rocker's angle counts from the direction of $x$.",
        "sign of C": "$D$ is right. $C$ counts from the rocker to the coupler, anticlockwise, and yours has the other sign.",
    }
    C = four_bar.pin_positions(np.radians(degrees))[2][drawn]
    return Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} Somebody assembled it with the crank at {degrees} "
        "degrees, and read off that C is at "
        f"${vector(C.round(2))}$, to a centimetre. Which joint values are these?\n\n{shown}\n\nAnswer with a letter, such as `'a'`.",
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
    "a": "the crank turns right round, the rocker swings",
    "b": "crank and rocker both turn right round",
    "c": "crank and rocker swing, and the coupler turns right round",
    "d": "no bar turns right round against another",
    "e": "it is at the limit: all four bars can lie on one line",
}


@problem("08.6", "What kind of four-bar is it?", points=2, lecture="08_closed_chains#Grashof's condition")
def which_kind(sampler: ArmSampler) -> Problem:
    right = sampler.choice(list(KINDS))
    four_bar = four_bar_of_kind(sampler, right)
    listed = "\n".join(f"- {letter}) {kind}" for letter, kind in KINDS.items())
    return Problem(
        statement=f"{describe_lengths(four_bar)} What holds?\n\n{listed}\n\nAnswer with a letter, such as `'a'`.",
        given={"bars": tuple(four_bar)},
        answer=Choice(right, KINDS),
        mistakes=[mistake(f"kind {wrong}", wrong, _kind_message(wrong, right)) for wrong in KINDS if wrong != right],
    )


def _kind_message(wrong: str, right: str) -> str:
    if right == "e":
        return "Add up shortest and longest, and the other two: the sums are equal, and that is the limit."
    if right == "d":
        return "Shortest plus longest is more than the other two together: here no bar turns right round."
    if wrong == "d":
        return "Shortest plus longest is less than the other two together, so the shortest bar does turn right round."
    if wrong == "e":
        return "At the limit shortest plus longest would be exactly what the other two are together."
    turns = {"a": "the crank", "b": "the ground", "c": "the coupler"}[right]
    return f"Grashof's condition holds, so the shortest bar turns against all others. Which bar is the shortest? Here it is {turns}."


@problem("08.7", "How far the crank can go", points=3, lecture="08_closed_chains#The configuration-space curve")
def dead_point(sampler: ArmSampler) -> Problem:
    four_bar = limited_crank(sampler)
    lengths = ground, crank, coupler, rocker = bars(four_bar)

    def stretched(four: Sequence[Expression]) -> Expression:
        reach = (four[2] + four[3]).mistaken_for(
            four[2] - four[3], "folded", "take the difference of coupler and rocker, as if they were folded"
        )
        return corner_angle(four[0], four[1], reach)

    A = with_other_bars(stretched, lengths, [(0, 2), (0, 3), (1, 2), (1, 3)])
    for name, text, wrong in (
        ("mirror image", "give the least angle instead of the greatest", -A),
        ("another bar", "stretch crank and coupler into one line", corner_angle(ground, crank + coupler, rocker)),
        (
            "another corner",
            "give the angle at D in degrees",
            180 / np.pi * corner_angle(ground, coupler + rocker, crank),
        ),
        ("supplement", "give the supplement in degrees", 180 - 180 / np.pi * A),
        ("full turn", "assume that the crank turns right round", np.pi),
    ):
        A = A.mistaken_for(wrong, name, text)
    advice = "At the dead point coupler and rocker lie in one line, end to end, and reach from B to D."
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank cannot turn right round. What is the greatest angle $A$ "
        "from the $x$ axis, between $-\\pi$ and $\\pi$ and in radians, at which the loop still closes?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), four_bar.assembly_modes(0.6 * A.value)[0]),
        given={"bars": tuple(four_bar)},
        answer=Angles(np.array(A.value)),
        solution=A,
        advice={
            "mirror image": "It is the mirror image of the other one, with the crank below the ground line.",
            "another corner": "The crank's angle is that at A, opposite the stretched bars.",
            **dict.fromkeys(("folded", "another bar", "term left out", "lengths swapped"), advice),
        },
    )


JOINT_FREEDOMS_NOTE = "A pin and a slide have one freedom, a universal joint two, a ball joint three."


@problem("08.8", "Freedoms by counting", points=3, lecture="08_closed_chains#Counting freedoms")
def counting(sampler: ArmSampler) -> Problem:
    d, kinds = sampler.choice([(3, PLANAR_LEGS), (6, SPATIAL_LEGS), (6, SPATIAL_LEGS)])
    one, other = sampler.shuffled(kinds)[:2]
    legs = [one] * sampler.integer(1, 3) + [other] * sampler.integer(1, 3)
    f = [joint_freedoms for leg in legs for joint_freedoms in leg.joint_freedoms]
    place = "in one plane" if d == 3 else "in space"
    right = kutzbach(d, [leg.joint_freedoms for leg in legs])
    counts = [f"{legs.count(leg)} with {leg.description}" for leg in (one, other)]
    return Problem(
        statement=f"A platform moves {place}. It stands on {len(legs)} legs, {' and '.join(counts)}, each named from the ground to the "
        f"platform, with a body of its own between every two joints. {JOINT_FREEDOMS_NOTE} How many freedoms does Kutzbach's formula give?",
        given={"d": d, "legs": [leg.joint_freedoms for leg in legs]},
        answer=Numbers(np.array(float(right.value))),
        solution=right,
        advice={
            "another d": f"A body that moves {place} has {d} degrees of freedom when it is free.",
            "leave out $-1$": "The ground is one of the $N$ bodies, and it stands still.",
            "bodies": f"The ground and the platform are bodies too, so there are $N = {2 + len(f) - len(legs)}$.",
        },
    )


@problem("08.9", "Counted, felt, had", points=3, lecture="08_closed_chains#Where counting fails")
def three_mobilities(sampler: ArmSampler) -> Problem:
    case = overconstrained_case(sampler)
    linkage, loops = case.linkage, len(case.linkage.loops)
    mobility = linkage.mobility(case.q)
    counted, felt, rank = mobility.kutzbach, mobility.infinitesimal, linkage.n - mobility.infinitesimal
    d = (linkage.n - counted) // loops
    large = np.count_nonzero(mobility.singular_values > 1)
    shown = ", ".join(f"{value:.3f}" if value > 1e-6 else "0" for value in mobility.singular_values)
    return Problem(
        statement=f"The drawing shows {case.description}: {linkage.n} joint values in {loops} loop{'s' * (loops > 1)}. In this posture "
        f"the Jacobian of its closure has the singular values {shown}. How many freedoms are *counted* by Kutzbach's formula, how "
        "many are *felt* in this posture, and how many are *had*, so that they lead to other postures?",
        figure=partial(draw_linkage, linkage, case.q, names=False),
        given={"joint_values": linkage.n, "loops": loops, "singular_values": mobility.singular_values.round(3)},
        answer=CountsAnswer(
            np.array([counted, felt, case.finite_mobility], dtype=float), names=["counted", "felt", "had"]
        ),
        mistakes=[
            mistake(
                "believed the count",
                [counted, counted, counted],
                "You believed the count. Felt is the number of joint values less the rank of $J$: look at the singular values that are 0.",
                "This is the number that is counted. Counting does not see that some of the equations of the closure are not new.",
            ),
            mistake(
                "rank",
                [counted, rank, case.finite_mobility],
                f"You gave the rank of $J$, {rank}: how many of its equations are new. Felt is what they leave over.",
                f"This is the rank of $J$, {rank}: how many of its equations are new. Felt is what they leave over.",
            ),
            mistake(
                "the wrong d",
                [linkage.n - (9 - d) * loops, felt, case.finite_mobility],
                f"You counted with $d = {9 - d}$. This linkage moves {'in one plane' if d == 3 else 'in space'}: $d = {d}$.",
                f"This is the count with $d = {9 - d}$. This linkage moves {'in one plane' if d == 3 else 'in space'}: $d = {d}$.",
            ),
            mistake(
                "no loops",
                [linkage.n, felt, case.finite_mobility],
                f"You counted the joint values alone. Each of the loops takes $d = {d}$ away.",
                f"This is the number of joint values. Each of the loops takes $d = {d}$ away.",
            ),
            mistake("had", [counted, felt, 1 - case.finite_mobility], case.explanation, case.explanation),
            *(
                mistake(name, wrong, f"You counted {text}.", f"This is what you get if you count {text}.")
                for name, wrong, text in (
                    ("one loop too many", [counted - d, felt, case.finite_mobility], "one loop too many"),
                    ("rank", [counted, felt + 1, case.finite_mobility], "one singular value too many as zero"),
                    ("rank", [counted, linkage.n - large, case.finite_mobility], "the singular values below 1 as zero"),
                )
            ),
        ],
    ).without_duplicates()


@dataclass(frozen=True, eq=False)
class CountsAnswer(Numbers):
    """Named integers, shape (k,); each is a part."""

    names: Sequence[str] = ()

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
    [gap, both_ways, coupler_point, slider, which_mode, which_kind, dead_point, counting, three_mobilities],
)
