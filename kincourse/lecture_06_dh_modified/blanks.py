"""The blank steps of lecture 06: a link transform that a slide misprints, a product of two, and a converted row."""

import numpy as np

from kincourse.answers.dh_row import DHEntriesAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.links import joint_variable, link, table_product
from kincourse.problem import ArmSampler, Problem, problem
from misstep.mistakes import Mistake

RIGHT_ANGLE_RAD = np.pi / 2
ROW_2 = (0.0, -RIGHT_ANGLE_RAD, 0.3, -RIGHT_ANGLE_RAD)
ROW_3 = (0.5, -RIGHT_ANGLE_RAD, 0.0, RIGHT_ANGLE_RAD)
"""Rows 2 and 3 (a, alpha, d, theta) of the arm of "DH example with n = 5", at the joint values of steps 06.a and 06.b."""


@problem("06.a", "The second link of the n = 5 arm", points=1, lecture="06_dh_modified#The n = 5 arm")
def n5_row_2(_draw: ArmSampler) -> Problem:
    a, alpha, d, theta = ROW_2
    T_12 = link([a, alpha, joint_variable("P", 2, d, 0.0), theta], "modified", 2)
    printed = T_12.value.copy()
    printed[2, 2] = 1.0
    return Problem(
        statement="Row 2 of the n = 5 arm is $\\alpha_1 = -90°$, $a_1 = 0$, $d_2 = q_2 = 0.3$ m, $\\theta_2 = -90°$. Give ${}^1T_2$.",
        answer=PoseAnswer(T_12.value),
        solution=T_12.mistaken_for(("as printed", "copy the printed matrix, whose entry $(3, 3)$ is 1", printed)),
        advice={
            "as printed": "Its third row is 1 0 1 0, so it contains no rotation matrix: columns 1 and 3 are not perpendicular.",
            "leave out $\\theta_2$": "A prismatic joint has a $\\theta$ too; it is a constant.",
        },
    )


@problem("06.b", "Two links of the n = 5 arm", points=1, lecture="06_dh_modified#The n = 5 arm")
def n5_rows_2_and_3(_draw: ArmSampler) -> Problem:
    at_zero = np.array([ROW_2, ROW_3]) * ((1, 1, 0, 1), (1, 1, 1, 0))
    T_13 = table_product(at_zero, "PR", [ROW_2[2], ROW_3[3]], "modified", first=2)
    return Problem(
        statement="At $q_2 = 0.3$ m and $q_3 = 90°$, give ${}^1T_3 = {}^1T_2\\,{}^2T_3$ of the n = 5 arm, with $l_2 = 0.5$ m.",
        answer=PoseAnswer(T_13),
        advice={"order": "Neighbouring indices cancel, so the 2s must be side by side."},
    )


@problem("06.c", "A row of the youBot, modified", points=1, lecture="06_dh_modified#Converting")
def youbot_row_2(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give row 2 of the youBot's table in the modified convention: $a_1$, $\\alpha_1$, $d_2$, offset of $\\theta_2$.",
        answer=DHEntriesAnswer(
            np.array([0.033, RIGHT_ANGLE_RAD, 0.0, 0.0]), names=["a_1", "alpha_1", "d_2", "theta_2"]
        ),
        mistakes=[
            Mistake(
                "not converted",
                [0.155, 0.0, 0.0, 0.0],
                "This is row 2 of the standard table. A modified row 2 holds $a_1$ and $\\alpha_1$, those of the link before joint 2.",
            ),
            Mistake(
                "moved the other way",
                [0.135, 0.0, 0.0, 0.0],
                "You took $a$ and $\\alpha$ from row 3. They move down by one row: row 2 gets them from row 1.",
            ),
            Mistake(
                "whole rows moved",
                [0.033, RIGHT_ANGLE_RAD, 0.147, 0.0],
                "You moved the whole of row 1. $d$ and $\\theta$ belong to the joint and stay in its row; only $a$ and $\\alpha$ move.",
            ),
        ],
    )
