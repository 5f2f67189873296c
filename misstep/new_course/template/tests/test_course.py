"""Every problem is tried with the numbers of many students and with every mistake that is known."""

import pytest

from misstep.census import census_of
from my_course import COURSE

PROBLEMS = [template for sheet in COURSE.sheets() for template in COURSE.find_sheet(sheet).problems]


@pytest.mark.parametrize("template", PROBLEMS, ids=lambda template: template.number)
def test_no_mistake_has_full_marks_and_each_has_its_true_name(template):
    row = census_of(template, [f"student {k}" for k in range(40)])
    assert row.wrong > 40
    assert not row.counts, row.examples
