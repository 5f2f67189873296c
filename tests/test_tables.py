"""DH tables as answers: every legal table is right, and a wrong one is told what is wrong with it."""

import numpy as np
import pytest

from kinlib import DHTable
from kinlib.practice.answers import Unreadable
from kinlib.practice.judge import judge
from kinlib.practice.problem import Problem
from kinlib.practice.tables import Table

ROWS = [[0.3, 0.7, 0.2, 0], [0.25, -1.1, 0.35, 0.5], [0.4, 0.9, 0.15, 0]]
RIGHT = DHTable(ROWS, convention="standard")


def judged(given, **options):
    return judge(Problem("Give the table.", Table(RIGHT, **options), []), given)


def changed(*entries):
    rows = np.array(ROWS)
    for row, column, value in entries:
        rows[row, column] = value
    return rows.tolist()


def test_numbers_dictionaries_and_text_are_read():
    text = "a|alpha|d|theta\n0.3|0.7|0.2|q1\n0.25|-1.1|0.35|q2+0.5\n0.4|0.9|0.15|q3"
    named = [dict(zip(("a", "alpha", "d", "theta"), row, strict=True)) for row in ROWS]
    for row, number in zip(named, (1, 2, 3), strict=True):
        row["theta"] = f"q{number} + {row['theta']}"
    assert [judged(given).state for given in (ROWS, text, named, RIGHT)] == ["right"] * 4


def test_a_flipped_x_and_another_zero_are_right():
    flipped = changed((0, 0, -0.3), (0, 1, -0.7), (0, 3, np.pi), (1, 3, 0.5 - np.pi))
    assert judged(flipped).state == "right"
    assert judged(changed((1, 3, 2.0))).state == "right"


def test_where_the_zero_counts_another_zero_is_wrong_and_told():
    judgement = judged(changed((1, 3, 1.5)), anchored=True)
    assert judgement.state == "wrong"
    assert judgement.findings[0].message.startswith(
        "Your table moves like the arm, from another start. Joint 2 has its zero"
    )


def test_three_decimals_are_enough():
    assert judged(np.round(ROWS, 3).tolist()).state == "right"


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (changed((1, 1, 1.1)), "Row 2: alpha has the wrong sign."),
        (changed((1, 0, 0.35), (1, 2, 0.25)), "Row 2: a and d are exchanged"),
        (changed((1, 2, 0.9)), "All but one entry can stand: look again at d in row 2."),
        (DHTable(ROWS, convention="modified"), "The table is in the standard convention, and was read as modified."),
        (DHTable(ROWS, convention="standard", joints="RPR"), "Which column holds the variable?"),
        (changed((0, 1, 0.1), (1, 0, 9.0), (1, 2, 5.0)), "Axes 1 and 2 make an angle"),
    ],
)
def test_a_wrong_table_is_told_what_is_wrong(given, words):
    assert words in judged(given).findings[0].message


@pytest.mark.parametrize("given", ["a|alpha|d|theta\n0|0|0|q1", "nonsense", [[1, 2]], "x" * 100_000, 7])
def test_what_is_no_table_of_this_arm_is_unreadable(given):
    with pytest.raises(Unreadable, match="Expected a DH table in the standard convention with 3 joints"):
        Table(RIGHT).read(given)
