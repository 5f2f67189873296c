"""The blank steps of lecture 07: a row between antiparallel axes, an origin, and the whole table of an unknown arm."""

from dataclasses import replace

import numpy as np

from kincourse.answers.dh_row import DHRowAnswer
from kincourse.answers.dh_table import DHTableAnswer
from kincourse.expressions.links import dh_row
from kincourse.mistakes.dh import rows_of_the_other_convention
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose
from kinlib.dh.assignment import assign_frames
from misstep.answers.number import Numbers
from misstep.mistakes import Mistake

NEW_ARM = arm(
    [
        (Z, (0, 0, 0)),
        (-Y, (0, 0, 0.5)),
        (-Y, (0.5, 0, 0.5)),
        (Y, (0.8, 0.2, 0.5)),
        (X, (0.9, 0.35, 0.8), SLIDE),
        (X, (1.1, 0.35, 0.8)),
    ],
    pose((X, Y, Z), (1.3, 0.35, 0.8)),
    "stranger",
    "made for lecture 07",
)
"""The arm of the lecture: its five pairs of neighbouring axes are related in five different ways."""


@problem("07.a", "A row between antiparallel axes", points=1, lecture="07_frame_assignment#The algorithm")
def antiparallel_row(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give row 3 of the stranger in the standard convention, as $[a, \\alpha, d, \\theta]$ at $q = 0$.",
        answer=DHRowAnswer(np.array([0.3, np.pi, -0.2, 0.0])),
        solution=dh_row(0.3, np.pi, -0.2, 0.0).mistaken_for(
            (
                "parallel, and the sign of d",
                "take $\\alpha = 0$, and measure $d$ along the axis of joint 4",
                np.array([0.3, 0.0, 0.2, 0.0]),
            )
        ),
        invisible=["sign of alpha", "sign of the angles"],  # pi and -pi are the same rotation
        advice={
            "parallel, and the sign of d": "In the standard convention $d_3$ is measured along $z_2$, the axis of joint 3; the "
            "angle to $z_3$ is $\\pi$.",
            "alpha left out": "$z_2$ points along $-y$ and $z_3$ along $+y$, so the angle between them is $\\pi$.",
            "sign of d": "$d$ is measured along $z_2$, which points along $-y$ of {s}.",
        },
    )


@problem("07.b", "The foot of a common normal", points=1, lecture="07_frame_assignment#A worked example")
def origin_4(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="What is the position of $O_4$ of the stranger in {s}, in the standard convention?",
        answer=Numbers(np.array([0.8, 0.35, 0.8]), unit="m"),
        mistakes=[
            Mistake(
                "at joint 5",
                [0.9, 0.35, 0.8],
                "This is where the prismatic joint is drawn. The origin is the foot of the common normal, wherever the joint is drawn.",
            ),
            Mistake(
                "the other foot",
                [0.8, 0.35, 0.5],
                "This is the foot on axis 4, the origin of frame 4 in the modified convention. In the standard convention $O_4$ "
                "lies on the axis of joint 5.",
            ),
            Mistake(
                "at joint 6",
                [1.1, 0.35, 0.8],
                "This is joint 6, on the same line. $O_4$ belongs to axes 4 and 5, and their common normal meets axis 5 at $x = 0.8$.",
            ),
            Mistake(
                "above joint 4",
                [0.8, 0.2, 0.8],
                "This point is vertically above joint 4, but it does not lie on axis 5, which has $y = 0.35$. The common normal "
                "starts from another point of axis 4.",
            ),
        ],
    )


@problem("07.c", "The table of the stranger", points=1, lecture="07_frame_assignment#What is free")
def table_of_the_new_arm(_draw: ArmSampler) -> Problem:
    table = assign_frames(NEW_ARM, convention="standard").table
    rows = table.rows.copy()
    rows[2, 1] = 0.0
    return Problem(
        statement="Give a DH table of the stranger in the standard convention. Every table of the same mechanism is right.",
        answer=DHTableAnswer(table),
        mistakes=[
            Mistake(
                "antiparallel as parallel",
                replace(table, rows=rows),
                "Your table moves as if the axis of one joint had the opposite direction.\n"
                "Axes 3 and 4 have opposite directions, so $\\alpha_3 = \\pi$. With 0 "
                "the rest of the arm is rotated by $\\pi$ about $x_3$.",
            ),
            rows_of_the_other_convention(table),
        ],
    )
