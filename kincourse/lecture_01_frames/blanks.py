"""The blank steps of lecture 01: products, inverses and a misprinted row of poses of the arm of the deck "n = 5"."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.chains.robots import X, Y, Z, pose, rprr
from kinlib.rigid.lie import homogeneous, inverse
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
    return pose((np.cos(q) * X + np.sin(q) * Y, np.cos(q) * Y - np.sin(q) * X, Z), (0, 0, 0))


def links() -> tuple[Array, Array, Array]:
    """The poses T_01, T_12 and T_23 at the lecture's configuration, with the lengths of robots.rprr.

    >>> links()[2][:3, 3]
    array([0.5, 0. , 0. ])
    """
    q1, q2, q3, _ = CONFIGURATION
    return rotation_about_z(q1), pose((Z, X, Y), (0, q2, 0)), pose((X, -Z, Y), (0.5, 0, 0)) @ rotation_about_z(q3)


def with_position(T: Array, p: Array) -> Array:
    """Replace the position of a pose T (4, 4) by p (3,), and keep its rotation.

    >>> with_position(np.eye(4), np.array([1, 2, 3]))[:3, 3]
    array([1., 2., 3.])
    """
    return homogeneous(T[:3, :3], p)


@problem("01.a", "One more link", points=1, lecture="01_frames#Chaining along the links")
def one_more_link(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_02 = T_01 @ T_12
    T_03 = T_02 @ T_23
    return Problem(
        statement="Give $T_{03}$ from $T_{02}$ and $T_{23}$.",
        answer=PoseAnswer(T_03),
        mistakes=[
            mistake(
                "reversed",
                T_23 @ T_02,
                "You multiplied $T_{23} T_{02}$. The inner letters 3 and 0 do not cancel: what the base sees stands leftmost.",
            ),
            mistake(
                "positions added",
                with_position(T_03, T_02[:3, 3] + T_23[:3, 3]),
                "You added the two positions. $p_{23}$ is written in frame 2: turn it into frame 0 first, "
                "$p_{03} = R_{02}\\,p_{23} + p_{02}$.",
            ),
            mistake(
                "entry by entry",
                T_02 * T_23,
                "You multiplied entry by entry, with `*`. The product of matrices is `@` in NumPy.",
            ),
            mistake(
                "poses added",
                T_02 + T_23,
                "You added the matrices. Motions follow one another by a product; a sum of two poses is no pose.",
            ),
        ],
    )


@problem("01.b", "Look back", points=1, lecture="01_frames#The inverse")
def look_back(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_03 = T_01 @ T_12 @ T_23
    R, p = T_03[:3, :3], T_03[:3, 3]
    back = inverse(T_03)
    return Problem(
        statement="Give $T_{30}$, the base seen from link 3.",
        answer=PoseAnswer(back),
        mistakes=[
            mistake(
                "minus p",
                with_position(back, -p),
                "You wrote $R^T$ and $-p$. The vector $-p$ leads back to the base, but it is written in frame 0: "
                "link 3 writes it as $-R^T p$.",
            ),
            mistake(
                "plus p turned",
                with_position(back, R.T @ p),
                "You turned $p$ into frame 3 and kept its direction. From link 3 the base lies the other way: $-R^T p$.",
            ),
            mistake(
                "turned the wrong way",
                with_position(back, -R @ p),
                "You turned $-p$ with $R$. That takes frame 3 to frame 0; you need the other way, $R^T$.",
            ),
            mistake(
                "all transposed",
                T_03.T,
                "You transposed the whole matrix. $R^T$ undoes the turn, but the translation went into the last row, where none belongs.",
            ),
            mistake(
                "not undone",
                T_03,
                "This is $T_{03}$ itself: link 3 seen from the base.",
            ),
        ],
    )


@problem("01.c", "The tool, seen from link 3", points=1, lecture="01_frames#Chaining along the links")
def tool_from_link_3(_draw: ArmSampler) -> Problem:
    T_01, T_12, T_23 = links()
    T_03, T_05 = T_01 @ T_12 @ T_23, rprr().fk(CONFIGURATION)
    return Problem(
        statement="Give $T_{35}$ from $T_{30}$ and $T_{05}$.",
        answer=PoseAnswer(inverse(T_03) @ T_05),
        mistakes=[
            mistake(
                "not inverted",
                T_03 @ T_05,
                "You multiplied $T_{03} T_{05}$. The inner letters 3 and 0 differ, so nothing cancels: you need $T_{30}$ first.",
            ),
            mistake(
                "wrong side",
                T_05 @ inverse(T_03),
                "You multiplied $T_{05} T_{30}$. The inner letters 5 and 3 differ: put $T_{30}$ on the left, so that 0 meets 0.",
            ),
            mistake(
                "turned round",
                inverse(T_05) @ T_03,
                "This is $T_{53}$: link 3 seen from the tool. The first letter says who looks.",
            ),
            mistake(
                "positions subtracted",
                with_position(inverse(T_03) @ T_05, T_05[:3, 3] - T_03[:3, 3]),
                "The rotation is right. The arrow $p_{05} - p_{03}$ leads from link 3 to the tool, but it is written in frame 0: "
                "turn it with $R_{30}$.",
            ),
        ],
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
                "The columns are now unit and square, but left-handed: the determinant is $-1$, "
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
