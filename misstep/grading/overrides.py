"""Points and comments by hand, which count in the place of the grader's: in overrides.csv, in the folder of results.

student,problem,points,comment
ada,03.1,3,The sketch is right.          these points count for the problem
bob,03.2,,See page 12.                   a comment only
cyn,,20,You explained it to me.          without a problem: of the whole sheet
"""

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

from misstep.display.text import points as in_words
from misstep.grading.collect.roster import read_table
from misstep.grading.escape import csv_text
from misstep.sheet import Sheet

COLUMNS = ("student", "problem", "points", "comment")


@dataclass(frozen=True)
class Override:
    """What an instructor decided about a problem of one student."""

    problem: str  # "" for the whole sheet
    points: float | None  # None if only a comment is given
    comment: str

    def sentence(self, before: float) -> str:
        """Return what the student reads.

        >>> Override("03.1", 3.0, "The sketch is right.").sentence(1.5)
        'Changed by your instructor from 1 1/2 to 3 points. The sketch is right.'
        """
        if self.points is None:
            return f"From your instructor: {self.comment}"
        changed = f"Changed by your instructor from {in_words(before)} to {in_words(self.points)} points."
        return f"{changed} {self.comment}".strip()


def read_overrides(out: Path, sheet: Sheet, students: Collection[str]) -> dict[str, list[Override]]:
    """Read the overrides in a folder of results, by student, and write the empty table if there is none.

    Raises ValueError that names every line with a fault: an unknown student or problem, points that are no number or too many,
    and a line that is there twice.
    """
    path = out / "overrides.csv"
    if not path.exists():
        out.mkdir(parents=True, exist_ok=True)
        path.write_text(csv_text(COLUMNS, []), "utf-8")
    header, rows, _ = read_table(path)
    titles = [title.strip().casefold() for title in header]
    if not set(COLUMNS) <= set(titles):
        raise ValueError(f"{path} must have the columns {', '.join(COLUMNS)}; it has {', '.join(header)}.")
    maxima = {"": sheet.points} | {template.number: template.points for template in sheet.problems}
    spelled = {name.casefold(): name for name in students}
    found: dict[str, list[Override]] = {}
    faults = []
    for line, row in enumerate(rows, start=2):
        name, problem, text, comment = (row[titles.index(title)].strip() for title in COLUMNS)
        try:
            points = float(text.replace(",", ".")) if text else None
        except ValueError:
            points = -1.0
        student = spelled.get(name.lstrip("'").casefold(), "")
        maximum = maxima.get(problem)
        known = found.setdefault(student, [])
        if not student:
            faults.append(f"line {line}: there is no student {name!r}")
        elif maximum is None:
            faults.append(f"line {line}: there is no problem {problem!r}, only {', '.join(filter(None, maxima))}")
        elif points is not None and not 0 <= points <= maximum:
            faults.append(f"line {line}: the points must be a number from 0 to {maximum:g}; got {text!r}")
        elif any(one.problem == problem for one in known):
            faults.append(f"line {line}: {name} {problem or 'whole sheet'} has a line already")
        else:
            known.append(Override(problem, points, comment))
    if faults:
        raise ValueError(f"{path} has faults, and nothing was graded: {'; '.join(faults)}.")
    return found
