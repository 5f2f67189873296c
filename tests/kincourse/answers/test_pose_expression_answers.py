"""Poses as formulas: the rotation and the position are judged separately."""

import sympy as sp

import kinlib as kl
from kincourse.answers.pose_expression import PoseExpressionAnswer

q_1 = sp.Symbol("q_1", real=True)
a_2 = sp.Symbol("a_2", positive=True)
T = kl.symbolic.exp(kl.symbolic.screw((0, 0, 1), point=(a_2, 0, 0)) * q_1)
TEXT = "[[c1, -s1, 0, a2(1 - c1)], [s1, c1, 0, -a2 s1], [0, 0, 1, 0], [0, 0, 0, 1]]"


def agreement(given):
    answer = PoseExpressionAnswer(T)
    return answer.agrees(answer.read(given), T)


def test_a_pose_may_be_given_as_text_or_as_kinlib_computed_it():
    assert agreement(T) == agreement(TEXT) == agreement(f"Matrix({TEXT})") == [True, True]


def test_the_rotation_and_the_position_are_judged_separately_each_with_its_share_of_the_last_row():
    assert agreement(sp.eye(4)) == [False, False]
    assert agreement(TEXT.replace("a2(1 - c1)", "a2")) == [True, False]
    assert agreement(TEXT.replace("0, 0, 0, 1", "0, 0, 0, 0")) == [True, False]
    assert agreement(TEXT.replace("0, 0, 0, 1", "0, 1, 0, 1")) == [False, True]
