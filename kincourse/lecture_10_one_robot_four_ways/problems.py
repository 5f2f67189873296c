"""Sheet 10: problems on the whole course. Each leads from one description of an arm to another."""

from __future__ import annotations

from functools import partial

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.links import link
from kincourse.expressions.poses import inverse
from kincourse.expressions.screws import (
    change_frame,
    revolute,
)
from kincourse.expressions.urdf import rpy_rotation
from kincourse.lecture_10_one_robot_four_ways.project_problems import PROJECT_PROBLEMS
from kincourse.problem import problem
from kincourse.sampling.arms import PLAIN_ANGLES_DEG, ArmSampler
from kinlib.dh.formatting import markdown_table
from kinlib.dh.table import DHTable, format_rows
from kinlib.rigid.lie import exp as exponential
from kinlib.rigid.lie import inverse as inverted
from kinlib.rigid.lie import log
from kinlib.rigid.rpy import roll_pitch_yaw
from misstep.answers.angle import Angles
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.answers.prose import Prose
from misstep.display.text import degrees, matrix, number, vector
from misstep.mistakes import mistake
from misstep.mutants.expression import Expression, given, product
from misstep.mutants.operations import radians
from misstep.problem import Problem
from misstep.sheet import Sheet

RIGHT_ANGLE_RAD = np.pi / 2

MIN_ENTRY_DIFFERENCE = 0.3
"""The minimum difference of the wrong pose from the right ones in some entry, so that it cannot be taken for rounding."""

REPORTS = {
    "a": "This one is $T_{sb}$ already.",
    "b": "Take its inverse.",
    "c": "$R = R_z(\\text{yaw}) R_y(\\text{pitch}) R_x(\\text{roll})$.",
    "d": "Take its exponential.",
}
"""For each kind of report in problem 3 how it becomes a pose."""


@problem(
    "10.1",
    "From a table to a screw",
    points=2,
    lecture="10_one_robot_four_ways#A table",
    further="Which entries of the screw depend on the choice of $x_2$?",
    level="Warm-up",
)
def from_a_table(sampler: ArmSampler) -> Problem:
    length = partial(sampler.length, 0.1, 0.9)
    right_angle = partial(sampler.choice, (-RIGHT_ANGLE_RAD, RIGHT_ANGLE_RAD))

    def theta() -> float:
        # With a right angle a length of row 1 would lie along z_2, and change no moment.
        return float(np.radians(sampler.choice((-1, 1)) * sampler.choice(PLAIN_ANGLES_DEG)))

    rows = np.array([(length(), right_angle(), length(), theta()) for _ in range(2)] + [(length(), 0.0, 0.0, 0.0)])
    A = [link(row, "standard", i) for i, row in enumerate(rows, start=1)]
    table = DHTable(rows, convention="standard")

    def axis_of(T: Expression, k: int) -> Expression:
        return revolute(T[:3, 2].named(f"z_{k}"), T[:3, 3].named(f"O_{k}"))

    T_02, T_03 = A[0] @ A[1], product(*A)
    z, O = T_02[:3, 2].named("z_2"), T_02[:3, 3].named("O_2")
    z = z.mistaken_for(
        ("another axis", "take $x_2$ instead of $z_2$", T_02[:3, 0]),
        ("row for column", "take the third row of the rotation instead of its third column", T_02[2, :3]),
    )
    for k, T in ((1, A[0]), (3, T_03)):
        O = O.mistaken_for(("another point", f"take $O_{k}$ instead of $O_2$", T[:3, 3]))
    S = revolute(z, O)
    modified = product(*(link(row, "modified", i) for i, row in enumerate(rows, start=1)))
    S = S.mistaken_for(
        ("another joint", "take $z_3$ and $O_3$", axis_of(T_03, 3)),
        ("another joint", "take $z_1$ and $O_1$, the axis of joint 2", axis_of(A[0], 1)),
        ("another joint", "take $z_0$ and $O_0$, the axis of joint 1", axis_of(given("I", np.eye(4)), 0)),
        ("the other convention", "take $z_3$ and $O_3$ of the modified convention", axis_of(modified, 3)),
        ("body screw", "give $B_3$, the screw axis in frame 3", change_frame(inverse(T_03), S)),
    )
    return Problem(
        statement="The table of an arm with three revolute joints is in the standard convention, and its frame 0 is {s}. Give the screw "
        f"axis $S_3$ of joint 3 in {{s}}, at home.\n\n{_format_table(table)}",
        given={"rows": rows},
        answer=ScrewsAnswer(S.value),
        solution=S,
        advice={
            "another joint": "In the standard convention joint $i$ rotates about $z_{i-1}$, so joint 3 rotates about $z_2$.",
            "body screw": "In {s} it is $S_3 = \\mathrm{Ad}_M B_3$.",
        },
    )


