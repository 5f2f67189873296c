"""Each problem on the numbers of 200 students; tests/kincourse/sheets/test_sheets.py tries 10 of them in each run."""

import pytest
from right_and_wrong import assert_mistakes_are_named

from kincourse import find_sheet, sheets

STUDENTS = [f"student {i}" for i in range(200)]
TEMPLATES = [template for name in sheets() for template in find_sheet(name).problems]


@pytest.mark.parametrize("template", TEMPLATES, ids=lambda template: template.number)
def test_each_mistake_gets_its_own_message(template):
    for student in STUDENTS:
        assert_mistakes_are_named(template.variant(student))
