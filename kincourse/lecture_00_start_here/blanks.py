"""The blank steps of lecture 00: the position of the end-effector at home, and a configuration in radians."""

import numpy as np

from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import youbot
from misstep.answers.number import Numbers
from misstep.mutants.expression import as_expression, given
from misstep.mutants.operations import stack


@problem(
    "00.a", "The position of the end-effector at home", points=1, lecture="00_start_here#A wrong answer, on purpose"
)
def end_effector_at_home(_draw: ArmSampler) -> Problem:
    shoulder, upper_arm, forearm, end_effector, height = (
        as_expression(x) for x in (0.033, 0.155, 0.135, 0.2175, 0.147)
    )
    height = height.mistaken_for(
        ("height left out", "leave out the height", 0, "At home the arm is 0.147 m above the origin of {s}.")
    )
    reach = shoulder + upper_arm + forearm + end_effector
    upright = stack(shoulder, 0, height + upper_arm + forearm + end_effector)
    return Problem(
        statement="Give the position $(x, y, z)$ of the end-effector at home, in {s} and in metres.",
        answer=Numbers(youbot().home[:3, 3], unit="m"),
        solution=stack(reach, 0, height).mistaken_for(("upright", "take the arm as upright at home", upright)),
        advice={
            "upright": "Here the arm is stretched out horizontally at home. Home is a choice, and other descriptions choose an "
            "upright arm.",
            "leave out $0.033$": "The origin of {s} is on the axis of joint 1, and the axis of joint 2 is 0.033 m in front of it.",
            "leave out $0.2175$": "The end-effector frame {b} is 0.2175 m beyond joint 4: it is the last of the four lengths.",
            "swap entries 2 and 3": "In {s}, $z$ points up, not $y$ as on a screen. In the figure, each axis has its letter at the tip.",
        },
    )


POSITIVE_ROTATION = "A rotation has a sense: it is positive if it is counterclockwise when the axis points towards you."


@problem("00.b", "A configuration in radians", points=1, lecture="00_start_here#Degrees and radians")
def configuration_in_radians(_draw: ArmSampler) -> Problem:
    degrees = np.array([0, 60, 0, -120, 45])
    q = given("q", np.radians(degrees))
    offset = "The DH table needs it, but here the home pose and the screw axes already describe the straight arm."
    return Problem(
        statement="Joints 2, 4 and 5 are at 60, -120 and 45 degrees, and joints 1 and 3 at 0. Give the five joint values for `arm.fk`.",
        answer=Numbers(q.value, unit="rad"),
        solution=q.mistaken_for(
            ("signs left out", "leave out the minus signs", np.abs(q.value), POSITIVE_ROTATION),
            ("offset added", "add the offset of the DH table to joint 4", q.value + np.array([0, 0, 0, np.pi / 2, 0])),
            ("turns", "give fractions of a full turn", degrees / 360),
            ("degrees", "give degrees", degrees, "`arm.fk` takes the numbers as radians, and reports no error."),
        ),
        advice={"offset added": offset, "turns": "A full turn is $2\\pi$ radians, so 90 degrees are $\\pi/2$."},
    )
