"""The blank steps of lecture 08: the position of a slider, a rocker angle in one mode, and a number of degrees of freedom."""

import numpy as np

from kincourse.expressions.planar import (
    bars,
    coupler_directions,
    kutzbach,
    length,
    rocker_directions,
    slider_place,
    with_other_bars,
)
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from misstep.answers.angle import Angles
from misstep.answers.number import Numbers
from misstep.mutants.expression import given
from misstep.mutants.operations import ANGLE, LENGTH, radians
from misstep.problem import Problem


@problem("08.a", "Where the slider is", points=1, lecture="08_closed_chains#A worked example")
def slider(_draw: ArmSampler) -> Problem:
    A = radians(given("A", 150.0, ANGLE))
    x = slider_place(length("crank", 0.2), length("rod", 0.5), length("offset", -0.1, LENGTH), A)
    return Problem(
        statement="A slider-crank has a crank of 0.2 m, a rod of 0.5 m, and its slide on the line $y = -0.1$. The crank stands at "
        "150 degrees. Where is the slider along x, on the far side of the crank pin?",
        answer=Numbers(np.array(x.value), unit="m"),
        solution=x,
        advice={
            "leave out $\\mathrm{offset}$": "The rod has to climb from the crank pin to the line $y = -0.1$, not to $y = 0$.",
            "sign of a length": "The offset is negative: the slide lies below the x axis.",
            "sine and cosine swapped": "At 0 degrees the crank lies along x.",
        },
    )


@problem("08.b", "A rocker angle", points=1, lecture="08_closed_chains#The smallest loop")
def rocker(_draw: ArmSampler) -> Problem:
    A = radians(given("A", 90.0, ANGLE))
    lengths = bars([0.4, 0.1, 0.35, 0.3])
    D = with_other_bars(lambda four: rocker_directions(four, A)[0], lengths)
    for name, text, wrong in (
        ("other mode", "take the other mode, with C below", rocker_directions(lengths, A)[1]),
        ("coupler's angle", "give the coupler's angle from the x axis", coupler_directions(lengths, A)[0]),
    ):
        D = D.mistaken_for(wrong, name, text)
    return Problem(
        statement="The crank of the lecture's four-bar stands at 90 degrees. What is the rocker's angle $D$, in radians, in the mode "
        "that has C above?",
        answer=Angles(np.array(D.value)),
        solution=D,
        advice={
            "other mode": "Both close the loop; look at where C is.",
            "coupler's angle": "The rocker's angle is at D.",
            "lengths swapped": "The circle about B has the coupler's radius.",
        },
    )


@problem("08.c", "Freedoms by counting", points=1, lecture="08_closed_chains#Counting freedoms")
def count(_draw: ArmSampler) -> Problem:
    mobility = kutzbach(3, [(1, 1, 1)] * 3)
    return Problem(
        statement="How many freedoms does Kutzbach's formula give the planar 3-RRR robot?",
        answer=Numbers(np.array(mobility.value)),
        solution=mobility,
        invisible=["leg left out", "platform alone"],  # a leg of three pins takes no freedom away
        advice={
            "bodies": "The ground is a body too: $N = 8$. The formula takes it away by itself, in $N - 1$.",
            "another d": "A body that stays in a plane has three degrees of freedom, and a pin takes two of them.",
            "loops": "Nine joints and eight bodies make $J - N + 1 = 2$ loops: three arms meet in one platform.",
        },
    )


BLANKS = [slider, rocker, count]
