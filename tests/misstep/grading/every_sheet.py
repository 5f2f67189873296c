"""Each habit of students on each sheet, and each sheet with a key: `nox -s every_sheet`, which takes some minutes."""

import re

import pytest
from habits import HABITS, SHEETS, grade_habit, solution, solved
from submissions import ROOT, as_bytes, handed_in, right

from misstep.grading.collect.run_plan import read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.sheet import SAMPLE_ID

GUIDE = (ROOT / "site" / "instructors.md").read_text("utf-8")
KEY_TABLE = {row[0]: row[1:] for row in re.findall(r"^\| (\d\d) \| (\d+) of (\d+) \| (.*) \|$", GUIDE, re.MULTILINE)}
"""By the number of a sheet: how many problems the key covers, of how many, and which it does not cover."""


@pytest.mark.parametrize("sheet", SHEETS)
def test_no_habit_costs_a_point(sheet):
    with Grader(read_released_sheet(solution(sheet))) as grader:
        results = {habit: grade_habit(grader, habit) for habit in HABITS}
    assert {habit: one.points for habit, one in results.items() if one.points < one.max} == {}


@pytest.mark.parametrize("sheet", SHEETS)
def test_with_a_key_computed_answers_keep_their_points_and_typed_ones_earn_none(sheet):
    with Grader(read_released_sheet(solution(sheet), key="a key for this test")) as grader:
        honest = grader.grade(SAMPLE_ID, as_bytes(solved(sheet)))
        typed = grader.grade("ada", as_bytes(handed_in("ada", right("ada", sheet), name=sheet)))
    assert honest.points == honest.max
    assert not any(one.points for one in typed.problems if one.own_points is not None)
    not_covered = [one.number for one in typed.problems if one.own_points is None]
    counts = str(len(typed.problems) - len(not_covered)), str(len(typed.problems))
    assert KEY_TABLE[sheet[:2]] == (*counts, ", ".join(not_covered) or "-")
