"""Sheet 08: loop closure, assembly modes, Grashof's condition, dead points, and degrees of freedom by formula and in fact."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from kincourse.answers.screws import TwistAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.four_bar_geometry import FourBar, slider_position
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
from kinlib.rigid.lie import exp, inverse, log
from kinlib.view.figures.linkage import draw_linkage
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import number, vector
from misstep.mistakes import mistake
from misstep.problem import Problem
from misstep.sheet import Sheet

ANGLES_NOTE = "$A$ and $D$ count from the $x$ axis, $B$ is the coupler's angle against the crank, $C$ its angle against the rocker."


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

    def factors(angles: Array) -> tuple[Array, Array, Array, Array]:
        A, B, D, C = (exp(S[name] * angle) for name, angle in zip("ABDC", angles, strict=True))
        return A, B, D, C

    A, B, D, C = factors(np.radians(degrees))
    wrong = factors(degrees.astype(float))
    gap_pose = D @ C @ G @ inverse(A @ B)
    r = log(gap_pose)
    listed = ", ".join(f"${name} = {angle}°$" for name, angle in zip("ABDC", degrees, strict=True))
    return Problem(
        statement=f"{describe_lengths(four_bar)} {ANGLES_NOTE} It is not closed yet: {listed}. Walk round, from the "
        "ground over D and C to the coupler and "
        "back over B and A. What twist is left over, $r = \\log(e^{[S_D]D}\\, e^{[S_C]C}\\, G\\, e^{-[S_B]B}\\, e^{-[S_A]A})$?",
        figure=partial(draw_linkage, linkage, np.radians(degrees)),
        given={"S": S, "G": G, "degrees": dict(zip("ABDC", degrees.tolist(), strict=True))},
        answer=TwistAnswer(r),
        mistakes=[
            mistake(
                "not inverted",
                log(D @ C @ G @ A @ B),
                "You did not invert the second branch. Branches that meet have equal poses, so one is multiplied by the other's "
                "inverse: on the way back every joint is undone.",
            ),
            mistake(
                "not reversed",
                log(D @ C @ G @ inverse(A) @ inverse(B)),
                "The signs are right, the order is not: on the way back you pass B first, then A.",
            ),
            mistake(
                "no gap",
                log(D @ C @ inverse(A @ B)),
                "You left out $G$. The drawing is open; $G$ moves the coupler's drawing to where C has it.",
            ),
            mistake(
                "the other way round",
                -r,
                "You walked the other way: over A and B, and back over C and D. All signs turn.",
            ),
            mistake(
                "translation for v",
                [*r[:3], *gap_pose[:3, 3]],
                "Your $\\omega$ is right. Your $v$ is the translation of the product of the exponentials; the $v$ of its logarithm "
                "differs from it, because the gap is a rotation too.",
            ),
            mistake(
                "angle in degrees",
                [*np.degrees(r[:3]), *r[3:]],
                "Your $v$ is right. Your $\\omega$ is in degrees; a twist is in radians.",
            ),
            mistake(
                "seen from the coupler",
                log(inverse(A @ B) @ D @ C @ G),
                "This is $\\log(T_2^{-1}\\, T_1)$, as in equation (2) of the lecture: the same gap in coordinates of the coupler. "
                "The formula here begins on the ground, with $D$, so its twist is in coordinates of the ground.",
            ),
            mistake(
                "seen from the coupler, and negated",
                log(inverse(D @ C @ G) @ A @ B),
                "This is $\\log(T_1^{-1}\\, T_2)$: the gap in coordinates of the coupler, and in the other direction. "
                "The formula here is $\\log(T_1\\, T_2^{-1})$, with $T_1 = e^{[S_D]D} e^{[S_C]C} G$.",
            ),
            mistake(
                "degrees",
                log(wrong[2] @ wrong[3] @ G @ inverse(wrong[0] @ wrong[1])),
                "You used degrees as radians.",
            ),
        ],
    )


@problem("08.2", "Both ways to put it together", points=3, lecture="08_closed_chains#The smallest loop")
def both_modes(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    A = np.radians(degrees)
    left, right = four_bar.assembly_modes(A)
    D = np.array([left[2], right[2]])
    swapped = FourBar(four_bar.ground, four_bar.crank, four_bar.rocker, four_bar.coupler).assembly_modes(A)[:, 2]
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank stands at {degrees} degrees from the $x$ axis. Give the "
        "rocker's angle $D$, from the $x$ axis "
        "too and in radians, in both assembly modes, in any order. (Drawn before C is pinned.)",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), open_configuration(A)),
        given={"bars": tuple(four_bar), "degrees": degrees},
        answer=Angles(D, any_order=True),
        mistakes=[
            mistake(
                "mirrored in the ground",
                [left[2], -left[2]],
                "One is right. You mirrored it in the ground line, but B does not move: the mirror is the line from B to D.",
            ),
            mistake(
                "mirror image",
                -D,
                "These are the right angles with the other sign: those of the mirror image in the ground line, whose crank points "
                "below the $x$ axis. Here angles are positive anticlockwise, and the crank points above it.",
                "This is a right angle with the other sign. Angles are positive anticlockwise, and the crank points above the $x$ axis.",
            ),
            mistake(
                "inner angles",
                np.pi - D,
                "These are the inner angles at D. The joint value counts from the direction of $x$, anticlockwise.",
                "This is an inner angle at D. The joint value counts from the direction of $x$, anticlockwise.",
            ),
            mistake(
                "crank from y",
                four_bar.assembly_modes(np.pi / 2 - A)[:, 2],
                "You measured the crank from the $y$ axis. At 0 degrees it lies along $x$.",
                "This is right if the crank's angle is measured from the $y$ axis. At 0 degrees the crank lies along $x$.",
            ),
            mistake(
                "lengths swapped",
                swapped,
                "You swapped coupler and rocker. The circle about B has the coupler's radius, the one about D the rocker's.",
                "This is right if coupler and rocker are swapped. The circle about B has the coupler's radius.",
            ),
            mistake(
                "the coupler's angles",
                [left[0] + left[1], right[0] + right[1]],
                "These are the coupler's angles from the $x$ axis. The rocker hangs at D.",
                "This is an angle of the coupler from the $x$ axis. The rocker hangs at D.",
            ),
            mistake(
                "degrees",
                np.degrees(D),
                "Right, but in degrees. Joint values are in radians.",
                "Right, but in degrees.",
            ),
        ],
    )


@problem("08.3", "A point of the coupler", points=3, lecture="08_closed_chains#The smallest loop")
def coupler_point(sampler: ArmSampler) -> Problem:
    four_bar, degrees = crank_rocker(sampler), sampler.degrees(25, 155)
    A, point = np.radians(degrees), np.array([sampler.length(0.1, 0.25), sampler.length(0.1, 0.25)])
    linkage, (q, other) = linkages.four_bar(*four_bar), four_bar.assembly_modes(A)
    B = four_bar.pin_positions(A)[0]

    def carried(angle: float, where: Array = point) -> Array:
        turned: Array = B + exp(np.array([0.0, 0.0, angle]))[:2, :2] @ where
        return turned

    angle = q[0] + q[1]
    drawn = {"P": ("coupler", (four_bar.crank + point[0], point[1], 0.0))}
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank stands at {degrees} degrees, and C lies to the left of the "
        "arrow from B to D. A point P of the "
        f"coupler lies {number(point[0])} m from B along the coupler, towards C, and {number(point[1])} m to the left of it. Where is P, "
        "as $[x, y]$ from A?",
        figure=partial(draw_linkage, linkage, q, points=drawn),
        given={"bars": tuple(four_bar), "degrees": degrees, "along": point[0], "left": point[1]},
        answer=Numbers(carried(angle), unit="m"),
        mistakes=[
            mistake(
                "other mode", carried(other[0] + other[1]), "This is P in the other assembly mode, with C to the right."
            ),
            mistake(
                "mirror image",
                carried(angle) * (1, -1),
                "This is the mirror image of P in the ground line. Here the crank's angle is positive anticlockwise, so B is above "
                "the $x$ axis, and C is to the left of the arrow from B to D.",
            ),
            mistake(
                "relative angle",
                carried(q[1]),
                "You turned by $B$ alone. $B$ counts from the crank; from the $x$ axis the coupler stands at $A + B$.",
            ),
            mistake(
                "not turned",
                B + point,
                "You added P's coordinates without turning them: the coupler does not lie along $x$.",
            ),
            mistake(
                "to the right",
                carried(angle, point * (1, -1)),
                "P lies to the left of the way from B to C. You put it to the right.",
            ),
            mistake(
                "from C",
                carried(angle, point * (-1, 1) + (four_bar.coupler, 0)),
                "You measured from C. P's distance along the coupler counts from B.",
            ),
        ],
    )


@problem("08.4", "A slider-crank with an offset", points=2, lecture="08_closed_chains#A worked example")
def slider(sampler: ArmSampler) -> Problem:
    crank, rod, offset = (
        sampler.length(0.2, 0.35),
        sampler.length(0.6, 0.8),
        sampler.choice((-1, 1)) * sampler.length(0.1, 0.2),
    )
    degrees = sampler.choice((sampler.degrees(20, 70), sampler.degrees(110, 160)))  # near 90 the crank has no part in x
    A = np.radians(degrees)
    x = slider_position(crank, rod, offset, A)
    linkage = linkages.slider_crank(crank, rod, offset)
    side = "above" if offset > 0 else "below"
    return Problem(
        statement=f"A slider-crank has a crank of {number(crank)} m and a rod of {number(rod)} m. Its slide runs along $x$, "
        f"{number(abs(offset))} m {side} A. The crank stands at {degrees} degrees from the $x$ axis. Where is the slider "
        "along $x$, from A, on the far side of B? (Drawn before C is pinned.)",
        figure=partial(draw_linkage, linkage, np.array([A, -A, 1.1 * (crank + rod), 0.0])),
        given={"crank": crank, "rod": rod, "offset": offset, "degrees": degrees},
        answer=Numbers(np.array(x), unit="m"),
        mistakes=[
            mistake(
                "other mode",
                slider_position(crank, rod, offset, A, side=-1),
                "This is the other mode, the slider on the near side of B.",
            ),
            mistake("no offset", slider_position(crank, rod, 0.0, A), "You let the slide run through A."),
            mistake(
                "sign of the offset",
                slider_position(crank, rod, -offset, A),
                f"This is right for the mirror image, with the slide on the other side of A or the crank turned clockwise. Here the "
                f"slide runs {side} A, and the crank's angle is positive anticlockwise.",
            ),
            mistake(
                "flat rod",
                crank * np.cos(A) + rod,
                "You laid the rod along $x$. It climbs from B to the slide, so it reaches less far.",
            ),
            mistake(
                "crank from y",
                slider_position(crank, rod, offset, np.pi / 2 - A),
                "You measured the crank from the $y$ axis, or swapped sine and cosine.",
            ),
            mistake(
                "degrees",
                slider_position(crank, rod, offset, float(degrees)),
                "You gave degrees to a cosine that wants radians.",
            ),
        ],
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
    ground, crank, coupler, rocker = four_bar
    far = coupler + rocker
    A = four_bar.dead_point()
    return Problem(
        statement=f"{describe_lengths(four_bar)} Its crank cannot turn right round. What is the greatest angle $A$ "
        "from the $x$ axis, between $-\\pi$ and $\\pi$ and in radians, at which the loop still closes?",
        figure=partial(draw_linkage, linkages.four_bar(*four_bar), four_bar.assembly_modes(0.6 * A)[0]),
        given={"bars": tuple(four_bar)},
        answer=Angles(np.array(A)),
        mistakes=[
            mistake(
                "least angle",
                -A,
                "The sign is wrong: this is the dead point with the crank below the ground line, the mirror image of the other one. "
                "Between $-\\pi$ and $\\pi$ it is the least angle, not the greatest.",
            ),
            mistake(
                "supplement",
                np.pi - A,
                "This is the supplement. In the triangle A, B, D the angle at A is the crank's own.",
            ),
            mistake(
                "angle at B",
                _triangle_angle(crank, far, ground),
                "This is the angle at B of the triangle A, B, D. The crank's angle is the one at A, opposite the stretched bars.",
            ),
            mistake(
                "angle at D",
                _triangle_angle(ground, far, crank),
                "This is the angle at D of the triangle A, B, D. The crank's angle is the one at A.",
            ),
            mistake(
                "one bar only",
                np.arccos(np.clip(four_bar.cos_crank_angle(max(coupler, rocker)), -1, 1)),
                "You let one bar reach from B to D. At the dead point coupler and rocker lie in one line, end to end.",
            ),
            mistake("degrees", np.degrees(A), "Right, but in degrees. Joint values are in radians."),
        ],
    )


def _triangle_angle(one: float, two: float, opposite: float) -> float:
    """The angle, in radians, between two sides of a triangle, by the law of cosines."""
    return float(np.arccos((one**2 + two**2 - opposite**2) / (2 * one * two)))


JOINT_FREEDOMS_NOTE = "A pin and a slide have one freedom, a universal joint two, a ball joint three."


@problem("08.8", "Freedoms by counting", points=3, lecture="08_closed_chains#Counting freedoms")
def counting(sampler: ArmSampler) -> Problem:
    d, kinds = sampler.choice([(3, PLANAR_LEGS), (6, SPATIAL_LEGS), (6, SPATIAL_LEGS)])
    one, other = sampler.shuffled(kinds)[:2]
    legs = [one] * sampler.integer(1, 3) + [other] * sampler.integer(1, 3)
    f = [joint_freedoms for leg in legs for joint_freedoms in leg.joint_freedoms]
    N, J = 2 + sum(len(leg.joint_freedoms) - 1 for leg in legs), len(f)
    place = "in one plane" if d == 3 else "in space"
    counts = [f"{legs.count(leg)} with {leg.description}" for leg in (one, other)]
    right = d * (N - 1 - J) + sum(f)
    mistakes = [
        mistake(
            "ground not counted",
            right - d,
            f"You are $d = {d}$ too low. The ground is a body too, and the platform another: $N = {N}$. Or did you count one loop for each "
            "leg? The first leg closes none.",
        ),
        mistake(
            "d N",
            right + d,
            f"You are $d = {d}$ too high: the ground stands still, so {N - 1} bodies move, not {N}.",
        ),
        mistake(
            "the wrong d",
            (9 - d) * (N - 1 - J) + sum(f),
            f"You took $d = {9 - d}$. A body that moves {place} has {d} freedoms when it is free.",
        ),
        mistake("no loops", sum(f), "You added up the freedoms of the joints. Each loop takes $d$ of them away."),
        mistake(
            "neither ground nor platform",
            right - 2 * d,
            f"You are $2d = {2 * d}$ too low: the ground and the platform are bodies too, $N = {N}$.",
        ),
        *(
            [
                mistake(
                    "one loop",
                    sum(f) - d,
                    f"This is right for a single loop, in which $N = J$. Here $N = {N}$ bodies and $J = {J}$ joints are counted.",
                )
            ]
            if len(legs) > 2
            else []
        ),
        mistake(
            "freedoms taken away",
            d * (N - 1) - sum(f),
            f"This is $d\\,(N - 1)$ less the freedoms of the joints. A joint with $f$ freedoms takes $d - f$ away, not $f$: $d = {d}$.",
        ),
        mistake(
            "no freedoms of joints",
            d * (N - 1 - J),
            "This is $d\\,(N - 1 - J)$. The freedoms of the joints, $\\sum f$, are still to be added.",
        ),
    ]
    if d == 6:
        mistakes.append(
            mistake(
                "one freedom each",
                d * (N - 1 - J) + J,
                "You gave every joint one freedom. A universal joint has two, a ball joint three.",
            )
        )
        joints: dict[int, list[str]] = {}
        for name, freedoms in (("universal", 2), ("ball", 3)):
            if f.count(freedoms):
                joints.setdefault(f.count(freedoms), []).append(f"{name} joint, which has {freedoms} freedoms")
        mistakes += [
            mistake(f"{count} too low", right - count, f"You are one too low for each {', or for each '.join(names)}.")
            for count, names in joints.items()
        ]
    return Problem(
        statement=f"A platform moves {place}. It stands on {len(legs)} legs, {' and '.join(counts)}, each named from the ground to the "
        f"platform, with a body of its own between every two joints. {JOINT_FREEDOMS_NOTE} How many freedoms does Kutzbach's formula give?",
        given={"d": d, "legs": [leg.joint_freedoms for leg in legs]},
        answer=Numbers(np.array(float(right))),
        mistakes=mistakes,
    )


@problem("08.9", "Counted, felt, had", points=3, lecture="08_closed_chains#Where counting fails")
def three_mobilities(sampler: ArmSampler) -> Problem:
    case = overconstrained_case(sampler)
    linkage, loops = case.linkage, len(case.linkage.loops)
    mobility = linkage.mobility(case.q)
    counted, felt, rank = mobility.kutzbach, mobility.infinitesimal, linkage.n - mobility.infinitesimal
    d = (linkage.n - counted) // loops
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
        ],
    )


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
    [gap, both_modes, coupler_point, slider, which_mode, which_kind, dead_point, counting, three_mobilities],
)
