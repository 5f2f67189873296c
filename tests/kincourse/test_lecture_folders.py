"""Each lecture has one folder with its files beside its notebook, and the lists of lectures name all of them."""

from pathlib import Path

from kincourse import COURSE, sheets
from kincourse.table_of_lectures import fill_home_page, lectures, table_rows

ROOT = Path(__file__).parents[2]


def test_a_lecture_has_its_files_and_its_notebooks():
    for name in COURSE.lectures:
        folder = COURSE.folder / f"lecture_{name}"
        files = (folder / "blanks.py", folder / "questions.toml", ROOT / "notebooks" / f"{name}.ipynb")
        assert all(file.is_file() for file in files), name
        for sheet in ("solutions", "exercises"):
            assert (ROOT / sheet / name / f"{name}.ipynb").is_file() == (name in sheets()), name
    assert {path.stem for path in (ROOT / "notebooks").glob("[0-9]*.ipynb")} == set(COURSE.lectures)


def test_the_readme_lists_every_lecture():
    rows = table_rows("notebooks", "[{problems}](exercises/{name}/{name}.ipynb)")
    assert rows in (ROOT / "README.md").read_text("utf-8"), f"write this table into README.md:\n{rows}"


def test_the_home_page_lists_every_lecture_twice_and_every_sheet():
    page = fill_home_page((ROOT / "site" / "pages" / "index.md").read_text("utf-8"))
    assert "{number" not in page
    table, _, navigation = page.partition("```{toctree}")
    for lecture in lectures():
        assert f"](lectures/{lecture.name}.ipynb) | {lecture.question} |" in table
        assert f"\n{lecture.number} {lecture.title} <lectures/{lecture.name}>\n" in navigation
        assert (f"](sheets/{lecture.name}.ipynb) |" in table) == bool(lecture.problems)
