"""Text of students on its way out: to a terminal or into a table. Pages are escaped by Jinja, which calls `printable` too."""

import csv
import io
import re
from collections.abc import Iterable, Sequence

FORMULA_START = re.compile(r"\s*[=+\-@＝＋－＠]")
"""Excel, LibreOffice and Google Sheets may execute a cell that begins like this as a formula."""

NUMBER_OR_DASH = re.compile(r"-|[+-]?\d+([.,]\d+)?")

MAX_CELL = 2000
"""The most characters of a cell of a table; a spreadsheet refuses larger ones."""


def printable(text: str) -> str:
    r"""Return a text without control characters, which may move a cursor, or make text run from right to left.

    >>> printable("a\x1b[5mb\u202ec\ud800")
    'a\\x1b[5mb\\u202ec\\ud800'
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii") for letter in text
    )


def csv_text(header: Sequence[str], rows: Iterable[Sequence[str]], delimiter: str = ",") -> str:
    r"""Return a table as CSV, in which no cell is executed as a formula. Numbers, and the dash of an empty cell, stay.

    >>> csv_text(["id", "points"], [["=HYPERLINK(1)", "-2.5"], ["\x1b]", "-"]])
    "id,points\n'=HYPERLINK(1),-2.5\n\\x1b],-\n"
    """

    def cell(text: str) -> str:
        safe = " ".join(map(printable, text[:MAX_CELL].split("\n")))
        return f"'{safe}" if FORMULA_START.match(safe) and not NUMBER_OR_DASH.fullmatch(safe) else safe

    lines = io.StringIO()
    writer = csv.writer(lines, delimiter=delimiter, lineterminator="\n")
    writer.writerows(map(cell, row) for row in [header, *rows])
    return lines.getvalue()


def format_points(value: float) -> str:
    """Return points with at most two decimals.

    >>> format_points(2.0), format_points(2 / 3)
    ('2', '0.67')
    """
    return f"{value:.2f}".rstrip("0").rstrip(".")
