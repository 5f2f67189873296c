"""Tables from papers and data sheets: right, or told which mistake, or which two, and mended."""

import numpy as np
import pytest

import kinlib as kl
from kinlib import DHTable, assign_frames, diagnose, equivalent

PUMA = kl.robots.puma560()
YOUBOT = kl.robots.youbot()
STANDARD = assign_frames(PUMA, convention="standard").table
MODIFIED = assign_frames(PUMA, convention="modified").table


def with_entries(table, *entries):
    rows = np.array(table.rows)
    for row, column, value in entries:
        rows[row - 1, ("a", "alpha", "d", "theta").index(column)] = value
    return table.changed(rows=rows)


def exchanged(table, row):
    a, _, d, _ = table.rows[row - 1]
    return with_entries(table, (row, "a", d), (row, "d", a))


@pytest.mark.parametrize("table", [STANDARD, MODIFIED, STANDARD.converted("modified")])
def test_a_right_table_is_right(table):
    found = diagnose(table, PUMA)
    assert found.right
    assert str(found).startswith("This table is the arm.")


def test_zeros_signs_base_and_tool_are_told_and_not_held_against_a_table():
    theirs = DHTable("a|alpha|d|theta\n0.4|0|0|-q1\n0.3|0|0|q2 + pi/2", convention="standard")
    ours = DHTable("a|alpha|d|theta\n0.4|0|0|q1\n0.3|0|0|q2", convention="standard", base=kl.exp([0, 0, 0, 1, 2, 3]))
    found = diagnose(theirs, ours)
    assert found.right
    assert "Joint 1 counts the other way." in str(found)
    assert "Joint 2 has its zero elsewhere, by -1.571." in str(found)
    assert "The base frames differ" in str(found)


WRONG = {
    "other convention": MODIFIED.changed(convention="standard"),
    "a and d exchanged": exchanged(STANDARD, 2),
    "wrong number": with_entries(STANDARD, (3, "a", 0.3)),
    "variable in the wrong column": STANDARD.changed(joints="RRPRRR"),
    "column shifted": STANDARD.changed(
        rows=np.hstack([np.roll(STANDARD.rows[:, :2], -1, axis=0), STANDARD.rows[:, 2:]])
    ),
}


@pytest.mark.parametrize(("name", "table"), WRONG.items(), ids=WRONG)
def test_each_mistake_is_named_and_mended(name, table):
    found = diagnose(table, PUMA)
    assert [fault.name for fault in found.faults] == [name]
    assert found.corrected is not None
    assert equivalent(found.corrected, PUMA)


def test_the_row_and_the_entry_are_named():
    (fault,) = diagnose(WRONG["wrong number"], PUMA).faults
    assert (fault.row, fault.column) == (3, "a")
    assert fault.text == "Row 3: a should be 0.0203; the table says 0.3."
    (fault,) = diagnose(WRONG["a and d exchanged"], PUMA).faults
    assert fault.row == 2


def test_an_anti_parallel_axis_with_alpha_0_is_named():
    """Axes 2 and 3 point opposite ways. What stands on both sides of them tells left from right."""
    right = DHTable(
        [[0.4, 0.6, 0.1, 0], [0.3, np.pi, 0.2, 0], [0.2, 0.7, 0.3, 0], [0.1, 0.4, 0.2, 0]], convention="standard"
    )
    found = diagnose(with_entries(right, (2, "alpha", 0.0)), right)
    assert [(fault.name, fault.row, fault.column) for fault in found.faults] == [("anti-parallel", 2, "alpha")]


def test_at_the_end_of_an_arm_an_anti_parallel_axis_may_be_turned_round():
    """Axis 1 of this arm has nothing before it, so joint 1 may count the other way, and alpha = 0 is as right as pi."""
    right = DHTable([[0.4, np.pi, 0.1, 0], [0.3, 0.5, 0.2, 0], [0.2, 0.7, 0.3, 0]], convention="standard")
    found = diagnose(with_entries(right, (1, "alpha", 0.0)), right)
    assert found.right
    assert "Joint 1 counts the other way." in str(found)


def test_two_mistakes_together_are_both_named():
    right = DHTable(
        [[0.4, 0.6, 0.1, 0], [0.3, -0.9, 0.25, 0], [0.2, 1.2, 0.15, 0], [0, 0, 0, 0]], convention="standard"
    )
    wrong = exchanged(with_entries(right, (2, "alpha", 0.9)), 3)
    found = diagnose(wrong, right)
    assert sorted(fault.name for fault in found.faults) == ["a and d exchanged", "sign of alpha"]
    assert [fault.row for fault in found.faults if fault.name == "a and d exchanged"] == [3]
    assert equivalent(found.corrected, right)


def test_what_nothing_explains_is_said_with_the_first_difference():
    right = DHTable(np.random.default_rng(0).uniform(0.2, 1, (4, 4)), convention="standard")
    wrong = DHTable(np.random.default_rng(1).uniform(0.2, 1, (4, 4)), convention="standard")
    found = diagnose(wrong, right)
    assert not found.right
    assert found.corrected is None
    assert "None of the mistakes that we know" in str(found)
    assert "Axes 1 and 2 make an angle of" in str(found)


def test_another_number_of_joints_is_refused():
    with pytest.raises(ValueError, match=r"The table has 6 joints \(RRRRRR\), and the arm 5 \(RRRRR\)"):
        diagnose(STANDARD, YOUBOT)
