"""Write the parts of DH tables as text: headings and variables.

`headings.json` holds the headings of every table that shows its convention; one to be filled in has the names of `COLUMNS`.
"""

from functools import cache
from pathlib import Path

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
