"""Numbers as answers: how near is near enough, what looks rounded, what a hint says, and slips that are made by hand."""

from functools import partial

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from misstep.answers.angle import Angles
from misstep.answers.base import Unreadable
from misstep.answers.entries import entries_hint, looks_rounded
from misstep.answers.equivalent import Equivalent
from misstep.answers.function import Function
from misstep.answers.groups.ordering import Ordering
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.problem import Problem


def is_right(right, given, **more):
    answer = Numbers(np.array(right, dtype=float), **more)
    return all(answer.agrees(answer.read(given), answer.value))


# --- near enough ---


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


@given(st.floats(1e-11, 1e9), st.booleans())
def test_three_decimals_and_three_digits_of_a_number_are_enough_if_it_is_small(size, negative):
    number = -size if negative else size
    if size < 1:
        assert is_right(number, float(f"{number:.2e}"))
    assert is_right(number, round(number, 3)) or size < 0.1


# --- rounded ---


def test_the_right_answer_rounded_looks_rounded_and_another_difference_does_not():
    for right, rounded in [
        (0.7041, 0.7),
        (0.0998, 0.1),
        (0.125, 0.13),
        ([0.7071, 0.0032], [0.71, 0.0]),
        ([12.346, 0.34], [12.3, 0.3]),
        ([1.0, 0.0, 0.7071], [1.0, 0.0, 0.707]),
    ]:
        assert looks_rounded(np.array(rounded), np.array(right)), rounded
    for right, wrong in [
        (0.7071, 0.7),
        (0.7071, -0.71),
        (0.0203, 0.0),
        (0.7071, 0.7071),
        ([1.2345, 0.0203], [1.2345, 0.0]),
        ([1.2345, 0.0203], [1.23, 0.0]),
        ([0.7071, 0.5], [0.71, 0.51]),
        ([0.0, 0.7071], [0.01, 0.71]),
        (np.zeros(2), [0.0, 0.01]),
    ]:
        assert not looks_rounded(np.array(wrong), np.array(right)), wrong


@given(st.lists(st.floats(-1e3, 1e3).filter(lambda x: abs(x) > 1e-3), min_size=1, max_size=6), st.integers(2, 6))
def test_every_rounding_to_two_or_more_digits_is_recognised(right, digits):
    rounded = np.array([float(f"{x:.{digits - 1}e}") for x in right])
    changed = np.abs(rounded - right) > 1e-9 * np.abs(right) + 1e-12
    assert looks_rounded(rounded, np.array(right)) == changed.any()


def test_a_function_is_rounded_if_each_of_its_outputs_is():
    answer = Function(np.square, Numbers(np.zeros(2)), lambda chance: (chance.uniform(1, 2, 2),))
    rounded = answer.read(lambda x: [float(f"{v * v:.1e}") for v in x])
    assert answer.is_rounded(rounded, 0)
    assert not answer.is_rounded(answer.read(lambda x: x * x + 0.0123), 0)
    assert not answer.is_rounded(answer.read(np.square), 0)


# --- hints and messages ---


def test_a_hint_says_where_at_most_two_entries_are_wrong_in_grammar():
    hints = {
        (1, 0, 0): "1 of the 3 entries is right. Look at entry 2 and entry 3.",
        (1, 0, 0, 0): "1 of the 4 entries is right. Look at entry 2 first.",
        ((1, 0), (1, 1)): "3 of the 4 entries are right. Look at row 1, column 2.",
        (0, 0): "",
        (1, 1): "",
    }
    assert {same: entries_hint(np.array(same, dtype=bool)) for same in hints} == hints
    assert Numbers(np.array(1.0)).hint(np.array(2.0), 0) == ""
    pair = Numbers(np.array([1.0, 2.0]))
    assert pair.hint(np.array([1.0, 3.0]), 0) == "1 of the 2 entries is right. Look at entry 2."


class Silent:
    """An object whose text is an address in memory."""


def test_a_message_for_what_is_not_a_number_says_what_it_is_and_no_address():
    for right, odd, words in [
        (0.0, np.sin, "got the function sin. Give its value"),
        (0.0, partial(max, 0), "got the function. Give its value"),
        ([0.0, 0.0], [np.sin, len], "got list [the function sin, the function len]"),
        (0.0, Silent(), "got an object of class Silent"),
        (0.0, [1.0, 2.0], "got a list of shape (2,)."),
        (np.eye(2), [1, 0, 0, 1], "got a list of shape (4,)"),
    ]:
        with pytest.raises(Unreadable) as refusal:
            Numbers(np.array(right)).read(odd)
        assert words in str(refusal.value)
        assert "0x" not in str(refusal.value)


# --- equivalent values ---

QUATERNION = np.array([0.8, 0.6, 0.0, 0.0])
QUATERNIONS = Equivalent(QUATERNION, meaning=lambda q: np.outer(q, q))


def test_nothing_is_said_of_single_entries_where_several_values_are_right():
    assert QUATERNIONS.hint(QUATERNION * (1, -1, 1, 1), 0) == ""
    assert list(QUATERNIONS.slips()) == []


# --- slips ---


class Listed(Numbers):
    """Numbers each of which is a part."""

    parts = ("a", "b", "c")

    def part_indices(self):
        return [0, 1, 2]


