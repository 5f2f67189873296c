"""Rosters: the list of students of a course, as a learning platform exports it, or your own, and the points for it.

Canvas      Grades, Export:                    Student, ID, SIS User ID, SIS Login ID, Section, ...
Moodle      the assignment's grading worksheet: Identifier, Full name, Email address, ..., Grade, Maximum grade, ...
Gradescope  the assignment, Download Grades:    First Name, Last Name, SID, Email, ...
your own    any table with a column id

Moodle writes its headers in the language of the user who exports, and in some languages the first one is "ID". So Moodle's and
Canvas's tables are recognised by their cells, and their columns by what they contain and where they are.

Source: col_recordid and the columns of mod/assign/gradingtable.php of Moodle; lib/gradebook_exporter.rb of Canvas.
"""

import csv
import io
import re
import unicodedata
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from misstep.grading.escape import csv_text, format_points

Row = Sequence[str]
PARTICIPANT = re.compile(r"(?P<word>\D*[^\W\d_]\D*?)\s*(?P<key>\d+)")
"""Moodle's first column: "Participant 1815", "Teilnehmer/in1815", in the language of the user who exported the table."""
TEST_STUDENT = re.compile(r"student, test|test student|[0-9a-f]{32,}", re.IGNORECASE)
"""Canvas's test student: the name in English, and the login in every language."""
ID_TITLES = {
    "canvas": ("sis login id", "sis user id"),
    "moodle": ("id number", "username"),
    "gradescope": ("sid", "email"),
    "own": ("id",),
}
"""The columns in which the ids may be that students type, the best first."""


@dataclass(frozen=True)
class Roster:
    """The list of students of a course."""

    kind: str  # canvas, moodle, gradescope or own
    columns: Sequence[str]
    rows: Sequence[Row]
    ids: Sequence[str]  # that students type into their sheets, for each row; "" for none
    by_key: Mapping[str, str]  # the ids by what the names of downloaded files contain, "" for a test student
    kept: int  # the column before the one for the points: Moodle's status, Canvas's section
    delimiter: str

    @cached_property
    def by_id(self) -> Mapping[str, str]:
        """The ids as the roster spells them, by themselves without capitals."""
        return {name.casefold(): name for name in self.ids if name}


def read_roster(path: Path, id_column: str | None = None) -> Roster:
    """Read a roster.

    id_column  the header of the column with the ids; by default the first of the platform's id columns that is filled in most rows

    Raises ValueError for a table of an unknown kind, without such a column, or with the same id or key twice.
    """
    columns, table, delimiter = read_table(path)
    titles = [column.strip().casefold() for column in columns]
    grade = _grade_column(table)
    kind = _kind(titles, table, grade)
    if kind is None or (kind == "moodle" and grade is None):
        raise ValueError(
            f"{path} must be an export of Canvas, Moodle or Gradescope, or a table with a column id; it has the columns "
            f"{', '.join(columns)[:300]}. In Moodle, grade the assignment with points, not a scale."
        )
    place = titles.index(ID_TITLES[kind][0]) if kind in ("gradescope", "own") else 0
    if kind == "canvas":  # the first column with numbers only, after one or two with names
        place = next((k for k in (1, 2) if all(row[k].strip().isdigit() for row in table if row[k].strip())), 1)
    rows = [row for row in table if row[place].strip() or kind == "gradescope"]  # Canvas begins with rows of no student
    wanted = [id_column.strip().casefold()] if id_column else ID_TITLES[kind]
    candidates = [titles.index(title) for title in wanted if title in titles]
    if not (candidates or id_column):
        # Translated: Canvas's last id is the login; Moodle's are between the name and the grade, numbers before addresses.
        possible = range(place + 1, min(place + 3, len(titles))) if kind == "canvas" else range(2, grade or 2)
        unique = [column for column in possible if _has_ids(rows, column)]
        unique.sort(key=lambda column: -column if kind == "canvas" else "@" in rows[0][column])
        candidates = [*unique, *[place] * (kind == "canvas")]
    filled = [column for column in candidates if 2 * sum(bool(row[column].strip()) for row in rows) > len(rows)]
    if not filled:
        raise ValueError(
            f"{path} must have the students' ids in the column {' or '.join(wanted)}, which is missing or mostly empty. "
            "Name the column with --id-column."
        )
    cells = [[row[column].strip() for row in rows] for column in (filled[0], place, candidates[-1])]
    ids, keys, emails = ([unicodedata.normalize("NFC", cell) for cell in column] for column in cells)
    if kind == "moodle":
        keys = [match["key"] if (match := PARTICIPANT.fullmatch(key)) else key for key in keys]
    tests = [kind == "canvas" and any(map(TEST_STUDENT.fullmatch, row[: place + 4])) for row in rows]
    ids = ["" if is_test else id_ for id_, is_test in zip(ids, tests, strict=True)]
    if kind == "gradescope":  # a student without an SID is known by the address
        ids, keys = ([one or other for one, other in zip(column, emails, strict=True)] for column in (ids, keys))
    for names in (ids, keys):
        if repeated := [name for name, count in Counter(map(str.casefold, filter(None, names))).items() if count > 1]:
            raise ValueError(
                f"{path}: each id must occur once, whatever its capitals; it repeats {', '.join(repeated[:5])}. "
                "Correct the list, or export it again."
            )
    section = titles.index("section") if "section" in titles else min(filled[0] + 1, len(titles) - 1)
    by_key = {key.casefold(): id_ for key, id_, is_test in zip(keys, ids, tests, strict=True) if id_ or is_test}
    return Roster(kind, columns, rows, ids, by_key, section if kind == "canvas" else (grade or 0) - 1, delimiter)


