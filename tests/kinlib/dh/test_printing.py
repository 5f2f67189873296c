"""Tables, chains, assignments and linkages print what they contain."""

import re

import numpy as np
import pytest
from hypothesis import given
from strategies import ROBOTS, chains_with_values

import kinlib as kl
from kinlib import DHTable
from kinlib.dh.assignment import AssignmentStep

CONVENTIONS = ["standard", "modified"]


@pytest.mark.parametrize("convention", CONVENTIONS)
@given(chains_with_values())
def test_a_printed_table_is_read_back(convention, drawn):
    chain, _ = drawn
    if "H" in chain.joint_types:
        return
    table = kl.assign_frames(chain, convention=convention).table
    again = DHTable(str(table), convention=convention)
    np.testing.assert_allclose(again.rows, table.rows, rtol=1e-11, atol=1e-9)
    assert again.joints == table.joints
    assert np.array_equal(again.signs, table.signs)
    for end in ("base", "tool"):
        np.testing.assert_allclose(getattr(again, end), getattr(table, end), rtol=1e-11, atol=1e-9)
    assert again.fk({f"q{i + 1}": 0 for i in range(table.n)}).shape == (4, 4)


def test_the_repr_of_a_result_says_what_its_text_says():
    step = AssignmentStep("x", 1, "x_1 is along the normal.", "The opposite direction.")
    assert str(step) == "x_1 is along the normal. (Also right: The opposite direction.)"
    table = kl.assign_frames(kl.robots.rpr(), convention="standard").table
    assert repr(table).startswith("DHTable('RPR', standard, 3 rows: RPR, base = [[")
    flipped = table.changed(signs=[1, 1, -1])
    for found in (kl.equivalent(table, flipped), kl.diagnose(table, flipped)):
        assert " ".join(str(found).splitlines()) in repr(found)
        assert "joint 3: " in repr(found)
    assert kl.equivalent(table, flipped).choices(1e-8) == [("signs", "joint 3: q counts in the opposite direction")]


@pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)
def test_a_printed_chain_can_be_built_again(robot):
    rows = re.findall(r"\((.*?)\) +\| \((.*?)\)", str(robot))
    numbers = np.array([[float(x) for half in row for x in half.split(", ")] for row in rows])
    np.testing.assert_allclose(numbers, robot.screws, atol=1e-3)
    home = np.array(eval(str(robot).rpartition("M = ")[2]))
    np.testing.assert_allclose(home, robot.home, atol=1e-3)
