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
MOODLE_IDS = ("id number", "username")


@dataclass(frozen=True)
class Roster:
    """The list of students of a course. Columns are given by their place, because two may have the same header."""

    kind: str  # canvas, moodle, gradescope or own
    columns: Sequence[str]
    rows: Sequence[Row]
    id_column: int  # with the ids that students type into their sheets
    key_column: int  # with the number that the names of downloaded files contain
    grade_column: int | None = None  # Moodle's, to the left of the maximum grade
    test_keys: Sequence[str] = ()  # of students who do not exist: Canvas's test student
    delimiter: str = ","

    def id_of(self, row: Row) -> str:
        """The id of a student, as it is typed into sheets."""
        return unicodedata.normalize("NFC", row[self.id_column].strip())

    @cached_property
    def ids(self) -> list[str]:
        """The ids of all students, without test students."""
        people = [row for row in self.rows if _key(self.kind, row[self.key_column]) not in self.test_keys]
        return [name for row in people if (name := self.id_of(row))]

    def spelled(self, name: str) -> str | None:
        """An id as the roster spells it, whatever its capitals; None if the roster does not have it."""
        return self._spellings.get(name.casefold())

    @cached_property
    def _spellings(self) -> Mapping[str, str]:
        return {name.casefold(): name for name in self.ids}

    def id_for_key(self, key: str) -> str | None:
        """The id of the student whose files have this key in a download; None if there is no such student."""
        return self._ids_by_key.get(key.strip().casefold())

    @cached_property
    def _ids_by_key(self) -> Mapping[str, str]:
        """The ids by their keys; in Gradescope, where a student may have no SID, also by their email addresses."""
        titles = [column.strip().casefold() for column in self.columns]
        emails = titles.index("email") if self.kind == "gradescope" and "email" in titles else self.key_column
        by_email = {row[emails].strip().casefold(): self.id_of(row) for row in self.rows if row[emails].strip()}
        return by_email | {_key(self.kind, row[self.key_column]).casefold(): self.id_of(row) for row in self.rows}


def read_roster(path: Path, id_column: str | None = None) -> Roster:
    """Read a roster.

    id_column  the header of the column with the ids; by default the first of the platform's id columns that is filled in most rows

    Raises ValueError for a table of an unknown kind, without such a column, or with the same id or key twice.
    """
    columns, rows, delimiter = read_table(path)
    titles = [column.strip().casefold() for column in columns]
    kind = _kind(titles, rows)
    if kind is None:
        raise ValueError(
            f"{path} must be an export of Canvas, Moodle or Gradescope, or a table with a column id; it has the columns "
            f"{', '.join(columns)[:300] or 'none'}."
        )
    grade = _grade_column(rows) if kind == "moodle" else None
    if kind == "moodle" and grade is None:
        raise ValueError(
            f"{path} must have a column with the maximum grade, which is the same number in each row. In Moodle, grade the "
            "assignment with points, not a scale."
        )
    key = _key_column(kind, titles, rows)
    people = [row for row in rows if row[key].strip()]  # Canvas begins with rows that belong to no student
    if id_column:
        candidates = [place for place, title in enumerate(titles) if title == id_column.strip().casefold()]
    else:
        candidates = _id_columns(kind, titles, people, key, grade)
    filled = [place for place in candidates if 2 * sum(bool(row[place].strip()) for row in people) > len(people)]
    if not filled:
        wanted = id_column or " or ".join(columns[place] for place in candidates) or "id"
        raise ValueError(
            f"{path} must have the students' ids in the column {wanted}, which is missing or mostly empty. "
            "Name the column with --id-column."
        )
    tests = [
        row[key].strip() for row in people if kind == "canvas" and any(map(TEST_STUDENT.fullmatch, row[: key + 4]))
    ]
    roster = Roster(kind, columns, people, filled[0], key, grade, tests, delimiter)
    _refuse_repeated(path, columns[filled[0]], [name.casefold() for name in roster.ids])
    if kind != "own":
        _refuse_repeated(path, columns[key], [_key(kind, row[key]).casefold() for row in people])
    return roster


def _refuse_repeated(path: Path, column: str, names: Sequence[str]) -> None:
    if repeated := [name for name, count in Counter(names).items() if count > 1]:
        raise ValueError(
            f"{path}: each id must occur once, whatever its capitals; the column {column!r} repeats {', '.join(repeated[:5])}. "
            "Correct the list, or export it again."
        )


def _kind(titles: Sequence[str], rows: Sequence[Row]) -> str | None:
    """The platform that wrote the table, from its cells; the headers of Canvas and Gradescope are always in English."""
    if {"identifier", "full name", "grade"} <= set(titles):
        return "moodle"
    words = {match["word"].strip() if (match := PARTICIPANT.fullmatch(row[0].strip())) else "" for row in rows}
    # In a list of your own, s1815 is an id. Moodle's word is longer, and its table has a maximum grade; if not, it is said later.
    if len(words) == 1 and len(min(words)) > (3 if min(words).isascii() else 0):
        has_grades = _grade_column(rows) is not None or "id" not in titles
        if "identifier" in titles or (len(titles) >= 5 and has_grades):
            return "moodle"
    has_points_row = any(len(row) > 3 and row[0].startswith("    ") and not row[1].strip() for row in rows)
    if ({"id", "section"} <= set(titles) and {"student", "lastname"} & set(titles)) or has_points_row:
        return "canvas"
    if {"sid", "email"} <= set(titles):
        return "gradescope"
    return "own" if "id" in titles else None


