"""The blank steps of lecture 01: products, inverses and a misprinted row of poses of the arm of the deck "n = 5"."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.poses import inverse, pose, with_position
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, rprr
from kinlib.chains.robots import pose as frame
from misstep.answers.number import Numbers
from misstep.mistakes import mistake
from misstep.problem import Problem

CONFIGURATION = (np.pi / 2, 0.2, np.pi / 6, np.pi / 3)
"""The joint values of the lecture's worked example: radians, metres, radians, radians."""


def rotation_about_z(q: float) -> Array:
    """The pose (4, 4) of a rotation about z by q radians.

    >>> rotation_about_z(np.pi / 2)[:3, 0].round(6) + 0.0
    array([0., 1., 0.])
    """
    return frame((np.cos(q) * X + np.sin(q) * Y, np.cos(q) * Y - np.sin(q) * X, Z), (0, 0, 0))


def links() -> tuple[Array, Array, Array]:
    """The poses T_01, T_12 and T_23 at the lecture's configuration, with the lengths of robots.rprr.

    >>> links()[2][:3, 3]
    array([0.5, 0. , 0. ])
    """
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
            added,
            "positions added",
            "add the two positions",
            "$p_{23}$ is written in frame 2: rotate it into frame 0 first, $p_{03} = R_{02}\\,p_{23} + p_{02}$.",
        ).mistaken_for(T_02 + T_23, "poses added", "add the matrices", "Motions follow one another by a product."),
        advice={"order": "The inner letters 3 and 0 do not cancel: what the base sees is leftmost."},
    )


@problem("01.b", "Look back", points=1, lecture="01_frames#The inverse")
def look_back(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_30 = inverse(pose("T_{03}", T_01 @ T_12 @ T_23))
    return Problem(
        statement="Give $T_{30}$, the base seen from link 3.",
        answer=PoseAnswer(T_30.value),
        solution=T_30,
        advice={
            "inverse left out": "It is link 3 seen from the base.",
            "transpose for inverse": "$R^T$ inverts the rotation, but the translation goes into the last row, where none belongs.",
            "write $-p$ as the position of the inverse of $T_{03}$": "The vector $-p$ leads back to the base, but in frame 0: "
            "link 3 writes it as $-R^T p$.",
            "write $-R\\,p$ as the position of the inverse of $T_{03}$": "$R$ takes frame 3 to frame 0; you need the other way, $R^T$.",
        },
    )


@problem("01.c", "The tool, seen from link 3", points=1, lecture="01_frames#Chaining along the links")
def tool_from_link_3(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_03, T_05 = T_01 @ T_12 @ T_23, rprr().fk(CONFIGURATION)
    T_35 = inverse(pose("T_{03}", T_03)) @ pose("T_{05}", T_05)
    subtracted = with_position(T_35.value, T_05[:3, 3] - T_03[:3, 3])
    return Problem(
        statement="Give $T_{35}$ from $T_{30}$ and $T_{05}$.",
        answer=PoseAnswer(T_35.value),
        solution=T_35.mistaken_for(
            subtracted,
            "positions subtracted",
            "subtract the positions",
            "The arrow $p_{05} - p_{03}$ leads from link 3 to the tool, but it is written in frame 0: rotate it with $R_{30}$.",
        ),
        advice={
            "inverse left out": "The inner letters 3 and 0 differ, so nothing cancels: $T_{30}$ comes first.",
            "order": "The inner letters 5 and 3 differ: put $T_{30}$ on the left, so that 0 meets 0.",
        },
    )


@problem("01.d", "The row that the deck misprints", points=1, lecture="01_frames#Bug hunt")
def misprinted_row(_draw: ArmSampler) -> Problem:
    return Problem(
        statement="Give the third row of ${}^1_2T$, four numbers.",
        answer=Numbers(np.array([1.0, 0.0, 0.0, 0.0])),
        mistakes=[
            mistake(
                "as printed",
                np.array([1, 0, 1, 0]),
                "This is the row as printed. The third column $(0, 1, 1)$ then has length $\\sqrt 2$, and it leans on the first.",
            ),
            mistake(
                "reflection",
                np.array([-1, 0, 0, 0]),
                "The columns are orthonormal now, but left-handed: the determinant is $-1$, "
                "and no motion makes a glove fit the other hand.",
            ),
            mistake(
                "the other 1 kept",
                np.array([0, 0, 1, 0]),
                "You kept the other 1. Then the first column is zero: $x_2$ would have no direction at all.",
            ),
            mistake(
                "a last row",
                np.array([0, 0, 0, 1]),
                "That is the fourth row of every pose. The third row holds the $z$ components of the three axes and of the origin.",
            ),
        ],
    )


BLANKS = [one_more_link, look_back, tool_from_link_3, misprinted_row]
