"""CSV tables for spreadsheets, in which no cell is executed as a formula, also if a student typed it."""

import csv
import io
import re
from collections.abc import Iterable, Sequence

FORMULA_START = re.compile(r"[=+\-@\t\r\n＝＋－＠]")
"""Excel, LibreOffice and Google Sheets may execute a cell that begins like this as a formula."""

NUMBER_OR_DASH = re.compile(r"-|[+-]?\d+([.,]\d+)?")


def escape_formula(cell: str) -> str:
    """The cell, with an apostrophe in front if it could be a formula. Numbers and the dash of an empty cell stay.

    >>> escape_formula("=HYPERLINK(1)"), escape_formula("-2.5"), escape_formula("Ada")
    ("'=HYPERLINK(1)", '-2.5', 'Ada')
    """
    return f"'{cell}" if FORMULA_START.match(cell) and not NUMBER_OR_DASH.fullmatch(cell) else cell


def format_csv(header: Sequence[str], rows: Iterable[Sequence[str]], delimiter: str = ",") -> str:
    """A table as CSV text."""
    text = io.StringIO()
    writer = csv.writer(text, delimiter=delimiter, lineterminator="\n")
    writer.writerows([escape_formula(cell) for cell in row] for row in [header, *rows])
    return text.getvalue()
