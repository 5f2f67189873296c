"""The table of grades: a row for each student, with the reasons beside the points."""

import csv
import io
from collections import Counter
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import escape_formula, format_csv
from misstep.grading.publish.pages import format_points
from misstep.grading.sandbox.limits import UNSAFE_OPTION

LOG_COLUMNS = ("when", "student", "problem", "before", "after", "why")
"""The columns of the log of changes; without a problem, a row is about the points of the whole sheet."""


def grades_table(results: Sequence[Result]) -> str:
    """The table as CSV, with a row for each result, of which there is at least one."""
    has_key = any(problem.own_points is not None for result in results for problem in result.problems)
    typed_ids = Counter(_fold(result.typed_id) for result in results)
    rows = [_row(result, typed_ids[_fold(result.typed_id)], has_key) for result in results]
    return format_csv(list(rows[0]), (list(row.values()) for row in rows))


def record_changes(log: Path, table: Path, results: Sequence[Result]) -> str:
    """Add to a log what is about to change in a table of grades, whatever the cause. Returns the changed students, in words."""
    if not table.exists():
        return ""
    before = {row["student"]: row for row in csv.DictReader(io.StringIO(table.read_text("utf-8")))}
    rows = []
    for result in results:
        old = before.get(escape_formula(result.student), {})
        now = {"": result.points} | {problem.number: problem.points for problem in result.problems}
        why = " | ".join(result.changes) or "graded again"
        for number, points in now.items():
            was, text = old.get(number or "points"), format_points(points)
            if was is not None and was != text:
                rows.append([f"{datetime.now():%Y-%m-%d %H:%M}", result.student, number, was, text, why])
    if rows:
        added = format_csv(LOG_COLUMNS, rows)
        with log.open("a", encoding="utf-8") as stream:
            stream.write(added.partition("\n")[2] if log.stat().st_size else added)
    return ", ".join(dict.fromkeys(row[1] for row in rows))


def _row(result: Result, typed_count: int, has_key: bool) -> dict[str, str]:
    """The cells of a row by their columns."""
    notes = [f"{problem.number}: {note}" for problem in result.problems for note in problem.notes]
    repeated = f"The id {result.typed_id!r} is in {typed_count} sheets." if typed_count > 1 and result.typed_id else ""
    is_own_id = _fold(result.student) == _fold(result.typed_id)
    reasons = [result.reason, *result.notes, *notes, "" if is_own_id else repeated]
    row = {
        "student": result.student,
        "points": format_points(result.points),
        "max": format_points(result.max),
        "status": result.status,
        **{problem.number: format_points(problem.points) for problem in result.problems},
        "reason": " | ".join(reason for reason in reasons if reason),
        "mistakes": "; ".join(f"{problem.number} {name}" for problem in result.problems for name in problem.mistakes),
        "id in the sheet": result.typed_id,
        "run in": "sandbox" if result.is_safe else UNSAFE_OPTION,
        "by hand": " | ".join(result.changes),
    }
    if has_key:
        own = sum(one.points if one.own_points is None else one.own_points for one in result.problems)
        row["points without the key"] = format_points(own)
        row["right only for the own numbers"] = "; ".join(problem.number for problem in result.typed)
    return row


def _fold(name: str) -> str:
    return name.strip().casefold()
