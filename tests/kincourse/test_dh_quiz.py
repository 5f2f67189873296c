"""The quiz on DH tables: any number of arms, every right table accepted, and feedback on wrong ones."""

import pytest

from kincourse.dh_quiz import EMPTY_TABLE, draw_problem, quiz
from kinlib import DHTable, assign_frames


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_arms_accept_their_own_table_and_its_conversion(convention):
    for number in range(15):
        right = draw_problem(f"seed {number}", convention).answer
        converted = right.value.converted("standard").converted(convention)
        assert all(right.agrees(right.read(converted), right.value))


def test_checking_a_table_counts_it_once_and_another_arm_follows():
    game = quiz("standard", seed="test")
    first, right = game._statement_box.value, game.problem.answer.value
    other = assign_frames(right.to_chain(), convention="modified").table
    judgement = game.check(DHTable(other.rows, convention="standard", joints=other.joints))
    assert judgement.mistakes == ["the other convention"]
    assert "in the other convention" in game._feedback_box.value
    assert [game.check(right).state for _ in range(2)] == ["right"] * 2
    assert (game.right, game.asked) == (1, 1)
    assert "1 right of 1" in game._feedback_box.value
    game.another()
    assert game.asked == 2
    assert game._statement_box.value != first
    assert game._table_box.value == EMPTY_TABLE
