"""Tables that a spreadsheet opens: CSV in which no cell is a formula, whoever wrote it."""

import csv
import io
import re
from collections.abc import Iterable, Sequence

STARTS = re.compile(r"[=+\-@\t\r\n＝＋－＠]")
"""A cell that begins so may be run as a formula by Excel, LibreOffice or Google's sheets."""

HARMLESS = re.compile(r"-|[+-]?\d+([.,]\d+)?")


def harmless(cell: str) -> str:
    """A cell with an apostrophe before what would be a formula. Numbers, and the dash of an empty cell, stay as they are.

    >>> harmless("=HYPERLINK(1)"), harmless("-2.5"), harmless("Ada")
    ("'=HYPERLINK(1)", '-2.5', 'Ada')
    """
    return f"'{cell}" if STARTS.match(cell) and not HARMLESS.fullmatch(cell) else cell


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([harmless(cell) for cell in row] for row in [header, *rows])
    return text.getvalue()
