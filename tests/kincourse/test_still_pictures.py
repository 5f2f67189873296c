"""The picture below the title of each lecture is what the lecture begins with, and its text alternative says what it shows."""

import json
from pathlib import Path

import pytest

from kincourse import COURSE
from kincourse.still_pictures import first_picture, on_paper

FOLDER = Path(__file__).parents[2] / "notebooks"


@pytest.mark.parametrize("lecture", COURSE.lectures)
def test_the_picture_and_its_text_are_up_to_date(lecture):
    picture = first_picture(lecture)
    drawing = FOLDER / "pictures" / f"{lecture}.svg"
    assert drawing.read_text("utf-8") == on_paper(picture), "Run: kincourse pictures"
    assert drawing.stat().st_size < 40_000
    first = json.loads((FOLDER / f"{lecture}.ipynb").read_text("utf-8"))["cells"][0]
    alt = picture.alt.removeprefix(f"{picture.caption} ")
    assert f"![{alt}](pictures/{lecture}.svg)\n" in first["source"], "Run: kincourse pictures"
