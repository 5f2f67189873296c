"""The census, on two students: feedback is held against wrong answers that share no code with it.

`nox -s census` does the same for 60 students and writes what the site shows.
"""

from importlib.util import find_spec

import pytest

from evidence.answers_by_hand import answers_by_hand
from evidence.outside import outside_answers
from kincourse import find_sheet, sheets
from misstep.census import COUNTS, census_of

STUDENTS = ["a student of the tests", "another one"]

MAX_UNNAMED = 0.25
"""The largest share of the wrong answers by hand to one problem that may have no name."""

MAX_COINCIDENT = 0.25
"""The largest share of those that are told another story with the same numbers: what is said is true of the numbers, not of the maker."""

MAX_UNDESERVED = 0.2
"""The largest share of the answers from outside that may earn points for a part which any wrong method gets right."""

MAX_UNNAMED_OUTSIDE = 0.1
"""The same of the answers from outside."""

TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_feedback_is_true_and_names_most_mistakes(template):
    # The tests of the sheets judge what the engine itself makes.
    row = census_of(template, STUDENTS, answers_by_hand, own=False)
    is_new = not find_spec(f"evidence.answers_by_hand.lecture_{template.number[:2]}")  # a lecture that is being written
    assert row.by_hand > 0 or is_new
    wrong = {
        what: row.examples.get(what) for what in COUNTS if what not in {"unnamed", "coincident"} and row.counts[what]
    }
    assert not wrong
    assert row.counts["coincident"] <= MAX_COINCIDENT * row.by_hand, row.examples["coincident"]
    assert row.unnamed_by_hand <= MAX_UNNAMED * row.by_hand, row.examples["unnamed"]


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_answers_from_outside_have_no_full_marks_and_a_name(template):
    row = census_of(template, STUDENTS[:1], outside=outside_answers, own=False)
    wrong = {what: row.outside[what] for what in ("full marks", "refused") if row.outside[what]}
    assert not wrong, row.examples
    assert row.outside["undeserved"] <= MAX_UNDESERVED * row.outside["wrong"], row.examples["outside, undeserved"]
    assert row.outside["unnamed"] <= MAX_UNNAMED_OUTSIDE * row.outside["wrong"], row.examples["outside, unnamed"]
