"""Habits of Jupyter cost no points, and what is lenient with them gives none. `nox -s every_sheet` tries each habit on each sheet."""

import re

import pytest
import submissions
from habits import cells_of, grade_habit, solution, solved, text
from submissions import as_bytes, code, names

if lacking := submissions.sandbox_lacks():
    pytest.skip(f"NO HABIT IS TRIED: this machine lacks {lacking}", allow_module_level=True)

from misstep.grading.collect.run_plan import PASSED_OVER, RERUN_SOURCE, read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.grading.publish.pages import feedback_page
from misstep.sheet import SAMPLE_ID

SHEET = "10_one_robot_four_ways"

SAMPLE = {
    "": "",
    "!pip install": "!pip install kinlib",
    "%matplotlib qt": "",
    "google.colab": "from google.colab import drive (ModuleNotFoundError",
    "import pandas, numpy": "import pandas as pd, numpy as np (ModuleNotFoundError",
    "input()": "student = input('Your id: ') (EOFError",
    "opening cell at the end": "",
    "opening cell deleted": "No id was found in the sheet",
    "sheet overwritten": "the variable sheet",
    "checks above answers": "",
    "answer set again below": "",
    "answers cleared at the end": "",
    "answers renamed": "",
    "helper at the end": "failed at first",
    "X (1).ipynb beside blank X.ipynb": f"{SHEET} (1).ipynb counts, because no other has more points",
}
"""Habits that are tried in every run, each with a part of the note."""

LARGE = {
    "plots at 150 dpi": r"\[\d+ outputs of this cell with \d+\.\d MB left out here; this costs no points\. At most 1 MB of a cell",
    "2,000 displays": r"\[1,?8\d\d outputs of this cell with 9\.\d MB left out here; this costs no points\.",
    "long prints in many cells": r"\[the rest of this output is left out\]",
}
"""Habits with more output than can be shown, and what the page says in its place."""


@pytest.fixture(scope="module")
def grader():
    with Grader(read_released_sheet(solution(SHEET))) as started:
        yield started


@pytest.mark.parametrize("habit", SAMPLE)
def test_a_habit_costs_nothing_and_the_note_says_what_was_passed_over(habit, grader):
    result = grade_habit(grader, habit)
    assert result.points == result.max, result.notes
    assert SAMPLE[habit] in " ".join(result.notes)
    if not habit:
        assert (result.reason, result.notes, [*filter(None, (one.notes for one in result.problems))]) == ("", [], [])


@pytest.mark.parametrize("habit", LARGE)
def test_much_output_costs_nothing_and_the_page_says_what_is_left_out(habit, grader):
    result = grade_habit(grader, habit)
    assert result.points == result.max, result.notes
    assert re.search(LARGE[habit], feedback_page(result))


# --- nothing is won ---

WRONG = "screw_1 = np.zeros(6)"

ABUSES = (
    "screw_1 = sheet.problem(1).answer.value",
    "found = sheet.problem(1).answer.value\nscrew_1 = found",
    "import nowhere\nscrew_1 = nowhere.answers[1]",
    "screw_1 = open('answers.txt').read()",
    "screw_1 = input('Which?')",
    "screw_1 = !solve 1",
    "1 / 0\nscrew_1 = kl.DHTable(given.rows, convention='standard').to_chain().screws[2]",
)


def points_of_first(grader, *cells, below=()):
    """The first problem's points, state and notes: these cells instead of its answer cell, and these below its check."""
    notebook = solved(SHEET)
    answer = notebook["cells"].index(cells_of(notebook, "answer")[1])
    notebook["cells"][answer : answer + 2] = [*map(code, cells), notebook["cells"][answer + 1], *map(code, below)]
    result = grader.grade(SAMPLE_ID, as_bytes(notebook))
    assert result.points - result.problems[0].points == result.max - result.problems[0].max
    return result.problems[0].points


def test_what_is_passed_over_gives_no_answer(grader):
    for abuse in ABUSES:
        assert points_of_first(grader, f"given = sheet.given(1)\nscrew_1 = ...\n{abuse}") == 0, abuse


def test_a_second_answer_is_no_second_guess(grader):
    """A wrong answer that was checked stays the answer, unless the execution counts show that the check ran again."""
    right = text(cells_of(solved(SHEET), "answer")[1])
    assert points_of_first(grader, WRONG, below=[right]) == 0
    assert points_of_first(grader, WRONG, below=[right, RERUN_SOURCE]) == 0
    assert points_of_first(grader, right, below=[WRONG]) > 0


def test_of_several_guesses_in_an_edited_check_the_last_one_counts(grader):
    for guesses in ("cabd", "abcd", "dcba"):
        notebook = solved(SHEET)
        answer, check = cells_of(notebook, "answer")[3], cells_of(notebook, "check")[3]
        assert names(SHEET)[3] == "wrong_3"
        answer["source"] = "wrong_3 = ..."
        check["source"] = f"for letter in {guesses!r}:\n    sheet.check(3, letter)"
        last = grader.grade(SAMPLE_ID, as_bytes(notebook)).problems[2]
        check["source"] = f"letter = {guesses[-1]!r}\nsheet.check(3, letter)"
        alone = grader.grade(SAMPLE_ID, as_bytes(notebook)).problems[2]
        assert last.points == alone.points


def test_a_note_that_a_student_writes_is_text_and_short(grader):
    notebook = solved(SHEET)
    notebook["cells"].append(code(f"for k in range(99): print({PASSED_OVER!r} + '<script>' * 99 + str(k))"))
    result = grader.grade(SAMPLE_ID, as_bytes(notebook))
    assert result.points == result.max
    assert all(len(note) < 1500 for note in result.notes)
