"""Mistakes in DH tables: the slips of `kinlib.dh.slips`, made in a right table, with the words of cards."""

import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cache

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS
from kinlib.dh.slips import OTHER_CONVENTION, SLIPS_OF_A_TABLE, SLIPS_THAT_LOSE_NUMBERS
from kinlib.dh.table import Convention, DHTable
from misstep.mistakes import Mistake
from misstep.mutants.expression import Slip

WRONG_METHODS = {"a and d swapped", "angles swapped", "column after column"}
"""The slips by which a row that comes out right does so by chance."""

_COLUMN = re.compile(
    r"\b(alpha|theta|Alpha|Theta|d)\b|\ba\b(?= (?:is measured|was measured|has|and (?:d|alpha)))|(?<=along |about )[xz]\b"
)
"""The name of a column or an axis in a sentence, and not the article."""


def symbol(name: str) -> str:
    """Return the name of an entry as mathematics."""
    return f"$\\{name.lower()}$" if name.lower().startswith(ANGLE_COLUMNS) else f"${name}$"


def with_symbols(text: str) -> str:
    """Return a sentence of `kinlib.dh` with the names of columns and axes as mathematics."""
    return _COLUMN.sub(lambda found: symbol(found[0]), text)


@cache
def slips_of_rows() -> Sequence[Slip]:
    """The slips that people make in the rows of any table, one of each name and column."""
    usual = [slip for slip in SLIPS_OF_A_TABLE if slip.column is not None and "shifted" not in slip.name]
    return [
        Slip(slip.name, with_symbols(slip.text), slip.change, in_parts=False, spoils=slip.name in WRONG_METHODS)
        for slip in (*usual, *SLIPS_THAT_LOSE_NUMBERS)
    ]


def slips_of_table(right: DHTable) -> list[Slip]:
    """The slips in a whole table that cannot be undone, and the signs of joint values, each with the table that it leads to."""
    rows, n = right.rows, right.n
    changes = [(slip.name, with_symbols(slip.text), slip.change(rows), right.signs) for slip in SLIPS_THAT_LOSE_NUMBERS]
    moved = "moves in the opposite direction, as with"
    changes.append(("sign of a joint value", f"Every joint {moved} $-q_i$ for $q_i$.", rows, -right.signs))
    for i in range(1, n + 1):
        signs = np.where(np.arange(n) == i - 1, -1, 1) * right.signs
        changes.append(("sign of a joint value", f"Joint {i} {moved} $-q_{i}$ for $q_{i}$.", rows, signs))
    if rows[:, 3].any():
        turned = "Every $\\theta_i$ is negated, with its $q_i$."
        changes.append(("sign of theta", turned, rows * (1, 1, 1, -1), -right.signs))
    found = []
    for name, text, changed, signs in changes:
        # A single entry is explained by its place.
        if np.count_nonzero(changed - rows) < 2 and (signs == right.signs).all():
            continue
        with suppress(ValueError):  # no table has an angle of many turns
            table = right.changed(rows=changed, signs=signs)
            both = [np.column_stack([one.rows, one.signs]) for one in (table, right)]
            runs_through = is_in_several_rows(*both)
            found.append(Slip(name, text, lambda _, table=table: table, in_parts=False, spoils=runs_through))
    return found


def is_in_several_rows(wrong: Array, right: Array) -> bool:
    """Whether a mistake runs through a table, so that a row that it leaves as it is earns nothing."""
    return bool(np.count_nonzero((wrong != right).any(axis=1)) > 1)


def rows_of_the_other_convention(table: DHTable) -> Mistake:
    """The rows of the frames that obey the rule of the other convention, as a mistake: z_i on the wrong joint."""
    wrong = table.changed(rows=table.converted(OTHER_CONVENTION[table.convention]).rows)
    text = (
        "You put $z_i$ on the wrong joint. In the standard convention $z_i$ lies on the axis of joint $i + 1$, in the "
        "modified one on that of joint $i$. Your rows are those of the other convention."
    )
    return Mistake("z on the wrong joint", wrong, text, spoils=is_in_several_rows(wrong.rows, table.rows))


def entry_names(n: int) -> dict[str, str]:
    """The entries of a table with n rows, as a student types them, in words."""
    return {f"{column}{row}": f"{column} in row {row}" for row in range(1, n + 1) for column in COLUMNS}


def other_entries(faulty: str, n: int, convention: Convention) -> list[Mistake]:
    """The choices of an entry that agrees with the drawn frames, where one entry of a table with n rows is faulty.

    Each is told what this entry is, and nothing of the faulty one: a row or a column that is right would be half the answer.
    """
    return [_other_entry(chosen, name, convention) for chosen, name in entry_names(n).items() if chosen != faulty]


def _other_entry(chosen: str, name: str, convention: Convention) -> Mistake:
    column, row = chosen[:-1], int(chosen[-1])
    name = symbol(f"{column}_{row}") if convention == "standard" else name
    x, z = (row, row - 1) if convention == "standard" else (row - 1, row)
    measured, about = ("z", f"$x_{x}$") if column in ("a", "alpha") else ("x", f"$z_{z}$")
    what = f"angle from ${measured}_{row - 1}$ to ${measured}_{row}$ about {about}"
    if column in ("a", "d"):
        what = f"distance from ${measured}_{row - 1}$ to ${measured}_{row}$ along {about}"
    text = f"This entry agrees with the frames: {name} is the {what}. Compare the others with them."
    return Mistake("another entry", chosen, text)
