"""The table of grades: a row for each student, with the reasons beside the points."""

from collections import Counter
from collections.abc import Sequence

from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import format_csv
from misstep.grading.publish.pages import format_points
from misstep.grading.sandbox.limits import UNSAFE_OPTION


def grades_table(results: Sequence[Result]) -> str:
    """The table as CSV: student, points, maximum, status, points of each problem, reasons, mistakes, and how it was run."""
    numbers = [problem.number for problem in results[0].problems] if results else []
    has_key = any(problem.own_points is not None for result in results for problem in result.problems)
    header = [
        "student",
        "points",
        "max",
        "status",
        *numbers,
        "reason",
        "mistakes",
        "id in the sheet",
        "run in",
        "by hand",
    ]
    header += ["points without the key", "right only for the own numbers"] if has_key else []
    typed_ids = Counter(_fold(result.typed_id) for result in results)
    rows = [_row(result, typed_ids[_fold(result.typed_id)]) for result in results]
    return format_csv(header, (row[: len(header)] for row in rows))


def _row(result: Result, typed_count: int) -> list[str]:
    notes = [f"{problem.number}: {note}" for problem in result.problems for note in problem.notes]
    repeated = f"The id {result.typed_id!r} is in {typed_count} sheets." if typed_count > 1 and result.typed_id else ""
    mistakes = [f"{problem.number} {name}" for problem in result.problems for name in problem.mistakes]
    is_own_id = _fold(result.student) == _fold(result.typed_id)
    reasons = [result.reason, *result.notes, *notes, "" if is_own_id else repeated]
    return [
        result.student,
        format_points(result.points),
        format_points(result.max),
        result.status,
        *(format_points(problem.points) for problem in result.problems),
        " | ".join(reason for reason in reasons if reason),
        "; ".join(mistakes),
        result.typed_id,
        "sandbox" if result.is_safe else UNSAFE_OPTION,
        " | ".join(result.changes),
        format_points(sum(one.points if one.own_points is None else one.own_points for one in result.problems)),
        "; ".join(problem.number for problem in result.typed),
    ]


def _fold(name: str) -> str:
    return name.strip().casefold()
