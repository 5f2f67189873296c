"""The blank steps of lecture 04b: a column of the body Jacobian, and the twist that joint rates give."""

import numpy as np

from kincourse.answers.screws import ScrewsAnswer, TwistAnswer
from kincourse.expressions.poses import inverse
from kincourse.expressions.screws import change_frame, exponentials, joint_values, screw_axes
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import rpr
from misstep.display.text import matrix
from misstep.mutants.expression import given, total

TYPED = (30.0, 0.5, 90.0)
RATES = (0.2, 0.5, -0.4)
"""The joint values in degrees and metres, and the joint rates in rad/s and m/s."""


@problem("04b.a", "A column of the body Jacobian", points=1, lecture="04b_velocity#Body screws and the body Jacobian")
def column_1(_draw: ArmSampler) -> Problem:
    robot = rpr()
    B, q = robot.body_screws, np.array([np.radians(TYPED[0]), TYPED[1], np.radians(TYPED[2])])
    e = exponentials(B, joint_values(robot.joint_types, TYPED), "B")
    column = change_frame(inverse(e[1] @ e[2]), screw_axes("B_1", B[0])).mistaken_for(
        ("space Jacobian", "give the column of the space Jacobian", robot.jacobian(q)[:, 0], "It is axis 1 in {s}.")
    )
    return Problem(
        statement=f"The RPR arm has the body screws $B = {matrix(B)}$. At $q = (30°, 0.5$ m$, 90°)$, give column 1 of $J_b(q)$.",
        given={"body_screws": B},
        answer=ScrewsAnswer(column),
        advice={
            "frame not changed": "$B_1$ is the axis at home. Joints 2 and 3 are between it and the end-effector, and have moved since.",
            "inverse left out": "The joints move the end-effector, and the axis is seen from there: take $\\mathrm{Ad}^{-1}$.",
        },
        invisible=["rotation left out of the block"],  # at a right angle, the block is right without it, too
    )


@problem("04b.b", "The twist of the tool", points=1, lecture="04b_velocity#Joint rates and the twist of the tool")
def twist(_draw: ArmSampler) -> Problem:
    robot = rpr()
    q = np.array([np.radians(TYPED[0]), TYPED[1], np.radians(TYPED[2])])
    columns, rates = robot.body_jacobian(q).T, np.array(RATES)
    dq = [given(f"\\dot q_{i}", rate) for i, rate in enumerate(RATES, start=1)]
    axes = [screw_axes(f"J_{{b,{i}}}", column) for i, column in enumerate(columns, start=1)]
    V = total(*(rate * column for rate, column in zip(dq, axes, strict=True)))
    V = V.mistaken_for(
        ("at home", "use the body screws at home as columns", robot.body_screws.T @ rates, "The joints have moved."),
        ("space Jacobian", "use the space Jacobian", robot.jacobian(q) @ rates, "It gives the twist in {s}."),
        ("rates reversed", "use the rates in the reverse order", columns.T @ rates[::-1], ""),
        ("rates left out", "add up the columns without the rates", columns.sum(axis=0), "Multiply by the rates."),
        ("joint values for rates", "multiply by the joint values", columns.T @ q, "Multiply by the rates."),
    )
    return Problem(
        statement="In this configuration the joint rates of the RPR arm are $\\dot q = (0.2, 0.5, -0.4)$, in rad/s and m/s. Give "
        "$\\mathcal V_b$.",
        given={"rates": rates},
        answer=TwistAnswer(V),
        advice={"term left out": "Every joint that moves adds its column times its rate."},
    )
