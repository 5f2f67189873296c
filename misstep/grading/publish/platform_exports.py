"""Exports: the points in the columns that a learning platform imports, based on the roster that it exported.

Canvas      Grades, Import: the columns that identify a student, and one for the sheet
Moodle      the grading worksheet, with the column Grade filled in; the assignment's "Upload grading worksheet"
Gradescope  the columns of its own list of grades, for programs that read such lists
"""

from collections.abc import Callable, Mapping, Sequence

from misstep.grading.collect.roster import Roster, Row
from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import format_csv
from misstep.grading.publish.pages import format_points

CANVAS_ID_COLUMNS = ("student", "id", "sis user id", "sis login id", "section")
GRADESCOPE_ID_COLUMNS = ("first name", "last name", "name", "sid", "email", "sections", "section_name")

ResultsById = Mapping[str, Result]
"""Results by the id in lower case."""


def export(roster: Roster, results: Sequence[Result], column: str | None = None) -> str | None:
    """The file for the platform of the roster; None for your own roster. A student without a result has an empty cell.

    column  the column of the sheet on the platform; by default the only column of the roster that contains the sheet's name,
            or else the sheet's name

    Raises ValueError for a roster without a numeric maximum grade.
    """
    if roster.kind not in WRITERS or not results:
        return None
    results_by_id = {result.student.strip().casefold(): result for result in results}
    return WRITERS[roster.kind](roster, results_by_id, column or _column(roster, results[0].sheet))


def _canvas(roster: Roster, results_by_id: ResultsById, column: str) -> str:
    id_columns = _existing_columns(roster, CANVAS_ID_COLUMNS)
    max_points = _any_result(results_by_id).max
    out_of = ["    Points Possible", *[""] * (len(id_columns) - 1), format_points(max_points)]
    rows = [[*(row[name] for name in id_columns), _points(roster, row, results_by_id)] for row in roster.rows]
    return format_csv([*id_columns, column], [out_of, *rows])


def _moodle(roster: Roster, results_by_id: ResultsById, _: str) -> str:
    grade_column, max_column = roster.column("grade"), roster.column("maximum grade")
    rows = []
    for row in roster.rows:
        filled = dict(row)
        if (result := _result_of(roster, row, results_by_id)) and grade_column:
            scale = _scale(row[max_column], result) if max_column else 1.0
            filled[grade_column] = format_points(result.points * scale)
        rows.append([filled[name] for name in roster.columns])
    return format_csv(roster.columns, rows)


def _gradescope(roster: Roster, results_by_id: ResultsById, column: str) -> str:
    id_columns = _existing_columns(roster, GRADESCOPE_ID_COLUMNS)
    max_points = format_points(_any_result(results_by_id).max)
    rows = [
        [*(row[name] for name in id_columns), _points(roster, row, results_by_id), max_points] for row in roster.rows
    ]
    return format_csv([*id_columns, column, f"{column} - Max Points"], rows)


WRITERS: Mapping[str, Callable[[Roster, ResultsById, str], str]] = {
    "canvas": _canvas,
    "moodle": _moodle,
    "gradescope": _gradescope,
}


def _scale(cell: str, result: Result) -> float:
    """The factor from the sheet's points to Moodle's, which are relative to the maximum grade of the assignment."""
    try:
        max_points = float(cell.replace(",", "."))
    except ValueError as error:
        raise ValueError(
            f"The roster's maximum grade must be a number; got {cell!r}. In Moodle, grade the assignment with points, not a scale."
        ) from error
    return max_points / result.max


def _column(roster: Roster, sheet: str) -> str:
    matching = [column for column in roster.columns if sheet.casefold() in column.casefold() and " - " not in column]
    return matching[0] if len(matching) == 1 else sheet


def _existing_columns(roster: Roster, names: Sequence[str]) -> list[str]:
    return [column for name in names if (column := roster.column(name)) is not None]


def _result_of(roster: Roster, row: Row, results_by_id: ResultsById) -> Result | None:
    return results_by_id.get(roster.id_of(row).casefold())


def _points(roster: Roster, row: Row, results_by_id: ResultsById) -> str:
    result = _result_of(roster, row, results_by_id)
    return format_points(result.points) if result else ""


def _any_result(results_by_id: ResultsById) -> Result:
    return next(iter(results_by_id.values()))
