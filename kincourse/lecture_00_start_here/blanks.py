"""The blank steps of lecture 00: the position of the end-effector at home, and a configuration in radians."""

import numpy as np

from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import youbot
from misstep.answers.number import Numbers
from misstep.mistakes import mistake
from misstep.problem import Problem


@problem("00.a", "Where the hand is at home", points=1, lecture="00_start_here#A wrong answer, on purpose")
def end_effector_at_home(_draw: ArmSampler) -> Problem:
    shoulder, upper_arm, forearm, end_effector, height = 0.033, 0.155, 0.135, 0.2175, 0.147
    return Problem(
        statement="Give the hand's position $(x, y, z)$ at home, in {s} and in metres.",
        answer=Numbers(youbot().home[:3, 3], unit="metres"),
        mistakes=[
            mistake(
                "no shoulder",
                np.array([upper_arm + forearm + end_effector, 0, height]),
                "You left out the shoulder. Joint 2 does not stand above joint 1 but 0.033 m in front of it, and {s} is below joint 1.",
            ),
            mistake(
                "no hand",
                np.array([shoulder + upper_arm + forearm, 0, height]),
                "You stopped at the wrist. The hand is 0.2175 m further: the last length of the deck's table.",
            ),
            mistake(
                "on the floor",
                np.array([shoulder + upper_arm + forearm + end_effector, 0, 0]),
                "You left out the height. The whole arm lies 0.147 m above the origin of {s}.",
            ),
            mistake(
                "upright",
                np.array([shoulder, 0, height + upper_arm + forearm + end_effector]),
                "You stood the arm up, as many robots stand at home. This one lies stretched out: home is what its makers chose.",
            ),
            mistake(
                "y is up",
                np.array([shoulder + upper_arm + forearm + end_effector, height, 0]),
                "You wrote the height as $y$, as on a screen. Here $z$ points up: look for the letter at the tip of the arrow.",
            ),
            mistake(
                "millimetres",
                np.array([1000 * (shoulder + upper_arm + forearm + end_effector), 0, 1000 * height]),
                "You answered in millimetres. Lengths are metres here, everywhere.",
            ),
        ],
    )


@problem("00.b", "A posture in radians", points=1, lecture="00_start_here#Degrees and radians")
def configuration_in_radians(_draw: ArmSampler) -> Problem:
    degrees = np.array([0, 0, 90, -90, -45])
    configuration, offset = np.radians(degrees), np.array([0, 0, 0, np.pi / 2, 0])
    return Problem(
        statement="Joints 3, 4 and 5 stand at 90, -90 and -45 degrees, the others at 0. Give the five joint values for `arm.fk`.",
        answer=Numbers(configuration, unit="radians"),
        mistakes=[
            mistake(
                "degrees",
                degrees,
                "These are degrees. `arm.fk` takes them as radians and reports no error, for 90 radians are a turn like any other.",
            ),
            mistake(
                "signs lost",
                np.abs(configuration),
                "You lost the minus signs. A turn has a sense: positive is counterclockwise when the axis points at you.",
            ),
            mistake(
                "offset added",
                configuration + offset,
                "You added the deck's offset of pi/2 to joint 4. Its table needs that; our home pose holds it already.",
            ),
            mistake(
                "divided by 360",
                degrees / 360,
                "You gave fractions of a full turn. A full turn is 2 pi radians, so 90 degrees are pi/2.",
            ),
        ],
    )


BLANKS = [end_effector_at_home, configuration_in_radians]
