"""Notebooks as nbgrader stores them after grading: the outputs of each cell, and the judge's verdicts in the check cells.

nbgrader reads the points of a check cell from its last output, a number. Outputs of student code are kept as text and
pictures only, because formgrader and generate_feedback would copy HTML into their pages unchanged.
"""

import warnings
from collections.abc import Mapping
from copy import deepcopy
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.pages import outputs_of, png_of, text_of


def fill_outputs(notebook: NotebookNode, result: Result) -> NotebookNode:
    """The graded notebook, with the outputs and verdicts of its result, and with the reasons in a cell at the top."""
    problems = {f"check-{k}": problem for k, problem in enumerate(result.problems, start=1)}
    outputs = {cell.index: outputs_of(cell) for cell in result.cells}
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type == "code":
            problem = problems.get(_name(cell))
            cell.outputs = (
                _verdict_outputs(problem) if problem else [_safe_output(output) for output in outputs.get(index, ())]
            )
            cell.execution_count = None
    remarks = [" ".join(line.replace("`", "'").split()) for line in (result.reason, *result.notes) if line]
    if remarks:
        notebook.cells.insert(0, new_markdown_cell("\n\n".join(f"`{line}`" for line in remarks)))
    return notebook


def restore_metadata(content: bytes | None, result: Result, released: NotebookNode) -> NotebookNode:
    """The submitted notebook, with nbgrader's metadata as in the released sheet, even if an editor changed or removed it.

    If nothing was run, this is the released sheet. Check cells that were deleted are at the end.
    """
    notebook = deepcopy(released)
    if content is None or not result.cells:
        return notebook
    with warnings.catch_warnings(action="ignore"):  # about cell ids, which old editors leave out
        submitted = nbformat.reads(content.decode("utf-8-sig", errors="replace"), as_version=4)
    released_cells = {name: cell for cell in notebook.cells if (name := _name(cell))}
    checks = {cell.index: f"check-{cell.problem}" for cell in result.cells if cell.problem}
    last = {name: index for index, name in checks.items()}  # if a check cell occurs twice, the last one counts
    notebook.cells = []
    for index, cell in enumerate(submitted.cells):
        name = checks.get(index) or _name(cell) or cell.get("id", "")
        is_released = last.get(name) == index if name.startswith("check-") else name in released_cells
        metadata = released_cells.pop(name).metadata if is_released else {}
        notebook.cells.append(_minimal_cell(cell, metadata, name if is_released else f"cell-{index}"))
    notebook.cells += [cell for name, cell in released_cells.items() if name.startswith("check-")]
    return notebook


def _minimal_cell(cell: Mapping[str, Any], metadata: Mapping[str, Any], name: str) -> NotebookNode:
    """A cell with only what the format requires, without what editors add."""
    required = {key: cell[key] for key in ("cell_type", "source", "attachments") if key in cell}
    outputs: dict[str, Any] = {"outputs": [], "execution_count": None} if cell["cell_type"] == "code" else {}
    minimal: NotebookNode = nbformat.from_dict({**required, **outputs, "metadata": metadata, "id": name})
    return minimal


def _name(cell: Mapping[str, Any]) -> str:
    return str(cell.get("metadata", {}).get("nbgrader", {}).get("grade_id", ""))


def _verdict_outputs(problem: ProblemResult) -> list[NotebookNode]:
    card = {"text/html": problem.html, "text/plain": problem.verdict}
    points = {"text/plain": repr(float(problem.points))}
    return [
        _output("display_data", data=card, metadata={}),
        *(_output("stream", name="stdout", text=f"{note}\n") for note in problem.notes),
        _output("execute_result", data=points, metadata={}, execution_count=None),
    ]


def _safe_output(output: Mapping[str, Any]) -> NotebookNode:
    picture, text = png_of(output), text_of(output)
    if picture is None:
        return _output("stream", name="stdout", text=text)
    return _output("display_data", data={"image/png": picture, "text/plain": text}, metadata={})


def _output(kind: str, **parts: Any) -> NotebookNode:
    """An output, not validated, because the whole notebook is validated when it is written."""
    output: NotebookNode = nbformat.from_dict({"output_type": kind, **parts})
    return output
