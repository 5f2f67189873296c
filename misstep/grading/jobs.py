"""Jobs: the submissions that must be graded, each with the fingerprint of everything that its result depends on."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from misstep.grading.collect.files import UnreadableFile, list_names
from misstep.grading.collect.gather import Submission
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import ABSENT, Result
from misstep.grading.publish.result_store import fingerprint


@dataclass(frozen=True, eq=False)
class GradingJob:
    """A submission that has been read, and is now graded.

    seed_id      the id from which the numbers are drawn; "" for the one that is typed in a notebook, or else the student's name
    contents     the notebooks, of which the best one counts; [None] if nothing was submitted or no file could be read
    fault        why no file could be read, "" if one could
    fingerprint  the digest of everything that the result depends on
    """

    submission: Submission
    seed_id: str
    contents: Sequence[bytes | None]
    fault: str
    fingerprint: str

    @property
    def request(self) -> tuple[str, str, Sequence[bytes | None]]:
        """The arguments of `grade_best` after the first one."""
        return self.submission.student, self.seed_id, self.contents

    def complete(self, result: Result) -> Result:
        """The grader's result, with the student's name and the remarks on the files."""
        notes = [*self.submission.notes, *result.notes]
        if len(self.contents) > 1:
            chosen = self.submission.with_notebook(result.digest).notebook
            files = list_names(self.submission.notebooks)
            counts = f"{chosen.path} counts, because no other has more points" if chosen else ""
            notes.insert(0, f"{len(self.contents)} notebooks were handed in and graded ({files}); {counts}.")
        status = ABSENT if self.submission.notebook is None else result.status
        return replace(
            result, student=self.submission.student, status=status, reason=self.fault or result.reason, notes=notes
        )


def grade_best(
    grade: Callable[[str, bytes | None, str], Result], student: str, seed_id: str, contents: Sequence[bytes | None]
) -> Result:
    """Grade each of a student's notebooks; the result with the most points, the first one of these."""
    results = [grade(student, content, seed_id) for content in contents]
    limits = list(dict.fromkeys(limit for result in results for limit in result.limits))
    return replace(max(results, key=lambda result: result.points), limits=limits)


def make_jobs(
    submissions: Sequence[Submission], sheet: ReleasedSheet, way: str, has_result: Callable[[str, str], bool]
) -> Iterator[GradingJob | None]:
    """A job for each submission, which is read when its job is made; None for a submission that has a result already.

    way         how submissions run: the limits, and whether in the sandbox
    has_result  whether there is a result for a student and a fingerprint
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
        job = GradingJob(submission, submission.seed_id, contents or [None], fault, fingerprint(sheet, way, parts))
        yield None if has_result(submission.student, job.fingerprint) else job
