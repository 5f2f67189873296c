"""Feedback: a page for one student, with the points, each problem with its verdict in words, and the sheet as it ran."""

from misstep.grading.judging.result import Result
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
        unsolved=[(k, one) for k, one in enumerate(result.problems, start=1) if one.state != "right"],
        solved=[(k, one) for k, one in enumerate(result.problems, start=1) if one.state == "right"],
        is_safe=result.is_safe,
    )
