"""Jobs: the submissions that must be graded, each with the fingerprint of everything that its result depends on."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from misstep.grading.collect.files import UnreadableFile
from misstep.grading.collect.gather import Submission, typed_id
from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import Result
from misstep.grading.publish.result_store import fingerprint


@dataclass(frozen=True, eq=False)
class GradingJob:
    """A submission that has been read, and is now graded.

    seed_id      the id from which the numbers are drawn
    content      the notebook; None if nothing was submitted, or if the file could not be read
    fault        why the file could not be read, "" if it could
    fingerprint  the digest of everything that the result depends on
    """

    submission: Submission
    seed_id: str
    content: bytes | None
    fault: str
    fingerprint: str

    def complete(self, result: Result) -> Result:
        """The grader's result, with the student's name and the remarks on the files."""
        notes = [*self.submission.notes, *result.notes]
        return replace(result, student=self.submission.student, reason=self.fault or result.reason, notes=notes)


def make_jobs(
    submissions: Sequence[Submission], sheet: ReleasedSheet, is_safe: bool, has_result: Callable[[str, str], bool]
) -> Iterator[GradingJob | None]:
    """A job for each submission, which is read when its job is made; None for a submission that has a result already.

    has_result  whether there is a result for a student and a fingerprint
    """
    for submission in submissions:
        content, fault = None, ""
        try:
            content = submission.read()
        except UnreadableFile as error:
            fault = str(error)
        seed_id = submission.seed_id or (typed_id(content) if content else "") or submission.student
        parts = [submission.student, seed_id, content, fault, *submission.notes]
        job = GradingJob(submission, seed_id, content, fault, fingerprint(sheet, is_safe, parts))
        yield None if has_result(submission.student, job.fingerprint) else job
