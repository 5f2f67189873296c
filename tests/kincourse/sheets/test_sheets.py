"""Every sheet and every blank step: the right answer scores, each mistake has a message, and no answer breaks the judge."""

import json
import re
from collections import defaultdict
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from docutils.nodes import make_id
from hostile_answers import HOSTILE, Rude
from latex2mathml.converter import convert
from odd_robots import generated_sheet

from kincourse import attempt, blanks, find_question, find_sheet, open_sheet, sheets
from misstep.answers.expression import ClosedForm
from misstep.answers.number import Numbers
from misstep.display.lecture_address import page_address
from misstep.judge import judge
from misstep.mutants.mutants import nodes
from misstep.sheet import SAMPLE_ID
from misstep.verdict import Verdict
from misstep.worked_solution import worked_solution

SHEETS = [*map(find_sheet, sheets()), generated_sheet()]
TEMPLATES = [template for sheet in SHEETS for template in sheet.problems if template.level != "Open"]
OPEN = [template for sheet in SHEETS for template in sheet.problems if template.level == "Open"]
BLANK_STEPS = list(blanks().values())
NOTEBOOKS, SOLUTIONS = (Path(__file__).parents[3] / name for name in ("notebooks", "solutions"))
STUDENTS = [f"student {i}" for i in range(3)]


@cache
def drawn(template, student):
    """One variant serves several tests."""
    return template.variant(student)


each_problem = pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)


@each_problem
def test_right_answers_score_mistakes_have_messages_and_students_have_different_numbers(template):
    problem, *_ = problems = [drawn(template, student) for student in STUDENTS]
    assert len({one.statement + str(one.answer.value) for one in problems}) > 1
    assert len([*problem.known_mistakes, *problem.slips]) >= 3, "at least three mistakes"
    assert problem.further, "a question after a right answer"
    answer = problem.answer
    for wrong in problem.mistakes:
        judgement = judge(problem, wrong.value)
        assert judgement.mistakes == [wrong.name]
        assert judgement.fraction < 1
        assert wrong.message in [finding.message for finding in judgement.findings]
    if isinstance(answer, (Numbers, ClosedForm)):  # what a right answer fulfils, it fulfils
        rounded = np.round(answer.value, 3).tolist() if isinstance(answer, Numbers) else answer.value
        assert judge(problem, rounded).state == "right", "three decimals are enough"
        for right in (answer.value, rounded):
            assert not any(answer.check(answer.read(right), part) for part in range(len(answer.parts)))


@pytest.mark.parametrize("template", TEMPLATES + BLANK_STEPS, ids=lambda template: template.number)
def test_the_right_answer_is_accepted_and_followed_by_a_way_to_it(template):
    problem = drawn(template, STUDENTS[0])
    assert judge(problem, problem.answer.value).state == "right"
    assert all(worked_solution(problem))


@each_problem
def test_what_an_author_says_of_a_mistake_is_about_one_that_students_see(template):
    """A misspelled name, and a wrong answer of another shape, would be ignored without a word."""
    names, said, own = set(), set(), set()
    for problem in (drawn(template, student) for student in STUDENTS):
        found = [*problem.known_mistakes, *problem.slips]
        names |= {word for one in found for word in (one.name, one.did)}
        said |= {*problem.advice, *problem.invisible}
        solution = [] if problem.solution is None else nodes(next(problem.answer.at_inputs(problem.solution)))
        own |= {slip.did for node in solution for slip in node.alternatives}
    assert not (said | own) - names


def plain_text(template, judgement):
    """The feedback that a student reads in a terminal: the plain text of the card."""
    return Verdict(template, judgement)._repr_mimebundle_()["text/plain"]


def test_one_step_that_went_wrong_has_one_name_in_the_steps_01b_and_04c():
    inverse, product = (drawn(blanks()[number], STUDENTS[0]) for number in ("01.b", "04.c"))
    assert "or if" not in judge(inverse, np.linalg.inv(inverse.answer.value)).findings[0].message
    one_joint = [one.value for one in product.known_mistakes if one.name in ("sign of a joint value", "joint at zero")]
    assert len(np.unique(np.round(one_joint, 6), axis=0)) == 2 * 4 + 2  # and all four at once


def test_an_unfilled_answer_is_blank_and_a_hostile_value_gets_a_card_with_what_was_expected():
    """A value is read by the kind of answer, so one problem of each kind is enough."""
    pairs = [(template, drawn(template, STUDENTS[0])) for template in TEMPLATES + BLANK_STEPS]
    for template, problem in {type(problem.answer): (template, problem) for template, problem in pairs}.values():
        for blank in (..., None):
            judgement = judge(problem, blank)
            assert (judgement.state, judgement.fraction) == ("blank", 0)
            text = plain_text(template, judgement)
            assert "Nothing here yet" in text
            assert problem.answer.expected in text
        for what, hostile in {**HOSTILE, "a rude object": Rude()}.items():
            judgement = judge(problem, hostile)
            assert (judgement.state, judgement.fraction) == ("unreadable", 0), (template.number, what)
            text = plain_text(template, judgement)
            assert "Expected" in text, what
            assert "cannot be read" in text, what
            assert len(text) < 1500, what


