"""The page Sources says where each item of a deck is taught: these sections exist."""

import re
from pathlib import Path

import nbformat

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


def headings(name):
    cells = nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4).cells
    return [line for cell in cells if cell.cell_type == "markdown" for line in cell.source.splitlines()]


def test_each_section_that_is_named_for_an_item_exists():
    table = nbformat.read(NOTEBOOKS / "sources.ipynb", as_version=4).cells[-1].source
    places = re.findall(r"\[\d\d[a-z]?\]\((\w+)\.ipynb\) ([^;|]+)", table)
    assert len(places) > 59
    assert [(name, title) for name, title in places if f"## {title.strip()}" not in headings(name)] == []