def _key_column(kind: str, titles: Sequence[str], rows: Sequence[Row]) -> int:
    """Moodle's is the first. Canvas's is the first with numbers only; a student's name is in one or two columns before it."""
    if kind == "moodle":
        return 0
    if kind == "canvas":
        cells = ([row[place].strip() for row in rows if row[place].strip()] for place in range(1, min(3, len(titles))))
        numeric = [place for place, column in enumerate(cells, start=1) if column and all(map(str.isdigit, column))]
        return numeric[0] if numeric else titles.index("id") if "id" in titles else 1
    return titles.index("sid" if kind == "gradescope" else "id")


def _id_columns(kind: str, titles: Sequence[str], people: Sequence[Row], key: int, grade: int | None) -> list[int]:
    """The columns that may contain the course id, the best first."""
    if kind == "gradescope":
        return [titles.index("sid"), titles.index("email")]
    if kind == "canvas":
        if "sis login id" in titles:
            return [titles.index(name) for name in ("sis login id", "sis user id", "id") if name in titles]
        # Translated: Student, ID, [SIS User ID,] SIS Login ID, Section, ...; the cells of the last one repeat.
        words = [place for place in range(key + 1, min(key + 3, len(titles))) if _is_id_column(people, place)]
        return [*reversed(words), key]
    if kind == "own":
        return [key]
    if named := [titles.index(name) for name in MOODLE_IDS if name in titles]:
        return named
    ids = [place for place in range(2, grade or 2) if _is_id_column(people, place)]
    emails = [place for place in range(1, grade or 1) if people and all("@" in row[place] for row in people)]
    plain = [place for place in ids if place not in emails]
    return [*plain[:1], *emails, *plain[1:]]


def _is_id_column(people: Sequence[Row], place: int) -> bool:
    """Whether the cells are ids: most are filled, all are different, and none has a space."""
    cells = [row[place].strip() for row in people if row[place].strip()]
    is_filled = 2 * len(cells) > len(people) and len({*cells}) == len(cells)
    return is_filled and not any(re.search(r"\s", cell) for cell in cells)


def _grade_column(rows: Sequence[Row]) -> int | None:
    """Moodle's grade: the column, empty or with numbers, before the one in which each row has the same positive number."""
    for place in range(2, len(rows[0]) if rows else 0):
        maxima = {_number(row[place]) for row in rows}
        grades = [row[place - 1].strip() for row in rows]
        if len(maxima) == 1 and (maxima.pop() or 0) > 0 and all(_number(cell) is not None for cell in grades if cell):
            return place - 1
    return None


def _number(cell: str) -> float | None:
    """A number, with a decimal point or comma; None for any other text."""
    return float(cell.replace(",", ".")) if re.fullmatch(r"\s*\d+([.,]\d+)?\s*", cell) else None


def read_table(path: Path) -> tuple[list[str], list[Row], str]:
    """A table of a spreadsheet: its header, its rows, and what separates its cells.

    Raises ValueError for a file that is none.
    """
    try:
        text = path.read_text("utf-8-sig")
        delimiter = max(",;\t", key=text.partition("\n")[0].count)  # platforms use the one of the user's language
        header, *lines = [*csv.reader(io.StringIO(text), delimiter=delimiter)] or [[]]
        return header, [[*line, *[""] * len(header)][: len(header)] for line in lines if any(line)], delimiter
    except UnicodeDecodeError as error:
        raise ValueError(
            f'{path} must be a table in UTF-8; it is in another encoding. A spreadsheet saves it as "CSV UTF-8"; or take the '
            "file as the platform exported it."
        ) from error
    except (OSError, csv.Error) as error:
        raise ValueError(f"{path} must be a table, CSV in UTF-8: {error}.") from error


def _key(kind: str, cell: str) -> str:
    """The key in a cell: Moodle, and no other platform, writes a word in front of it."""
    match = PARTICIPANT.fullmatch(cell.strip()) if kind == "moodle" else None
    return match["key"] if match else cell.strip()


# --- the points, in the columns that the platform imports ---


def export(roster: Roster, points: Mapping[str, float], maximum: float, sheet: str, column: str | None = None) -> str:
    """The roster with the points of a sheet, as its platform imports it: Moodle's are scaled to the maximum that it names.

    points  by id
    column  the column of the sheet; by default the only column that contains the sheet's name, or else this name
    """
    matching = [name for name in roster.columns if sheet.casefold() in name.casefold() and " - " not in name]
    title = column or (matching[0] if len(matching) == 1 else sheet)
    cells = [format_points(points[id_]) if (id_ := roster.id_of(row)) in points else "" for row in roster.rows]
    rows: list[Row] = []
    if roster.kind == "moodle":
        place = roster.grade_column or 0
        for row in roster.rows:
            id_, full = roster.id_of(row), row[place + 1]
            text = format_points(points[id_] * float(full.replace(",", ".")) / maximum) if id_ in points else row[place]
            decimals = text.replace(".", ",") if "," in full else text
            rows.append([*row[:place], decimals, *row[place + 1 :]])
        return csv_text(roster.columns, rows, roster.delimiter)
    if roster.kind == "canvas":
        # Up to the section: the columns before the first assignment, where the row of the points possible has a number.
        titles = [name.strip().casefold() for name in roster.columns]
        section = titles.index("section") if "section" in titles else min(roster.id_column + 1, len(titles) - 1)
        out_of = ["    Points Possible", *[""] * section, format_points(maximum)]
        rows = [[*row[: section + 1], cell] for row, cell in zip(roster.rows, cells, strict=True)]
        return csv_text([*roster.columns[: section + 1], title], [out_of, *rows], roster.delimiter)
    rows = [[*row, cell, format_points(maximum)] for row, cell in zip(roster.rows, cells, strict=True)]
    return csv_text([*roster.columns, title, f"{title} - Max Points"], rows, roster.delimiter)
