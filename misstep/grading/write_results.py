"""Write what people open, from the stored results: the pages, the gradebook of nbgrader, the tables.

Whatever has bytes of students in it is written by a reader, within limits.
"""

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from misstep.grading.collect.files import UnreadableFile
from misstep.grading.collect.gather import Submission
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.jobs import run_bounded
from misstep.grading.publish.overrides import write_formgrader
from misstep.grading.publish.result_store import ResultStore
from misstep.grading.reader_process import STEP_SECONDS
from misstep.grading.steps import StepFailed, StepProcesses

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import GradebookWriter

PENDING_PAGES = 8
"""How many pages wait for a process that writes them."""


@contextmanager
def opened_gradebook(folder: Path | None, sheet: ReleasedSheet, overwrite: bool) -> "Iterator[GradebookWriter | None]":
    """The gradebook of the nbgrader course in a folder; None without a folder.

    Raises ValueError if the folder is no nbgrader course, or if its assignment is not generated.
    """
    if folder is None:
        yield None
        return
    from misstep.grading.nbgrader.gradebook import open_gradebook  # here, because it takes a second to import

    with open_gradebook(folder, sheet, overwrite) as gradebook:
        yield gradebook


@dataclass(frozen=True)
class ResultWriter:
    """Writes into a folder of results.

    late     the rule for late days as text, "" for none
    remarks  what could not be written as it should be
    """

    out: Path
    reader: StepProcesses
    executor: Executor
    late: str
    remarks: list[str] = field(default_factory=list)

    def write_pages(self, students: Sequence[str]) -> None:
        """Write the page of each student who has a result."""
        self._write_all(self._write_page, [(student,) for student in students])

    def fill_gradebook(self, gradebook: "GradebookWriter", submissions: Sequence[Submission]) -> None:
        """Write points and notebooks into a gradebook, and what was entered in formgrader into the folder."""
        store, written = ResultStore(self.out), []
        problems: list[str] = []
        for submission in submissions:
            if result := store.load(submission.student):
                problems = [problem.number for problem in result.problems]
                if arguments := gradebook.record(result):
                    written.append((submission, result.digest, arguments))
        self._write_all(self._write_notebook, written)
        if problems:
            write_formgrader(self.out, gradebook.entered(problems))
        if gradebook.invalid_ids:
            ids = ", ".join(gradebook.invalid_ids)
            self.remarks.append(f"Not in the gradebook, because these ids cannot be names of folders: {ids}.")

    def _write_all(self, write: Any, arguments: Sequence[tuple[Any, ...]]) -> None:
        for _, error in run_bounded(lambda some: self.executor.submit(write, *some), arguments, PENDING_PAGES):
            if isinstance(error, BaseException):
                raise error

    def _write_page(self, student: str) -> None:
        common = {"out": self.out, "student": student, "late": self.late}
        try:
            self.reader.do("page", seconds=STEP_SECONDS, **common)
        except StepFailed as error:
            self.reader.do("page", seconds=STEP_SECONDS, is_short=True, **common)
            self.remarks.append(f"The page of {student} has only the points: {error}.")

    def _write_notebook(self, submission: Submission, digest: str, arguments: dict[str, Any]) -> None:
        content, file = None, submission.notebook_with(digest)
        with suppress(UnreadableFile):
            content = file and file.read()
        common = {"out": self.out, "student": submission.student, **arguments}
        try:
            self.reader.do("autograded notebook", seconds=STEP_SECONDS, content=content, **common)
        except StepFailed as error:
            self.reader.do("autograded notebook", seconds=STEP_SECONDS, content=None, **common)
            self.remarks.append(f"Formgrader shows the notebook of {submission.student} without its cells: {error}.")