@problem(
    "10.2",
    "The origin of a joint",
    points=2,
    lecture="10_one_robot_four_ways#A file",
    further="Which `rpy` would give the same origin with another axis?",
    level="Warm-up",
)
def joint_origin(sampler: ArmSampler) -> Problem:
    # With two right angles, fixed and moving axes could be swapped.
    degrees = [sampler.choice((90, -90)), 0, sampler.choice((-60, -30, 30, 60))]
    here, there = sampler.point(4) / 10, sampler.point(4) / 10
    R = rpy_rotation("R", radians(given("\\mathrm{rpy}", np.array(degrees))))
    step = (given("p_2", there) - given("p_1", here)).named("(p_2 - p_1)")
    step = step.mistaken_for(
        ("order", "take the vector from joint 2 to joint 1", here - given("p_2", there)),
        ("sign", "add the two positions instead of subtracting them", here + given("p_2", there)),
    )
    xyz = R.T @ step
    for name, text, place in (
        ("from the base", "give the position of joint 2 in {s}", there),
        ("another joint", "give the position of joint 1", here),
        ("rotated and not moved", "multiply the position of joint 2 by $R$", R @ there),
        ("order", "rotate the position of joint 2 before subtracting that of joint 1", R.T @ there - here),
        (
            "placed by joint 1",
            "treat the position of joint 2 as if it were given in the frame of joint 1",
            here + R @ there,
        ),
    ):
        advice = "The `xyz` of joint 2 has its components in the frame of joint 1. The problem gives the position of joint 2 in {s}."
        xyz = xyz.mistaken_for((name, text, place, advice))
    return Problem(
        statement=f"In a URDF file, the origin of joint 1 in the base frame {{s}} is `xyz` = ${vector(here)}$ and "
        f"`rpy` = ${vector(degrees)}$ degrees. At home the position of joint 2 is ${vector(there)}$ in {{s}}. "
        "Give the `xyz` of joint 2, whose parent is the link of joint 1, in metres.",
        given={"xyz_1": here, "rpy_1_in_degrees": np.array(degrees, dtype=float), "place_2": there},
        answer=VectorsAnswer(xyz.value, unit="m"),
        solution=xyz,
        advice={
            "transpose left out": "$R$ takes components in the frame of joint 1 to components in {s}; here you need $R^T$.",
            "factor left out": "The frame of joint 1 is rotated: give the components along its axes.",
            "term left out": "The origin of joint 1 is not at the origin of the base frame.",
        },
    )


@problem(
    "10.3",
    "One of four is wrong",
    points=3,
    lecture="10_one_robot_four_ways#Do they agree?",
    further="How many configurations do you need to find the wrong description for certain?",
)
def one_of_four(sampler: ArmSampler) -> Problem:
    names = {"a": "space screws", "b": "body screws", "c": "table", "d": "file"}
    wrong = sampler.choice("abcd")
    right = fault = np.eye(4)
    while np.linalg.norm((right - fault)[:3, 3]) < MIN_ENTRY_DIFFERENCE:
        robot = sampler.arm(sampler.choice(("RRR", "RPR", "RRP")), reach=3)
        q = np.array([sampler.choice((0.3, 0.5, 0.7, 0.9)) for _ in range(3)])
        right, fault = robot.fk(q), np.linalg.multi_dot([*exponential(robot.screws * q[:, None])[::-1], robot.home])
    poses = [fault if letter == wrong else right for letter in names]
    T, T_inverse, placed, twist = poses[0], inverted(poses[1]), poses[2], log(poses[3])
    xyz, rpy = placed[:3, 3], roll_pitch_yaw(placed[:3, :3])
    problem = Problem(
        statement="Four descriptions of one arm were evaluated at the same $q$, and one of them is wrong. Each report gives "
        "the pose of the tool in another format. Which description is wrong, and how far from the others, in metres, does it put "
        "the tool? Answer with its letter and the distance, such as `('a', 0.5)`.\n\n"
        f"- (a) space screws: $T_{{sb}} = {matrix(T)}$\n"
        f"- (b) body screws: the pose of {{s}} in {{b}}, $T_{{bs}} = {matrix(T_inverse)}$\n"
        f"- (c) table: `xyz` = ${vector(xyz)}$ m and `rpy` = ${vector(rpy)}$ rad, as in a URDF\n"
        f"- (d) file: the twist ${vector(twist)}$ whose exponential is $T_{{sb}}$",
        given={"T_sb": T, "T_bs": T_inverse, "xyz": xyz, "rpy": rpy, "twist": twist},
        answer=Choice(wrong, names),
        mistakes=[
            mistake(
                letter,
                letter,
                f"You answered {name}, but this report agrees with two others if you write all four as $T_{{sb}}$. "
                f"{REPORTS[letter]} The wrong report agrees with none of the others.",
            )
            for letter, name in names.items()
            if letter != wrong
        ],
    )
    return problem.with_reason(Numbers(np.array(np.linalg.norm((right - fault)[:3, 3])), unit="m"))


