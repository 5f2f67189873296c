"""Jobs: the submissions that must be graded, each with the fingerprint of everything that its result depends on."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from misstep.grading.collect.files import UnreadableFile, list_names
from misstep.grading.collect.gather import Submission, typed_id
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import ABSENT, Result
from misstep.grading.publish.result_store import fingerprint


@dataclass(frozen=True, eq=False)
class GradingJob:
    """A submission that has been read, and is now graded.

    seed_id      the id from which the numbers are drawn
    contents     the notebooks, of which the best one counts; [None] if nothing was submitted or no file could be read
    fault        why no file could be read, "" if one could
    fingerprint  the digest of everything that the result depends on
    """

    submission: Submission
    seed_id: str
    contents: Sequence[bytes | None]
    fault: str
    fingerprint: str

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


def grade_best(grade: Callable[[str, bytes | None], Result], seed_id: str, contents: Sequence[bytes | None]) -> Result:
    """Grade each of a student's notebooks; the result with the most points, the first one of these."""
    return max((grade(seed_id, content) for content in contents), key=lambda result: result.points)


def make_jobs(
    submissions: Sequence[Submission], sheet: ReleasedSheet, is_safe: bool, has_result: Callable[[str, str], bool]
) -> Iterator[GradingJob | None]:
    """A job for each submission, which is read when its job is made; None for a submission that has a result already.

    has_result  whether there is a result for a student and a fingerprint
    """
    for submission in submissions:
        contents, faults = list[bytes | None](), []
        for file in submission.notebooks:
            try:
                contents.append(file.read())
            except UnreadableFile as error:
                faults.append(str(error))
        typed = (name for content in contents if content and (name := typed_id(content)))
        seed_id = submission.seed_id or next(typed, "") or submission.student
        fault = faults[0] if faults and not contents else ""
        parts = [submission.student, seed_id, *contents, fault, *submission.notes]
        job = GradingJob(submission, seed_id, contents or [None], fault, fingerprint(sheet, is_safe, parts))
        yield None if has_result(submission.student, job.fingerprint) else job
