"""The blank steps of lecture 04: a body screw by the adjoint, one read in the tool's frame, and a pose with M in the middle."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.mistakes.space_form import negate_moment, product, swap_halves
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import mid_formula_arm, rpr
from kinlib.rigid.lie import adjoint, exp
from misstep.display.text import matrix, vector
from misstep.mistakes import mistake
from misstep.problem import Problem

CONFIGURATION_RAD = np.radians([90, -90, 90, 90])
"""The joint values of step 04.c: right angles, so that every entry of the pose can be checked on paper."""


@problem("04.a", "A body screw by the adjoint", points=1, lecture="04_poe_body#The adjoint")
def body_screw_by_the_adjoint(_draw: ArmSampler) -> Problem:
    robot = rpr()
    R, S = robot.home[:3, :3], robot.screws[0]
    return Problem(
        statement=f"The RPR arm has $S_1 = {vector(S)}$ and $M = {matrix(robot.home)}$. Give $B_1$.",
        given={"home": robot.home, "screw": S},
        answer=ScrewsAnswer(robot.body_screws[0]),
        mistakes=[
            mistake(
                "Ad_M",
                adjoint(robot.home) @ S,
                "You carried the screw with $\\mathrm{Ad}_M$. That takes what {b} reads to what {s} reads; here we go the other way.",
            ),
            mistake(
                "only rotated",
                np.concatenate([R.T @ S[:3], R.T @ S[3:]]),
                "You turned $\\omega$ and $v$, but the origin moved too: $v$ is the velocity at the new origin $p$, "
                "$R^T (v + \\omega \\times p)$.",
            ),
            mistake(
                "moment subtracted",
                np.concatenate([R.T @ S[:3], R.T @ (S[3:] - np.cross(S[:3], robot.home[:3, 3]))]),
                "You wrote $v - \\omega \\times p$. A point at $p$ moves with $v + \\omega \\times p$.",
            ),
            mistake(
                "moved, not turned",
                np.concatenate([S[:3], S[3:] + np.cross(S[:3], robot.home[:3, 3])]),
                "You moved the origin, but kept the axes of {s}. The axes of {b} turn both halves by $R^T$.",
            ),
            mistake(
                "space screw", S, "This is $S_1$, as {s} reads it. The tool stands elsewhere and reads other numbers."
            ),
            mistake(
                "halves swapped",
                swap_halves(robot.body_screws[0]),
                "You wrote $(v, \\omega)$. Here a screw is $(\\omega, v)$.",
            ),
        ],
    )


@problem("04.b", "A body screw read in the tool's frame", points=1, lecture="04_poe_body#The mid-formula form")
def body_screw_from_the_drawing(_draw: ArmSampler) -> Problem:
    robot = mid_formula_arm()
    R, B = robot.home[:3, :3], robot.body_screws[3]
    return Problem(
        statement="Joint 4 of the mid-formula arm turns about $y_b$, and its axis passes through $(0, 0, -0.2)$ in {b}. Give $B_4$.",
        answer=ScrewsAnswer(B),
        mistakes=[
            mistake(
                "omega x q",
                negate_moment(B),
                "You took $v = \\omega \\times p$. In {b} as in {s} it is $v = -\\omega \\times p$.",
            ),
            mistake(
                "no moment",
                np.concatenate([B[:3], np.zeros(3)]),
                "You left $v = 0$. That is joint 3: its axis passes through the origin of {b}. This one passes beside it.",
            ),
            mistake(
                "space screw",
                robot.screws[3],
                "This is $S_4$, read in {s}. After $M$ stand the screws that the tool reads.",
            ),
            mistake(
                "only rotated",
                np.concatenate([R.T @ robot.screws[3, :3], R.T @ robot.screws[3, 3:]]),
                "You turned both halves of $S_4$. The origin moves too: measure the point of the axis from the tool.",
            ),
            mistake("halves swapped", swap_halves(B), "You wrote $(v, \\omega)$. Here a screw is $(\\omega, v)$."),
        ],
    )


@problem("04.c", "The pose, with M in the middle", points=1, lecture="04_poe_body#The mid-formula form")
def pose_with_home_in_the_middle(_draw: ArmSampler) -> Problem:
    robot = mid_formula_arm()
    S, B, M = robot.screws, robot.body_screws, robot.home
    return Problem(
        statement=f"Give $T(q)$ of the mid-formula arm at $q = {vector(np.degrees(CONFIGURATION_RAD))}$ degrees, with $M$ after joint 2.",
        given={"screws": S, "body_screws": B, "home": M, "q": CONFIGURATION_RAD},
        answer=PoseAnswer(robot.fk(CONFIGURATION_RAD)),
        mistakes=[
            mistake(
                "space screws after M",
                _product_with_home_in_middle(robot, S, S),
                "You kept space screws to the right of $M$. Whatever has let $M$ past it is read by the tool: $B_3$ and $B_4$.",
            ),
            mistake(
                "body screws before M",
                _product_with_home_in_middle(robot, B, B),
                "You took body screws on both sides. To the left of $M$ the base reads: $S_1$ and $S_2$.",
            ),
            mistake(
                "sides exchanged",
                _product_with_home_in_middle(robot, B, S),
                "You exchanged the sides: space screws stand to the left of $M$, body screws to the right.",
            ),
            mistake(
                "M at the end",
                product(np.concatenate([S[:2], B[2:]]), CONFIGURATION_RAD, M),
                "You left $M$ at the end. It stands after joint 2, and the body screws follow it.",
            ),
            mistake(
                "reversed",
                product(S, CONFIGURATION_RAD, M, "reversed"),
                "You multiplied from the last joint to the first. Moving $M$ does not change the order of the joints.",
            ),
        ],
    )


def _product_with_home_in_middle(robot: Chain, before: Array, after: Array) -> Array:
    """The product with M after joint 2, with the screws `before` to its left and `after` to its right."""
    e = [exp(twist * value) for twist, value in zip([*before[:2], *after[2:]], CONFIGURATION_RAD, strict=True)]
    T: Array = e[0] @ e[1] @ robot.home @ e[2] @ e[3]
    return T


BLANKS = [body_screw_by_the_adjoint, body_screw_from_the_drawing, pose_with_home_in_the_middle]
