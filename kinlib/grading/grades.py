"""The list of grades: a row for each student, with the reason beside the points."""

from collections.abc import Sequence

from kinlib.grading.layers import UNSAFE
from kinlib.grading.pages import points
from kinlib.grading.result import Result
from kinlib.grading.tables import table


def grades(results: Sequence[Result]) -> str:
    """The list as CSV: student, points, of how many, how it went, each problem's points, reasons, and how it was run."""
    numbers = [problem.number for problem in results[0].problems] if results else []
    header = ["student", "points", "max", "status", *numbers, "reason", "mistakes", "id in the sheet", "run in"]
    return table(header, map(_row, results))


def _row(result: Result) -> list[str]:
    odd = [f"{problem.number}: {note}" for problem in result.problems for note in problem.notes]
    mistakes = [f"{problem.number} {name}" for problem in result.problems for name in problem.mistakes]
    return [
        result.student,
        points(result.points),
        points(result.max),
        result.status,
        *(points(problem.points) for problem in result.problems),
        " ".join(part for part in (result.reason, *result.notes, *odd) if part),
        "; ".join(mistakes),
        result.typed_id,
        "sandbox" if result.is_safe else UNSAFE,
    ]
