"""Texts use the textbook's words: these house words are in no lecture, question, sheet, picture or message."""

import json
import re
from pathlib import Path

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


def house_words(text):
    """What to write instead of each house word of a text."""
    return [f"{match[0]}: write {better}" for word, better in HOUSE_WORDS.items() for match in re.finditer(word, text)]


def test_no_text_has_a_house_word():
    found = {path.relative_to(ROOT).as_posix(): house_words(text_of(path)) for path in FILES}
    assert {name: words for name, words in found.items() if words} == {}


def test_house_words_are_found_and_no_others():
    for text in ("an axis square to z", "two freedoms", "Who says below took", "the UIUC deck prints", "its posture"):
        assert house_words(text), text
    for text in ("Who said it?", "six degrees of freedom", "the square of 3", "a person who says so"):
        assert not house_words(text), text
