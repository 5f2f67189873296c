"""The result sink: writes each result to the student's page and into the gradebook, while other submissions still run.

Pages and notebooks are written by a reader, from the stored results. The modules of the gradebook take a second to import, so they
are imported while the sandbox starts.
"""

from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, suppress
from functools import cached_property
from importlib import import_module
from pathlib import Path
from threading import Thread
from types import TracebackType
from typing import TYPE_CHECKING, Any

from misstep.grading.collect.files import UnreadableFile
from misstep.grading.collect.gather import Submission
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import Result
from misstep.grading.publish.overrides import write_formgrader
from misstep.grading.reading import Reader, StepFailed

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import GradebookWriter

WRITERS = 2
"""How many pages are written at a time."""


class ResultSink:
    """Writes stored results, each to its page and, if there is an nbgrader course, to its gradebook. Any thread may use it.

    students  the students whose results have been written
    """

    def __init__(
        self,
        out: Path,
        sheet: ReleasedSheet,
        reader: Reader,
        *,
        nbgrader_course: Path | None,
        overwrite: bool,
        late: str = "",
    ) -> None:
        self._out, self._sheet, self._reader, self._late = out, sheet, reader, late
        self._nbgrader_course, self._overwrite = nbgrader_course, overwrite
        self._open_contexts, self._writers, self._pending = (
            ExitStack(),
            ThreadPoolExecutor(WRITERS),
            list[Future[None]](),
        )
        self._remarks: list[str] = []
        self._problems: Sequence[str] = ()
        self.students: set[str] = set()
        if nbgrader_course:
            Thread(target=_import_gradebook, daemon=True).start()

    def __enter__(self) -> "ResultSink":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind:
            self._reader.close()  # so that nobody waits for it
        self._writers.shutdown(cancel_futures=kind is not None)
        self._open_contexts.close()

    def write(self, submission: Submission, result: Result) -> None:
        """Write a result that has been stored, points into the gradebook at once, the rest soon.

        Raises ValueError if the folder of the gradebook is no nbgrader course, or if its assignment is not generated.
        """
        self._problems = [problem.number for problem in result.problems]
        if self._gradebook and (arguments := self._gradebook.record(result)):
            self._pending.append(self._writers.submit(self._write_notebook, submission, result, arguments))
        self.write_page(result.student)

    def write_page(self, student: str) -> None:
        """Write the page of a stored result."""
        self._pending.append(self._writers.submit(self._write_page, student))
        self.students.add(student)

    def write_entered(self) -> None:
        """Write what was entered in formgrader, and the pages of these students again."""
        if self._gradebook and self._problems:
            entered = self._gradebook.entered(self._problems)
            write_formgrader(self._out, entered)
            for student in entered:
                if student in self.students:
                    self.write_page(student)

    def finish(self) -> list[str]:
        """Wait until everything is written; what could not be."""
        for future in self._pending:
            future.result()
        if self._gradebook and self._gradebook.invalid_ids:
            ids = ", ".join(self._gradebook.invalid_ids)
            self._remarks.append(f"Not in the gradebook, because these ids cannot be names of folders: {ids}.")
        return sorted(self._remarks)

    def _write_page(self, student: str) -> None:
        try:
            self._reader.do("page", out=str(self._out), student=student, late=self._late, is_short=False)
        except StepFailed as error:
            self._reader.do("page", out=str(self._out), student=student, late=self._late, is_short=True)
            self._remarks.append(f"The page of {student} has only the points: {error}.")

    def _write_notebook(self, submission: Submission, result: Result, arguments: dict[str, str]) -> None:
        try:
            content = submission.with_notebook(result.digest).read()
        except UnreadableFile:
            content = None
        places: dict[str, Any] = {"out": str(self._out), "student": result.student, **arguments}
        try:
            self._reader.do("autograded notebook", content=content, **places)
        except StepFailed as error:
            self._reader.do("autograded notebook", content=None, **places)
            self._remarks.append(f"Formgrader shows the notebook of {result.student} without its cells: {error}.")

    @cached_property
    def _gradebook(self) -> "GradebookWriter | None":
        if self._nbgrader_course is None:
            return None
        from misstep.grading.nbgrader.gradebook import open_gradebook

        return self._open_contexts.enter_context(open_gradebook(self._nbgrader_course, self._sheet, self._overwrite))


def _import_gradebook() -> None:
    with suppress(ImportError):  # the import that needs it reports what is missing
        import_module("misstep.grading.nbgrader.gradebook")
