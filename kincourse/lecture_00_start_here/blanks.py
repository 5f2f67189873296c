"""The blank steps of lecture 00: the position of the end-effector at home, and a configuration in radians."""

import numpy as np

from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.chains.robots import youbot
from misstep.answers.number import Numbers
from misstep.mutants.expression import as_expression, given
from misstep.mutants.operations import stack
from misstep.problem import Problem


@problem("00.a", "Where the hand is at home", points=1, lecture="00_start_here#A wrong answer, on purpose")
def end_effector_at_home(_draw: ArmSampler) -> Problem:
    shoulder, upper_arm, forearm, end_effector, height = (
        as_expression(x) for x in (0.033, 0.155, 0.135, 0.2175, 0.147)
    )
    height = height.mistaken_for(
        0, "height left out", "leave out the height", "The whole arm lies 0.147 m above the origin of {s}."
    )
    reach = shoulder + upper_arm + forearm + end_effector
    upright = stack(shoulder, 0, height + upper_arm + forearm + end_effector)
    return Problem(
        statement="Give the hand's position $(x, y, z)$ at home, in {s} and in metres.",
        answer=Numbers(youbot().home[:3, 3], unit="metres"),
        solution=stack(reach, 0, height).mistaken_for(
            upright,
            "upright",
            "take the arm as upright, as many robots are at home",
            "This one lies stretched out: home is what its makers chose.",
        ),
        advice={
            "leave out $0.033$": "Joint 2 is not above joint 1 but 0.033 m in front of it, and {s} is below joint 1.",
            "leave out $0.2175$": "The hand is 0.2175 m beyond the wrist: the last length of the deck's table.",
            "swap entries 2 and 3": "Here $z$ points up, not $y$ as on a screen: look for the letter at the tip of the arrow.",
        },
    )


POSITIVE_ROTATION = "A rotation has a sense: positive is counterclockwise when the axis points at you."


@problem("00.b", "A posture in radians", points=1, lecture="00_start_here#Degrees and radians")
def configuration_in_radians(_draw: ArmSampler) -> Problem:
    degrees = np.array([0, 0, 90, -90, -45])
    q = given("q", np.radians(degrees))
    offset = "Its table needs that; our home pose holds it already."
    return Problem(
        statement="Joints 3, 4 and 5 stand at 90, -90 and -45 degrees, the others at 0. Give the five joint values for `arm.fk`.",
        answer=Numbers(q.value, unit="radians"),
        solution=q.mistaken_for(np.abs(q.value), "signs left out", "leave out the minus signs", POSITIVE_ROTATION)
        .mistaken_for(
            q.value + np.array([0, 0, 0, np.pi / 2, 0]),
            "offset added",
            "add the deck's offset of pi/2 to joint 4",
            offset,
        )
        .mistaken_for(
            degrees / 360,
            "turns",
            "give fractions of a full turn",
            "A full turn is 2 pi radians, so 90 degrees are pi/2.",
        )
        .mistaken_for(degrees, "degrees", "give degrees", "`arm.fk` takes them as radians and reports no error."),
    )


BLANKS = [end_effector_at_home, configuration_in_radians]
