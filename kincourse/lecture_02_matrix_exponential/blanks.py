"""The blank steps of lecture 02: a translation part, a rotation, a pose, an axis that is not of unit length, and a logarithm."""

import numpy as np

from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.expressions.poses import assemble, inverse, logarithm, pose
from kincourse.expressions.rodrigues import position_exp, rotation_exp
from kincourse.expressions.screws import direction
from kincourse.problem import ArmSampler, Problem, problem
from kinlib.chains.robots import angled_arm, hrr, youbot
from kinlib.rigid.lie import exp, log
from misstep.answers.number import Numbers
from misstep.display.text import vector
from misstep.mutants.expression import Expression, given
from misstep.mutants.operations import ANGLE, radians

ONE_MOTION = "A screw axis is scaled as a whole."
TO_THE_ANGLE = "If you divide the axis by 2, multiply the angle by 2: $S\\,\\theta = (S / 2)\\,(2\\theta)$."


def third_of_a_turn() -> Expression:
    """The angle q of 120 degrees. At a quarter turn sin and 1 - cos are both 1, and those who swap them would be right."""
    return radians(given("q", 120.0, ANGLE))


@problem(
    "02.a", "The translation part of a rotation", points=1, lecture="02_matrix_exponential#From rotations to screws"
)
def p_column(_draw: ArmSampler) -> Problem:
    S = hrr().screws[1]
    p = position_exp(direction("\\omega", S[:3]), direction("v", S[3:]), third_of_a_turn())
    return Problem(
        statement=f"Give the translation part of $e^{{[S]q}}$ for $S = {vector(S)}$ and $q = 2\\pi/3$.",
        answer=Numbers(p, unit="m"),
    )


@problem("02.b", "A rotation about a tilted axis", points=1, lecture="02_matrix_exponential#The key identity")
def leaning_rotation(_draw: ArmSampler) -> Problem:
    R = rotation_exp(direction("\\omega", angled_arm().screws[1, :3]), third_of_a_turn())
    return Problem(
        statement="Give $R = e^{[\\omega]q}$ for joint 2 of the angled arm, $q = 2\\pi/3$.",
        answer=RotationAnswer(R),
        advice={"sign of an angle": "The first row of $[\\omega]$ is $(0, -\\omega_z, \\omega_y)$."},
    )


@problem("02.c", "The whole pose", points=1, lecture="02_matrix_exponential#From rotations to screws")
def leaning_pose(_draw: ArmSampler) -> Problem:
    S, q = angled_arm().screws[1], third_of_a_turn()
    omega = direction("\\omega", S[:3])
    p = position_exp(omega, direction("v", S[3:]), q).mistaken_for(
        ("point on the axis", "write the point of the joint", angled_arm().joint_points[1])
    )
    T = assemble(rotation_exp(omega, q), p)
    return Problem(
        statement="Give $e^{[S]q}$ for joint 2 of the angled arm, $q = 2\\pi/3$.",
        answer=PoseAnswer(T),
        advice={
            "point on the axis": "The column is the place to which the origin of {s} moves, not that of the joint.",
        },
    )


@problem("02.d", "An axis that is not of unit length", points=1, lecture="02_matrix_exponential#Bug hunt")
def long_axis(_draw: ArmSampler) -> Problem:
    w, v_0, angle = np.array([0.0, 0.0, 2.0]), np.array([1.0, 0.0, 0.0]), np.pi / 4
    omega, v, theta = direction("\\omega", w), direction("v", v_0), given("\\theta", angle, ANGLE)
    undivided = v.mistaken_for(("v not divided", "divide $\\omega$ by its length, but not $v$", 2 * v_0, ONE_MOTION))
    T = assemble(rotation_exp(omega, theta), position_exp(omega, undivided, theta))
    T = T.mistaken_for(
        ("angle kept", "divide $S$ by $|\\omega|$, and keep $\\theta$", exp(np.array([*w / 2, *v_0 / 2]) * angle)),
        ("angle kept", "divide $\\omega$ by $|\\omega|$, and keep $\\theta$", exp(np.array([*w / 2, *v_0]) * angle)),
    )
    return Problem(
        statement="Give $e^{[S]\\theta}$ for $\\omega = (0, 0, 2)$, $v = (1, 0, 0)$, $\\theta = \\pi/4$.",
        answer=PoseAnswer(T),
        invisible=("coefficients swapped", "cos for 1 - cos"),  # at a quarter turn, sin and 1 - cos are both 1
        advice={"angle kept": TO_THE_ANGLE},
    )


@problem("02.e", "The screw from one pose to another", points=1, lecture="02_matrix_exponential#The logarithm")
def screw_between(_draw: ArmSampler) -> Problem:
    arm = youbot()
    home, drawn = arm.home, arm.fk([0, 0, np.pi / 2, -np.pi / 2, -np.pi / 4])
    x = logarithm(pose("T_{sb}", drawn) @ inverse(pose("T_{sa}", home)))
    return Problem(
        statement="Give the twist $x$ in {s} with $e^{[x]} T_{sa} = T_{sb}$, from the youBot's home pose to its drawn configuration.",
        given={"T_sa": home, "T_sb": drawn},
        answer=Numbers(x.value),
        solution=x.mistaken_for(
            ("logs subtracted", "subtract logarithms", log(drawn) - log(home)),
        ),
        invisible=("position of the inverse", "rotation transposed"),  # the rotation of T_sa is I
        advice={
            "logs subtracted": "$\\log(AB) = \\log A + \\log B$ holds for positive numbers; you can rely on it only for motions "
            "that commute.",
            "order": "In this order, $x$ is the same screw motion, written in {a}: $T_{sa} e^{[x]} = T_{sb}$.",
            "factor left out": "The motion starts at $T_{sa}$ and ends at $T_{sb}$, so $e^{[x]} = T_{sb}\\,T_{sa}^{-1}$.",
        },
    )
