"""The blank steps of lecture 05: rows 2, 4 and 5 of the youBot, the matrix of row 4, and the product at one configuration."""

import numpy as np

from kincourse.answers.dh_row import DHRowAnswer
from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.links import dh_row, joint_variable, link, table_product
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.dh.table import DHTable

RIGHT_ANGLE_RAD = np.pi / 2

YOUBOT = DHTable(
    [
        [0.033, RIGHT_ANGLE_RAD, 0.147, 0],
        [0.155, 0, 0, 0],
        [0.135, 0, 0, 0],
        [0, RIGHT_ANGLE_RAD, 0, RIGHT_ANGLE_RAD],
        [0, 0, 0.2175, 0],
    ],
    convention="standard",
    name="youBot",
)
"""The DH table of the EduFill manipulation module, with its columns in the order of kinlib: a, alpha, d, theta."""

BENT_CONFIGURATION = np.array([0, 0, RIGHT_ANGLE_RAD, -np.pi / 4, -np.pi / 4])
"""Joint values in radians. With q_4 = -pi/2, theta_4 would be 0, and A_4 the same in both conventions."""


@problem("05.a", "Row 4 of the youBot", points=1, lecture="05_dh_standard#Reading a table off a drawing")
def row_4(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Read row 4 of the youBot from the drawn frames: $a_4, \\alpha_4, d_4$ and $\\theta_4$ at $q = 0$.",
        answer=DHRowAnswer(YOUBOT.rows[3]),
        solution=dh_row(*YOUBOT.rows[3]).mistaken_for(
            ("alpha of the row before", "take $\\alpha$ from $z_2$ to $z_3$", np.array([0, 0, 0, RIGHT_ANGLE_RAD]))
        ),
        invisible=["angles swapped", "both pairs swapped"],  # both angles are right angles
        advice={
            "alpha of the row before": "That is $\\alpha_3$; row 4 holds $\\alpha_4$, from $z_3$ to $z_4$.",
            "take $x_i$ in the opposite direction": "That is allowed too, and then $\\theta_5 = q_5 + \\pi$. But in the drawing $x_4$ "
            "points up.",
            "sign of theta": "$\\theta_4$ is measured about $z_3$, which points towards you: from $x_3$ to $x_4$ it is positive.",
        },
    )


@problem("05.b", "The matrix of row 4", points=1, lecture="05_dh_standard#The offset")
def matrix_of_row_4(_draw: ArmSampler) -> Problem:
    A_4 = link([0, RIGHT_ANGLE_RAD, 0, joint_variable("R", 4, -np.pi / 4, RIGHT_ANGLE_RAD)], "standard", 4)
    return Problem(
        statement="Give $A_4$ of the youBot at $q_4 = -\\pi/4$.",
        answer=PoseAnswer(A_4),
        advice={"leave $q_4$ at 0": "The offset is added to $q_4$, and does not replace it."},
    )


@problem("05.c", "The pose of the end-effector", points=1, lecture="05_dh_standard#The product of the A matrices")
def pose_in_the_drawn_configuration(_draw: ArmSampler) -> Problem:
    T = table_product(YOUBOT.rows, YOUBOT.joints, BENT_CONFIGURATION, "standard")
    return Problem(
        statement="Give $T(q) = A_1 A_2 A_3 A_4 A_5$ of the youBot at $q = (0, 0, \\pi/2, -\\pi/4, -\\pi/4)$.",
        answer=PoseAnswer(T),
        invisible=["order"],  # at q_1 = q_2 = 0 the first two link transforms commute
    )


@problem("05.d", "Row 2 of the youBot", points=1, lecture="05_dh_standard#Reading a table off a drawing")
def row_2(_draw: ArmSampler) -> Problem:
    row = dh_row(*YOUBOT.rows[1])
    for name, text, wrong, advice in (
        ("measured from the base", "measure $a_2$ from $z_0$", [0.188, 0, 0, 0], "$a_2$ is measured from $z_1$ to $z_2$."),
        ("height above the floor", "take the height of the axis as $d_2$", [0.155, 0, 0.147, 0], "$d_2$ is measured along $z_1$."),
        ("another row", "read row 1", YOUBOT.rows[0], "Row 2 leads from frame 1 to frame 2."),
        ("another row", "read row 3", YOUBOT.rows[2], "Row 2 leads from frame 1 to frame 2."),
    ):  # fmt: skip
        row = row.mistaken_for((name, text, np.array(wrong), advice))
    return Problem(
        statement="Read row 2 of the youBot from the drawn frames: $a_2, \\alpha_2, d_2$ and $\\theta_2$ at $q = 0$.",
        answer=DHRowAnswer(row),
    )


@problem("05.e", "Row 5 of the youBot", points=1, lecture="05_dh_standard#Reading a table off a drawing")
def row_5(_draw: ArmSampler) -> Problem:
    row = dh_row(*YOUBOT.rows[4])
    for name, text, wrong, advice in (
        ("measured from the base", "measure $d_5$ from $O_0$", [0, 0, 0.5405, 0], "$d_5$ is measured from $O_4$ to $O_5$, along $z_4$."),
        ("another row", "read row 4", YOUBOT.rows[3], "Row 5 leads from frame 4 to frame 5."),
    ):  # fmt: skip
        row = row.mistaken_for((name, text, np.array(wrong), advice))
    return Problem(
        statement="Read row 5 of the youBot from the drawn frames: $a_5, \\alpha_5, d_5$ and $\\theta_5$ at $q = 0$.",
        answer=DHRowAnswer(row),
    )
