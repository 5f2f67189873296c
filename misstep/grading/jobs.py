"""Jobs: the submissions that must be graded, each with the fingerprint of everything that its result depends on."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, replace
from typing import TypeVar

from misstep.grading.collect.files import UnreadableFile, list_names
from misstep.grading.collect.gather import Submission
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.fingerprint import fingerprint
from misstep.grading.judging.result import ABSENT, Result

Job = TypeVar("Job")
Outcome = TypeVar("Outcome")


@dataclass(frozen=True, eq=False)
class GradingJob:
    """A submission that has been read, and is now graded.

    contents     the notebooks, of which the best one counts; [None] if nothing was submitted or no file could be read
    fault        why no file could be read, "" if one could
    fingerprint  the digest of everything that the result depends on
    """

    submission: Submission
    contents: Sequence[bytes | None]
    fault: str
    fingerprint: str

    @property
    def request(self) -> tuple[str, str, Sequence[bytes | None]]:
        """The arguments of `grade_best` after the first one."""
        return self.submission.student, self.submission.seed_id, self.contents

    def complete(self, result: Result) -> Result:
        """The grader's result, with the student's name and the remarks on the files."""
        notes = [*self.submission.notes, *result.notes]
        if len(self.contents) > 1:
            chosen = self.submission.notebook_with(result.digest)
            files = list_names(self.submission.notebooks)
            counts = f"{chosen.path} counts, because no other has more points" if chosen else ""
            notes.insert(0, f"{len(self.contents)} notebooks were handed in and graded ({files}); {counts}.")
        status = result.status if self.submission.notebooks else ABSENT
        return replace(
            result, student=self.submission.student, status=status, reason=self.fault or result.reason, notes=notes
        )


def grade_best(
    grade: Callable[[str, bytes | None, str], Result], student: str, seed_id: str, contents: Sequence[bytes | None]
) -> Result:
    """Grade each of a student's notebooks; the result with the most points, the first one of these.

    seed_id  the id from which the numbers are drawn; "" for the one that is typed in a notebook, or else the student's name
    """
    results = [grade(student, content, seed_id) for content in contents]
    limits = list(dict.fromkeys(limit for result in results for limit in result.limits))
    return replace(max(results, key=lambda result: result.points), limits=limits)


def make_jobs(submissions: Iterable[Submission], sheet: ReleasedSheet, way: str) -> Iterator[GradingJob]:
    """A job for each submission, which is read when its job is made.

    way  how submissions run: the limits, and whether in the sandbox
    """
    for submission in submissions:
        contents, faults = list[bytes | None](), []
        for file in submission.notebooks:
            try:
                contents.append(file.read())
            except UnreadableFile as error:
                faults.append(str(error))
        fault = faults[0] if faults and not contents else ""
        parts = [submission.student, submission.seed_id, *contents, fault, *submission.notes]
        yield GradingJob(submission, contents or [None], fault, fingerprint(sheet, way, parts))


def run_bounded(
    submit: Callable[[Job], Future[Outcome]], jobs: Iterable[Job], max_pending: int
) -> Iterator[tuple[Job, Outcome | BaseException]]:
    """Each job with its outcome, or with the error that it raised, in the order in which they finish.

    submit       gives a job to an executor
    max_pending  how many jobs the executor may have at a time. A job is made when there is room for it, so that a thousand
                 notebooks are never in memory together

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(1) as pool:
    ...     dict(run_bounded(lambda x: pool.submit(abs, x), [-1, -2], max_pending=1))
    {-1: 1, -2: 2}
    """
    pending: dict[Future[Outcome], Job] = {}
    remaining = iter(jobs)
    try:
        while True:
            while len(pending) < max_pending and (job := next(remaining, None)) is not None:
                pending[submit(job)] = job
            if not pending:
                return
            for future in wait(pending, return_when=FIRST_COMPLETED).done:
                yield pending.pop(future), future.exception() or future.result()
    finally:
        for future in pending:
            future.cancel()
