"""DH tables as answers: every equivalent table is right, and the feedback on a wrong one says what is wrong."""

import numpy as np
import pytest

import kinlib as kl
from kincourse.answers.dh_table import MAX_TEXT_LENGTH, DHTableAnswer
from kincourse.answers.table_rows import wrong_rows
from kinlib import DHTable
from misstep.answers.base import Unreadable
from misstep.judge import judge
from misstep.problem import Problem

ROWS = [[0.3, 0.7, 0.2, 0], [0.25, -1.1, 0.35, 0.5], [0.4, 0.9, 0.15, 0]]
RIGHT = DHTable(ROWS, convention="standard")
RIGHT_TEXT = "a|alpha|d|theta\n0.3|0.7|0.2|q1\n0.25|-1.1|0.35|q2+0.5\n0.4|0.9|0.15|q3"


def judge_table(given, **options):
    return judge(Problem("Give the table.", DHTableAnswer(RIGHT, **options), []), given)


def rows_with(*entries):
    rows = np.array(ROWS)
    for row, column, value in entries:
        rows[row, column] = value
    return rows.tolist()


def test_numbers_dictionaries_and_text_are_read():
    named = [dict(zip(("a", "alpha", "d", "theta"), row, strict=True)) for row in ROWS]
    for row, number in zip(named, (1, 2, 3), strict=True):
        row["theta"] = f"q{number} + {row['theta']}"
    for given in (ROWS, RIGHT_TEXT, RIGHT_TEXT.ljust(MAX_TEXT_LENGTH), named, RIGHT):
        assert judge_table(given).state == "right"
    lengths = RIGHT_TEXT.replace("\n0.3", "\nl1")
    assert judge_table(lengths, lengths={"l1": 0.3}).state == "right"
    assert "Write its value in a line above the table, l1 = 0.3" in judge_table(lengths).findings[0].message
    assert DHTableAnswer(RIGHT).agrees(RIGHT, DHTable(ROWS[:2], convention="standard")) == [False]


def test_a_reversed_x_axis_and_another_zero_configuration_are_right():
    flipped = rows_with((0, 0, -0.3), (0, 1, -0.7), (0, 3, np.pi), (1, 3, 0.5 - np.pi))
    assert judge_table(flipped).state == "right"
    assert judge_table(rows_with((1, 3, 2.0))).state == "right"


def test_another_zero_configuration_is_wrong_if_the_table_is_anchored():
    judgement = judge_table(rows_with((1, 3, 1.5)), anchored=True)
    assert judgement.right_parts == ["row 1", "row 3"]
    assert judgement.findings[0].message == "All but one entry can stay as they are.\nLook again at $\\theta$ in row 2."


def other_frames(table):
    """The same arm with an x and a z reversed, and an origin moved along parallel axes."""
    rows, k = table.rows.copy(), 0 if table.convention == "standard" else 1
    rows[k, :2] *= -1
    rows[:2, 3] += np.pi, -np.pi
    rows[1, 2:] *= -1
    rows[k : k + 2, 1] += np.pi
    rows[2:4, 2] += 0.25, -0.25
    return table.changed(rows=rows, signs=[1, -1, 1, 1])


@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("choose", [lambda table: table, other_frames], ids=["our frames", "other frames"])
def test_a_wrong_row_costs_only_itself(convention, choose):
    rows = [[0.3, 0.7, 0.2, 0.4], [0.25, -1.1, 0.35, 0.5], [0.4, 0.0, 0.15, 0.3], [0.2, 0.0, 0.45, -0.6]]
    if convention == "modified":
        rows = [[0.0, 0.6, 0.5, 0.1], *rows[:3]]
        rows[3][0] = rows[2][0] = 0.2
        rows[2][1], rows[3][1] = -1.1, 0.0
    right = DHTable(rows, convention=convention)
    answer, theirs = DHTableAnswer(right, anchored=True), choose(right)
    assert wrong_rows(theirs, right) == ()
    for place in np.ndindex(4, 4):
        wrong = theirs.rows.copy()
        wrong[place] += 0.3
        assert len(wrong_rows(theirs.changed(rows=wrong), right)) == 1, place
    for places in ([0, 2], [1, 3], [0, 1]):
        wrong = theirs.rows.copy()
        wrong[places, [0, 1]] += 0.3, 0.4
        assert len(wrong_rows(theirs.changed(rows=wrong), right)) == 2, places
    assert judge(Problem("", answer, []), theirs.changed(rows=wrong)).fraction == 0.5


