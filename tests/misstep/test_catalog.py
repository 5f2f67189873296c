"""Courses that are loaded by the path of their folder."""

import pytest

from misstep.catalog import forget_package, load_course

COURSE = 'from misstep import Course; COURSE = Course("halves_course")'


def write(folder, definition=COURSE, title="Halves", name="halves_course"):
    """Write a course with one empty sheet of this title."""
    course = folder / name
    lecture = course / "lecture_01_halves"
    lecture.mkdir(parents=True, exist_ok=True)
    (course / "__init__.py").write_text(definition)
    (lecture / "problems.py").write_text(f'from misstep import Sheet; SHEET = Sheet("01_halves", "{title}", [])')
    return course


@pytest.fixture(autouse=True)
def forget():
    yield
    forget_package("halves_course")


def test_a_course_of_the_same_name_in_another_folder_brings_its_own_sheets(tmp_path):
    for title in ("One", "Other"):
        assert load_course(write(tmp_path / title, title=title)).find_sheet("01_halves").title == title


def test_a_course_with_the_name_of_another_package_is_refused(tmp_path):
    import json

    with pytest.raises(ValueError, match=r"'json' is already imported from .*Rename the folder"):
        load_course(write(tmp_path, name="json"))
    assert __import__("json") is json
