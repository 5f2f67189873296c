"""The result sink: writes each result to the student's page and into the gradebook, while other submissions still run.

The modules that write pages and the gradebook take a second to import, so they are imported while the sandbox starts.
"""

from contextlib import ExitStack, suppress
from functools import cached_property
from importlib import import_module
from pathlib import Path
from threading import Thread
from types import TracebackType
from typing import TYPE_CHECKING

from misstep.grading.collect.gather import Submission
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import Result

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import GradebookWriter

PUBLISH_MODULE, GRADEBOOK_MODULE = "misstep.grading.publish.publish", "misstep.grading.nbgrader.gradebook"


class ResultSink:
    """Writes results one after the other, each to its page and, if there is an nbgrader course, to its gradebook.

    students  the students whose results have been written
    """

    def __init__(self, out: Path, sheet: ReleasedSheet, nbgrader_course: Path | None, overwrite: bool) -> None:
        self._out, self._sheet, self._nbgrader_course, self._overwrite = out, sheet, nbgrader_course, overwrite
        self._open_contexts = ExitStack()
        self.students: set[str] = set()
        modules = [PUBLISH_MODULE, *([GRADEBOOK_MODULE] if nbgrader_course else [])]
        Thread(target=_import_modules, args=modules).start()

    def __enter__(self) -> "ResultSink":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._open_contexts.close()

    def write(self, submission: Submission, result: Result) -> None:
        """Write a result.

        Raises ValueError if the folder of the gradebook is no nbgrader course, or if its assignment is not generated.
        """
        from misstep.grading.publish.publish import publish_feedback

        publish_feedback(self._out, result)
        if self._gradebook:
            self._gradebook.record(submission.with_notebook(result.digest), result)
        self.students.add(submission.student)

    def remarks(self) -> list[str]:
        """What could not be written."""
        if not self._gradebook or not self._gradebook.invalid_ids:
            return []
        ids = ", ".join(self._gradebook.invalid_ids)
        return [f"Not in the gradebook, because these ids cannot be names of folders: {ids}."]

    @cached_property
    def _gradebook(self) -> "GradebookWriter | None":
        if self._nbgrader_course is None:
            return None
        from misstep.grading.nbgrader.gradebook import open_gradebook

        return self._open_contexts.enter_context(open_gradebook(self._nbgrader_course, self._sheet, self._overwrite))


def _import_modules(*modules: str) -> None:
    for module in modules:
        with suppress(ImportError):  # the import that needs it reports what is missing
            import_module(module)
