"""Points and comments by hand, which count instead of the grader's: in overrides.csv, in the folder of results.

    student,problem,points,comment
    ada,03.1,3,The sketch is right.          these points count for the problem
    bob,03.2,,See page 12.                   a comment only
    cyn,,20,Two days late.                   without a problem: of the whole sheet

They are read in each run, whether anything is graded again or not, and reach the tables, the pages and the platforms. What was entered
in formgrader is in formgrader.csv, in the same form; where both have a line, overrides.csv counts.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from misstep.display.text import points as in_words
from misstep.grading.collect.roster import read_table
from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import format_csv

COLUMNS = ("student", "problem", "points", "comment")

FILES = ("formgrader.csv", "overrides.csv")
"""The files with overrides; a later one wins."""


@dataclass(frozen=True)
class Override:
    """What an instructor decided about a problem of a student, or, with the problem "", about the whole sheet.

    points  None if only a comment is given
    """

    student: str
    problem: str
    points: float | None
    comment: str

    def describe(self, before: float) -> str:
        """A sentence for the student.

        >>> Override("ada", "03.1", 3.0, "The sketch is right.").describe(1.5)
        'Changed by your instructor from 1 1/2 to 3 points. The sketch is right.'
        """
        change = (
            ""
            if self.points is None
            else f"Changed by your instructor from {in_words(before)} to {in_words(self.points)} points. "
        )
        return f"{change or 'From your instructor: '}{self.comment}".strip()


def write_template(out: Path) -> None:
    """Write an empty overrides.csv, unless there is one."""
    path = out / FILES[-1]
    if not path.exists():
        path.write_text(format_csv(COLUMNS, []), "utf-8")


def read_overrides(out: Path) -> dict[str, list[Override]]:
    """The overrides in the folder of results, by student.

    Raises ValueError for a table without the columns, and for points that are no number.
    """
    found: dict[tuple[str, str], Override] = {}
    for path in (out / name for name in FILES):
        if path.exists():
            found |= {(one.student, one.problem): one for one in _read(path)}
    by_student: dict[str, list[Override]] = {}
    for one in found.values():
        by_student.setdefault(one.student, []).append(one)
    return by_student


def _read(path: Path) -> list[Override]:
    header, rows, _ = read_table(path)
    titles = [title.strip().casefold() for title in header]
    if missing := [name for name in COLUMNS if name not in titles]:
        raise ValueError(f"{path} must have the columns {', '.join(COLUMNS)}; {', '.join(missing)} is missing.")
    overrides = []
    for row in rows:
        student, problem, points, comment = (row[titles.index(name)].strip() for name in COLUMNS)
        try:
            value = float(points.replace(",", ".")) if points else None
        except ValueError:
            value = -1.0
        if value is not None and not 0 <= value < float("inf"):
            raise ValueError(f"{path}: points must be a number, 0 or more; got {points!r} for {student} {problem}.")
        overrides.append(Override(student, problem, value, comment))
    return overrides


def apply_overrides(result: Result, overrides: Sequence[Override]) -> Result:
    """The result as the instructor decided. Each change is in its notes, and in its `changes`.

    Raises ValueError for a problem that the sheet does not have, and for more points than there are.
    """
    by_problem = {one.problem: one for one in overrides}
    maxima = {"": result.max, **{problem.number: problem.max for problem in result.problems}}
    for one in overrides:
        if one.problem not in maxima:
            raise ValueError(
                f"{FILES[-1]}: sheet {result.sheet} has no problem {one.problem!r}; it has {', '.join(filter(None, maxima))}."
            )
        if one.points is not None and one.points > maxima[one.problem]:
            raise ValueError(
                f"{FILES[-1]}: {one.student} {one.problem} can have at most {maxima[one.problem]:g} points; got {one.points:g}."
            )
    problems, changes = [], []
    for problem in result.problems:
        if override := by_problem.get(problem.number):
            note = override.describe(problem.points)
            changes.append(f"{problem.number}: {note}")
            points = problem.points if override.points is None else override.points
            problem = replace(problem, points=points, notes=[*problem.notes, note])  # noqa: PLW2901
        problems.append(problem)
    total, notes = sum(problem.points for problem in problems), list(result.notes)
    if override := by_problem.get(""):
        notes.append(override.describe(total))
        changes.append(notes[-1])
        total = total if override.points is None else override.points
    return replace(result, points=total, problems=problems, notes=notes, changes=changes)


def write_formgrader(out: Path, overrides: Mapping[str, Sequence[Override]]) -> None:
    """Write what was entered in formgrader."""
    rows = [
        [one.student, one.problem, "" if one.points is None else f"{one.points:g}", one.comment]
        for student in sorted(overrides)
        for one in overrides[student]
    ]
    (out / FILES[0]).write_text(format_csv(COLUMNS, rows), "utf-8")
