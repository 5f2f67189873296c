"""Exports: the points in the columns that a learning platform imports, based on the roster that it exported.

Canvas      Grades, Import: the columns that identify a student, and one for the sheet
Moodle      the grading worksheet, with the column Grade filled in; the assignment's "Upload grading worksheet"
Gradescope  the columns of its own list of grades, for programs that read such lists

Cells are separated as in the roster, because a platform reads what it writes: in many languages, semicolons.
"""

from collections.abc import Callable, Mapping, Sequence

from misstep.grading.collect.roster import Roster, Row
from misstep.grading.judging.result import ABSENT, Result
from misstep.grading.publish.csv_table import format_csv
from misstep.grading.publish.pages import format_points

GRADESCOPE_ID_COLUMNS = ("first name", "last name", "name", "sid", "email", "sections", "section_name")

ResultsById = Mapping[str, Result]
"""The results of those who submitted something, by their ids."""


def export(roster: Roster, results: Sequence[Result], column: str | None = None) -> str | None:
    """The file for the platform of the roster; None for your own roster. A student who submitted nothing has an empty cell.

    column  the column of the sheet on the platform; by default the only column of the roster that contains the sheet's name,
            or else the sheet's name

    Raises ValueError for a roster without a numeric maximum grade.
    """
    if roster.kind not in WRITERS or not results:
        return None
    results_by_id = {result.student: result for result in results if result.status != ABSENT}
    name = column or _column(roster, results[0].sheet)
    return WRITERS[roster.kind](roster, results_by_id, name, results[0].max)


def _canvas(roster: Roster, results_by_id: ResultsById, column: str, max_points: float) -> str:
    # Up to the section: the columns before the first assignment, where the row of the points possible has a number.
    places = range(_section_column(roster) + 1)
    header = [roster.columns[place] for place in places]
    out_of = ["    Points Possible", *[""] * (len(header) - 1), format_points(max_points)]
    rows = [[*(row[place] for place in places), _points(roster, row, results_by_id)] for row in roster.rows]
    return format_csv([*header, column], [out_of, *rows], roster.delimiter)


def _section_column(roster: Roster) -> int:
    """Canvas's Section: by its name, or else the column after the login id."""
    titles = [column.strip().casefold() for column in roster.columns]
    return titles.index("section") if "section" in titles else min(roster.id_column + 1, len(titles) - 1)


def _moodle(roster: Roster, results_by_id: ResultsById, _: str, __: float) -> str:
    rows = []
    for row in roster.rows:
        filled = list(row)
        result = results_by_id.get(roster.id_of(row))
        if result and roster.grade_column is not None:
            maximum = row[roster.grade_column + 1]
            points = format_points(result.points * float(maximum.replace(",", ".")) / result.max)
            filled[roster.grade_column] = points.replace(".", ",") if "," in maximum else points
        rows.append(filled)
    return format_csv(roster.columns, rows, roster.delimiter)


def _gradescope(roster: Roster, results_by_id: ResultsById, column: str, max_points: float) -> str:
    titles = [name.strip().casefold() for name in roster.columns]
    places = [titles.index(name) for name in GRADESCOPE_ID_COLUMNS if name in titles]
    rows = [
        [*(row[place] for place in places), _points(roster, row, results_by_id), format_points(max_points)]
        for row in roster.rows
    ]
    return format_csv(
        [*(roster.columns[place] for place in places), column, f"{column} - Max Points"], rows, roster.delimiter
    )


WRITERS: Mapping[str, Callable[[Roster, ResultsById, str, float], str]] = {
    "canvas": _canvas,
    "moodle": _moodle,
    "gradescope": _gradescope,
}


def _column(roster: Roster, sheet: str) -> str:
    matching = [column for column in roster.columns if sheet.casefold() in column.casefold() and " - " not in column]
    return matching[0] if len(matching) == 1 else sheet


def _points(roster: Roster, row: Row, results_by_id: ResultsById) -> str:
    result = results_by_id.get(roster.id_of(row))
    return format_points(result.points) if result else ""
