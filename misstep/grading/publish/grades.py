"""The list of grades: a row for each student, with the reason beside the points."""

from collections import Counter
from collections.abc import Sequence

from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import table
from misstep.grading.publish.pages import points
from misstep.grading.sandbox.limits import UNSAFE


def grades(results: Sequence[Result]) -> str:
    """The list as CSV: student, points, of how many, how it went, each problem's points, reasons, and how it was run."""
    numbers = [problem.number for problem in results[0].problems] if results else []
    header = ["student", "points", "max", "status", *numbers, "reason", "mistakes", "id in the sheet", "run in"]
    typed = Counter(_folded(result.typed_id) for result in results)
    return table(header, (_row(result, typed[_folded(result.typed_id)]) for result in results))


def _row(result: Result, namesakes: int) -> list[str]:
    odd = [f"{problem.number}: {note}" for problem in result.problems for note in problem.notes]
    twice = f"The id {result.typed_id!r} stands in {namesakes} sheets." if namesakes > 1 and result.typed_id else ""
    mistakes = [f"{problem.number} {name}" for problem in result.problems for name in problem.mistakes]
    reasons = [result.reason, *result.notes, *odd, twice if _folded(result.student) != _folded(result.typed_id) else ""]
    return [
        result.student,
        points(result.points),
        points(result.max),
        result.status,
        *(points(problem.points) for problem in result.problems),
        " ".join(reason for reason in reasons if reason),
        "; ".join(mistakes),
        result.typed_id,
        "sandbox" if result.is_safe else UNSAFE,
    ]


def _folded(name: str) -> str:
    return name.strip().casefold()
