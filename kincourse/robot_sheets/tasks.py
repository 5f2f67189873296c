"""The tasks of a sheet for any robot: its home pose, screw axes in {s} and in {b}, its forward kinematics, and its DH tables.

For a table the zero configuration is the student's own, so that the offsets are their own too. The first and the last frame are
given, and every choice that the rules leave open between them is right.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from kincourse.answers.dh_table import DHTableAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse, pose, with_position
from kincourse.expressions.screws import (
    change_frame_of_rows,
    exponentials,
    forward_kinematics,
    joint_screws,
    joint_values,
    screw_axes,
)
from kincourse.mistakes.dh import rows_of_the_other_convention
from kincourse.robot_sheets.sampling import (
    random_aligned_base,
    random_arm,
    random_configuration,
    random_tilted_base,
    random_tool,
    rebased,
    truncated,
    with_zero_at,
)
from kincourse.sampling.arms import ArmSampler, shows_transposes
from kincourse.text.joint_table import end_frames, given_frames, joint_table, rows_from_frames
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.table import Convention
from kinlib.view import draw_arm, draw_frames, draw_joints
from misstep.display.text import matrix
from misstep.problem import Problem
from misstep.release.instructor_notebook import Entry

MAX_ASKED_JOINTS = 3
"""The maximum number of joints whose screw axes are asked for, because more joints would only repeat the same work."""

MAX_ROWS = 7
"""The maximum number of rows of a table. A robot with more joints is cut off after this joint."""

POSE = "Answer with a pose, an array of shape (4, 4)."
SCREWS = "Answer with screw axes $(\\omega, v)$ in rows, in the order of the joints."
TABLE = "Answer with a table: text with the header `a | alpha | d | theta`, a row for each joint, and `q1`, `q2`, ...; angles as `90°`."

SPACE_FORM_SOLUTION = """\
turns = given.screws[:, :3].any(axis=1)
q = np.where(turns, np.radians(given.values), given.values)
pose_{k} = kl.Chain(given.screws, given.home).fk(q)"""

TABLE_SOLUTION = """\
arm = kl.Chain(given.screws, given.home, given.points)
table_{k} = kl.assign_frames(arm, convention="standard").table
"""


def home_pose(robot: Chain, sampler: ArmSampler) -> Problem:
    """The home pose of the robot with another base and a tool on its flange."""
    T_sr, T_rf, T_fb = random_tilted_base(sampler, robot), robot.home, random_tool(sampler, robot)
    while not shows_transposes(rebased(robot, T_sr, T_fb)):
        T_sr, T_fb = random_tilted_base(sampler, robot), random_tool(sampler, robot)
    M = pose("T_{sr}", T_sr) @ pose("T_{rf}", T_rf) @ pose("T_{fb}", T_fb)
    unrotated = with_position(M.value, T_sr[:3, 3] + T_rf[:3, 3] + T_fb[:3, 3])
    M = M.mistaken_for(("positions added", "add the positions without rotating them", unrotated))
    return Problem(
        statement=f"In its file, {robot.name} has a base frame {{r}} and a flange with the frame {{f}}, whose pose at $q = 0$ is "
        "$T_{rf}$. In your lab its base has the pose $T_{sr}$. A tool with the frame {b} is mounted on the flange at $T_{fb}$. Give the "
        "home pose $M = T_{sb}(0)$.\n\n"
        f"$$T_{{sr}} = {matrix(T_sr)}$$\n\n$$T_{{rf}} = {matrix(T_rf)}$$\n\n$$T_{{fb}} = {matrix(T_fb)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "r": T_sr, "f": T_sr @ T_rf}),
        further="The tool is replaced by a longer one. Which blocks of $M$ change?",
        given={"T_sr": T_sr, "T_rf": T_rf, "T_fb": T_fb},
        answer=PoseAnswer(M),
        advice={
            "leave out $T_{sr}$": "This is the pose of the tool in {r}: $T_{sr}$ must be the first factor.",
            "leave out $T_{fb}$": "This is the pose of the flange: $T_{fb}$ must be the last factor.",
            "reversed": "$T_{sr}\\,T_{rf}\\,T_{fb}$: neighbouring letters cancel.",
        },
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
        further="The base is moved by 1 m along $x$ of {s}. Which of your numbers change?",
        given={"axes": axes, "points": points, "pitches": pitches},
        answer=ScrewsAnswer(arm.screws[joints], names=[f"screw {i}" for i in numbers]),
        solution=joint_screws(axes, points, pitches, numbers),
        advice={"sign of a vector": "The arrows show the positive direction."},
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
        further="Which of these screws would stay the same with a tool that is longer along its $z$?",
        given={"screws": S, "home": arm.home},
        answer=ScrewsAnswer(arm.body_screws[joints], names=[f"screw {i + 1}" for i in joints]),
        solution=change_frame_of_rows(inverse(pose("M", arm.home)), screw_axes("S", S)),
        advice={
            "inverse left out": "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here.",
            "frame not changed": "These are the space screws; {b} has another origin and other axes.",
        },
    )


def _choose_joints(sampler: ArmSampler, arm: Chain) -> list[int]:
    """Choose a few joints, counted from 0 and in ascending order: at least one of each type."""
    kinds = [
        sampler.choice([i for i, other in enumerate(arm.joint_types) if other == kind])
        for kind in sorted(set(arm.joint_types))
    ]
    others = [i for i in sampler.shuffled(range(arm.n)) if i not in kinds]
    return sorted([*kinds, *others][: min(MAX_ASKED_JOINTS, arm.n)])


def _name_axes(joints: Sequence[int]) -> str:
    """Name the screw axes of some joints, counted from 0, in words."""
    *others, last = (str(i + 1) for i in joints)
    return f"the screw axes of joints {', '.join(others)} and {last}" if others else f"the screw axis of joint {last}"


def where_is_the_tool(robot: Chain, sampler: ArmSampler) -> Problem:
    """Forward kinematics by the space form, at a configuration within the joint limits."""
    arm = random_arm(sampler, robot)
    at = random_configuration(sampler, arm)
    return Problem(
        statement=f"The joint values of {robot.name} are {at.words}. Its screws in {{s}} and the home pose of its tool are below. Give "
        f"$T(q)$.\n\n$$S = {matrix(arm.screws)}$$\n\n$$M = {matrix(arm.home)}$$",
        figure=partial(draw_arm, arm),
        further="Write the same pose with body screws. Which factor stays as it is?",
        given={"screws": arm.screws, "home": arm.home, "values": at.typed},
        answer=PoseAnswer(arm.fk(at.q)),
        solution=forward_kinematics(
            exponentials(arm.screws, joint_values(arm.joint_types, at.typed)), pose("M", arm.home)
        ).named("T"),
        advice={
            "reversed": "The factor of the joint at the base is to the left of all others, because this joint moves all others.",
            "first factor": "With space screws $M$ is the last factor.",
        },
    )


def dh_table(convention: Convention, robot: Chain, sampler: ArmSampler) -> Problem:
    """The table in a convention between two given frames."""
    part = truncated(robot, MAX_ROWS)
    at = random_configuration(sampler, part, quarters=True)
    arm = rebased(with_zero_at(part, at.q), random_aligned_base(sampler, robot), np.eye(4))
    cut = f", up to joint {MAX_ROWS}," if part.n < robot.n else ""
    table = assign_frames(arm, convention=convention).table.changed(name=arm.name)
    return Problem(
        statement=f"{robot.name}{cut} is drawn with its joints at {at.words}; let $q = 0$ in this configuration. Write its table in the "
        f"{convention} convention. Each $q_i$ is positive about or along the direction of its joint. The poses of frame 0 and frame "
        f"{table.n} in {{s}} are given. Where the rules leave a choice, it is yours: every table that fits is right. "
        f"\n\n{joint_table(arm)}\n\n{given_frames(table)}",
        figure=partial(draw_joints, arm),
        method=rows_from_frames(table),
        further="Where did the rules leave you a choice? Write a second table with other choices.",
        given={"screws": arm.screws, "points": arm.joint_points, "home": arm.home, **end_frames(table)},
        answer=DHTableAnswer(table, anchored=True),
        mistakes=[rows_of_the_other_convention(table)],
    ).without_duplicates()


class RobotTask(NamedTuple):
    """A problem whose robot is not chosen yet, and its cells in the instructor's notebook.

    lecture  where to re-read, notebook and heading
    write    the function that writes the problem of a robot with a student's numbers
    entry    the cells; {k} in its solution stands for the number of the problem
    """

    title: str
    points: int
    lecture: str
    write: Callable[[Chain, ArmSampler], Problem]
    entry: Entry


TASKS = (
    RobotTask(
        *("The home pose in your lab", 2, "03_poe_space#The home pose", home_pose),
        Entry("pose", POSE, "pose_{k} = given.T_sr @ given.T_rf @ given.T_fb"),
    ),
    RobotTask(
        *("Screw axes in your lab", 3, "03_poe_space#Screw axes from a drawing", space_screws),
        Entry("screws", SCREWS, "screws_{k} = kl.screw(given.axes, given.points, given.pitches)"),
    ),
    RobotTask(
        *("The same axes in the tool frame", 3, "04_poe_body#The adjoint", body_screws),
        Entry("screws", SCREWS, "screws_{k} = given.screws @ kl.adjoint(kl.inverse(given.home)).T"),
    ),
    RobotTask(
        *("Where is the tool?", 3, "03_poe_space#The product", where_is_the_tool),
        Entry("pose", f"{POSE} `given.values` are in degrees and metres.", SPACE_FORM_SOLUTION),
    ),
)
"""The tasks that any robot gets."""

TABLE_TASKS = (
    RobotTask(
        *("A table in the standard convention", 4, "05_dh_standard#Reading a table off a drawing"),
        *(partial(dh_table, "standard"), Entry("table", TABLE, TABLE_SOLUTION)),
    ),
    RobotTask(
        *("A table in the modified convention", 4, "06_dh_modified#Frame labelling in eight steps"),
        *(partial(dh_table, "modified"), Entry("table", TABLE, TABLE_SOLUTION.replace("standard", "modified"))),
    ),
)
"""Those that need rows: no DH row can describe a helical joint, and a single row is the frame of the tool."""
