"""What is wrong with a DH table: the mistake, or the two together, that explain why it is not the arm it claims to be.

Every known mistake is undone in turn, in every row where it could have been made. If the table then moves like the arm,
up to base, tool, joint zero and joint sign, that was it. One mistake is preferred to two, and one that spoils the whole
table to one that spoils an entry; a plain wrong number is believed last.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import SAME, Equivalence, equivalent
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import Convention, DHTable
from kinlib.rigid.angles import wrap_angle
from kinlib.rigid.lie import log

A, ALPHA, D, THETA = range(4)


@dataclass(frozen=True)
class Fault:
    """A mistake that was found: its name, the row (from 1) and the column where it stands, and what to say of it."""

    name: str
    text: str
    row: int | None = None
    column: str | None = None


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """What was found: no faults and an equivalence, or faults and the corrected table, or neither.

    faults       the mistakes that explain the difference together; empty where the table is right or nothing explains it
    corrected    the table with them mended, which is equivalent to the reference
    equivalence  of the corrected table and the reference, with the map that shows it
    """

    faults: Sequence[Fault]
    corrected: DHTable | None
    equivalence: Equivalence

    @property
    def right(self) -> bool:
        """Whether the table was right as it stood."""
        return not self.faults and self.corrected is not None

    def __str__(self) -> str:
        if self.faults:
            return "\n".join(fault.text for fault in self.faults)
        if self.corrected is None:
            return (
                f"None of the mistakes that we know, alone or in pairs, explains this table. {self.equivalence.reason}"
            )
        return "\n".join(["This table is the arm.", *_conventions(self.equivalence)])


def diagnose(
    table: DHTable, reference: Chain | DHTable, *, tolerance: float = SAME, in_pairs: bool = True
) -> Diagnosis:
    """Find what is wrong with a table, given the arm that it claims to describe.

    in_pairs  whether two mistakes together are tried where none alone explains the table; it may take some seconds

    Raises ValueError where the two cannot be compared: another number of joints.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> printed = assign_frames(puma560(), convention="modified").table
    >>> print(diagnose(printed.changed(convention="standard"), puma560()))
    The table is in the modified convention, and was read as standard.
    """
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if table.n != arm.n:
        raise ValueError(f"The table has {table.n} joints ({table.joints}), and the arm {arm.n} ({arm.joint_types}).")
    as_it_stands = equivalent(table, arm, tolerance=tolerance)
    if as_it_stands:
        return Diagnosis((), table, as_it_stands)
    single = [*_whole(table), *_by_row(table)]
    paired = [fix for fix in single if fix.fault.name != "column shifted"]
    doubles = combinations(paired, 2) if in_pairs else ()
    for fixes in [*((fix,) for fix in single), *((fix,) for fix in _numbers(table, arm)), *doubles]:
        mended = table
        for fix in fixes:
            mended = fix.apply(mended)
        if equivalent(mended, arm, tolerance=tolerance, simplest=False):
            found = equivalent(mended, arm, tolerance=tolerance)
            return Diagnosis([fix.fault for fix in fixes], mended, found)
    return Diagnosis((), None, as_it_stands)


@dataclass(frozen=True, eq=False)
class _Fix:
    """A fault, and how to mend it: entries to set by (row, column), or another convention, joints or shift of a and alpha."""

    fault: Fault
    entries: Sequence[tuple[int, int, float]] = ()
    convention: Convention | None = None
    joints: str | None = None
    shift: int = 0

    def apply(self, table: DHTable) -> DHTable:
        rows = np.array(table.rows)
        for row, column, value in self.entries:
            rows[row, column] = value
        rows[:, :2] = np.roll(rows[:, :2], self.shift, axis=0)
        return table.changed(
            rows=rows, convention=self.convention or table.convention, joints=self.joints or table.joints
        )


def _whole(table: DHTable) -> Iterator[_Fix]:
    """Mistakes that run through the whole table."""
    other: Convention = "modified" if table.convention == "standard" else "standard"
    text = f"The table is in the {other} convention, and was read as {table.convention}."
    yield _Fix(Fault("other convention", text), convention=other)
    for shift, where in ((1, "one row too high"), (-1, "one row too low")):
        text = f"The columns a and alpha stand {where}: a_{{i-1}} and a_i were taken for each other."
        yield _Fix(Fault("column shifted", text), shift=shift)
    every, numbers = range(len(table.rows)), table.rows
    text = "The angles are degrees, read as radians."
    yield _Fix(
        Fault("degrees", text),
        [(row, column, float(np.radians(numbers[row, column]))) for row in every for column in (ALPHA, THETA)],
    )
    text = "Every alpha has the wrong sign: it turns from z_{i-1} to z_i about x_i, by the right hand."
    yield _Fix(Fault("sign of alpha", text, None, "alpha"), [(row, ALPHA, -numbers[row, ALPHA]) for row in every])
    text = "The columns a and d are exchanged: a is measured along x, d along z."
    yield _Fix(
        Fault("a and d exchanged", text, None, "a"),
        [entry for row in every for entry in ((row, A, numbers[row, D]), (row, D, numbers[row, A]))],
    )


def _by_row(table: DHTable) -> Iterator[_Fix]:
    """Mistakes that one row may hold."""
    for row, (a, alpha, d, theta) in enumerate(table.rows):
        place = f"Row {row + 1}"
        if abs(np.sin(alpha)) > SAME:
            text = f"{place}: alpha has the wrong sign."
            yield _Fix(Fault("sign of alpha", text, row + 1, "alpha"), [(row, ALPHA, -alpha)])
        else:
            text = f"{place}: the axes are parallel and point opposite ways, or the same way: alpha should be {np.pi - abs(alpha):.4g}."
            yield _Fix(Fault("anti-parallel", text, row + 1, "alpha"), [(row, ALPHA, np.pi - abs(alpha))])
        if a != d:
            text = f"{place}: a and d are exchanged. a is measured along x, d along z."
            yield _Fix(Fault("a and d exchanged", text, row + 1, "a"), [(row, A, d), (row, D, a)])
        if d and table.joints[row] != "P":
            yield _Fix(Fault("sign of d", f"{place}: d has the wrong sign.", row + 1, "d"), [(row, D, -d)])
        if a:
            yield _Fix(Fault("sign of a", f"{place}: a has the wrong sign.", row + 1, "a"), [(row, A, -a)])
        if table.joints[row] != "F":
            letter, column = ("P", "d") if table.joints[row] == "R" else ("R", "theta")
            joints = table.joints[:row] + letter + table.joints[row + 1 :]
            text = f"{place}: the joint variable belongs in {column}, for this joint {'slides' if letter == 'P' else 'turns'}."
            yield _Fix(Fault("variable in the wrong column", text, row + 1, column), joints=joints)
        if theta != alpha and table.joints[row] != "R":
            text = f"{place}: theta and alpha are exchanged."
            yield _Fix(
                Fault("theta and alpha exchanged", text, row + 1, "theta"), [(row, ALPHA, theta), (row, THETA, alpha)]
            )


def _numbers(table: DHTable, arm: Chain) -> Iterator[_Fix]:
    """Entries that should be another number: one that stands in the arm's own table, or a usual angle."""
    if "H" in arm.joint_types:
        return
    own = assign_frames(arm, convention=table.convention).table.rows
    lengths = np.concatenate([own[:, A], own[:, D]])
    usual = {column: {0.0, *lengths, *-lengths} for column in (A, D)}
    for column in (ALPHA, THETA):
        # Beside an axis that is drawn the other way round, an angle and its supplement change places.
        angles = np.concatenate([own[:, column], wrap_angle(np.pi - own[:, column])])
        usual[column] = {0.0, np.pi / 2, -np.pi / 2, np.pi, *angles, *-angles}
    for row, letter in enumerate(table.joints):
        for column, name in enumerate(COLUMNS):
            moves = (letter, name) in {("R", "theta"), ("P", "d")}
            for value in sorted(usual[column], key=lambda value: (abs(value), -value)) if not moves else ():
                text = f"Row {row + 1}: {name} should be {value:.4g}; the table says {table.rows[row, column]:.4g}."
                yield _Fix(Fault("wrong number", text, row + 1, name), [(row, column, float(value))])


def _conventions(found: Equivalence) -> Iterator[str]:
    """What two right descriptions of one arm may still disagree about."""
    for joint, (sign, offset) in enumerate(zip(found.signs, found.offsets, strict=True), start=1):
        if sign < 0:
            yield f"Joint {joint} counts the other way."
        if abs(offset) > SAME:
            yield f"Joint {joint} has its zero elsewhere, by {offset:.4g}."
    for name, T in (("base", found.base), ("tool", found.tool)):
        if np.abs(T - np.eye(4)).max() > SAME:
            yield f"The {name} frames differ: {_where(T)}."


def _where(T: np.ndarray) -> str:
    degrees, metres = np.degrees(np.linalg.norm(log(T[:3, :3]))), np.linalg.norm(T[:3, 3])
    # A rounding of 1e-17 is nothing to tell.
    return f"turned by {round(float(degrees), 6):.4g} degrees, shifted by {round(float(metres), 9):.4g} m"