@problem(
    "10.11",
    "An offset from a log",
    points=3,
    lecture="10_one_robot_four_ways#Do they agree?",
    further="Two joints with parallel axes both have an offset. Which of the two could you still find?",
    level="Hard",
)
def offset_from_a_log(sampler: ArmSampler) -> Problem:
    robot, joint = sampler.arm("RRRR"), sampler.integer(1, 4)
    offset = np.radians(sampler.choice((-1, 1)) * sampler.integer(8, 30) / 10)
    q = np.array([[sampler.integer(-12, 12) / 10 for _ in range(4)] for _ in range(5)])
    poses = robot.fk(q + offset * np.eye(4)[joint - 1])
    names = {str(i): f"joint {i}" for i in (1, 2, 3, 4)}
    problem = Problem(
        statement="The zero of one joint of an arm is off: the joint value is larger than its encoder says by a constant offset. You "
        "have a log of encoder values in radians, a row of `q` for each pose in `poses`, and the screw axes and the home pose of the arm, "
        "which are right. Which joint is it, and what is the offset in radians? Answer with the number of the joint and the offset, such "
        "as `('1', 0.0213)`. A negative offset means that the joint value is smaller.",
        given={"screws": robot.screws, "home": robot.home, "q": q, "poses": poses},
        answer=Choice(str(joint), names),
        mistakes=[
            mistake(
                f"joint {number}",
                number,
                f"You answered joint {number}. No single offset of this joint explains all poses of the log.",
            )
            for number in names
            if number != str(joint)
        ],
    )
    return problem.with_reason(Angles(np.array(offset)))


def _format_table(table: DHTable) -> str:
    """Write a table of revolute joints in Markdown, with its lengths in metres and angles in degrees."""
    rows = format_rows(table, length=number, angle=degrees, variable="$q_{}$".format)
    return markdown_table(rows, ["row", "$a$ (m)", "$\\alpha$", "$d$ (m)", "$\\theta$"])


@problem(
    "10.12",
    "A problem of your own",
    points=3,
    lecture="10_one_robot_four_ways#What changes when a frame moves",
    level="Open",
)
def your_own_problem(_: ArmSampler) -> Problem:
    return Problem(
        statement="Write a problem about your machine that belongs on this sheet. Give its right answer, and a wrong answer that a good "
        "student might give. Then write the card for this wrong answer in one or two sentences: it names the idea that went "
        "wrong, and not the number. How do you know that no other mistake leads to the same wrong answer?",
        answer=Prose(
            "For example: give the body screw of joint 2 after the tool is lengthened by $l$ along its $z$. Right is "
            "$\\mathrm{Ad}_{T^{-1}} B_2$; a good student multiplies by $\\mathrm{Ad}_{T}$. Card: “You moved the tool the other way. "
            "The new frame is farther out, so the joint is farther behind it.” The sign of $l$ gives the same numbers, and says the "
            "same; the transposed adjoint gives others.",
            {
                "a problem with a right answer, about the own machine": 1,
                "a wrong answer that is likely, with its numbers": 1,
                "a card that is true and names the idea, and a comparison with other mistakes": 1,
            },
        ),
    )


SHEET = Sheet(
    "10_one_robot_four_ways",
    "One robot, four ways",
    [
        from_a_table,
        joint_origin,
        one_of_four,
        *PROJECT_PROBLEMS,
        offset_from_a_log,
        your_own_problem,
    ],
)
