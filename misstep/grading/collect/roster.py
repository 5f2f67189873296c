"""Rosters: the list of students of a course, as a learning platform exports it, or your own. It has the students' ids.

Canvas      Grades, Export:                    Student, ID, SIS User ID, SIS Login ID, Section, ...
Moodle      the assignment's grading worksheet: Identifier, Full name, Email address, ..., Grade, ...
Gradescope  the assignment, Download Grades:    First Name, Last Name, SID, Email, ...
your own    any table with a column id
"""

import csv
import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

Row = Mapping[str, str]


@dataclass(frozen=True)
class Kind:
    """A platform's table.

    signature   the columns by which it is recognised
    key         the column with the number that the names of downloaded files contain
    id_columns  the columns that may contain the course id, the best first
    """

    signature: Sequence[str]
    key: str
    id_columns: Sequence[str]


KINDS = {
    "canvas": Kind(("student", "id", "section"), "id", ("sis login id", "sis user id", "id")),
    "moodle": Kind(("identifier", "full name", "grade"), "identifier", ("id number", "username", "email address")),
    "gradescope": Kind(("sid", "email"), "sid", ("sid", "email")),
    "own": Kind(("id",), "id", ("id",)),
}


@dataclass(frozen=True)
class Roster:
    """The list of students of a course.

    kind       canvas, moodle, gradescope or own
    columns    the header, unchanged
    rows       a row for each student, by column
    id_column  the column with the ids that students type into their sheets
    """

    kind: str
    columns: Sequence[str]
    rows: Sequence[Row]
    id_column: str

    def column(self, name: str) -> str | None:
        """The column of this name, in capitals or not; None if there is none."""
        return next((column for column in self.columns if column.strip().casefold() == name), None)

    def id_of(self, row: Row) -> str:
        """The id of a student, as it is typed into sheets."""
        return row[self.id_column].strip()

    @property
    def ids(self) -> list[str]:
        """The ids of all students. Canvas has a test student, who has no id."""
        return [name for row in self.rows if (name := self.id_of(row))]

    def id_for_key(self, key: str) -> str | None:
        """The id of the student whose files have this key in a download; None if there is no such student."""
        column = self.column(KINDS[self.kind].key)
        return next((self.id_of(row) for row in self.rows if column and _key(row[column]) == key.strip()), None)


def read_roster(path: Path, id_column: str | None = None) -> Roster:
    """Read a roster.

    id_column  the column with the ids; by default the first of the platform's id columns that is filled in most rows

    Raises ValueError for a table of an unknown kind, without such a column, or with the same id twice.
    """
    columns, rows = _table(path)
    titles = [column.strip().casefold() for column in columns]
    kind = next((name for name, kind in KINDS.items() if set(kind.signature) <= set(titles)), None)
    if kind is None:
        raise ValueError(
            f"{path} has the columns {', '.join(columns)[:300] or 'none'}. A roster must be an export of Canvas, Moodle or "
            "Gradescope, or a table with a column id."
        )
    key = columns[titles.index(KINDS[kind].key)]
    people = [row for row in rows if row[key].strip()]  # Canvas begins with rows that belong to no student
    candidates = [id_column.strip().casefold()] if id_column else KINDS[kind].id_columns
    present = [columns[titles.index(name)] for name in candidates if name in titles]
    filled = [column for column in present if 2 * sum(bool(row[column].strip()) for row in people) > len(people)]
    if not filled:
        raise ValueError(
            f"{path} must have the students' ids in the column {' or '.join(candidates)}, which is missing or mostly empty. "
            "Name the column with --id-column."
        )
    roster = Roster(kind, columns, people, filled[0])
    ids = [name.casefold() for name in roster.ids]
    if repeated := sorted({name for name in ids if ids.count(name) > 1}):
        raise ValueError(
            f"Each id must occur once; in {path}, column {filled[0]!r} has the id {repeated[0]!r} {ids.count(repeated[0])} times."
        )
    return roster


def _table(path: Path) -> tuple[list[str], list[Row]]:
    try:
        text = path.read_text("utf-8-sig")
        head = text.partition("\n")[0]
        delimiter = max(",;\t", key=head.count)  # Moodle uses the delimiter of the user's language
        reader = csv.DictReader(io.StringIO(text), delimiter=delimiter, restval="")
        rows: list[Row] = [{name: value for name, value in row.items() if name is not None} for row in reader]
        return list(reader.fieldnames or []), rows
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ValueError(f"{path} cannot be read as a table (CSV in UTF-8): {error}.") from error


def _key(cell: str) -> str:
    """The key in a cell: Moodle writes "Participant 1815", in the language of the user who exported the table."""
    return re.sub(r"^\D+ (?=\d+$)", "", cell.strip())
