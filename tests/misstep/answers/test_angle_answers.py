"""Angles as answers: compared modulo full turns, and in any order if the problem allows it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.angle import Angles

right = st.lists(st.floats(-3, 3), min_size=2, max_size=4)


@given(right, st.data())
def test_full_turns_and_the_order_make_no_difference(angles, data):
    answer = Angles(np.array(angles), any_order=True)
    turns = data.draw(st.lists(st.integers(-3, 3), min_size=len(angles), max_size=len(angles)))
    mixed = data.draw(st.permutations(angles))
    read = answer.read(np.array(mixed) + 2 * np.pi * np.array(turns))
    assert all(answer.agrees(read, answer.value))


@given(st.floats(-3, 3), st.floats(0.01, 6.27))
def test_a_different_angle_is_wrong(angle, off):
    answer = Angles(np.array(angle))
    assert not any(answer.agrees(answer.read(angle + off), answer.value))


def test_in_any_order_one_right_angle_of_two_is_recognised_and_otherwise_the_order_counts():
    for any_order, typed, right in [(False, [-0.5, 0.5], [False, False]), (True, [2.0, 0.5], [False, True])]:
        answer = Angles(np.array([0.5, -0.5]), any_order=any_order)
        assert sorted(answer.agrees(answer.read(typed), answer.value)) == right
