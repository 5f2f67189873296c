"""Mistakes in DH tables: the slips of `kinlib.dh.slips`, made in a right table, with the words of cards."""

import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cache

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS
from kinlib.dh.slips import ALPHA, OTHER_CONVENTION, SLIPS_OF_A_TABLE, THETA, A, D, reorder, scale
from kinlib.dh.slips import Slip as DHSlip
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


def off_the_normal(rows: Array) -> Array:
    """Measure a from origin to origin, with no d, so that x is along the link and not along the common normal."""
    a, alpha, d, theta = rows.T
    return np.where(rows[:, [A]] != 0, np.column_stack([np.hypot(a, d), alpha, 0 * d, theta]), rows)


SLIPS_THAT_LOSE_NUMBERS = [
    DHSlip("alpha left out", "Every alpha is 0; it is the angle about x from one z axis to the next.", scale([ALPHA], 0), column=ALPHA),
    DHSlip("d left out", "Every d is 0; it is the distance along z from one x axis to the next.", scale([D], 0), column=D),
    DHSlip("no offset", "Every theta is 0 at q = 0; it is the angle about z from one x axis to the next.", scale([THETA], 0), column=THETA),
    DHSlip("signs left out", "No minus sign is left.", np.abs),
    DHSlip("off the normal", "a was measured from joint to joint, and not along the common normal.", off_the_normal),
    DHSlip("both pairs swapped", "a and d are swapped, and so are alpha and theta.", reorder((D, THETA, A, ALPHA))),
    DHSlip("all signs", "Every entry has the wrong sign.", scale(range(4), -1)),
    DHSlip("rows reversed", "The rows are in the order from the tool to the base.", lambda rows: rows[::-1]),
    DHSlip("column after column", "The numbers were listed column after column.", lambda rows: rows.T.reshape(rows.shape)),
]  # fmt: skip
"""The slips in a whole table that cannot be undone, because numbers or their order are lost; they are made forwards only."""


@cache
def slips_of_rows() -> Sequence[Slip]:
    """The slips that people make in the rows of any table, one of each name and column."""
    usual = [slip for slip in SLIPS_OF_A_TABLE if slip.column is not None]
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
