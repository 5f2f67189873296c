"""The quiz on DH tables: any number of arms, every right table accepted, and feedback on wrong ones."""

import pytest

from kincourse import quiz
from kincourse.dh_quiz import EMPTY_TABLE, draw_problem
from kinlib import DHTable, assign_frames


def as_text(table):
    """Write a table as a student would type it."""
    lines = ["a | alpha | d | theta"]
    for number, (letter, (a, alpha, d, theta)) in enumerate(zip(table.joints, table.rows, strict=True), start=1):
        moves = (
            (f"{d:.12g}", f"q{number} + {theta:.12g}") if letter == "R" else (f"q{number} + {d:.12g}", f"{theta:.12g}")
        )
        lines.append(" | ".join([f"{a:.12g}", f"{alpha:.12g}", *moves]))
    return "\n".join(lines)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_arms_accept_their_own_table_and_its_conversion(convention):
    for number in range(15):
        right = draw_problem(f"seed {number}", convention).answer
        for table in (right.value, right.value.converted("standard").converted(convention)):
            assert all(right.agrees(right.read(as_text(table)), right.value))


def test_checking_a_table_counts_it_once_and_another_arm_follows():
    game = quiz("standard", seed="test")
    first = game._statement_box.value
    typed = as_text(game.problem.answer.value)
    assert game.check(typed).state == "right"
    assert game.check(typed).state == "right"
    assert (game.right, game.asked) == (1, 1)
    assert "1 right of 1" in game._feedback_box.value
    game.another()
    assert game.asked == 2
    assert game._statement_box.value != first
    assert game._table_box.value == EMPTY_TABLE


def test_the_other_convention_is_recognised():
    game = quiz("standard", seed="test 5")
    arm = game.problem.answer.value.to_chain()
    other = assign_frames(arm, convention="modified").table
    judgement = game.check(DHTable(other.rows, convention="standard", joints=other.joints))
    assert judgement.mistakes == ["other convention"]
    assert "in the other convention" in game._feedback_box.value
