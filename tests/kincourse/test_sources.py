"""The page Sources says where each item of a deck is taught: these sections exist, and they speak of the item."""

import re
from pathlib import Path

import nbformat

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
LEAST_SHARE = 0.2
"""How many of the words of an item its section has at least. The rest is the deck's own wording."""
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


def words(text):
    return {word[:5] for word in re.findall(r"[a-z]{3,}|\d+", text.lower())}


def share(item, text):
    """Return how many of the words of an item a text has."""
    wanted = words(BOOK_NAMES.sub("", item))
    return len(wanted & words(text)) / max(len(wanted), 1)


def test_each_section_holds_its_item():
    found = list(rows())
    assert len(found) > 59
    assert [(name, title) for _, name, title in found if not section(name, title)] == []
    assert [(item, name, title) for item, name, title in found if share(item, section(name, title)) < LEAST_SHARE] == []
