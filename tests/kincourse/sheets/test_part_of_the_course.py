"""A course of somebody else takes problems of ours, changes sentences, and adds its own: as guides/other_courses.md describes."""

import csv
import re
from pathlib import Path

import pytest
import submissions

from misstep.catalog import load_course
from misstep.cli import main
from misstep.release.instructor_notebook import Entry, notebook

GUIDE = Path(__file__).parents[3] / "guides" / "other_courses.md"
RIGHT = {
    1: "given = sheet.given(1)\ntilt = np.radians(given.degrees)\n"
    "axis = np.cos(tilt) * given.from_axis + np.sin(tilt) * given.towards\n"
    "screw_1 = np.r_[axis, np.cross(given.point, axis)]",
    2: "given = sheet.given(2)\nd = given.direction / np.linalg.norm(given.direction)\nscrew_2 = np.r_[0, 0, 0, d]",
    3: "given = sheet.given(3)\nreach_3 = given.boom + given.jib",
}


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


@pytest.mark.skipif(bool(submissions.sandbox_lacks()), reason=f"this machine lacks {submissions.sandbox_lacks()}")
def test_the_sheet_is_graded_with_our_kinds_of_answers(course, tmp_path):
    sheet = load_course(str(course)).find_sheet("01_cranes")
    entries = [
        Entry("screw", "Six numbers.", RIGHT[1].partition("\n")[2]),
        Entry("screw", "Six numbers.", RIGHT[2].partition("\n")[2]),
        Entry("reach", "One number.", RIGHT[3].partition("\n")[2]),
    ]
    opening = "import numpy as np\nfrom cranes import open_sheet"
    solution = tmp_path / "solutions" / "01_cranes" / "01_cranes.ipynb"
    solution.parent.mkdir(parents=True)
    solution.write_text(notebook(sheet, entries, "Cranes.", opening), "utf-8")
    handed_in = tmp_path / "submissions" / "ada" / "01_cranes.ipynb"
    handed_in.parent.mkdir(parents=True)
    handed_in.write_text(solution.read_text("utf-8").replace("your id", "ada"), "utf-8")
    results = tmp_path / "results"
    command = ["grade", str(solution), str(tmp_path / "submissions"), "--out", str(results), "--course", str(course)]
    assert main(command) == 0
    with (results / "grades.csv").open(newline="", encoding="utf-8") as stream:
        assert {row["student"]: float(row["points"]) for row in csv.DictReader(stream)} == {"ada": 8}