def test_the_section_to_reread_is_a_heading_of_its_lecture():
    for template in TEMPLATES + BLANK_STEPS:
        notebook, _, section = template.lecture.partition("#")
        cells = json.loads((NOTEBOOKS / f"{notebook}.ipynb").read_text(encoding="utf-8"))["cells"]
        prose = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
        assert section in re.findall(r"^#+ (.+)$", prose, flags=re.MULTILINE), template.number
        expected = f"https://a.b/lectures/{notebook}.html#{make_id(section)}"
        assert page_address(template.lecture, "https://a.b") == expected


@pytest.mark.parametrize("name", sheets())
def test_a_sheet_is_a_ladder_from_two_warm_ups_to_two_hard_problems_and_an_open_one(name):
    levels = [template.level for template in find_sheet(name).problems]
    assert levels[:2] == ["Warm-up"] * 2
    assert (levels.count("Hard"), levels[-1], levels.count("Open")) == (2, "Open", 1)
    assert levels.count("Usual") >= 4


@pytest.mark.parametrize("name", sheets())
def test_every_official_solution_has_full_marks(name):
    """Where a problem is read off a drawing, the solution has what the drawing of SAMPLE_ID shows: update it with the drawing."""
    cells = json.loads((SOLUTIONS / name / f"{name}.ipynb").read_text("utf-8"))["cells"]
    names = {}
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code" and not source.startswith("sheet.show("):
            exec(source, names)
    verdicts, sheet = names["sheet"].verdicts, find_sheet(name)
    for k, template in enumerate(sheet.problems, start=1):
        assert verdicts[k].judgement.state == ("open" if template.level == "Open" else "right"), template.number


@pytest.mark.parametrize("template", OPEN, ids=lambda template: template.number)
def test_an_open_problem_is_kept_for_the_instructor_with_a_rubric_for_all_its_points(template):
    problem = template.variant(SAMPLE_ID)
    assert sum(problem.answer.rubric.values()) == template.points
    assert 3 <= len(problem.answer.rubric) <= 4
    assert judge(problem, problem.answer.value).state == "open"
    text = plain_text(template, judge(problem, "This is what I think of it."))
    assert f"Your instructor gives up to {template.points} points" in text
    assert judge(problem, "No.").state == "unreadable"
    assert judge(problem, ...).state == "blank"


def test_all_sheets_have_300_points_together():
    assert sum(find_sheet(name).points for name in sheets()) == 300


def test_ids_that_differ_only_in_case_or_spaces_are_the_same_student():
    def statement(student):
        return open_sheet("03_poe_space", student).problem(1).statement

    assert statement(" Ada") == statement("ada")
    assert statement(1234567) == statement("1234567") != statement("ada")
    for student in ("", "  ", None, True, [7]):
        with pytest.raises(ValueError, match="student must be your id"):
            open_sheet("03_poe_space", student)


def test_a_sheet_counts_the_points_of_the_last_answers_and_says_whose_they_are():
    sheet = open_sheet("03_poe_space", "ada")
    for k in (1, 2):
        sheet.check(k, sheet.problem(k).answer.value)
    sheet.check(2, ...)
    assert sheet.tally().score == 2
    assert "not checked yet" in sheet.tally()._repr_markdown_()
    assert "type your own id" not in sheet.tally()._repr_markdown_()
    assert "type your own id" in open_sheet("03_poe_space", SAMPLE_ID).tally()._repr_markdown_()
    assert "type your own id" in repr(open_sheet("03_poe_space", "Your ID"))


def test_unknown_sheets_problems_steps_and_questions_are_refused_with_those_that_there_are():
    sheet = open_sheet("03_poe_space", "ada")
    last = len(sheet.sheet.problems)
    for ask, says in [
        (lambda: open_sheet("99", "ada"), r"no sheet '99'.*03_poe_space"),
        (lambda: sheet.check(last + 1, 0), f"problems 1 to {last}; got {last + 1}"),
        (lambda: attempt("00.z", 0), r"no blank step '00.z'.*00.a"),
        (lambda: find_question("01/nothing"), r"no question '01/nothing'\. Lecture 01 has: "),
    ]:
        with pytest.raises(ValueError, match=says):
            ask()


# --- words and formulas of all problems ---


def test_one_change_has_one_name():
    names_of = defaultdict(set)
    for problem in (drawn(template, STUDENTS[0]) for template in TEMPLATES + OPEN):
        for mistake in [*problem.known_mistakes, *problem.slips]:
            if mistake.did and "$" not in mistake.did:  # a symbol may be an angle here and a length there
                names_of[mistake.did].add(mistake.name)
    assert {did: names for did, names in names_of.items() if len(names) > 1} == {}


def test_every_formula_of_a_statement_and_of_a_message_can_be_set():
    """On the page of feedback an invalid one would stand as it was typed."""
    formulas = set()
    for problem in (drawn(template, STUDENTS[0]) for template in TEMPLATES + OPEN):
        texts = [problem.statement, problem.method, problem.further]
        for text in [*texts, *(one.message for one in problem.known_mistakes)]:
            assert text.count("$") % 2 == 0, text
            assert not {*"\a\b\t\v\f\r"} & {*text}, "a backslash in a text must be doubled: " + text
            formulas |= {*re.findall(r"\$\$?([^$]+)\$\$?", text)}
    assert len(formulas) > 100
    for formula in formulas:
        assert convert(formula).startswith("<math"), formula
        assert "<mi>\\" not in convert(formula), f"an unknown command: {formula}"
        assert formula.count("{") == formula.count("}"), formula
