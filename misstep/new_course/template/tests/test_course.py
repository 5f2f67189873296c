"""Every problem is tried with the numbers of many students and with every mistake that is known, and has its cells."""

from pathlib import Path

import pytest

from misstep.census import census_of
from my_course import COURSE

FOLDER = Path(__file__).parents[1]
PROBLEMS = [template for sheet in COURSE.sheets() for template in COURSE.find_sheet(sheet).problems]


@pytest.mark.parametrize("template", PROBLEMS, ids=lambda template: template.number)
def test_no_mistake_has_full_marks_and_each_has_its_true_name(template):
    if template.variant("student").answer.rubric:
        return  # a person marks it
    row = census_of(template, [f"student {k}" for k in range(40)])
    assert row.wrong > 40
    assert not row.counts, row.examples


@pytest.mark.parametrize("sheet", COURSE.sheets())
def test_the_notebook_of_a_sheet_checks_each_of_its_problems(sheet):
    text = (FOLDER / "solutions" / sheet / f"{sheet}.ipynb").read_text("utf-8")
    numbers = range(1, len(COURSE.find_sheet(sheet).problems) + 1)
    assert not [k for k in numbers if f"sheet.check({k}, " not in text], "These problems have no check cell."


@pytest.mark.parametrize("template", PROBLEMS, ids=lambda template: template.number)
def test_the_section_to_re_read_is_a_heading_of_the_lecture(template):
    lecture, _, section = template.lecture.partition("#")
    assert f"# {section}" in (FOLDER / "notebooks" / f"{lecture}.ipynb").read_text("utf-8")
