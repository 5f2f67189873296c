"""Tasks on the screw axes of any robot, in {s} and in {b}."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse, pose
from kincourse.expressions.screws import change_frame_of_rows, joint_screws, screw_axes
from kincourse.robot_sheets.sampling import random_aligned_base, random_arm, random_tilted_base, rebased
from kincourse.robot_sheets.task import task
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.chains.chain import Chain
from kinlib.view import draw_arm, draw_joints
from misstep.display.text import matrix
from misstep.problem import Problem

MAX_ASKED_JOINTS = 3
"""The maximum number of joints whose screw axes are asked for, because more joints would only repeat the same work."""

SCREWS = "screws", "Answer with screw axes $(\\omega, v)$ in rows, in the order of the joints."
SPACE_SCREWS_SOLUTION = "screws_{k} = kl.screw(given.axes, given.points, given.pitches)"
BODY_SCREWS_SOLUTION = "screws_{k} = given.screws @ kl.adjoint(kl.inverse(given.home)).T"


@task("Screw axes in your lab", 3, "03_poe_space#Screw axes from a drawing", SCREWS, SPACE_SCREWS_SOLUTION)
def space_screws(robot: Chain, sampler: ArmSampler) -> Problem:
    """Space screws from directions and points, for a base of the student's own."""
    # The screw of a prismatic joint depends on its direction only, and x, y, z are too few directions for a class.
    base = random_tilted_base if set(robot.joint_types) == {"P"} else random_aligned_base
    arm = rebased(robot, base(sampler, robot), np.eye(4))
    joints = _choose_joints(sampler, arm)
    axes, points, pitches = arm.lines.axis[joints], arm.joint_points[joints], arm.lines.pitch[joints]
    numbers = [i + 1 for i in joints]
    return Problem(
        statement=f"In your lab {robot.name} is mounted as in the drawing, which shows it at home. Give {_name_axes(joints)} "
        f"in {{s}}, as rows.\n\n{joint_table(arm, joints)}",
        figure=partial(draw_joints, arm),
        given={"axes": axes, "points": points, "pitches": pitches},
        answer=ScrewsAnswer(arm.screws[joints], names=[f"screw {i}" for i in numbers]),
        solution=joint_screws(axes, points, pitches, numbers),
        advice={"sign of a vector": "The arrows show the positive direction."},
    ).without_duplicates()


@task("The same axes in the tool frame", 3, "04_poe_body#The adjoint", SCREWS, BODY_SCREWS_SOLUTION)
def body_screws(robot: Chain, sampler: ArmSampler) -> Problem:
    """Body screws by the adjoint, for a base and a tool of the student's own."""
    arm = random_arm(sampler, robot)
    joints = _choose_joints(sampler, arm)
    S = arm.screws[joints]
    return Problem(
        statement=f"Below are {_name_axes(joints)} of {robot.name} in {{s}}, and the home pose of its tool. Give "
        f"the same screw axes in {{b}}, as rows.\n\n$$S = {matrix(S)}$$\n\n$$M = {matrix(arm.home)}$$",
        figure=partial(draw_arm, arm),
        given={"screws": S, "home": arm.home},
        answer=ScrewsAnswer(arm.body_screws[joints], names=[f"screw {i + 1}" for i in joints]),
        solution=change_frame_of_rows(inverse(pose("M", arm.home)), screw_axes("S", S)),
        advice={
            "inverse left out": "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here.",
            "frame not changed": "These are the space screws; {b} has another origin and other axes.",
        },
    ).without_duplicates()


def _choose_joints(sampler: ArmSampler, arm: Chain) -> list[int]:
    """Choose a few joints, counted from 0 and in ascending order: at least one of each type."""
    kinds = [
        sampler.choice([i for i, other in enumerate(arm.joint_types) if other == kind])
        for kind in sorted(set(arm.joint_types))
    ]
    others = [i for i in sampler.shuffled(range(arm.n)) if i not in kinds]
    return sorted([*kinds, *others][: min(MAX_ASKED_JOINTS, arm.n)])


def _name_axes(joints: Sequence[int]) -> str:
    """Name the screw axes of some joints, counted from 0, in words.

    >>> _name_axes([0]), _name_axes([0, 2, 3])
    ('the screw axis of joint 1', 'the screw axes of joints 1, 3 and 4')
    """
    numbers = [str(i + 1) for i in joints]
    if len(numbers) == 1:
        return f"the screw axis of joint {numbers[0]}"
    return f"the screw axes of joints {', '.join(numbers[:-1])} and {numbers[-1]}"