def test_a_mistake_in_the_whole_table_and_rows_of_zeros_earn_nothing():
    rows = np.array([[0, 0, 0, 0], [0.3, 0, 0, 0], [0.25, -1.1, 0.35, 0.5], [0.4, 0.9, 0.15, 0]])
    right = DHTable(rows, convention="modified")
    problem = Problem("", DHTableAnswer(right, anchored=True), [])
    for factors in ((1000, 1, 1000, 1), (1, -1, 1, 1), (1, 0, 1, 1), (1, 1, 0, 1)):
        assert judge(problem, (rows * factors).tolist()).fraction == 0, factors
    for order in ([2, 1, 0, 3], [0, 3, 2, 1], [3, 2, 1, 0]):
        assert judge(problem, rows[:, order].tolist()).fraction == 0, order
    guess = np.vstack([rows[:2], rows[2:] + 0.3])
    judgement = judge(problem, guess.tolist())
    assert (judgement.state, judgement.fraction) == ("wrong", 0)
    assert judgement.right_parts == ["row 1", "row 2"]
    one_of_zeros = rows.copy()
    one_of_zeros[0, 2] = 0.7
    assert judge(problem, one_of_zeros.tolist()).fraction == 0.75


def test_three_decimals_are_enough():
    right = DHTable(np.array(ROWS) * np.sqrt(2) / 2, convention="standard")
    printed = right.rows.round(3).tolist()
    for anchored in (False, True):
        assert judge(Problem("", DHTableAnswer(right, anchored=anchored), []), printed).state == "right"


def test_an_anchored_table_takes_base_and_tool_from_the_problem():
    ends = RIGHT.changed(base=kl.exp([0, 0, 1, 1, 0, 0]), tool=kl.exp([0, 1, 0, 0, 0, 2]))
    problem = Problem("", DHTableAnswer(ends, anchored=True), [])
    for rows in (ROWS, RIGHT, ends):  # RIGHT has no base and no tool, as the rows have none
        assert judge(problem, rows).state == "right"
    assert judge(problem, RIGHT.changed(base=ends.base)).state == "right"
    for end in ("base", "tool"):
        assert judge(problem, ends.changed(**{end: kl.exp([0, 0, 0, 0.1, 0, 0])})).state != "right"
    without_ends = Problem("", DHTableAnswer(RIGHT, anchored=True), [])
    assert judge(without_ends, ends).state != "right"


def test_a_flipped_joint_sign_is_wrong_if_the_table_is_anchored():
    """At half a turn both signs give the same pose, so several configurations must be compared."""
    text = RIGHT_TEXT.replace("|q1", "|-q1")
    assert judge_table(text).state == "right"
    assert judge_table(text, anchored=True).right_parts == ["row 2", "row 3"]


def test_a_right_table_says_how_it_differs_from_ours():
    backwards = RIGHT.changed(
        rows=rows_with((0, 1, 0.7 + np.pi), (1, 1, -1.1 + np.pi), (1, 2, -0.35), (1, 3, -0.5)), signs=[1, -1, 1]
    )
    assert judge_table(backwards, anchored=True).state == "right"
    free = DHTableAnswer(RIGHT).remark(RIGHT.changed(rows=rows_with((1, 3, 0.5 + np.pi / 2))))
    assert free == "Joint 2: its zero is -90° away."


def test_an_answer_that_is_no_table_of_this_arm_is_unreadable():
    expected = (
        r"^Expected a DH table in the standard convention with 3 joints \(RRR\): text with .* for the joint variables"
    )
    for given, words in [
        ("a|alpha|d|theta\n0|0|0|q1", r"; your table has 1 joints \(R\)\.$"),
        (RIGHT.converted("modified"), r"; your table is in the modified convention\.$"),
        ("nonsense", r"\. No table was found: .* one row in a line"),
        ([[0.1, 0.2, 0.3, 0.4]] * 13, r"; got list \[.*\], which is too long\.$"),
        (RIGHT_TEXT.ljust(MAX_TEXT_LENGTH + 1), "too long"),
    ]:
        with pytest.raises(Unreadable, match=f"(?s){expected}.*{words}"):
            DHTableAnswer(RIGHT).read(given)
