"""The census, on one student and a third of the problems: feedback is held against answers that share no code with it.

Every night, evidence/test_many_answers.py does the same for all problems; `nox -s census` writes what the site shows.
"""

import pytest
from judge_outside import STUDENTS, a_third_of_each_sheet, assert_feedback_is_true


@pytest.mark.parametrize("template", a_third_of_each_sheet(), ids=lambda template: template.number)
def test_wrong_answers_have_no_full_marks_and_are_told_what_is_true(template):
    assert_feedback_is_true(template, STUDENTS[:1])
