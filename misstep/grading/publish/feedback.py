"""Feedback: a page for one student, with the points, each verdict in words, and the sheet as it ran."""

from misstep.grading.judging.result import ProblemResult, Result
from misstep.grading.publish.pages import page


def feedback(result: Result) -> str:
    """The page. It holds what the student wrote, what that gave, and the judge's sentences; nobody else's data.

    The right answer is not in it: whoever has not found it may try again.
    """
    told = [line for line in (result.reason, *result.notes) if line]
    return page("feedback.html", result=result, told=told, lines=lines, is_safe=result.is_safe)


def lines(problem: ProblemResult) -> list[str]:
    """The lines of a verdict below its title, which the page gives itself."""
    return [line.strip() for line in problem.verdict.splitlines()[1:] or [problem.verdict] if line.strip()]
