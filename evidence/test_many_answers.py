"""The answers from outside to all problems; tests/evidence/test_answers_from_outside.py judges those to a third in each run."""

import pytest
from judge_outside import STUDENTS, assert_feedback_is_true, tasks_of_a_robot

from kincourse import find_sheet, sheets

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


@pytest.mark.parametrize("template", [*TEMPLATES, *tasks_of_a_robot()], ids=lambda template: template.number)
def test_wrong_answers_have_no_full_marks_and_are_told_what_is_true(template):
    assert_feedback_is_true(template, STUDENTS)
