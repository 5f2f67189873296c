"""A step for nbgrader: `nbgrader autograde` runs submissions in our sandbox, and our judge gives the points.

nbgrader_config.py puts Execute in the place of nbgrader's own:

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

from misstep.grading.collect.submission import master
from misstep.grading.judging.grader import Grader
from misstep.grading.nbgrader.cells import filled


class Execute(NbGraderPreprocessor):  # type: ignore[misc]  # nbgrader ships no types
    """Grade the notebook, and write what came of it into its cells."""

    unsafe_no_sandbox = Bool(False, help="Run submissions with your own rights: only code that you trust.").tag(
        config=True
    )

    def preprocess(self, nb: NotebookNode, resources: dict[str, Any]) -> tuple[NotebookNode, dict[str, Any]]:
        """Grade one submission. nbgrader says whose it is by the folder, and has put back the cells that it gives points for."""
        about = resources["nbgrader"]
        course = CourseDirectory(parent=self)
        source = course.format_path(course.source_directory, ".", about["assignment"])
        grader = _grader(Path(source, f"{about['notebook']}.ipynb"), not self.unsafe_no_sandbox)
        result = grader.grade(about["student"], nbformat.writes(nb).encode(errors="replace"))
        self.log.info("%s: %g of %g points. %s", result.student, result.points, result.max, result.reason)
        return filled(nb, result), resources


@cache
def _grader(path: Path, is_safe: bool) -> Grader:
    """One grader for all submissions of a sheet."""
    grader = Grader(master(path), is_safe=is_safe)
    atexit.register(grader.close)
    return grader
