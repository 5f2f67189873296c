"""The instructor's notebook of a sheet: for each problem a heading, the statement, an answer cell and a check cell.

The metadata of the cells tell nbgrader what to clear, to lock and to score. `student_notebook` makes the student's version.
"""

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from misstep.sheet import SAMPLE_ID, Sheet
from misstep.worked_solution import worked_solution

FOLDED = {"jupyter": {"source_hidden": True}, "tags": ["hide-input"]}
"""The call that shows a problem is folded, in the lab and on a page."""


class Entry(NamedTuple):
    """One problem in the notebook: the name of the answer, the instruction, and the lines of the solution."""

    answer: str
    ask: str
    solution: str


def notebook(sheet: Sheet, entries: Sequence[Entry], intro: str, imports: str) -> str:
    """Write the notebook of a sheet, as the text of a file.

    entries  one for each problem
    intro    the paragraph below the title
    imports  the first lines of the first code cell, before those that open the sheet
    """
    number = sheet.problems[0].number.partition(".")[0]
    opening = [imports, "", f'student = "{SAMPLE_ID}"', f'sheet = open_sheet("{sheet.name}", student)', "sheet"]
    title = f"# Sheet {number}: {sheet.title[0].lower()}{sheet.title[1:]}"
    cells = [_markdown("title", f"{title}\n\n{intro}"), _code("open", "\n".join(opening))]
    for k, (template, entry) in enumerate(zip(sheet.problems, entries, strict=True), start=1):
        cells += _problem_cells(k, template.title, template.points, entry)
    cells.append(_markdown("together", "## Together\n\nRun this cell last: it counts what you have."))
    cells.append(_code("tally", "sheet.tally()"))
    kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}}
    return _dumps({"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5})


def _problem_cells(k: int, title: str, points: int, entry: Entry) -> list[dict[str, Any]]:
    """The four cells of problem k: heading, statement, answer and check."""
    name = f"{entry.answer}_{k}"
    given = [f"given = sheet.given({k})"] if "given." in entry.solution else []
    lines = [*given, f"{name} = ...", "### BEGIN SOLUTION", entry.solution.strip(), "### END SOLUTION"]
    scored = {"grade": True, "locked": True, "points": points, "solution": False}
    return [
        _markdown(f"heading-{k}", f"## Problem {k}. {title}\n\n{entry.ask}".strip()),
        _code(f"show-{k}", f"sheet.show({k})") | {"metadata": FOLDED},
        _code(f"answer-{k}", "\n".join(lines), {"grade": False, "locked": False, "solution": True}),
        _code(f"check-{k}", f"sheet.check({k}, {name})", scored),
    ]


WORKED = "worked-"
"""The beginning of the ids of the cells with worked solutions, which students do not get."""


def with_worked_solutions(text: str, sheet: Sheet) -> str:
    """Return an instructor's notebook with a worked solution after each check, as a student of SAMPLE_ID reads it on the card."""
    content = json.loads(text)
    cells = []
    for cell in (cell for cell in content["cells"] if not cell["id"].startswith(WORKED)):
        cells.append(cell)
        if found := re.fullmatch(r"check-(\d+)", cell["id"]):
            template = sheet.problems[int(found[1]) - 1]
            problem = template.variant(SAMPLE_ID)
            what = "The answer" if problem.solution is None else "One way to it"
            steps = "\n".join(f"- {step}" for step in worked_solution(problem))
            further = f"\n\nA further question: {problem.further}" if problem.further else ""
            cells.append(
                _markdown(f"{WORKED}{found[1]}", f"{what}, with the numbers of “{SAMPLE_ID}”:\n\n{steps}{further}")
            )
    return _dumps(content | {"cells": cells})


def _dumps(content: dict[str, Any]) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _markdown(name: str, text: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": name, "metadata": {}, "source": text.splitlines(keepends=True)}


def _code(name: str, text: str, nbgrader: Mapping[str, Any] | None = None) -> dict[str, Any]:
    fields = {**nbgrader, "grade_id": name, "schema_version": 3, "task": False} if nbgrader else {}
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": name,
        "metadata": {"nbgrader": dict(sorted(fields.items()))} if fields else {},
        "outputs": [],
        "source": text.splitlines(keepends=True),
    }
