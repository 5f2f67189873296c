"""Write what people open, from the stored results: the pages, the gradebook of nbgrader, the tables.

Whatever has bytes of students in it is written by a process of the judge, within limits.
"""

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from misstep.grading.collect.files import UnreadableFile
from misstep.grading.collect.gather import Submission
from misstep.grading.jobs import run_bounded
from misstep.grading.publish.overrides import LateRule, write_formgrader
from misstep.grading.publish.result_store import ResultStore
from misstep.grading.steps import StepFailed, StepProcesses

if TYPE_CHECKING:
    from misstep.grading.nbgrader.gradebook import GradebookWriter

PAGE_SECONDS = 5.0
"""Processor time for writing one page or notebook."""

PENDING_PAGES = 8
"""How many pages wait for a process that writes them."""


@dataclass(frozen=True)
class ResultWriter:
    """Writes into a folder of results.

    remarks  what could not be written as it should be
    """

    out: Path
    judge: StepProcesses
    executor: Executor
    late: LateRule | None
    remarks: list[str] = field(default_factory=list)

    def write_pages(self, students: Sequence[str]) -> None:
        """Write the page of each student who has a result."""
        remark = "The page of {} has only the points: {}."
        jobs = ({"student": student, "late": self.late} for student in students)
        self._write_all("page", jobs, {"is_short": True}, remark)

    def fill_gradebook(self, gradebook: "GradebookWriter", submissions: Sequence[Submission]) -> None:
        """Write points and notebooks into a gradebook, and what was entered in formgrader into the folder."""
        store, problems = ResultStore(self.out), list[str]()

        def notebooks() -> Iterator[dict[str, Any]]:
            for submission in submissions:
                if (result := store.load(submission.student)) is None:
                    continue
                problems[:] = [problem.number for problem in result.problems]
                if arguments := gradebook.record(result):
                    content, file = None, submission.notebook_with(result.digest)
                    with suppress(UnreadableFile):
                        content = file and file.read()
                    yield {"student": submission.student, "content": content, **arguments}

        remark = "Formgrader shows the notebook of {} without its cells: {}."
        self._write_all("autograded notebook", notebooks(), {"content": None}, remark)
        if problems:
            write_formgrader(self.out, gradebook.entered(problems))
        if gradebook.invalid_ids:
            ids = ", ".join(gradebook.invalid_ids)
            self.remarks.append(f"Not in the gradebook, because these ids cannot be names of folders: {ids}.")

    def _write_all(self, step: str, jobs: Iterable[dict[str, Any]], short: dict[str, Any], remark: str) -> None:
        """Let the judge do a step with the arguments of each job; with those of `short` where they cannot."""

        def write(arguments: dict[str, Any]) -> None:
            do = partial(self.judge.do, step, seconds=PAGE_SECONDS, out=self.out)
            try:
                do(**arguments)
            except StepFailed as error:
                do(**arguments | short)
                self.remarks.append(remark.format(arguments["student"], error))

        for _, error in run_bounded(lambda job: self.executor.submit(write, job), jobs, PENDING_PAGES):
            if isinstance(error, BaseException):
                raise error
