"""How many minutes a lecture takes: words, formulas, lines of code, pictures and tasks are counted, each at a stated rate.

The rates are near the minutes that readers of lectures 02, 05 and 08 counted for each section: 98, 84 and 82 minutes, with the
blank steps solved by hand. No class has been measured with a clock. Side tracks do not count.
"""

import re

from nbformat import NotebookNode
from prose_numbers import named

RATES = {
    "words": 1 / 180,
    "numbered formulas": 1.3,
    "formulas in the text": 0.05,
    "lines of code": 0.08,
    "pictures": 0.8,
    "questions": 1.1,
    "blank steps": 4.0,
}
"""Minutes for each of them."""

SHOWN = re.compile(r"\b(?:draw_\w+|slide\w*|explore|play_\w+|drive|assign|plot)\(")
STATED = re.compile(r"takes about (\d+)(?: to (\d+))? minutes")


def counts(notebook: NotebookNode, questions: int) -> dict[str, int]:
    """Count what takes time in a lecture."""
    found = dict.fromkeys(RATES, 0) | {"questions": questions}
    aside, formulas = False, set()
    for cell in notebook.cells:
        if cell.cell_type == "markdown" and re.search(r"^## ", cell.source, re.MULTILINE):
            aside = "## Side track" in cell.source
        if aside:
            continue
        if cell.cell_type == "markdown":
            formulas |= named(cell.source)
            text = re.sub(r"\$\$.*?\$\$", " ", cell.source, flags=re.DOTALL)
            found["formulas in the text"] += len(re.findall(r"\$[^$]+\$", text))
            found["words"] += len(re.findall(r"[A-Za-z]{2,}", re.sub(r"\$[^$]+\$", " ", text)))
        else:
            lines = [
                line
                for line in cell.source.splitlines()
                if line and not re.match(r"ask|explain|attempt|from|import", line)
            ]
            found["lines of code"] += len(lines) * ("hide-input" not in cell.metadata.get("tags", []))
            found["pictures"] += len(SHOWN.findall(cell.source))
            found["blank steps"] += cell.source.count("attempt(")
    return found | {"numbered formulas": len(formulas)}


def minutes(notebook: NotebookNode, questions: int) -> float:
    """Return how long a lecture takes."""
    return sum(RATES[what] * number for what, number in counts(notebook, questions).items())


def stated(notebook: NotebookNode) -> tuple[int, int]:
    """Return the range of minutes that a lecture states in its first cell. Raises ValueError if there is none."""
    found = STATED.search(notebook.cells[0].source)
    if not found:
        raise ValueError(f"the first cell must say how long the lecture takes; got {notebook.cells[0].source[:200]!r}.")
    return int(found[1]), int(found[2] or found[1])
