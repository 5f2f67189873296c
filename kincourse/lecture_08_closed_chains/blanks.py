"""The blank steps of lecture 08: the position of a slider, a rocker angle in one mode, and a number of degrees of freedom."""

import numpy as np

from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.four_bar_geometry import FourBar, slider_position
from misstep.answers.angle import Angles
from misstep.answers.number import Numbers
from misstep.mistakes import mistake
from misstep.problem import Problem


@problem("08.a", "Where the slider is", points=1, lecture="08_closed_chains#A worked example")
def slider(_draw: ArmSampler) -> Problem:
    crank, rod, offset, A = 0.2, 0.5, -0.1, np.radians(150)
    return Problem(
        statement="A slider-crank has a crank of 0.2 m, a rod of 0.5 m, and its slide on the line $y = -0.1$. The crank stands at "
        "150 degrees. Where is the slider along x, on the far side of the crank pin?",
        answer=Numbers(np.array(slider_position(crank, rod, offset, A)), unit="m"),
        mistakes=[
            mistake(
                "other mode",
                slider_position(crank, rod, offset, A, side=-1),
                "This is the other assembly mode, with the slider on the near side of B. Take the root with the plus sign.",
            ),
            mistake(
                "no offset",
                slider_position(crank, rod, 0.0, A),
                "You left out the offset. The rod has to climb from the crank pin to the line $y = -0.1$, not to $y = 0$.",
            ),
            mistake(
                "sign of the offset",
                slider_position(crank, rod, -offset, A),
                "The offset is negative: the slide lies below the x axis.",
            ),
            mistake(
                "degrees",
                slider_position(crank, rod, offset, 150.0),
                "You gave degrees to a cosine that wants radians.",
            ),
            mistake(
                "sine and cosine swapped",
                slider_position(crank, rod, offset, np.pi / 2 - A),
                "You swapped sine and cosine of the crank's angle. At 0 degrees the crank lies along x.",
            ),
        ],
    )


@problem("08.b", "A rocker angle", points=1, lecture="08_closed_chains#The smallest loop")
def rocker(_draw: ArmSampler) -> Problem:
    four_bar, A = FourBar(0.4, 0.1, 0.35, 0.3), np.pi / 2
    above, below = four_bar.assembly_modes(A)
    swapped = FourBar(0.4, 0.1, 0.3, 0.35).assembly_modes(A)[0, 2]
    return Problem(
        statement="The crank of the lecture's four-bar stands at 90 degrees. What is the rocker's angle $D$, in radians, in the mode "
        "that has C above?",
        answer=Angles(np.array(above[2])),
        mistakes=[
            mistake(
                "other mode", below[2], "This is the other mode, with C below. Both close the loop; look at where C is."
            ),
            mistake("degrees", np.degrees(above[2]), "Right, but in degrees. Joint values are in radians."),
            mistake(
                "inner angle",
                np.pi - above[2],
                "This is the inner angle of the quadrilateral at D. The joint value counts from the x axis, anticlockwise.",
            ),
            mistake(
                "coupler and rocker swapped",
                swapped,
                "You swapped coupler and rocker: the circle about B has the coupler's radius.",
            ),
            mistake(
                "coupler", (above[0] + above[1]), "This is the coupler's angle from the x axis. The rocker hangs at D."
            ),
        ],
    )


@problem("08.c", "Freedoms by counting", points=1, lecture="08_closed_chains#Counting freedoms")
def count(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="How many freedoms does Kutzbach's formula give the planar 3-RRR robot?",
        answer=Numbers(np.array(3.0)),
        mistakes=[
            mistake(
                "ground not counted",
                0.0,
                "You counted 7 bodies. The ground is a body too: $N = 8$. The formula takes it away by itself, in $N - 1$.",
            ),
            mistake(
                "in space",
                -12.0,
                "You took $d = 6$. A body that stays in a plane has three freedoms, and a pin takes two of them.",
            ),
            mistake(
                "only the joints",
                9.0,
                "You added up the freedoms of the joints. Each of the two loops takes three of them away.",
            ),
            mistake(
                "one loop",
                6.0,
                "You closed one loop. Nine joints and eight bodies make $J - N + 1 = 2$ loops: three arms meet in one platform.",
            ),
        ],
    )


BLANKS = [slider, rocker, count]
