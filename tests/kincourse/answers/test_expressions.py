"""Operations of kinematics as parts of solutions: each wrong value, computed by hand, has the sentence that says what was done.

The words of a mistake are held against its value here, so that two mistakes cannot exchange their sentences.
"""

import numpy as np

from kincourse.answers.pose import PoseAnswer, RotationAnswer
from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.poses import exp, inverse, pose
from kincourse.expressions.screws import change_frame, direction, moment, prismatic, revolute, screw_axes
from kincourse.expressions.urdf import rpy_rotation
from kinlib import adjoint
from kinlib import exp as exponential
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.mutants.expression import given, product
from misstep.mutants.operations import ANGLE, SLIDE, radians
from misstep.problem import Problem

A = exponential([0.3, -0.8, 0.5, 0.2, 0.7, -0.4])
B = exponential([-0.6, 0.1, 0.9, -0.5, 0.3, 0.8])
W, P, D = np.array([0.0, 0.6, 0.8]), np.array([0.4, -0.1, 0.3]), np.array([0.8, 0.0, 0.6])
S = np.array([[0, 0.6, 0.8, 0.1, 0.4, -0.3], [0.8, 0, 0.6, 0.2, -0.5, 0.7], [0, 0, 0, 0, 0.6, 0.8]])
R, p = A[:3, :3], A[:3, 3]


def posed(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def x_rotation(q):
    return np.array([[1, 0, 0], [0, np.cos(q), -np.sin(q)], [0, np.sin(q), np.cos(q)]])


def z_rotation(q):
    return np.array([[np.cos(q), -np.sin(q), 0], [np.sin(q), np.cos(q), 0], [0, 0, 1]])


INVERSE = Problem("", PoseAnswer(np.linalg.inv(A) @ B), solution=inverse(pose("A", A)) @ pose("B", B))
FRAME = Problem("", ScrewsAnswer(S @ adjoint(A).T), solution=change_frame(pose("A", A), screw_axes("S", S)))
JOINT = Problem("", ScrewsAnswer(np.append(W, -np.cross(W, P))), solution=revolute(direction("w", W), given("p", P)))
SLIDING = Problem("", ScrewsAnswer(np.append(0 * D, D)), solution=prismatic(direction("d", D), given("p", P)))
MOMENT = Problem("", Numbers(-np.cross(W, P)), solution=moment(direction("w", W), given("p", P)))
RPY = Problem(
    "", RotationAnswer(z_rotation(0.7) @ x_rotation(0.4)), solution=rpy_rotation("R", np.array([0.4, 0, 0.7]))
)


def exponentials(q1, q2):
    first, second = exp(screw_axes("S_1", S[0]), q1), exp(screw_axes("S_3", S[2]), q2)
    return product(first, second, pose("M", A))


DRIVEN = exponentials(radians(given("q_1", 40.0, ANGLE)), given("q_2", 0.3, SLIDE))
FORM = Problem("", PoseAnswer(DRIVEN.value), solution=DRIVEN)
E1, E2 = exponential(S[0] * np.radians(40)), exponential(S[2] * 0.3)

CASES = {
    "A for its inverse": (INVERSE, A @ B, ["$A$, where its inverse belongs"], "transpose"),
    "the transpose": (INVERSE, A.T @ B, ["transpose $A$ instead of inverting it"], "where its inverse"),
    "-p": (INVERSE, posed(R.T, -p) @ B, ["$-p$ as the position"], "$-R\\,p$ as"),
    "-R p": (INVERSE, posed(R.T, -R @ p) @ B, ["$-R\\,p$ as the position"], "$-p$ as"),
    "p kept": (INVERSE, posed(R.T, p) @ B, ["position unchanged"], "minus"),
    "R^T p": (INVERSE, posed(R.T, R.T @ p) @ B, ["minus sign of $-R^T p$"], "unchanged"),
    "B inverted": (INVERSE, np.linalg.inv(A) @ np.linalg.inv(B), ["inverse of $B$ instead of $B$"], "$A$"),
    "the other order": (INVERSE, B @ np.linalg.inv(A), ["swap $A^{-1}$ and $B$"], "leave out"),
    "B alone": (INVERSE, B, ["leave out $A^{-1}$"], "swap "),
    "entry by entry": (INVERSE, np.linalg.inv(A) * B, ["entry by entry"], "swap "),
    "S @ Ad": (FRAME, S @ adjoint(A), ["without its transpose"], "inverse"),
    "Ad of the inverse": (FRAME, S @ np.linalg.inv(adjoint(A)).T, ["inverse of $A$"], "without its transpose"),
    "not changed": (FRAME, S, ["$S$ as it is"], "inverse"),
    "rotated only": (FRAME, np.hstack([S[:, :3] @ R.T, S[:, 3:] @ R.T]), ["rotate both halves"], "$S$ as it is"),
    "omega x p": (JOINT, np.append(W, np.cross(W, P)), ["\\omega \\times p", "without the minus sign"], "point itself"),
    "the point": (JOINT, np.append(W, P), ["the point itself"], "without the minus sign"),
    "no moment": (JOINT, np.append(W, 0 * P), ["leave out the moment"], "point itself"),
    "halves": (JOINT, np.append(-np.cross(W, P), W), ["(v, \\omega)"], "minus sign"),
    "omega for v": (SLIDING, np.append(D, 0 * D), ["direction of a prismatic joint into $\\omega$"], "revolute"),
    "a turn": (SLIDING, np.append(D, -np.cross(D, P)), ["as a revolute one"], "into $\\omega$"),
    "its moment": (SLIDING, np.append(0 * D, -np.cross(D, P)), ["moment of a prismatic joint"], "revolute"),
    "moment with its sign": (MOMENT, np.cross(W, P), ["\\omega \\times p", "minus sign"], "point itself"),
    "degrees": (FORM, exponential(S[0] * 40) @ E2 @ A, ["degrees of $q_1$ as radians"], "$q_2$"),
    "slide in radians": (
        FORM,
        E1 @ exponential(S[2] * np.radians(0.3)) @ A,
        ["$q_2$", "although it is a length"],
        "$q_1$",
    ),
    "M first": (FORM, A @ E1 @ E2, ["put $M$ first"], "leave out"),
    "no M": (FORM, E1 @ E2, ["leave out $M$"], "first"),
    "own axes": (RPY, x_rotation(0.4) @ z_rotation(0.7), ["own axes"], "yaw, pitch"),
    "yaw first": (RPY, z_rotation(0.4) @ x_rotation(0.7), ["yaw, pitch and roll"], "own axes"),
    "the parent's": (RPY, (z_rotation(0.7) @ x_rotation(0.4)).T, ["transpose $R$"], "yaw, pitch"),
}


def test_the_sentence_is_that_of_the_value():
    for case, (problem, answer, words, not_said) in CASES.items():
        finding = judge(problem, answer).findings[0]  # a second one is on rows that are right by chance
        assert all(word in finding.message for word in words), case
        assert not_said not in finding.message, case
