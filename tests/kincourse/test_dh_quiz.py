"""The quiz on DH tables: any number of arms, every right table accepted, and feedback on wrong ones."""

from itertools import product

import pytest

from kincourse import quiz
from kincourse.dh_quiz import (
    CLEAR,
    EMPTY_TABLE,
    MISTAKES,
    draw_next,
    draw_problem,
    separation,
    suspects_after,
    wrong_tables,
)
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


def test_the_same_seed_draws_the_same_arms():
    assert quiz("standard", seed="x").problem.statement == quiz("standard", seed="x").problem.statement
    assert quiz("standard").problem.statement != quiz("standard").problem.statement


def test_another_convention_is_refused():
    with pytest.raises(ValueError, match="convention must be"):
        quiz("craig")


# --- which arm comes next ---

TIE = ("column shifted", "other convention")
"""On some arms the columns a and alpha one row off are a table of the other convention, and on others not."""


def total(problem, names=TIE):
    return sum(separation(problem, names).values())


def with_mistake(problem, name):
    """A table of the arm with a mistake."""
    return next(table for made, table in wrong_tables(problem.answer.value) if made == name)


def test_mistakes_that_tie_on_some_arms_lead_to_different_tables_of_the_next_one():
    def is_clear(problem):
        return min(separation(problem, TIE).values()) >= CLEAR

    assert sum(not is_clear(draw_problem(f"seed {number}/0", "standard")) for number in range(8)) >= 2
    assert all(is_clear(draw_next(f"seed {number}", "standard", TIE)) for number in range(8))


def test_a_right_table_excludes_the_mistakes_that_would_have_shown_and_an_unexplained_one_none():
    for convention in ("standard", "modified"):
        problem = draw_problem("seed 1", convention)
        right = problem.answer.value
        left = suspects_after((), problem, right)
        assert left == {name for name in MISTAKES if not separation(problem, [name])[name]}
        assert total(draw_next("seed 1", convention, left), left) > 0
        assert suspects_after({"sign of d"}, problem, right.changed(rows=right.rows + 0.3)) == {"sign of d"}


def test_a_wrong_table_leaves_the_mistakes_that_explain_it():
    for name, number in product(["other convention", "a and d swapped"], (0, 1, 3)):
        problem = draw_problem(f"seed {number}", "standard")
        wrong = with_mistake(problem, name)
        left = suspects_after((), problem, wrong)
        assert name in left
        assert len(left) < len(MISTAKES) / 2
        assert suspects_after({name}, problem, wrong) == {name}
        assert suspects_after({"sign of d"}, problem, wrong) == left


def test_only_the_first_table_of_an_arm_changes_the_suspicion():
    game = quiz("standard", seed="test 5")
    game.check("no table")
    assert game.suspects == set()
    game.check(with_mistake(game.problem, "other convention"))
    suspected = game.suspects
    assert "other convention" in suspected
    game.check(game.problem.answer.value)
    assert game.suspects == suspected
    game.another()
    game.check(game.problem.answer.value)
    assert game.suspects != suspected
