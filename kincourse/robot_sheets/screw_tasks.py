"""Tasks on the screw axes of any robot: in {s}, in {b}, in the frame of a new tool, and from {b} back to {s}."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse, pose
from kincourse.expressions.screws import change_frame, joint_screws, screw_axes
from kincourse.robot_sheets.sampling import random_aligned_base, random_arm, random_tilted_base, random_tool, rebased
from kincourse.robot_sheets.task import RobotTask, add_task
from kincourse.sampling.arms import ArmSampler
from kincourse.text.joint_table import joint_table
from kinlib.chains.chain import Chain
from kinlib.view import draw_arm, draw_joints
from misstep.display.text import matrix
from misstep.problem import Problem

MAX_ASKED_JOINTS = 3
"""The maximum number of joints whose screw axes are asked for, because more joints would only repeat the same work."""

ANSWER_NOTE = "Answer with screw axes $(\\omega, v)$ in rows, in the order of the joints."

SCREW_TASKS: dict[str, RobotTask] = {}
"""The tasks by name. The file of a robot sheet stores these names, so a name must not change."""

task = partial(add_task, SCREW_TASKS)


@task(
    *("Screw axes in your lab", 3, "03_poe_space#Screw axes from a drawing"),
    *("screws", ANSWER_NOTE, "screws_{k} = kl.screw(given.axes, given.points, given.pitches)"),
)
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


@task(
    *("The same axes in the tool frame", 3, "04_poe_body#The adjoint"),
    *("screws", ANSWER_NOTE, "screws_{k} = given.screws @ kl.adjoint(kl.inverse(given.home)).T"),
)
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
        solution=change_frame(inverse(pose("M", arm.home)), screw_axes("S", S)),
        advice={
            "inverse left out": "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here.",
            "frame not changed": "These are the space screws; {b} has another origin and other axes.",
        },
    ).without_duplicates()


@task(
    *("Back to {s}", 2, "04_poe_body#The adjoint"),
    *("screws", ANSWER_NOTE, "screws_{k} = given.body_screws @ kl.adjoint(given.home).T"),
)
def back_to_space(robot: Chain, sampler: ArmSampler) -> Problem:
    """Space screws from body screws."""
    arm = random_arm(sampler, robot)
    joints = _choose_joints(sampler, arm)
    B = arm.body_screws[joints]
    return Problem(
        statement=f"A colleague gives {_name_axes(joints)} of {robot.name} in the frame {{b}} of its tool. Give them in {{s}}, as rows."
        f"\n\n$$B = {matrix(B)}$$\n\n$$M = {matrix(arm.home)}$$",
        figure=partial(draw_arm, arm),
        given={"body_screws": B, "home": arm.home},
        answer=ScrewsAnswer(arm.screws[joints], names=[f"screw {i + 1}" for i in joints]),
        solution=change_frame(pose("M", arm.home), screw_axes("B", B)),
        advice={
            "inverse": "$\\mathrm{Ad}_{M^{-1}}$ takes screws in {s} to screws in {b}; you need $\\mathrm{Ad}_M$ here.",
            "frame not changed": "These are the body screws.",
        },
    ).without_duplicates()


@task(
    *("A new tool", 2, "04_poe_body#Check yourself"),
    *("screws", ANSWER_NOTE, "screws_{k} = given.body_screws @ kl.adjoint(kl.inverse(given.T_bt)).T"),
)
def new_tool(robot: Chain, sampler: ArmSampler) -> Problem:
    """Body screws after the tool was replaced."""
    arm = random_arm(sampler, robot)
    joints, H = _choose_joints(sampler, arm), random_tool(sampler, robot)
    B = arm.body_screws[joints]
    new = change_frame(inverse(pose("T_{bt}", H)), screw_axes("B", B)).mistaken_for(
        ("space screws", "give the space screws", arm.screws[joints], "They are screws in {s} and not in {t}.")
    )
    return Problem(
        statement=f"The tool of {robot.name} is replaced. The frame {{t}} of the new tool has the pose $T_{{bt}}$ in the frame "
        f"{{b}} of the old one. Below are {_name_axes(joints)} in {{b}}. Give the same screw axes in {{t}}, as rows.\n\n"
        f"$$B = {matrix(B)}$$\n\n$$T_{{bt}} = {matrix(H)}$$",
        figure=partial(draw_arm, arm),
        given={"body_screws": B, "T_bt": H},
        answer=ScrewsAnswer(new.value, names=[f"screw {i + 1}" for i in joints]),
        solution=new,
        advice={
            "inverse left out": "$\\mathrm{Ad}_{T_{bt}}$ takes screws in {t} to screws in {b}; here you need the opposite direction.",
            "frame not changed": "The axes stay, but body screws are given in the tool frame, which is {t} now.",
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
