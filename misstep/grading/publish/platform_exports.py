"""Exports: the points in the columns that a learning platform takes back, made from the roster that it gave.

Canvas      Grades, Import: the columns that say who, and one for the sheet
Moodle      the grading worksheet, with the column Grade filled in; the assignment's "Upload grading worksheet"
Gradescope  the columns of its own list of grades, for whatever reads such lists
"""

from collections.abc import Callable, Mapping, Sequence

from misstep.grading.collect.roster import Roster, Row
from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import table
from misstep.grading.publish.pages import points

WHO_CANVAS = ("student", "id", "sis user id", "sis login id", "section")
WHO_GRADESCOPE = ("first name", "last name", "name", "sid", "email", "sections", "section_name")

Graded = Mapping[str, Result]
"""Results by the id in small letters."""


def export(roster: Roster, results: Sequence[Result], column: str | None = None) -> str | None:
    """The file for the platform of the roster; None for a roster of one's own. Who has no result keeps an empty cell.

    column  what the sheet is called on the platform: by default its name, or the only column of the roster that holds it

    Raises ValueError for a roster from which points cannot be told.
    """
    if roster.kind not in WRITERS or not results:
        return None
    graded = {result.student.strip().casefold(): result for result in results}
    return WRITERS[roster.kind](roster, graded, column or _column(roster, results[0].sheet))


def _canvas(roster: Roster, graded: Graded, column: str) -> str:
    who = _present(roster, WHO_CANVAS)
    most = _any(graded).max
    out_of = ["    Points Possible", *[""] * (len(who) - 1), points(most)]
    rows = [[*(row[name] for name in who), _points(roster, row, graded)] for row in roster.rows]
    return table([*who, column], [out_of, *rows])


def _moodle(roster: Roster, graded: Graded, _: str) -> str:
    grade, most = roster.column("grade"), roster.column("maximum grade")
    rows = []
    for row in roster.rows:
        filled = dict(row)
        if (result := _of(roster, row, graded)) and grade:
            filled[grade] = points(result.points * (_scale(row[most], result) if most else 1.0))
        rows.append([filled[name] for name in roster.columns])
    return table(roster.columns, rows)


def _gradescope(roster: Roster, graded: Graded, column: str) -> str:
    who = _present(roster, WHO_GRADESCOPE)
    rows = [
        [*(row[name] for name in who), _points(roster, row, graded), points(_any(graded).max)] for row in roster.rows
    ]
    return table([*who, column, f"{column} - Max Points"], rows)


WRITERS: Mapping[str, Callable[[Roster, Graded, str], str]] = {
    "canvas": _canvas,
    "moodle": _moodle,
    "gradescope": _gradescope,
}


def _scale(cell: str, result: Result) -> float:
    """Moodle takes no grade above the assignment's own maximum, and means its share of that."""
    try:
        most = float(cell.replace(",", "."))
    except ValueError as error:
        raise ValueError(
            f"The roster's maximum grade is {cell!r}, not a number. In Moodle, grade the assignment by points, not a scale."
        ) from error
    return most / result.max


def _column(roster: Roster, sheet: str) -> str:
    own = [column for column in roster.columns if sheet.casefold() in column.casefold() and " - " not in column]
    return own[0] if len(own) == 1 else sheet


def _present(roster: Roster, names: Sequence[str]) -> list[str]:
    return [column for name in names if (column := roster.column(name)) is not None]


def _of(roster: Roster, row: Row, graded: Graded) -> Result | None:
    return graded.get(roster.id_of(row).casefold())


def _points(roster: Roster, row: Row, graded: Graded) -> str:
    result = _of(roster, row, graded)
    return points(result.points) if result else ""


def _any(graded: Graded) -> Result:
    return next(iter(graded.values()))