def _kind(titles: Sequence[str], rows: Sequence[Row], grade: int | None) -> str | None:
    """Return the platform that wrote the table; the headers of Gradescope are always in English."""
    words = {match["word"].strip() if (match := PARTICIPANT.fullmatch(row[0].strip())) else "" for row in rows}
    # In a list of your own, s1815 is an id. Moodle's word is longer, and its table has a maximum grade; if not, it is said later.
    if len(words) == 1 and len(min(words).encode()) > 3 and (grade is not None or "id" not in titles):
        return "moodle"
    has_points_row = any(len(row) > 3 and row[0].startswith("    ") and not row[1].strip() for row in rows)
    if has_points_row or {"student", "id", "section"} <= set(titles):
        return "canvas"
    return "gradescope" if {"sid", "email"} <= set(titles) else "own" if "id" in titles else None


def _has_ids(rows: Sequence[Row], column: int) -> bool:
    """Whether the cells are ids: most are filled, all are different, and none has a space."""
    cells = [cell for row in rows if (cell := row[column].strip())]
    return 2 * len(cells) > len(rows) and len(set(cells)) == len(cells) and not re.search(r"\s", "".join(cells))


def _grade_column(rows: Sequence[Row]) -> int | None:
    """Moodle's grade: the column, empty or with numbers, before the one in which each row has the same positive number."""
    for place in range(2, len(rows[0]) if rows else 0):
        maxima = {_number(row[place]) for row in rows}
        grades = [row[place - 1].strip() for row in rows]
        if len(maxima) == 1 and (maxima.pop() or 0) > 0 and all(_number(cell) is not None for cell in grades if cell):
            return place - 1
    return None


def _number(cell: str) -> float | None:
    """Return a number, with a decimal point or comma; None for any other text."""
    return float(cell.replace(",", ".")) if re.fullmatch(r"\s*\d+([.,]\d+)?\s*", cell) else None


def read_table(path: Path) -> tuple[list[str], list[Row], str]:
    """Return a table of a spreadsheet: its header, its rows, and what separates its cells.

    Raises ValueError for a file that is none.
    """
    try:
        text = path.read_text("utf-8-sig")
        delimiter = max(",;\t", key=text.partition("\n")[0].count)  # platforms use the one of the user's language
        header, *lines = [*csv.reader(io.StringIO(text), delimiter=delimiter)] or [[]]
    except (UnicodeDecodeError, csv.Error) as error:
        raise ValueError(
            f'{path} must be a table in UTF-8, which a spreadsheet saves as "CSV UTF-8": {error}.'
        ) from error
    return header, [[*line, *[""] * len(header)][: len(header)] for line in lines if any(line)], delimiter


def sheet_column(roster: Roster, sheet: str, column: str | None = None) -> str:
    """Return the column of the sheet: `column`, or else the only one that contains the sheet's name, or else this name."""
    matching = [name for name in roster.columns if sheet.casefold() in name.casefold() and " - " not in name]
    return column or (matching[0] if len(matching) == 1 else sheet)


def export(roster: Roster, points: Mapping[str, float], maximum: float, title: str) -> str:
    """Return the roster with the points of a sheet, as its platform imports it: Moodle's are scaled to the maximum that it names.

    points  by id
    title   the column of the sheet
    """
    columns, kept = roster.columns, roster.kept + 1
    rows: list[Row] = []
    for row, id_ in zip(roster.rows, roster.ids, strict=True):
        cell = format_points(points[id_]) if id_ in points else ""
        if roster.kind == "moodle":
            full = row[kept + 1]
            cell = format_points(points[id_] * (_number(full) or 0) / maximum) if cell else row[kept]
            rows.append([*row[:kept], cell.replace(".", ",") if "," in full else cell, *row[kept + 1 :]])
        elif roster.kind == "canvas":
            rows.append([*row[:kept], cell])
        else:
            rows.append([*row, cell, format_points(maximum)])
    if roster.kind == "canvas":
        out_of = ["    Points Possible", *[""] * (kept - 1), format_points(maximum)]
        return csv_text([*columns[:kept], title], [out_of, *rows], roster.delimiter)
    added = [] if roster.kind == "moodle" else [title, f"{title} - Max Points"]
    return csv_text([*columns, *added], rows, roster.delimiter)
