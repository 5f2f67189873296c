"""The mistakes in DH tables that `diagnose` knows: each one with its name, a sentence, and the entries that correct it.

A correction is written for the table as it is, with its own row numbers, so that two of them can be combined.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import combinations, permutations

import numpy as np

from kinlib.arrays.tolerances import EQUIVALENCE_TOL, ROUNDING_ERROR
from kinlib.arrays.validation import Array
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.table import Convention, DHTable
from kinlib.rigid.angles import wrap_angle

A, ALPHA, D, THETA = range(4)
LENGTHS, ANGLES = (A, D), (ALPHA, THETA)

OTHER_CONVENTION: dict[Convention, Convention] = {"standard": "modified", "modified": "standard"}

NUMBERS = {"wrong number", "offset forgotten", "entries lost"}
"""The faults that are corrected by a number that the table does not suggest; so they could explain almost anything."""

MEANINGS = {A: "a is measured along x", ALPHA: "alpha about x", D: "d along z", THETA: "theta about z"}

UNITS = {
    1e-3: "The lengths are in millimetres, but were read as metres.",
    1e-2: "The lengths are in centimetres, but were read as metres.",
    1e3: "The lengths are a thousandth of those of the arm. Is the arm in millimetres?",
}

MIN_LENGTH_MM = 5
"""The smallest length that is taken as one in millimetres: within the tolerance of a typed table, 0.002 m is 0."""


@dataclass(frozen=True)
class Fault:
    """A mistake in a table: its name, a sentence that describes it, and its row (from 1) and column, if it has any.

    name  "sign of a", "sign of alpha", "sign of d", "sign of theta", "antiparallel", "a and d swapped",
          "theta and alpha swapped", "columns in another order", "rows swapped", "rows shifted", "column shifted",
          "entry one row off", "variable in the wrong column", "other convention", "degrees", "unit of length", "sign of q",
          "wrong base", "wrong tool", "entries lost", "offset forgotten" or "wrong number"
    """

    name: str
    text: str
    row: int | None = None
    column: str | None = None


@dataclass(frozen=True, eq=False)
class Correction:
    """A fault and its correction: new entries by (row, column), then factors (m, 4), another convention, letters or signs of joints."""

    fault: Fault
    entries: Mapping[tuple[int, int], float] = field(default_factory=dict)
    factors: Array | None = None
    convention: Convention | None = None
    letters: Mapping[int, str] = field(default_factory=dict)
    turned: frozenset[int] = frozenset()
    """The rows whose joint counts in the opposite direction."""


def corrected_rows(rows: Array, corrections: Sequence[Correction]) -> Array:
    """Apply corrections to the numbers of a table, (m, 4) -> (m, 4)."""
    rows = np.array(rows)
    for correction in corrections:
        for entry, value in correction.entries.items():
            rows[entry] = value
    for correction in corrections:
        if correction.factors is not None:
            rows *= correction.factors
    return rows


def format_entry(value: float, column: int) -> str:
    """Format an entry for a sentence: an angle in degrees, a length as the number that it is."""
    if column in ANGLES:
        return f"{round(float(np.degrees(value)), 6) + 0.0:.4g} degrees"
    return f"{round(float(value), 9) + 0.0:.4g}"


def known_corrections(
    table: DHTable, right: Sequence[Array], more_d: Mapping[int, Sequence[float]], fixed: Collection[str] = ()
) -> list[Correction]:
    """Return the corrections of all known mistakes that leave the joint types as they are, the most usual ones first.

    right   the rows (k, 4) of right tables of the arm, whose numbers are tried in place of wrong and of lost ones
    more_d  further values of d to try, by row
    fixed   what counts, of "zeros", the entries that the joints change, and "signs", the directions in which they count
    """
    zeros_are_fixed, numbers = "zeros" in fixed, np.concatenate(right)
    same_size = [rows for rows in right if rows.shape == table.rows.shape]
    return [
        *_corrections_of_a_row(table, zeros_are_fixed),
        *(correction for correction in _corrections_of_a_pair_of_rows(table) if not correction.letters),
        *_corrections_of_the_table(table),
        *_corrections_of_the_column_order(table),
        *(
            correction
            for rows in same_size
            for correction in _corrections_of_lost_entries(table, rows, zeros_are_fixed)
        ),
        *(_corrections_of_signs(table) if "signs" in fixed else ()),
        *_corrections_of_a_number(table, numbers, more_d, zeros_are_fixed),
    ]


def corrections_of_joint_types(table: DHTable, joint_types: str) -> list[tuple[Correction, ...]]:
    """Return the ways to give a table the joint types of an arm: variables in the other column, or two rows swapped."""
    right = list(table.joints)
    columns = []
    for (row, _), letter in zip(joint_entries(table.joints), joint_types, strict=True):
        right[row] = letter
        if letter != table.joints[row]:
            kind, column = ("prismatic", D) if letter == "P" else ("revolute", THETA)
            text = f"the joint variable belongs in {COLUMNS[column]}, because this joint is {kind}."
            columns.append(
                replace(
                    _correction_of_a_row(row, "variable in the wrong column", text, column, {}), letters={row: letter}
                )
            )
    swapped = [
        correction
        for correction in _corrections_of_a_pair_of_rows(table)
        if [correction.letters.get(row, letter) for row, letter in enumerate(table.joints)] == right
    ]
    return [tuple(columns), *((correction,) for correction in swapped if columns)]


def _corrections_of_the_table(table: DHTable) -> Iterator[Correction]:
    """Yield the corrections of mistakes that affect the whole table."""
    other = OTHER_CONVENTION[table.convention]
    text = f"The table is in the {other} convention, but was read as {table.convention}."
    yield Correction(Fault("other convention", text), convention=other)
    rows = table.rows
    for shift, where in ((1, "one row too high"), (-1, "one row too low")):
        rolled = np.roll(rows, shift, axis=0)
        text = f"The columns a and alpha are {where}: a_{{i-1}} and a_i were confused."
        yield _replaced(Fault("column shifted", text), rows, rolled, (A, ALPHA))
        for column, name in enumerate(COLUMNS):
            fault = Fault("column shifted", f"The column {name} is {where}.", None, name)
            yield _replaced(fault, rows, rolled, (column,))
        yield _replaced(Fault("rows shifted", f"The rows are {where}."), rows, rolled)
    text = "The angles are in degrees, but were read as radians."
    yield _scaled(Fault("degrees", text), rows, ANGLES, np.radians(1))
    for factor, text in UNITS.items():
        yield _scaled(Fault("unit of length", text), rows, LENGTHS, factor)
    for column in (ALPHA, D, A, THETA):
        if rows[:, column].any():
            name = COLUMNS[column]
            rule = (
                ": it is the angle from z_{i-1} to z_i about x_i, by the right-hand rule." if column == ALPHA else "."
            )
            fault = Fault(f"sign of {name}", f"Every {name} has the wrong sign{rule}", None, name)
            yield _scaled(fault, rows, (column,), -1)
    for one, two in ((A, D), (THETA, ALPHA)):
        swapped = rows.copy()
        swapped[:, [one, two]] = rows[:, [two, one]]
        names = f"{COLUMNS[one]} and {COLUMNS[two]}"
        text = f"The columns {names} are swapped: {MEANINGS[one]}, {MEANINGS[two]}."
        yield _replaced(Fault(f"{names} swapped", text, None, COLUMNS[one]), rows, swapped)


def _corrections_of_the_column_order(table: DHTable) -> Iterator[Correction]:
    """Yield the corrections of columns that were typed in another order; a and d, theta and alpha are mistakes of their own."""
    for order in permutations(range(4)):
        if order not in {(A, ALPHA, D, THETA), (D, ALPHA, A, THETA), (A, THETA, D, ALPHA)}:
            typed = ", ".join(COLUMNS[column] for column in order)
            text = f"The columns are in the order {typed}, but were read as {', '.join(COLUMNS)}."
            right = table.rows[:, np.argsort(order)]
            yield _replaced(Fault("columns in another order", text), table.rows, right)


def _corrections_of_lost_entries(table: DHTable, right: Array, zeros_are_fixed: bool) -> Iterator[Correction]:
    """Yield the corrections of numbers that moved one row, with 0 where they were; right has those that were lost by that."""
    rows, m = table.rows, len(table.rows)
    columns = [(A, ALPHA), *((k,) for k in range(4)), tuple(range(4))]
    variables = joint_entries(table.joints)
    for shift, where, first, last in ((1, "one row too low", 0, m - 1), (-1, "one row too high", m - 1, 0)):
        for moved in columns:
            if rows[first, moved].any() or not right[last, moved].any():
                continue  # nothing was filled in, or nothing was lost
            restored = np.roll(rows, -shift, axis=0)
            restored[last, moved] = right[last, moved]
            names = " and ".join(COLUMNS[k] for k in moved) if len(moved) < 4 else "all columns"
            text = f"The entries of {names} are {where}, so that those of row {last + 1} are lost."
            yield _replaced(Fault("entries lost", text), rows, restored, moved)
        for row, column in np.ndindex(m, 4):
            other = row + shift
            is_free = (row, column) in variables and not zeros_are_fixed
            if (
                not 0 <= other < m
                or is_free
                or rows[row, column]
                or not rows[other, column]
                or not right[other, column]
            ):
                continue
            name = COLUMNS[column]
            text = f"Row {other + 1}: the entry of {name} belongs in row {row + 1}; its own is lost."
            entries = {(row, column): float(rows[other, column]), (other, column): float(right[other, column])}
            yield Correction(Fault("entries lost", text, other + 1, name), entries)
    if zeros_are_fixed and not rows[:, THETA].any() and np.count_nonzero(right[:, THETA]) > 1:
        fault = Fault("offset forgotten", "The offsets of theta are missing.", None, "theta")
        yield _replaced(fault, rows, right, (THETA,))


def _corrections_of_signs(table: DHTable) -> Iterator[Correction]:
    """Yield the corrections of joints that count in the opposite direction: one of them, or all that rotate."""
    turning = frozenset(row for row, letter in enumerate(table.joints) if letter == "R")
    for row, letter in enumerate(table.joints):
        if letter != "F":
            name, sign = COLUMNS[THETA if letter == "R" else D], "-" if table.signs[row] > 0 else "+"
            text = f"Row {row + 1}: the joint counts in the opposite direction; {name} should have {sign}q."
            yield Correction(Fault("sign of q", text, row + 1, name), turned=frozenset({row}))
    if len(turning) > 1:
        factors = np.ones_like(table.rows)
        factors[sorted(turning), THETA] = -1
        fault = Fault("sign of theta", "Every theta has the wrong sign, with its q.", None, "theta")
        yield Correction(fault, factors=factors, turned=turning)


def _corrections_of_a_pair_of_rows(table: DHTable) -> Iterator[Correction]:
    """Yield the corrections of mistakes between two rows: swapped rows, and an entry in the row before or after its own."""
    rows, joints = table.rows, table.joints
    for one, two in combinations(range(len(rows)), 2):
        swapped = rows.copy()
        swapped[[one, two]] = rows[[two, one]]
        letters = {one: joints[two], two: joints[one]} if joints[one] != joints[two] else {}
        fault = Fault("rows swapped", f"Rows {one + 1} and {two + 1} are swapped.", one + 1)
        yield replace(_replaced(fault, rows, swapped), letters=letters)
        for column, name in enumerate(COLUMNS) if two == one + 1 else ():
            here, there = rows[one, column], rows[two, column]
            text = f"Rows {one + 1} and {two + 1}: the entries of {name} are swapped."
            row = one
            if not here or not there:
                row, right = (two, one) if not here else (one, two)
                text = f"Row {row + 1}: the entry of {name} belongs in row {right + 1}."
            fault = Fault("entry one row off", text, row + 1, name)
            yield _replaced(fault, rows, swapped, (column,))


def _corrections_of_a_row(table: DHTable, zeros_are_fixed: bool) -> Iterator[Correction]:
    """Yield the corrections of mistakes in one row. The entry that a joint changes is its zero, which may be free."""
    variables = joint_entries(table.joints)
    for row, (a, alpha, d, theta) in enumerate(table.rows):
        correction = partial(_correction_of_a_row, row)
        # If two signs explain a table equally well, that of alpha is the more frequent mistake.
        columns = [k for k in (ALPHA, D, A, THETA) if zeros_are_fixed or (row, k) not in variables]
        for column in columns:
            name, value = COLUMNS[column], table.rows[row, column]
            if column == ALPHA and abs(np.sin(alpha)) < EQUIVALENCE_TOL:
                directions = "the same direction" if np.cos(alpha) < 0 else "opposite directions"
                angle = np.pi - abs(alpha)
                text = f"the axes are parallel with {directions}: alpha should be {format_entry(angle, ALPHA)}."
                yield correction("antiparallel", text, ALPHA, {ALPHA: angle})
            elif abs(value) > ROUNDING_ERROR:
                yield correction(f"sign of {name}", f"{name} has the wrong sign.", column, {column: -value})
            if abs(value) > MIN_LENGTH_MM and column in LENGTHS:
                text = f"{name} is in millimetres, but was read as metres."
                yield correction("unit of length", text, column, {column: value / 1000})
            if abs(value) > 1 and column in ANGLES:
                text = f"{name} is in degrees, but was read as radians."
                yield correction("degrees", text, column, {column: np.radians(value)})
        if a != d:
            text = "a and d are swapped. a is measured along x, d along z."
            yield correction("a and d swapped", text, A, {A: d, D: a})
        if theta != alpha:
            yield correction(
                "theta and alpha swapped", "theta and alpha are swapped.", THETA, {ALPHA: theta, THETA: alpha}
            )


def _corrections_of_a_number(
    table: DHTable, numbers: Array, more_d: Mapping[int, Sequence[float]], zeros_are_fixed: bool
) -> Iterator[Correction]:
    """Yield the corrections of one entry to a number that the arm suggests, or to a usual angle."""
    lengths = numbers[:, LENGTHS].ravel()
    usual = {column: [0.0, *lengths, *-lengths] for column in LENGTHS}
    for column in ANGLES:
        # If an axis is drawn in the opposite direction, an angle becomes its supplement.
        angles = np.concatenate([numbers[:, column], wrap_angle(np.pi - numbers[:, column])])
        usual[column] = [0.0, np.pi / 2, -np.pi / 2, np.pi, *angles, *-angles]
    variables = joint_entries(table.joints)
    for row, column in np.ndindex(table.rows.shape):
        if (row, column) in variables and not zeros_are_fixed:
            continue
        name, typed = COLUMNS[column], float(table.rows[row, column])
        values = {round(float(value), 12) + 0.0: float(value) for value in usual[column]}
        if column == D:
            values |= {round(float(value), 12) + 0.0: float(value) for value in more_d.get(row, ())}
        for value in values.values():
            if abs(value - typed) < ROUNDING_ERROR:
                continue
            kind = "wrong number"
            text = f"{name} should be {format_entry(value, column)}; the table has {format_entry(typed, column)}."
            if (row, column) in variables and not typed:
                kind, text = "offset forgotten", f"the offset of {name} is missing."
            yield _correction_of_a_row(row, kind, text, column, {column: value})


def _correction_of_a_row(row: int, name: str, text: str, column: int, entries: Mapping[int, float]) -> Correction:
    fault = Fault(name, f"Row {row + 1}: {text}", row + 1, COLUMNS[column])
    return Correction(fault, {(row, k): float(value) for k, value in entries.items()})


def _replaced(fault: Fault, rows: Array, right: Array, columns: Iterable[int] = range(4)) -> Correction:
    """Construct the correction that replaces some columns of a table where they differ."""
    entries = {
        (row, column): float(right[row, column])
        for column in columns
        for row in range(len(rows))
        if rows[row, column] != right[row, column]
    }
    return Correction(fault, entries)


def _scaled(fault: Fault, rows: Array, columns: Sequence[int], factor: float) -> Correction:
    """Construct the correction that multiplies some columns of a table by a factor."""
    factors = np.ones_like(rows)
    factors[:, columns] = factor
    return Correction(fault, factors=factors)
