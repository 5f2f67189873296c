"""Write the parts of DH tables as text: headings, variables, and tables in Markdown.

`headings.json` holds the headings of every table that shows its convention; one to be filled in has the names of `COLUMNS`.
"""

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from kinlib.dh.parsing import COLUMNS

PRINTED_DIGITS = 12
"""A printed table is read back with this many digits."""


@cache
def headings(convention: str) -> tuple[str, ...]:
    """Return the headings of a table, which show its convention: row i of a modified table has a and alpha of the link before.

    The page of the 3-D viewer reads them from the same file.
    """
    import json  # for tables that are printed; `import kinlib` loads no more than NumPy

    by_convention = json.loads(Path(__file__).with_name("headings.json").read_text("utf-8"))
    return tuple(by_convention[convention])


def add_variable(variable: str, constant: str) -> str:
    """Write the sum of a joint variable and a constant, which is left out if it is 0."""
    if constant in {"0", "0°"}:
        return variable
    return f"{variable} - {constant[1:]}" if constant.startswith("-") else f"{variable} + {constant}"


def in_latex(heading: str) -> str:
    r"""Write a heading in LaTeX."""
    return heading.replace("alpha", r"\alpha").replace("theta", r"\theta")


def markdown_table(rows: Sequence[Sequence[str]], heads: Sequence[str] = ("i", *COLUMNS)) -> str:
    """Write rows of entries as a table in Markdown, with the rows numbered from 1.

    heads  the headings of all columns, including the column of row numbers
    """
    lines = [" | ".join(cells) for cells in (heads, ["---"] * len(heads))]
    lines += [" | ".join([str(i), *row]) for i, row in enumerate(rows, start=1)]
    return "\n".join(f"| {line} |" for line in lines)
