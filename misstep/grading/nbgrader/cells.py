"""Notebooks as nbgrader stores them after grading: the outputs of each cell, and the judge's verdicts in the check cells.

nbgrader reads the points of a check cell from its last output, a number. What a student wrote is kept as text and pictures only,
text cells included, because formgrader and generate_feedback would copy HTML into their pages unchanged.
"""

import re
from collections.abc import Container, Mapping
from copy import deepcopy
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.pages import SHOW_CELL, outputs_of, png_of, render_part, text_of


def fill_outputs(notebook: NotebookNode, result: Result, released_texts: Container[str]) -> NotebookNode:
    """The graded notebook, with the outputs and verdicts of its result, and with the reasons in a cell at the top.

    released_texts  the text cells of the released sheet; only these are shown as Markdown
    """
    notebook.metadata = nbformat.from_dict(
        {key: notebook.metadata[key] for key in ("kernelspec",) if key in notebook.metadata}
    )
    problems = {f"check-{k}": problem for k, problem in enumerate(result.problems, start=1)}
    outputs = {cell.index: outputs_of(cell) for cell in result.cells}
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type == "code":
            problem = problems.get(_name(cell))
            shown = _shown_problem(cell, result)
            cell.outputs = (
                _verdict_outputs(problem)
                if problem
                else [_part_output("problem", shown, shown.statement)]
                if shown
                else [_safe_output(output) for output in outputs.get(index, ())]
            )
            cell.execution_count = None
        elif cell.source not in released_texts:
            notebook.cells[index] = _literal_cell(cell)
        cell.metadata = nbformat.from_dict({key: cell.metadata[key] for key in ("nbgrader",) if key in cell.metadata})
    remarks = [" ".join(line.replace("`", "'").split()) for line in (result.reason, *result.notes) if line]
    if remarks:
        notebook.cells.insert(0, new_markdown_cell("\n\n".join(f"`{line}`" for line in remarks)))
    return notebook


def text_cells(notebook: NotebookNode) -> set[str]:
    """The sources of the text cells of a notebook."""
    return {cell.source for cell in notebook.cells if cell.cell_type == "markdown"}


def _literal_cell(cell: NotebookNode) -> NotebookNode:
    """A text or raw cell as a block of code: the fence is longer than each one in the text, so nothing can end the block."""
    fence = "`" * (max(map(len, re.findall("`+", cell.source)), default=0) + 3)
    literal = {"cell_type": "markdown", "metadata": cell.metadata, "source": f"{fence}text\n{cell.source}\n{fence}"}
    return _node({**literal, **({"id": cell.id} if "id" in cell else {})})


def _shown_problem(cell: NotebookNode, result: Result) -> ProblemResult | None:
    """The problem that a cell of the sheet shows, if the judge has drawn it."""
    found = SHOW_CELL.fullmatch(cell.source)
    position = int(found[1]) if found else 0
    problem = result.problems[position - 1] if 1 <= position <= len(result.problems) else None
    return problem if problem and problem.statement else None


def restore_metadata(content: bytes | None, result: Result, released: NotebookNode) -> NotebookNode:
    """The submitted notebook, with nbgrader's metadata as in the released sheet, even if an editor changed or removed it.

    If nothing was run, this is the released sheet. Check cells that were deleted are at the end.
    """
    notebook = deepcopy(released)
    if content is None or not result.cells:
        return notebook
    # It is not validated, as `nbformat.reads` does, because the whole notebook is validated when it is written.
    submitted = nbformat.convert(nbformat.reader.reads(content.decode("utf-8-sig", errors="replace")), 4)
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
    return _node({**required, **outputs, "metadata": metadata, "id": name})


def _name(cell: Mapping[str, Any]) -> str:
    return str(cell.get("metadata", {}).get("nbgrader", {}).get("grade_id", ""))


def _verdict_outputs(problem: ProblemResult) -> list[NotebookNode]:
    points = {"text/plain": repr(float(problem.points))}
    return [
        _part_output("card", problem, problem.verdict),
        *(_output("stream", name="stdout", text=f"{note}\n") for note in problem.notes),
        _output("execute_result", data=points, metadata={}, execution_count=None),
    ]


def _part_output(part: str, problem: ProblemResult, text: str) -> NotebookNode:
    html = str(render_part(part, problem))
    return _output("display_data", data={"text/html": html, "text/plain": text}, metadata={})


def _safe_output(output: Mapping[str, Any]) -> NotebookNode:
    picture, text = png_of(output), text_of(output)
    if picture is None:
        return _output("stream", name="stdout", text=text)
    return _output("display_data", data={"image/png": picture, "text/plain": text}, metadata={})


def _output(kind: str, **parts: Any) -> NotebookNode:
    """An output, not validated, because the whole notebook is validated when it is written."""
    return _node({"output_type": kind, **parts})


def _node(contents: Mapping[str, Any]) -> NotebookNode:
    node: NotebookNode = nbformat.from_dict(contents)
    return node
