"""Sheet 08: loop closure, assembly modes, Grashof's condition, dead points, and the mobility by formula, rank and motion."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from kincourse.answers.screws import TwistAnswer
from kincourse.expressions.planar import (
    bars,
    both_modes,
    closing_twist,
    corner_angle,
    coupler_directions,
    direction_of,
    length,
    polar,
    rocker_directions,
    slider_place,
    with_other_bars,
)
from kincourse.expressions.poses import exp, pose
from kincourse.expressions.screws import screw_axes
from kincourse.problem import ArmSampler, Problem, problem
from kincourse.sampling.linkages import FourBar, crank_rocker, four_bar_of_kind, limited_crank, overconstrained_case
from kinlib.arrays.validation import Array
from kinlib.mechanisms import linkages
from kinlib.view.figures.linkage import draw_linkage
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import number
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression, given
from misstep.mutants.operations import ANGLE, LENGTH, cos, radians, sqrt, square, stack

TITLE = "Closed chains"

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
    "08.1", "A slider-crank with an offset", points=2, lecture="08_closed_chains#A worked example", level="Warm-up"
)
def slider(sampler: ArmSampler) -> Problem:
    crank, rod = sampler.length(0.2, 0.35), sampler.length(0.6, 0.8)
    offset = sampler.choice((-1, 1)) * sampler.length(0.1, 0.2)
    degrees = sampler.choice((sampler.degrees(20, 70), sampler.degrees(110, 160)))  # near 90 the crank has no part in x
    angle = radians(given("A", degrees, ANGLE))
    x = slider_place(length("crank", crank), length("rod", rod), length("offset", offset, LENGTH), angle)
    linkage = linkages.slider_crank(crank, rod, offset)
    side = "above" if offset > 0 else "below"
    A = np.radians(degrees)

    def rod_to(x: Array) -> str:
        needed = float(np.hypot(x - crank * np.cos(A), offset - crank * np.sin(A)))
        return _bar("With this $x$, the rod would have to be", needed, rod)

    return Problem(
        statement=f"A slider-crank has a crank of {number(crank)} m and a rod of {number(rod)} m. Its slider moves parallel to $x$, "
        f"{number(abs(offset))} m {side} the pin A. The angle of the crank from the $x$ axis is $A = {degrees}°$. What is the $x$ "
        "coordinate of the slider, from the pin A, in the assembly mode with the slider to the right of B? (The picture shows the "
        "linkage before the pin C is put in.)",
        further="At which crank angle is the slider farthest away?",
        figure=partial(draw_linkage, linkage, np.array([A, -A, 1.1 * (crank + rod), 0.0])),
        given={"crank": crank, "rod": rod, "offset": offset, "degrees": degrees},
        answer=Numbers(x, unit="m", test=rod_to),
        advice={
            "sign of an angle": f"This is right for the mirror image, with the crank below the $x$ axis. {ANTICLOCKWISE}",
            "sign of a length": f"This is right for the mirror image. Here the slider moves {side} A.",
            "leave out $\\mathrm{offset}$": "The line of the slider does not pass through A.",
            "sine and cosine swapped": "At 0 degrees the crank lies along $x$.",
        },
    )


KINDS = {
    "a": "crank-rocker: the crank makes full turns, and the rocker swings",
    "b": "double crank: crank and rocker both make full turns",
    "c": "Grashof double rocker: crank and rocker swing, and the coupler makes full turns",
    "d": "non-Grashof: no bar makes full turns relative to another",
    "e": "change point: all four bars can lie on one line",
}


@problem(
    "08.2", "What kind of four-bar is it?", points=2, lecture="08_closed_chains#Grashof's condition", level="Warm-up"
)
def which_kind(sampler: ArmSampler) -> Problem:
    right = sampler.choice(list(KINDS))
    four_bar = four_bar_of_kind(sampler, right)
    least, most = min(four_bar), max(four_bar)
    listed = "\n".join(f"- {letter}) {kind}" for letter, kind in KINDS.items())
    problem = Problem(
        statement=f"{describe_lengths(four_bar)} What kind of four-bar is it?\n\n{listed}\n\nAnswer with a letter, and with the sum of "
        "the shortest and the longest bar in metres, such as `('a', 0.7)`.",
        method=f"The shortest bar is the {FourBar._fields[four_bar.index(least)]}. Shortest and longest bar together are "
        f"{number(least + most)} m, and the other two {number(sum(four_bar) - least - most)} m.",
        further="Change one length by as little as possible to get another kind of four-bar.",
        given={"bars": tuple(four_bar)},
        answer=Choice(right, KINDS),
        mistakes=[Mistake(f"kind {wrong}", wrong, _kind_message(wrong, right)) for wrong in KINDS if wrong != right],
    )
    return problem.with_reason(Numbers(np.array(least + most), unit="m"), "the sum")


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


@problem("08.3", "A loop closed by points", points=3, lecture="08_closed_chains#A ring of ten links")
def gap_of_points(sampler: ArmSampler) -> Problem:
    four_bar = crank_rocker(sampler)
    degrees = [sampler.degrees(20, 80), sampler.degrees(-60, -20), sampler.degrees(85, 130)]
    _, crank, coupler, rocker = bars(four_bar)
    A, B, D = (radians(given(name, float(angle), ANGLE)) for name, angle in zip("ABD", degrees, strict=True))
    angle = (A + B).mistaken_for(
        ("relative angle", "take $B$ as the coupler's angle from the $x$ axis", B),
        ("relative angle", "subtract $B$ from $A$", A - B),
    )
    over_B = (polar(crank, A) + polar(coupler, angle)).named("p_1")
    D_point = given("p_D", np.array([four_bar.ground, 0.0]))
    over_D = (D_point + polar(rocker, D)).named("p_2")
    gap = (over_B - over_D).mistaken_for(
        ("sign", "subtract the end of the first branch from that of the second", over_D - over_B),
        ("one branch", "give the end of the second branch alone", over_D),
    )  # fmt: skip
    listed = ", ".join(f"${name} = {angle}°$" for name, angle in zip("ABD", degrees, strict=True))
    return Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} The loop is not closed yet: {listed}. Both branches end where the pin C "
        "should be. How far apart are the ends? Give the vector $p_1(A, B) - p_2(D)$, $[x, y]$ in metres, from the end of the rocker to "
        "the end of the coupler.",
        further="The rocker is rotated until the gap is as short as possible. Which angle is then between the gap and the rocker?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), np.radians([*degrees, 0.0])),
        given={"bars": tuple(four_bar), "degrees": dict(zip("ABD", degrees, strict=True))},
        answer=Numbers(gap, unit="m"),
        advice={"sign of an angle": ANTICLOCKWISE},
    )


@problem("08.4", "The residual of an open loop", points=3, lecture="08_closed_chains#Loop closure")
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
        further="How large may the residual be if the lengths are measured to a millimetre?",
        figure=partial(draw_linkage, linkage, np.radians(degrees)),
        given={"S": S, "G": G, "degrees": dict(zip("ABDC", degrees.tolist(), strict=True))},
        answer=TwistAnswer(r, scale=1),
        invisible=["rotation transposed"],  # G is a translation
        advice={
            "inverse left out": "On the way back the joints B and A are passed backwards, so their factors are inverted.",
            "order": "The loop goes over D, C and $G$ to the coupler, and back over B and then A.",
            "leave out $G$": "In the drawing at $q = 0$ the loop is open, and $G$ is the pose that closes it.",
        },
    )


@problem("08.5", "Both assembly modes", points=4, lecture="08_closed_chains#The smallest loop")
def both_ways(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    A = radians(given("A", degrees, ANGLE))
    D = with_other_bars(lambda four: both_modes(*rocker_directions(four, A)), bars(four_bar))
    coupler, rocker = coupler_directions(bars(four_bar), A), D.arguments
    line = direction_of(np.array([four_bar.ground, 0.0]) - polar(given("a", four_bar.crank), A))
    pins = [polar(given("d", four_bar.rocker), q) + np.array([four_bar.ground, 0.0]) for q in rocker]
    at_D = rocker[1] - line - np.pi
    for name, text, angles in (
        ("coupler's angles", "give the coupler's angles from the $x$ axis", coupler),
        ("crank's angle", "give the crank's angle and its negative", (A, -A)),
        ("angles at A", "give the angles of C as seen from A", tuple(map(direction_of, pins))),
        ("angles from the crank", "measure the rocker's angle from the crank", tuple(q - A for q in rocker)),
        ("angles from BD", "give the angles from the line BD instead of the $x$ axis", tuple(q - line for q in rocker)),
        ("angles from DB", "give the angles from the line DB instead of the $x$ axis", (-at_D, at_D)),
    ):
        D = D.mistaken_for(
            (name, text, both_modes(*angles), "The rocker's angle is measured from the $x$ axis, in radians.")
        )
    return Problem(
        statement=f"{describe_lengths(four_bar)} The angle of its crank from the $x$ axis is $A = {degrees}°$. Give "
        "the rocker's angle $D$, also from the $x$ axis but in radians, in both assembly modes, in any order. (The picture shows "
        "the linkage before the pin C is put in.)",
        method="$\\angle(x, DB)$ is the angle of the vector $DB$ from the $x$ axis, by $\\operatorname{atan2}$.",
        further="Can the linkage move from one mode to the other without being taken apart?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), open_configuration(np.radians(degrees))),
        given={"bars": tuple(four_bar), "degrees": degrees},
        answer=Angles(D, any_order=True, test=partial(_coupler_at, four_bar, np.radians(degrees))),
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


@problem("08.6", "The range of a crank", points=3, lecture="08_closed_chains#The configuration-space curve")
def dead_point(sampler: ArmSampler) -> Problem:
    four_bar = limited_crank(sampler)
    lengths = ground, crank, coupler, rocker = bars(four_bar)

    def stretched(four: Sequence[Expression]) -> Expression:
        return corner_angle(four[0], four[1], four[2] + four[3])

    A = with_other_bars(stretched, lengths, [(0, 2), (0, 3), (1, 2), (1, 3)])
    A = A.mistaken_for(
        ("mirror image", "give the least angle instead of the greatest", -A),
        ("another bar", "stretch crank and coupler into one line", corner_angle(ground, crank + coupler, rocker)),
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
        further="What is the angle of the rocker from the $x$ axis at this dead point?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), four_bar.closed_at(0.6 * A.value)),
        given={"bars": tuple(four_bar)},
        answer=Angles(A, test=reach),
        advice={
            "mirror image": "The least angle belongs to the mirror image, with the crank below the ground line.",
            "another corner": "The crank's angle is the angle at A, opposite the stretched bars.",
            **dict.fromkeys(("another bar", "term left out", "lengths swapped"), advice),
        },
    )


@problem("08.7", "Three kinds of mobility", points=4, lecture="08_closed_chains#Where counting fails", level="Hard")
def three_mobilities(sampler: ArmSampler) -> Problem:
    case = overconstrained_case(sampler)
    linkage, loops = case.linkage, len(case.linkage.loops)
    mobility = linkage.mobility(case.q)
    n, count, infinitesimal, finite = linkage.n, mobility.kutzbach, mobility.infinitesimal, case.finite_mobility
    rank, d, above_1 = n - infinitesimal, (n - count) // loops, int(np.count_nonzero(mobility.singular_values > 1))
    moves = f"This linkage moves {'in the plane' if d == 3 else 'in space'}, so $d = {d}$."
    of_formula = "This is the count of the formula."
    independent = "It is right only if the equations of the loops are independent."
    counted = "This is the result if you count"
    wrong = [
        ("rank", (count, rank, finite), f"This is the rank of $J$, {rank}, which is subtracted from the number of joint variables."),
        ("the wrong d", (n - (9 - d) * loops, infinitesimal, finite), f"This is the count with $d = {9 - d}$. {moves}"),
        ("no loops", (n, infinitesimal, finite), f"This is the number of joint variables. Each loop subtracts $d = {d}$ equations."),
        ("infinitesimal mobility", (infinitesimal, infinitesimal, finite),
         "This is the infinitesimal mobility. The formula counts joint variables and loops; it does not use $J$."),
        ("finite mobility", (count, infinitesimal, 1 - finite), case.explanation),
        ("rank", (count, infinitesimal + 1, finite), f"{counted} one singular value too many as zero."),
        ("rank", (count, n - above_1, finite), f"{counted} the singular values below 1 as zero."),
    ]  # fmt: skip
    shown = ", ".join(f"{value:.3f}" if value > 1e-6 else "0" for value in mobility.singular_values)
    return Problem(
        statement=f"The drawing shows {case.description}, with {linkage.n} joint variables and {loops} loop{'s' * (loops > 1)}. In this "
        f"configuration the Jacobian $J$ of the loop closure has the singular values {shown}. Give three numbers: the mobility by the "
        "Gruebler-Kutzbach formula (*kutzbach*), the infinitesimal mobility in this configuration (*infinitesimal*), and the finite "
        "mobility, that is, the number of degrees of freedom with which the linkage can move to other configurations (*finite*).",
        method=f"The formula subtracts $d = {d}$ for each loop from the number of joint variables: ${n} - {d} \\cdot {loops} = {count}$.\n"
        f"$J$ has the rank {rank}, the number of singular values that are not 0: ${n} - {rank} = {infinitesimal}$.\n{case.explanation}",
        further="One hinge is mounted slightly tilted. Which of the three numbers change?",
        figure=partial(draw_linkage, linkage, case.q, names=False),
        given={"joint_values": linkage.n, "loops": loops, "singular_values": mobility.singular_values.round(3)},
        answer=CountsAnswer(
            np.array([count, infinitesimal, finite], dtype=float),
            names=["kutzbach", "infinitesimal", "finite"],
        ),
        mistakes=[
            Mistake("count for all three", [count] * 3, f"{of_formula} {independent}", in_parts=True, spoils=True),
            Mistake(
                "order of the numbers",
                [finite, infinitesimal, count],
                "They are in the reverse order.",
                spoils=True,
            ),
            *(Mistake(name, value, text, in_parts=True) for name, value, text in wrong),
        ],
    ).without_duplicates()


@problem("08.8", "A wiper to design", points=4, lecture="08_closed_chains#Grashof's condition", level="Hard")
def wiper(sampler: ArmSampler) -> Problem:
    while True:
        ground, rocker = sampler.length(0.4, 0.8), sampler.length(0.25, 0.6)
        degrees = sorted((sampler.degrees(40, 75), sampler.degrees(90, 130)))
        C = [(ground + rocker * np.cos(x), rocker * np.sin(x)) for x in np.radians(degrees)]
        far, near = np.hypot(*np.transpose(C))
        if (
            ground != rocker
            and abs(sum(degrees) - 180) > 8
            and FourBar(ground, (far - near) / 2, (far + near) / 2, rocker).grashof_excess < -0.03
        ):
            break
    g, c = length("ground", ground), length("rocker", rocker)
    angles = [radians(given(name, x, ANGLE)) for name, x in zip(("D_1", "D_2"), degrees, strict=True)]
    r_1, r_2 = (sqrt(square(g) + square(c) + 2 * g * c * cos(D)).named(f"r_{i}") for i, D in enumerate(angles, start=1))
    crank, coupler = (r_1 - r_2) / 2, (r_1 + r_2) / 2
    both = stack(crank, coupler)
    other_sign = [np.sqrt(ground**2 + rocker**2 - 2 * ground * rocker * np.cos(x)) for x in np.radians(degrees)]
    swing = np.radians(degrees[1] - degrees[0])
    for name, text, wrong in (
        ("not halved", "give the difference and the sum, without halving them", (2 * crank, 2 * coupler)),
        ("distances themselves", "give the two distances from A to C", (r_1, r_2)),
        ("another corner", "take the angle at D to the ground line instead of the angle from the $x$ axis",
         (abs(other_sign[0] - other_sign[1]) / 2, sum(other_sign) / 2)),
        ("half of the chord", "take half of the chord of the swing as the crank", (rocker * np.sin(swing / 2), coupler)),
        ("half of the arc", "take half of the arc of the swing as the crank", (rocker * swing / 2, coupler)),
        ("coupler as the ground", "make the coupler as long as the ground", (crank, g)),
        ("coupler as the longer one", "give the longer distance as the coupler", (crank, r_1)),
        ("coupler as the shorter one", "give the shorter distance as the coupler", (crank, r_2)),
        ("sign", "subtract in the other order, so that a length is negative", (-crank.value, coupler)),
    ):  # fmt: skip
        both = both.mistaken_for(
            (name, text, stack(*map(np.array, (getattr(x, "value", x) for x in wrong)))), may_coincide=True
        )
    return Problem(
        statement=f"A wiper is the rocker of a four-bar, whose crank is driven round and round by a motor. The ground is "
        f"{number(ground)} m and the rocker {number(rocker)} m long: the crank turns about A, the origin, and the rocker about D, at "
        f"$({number(ground)}, 0)$. C is the tip of the rocker, whose angle from the $x$ axis must swing between $D_1 = {degrees[0]}°$ "
        f"and $D_2 = {degrees[1]}°$. How long are crank and coupler, in metres?",
        method="At the ends of the swing crank and coupler lie on one line, so the distance from A to C is coupler plus crank, $r_1$, or "
        "coupler minus crank, $r_2$. By the law of cosines in the triangle A, D, C:",
        further="Does the wiper take the same time in both directions if the motor runs at constant speed?",
        given={"ground": ground, "rocker": rocker, "degrees": degrees},
        answer=Numbers(both, unit="m"),
        invisible={"sign of an angle"},
    )


@dataclass(frozen=True, eq=False)
class CountsAnswer(Numbers):
    """Named integers, shape (k,); each is a part."""

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{len(self.names)} whole numbers, {', '.join(self.names)}"

    @property
    def parts(self) -> Sequence[str]:
        return self.names


@problem("08.9", "A tray that stays level", points=3, lecture="08_closed_chains#Where counting fails", level="Open")
def level_tray(_: ArmSampler) -> Problem:
    return Problem(
        statement="Design a planar linkage that carries a tray along a curve without tilting it, driven by one motor. Give its lengths, "
        "and show that the tray stays level. What goes wrong when all bars lie on one line, and what do you add against it? "
        "What does the Gruebler-Kutzbach formula say of the result, and is it right?",
        answer=Prose(
            "A parallelogram: two cranks of equal length on a ground as long as the coupler, which carries the tray. Opposite sides "
            "stay parallel, so the coupler has the direction of the ground all the time. On one line it is at a change point, and "
            "may leave it as an antiparallelogram, with a tilting tray. A third crank, parallel to the others and of the same "
            "length, prevents this. Then there are 5 bodies and 6 joints: $3 (5 - 1 - 6) + 6 = 0$, but it moves, because one loop "
            "repeats the equations of the other.",
            {
                "a linkage with lengths whose tray stays level, with the reason": 1,
                "the change point, and a remedy": 1,
                "the count of the formula, and why it is right or wrong here": 1,
            },
        ),
    )
