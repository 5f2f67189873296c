"""The blank steps of lecture 01: products and inverses of the poses of an RPRR arm, and a misprinted row."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.poses import inverse, pose, with_position
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, rprr
from kinlib.chains.robots import pose as frame
from misstep.answers.number import Numbers
from misstep.mistakes import Mistake

CONFIGURATION = (np.pi / 2, 0.2, np.pi / 6, np.pi / 3)
"""The joint values of the lecture's worked example: radians, metres, radians, radians."""


def rotation_about_z(q: float) -> Array:
    """The pose (4, 4) of a rotation about z by q radians."""
    return frame((np.cos(q) * X + np.sin(q) * Y, np.cos(q) * Y - np.sin(q) * X, Z), (0, 0, 0))


def links() -> tuple[Array, Array, Array]:
    """The poses T_01, T_12 and T_23 at the lecture's configuration, with the lengths of robots.rprr."""
    q1, q2, q3, _ = CONFIGURATION
    return rotation_about_z(q1), frame((Z, X, Y), (0, q2, 0)), frame((X, -Z, Y), (0.5, 0, 0)) @ rotation_about_z(q3)


@problem("01.a", "One more link", points=1, lecture="01_frames#Chaining along the links")
def one_more_link(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_02 = T_01 @ T_12
    T_03 = pose("T_{02}", T_02) @ pose("T_{23}", T_23)
    added = with_position(T_03.value, T_02[:3, 3] + T_23[:3, 3])
    return Problem(
        statement="Give $T_{03}$ from $T_{02}$ and $T_{23}$.",
        answer=PoseAnswer(T_03.value),
        solution=T_03.mistaken_for(
            ("positions added", "add the two positions", added),
            ("poses added", "add the matrices", T_02 + T_23, "Poses are composed by a matrix product."),
        ),
        advice={
            "positions added": "$p_{23}$ is written in frame 2: write it in frame 0 first, $p_{03} = R_{02}\\,p_{23} + p_{02}$.",
            "order": "The adjacent subscripts 3 and 0 do not cancel: $T_{02}$ goes to the left of $T_{23}$.",
        },
    )


@problem("01.b", "The inverse of a pose", points=1, lecture="01_frames#The inverse")
def look_back(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_30 = inverse(pose("T_{03}", T_01 @ T_12 @ T_23))
    return Problem(
        statement="Give $T_{30}$, the pose of the base in frame 3.",
        answer=PoseAnswer(T_30),
        advice={
            "inverse left out": "$T_{03}$ is the pose of frame 3 in the base frame.",
            "transpose for inverse": "The transpose inverts the rotation, but it also moves the position into the last row.",
            "write $-p$ as the position of the inverse of $T_{03}$": "The vector $-p$ leads from link 3 to the base, but it is written in "
            "frame 0. Written in frame 3, it is $-R^T p$.",
            "write $-R\\,p$ as the position of the inverse of $T_{03}$": "$R_{03}$ takes components in frame 3 to components in frame 0; "
            "its transpose does the opposite.",
        },
    )


@problem("01.c", "The pose of the tool in frame 3", points=1, lecture="01_frames#Chaining along the links")
def tool_from_link_3(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_03, T_05 = T_01 @ T_12 @ T_23, rprr().fk(CONFIGURATION)
    T_35 = inverse(pose("T_{03}", T_03)) @ pose("T_{05}", T_05)
    subtracted = with_position(T_35.value, T_05[:3, 3] - T_03[:3, 3])
    return Problem(
        statement="Give $T_{35}$ from $T_{30}$ and $T_{05}$.",
        answer=PoseAnswer(T_35.value),
        solution=T_35.mistaken_for(("positions subtracted", "subtract the positions", subtracted)),
        advice={
            "positions subtracted": "The vector $p_{05} - p_{03}$ leads from link 3 to the tool, but it is written in frame 0: "
            "multiply it by $R_{30}$.",
            "inverse left out": "The inverse of $T_{03}$ is $T_{30}$, whose second subscript cancels with the first of $T_{05}$.",
            "order": "Adjacent subscripts must be equal: put $T_{30}$ to the left of $T_{05}$, so that the two subscripts 0 are adjacent.",
        },
    )


@problem("01.d", "The misprinted row", points=1, lecture="01_frames#Bug hunt")
def misprinted_row(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give the third row of ${}^1_2T$, four numbers.",
        answer=Numbers(np.array([1.0, 0.0, 0.0, 0.0])),
        mistakes=[
            Mistake(
                "as printed",
                np.array([1, 0, 1, 0]),
                "This is the row as printed. With it, the third column $(0, 1, 1)$ has length $\\sqrt 2$, and it is not orthogonal to the "
                "first.",
            ),
            Mistake(
                "reflection",
                np.array([-1, 0, 0, 0]),
                "With this row the columns are orthonormal, but left-handed: the determinant is $-1$, so the matrix is a reflection.",
            ),
            Mistake(
                "the other 1 kept",
                np.array([0, 0, 1, 0]),
                "This row keeps the other 1. With it, the first column is zero, so that $x_2$ has no direction.",
            ),
            Mistake(
                "a last row",
                np.array([0, 0, 0, 1]),
                "This is the fourth row of every pose. The third row has the $z$ components of the three axes and of the origin.",
            ),
        ],
    )


@problem("01.e", "A pose for the gripper", points=1, lecture="01_frames#A pose for the gripper")
def grasp(_draw: ArmSampler) -> Problem:
    approach, bolt = np.array([0.6, 0.8, 0.0]), np.array([0.3, 0.7, 0.2])
    across = np.cross(approach, Z)
    T_sg = frame((Z, across, approach), bolt - 0.1 * approach)
    return Problem(
        statement="Give $T_{sg}$, the pose in which the gripper holds the bolt.",
        answer=PoseAnswer(T_sg),
        solution=pose("T_{sg}", T_sg).mistaken_for(
            ("origin at the bolt", "put the origin of {g} at the bolt", with_position(T_sg, bolt)),
            ("beyond the bolt", "put {g} 0.1 m beyond the bolt", with_position(T_sg, bolt + 0.1 * approach)),
            (
                "away from the bolt",
                "let the $z$ axis of {g} point away from the bolt",
                frame((Z, -across, -approach), bolt - 0.1 * approach),
            ),
            ("half a turn", "let the $x$ of {g} point down", frame((-Z, -across, approach), bolt - 0.1 * approach)),
        ),
        advice={
            "origin at the bolt": "The fingertips are at the bolt, and the origin of {g} is 0.1 m before them.",
            "beyond the bolt": "The $z$ axis of {g} points from its origin to the bolt, so the origin comes before the bolt.",
            "away from the bolt": "The $z$ axis of {g} points out of the gripper, towards the bolt.",
            "half a turn": "This grasp holds the bolt too, but the $x$ axis of {g} should point to the head of the bolt.",
        },
    )
