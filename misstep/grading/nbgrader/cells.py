"""Notebooks as nbgrader keeps them after grading: what each cell gave, and the judge's verdict in place of each check.

nbgrader reads points off a check cell's output, a number that is its result. What a student's code gave stays as text and
pictures: formgrader and generate_feedback would put HTML into their pages as it is.
"""

import warnings
from collections.abc import Mapping
from copy import deepcopy
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.pages import outputs_of, picture_of, text_of


def filled(notebook: NotebookNode, result: Result) -> NotebookNode:
    """The notebook that was graded, with the outputs of its result, and with its reasons on top."""
    problems = {f"check-{k}": problem for k, problem in enumerate(result.problems, start=1)}
    given = {cell.place: outputs_of(cell) for cell in result.cells}
    for place, cell in enumerate(notebook.cells):
        if cell.cell_type == "code":
            problem = problems.get(_name(cell))
            cell.outputs = _verdict(problem) if problem else [_harmless(output) for output in given.get(place, ())]
            cell.execution_count = None
    told = [" ".join(line.replace("`", "'").split()) for line in (result.reason, *result.notes) if line]
    if told:
        notebook.cells.insert(0, new_markdown_cell("\n\n".join(f"`{line}`" for line in told)))
    return notebook


def restored(content: bytes | None, result: Result, released: NotebookNode) -> NotebookNode:
    """What was handed in, with nbgrader's marks as they were handed out, whatever became of them.

    Where nothing was run, this is the sheet as it was handed out. A check cell that was deleted stands at the end.
    """
    made = deepcopy(released)
    if content is None or not result.cells:
        return made
    with warnings.catch_warnings(action="ignore"):  # about ids that old editors leave out
        submitted = nbformat.reads(content.decode("utf-8-sig", errors="replace"), as_version=4)
    marked = {name: cell for cell in made.cells if (name := _name(cell))}
    checks = {cell.place: f"check-{cell.problem}" for cell in result.cells if cell.problem}
    last = {name: place for place, name in checks.items()}  # where a check is there twice, the last one counts
    made.cells = []
    for place, cell in enumerate(submitted.cells):
        name = checks.get(place) or _name(cell) or cell.get("id", "")
        is_it = last.get(name) == place if name.startswith("check-") else name in marked
        metadata = marked.pop(name).metadata if is_it else {}
        made.cells.append(_bare(cell, metadata, name if is_it else f"cell-{place}"))
    made.cells += [cell for name, cell in marked.items() if name.startswith("check-")]
    return made


def _bare(cell: Mapping[str, Any], metadata: Mapping[str, Any], name: str) -> NotebookNode:
    """A cell with nothing but what the format asks for: editors leave much behind."""
    kept = {key: cell[key] for key in ("cell_type", "source", "attachments") if key in cell}
    runs: dict[str, Any] = {"outputs": [], "execution_count": None} if cell["cell_type"] == "code" else {}
    made: NotebookNode = nbformat.from_dict({**kept, **runs, "metadata": metadata, "id": name})
    return made


def _name(cell: Mapping[str, Any]) -> str:
    return str(cell.get("metadata", {}).get("nbgrader", {}).get("grade_id", ""))


def _verdict(problem: ProblemResult) -> list[NotebookNode]:
    card = {"text/html": problem.html, "text/plain": problem.verdict}
    points = {"text/plain": repr(float(problem.points))}
    return [
        _output("display_data", data=card, metadata={}),
        *(_output("stream", name="stdout", text=f"{note}\n") for note in problem.notes),
        _output("execute_result", data=points, metadata={}, execution_count=None),
    ]


def _harmless(output: Mapping[str, Any]) -> NotebookNode:
    picture, text = picture_of(output), text_of(output)
    if picture is None:
        return _output("stream", name="stdout", text=text)
    return _output("display_data", data={"image/png": picture, "text/plain": text}, metadata={})


def _output(kind: str, **parts: Any) -> NotebookNode:
    """An output, unchecked: the notebook is checked as a whole when it is written."""
    made: NotebookNode = nbformat.from_dict({"output_type": kind, **parts})
    return made
