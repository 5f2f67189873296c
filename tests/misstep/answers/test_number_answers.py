"""Numbers as answers: how near is near enough, what is read, what an answer resembles, and the slips of any angle."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.angle import Angles
from misstep.answers.base import Unreadable
from misstep.answers.number import Equivalent, Numbers
from misstep.judge import judge
from misstep.problem import Problem


def is_right(right, given, **more):
    answer = Numbers(np.array(right, dtype=float), **more)
    return all(answer.agrees(answer.read(given), answer.value))


def mistakes(answer, typed):
    return judge(Problem("", answer), typed).mistakes


def test_a_number_is_compared_on_the_scale_of_the_numbers_of_its_kind():
    for right, near, far in [
        (3e-7, 3.0009e-7, 0.0),
        (3e-7, 2.9992e-7, 3.02e-7),
        (1e-17, 0.0, 2e-3),
        (0.0512, 0.05128, 0.051),
        (0.3234, 0.323, 0.322),
        ([0.5, 3e-7], [0.5, -0.0008], [0.5, 0.0012]),
        ([0.05, 3e-7], [0.05, 9e-5], [0.05, 2e-4]),
        ([12.0, 0.5], [12.011, 0.5009], [12.0, 0.5012]),
    ]:
        assert is_right(right, near)
        assert not is_right(right, far)
    assert is_right(3e-7, 0.0, scale=1)


@given(st.floats(1e-11, 1e9), st.booleans())
def test_three_decimals_and_three_digits_of_a_number_are_enough_if_it_is_small(size, negative):
    number = -size if negative else size
    if size < 1:
        assert is_right(number, float(f"{number:.2e}"))
    assert is_right(number, round(number, 3)) or size < 0.1


def test_an_array_of_another_shape_is_refused_with_a_remedy():
    for right, odd, words in [
        (np.zeros(3), [[1, 2], [3]], "whose rows differ in length"),
        (np.zeros((2, 3)), np.zeros((3, 2)), "try .T"),
        (np.zeros((2, 2)), [1, 0, 0, 1], "try np.reshape(..., (2, 2))"),
        (np.zeros(2), "1, 2", "Give a list without quotes"),
    ]:
        with pytest.raises(Unreadable) as refusal:
            Numbers(right).read(odd)
        assert words in str(refusal.value)


MATRIX = np.array([[1.0, 2.0, 0.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]])


def test_what_an_answer_resembles_is_named_and_true():
    for typed, name, words in [
        (MATRIX.T, "transposed", "transpose of the right one"),
        (-MATRIX, "all signs", "every one is wrong"),
        (1000 * MATRIX, "millimetres", "right in millimetres"),
        (MATRIX[[0, 2, 1]], "rows in another order", "Two rows are swapped.\nThey are rows 2 and 3."),
        (MATRIX * [[1, -1, 1], [1, 1, 1], [1, 1, 1]], "signs", "this is right.\nLook at the sign of row 1, column 2."),
        (MATRIX**2 + 1, None, "We do not recognise"),
        (MATRIX + 5 * np.eye(3, k=2), "one entry", "8 of the 9 entries are right.\nLook at row 1, column 3."),
        (np.zeros((3, 3)), "placeholder", "Every number is 0"),
    ]:
        [finding] = judge(Problem("", Numbers(MATRIX, unit="m")), typed).findings
        assert finding.mistake == name
        assert words in finding.message


def test_a_number_is_called_rounded_if_two_of_its_digits_are_left_and_no_rotation_that_was_left_out():
    turned = ([[0.5, -0.866], [0.866, 0.5]], [[0, -1], [1, 0]], False)
    for right, typed, told in [turned, (0.7732, 0.77, 1), (0.0637, 0.06, 0), (34.94, 35, 1), (0.7732, 0.78, 0)]:
        assert ("rounded" in mistakes(Numbers(np.array(right)), typed)) == told


def test_of_a_right_answer_in_another_form_no_entry_is_called_wrong():
    right = np.array([0.8, 0.6, 0.0, 0.0])
    answer = Equivalent(right, meaning=lambda q: np.outer(q, q))
    assert mistakes(answer, right * (1, -1, 1, 1)) == []
    assert mistakes(answer, 2 * right) == ["doubled"]


@given(st.lists(st.floats(-3, 3).map(lambda x: round(x, 2)), min_size=1, max_size=3))
def test_no_slip_of_an_angle_is_the_right_answer(angles):
    problem = Problem("", Angles(np.array(angles), any_order=True))
    for slip in problem.slips:
        assert judge(problem, slip.value).state != "right"


def test_a_placeholder_earns_nothing_and_says_nothing_of_its_parts():
    class Listed(Numbers):
        parts = ("a", "b", "c")

        def part_indices(self):
            return [0, 1, 2]

    judgement = judge(Problem("", Listed(np.array([1.0, 2.5, 1.0])), []), [1, 1, 1])
    assert (judgement.fraction, list(judgement.right_parts)) == (0.0, [])
    assert [finding.text for finding in judgement.findings] == ["Every number is 1. Put in the numbers that you find."]


def test_a_test_of_the_author_is_shown_with_what_is_not_recognised():
    answer = Numbers(np.array(3.0), test=lambda x: "" if abs(x - 3) < 0.01 else f"Its square is {x * x:g}, and not 9.")
    found = [judge(Problem("", answer, []), x).findings for x in (4.0, -2.0)]
    assert [finding.check for [finding] in found] == ["Its square is 16, and not 9.", "Its square is 4, and not 9."]


def test_a_longer_unit_is_not_cut_to_the_right_one():
    with pytest.raises(Unreadable, match=r"'470.8 mm/s' is not a number"):
        Numbers(np.array(0.4708), unit="m/s").read("470.8 mm/s")
    assert (
        judge(Problem("", Numbers(np.array(0.4708), unit="m/s"), []), "470.8 m/s")
        .findings[0]
        .message.startswith("This is right in millimetres per second.")
    )


# --- angles ---

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