def slips(answer):
    return {(slip.name, slip.message): slip.value for slip in answer.slips()}


def test_the_slips_of_a_matrix_are_what_their_texts_say():
    right = np.array([[1.0, 2.0, 0.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]])
    found = slips(Numbers(right, unit="m"))
    expected = {
        ("transposed", "Your answer is the transpose of the right one."): right.T,
        ("all signs", "The sizes are right, but every sign is wrong."): -right,
        ("millimetres", "This is right in millimetres. Give it in metres."): 1000 * right,
        ("rows swapped", "Rows 2 and 3 are swapped."): right[[0, 2, 1]],
        ("columns swapped", "Columns 1 and 2 are swapped."): right[:, [1, 0, 2]],
        ("sign of one entry", "Only one sign is wrong: row 1, column 2."): right * [[1, -1, 1], [1, 1, 1], [1, 1, 1]],
        ("two entries swapped", "Two entries are swapped: row 1, column 1 and row 2, column 1."): [
            [4, 2, 0],
            [1, 5, 6],
            [7, 8, 9],
        ],
    }
    for key, value in expected.items():
        np.testing.assert_array_equal(found[key], value)
    np.testing.assert_array_equal(found["doubled", "Your answer is twice the right one."], 2 * right)
    np.testing.assert_array_equal(found["halved", "Your answer is half the right one."], right / 2)
    assert len(found) == 1 + 1 + 2 + 1 + 4 + 8 + 18


def test_twice_and_half_an_angle_are_said_of_numbers_within_half_a_turn():
    within, beyond = np.array([0.5, 0.7]), np.array([2.1, 3.8])
    assert {"doubled", "halved"} <= {name for name, _ in slips(Angles(within))}
    doubled, *others = [judge(Problem("", Angles(beyond), []), factor * beyond).findings for factor in (2, 0.5)]
    assert [finding.message for finding in doubled] == ["Your answer is twice the right one, up to full turns."]
    assert not any("half the" in finding.message for found in others for finding in found)


def test_a_placeholder_earns_nothing_and_says_nothing_of_its_parts():
    three = Listed(np.array([1.0, 2.5, 1.0]))
    judgement = judge(Problem("", three, []), [1, 1, 1])
    assert (judgement.fraction, list(judgement.right_parts)) == (0.0, [])
    assert [finding.text for finding in judgement.findings] == ["Every number is 1. Put in the numbers that you find."]
    assert judge(Problem("", Listed(np.ones(3)), []), [1, 1, 1]).state == "right"


def test_a_test_of_the_author_is_shown_with_what_is_not_recognised():
    answer = Numbers(np.array(3.0), test=lambda x: "" if abs(x - 3) < 0.01 else f"Its square is {x * x:g}, and not 9.")
    found = [judge(Problem("", answer, []), x).findings for x in (4.0, -3.0)]
    assert [finding.check for [finding] in found] == ["Its square is 16, and not 9.", "Its square is 9, and not 9."]


def test_the_slips_of_an_order_are_what_their_texts_say():
    found = slips(Ordering(list("abcd")))
    assert {text: "".join(value) for (_, text), value in found.items()} == {
        "Your order is the right one, reversed.": "dcba",
        "Only a is in the wrong place: at the end.": "bcda",
        "Only d is in the wrong place: at the beginning.": "dabc",
        "Only a and b are swapped.": "bacd",
        "Only b and c are swapped.": "acbd",
        "Only c and d are swapped.": "abdc",
        "Only a is in the wrong place.": "bcad",
        "Only d is in the wrong place.": "adbc",
        "Only b is in the wrong place: at the end.": "acdb",
        "Only c is in the wrong place: at the beginning.": "cabd",
    }


def test_a_function_has_the_slips_of_its_outputs_at_any_input():
    matrix = Function(
        lambda x: np.array([[x, 1.0], [2.0, x]]), Numbers(np.zeros((2, 2))), lambda chance: (chance.uniform(1, 2),)
    )
    for answer in (matrix, matrix.with_inputs(5)):
        found = {slip.name: (slip.value, slip.message) for slip in answer.slips()}
        transposed, text = found["transposed"]
        assert text == "At every input that was tried: your answer is the transpose of the right one."
        assert answer.agrees(answer.read(lambda x: np.array([[x, 2.0], [1.0, x]])), transposed) == [True]
        assert not any(map(all, (answer.agrees(value, answer.value) for value, _ in found.values())))


@given(st.lists(st.floats(-9, 9).map(lambda x: round(x, 2)), min_size=4, max_size=4), st.integers(0, 2))
def test_no_slip_is_right_and_no_two_are_alike(entries, kind):
    """Also of numbers with few slips, such as 0, pi/4 and the identity."""
    answer = [
        Numbers(np.reshape(entries, (2, 2)), unit="m"),
        Angles(np.array(entries[:2]), any_order=True),
        Angles(np.array(entries[0])),
    ][kind]
    found = list(answer.slips())
    assert not any(all(answer.agrees(slip.value, answer.value)) for slip in found)
    assert all(slip.message for slip in found)
    assert len({slip.value.tobytes() for slip in found}) == len(found)
