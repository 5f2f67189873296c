"""Every lecture and sheet runs in a new kernel without warnings, and every figure has a text alternative."""

import re
from html.parser import HTMLParser
from pathlib import Path

import nbformat
import pytest
from kinsite.execute import execute

ROOT = Path(__file__).parents[2]
FILES = [path for folder in ("notebooks", "exercises") for path in sorted((ROOT / folder).rglob("*.ipynb"))]
NOTEBOOKS = [path for path in FILES if ".ipynb_checkpoints" not in path.parts]  # JupyterLab's copies
LECTURES = [path for path in NOTEBOOKS if path.parent.name == "notebooks"]

MIN_ALTERNATIVE_LENGTH = 20
"""Characters: "A figure" does not describe a picture; "an RPR arm at home, seen from above" does."""


def each(paths):
    return pytest.mark.parametrize("path", paths, ids=lambda path: path.relative_to(ROOT).as_posix())


# --- source ---


@each(LECTURES)
def test_a_lecture_begins_with_its_title_has_short_cells_and_no_html(path):
    """A student meets the first code cell first. Markdown can be printed, translated and read aloud reliably; HTML in it cannot."""
    cells = nbformat.read(path, as_version=4).cells
    assert cells[0].cell_type == "markdown"
    assert cells[0].source.startswith("# "), f"expected '# Title', got {cells[0].source[:60]!r}"
    code = [cell.source for cell in cells if cell.cell_type == "code"]
    assert not code or len(code[0].splitlines()) <= 5, "move what need not be read to the course"
    assert all(len(source.splitlines()) <= 15 for source in code), "move what students need not read to kinlib"
    html = {tag: cell.source for cell in cells if cell.cell_type == "markdown" for tag in find_html(cell.source)}
    assert not html, "write these as Markdown"


def find_html(markdown):
    text = re.sub(r"```.*?```|`[^`]*`|\$\$.*?\$\$|\$[^$]*\$", "", markdown, flags=re.DOTALL)
    return re.findall(r"</?[a-zA-Z][\w-]*(?:\s[^>]*)?/?>|<!--", text)


# --- execution ---


@each(NOTEBOOKS)
def test_a_notebook_runs_without_warnings_and_describes_its_figures(path):
    """The cache has what nbval has executed without a warning; any other notebook is executed here, and a warning raises."""
    outputs = [output for cell in execute(path).cells for output in cell.get("outputs", [])]
    undescribed = [what for output in outputs for what in without_alternative(output)]
    assert not undescribed, f"these figures need a text alternative: {undescribed}"


def without_alternative(output):
    """List the pictures in an output that have no text alternative."""
    data = output.get("data", {})
    if "text/html" not in data:
        return [kind for kind in data if kind.startswith("image/")]
    pictures = PictureParser()
    pictures.feed(data["text/html"])
    return pictures.undescribed


class PictureParser(HTMLParser):
    def __init__(self):
        super().__init__()
        self.undescribed = []

    def handle_starttag(self, tag, attributes):
        text = dict(attributes).get({"img": "alt", "svg": "aria-label"}.get(tag)) or ""
        if tag in ("img", "svg") and len(text.strip()) < MIN_ALTERNATIVE_LENGTH:
            self.undescribed.append(f"<{tag}> with the alternative {text!r}")
