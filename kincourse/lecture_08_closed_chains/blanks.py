"""The blank steps of lecture 08: the position of a slider, a rocker angle in one mode, and a number of degrees of freedom."""

from kincourse.expressions.planar import (
    bars,
    coupler_directions,
    length,
    rocker_directions,
    slider_place,
    with_other_bars,
)
from kincourse.problem import ArmSampler, Problem, problem
from misstep.answers.angle import Angles
from misstep.answers.number import Numbers
from misstep.mutants.expression import given
from misstep.mutants.operations import ANGLE, LENGTH, radians


@problem("08.a", "Where the slider is", points=1, lecture="08_closed_chains#A worked example")
def slider(_draw: ArmSampler) -> Problem:
    A = radians(given("A", 150.0, ANGLE))
    x = slider_place(length("crank", 0.2), length("rod", 0.5), length("offset", -0.1, LENGTH), A)
    return Problem(
        statement="A slider-crank has a crank of 0.2 m, a rod of 0.5 m, and a slider on the line $y = -0.1$. The crank angle is 150 "
        "degrees. What is the x coordinate of the slider, in the assembly mode with the slider to the right of the pin B?",
        answer=Numbers(x, unit="m"),
        advice={
            "leave out $\\mathrm{offset}$": "The rod connects the pin B with the line $y = -0.1$, not with $y = 0$.",
            "sign of a length": "The offset is negative, because the slider moves below the x axis.",
            "sine and cosine swapped": "At 0 degrees the crank lies along x.",
        },
    )


@problem("08.b", "A rocker angle", points=1, lecture="08_closed_chains#The smallest loop")
def rocker(_draw: ArmSampler) -> Problem:
    A = radians(given("A", 90.0, ANGLE))
    lengths = bars([0.4, 0.1, 0.35, 0.3])
    D = with_other_bars(lambda four: rocker_directions(four, A)[0], lengths)
    D = D.mistaken_for(
        ("other mode", "take the other mode, with C below", rocker_directions(lengths, A)[1]),
        ("coupler's angle", "give the coupler's angle from the x axis", coupler_directions(lengths, A)[0]),
    )
    return Problem(
        statement="The crank angle of the lecture's first four-bar is 90 degrees. What is the rocker's angle $D$, in radians, in the "
        "assembly mode with C above the $x$ axis?",
        answer=Angles(D),
        advice={
            "other mode": "Both modes close the loop, so check where C is.",
            "coupler's angle": "The rocker's angle is the angle at D.",
            "lengths swapped": "The radius of the circle about B is the length of the coupler.",
        },
    )


@problem("08.c", "Mobility by counting", points=1, lecture="08_closed_chains#The Gruebler-Kutzbach formula")
def count(_draw: ArmSampler) -> Problem:
    d = given("d", 3.0).mistaken_for(("another d", "take $d = 6$", 6.0))
    bodies = given("N", 8.0).mistaken_for(
        ("bodies", "leave out the ground or the platform", 7.0),
        ("bodies", "leave out both the ground and the platform", 6.0),
    )
    joints = given("\\sum f", 9.0)
    mobility = (d * (bodies - 1 - given("J", 9.0)) + joints).mistaken_for(
        ("loops", "add up the degrees of freedom of the joints, without the equations of the loops", joints),
        ("loops", "close one loop only", 6.0),
        may_coincide=True,
    )
    return Problem(
        statement="Which mobility does the Gruebler-Kutzbach formula give for the planar 3-RRR robot?",
        answer=Numbers(mobility),
        advice={
            "bodies": "The ground is a body too, so $N = 8$. The formula subtracts it itself, in $N - 1$.",
            "another d": "A body in the plane has $d = 3$ degrees of freedom, and a revolute joint leaves one of them.",
            "loops": "Nine joints and eight bodies give $J - N + 1 = 2$ loops: three arms meet in one platform.",
        },
    )
