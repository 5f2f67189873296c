"""The page Sources says where each item of a deck is taught: these sections exist, and they speak of the item."""

import re
from pathlib import Path

import nbformat
import pytest
from gate import RARITY
from giveaways import contains, tokens

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
LEAST_SHARE = 0.25
"""How much of an item, by the weight of its words and symbols, its section has at least. The rest is the deck's own wording."""
BOOK_NAMES = re.compile(r"fuzziest: |exercise \d\.\d+[,:]? ?|\([^)]*the slide[^)]*\)")


def rows():
    """Yield each item of a deck with the notebook and the title of each section that is named for it."""
    table = nbformat.read(NOTEBOOKS / "sources.ipynb", as_version=4).cells[-1].source
    for item, places in re.findall(r"^\| (.*?) \| (.*?) \|", table, re.MULTILINE):
        for name, title in re.findall(r"\[\d\d[a-z]?\]\((\w+)\.ipynb\) ([^;]+)", places):
            yield item, name, title.strip()


def section(name, title):
    """Return the text and the code of a section of a lecture."""
    cells = nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4).cells
    text = "\n".join(
        cell.source if cell.cell_type == "markdown" else f"\n{cell.source}".replace("\n#", "\n") for cell in cells
    )
    found = re.search(rf"^## {re.escape(title)}$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    return title + found[1] if found else ""


def share(item, text):
    """Return how much of an item a text has, by weight."""
    words = tokens(BOOK_NAMES.sub("", item))
    return RARITY.of(word for word in words if contains(tokens(text), word)) / RARITY.of(words)


def test_each_section_holds_its_item():
    found = list(rows())
    assert len(found) > 59
    assert [(name, title) for _, name, title in found if not section(name, title)] == []
    assert [(item, name, title) for item, name, title in found if share(item, section(name, title)) < LEAST_SHARE] == []


@pytest.mark.parametrize(("item", "name", "title"), [("table of the youBot, units", "05_dh_standard", "Summary")])
def test_a_wrong_section_is_found(item, name, title):
    assert share(item, section(name, title)) < LEAST_SHARE
