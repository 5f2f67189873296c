"""Every sheet and every lecture step: the right answer scores, each mistake gets its own message, nothing breaks it."""

import json
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hostile_answers import HOSTILE, Rude
from odd_robots import generated_sheets

from kincourse import attempt, blanks, find_sheet, open_sheet, sheets
from misstep.answers.number import Numbers
from misstep.judge import judge
from misstep.sheet import SAMPLE_ID
from misstep.verdict import Verdict

OF_THE_COURSE = [template for name in sheets() for template in find_sheet(name).problems]
GENERATED = [template for sheet in generated_sheets() for template in sheet.problems]
TEMPLATES = [*OF_THE_COURSE, *GENERATED]
STEPS = list(blanks().values())
NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
STUDENTS = [f"student {i}" for i in range(200)]

SHARED = 30
"""So many students' variants are kept for all tests of this file; all 200 of every problem would fill the memory."""

FEW = 25
"""On how many variants a generated problem is tried here; tests/kincourse/test_new_sheet.py tries more robots."""


each_problem = pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
each_problem_and_step = pytest.mark.parametrize("template", TEMPLATES + STEPS, ids=lambda template: template.number)


@cache
def variant(template, student):
    """The problem of one student, drawn once for all tests of this file."""
    return template.variant(student)


def plain(template, answer):
    """What a student reads in a terminal: the card's plain text."""
    return Verdict(template, judge(variant(template, SAMPLE_ID), answer))._repr_mimebundle_()["text/plain"]


@each_problem
def test_on_200_variants_the_right_answer_scores_full_and_each_mistake_gets_its_own_message(template):
    for number, student in enumerate(STUDENTS[: FEW if template in GENERATED else None]):
        problem = variant(template, student) if number < SHARED else template.variant(student)
        assert judge(problem, problem.answer.value).fraction == 1.0
        for wrong in problem.mistakes:
            judgement = judge(problem, wrong.value)
            assert judgement.mistakes == [wrong.name]
            assert judgement.fraction < 1
            assert wrong.message in [finding.message for finding in judgement.findings]


@each_problem
def test_a_right_answer_typed_with_three_decimals_is_right(template):
    problem = variant(template, "ada")
    if isinstance(problem.answer, Numbers):
        assert judge(problem, np.round(problem.answer.value, 3).tolist()).state == "right"


@each_problem
def test_no_two_students_get_the_same_numbers(template):
    statements = {
        variant(template, student).statement + str(variant(template, student).answer.value)
        for student in STUDENTS[:SHARED]
    }
    assert len(statements) > 20


@each_problem
def test_a_problem_names_at_least_three_mistakes(template):
    assert len(variant(template, "ada").mistakes) >= 3


@each_problem_and_step
@pytest.mark.parametrize("blank", [..., None])
def test_a_blank_stub_earns_a_friendly_zero(template, blank):
    judgement = judge(variant(template, SAMPLE_ID), blank)
    assert (judgement.state, judgement.fraction) == ("blank", 0)
    assert "Nothing here yet" in plain(template, blank)
    assert variant(template, SAMPLE_ID).answer.expected in plain(template, blank)


@each_problem_and_step
@pytest.mark.parametrize("hostile", [*HOSTILE.values(), Rude()], ids=[*HOSTILE, "a rude object"])
def test_a_hostile_value_gets_a_card_that_says_what_was_expected(template, hostile):
    judgement = judge(variant(template, SAMPLE_ID), hostile)
    assert (judgement.state, judgement.fraction) == ("unreadable", 0)
    text = plain(template, hostile)
    assert "Expected" in text
    assert "cannot be read" in text
    assert len(text) < 1500


@each_problem_and_step
def test_the_section_to_reread_is_a_heading_of_its_lecture(template):
    notebook, _, section = template.lecture.partition("#")
    cells = json.loads((NOTEBOOKS / f"{notebook}.ipynb").read_text(encoding="utf-8"))["cells"]
    prose = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    assert section in re.findall(r"^#+ (.+)$", prose, flags=re.MULTILINE)


def test_ids_that_differ_in_case_or_blanks_are_one_student():
    assert (
        open_sheet("03_poe_space", " Ada").problem(1).statement
        == open_sheet("03_poe_space", "ada").problem(1).statement
    )


def test_a_sheet_counts_its_points():
    sheet = open_sheet("03_poe_space", "ada")
    sheet.check(1, sheet.problem(1).answer.value)
    sheet.check(2, ...)
    assert sheet.tally().score == 3
    assert "not checked yet" in sheet.tally()._repr_markdown_()


def test_the_last_answer_counts():
    sheet = open_sheet("03_poe_space", "ada")
    sheet.check(1, sheet.problem(1).answer.value)
    sheet.check(1, ...)
    assert sheet.tally().score == 0


def test_the_sample_id_is_pointed_out():
    assert "type your own id" in open_sheet("03_poe_space", SAMPLE_ID).tally()._repr_markdown_()
    assert "type your own id" in repr(open_sheet("03_poe_space", "Your ID"))
    assert "type your own id" not in open_sheet("03_poe_space", "ada").tally()._repr_markdown_()


def test_a_number_is_an_id_too():
    assert (
        open_sheet("03_poe_space", 1234567).problem(1).statement
        == open_sheet("03_poe_space", "1234567").problem(1).statement
    )


@pytest.mark.parametrize("student", ["", "  ", None, True, [7]])
def test_a_sheet_needs_a_student(student):
    with pytest.raises(ValueError, match="student must be your id"):
        open_sheet("03_poe_space", student)


def test_an_unknown_sheet_names_those_that_there_are():
    with pytest.raises(ValueError, match=r"no sheet '99'.*03_poe_space"):
        open_sheet("99", "ada")


def test_an_unknown_problem_names_the_range():
    sheet = open_sheet("03_poe_space", "ada")
    last = len(sheet.sheet.problems)
    with pytest.raises(ValueError, match=f"problems 1 to {last}; got {last + 1}"):
        sheet.check(last + 1, 0)


def test_an_unknown_step_names_those_that_there_are():
    with pytest.raises(ValueError, match="No lecture has a step"):
        attempt("00.z", 0)
