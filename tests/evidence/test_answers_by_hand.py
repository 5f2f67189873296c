"""The census, on two students: feedback is held against wrong answers that share no code with it.

`nox -s census` does the same for 60 students and writes what the site shows.
"""

from importlib.util import find_spec

import pytest

from evidence.answers_by_hand import answers_by_hand
from kincourse import find_sheet, sheets
from misstep.census import COUNTS, census_of

STUDENTS = ["a student of the tests", "another one"]

MAX_UNNAMED = 0.25
"""The largest share of the wrong answers by hand to one problem that may have no name."""

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_feedback_is_true_and_names_most_mistakes(template):
    row = census_of(template, STUDENTS, answers_by_hand)
    is_new = not find_spec(f"evidence.answers_by_hand.lecture_{template.number[:2]}")  # a lecture that is being written
    assert row.by_hand > 0 or is_new
    wrong = {what: row.examples.get(what) for what in COUNTS if what != "unnamed" and row.counts[what]}
    assert not wrong
    assert row.unnamed_by_hand <= MAX_UNNAMED * row.by_hand, row.examples["unnamed"]
