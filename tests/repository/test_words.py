"""Texts use the textbook's words: these house words are in no lecture, question, sheet, picture or message."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
HOUSE_WORDS = {
    r"square to\b": "perpendicular to",
    r"\bfreedoms\b": "degrees of freedom",
    r"\bpostures?\b": "configuration",
    r"\bturned round\b": "negated, or rotated by 180 degrees",
    r"\b[Ww]hoever\b": "a person who, or: if you",
    r"(?<![a-z,] )\bWho (says|said|takes|answers|answered|lets|thinks|expects|reads)\b(?![^.\n]*\?)": "If you said",
    r"\bthe (UIUC|EduFill|review|Chapter 4 review|Lecture 7) deck\b": "a line that names its source",
}
FILES = [
    *sorted(ROOT.glob("notebooks/*.ipynb")),
    *sorted(ROOT.glob("exercises/*/*.ipynb")),
    *sorted(ROOT.glob("solutions/*/*.ipynb")),
    *sorted(ROOT.glob("kincourse/**/*.toml")),
    *sorted(ROOT.glob("kincourse/**/*.py")),
    *sorted(ROOT.glob("kinlib/**/*.py")),
    *sorted(ROOT.glob("kinlib/view/js/**/*.js")),
]


def text_of(path):
    """The text of a file; of a notebook, the sources of its cells."""
    text = path.read_text("utf-8")
    if path.suffix == ".ipynb":
        return "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"])
    return text


@pytest.mark.parametrize("word", HOUSE_WORDS)
def test_no_text_has_a_house_word(word):
    found = [f"{path.relative_to(ROOT)}: {match[0]}" for path in FILES for match in re.finditer(word, text_of(path))]
    assert not found, f"write {HOUSE_WORDS[word]}:\n" + "\n".join(found)


@pytest.mark.parametrize(
    "text", ["an axis square to z", "two freedoms", "Who says below took", "the UIUC deck prints", "its posture"]
)
def test_house_words_are_found(text):
    assert any(re.search(word, text) for word in HOUSE_WORDS)


def test_questions_and_degrees_of_freedom_are_no_house_words():
    for text in ("Who said it?", "six degrees of freedom", "the square of 3", "a person who says so"):
        assert not any(re.search(word, text) for word in HOUSE_WORDS)
