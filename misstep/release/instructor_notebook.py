"""A sheet as the instructor's notebook: for each problem a heading, what it shows, a cell to fill, a check.

The cells carry the marks by which nbgrader knows what to clear, to lock and to score; `handout` makes the student's copy.
"""

import json
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from misstep.sheet import SAMPLE_ID, Sheet

SCHEMA = 3
"""The version of nbgrader's marks."""


class Entry(NamedTuple):
    """How one problem stands on the page: the name of the answer, what to answer with, and the lines that solve it."""

    answer: str
    ask: str
    solution: str


def notebook(sheet: Sheet, entries: Sequence[Entry], intro: str, imports: str, after: Mapping[int, str] = {}) -> str:
    """Write the notebook of a sheet, as the text of a file.

    entries  one for each problem
    intro    the paragraph below the title
    imports  the lines of the first code cell, above those that open the sheet
    after    remarks by the number of the problem behind which they stand

    Raises ValueError when there is not one entry for each problem.

    >>> notebook(Sheet("01_ohm", "Ohm's law", []), [Entry("U", "In volts.", "U_1 = 5")], "", "")
    Traceback (most recent call last):
    ValueError: 01_ohm has 0 problems; got 1 entries.
    """
    if len(entries) != len(sheet.problems):
        raise ValueError(f"{sheet.name} has {len(sheet.problems)} problems; got {len(entries)} entries.")
    number = sheet.problems[0].number.partition(".")[0]
    opened = [imports, "", f'student = "{SAMPLE_ID}"', f'sheet = open_sheet("{sheet.name}", student)', "sheet"]
    title = f"# Sheet {number}: {sheet.title[0].lower()}{sheet.title[1:]}"
    cells = [_markdown("title", f"{title}\n\n{intro}"), _code("open", "\n".join(opened))]
    for k, (template, entry) in enumerate(zip(sheet.problems, entries, strict=True), start=1):
        name = f"{entry.answer}_{k}"
        given = [f"given = sheet.given({k})"] if "given." in entry.solution else []
        lines = [*given, f"{name} = ...", "### BEGIN SOLUTION", entry.solution.strip(), "### END SOLUTION"]
        cells += [
            _markdown(f"heading-{k}", f"## Problem {k}. {template.title}\n\n{entry.ask}"),
            _code(f"show-{k}", f"sheet.show({k})"),
            _code(f"answer-{k}", "\n".join(lines), {"grade": False, "locked": False, "solution": True}),
            _code(
                f"check-{k}",
                f"sheet.check({k}, {name})",
                {"grade": True, "locked": True, "points": template.points, "solution": False},
            ),
        ]
        if k in after:
            cells.append(_markdown(f"note-{k}", after[k]))
    cells.append(_markdown("together", "## Together\n\nRun this cell last: it counts what you have."))
    cells.append(_code("tally", "sheet.tally()"))
    kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}}
    made = {"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(made, indent=1, ensure_ascii=False) + "\n"


def _markdown(name: str, text: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": name, "metadata": {}, "source": text.splitlines(keepends=True)}


def _code(name: str, text: str, mark: Mapping[str, Any] | None = None) -> dict[str, Any]:
    marks = dict(sorted({**mark, "grade_id": name, "schema_version": SCHEMA, "task": False}.items())) if mark else None
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": name,
        "metadata": {"nbgrader": marks} if marks else {},
        "outputs": [],
        "source": text.splitlines(keepends=True),
    }
