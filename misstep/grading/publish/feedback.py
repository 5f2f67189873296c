"""Feedback: a page for one student, with the points, each verdict in words, and the sheet as it ran."""

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.pages import render_page


def feedback_page(result: Result) -> str:
    """The page of one student: the student's code, its outputs, and the verdicts. It has no data of other students.

    The right answers are not on it, so that the student can try again.
    """
    remarks = [line for line in (result.reason, *result.notes) if line]
    return render_page(
        "feedback.html",
        result=result,
        remarks=remarks,
        patterns=[str(one) for one in result.recurrences if one.returns or one.is_slip],
        verdict_lines=verdict_lines,
        is_safe=result.is_safe,
    )


def verdict_lines(problem: ProblemResult) -> list[str]:
    """The lines of a verdict without its title, which the page has already."""
    return [line.strip() for line in problem.verdict.splitlines()[1:] or [problem.verdict] if line.strip()]
