"""Rosters: the list of a course, as a learning platform exports it, or of one's own. It tells whose id is whose.

Canvas      Grades, Export:                    Student, ID, SIS User ID, SIS Login ID, Section, ...
Moodle      the assignment's grading worksheet: Identifier, Full name, Email address, ..., Grade, ...
Gradescope  the assignment, Download Grades:    First Name, Last Name, SID, Email, ...
one's own   any table with a column id
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
    """A platform's table: the columns by which it is known, the one its downloads name, those that may hold the id."""

    known_by: Sequence[str]
    key: str
    ids: Sequence[str]


KINDS = {
    "canvas": Kind(("student", "id", "section"), "id", ("sis login id", "sis user id", "id")),
    "moodle": Kind(("identifier", "full name", "grade"), "identifier", ("id number", "username", "email address")),
    "gradescope": Kind(("sid", "email"), "sid", ("sid", "email")),
    "own": Kind(("id",), "id", ("id",)),
}


@dataclass(frozen=True)
class Roster:
    """A list of the course.

    kind       canvas, moodle, gradescope or own
    columns    the header, as it stood
    rows       a row for each person, by column
    id_column  the column with the ids that students type into their sheets
    """

    kind: str
    columns: Sequence[str]
    rows: Sequence[Row]
    id_column: str

    def column(self, name: str) -> str | None:
        """A column, however its letters are set; None if there is none."""
        return next((column for column in self.columns if column.strip().casefold() == name), None)

    def id_of(self, row: Row) -> str:
        """The id of somebody, as typed into sheets."""
        return row[self.id_column].strip()

    @property
    def ids(self) -> list[str]:
        """Everybody's id. Canvas has a test student, who has none."""
        return [name for row in self.rows if (name := self.id_of(row))]

    def found(self, key: str) -> str | None:
        """The id of whom a download calls by this key; None if nobody is."""
        column = self.column(KINDS[self.kind].key)
        return next((self.id_of(row) for row in self.rows if column and _key(row[column]) == key.strip()), None)


def read_roster(path: Path, id_column: str | None = None) -> Roster:
    """Read a roster. The ids are in the column named, or in the first of its kind that most rows fill.

    Raises ValueError for a table of no known kind, without such a column, or with one id twice.
    """
    columns, rows = _table(path)
    titles = [column.strip().casefold() for column in columns]
    kind = next((name for name, kind in KINDS.items() if set(kind.known_by) <= set(titles)), None)
    if kind is None:
        raise ValueError(
            f"{path} has the columns {', '.join(columns)[:300] or 'none'}. A roster is what Canvas, Moodle or Gradescope exports, "
            "or a table with a column id."
        )
    key = columns[titles.index(KINDS[kind].key)]
    people = [row for row in rows if row[key].strip()]  # Canvas begins with rows that are nobody's
    wanted = [id_column.strip().casefold()] if id_column else KINDS[kind].ids
    there = [columns[titles.index(name)] for name in wanted if name in titles]
    filled = [column for column in there if 2 * sum(bool(row[column].strip()) for row in people) > len(people)]
    if not filled:
        raise ValueError(
            f"In {path}, no id stands in {' or '.join(wanted)}. Say with --id-column where the ids are that students type."
        )
    best = filled[0]
    roster = Roster(kind, columns, people, best)
    ids = [name.casefold() for name in roster.ids]
    if twice := sorted({name for name in ids if ids.count(name) > 1}):
        raise ValueError(f"In {path}, the id {twice[0]!r} is there {ids.count(twice[0])} times in {best!r}.")
    return roster


def _table(path: Path) -> tuple[list[str], list[Row]]:
    try:
        text = path.read_text("utf-8-sig")
        head = text.partition("\n")[0]
        delimiter = max(",;\t", key=head.count)  # Moodle writes the one that the reader's language prefers
        reader = csv.DictReader(io.StringIO(text), delimiter=delimiter, restval="")
        rows: list[Row] = [{name: value for name, value in row.items() if name is not None} for row in reader]
        return list(reader.fieldnames or []), rows
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ValueError(f"{path} cannot be read as a table (CSV in UTF-8): {error}.") from error


def _key(cell: str) -> str:
    """The key in a cell: Moodle writes "Participant 1815", in the language of whoever exported."""
    return re.sub(r"^\D+ (?=\d+$)", "", cell.strip())
