"""The blank steps of lecture 04: a body screw by the adjoint, one read in the tool's frame, and a pose with M in the middle."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import inverse, pose
from kincourse.expressions.screws import (
    change_frame,
    direction,
    exponentials,
    forward_kinematics,
    revolute,
    screw_axes,
    values_in_radians,
)
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import Y, mid_formula_arm, rpr
from misstep.display.text import matrix, vector
from misstep.mutants.expression import given, product

CONFIGURATION_RAD = np.radians([90, -30, 60, -90])
"""The joint values of step 04.c: plain angles, at which each joint that is left out or negated gives another pose."""


@problem("04.a", "A body screw by the adjoint", points=1, lecture="04_poe_body#The adjoint")
def body_screw_by_the_adjoint(_draw: ArmSampler) -> Problem:
    robot = rpr()
    B = change_frame(inverse(pose("M", robot.home)), screw_axes("S_1", robot.screws[0]))
    return Problem(
        statement=f"The RPR arm has $S_1 = {vector(robot.screws[0])}$ and $M = {matrix(robot.home)}$. Give $B_1$.",
        given={"home": robot.home, "screw": robot.screws[0]},
        answer=ScrewsAnswer(B),
        advice={
            "inverse left out": "$\\mathrm{Ad}_M$ takes screws in {b} to screws in {s}; you need $\\mathrm{Ad}_{M^{-1}}$ here.",
            "position left out": "The origin moved too: $v$ is the velocity at the new origin $p$, $R^T (v + \\omega \\times p)$.",
            "sign in the adjoint": "A point at $p$ moves with $v + \\omega \\times p$.",
            "rotation left out": "{b} also has other axes than {s}, so both halves are rotated by $R^T$.",
            "frame not changed": "This is $S_1$, a screw in {s}; {b} has another origin and other axes.",
        },
    )


@problem("04.b", "A body screw from its line in the tool frame", points=1, lecture="04_poe_body#The mid-formula form")
def body_screw_from_the_drawing(_draw: ArmSampler) -> Problem:
    robot = mid_formula_arm()
    R, S = robot.home[:3, :3], robot.screws[3]
    B = revolute(direction("\\omega", Y), given("p", (0, 0, -0.2))).mistaken_for(
        ("frame not changed", "give $S_4$, which is a screw in {s}", S, "Use the direction and the point in {b}."),
        (
            "position left out",
            "rotate both halves of $S_4$ without the change of origin",
            np.concatenate([R.T @ S[:3], R.T @ S[3:]]),
        ),
    )
    return Problem(
        statement="Joint 4 of the mid-formula arm rotates about $y_b$, and its axis passes through $(0, 0, -0.2)$ in {b}. Give $B_4$.",
        answer=ScrewsAnswer(B),
        advice={
            "position left out": "Measure the point of the axis from the origin of {b}.",
            "no moment": "The axis of joint 3 passes through the origin of {b}, so its moment is zero; this axis does not.",
        },
    )


@problem("04.c", "The pose, with M in the middle", points=1, lecture="04_poe_body#The mid-formula form")
def pose_with_home_in_the_middle(_draw: ArmSampler) -> Problem:
    robot = mid_formula_arm()
    q = values_in_radians(robot.joint_types, CONFIGURATION_RAD)
    S, B, home = exponentials(robot.screws, q), exponentials(robot.body_screws, q, "B"), pose("M", robot.home)
    T = forward_kinematics(S[:2], home, B[2:])
    for left, right, name, text in (
        (S, S, "space screws", "use space screws to the right of $M$"),
        (B, B, "body screws", "use body screws to the left of $M$"),
        (B, S, "sides swapped", "use body screws to the left of $M$, and space screws to its right"),
    ):
        advice = "$S_1$ and $S_2$ belong to the left of $M$, $B_3$ and $B_4$ to its right."
        T = T.mistaken_for((name, text, product(*left[:2], home, *right[2:]), advice))
    T = T.mistaken_for(
        ("reversed", "multiply space screws from the last joint to the first, with $M$ last", product(*S[::-1], home))
    )
    return Problem(
        statement=f"Give $T(q)$ of the mid-formula arm at $q = {vector(np.degrees(CONFIGURATION_RAD))}$ degrees, with $M$ after joint 2.",
        given={"screws": robot.screws, "body_screws": robot.body_screws, "home": robot.home, "q": CONFIGURATION_RAD},
        answer=PoseAnswer(T),
        advice={
            "last factor": "$M$ comes after the factor of joint 2, and the body screws follow it.",
            "reversed": "Moving $M$ does not change the order of the joints.",
        },
        invisible=["first factor"],  # at these right angles, the factor of joint 3 may also be the first
    )
