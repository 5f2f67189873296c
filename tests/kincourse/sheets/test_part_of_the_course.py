"""A course of somebody else takes problems of ours, changes sentences, and adds its own: as guides/other_courses.md describes."""

import re
from pathlib import Path

import pytest

from misstep.catalog import load_course

GUIDE = Path(__file__).parents[3] / "guides" / "other_courses.md"


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """The course of the guide, in a folder."""
    folder = tmp_path_factory.mktemp("own") / "cranes"
    section = GUIDE.read_text("utf-8").partition("## How to use a part of this course")[2]
    lecture = folder / "lecture_01_cranes"
    lecture.mkdir(parents=True)
    (lecture / "problems.py").write_text(re.search(r"```python\n(.*?)```", section, re.DOTALL)[1], "utf-8")
    (folder / "__init__.py").write_text(
        "from misstep import Course\n\nCOURSE = Course('cranes')\nopen_sheet = COURSE.open_sheet\n", "utf-8"
    )
    return folder


def test_a_sheet_has_problems_of_both_courses(course):
    sheet = load_course(str(course)).open_sheet("01_cranes", "ada")
    assert sheet.problem(2).statement.endswith("Gib ihre Schraubachse an.")
    given = sheet.given(2)
    wrong = sheet.check(2, [0, 0, 0, *given.direction])
    assert "without dividing it by its length" in wrong.judgement.findings[0].message
    assert sheet.check(3, sheet.given(3).boom).judgement.mistakes == ["the boom only"]
