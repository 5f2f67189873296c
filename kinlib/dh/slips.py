"""The slips that people make in DH tables: one table of them, used in both directions.

Forwards, `slip.change` makes the slip in the rows of a right table. Backwards, `corrections` undoes every slip in every place where it
could have been made, for `kinlib.dh.explanation.search`. All changes take rows (..., m, 4), so that many tables are changed at once.
"""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations

import numpy as np

from kinlib.arrays.formatting import format_different, format_number
from kinlib.arrays.tolerances import ROUNDING_ERROR
from kinlib.arrays.validation import Array
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.table import Convention, DHTable
from kinlib.rigid.lie import wrap_angle

A, ALPHA, D, THETA = range(4)
LENGTHS, ANGLES = (A, D), (ALPHA, THETA)

OTHER_CONVENTION: dict[Convention, Convention] = {"standard": "modified", "modified": "standard"}

CHOICES = {"base": "wrong base", "tool": "wrong tool", "zeros": "another zero", "signs": "sign of a joint value"}
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint; and the name of each
as a fault, where it is fixed."""

WRONG_NUMBER = "wrong number"
"""The fault that is corrected by a number that the table does not suggest; so it could explain almost anything."""

Change = Callable[[Array], Array]


@dataclass(frozen=True)
class Slip:
    """A slip: what was done to the numbers, and how it is undone.

    name    the same in every sheet and every diagnosis
    text    what was done, in a sentence
    change  makes the slip in a whole table; or in one row, (..., 1, 4), or in two, (..., 2, 4)
    undo    corrects it; None if the same change does
    column  the column in which it was made, if there is one
    in_row  what was done, if it was done in one row, in a sentence; "" if it runs through a whole table
    """

    name: str
    text: str
    change: Change
    undo: Change | None = None
    column: int | None = None
    in_row: str = ""


def scale(columns: Sequence[int], factor: float) -> Change:
    """Return the change that multiplies some columns by a factor."""
    factors = np.ones(4)
    factors[[*columns]] = factor
    return lambda rows: rows * factors


def write(column: int, value: float) -> Change:
    """Return the change that writes a number in a column."""
    return lambda rows: np.where(np.arange(4) == column, value, rows)


def reorder(order: Sequence[int]) -> Change:
    """Return the change that writes the columns in another order."""
    return lambda rows: rows[..., [*order]]


def roll(columns: Sequence[int], by: int) -> Change:
    """Return the change that moves the numbers of some columns down by some rows; those of the last rows come first."""
    is_moved = np.isin(np.arange(4), columns)
    return lambda rows: np.where(is_moved, np.roll(rows, by, axis=-2), rows)


RULE = "it is the angle from one z to the next about the x between them, by the right-hand rule"
MEASURED = "a is measured along x, d along z"
ORDER = "The columns are in the order {typed}, but were read as a, alpha, d, theta."

DEGREES, RADIANS = 180 / np.pi, np.pi / 180
LENGTHS_SWAPPED, ANGLES_SWAPPED = (D, ALPHA, A, THETA), (A, THETA, D, ALPHA)

SLIPS_OF_A_TABLE = [
    Slip("degrees", "The angles are in degrees, but were read as radians.", scale(ANGLES, DEGREES), scale(ANGLES, RADIANS)),
    *(
        Slip(name, text, scale(LENGTHS, factor), scale(LENGTHS, 1 / factor))
        for name, factor, text in (
            ("millimetres", 1e3, "The lengths are in millimetres, but were read as metres."),
            ("centimetres", 1e2, "The lengths are in centimetres, but were read as metres."),
            ("millimetres", 1e-3, "The lengths are a thousandth of those of the arm. Is the arm in millimetres?"),
        )
    ),
    *(
        Slip(f"sign of {name}", f"Every {name} has the wrong sign{rule}.", scale([k], -1), column=k, in_row=f"{name} has the wrong sign.")
        for k, name, rule in ((ALPHA, "alpha", f": {RULE}"), (D, "d", ""), (A, "a", ""), (THETA, "theta", ""))
    ),
    Slip("a and d swapped", f"The columns a and d are swapped: {MEASURED}.", reorder(LENGTHS_SWAPPED), column=A,
         in_row=f"a and d are swapped. {MEASURED}."),
    Slip("angles swapped", "The columns theta and alpha are swapped.", reorder(ANGLES_SWAPPED), column=THETA,
         in_row="theta and alpha are swapped."),
    *(
        Slip("column shifted", f"The columns a and alpha are one row too {way}: a_{{i-1}} and a_i were confused.",
             roll([A, ALPHA], by), roll([A, ALPHA], -by))
        for by, way in ((1, "low"), (-1, "high"))
    ),
    Slip("rows shifted", "The rows are one row too low, and the last one is at the top.", roll(range(4), 1), roll(range(4), -1)),
    Slip("rows shifted", "The rows are one row too high, and the first one is at the bottom.", roll(range(4), -1), roll(range(4), 1)),
    *(
        Slip("columns in another order", ORDER.format(typed=", ".join(COLUMNS[k] for k in order)), reorder(order), reorder(back))
        for order in permutations(range(4))
        if order not in {(A, ALPHA, D, THETA), LENGTHS_SWAPPED, ANGLES_SWAPPED}
        for back in [np.argsort(order).tolist()]
    ),
]  # fmt: skip
"""The slips that run through a whole table; those that are also made in one row are in the order of how frequent they are there."""


@dataclass(frozen=True)
class Fault:
    """A fault of a table: its name, a sentence that describes it, and its row (from 1) and column, if it has any.

    name  of a slip; or "the other convention", "variable in the wrong column", WRONG_NUMBER, or that of a choice that is fixed
    """

    name: str
    text: str
    row: int | None = None
    column: str | None = None


def slips_in_places(m: int) -> Iterator[tuple[Slip, list[int]]]:
    """Yield every slip with the rows in which it can be made, [] for the whole table, whose slips come first."""
    yield from ((slip, []) for slip in SLIPS_OF_A_TABLE)
    yield from ((slip, [row]) for row in range(m) for slip in SLIPS_OF_A_TABLE if slip.in_row)
    for i, j in combinations(range(m), 2):
        yield Slip("rows swapped", f"Rows {i + 1} and {j + 1} are swapped.", roll(range(4), 1)), [i, j]


def changed_in(places: list[int], change: Change) -> Change:
    """Return the change of the whole rows that a change of some of them is; [] are all."""
    if not places:
        return change

    def in_places(rows: Array) -> Array:
        rows = rows.copy()
        rows[..., places, :] = change(rows[..., places, :])
        return rows

    return in_places


def corrections(
    table: DHTable, right: Array, fixed: Collection[str], half_unit: Array
) -> Iterator[tuple[Fault, Change]]:
    """Yield the faults that leave the joint types as they are, each with the change that corrects it, those of the whole table first.

    right      (k, 4) rows of right tables of the arm, whose numbers are tried in place of wrong ones, and so are usual angles
    fixed      with "zeros" the entries that the joints change count
    half_unit  (m, 4) a number that is off by less has not enough digits, and is no wrong one
    """
    variables = [] if "zeros" in fixed else joint_entries(table.joints)
    for slip, places in slips_in_places(len(table.rows)):
        if len(places) != 1 or (places[0], slip.column) not in variables:
            text = f"Row {places[0] + 1}: {slip.in_row}" if len(places) == 1 else slip.text
            column = None if slip.column is None else COLUMNS[slip.column]
            fault = Fault(slip.name, text, places[0] + 1 if places else None, column)
            yield fault, changed_in(places, slip.undo or slip.change)
    lengths = right[:, LENGTHS].ravel()
    for row, column in np.ndindex(table.rows.shape):
        if (row, column) in variables:
            continue
        values, least = np.concatenate([[0.0], lengths, -lengths]), max(ROUNDING_ERROR, 1.05 * half_unit[row, column])
        if column in ANGLES:
            # If an axis is drawn in the opposite direction, an angle becomes its supplement.
            angles = np.concatenate([right[:, column], wrap_angle(np.pi - right[:, column])])
            values = np.concatenate([[0.0, np.pi / 2, -np.pi / 2, np.pi], angles, -angles])
        for value in {round(value, 12) + 0.0: value for value in values.tolist()}.values():
            if abs(abs(value) - abs(table.rows[row, column])) > least:  # another sign is a slip of its own
                yield wrong_number(table, row, column, value), changed_in([row], write(column, value))


def starting_tables(table: DHTable, joint_types: str) -> Iterator[tuple[list[Fault], DHTable]]:
    """Yield a table in both conventions and with the joint types of an arm, and the faults that were corrected."""
    other, faults, right = OTHER_CONVENTION[table.convention], list[Fault](), [*table.joints]
    for (row, _), letter in zip(joint_entries(table.joints), joint_types, strict=True):
        if letter != table.joints[row]:
            right[row], kind, column = ("P", "prismatic", "d") if letter == "P" else ("R", "revolute", "theta")
            text = f"Row {row + 1}: the joint variable belongs in {column}, because this joint is {kind}."
            faults.append(Fault("variable in the wrong column", text, row + 1, column))
    start = table.changed(joints="".join(right))
    text = f"The table is in the {other} convention, but was read as {table.convention}."
    yield faults, start
    yield [*faults, Fault("the other convention", text)], start.changed(convention=other)


def wrong_number(table: DHTable, row: int, column: int, value: float) -> Fault:
    """Describe a number of a table that should have another value, with as many digits as it takes to tell them apart."""
    factor, unit = (180 / np.pi, "°") if column in ANGLES else (1.0, "")
    typed, name = float(table.rows[row, column]), COLUMNS[column]
    numbers = round(factor * value, 9), round(factor * typed, 9)
    texts = [format_number(number, 6) for number in numbers]
    should, has = (f"{text}{unit}" for text in (texts if texts[0] != texts[1] else format_different(*numbers)))
    return Fault(WRONG_NUMBER, f"Row {row + 1}: {name} should be {should}; the table has {has}.", row + 1, name)
