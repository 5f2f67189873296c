"""Each lecture has one folder with its files and its picture, and the lists of lectures name what there is."""

import json
import re
from pathlib import Path

import pytest

from kincourse import COURSE, find_sheet, sheets
from kincourse.still_pictures import first_picture, on_paper
from kincourse.table_of_lectures import table_rows

ROOT = Path(__file__).parents[2]
NOTEBOOKS = ROOT / "notebooks"


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


def sources(name):
    return ["".join(cell["source"]) for cell in json.loads((NOTEBOOKS / f"{name}.ipynb").read_text("utf-8"))["cells"]]


def test_the_page_of_sources_names_sections_and_problems_that_exist():
    text = sources("sources")[-1]
    sections = re.findall(r"\[\w+\]\((\w+)\.ipynb\) ([^|;]+?)(?=;| \|)", text)
    assert len(sections) > 80
    for lecture, section in sections:
        assert re.search(rf"(?m)^#+ {re.escape(section)}$", "\n".join(sources(lecture))), (lecture, section)
    for sheet, numbers in re.findall(r"exercises/(\w+)/\w+\.ipynb\) problems? ([\d, to]+)", text):
        assert max(map(int, re.findall(r"\d+", numbers))) <= len(find_sheet(sheet).problems), (sheet, numbers)


@pytest.mark.parametrize("lecture", COURSE.lectures)
def test_the_picture_below_the_title_and_its_text_are_up_to_date(lecture):
    picture = first_picture(lecture)
    drawing = NOTEBOOKS / "pictures" / f"{lecture}.svg"
    assert drawing.read_text("utf-8") == on_paper(picture), "Run: kincourse pictures"
    assert drawing.stat().st_size < 40_000
    alt = picture.alt.removeprefix(f"{picture.caption} ")
    assert f"![{alt}](pictures/{lecture}.svg)\n" in sources(lecture)[0], "Run: kincourse pictures"
