"""The blank steps of lecture 06: a link transform, one that a deck misprints, a product of two, and a converted row."""

import numpy as np

from kincourse.answers.dh_row import DHEntriesAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.dh.table import DHTable, dh_transform
from misstep.mistakes import Mistake, mistake
from misstep.problem import Problem

RIGHT_ANGLE_RAD = np.pi / 2
ROW_2 = (0.0, -RIGHT_ANGLE_RAD, 0.3, -RIGHT_ANGLE_RAD)
ROW_3 = (0.5, -RIGHT_ANGLE_RAD, 0.0, RIGHT_ANGLE_RAD)
"""Rows 2 and 3 (a, alpha, d, theta) of the arm of the deck "n = 5", at the joint values of steps 06.b and 06.c."""


@problem("06.a", "A link transform of the PUMA", points=1, lecture="06_dh_modified#The general matrix")
def puma_row_4(_draw: ArmSampler) -> Problem:
    a, alpha, d, theta = 0.0203, -RIGHT_ANGLE_RAD, 0.4318, np.radians(30)
    return Problem(
        statement="Row 4 of the PUMA's table has $\\alpha_3 = -90°$, $a_3$, $d_4$ and $\\theta_4 = 30°$. Give ${}^3T_4$.",
        answer=PoseAnswer(_link_transform(a, alpha, d, theta)),
        mistakes=[
            *_row_mistakes(a, alpha, d, theta),
            mistake(
                "a and d swapped",
                _link_transform(d, alpha, a, theta),
                "You exchanged $a$ and $d$. $a$ is the way along $x_3$, $d$ the way along $z_4$.",
            ),
            mistake(
                "degrees",
                _link_transform(a, -90.0, d, 30.0),
                "You gave degrees to a cosine that reads radians. Use np.radians, or np.pi / 2 for the right angle.",
            ),
        ],
    )


@problem("06.b", "The second link of the n = 5 arm", points=1, lecture="06_dh_modified#The n = 5 arm")
def n5_row_2(_draw: ArmSampler) -> Problem:
    a, alpha, d, theta = ROW_2
    printed = _link_transform(*ROW_2)
    printed[2, 2] = 1.0
    return Problem(
        statement="Row 2 of the n = 5 arm is $\\alpha_1 = -90°$, $a_1 = 0$, $d_2 = q_2 = 0.3$ m, $\\theta_2 = -90°$. Give ${}^1T_2$.",
        answer=PoseAnswer(_link_transform(*ROW_2)),
        mistakes=[
            mistake(
                "as printed",
                printed,
                "You copied the deck's matrix. Its third row reads 1 0 1 0, and that is no rotation: columns 1 and 3 are not square.",
            ),
            *_row_mistakes(a, alpha, d, theta),
            mistake(
                "slide in theta",
                _link_transform(a, alpha, 0.0, theta + d),
                "You put $q_2$ into $\\theta$. Joint 2 slides: its variable is $d_2$, and $\\theta_2 = -90°$ is a constant.",
            ),
            mistake(
                "no theta",
                _link_transform(a, alpha, d, 0.0),
                "You left out $\\theta_2 = -90°$. A slide has a $\\theta$ too; it is a constant.",
            ),
        ],
    )


@problem("06.c", "Two links of the n = 5 arm", points=1, lecture="06_dh_modified#The n = 5 arm")
def n5_rows_2_and_3(_draw: ArmSampler) -> Problem:
    T_12, T_23 = _link_transform(*ROW_2), _link_transform(*ROW_3)
    standard = [dh_transform(*row, convention="standard") for row in (ROW_2, ROW_3)]
    a, alpha, d, _ = ROW_3
    return Problem(
        statement="At $q_2 = 0.3$ m and $q_3 = 90°$, give ${}^1T_3 = {}^1T_2\\,{}^2T_3$ of the n = 5 arm, with $l_2 = 0.5$ m.",
        answer=PoseAnswer(T_12 @ T_23),
        mistakes=[
            mistake(
                "reversed",
                T_23 @ T_12,
                "You multiplied ${}^2T_3\\,{}^1T_2$. Neighbouring indices cancel: the 2s must stand side by side.",
            ),
            mistake(
                "standard rows",
                standard[0] @ standard[1],
                "You read both rows in the standard convention. Here each row crosses the link first and turns the joint after.",
            ),
            mistake(
                "joint 3 at zero",
                T_12 @ _link_transform(a, alpha, d, 0.0),
                "You left $q_3$ at 0. It stands at 90 degrees.",
            ),
            mistake(
                "only the second",
                T_23,
                "This is ${}^2T_3$, where {3} stands in {2}. Put ${}^1T_2$ in front of it.",
            ),
        ],
    )


@problem("06.d", "A row of the youBot, modified", points=1, lecture="06_dh_modified#Converting")
def youbot_row_2(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give row 2 of the youBot's table in the modified convention: $a_1$, $\\alpha_1$, $d_2$, offset of $\\theta_2$.",
        answer=DHEntriesAnswer(
            np.array([0.033, RIGHT_ANGLE_RAD, 0.0, 0.0]), names=["a_1", "alpha_1", "d_2", "theta_2"]
        ),
        mistakes=[
            mistake(
                "not handed on",
                [0.155, 0.0, 0.0, 0.0],
                "This is row 2 as it stands. In a modified row 2 stand $a_1$ and $\\alpha_1$, those of the link before joint 2.",
            ),
            mistake(
                "the other way",
                [0.135, 0.0, 0.0, 0.0],
                "You took $a$ and $\\alpha$ from row 3. They are handed on downwards: row 2 gets them from row 1.",
            ),
            mistake(
                "the whole row",
                [0.033, RIGHT_ANGLE_RAD, 0.147, 0.0],
                "You handed on the whole of row 1. $d$ and $\\theta$ belong to the joint and stay in its row; $a$ and $\\alpha$ move.",
            ),
            mistake(
                "degrees",
                [0.033, 90.0, 0.0, 0.0],
                "Your $\\alpha_1$ is in degrees. Type radians: np.pi / 2.",
            ),
        ],
    )


def _link_transform(a: float, alpha: float, d: float, theta: float) -> Array:
    return dh_transform(a, alpha, d, theta, convention="modified")


def _row_mistakes(a: float, alpha: float, d: float, theta: float) -> list[Mistake]:
    """The mistakes of a row read in the other convention, or with the sign of alpha flipped."""
    return [
        mistake(
            "standard",
            DHTable([[a, alpha, d, theta]], convention="standard").fk([0.0]),
            "You read the row in the standard convention, $R_z T_z T_x R_x$. Modified is $R_x T_x R_z T_z$: across the link first.",
        ),
        mistake(
            "sign of alpha",
            _link_transform(a, -alpha, d, theta),
            "Your $\\alpha$ has the wrong sign: the minus belongs to it, and it decides which way $z$ tips.",
        ),
    ]


BLANKS = [puma_row_4, n5_row_2, n5_rows_2_and_3, youbot_row_2]
