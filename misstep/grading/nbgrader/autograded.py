"""The notebook that formgrader shows: the submission as it ran, with the verdicts in it.

It is written by a process of the judge, within limits.
"""

import json
from copy import deepcopy
from dataclasses import replace
from functools import cache
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from misstep.grading.judging.result import Result
from misstep.grading.nbgrader.cells import fill_outputs, restore_metadata, text_cells
from misstep.grading.publish.result_store import ResultStore, write_if_changed


def write_notebook(out: Path, student: str, content: bytes | None, *, released: Path, target: Path) -> None:
    """Write the notebook of a stored result."""
    if result := ResultStore(out).load(student):
        write_if_changed(target, autograded_notebook(content, result, _read(released)))


def autograded_notebook(content: bytes | None, result: Result, released: NotebookNode) -> str:
    """The graded notebook, or, if nbformat cannot read it, the released one. nbformat is stricter than the grader."""
    texts = text_cells(released)
    try:
        notebook = fill_outputs(restore_metadata(content, result, released), result, texts)
        nbformat.validate(notebook)
    except Exception:  # nbformat raises many kinds of errors for invalid notebooks
        notebook = fill_outputs(deepcopy(released), replace(result, cells=()), texts)
    return json.dumps(notebook, ensure_ascii=False) + "\n"  # indented, it would take five times as long


@cache
def _read(path: Path) -> NotebookNode:
    released: NotebookNode = nbformat.read(path, as_version=4)
    return released
