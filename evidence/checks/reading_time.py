"""How many minutes a lecture takes: words, formulas, lines of code, pictures and tasks are counted, each at a stated rate.

The rates were set by hand, near what a reviewer of an earlier version estimated for lectures 01 to 09. Nobody has measured them
with a clock. Side tracks do not count.
"""

import re

from nbformat import NotebookNode

RATES = {"words": 1 / 150, "displayed formulas": 1.5, "formulas in the text": 0.1, "lines of code": 0.1, "pictures": 1.5,
         "questions": 1.5, "blank steps": 4.0}  # fmt: skip
"""Minutes for each of them."""

SHOWN = re.compile(r"\b(?:draw_\w+|slide\w*|explore|play_\w+|drive|assign|plot)\(")
STATED = re.compile(r"takes about (\d+)(?: to (\d+))? minutes")


def counts(notebook: NotebookNode, questions: int) -> dict[str, int]:
    """Count what takes time in a lecture."""
    found = dict.fromkeys(RATES, 0) | {"questions": questions}
    aside = False
    for cell in notebook.cells:
        if cell.cell_type == "markdown" and re.search(r"^## ", cell.source, re.MULTILINE):
            aside = "## Side track" in cell.source
        if aside:
            continue
        if cell.cell_type == "markdown":
            displayed = re.findall(r"\$\$.*?\$\$", cell.source, re.DOTALL)
            text = re.sub(r"\$\$.*?\$\$", " ", cell.source, flags=re.DOTALL)
            found["displayed formulas"] += len(displayed)
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
    return found


def minutes(notebook: NotebookNode, questions: int) -> float:
    """Return how long a lecture takes."""
    return sum(RATES[what] * number for what, number in counts(notebook, questions).items())


def stated(notebook: NotebookNode) -> tuple[int, int]:
    """Return the range of minutes that a lecture states in its first cell. Raises ValueError if there is none."""
    found = STATED.search(notebook.cells[0].source)
    if not found:
        raise ValueError(f"the first cell must say how long the lecture takes; got {notebook.cells[0].source[:200]!r}.")
    return int(found[1]), int(found[2] or found[1])
