"""A preprocessor for nbgrader: with it, `nbgrader autograde` runs submissions in the sandbox, and the judge computes the points.

In nbgrader_config.py, Execute replaces nbgrader's own preprocessor:

    c.Autograde.autograde_preprocessors = ["misstep.grading.nbgrader.plugin.Execute", ...]
"""

import atexit
from functools import cache
from pathlib import Path
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbgrader.coursedir import CourseDirectory
from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets import Bool

from misstep.grading.collect.run_plan import read_released_sheet
from misstep.grading.judging.grader import Grader
from misstep.grading.nbgrader.cells import fill_outputs, text_cells


class Execute(NbGraderPreprocessor):  # type: ignore[misc]  # nbgrader ships no types
    """Grades the notebook, and writes its outputs and verdicts into its cells."""

    unsafe_no_sandbox = Bool(
        False, help="Run submissions with your own rights; use it only for code that you trust."
    ).tag(config=True)

    def preprocess(self, nb: NotebookNode, resources: dict[str, Any]) -> tuple[NotebookNode, dict[str, Any]]:
        """Grade one submission. nbgrader knows the student from the folder, and has restored the cells that have points."""
        metadata = resources["nbgrader"]
        course = CourseDirectory(parent=self)
        sheet = Path(
            course.format_path(course.source_directory, ".", metadata["assignment"]), f"{metadata['notebook']}.ipynb"
        )
        grader = _grader(sheet, not self.unsafe_no_sandbox)
        result = grader.grade(metadata["student"], nbformat.writes(nb).encode(errors="replace"))
        self.log.info("%s: %g of %g points. %s", result.student, result.points, result.max, result.reason)
        return fill_outputs(nb, result, _text_cells(sheet)), resources


@cache
def _text_cells(path: Path) -> set[str]:
    return text_cells(nbformat.read(path, as_version=4))


@cache
def _grader(path: Path, is_safe: bool) -> Grader:
    """One grader for all submissions of a sheet."""
    grader = Grader(read_released_sheet(path), is_safe=is_safe)
    atexit.register(grader.close)
    return grader
