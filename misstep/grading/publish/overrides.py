"""Points, comments and late days by hand, which count beside the grader's: in overrides.csv, in the folder of results.

    student,problem,points,comment,days late
    ada,03.1,3,The sketch is right.,         these points count for the problem
    bob,03.2,,See page 12.,                  a comment only
    cyn,,20,You explained it to me.,         without a problem: of the whole sheet
    dan,,,,3                                 a rule takes points for 3 days

They are read in each run, whether anything is graded again or not, and reach the tables, the pages and the platforms. The page
marking.html saves marks.csv for answers that a person marks, and what was entered in formgrader is in formgrader.csv, both in
the same form. Where several have a line, overrides.csv counts, then marks.csv.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import ceil
from pathlib import Path

from misstep.display.text import points as in_words
from misstep.grading.collect.roster import read_table
from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import format_csv

COLUMNS = ("student", "problem", "points", "comment")

DAYS_LATE = "days late"
"""A column that may be missing."""

UNMARKED = "unmarked"
"""The state of an answer that a person marks, until then."""

FILES = ("formgrader.csv", "marks.csv", "overrides.csv")
"""The files with overrides; a later one wins."""


@dataclass(frozen=True)
class Override:
    """What an instructor decided about a problem of a student, or, with the problem "", about the whole sheet.

    points     None if only a comment or days are given
    days_late  how many days after its date the sheet was handed in
    """

    student: str
    problem: str
    points: float | None
    comment: str
    days_late: float = 0.0

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

    def describe_mark(self) -> str:
        """A sentence for the student about an answer that only a person marks."""
        return f"Marked by your instructor: {in_words(self.points or 0.0)} points. {self.comment}".strip()


def _marked_state(points: float, maximum: float) -> str:
    return "right" if points >= maximum else "partly" if points else "wrong"


@dataclass(frozen=True)
class LateRule:
    """How many points each late day costs, in percent of the maximum of the sheet, as Canvas's policy for late submissions has it.

    percent  for each day, also for a day that has begun
    free     how many days cost nothing
    lowest   the penalty ends here; an answer that earned less keeps what it has
    """

    percent: float
    free: float = 0.0
    lowest: float = 0.0

    @classmethod
    def parse(cls, text: str) -> "LateRule":
        """The rule in a text such as "percent=10,free=2".

        Raises ValueError for a text of another form, and for numbers that cannot be.

        >>> LateRule.parse("percent=10,free=2")
        LateRule(percent=10.0, free=2.0, lowest=0.0)
        """
        try:
            values = {name.strip(): float(value) for name, value in (part.split("=") for part in text.split(","))}
            rule = cls(**values)
        except (ValueError, TypeError) as error:
            raise ValueError(
                f"--late takes percent=NUMBER, and if you like free=NUMBER and lowest=NUMBER; got {text!r}. "
                "Try --late percent=10,free=2,lowest=50."
            ) from error
        if not (0 <= rule.percent <= 100 and 0 <= rule.lowest <= 100 and 0 <= rule.free < float("inf")):
            raise ValueError(f"--late: percent and lowest must be from 0 to 100, and free 0 or more; got {text!r}.")
        return rule

    def apply(self, points: float, maximum: float, days: float) -> tuple[float, str]:
        """The points that are left, and a sentence for the student.

        >>> LateRule(10, free=2).apply(20.0, 24.0, 3)
        (17.6, 'Handed in 3 days late, 2 of them free: 2.4 of 20 points are taken.')
        """
        counted = max(0, ceil(days - self.free))
        left = min(points, max(points - counted * self.percent / 100 * maximum, self.lowest / 100 * maximum))
        free = f", {min(self.free, days):g} of them free" if self.free else ""
        taken = f"{points - left:.4g} of {points:g} points are taken" if left < points else "this takes no points"
        return left, f"Handed in {days:g} {'day' if days == 1 else 'days'} late{free}: {taken}."


def write_template(out: Path) -> None:
    """Write an empty overrides.csv, unless there is one."""
    path = out / FILES[-1]
    if not path.exists():
        path.write_text(format_csv([*COLUMNS, DAYS_LATE], []), "utf-8")


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
        days = row[titles.index(DAYS_LATE)].strip() if DAYS_LATE in titles else ""
        if days and problem:
            raise ValueError(
                f"{path}: days late are those of the whole sheet; leave the problem {problem} empty for {student}."
            )
        numbers = {}
        for name, text in (("points", points), (DAYS_LATE, days)):
            try:
                numbers[name] = float(text.replace(",", ".")) if text else None
            except ValueError:
                numbers[name] = -1.0
            if (value := numbers[name]) is not None and not 0 <= value < float("inf"):
                raise ValueError(f"{path}: {name} must be a number, 0 or more; got {text!r} for {student} {problem}.")
        overrides.append(Override(student, problem, numbers["points"], comment, numbers[DAYS_LATE] or 0.0))
    return overrides


def check_overrides(out: Path, has_late_rule: bool) -> None:
    """Read the overrides before anything is graded. Raises ValueError as `read_overrides` does, and for late days without a rule."""
    late = [student for student, overrides in read_overrides(out).items() if any(one.days_late for one in overrides)]
    if late and not has_late_rule:
        raise ValueError(
            f"{FILES[-1]}: {late[0]} has days late, and there is no rule for them. Add one, such as --late percent=10,free=2."
        )


def apply_overrides(result: Result, overrides: Sequence[Override], late: LateRule | None = None) -> Result:
    """The result as the instructor decided. Each change is in its notes, and in its `changes`.

    late  the rule for late days; points for the whole sheet that are given by hand stay as they are

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
            is_marked = problem.state == UNMARKED and override.points is not None
            note = override.describe_mark() if is_marked else override.describe(problem.points)
            changes.append(f"{problem.number}: {note}")
            points = problem.points if override.points is None else override.points
            state = _marked_state(points, problem.max) if is_marked else problem.state
            problem = replace(problem, points=points, notes=[*problem.notes, note], state=state)  # noqa: PLW2901
        problems.append(problem)
    total, notes = sum(problem.points for problem in problems), list[str]()
    if override := by_problem.get(""):
        if override.points is not None or override.comment:
            notes.append(override.describe(total))
        if override.points is not None:
            total = override.points
        elif override.days_late and late:
            total, note = late.apply(total, result.max, override.days_late)
            notes.append(note)
    return replace(result, points=total, problems=problems, notes=[*result.notes, *notes], changes=[*changes, *notes])


def write_formgrader(out: Path, overrides: Mapping[str, Sequence[Override]]) -> None:
    """Write what was entered in formgrader."""
    rows = [
        [one.student, one.problem, "" if one.points is None else f"{one.points:g}", one.comment]
        for student in sorted(overrides)
        for one in overrides[student]
    ]
    (out / FILES[0]).write_text(format_csv(COLUMNS, rows), "utf-8")
