"""Each lecture has one folder with its files beside its notebook, and the lists of lectures name all of them."""

import re
from pathlib import Path

import pytest

from kincourse import COURSE, sheets
from kincourse.table_of_lectures import FILES_WITH_LISTS, fill_home_page, lectures, with_lists

ROOT = Path(__file__).parents[2]


def test_a_lecture_has_its_files_and_its_notebooks():
    for name in COURSE.lectures:
        folder = COURSE.folder / f"lecture_{name}"
        files = (folder / "blanks.py", folder / "questions.toml", ROOT / "notebooks" / f"{name}.ipynb")
        assert all(file.is_file() for file in files), name
        for sheet in ("solutions", "exercises"):
            assert (ROOT / sheet / name / f"{name}.ipynb").is_file() == (name in sheets()), name
    assert {path.stem for path in (ROOT / "notebooks").glob("[0-9]*.ipynb")} == set(COURSE.lectures)


@pytest.mark.parametrize("name", FILES_WITH_LISTS)
def test_the_lists_of_lectures_and_the_size_of_the_course_are_up_to_date(name):
    text = (ROOT / name).read_text("utf-8")
    assert text == with_lists(text), "run: nox -s tidy"
    outdated = re.sub(
        r"It has \w+ lecture(.*?)sheets with \d+", r"It has two lecture\1sheets with 7", text, flags=re.DOTALL
    )
    assert outdated != text == with_lists(outdated)


def test_the_home_page_lists_every_lecture_twice_and_every_sheet():
    page = fill_home_page((ROOT / "site" / "pages" / "index.md").read_text("utf-8"))
    assert "{number" not in page
    table, _, navigation = page.partition("```{toctree}")
    for lecture in lectures():
        assert f"](lectures/{lecture.name}.ipynb) | {lecture.question} |" in table
        assert f"\n{lecture.number} {lecture.title} <lectures/{lecture.name}>\n" in navigation
        assert (f"](sheets/{lecture.name}.ipynb) |" in table) == bool(lecture.problems)
