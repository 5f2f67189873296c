"""Diagnose a DH table: find the mistake, or the two mistakes, that explain why it does not describe a given arm.

Every known mistake is corrected in turn, in every row where it could have been made. If the corrected table has the motions of
the arm, up to base, tool, joint zero and joint sign, the mistake is found. One mistake is preferred to two, and a mistake in the
whole table to a mistake in one entry; a wrong number is considered last.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from kinlib.arrays.tolerances import EQUIVALENCE_TOL
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import Equivalence, equivalent
from kinlib.dh.parsing import COLUMNS
from kinlib.dh.table import Convention, DHTable
from kinlib.rigid.angles import wrap_angle
from kinlib.rigid.lie import log

A, ALPHA, D, THETA = range(4)


@dataclass(frozen=True)
class Fault:
    """A mistake in a table: its name, a sentence that describes it, and its row (from 1) and column, if it has any."""

    name: str
    text: str
    row: int | None = None
    column: str | None = None


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """The result of a diagnosis: no faults and an equivalence, or faults and the corrected table, or neither.

    faults       the mistakes that together explain the difference; empty if the table is right or nothing explains it
    corrected    the table without these mistakes, which is equivalent to the reference
    equivalence  of the corrected table and the reference, with the map between them
    """

    faults: Sequence[Fault]
    corrected: DHTable | None
    equivalence: Equivalence

    @property
    def right(self) -> bool:
        """Whether the table was right without corrections."""
        return not self.faults and self.corrected is not None

    @property
    def difference(self) -> str:
        """The first difference between the uncorrected table and the arm, in words; empty if there is none or it is explained."""
        return self.equivalence.reason.replace("the first", "the table").replace("the second", "the arm")

    def __str__(self) -> str:
        if self.faults:
            return "\n".join(fault.text for fault in self.faults)
        if self.corrected is None:
            return f"No known mistake, and no pair of them, explains this table. {self.difference}"
        return "\n".join(["This table describes the arm.", *_describe_choices(self.equivalence)])


def diagnose(
    table: DHTable, reference: Chain | DHTable, *, tolerance: float = EQUIVALENCE_TOL, in_pairs: bool = True
) -> Diagnosis:
    """Find the mistakes in a table, given the arm that it is meant to describe.

    in_pairs  whether pairs of mistakes are tried if no single one explains the table, which may take some seconds

    Raises ValueError if the two have different numbers of joints, because then they cannot be compared.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> printed = assign_frames(puma560(), convention="modified").table
    >>> print(diagnose(printed.changed(convention="standard"), puma560()))
    The table is in the modified convention, but was read as standard.
    """
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if table.n != arm.n:
        raise ValueError(
            f"The table must have as many joints as the arm, {arm.n} ({arm.joint_types}); it has {table.n} ({table.joints})."
        )
    uncorrected = equivalent(table, arm, tolerance=tolerance)
    if uncorrected:
        return Diagnosis((), table, uncorrected)
    single = [*_corrections_of_the_table(table), *_corrections_of_a_row(table)]
    pairable = [correction for correction in single if correction.fault.name != "column shifted"]
    pairs = combinations(pairable, 2) if in_pairs else ()
    numbers = _corrections_of_a_number(table, arm)
    for corrections in [*zip(single, strict=True), *zip(numbers, strict=True), *pairs]:
        corrected = table
        for correction in corrections:
            corrected = correction.apply(corrected)
        if equivalent(corrected, arm, tolerance=tolerance, simplest=False):
            equivalence = equivalent(corrected, arm, tolerance=tolerance)
            return Diagnosis([correction.fault for correction in corrections], corrected, equivalence)
    return Diagnosis((), None, uncorrected)


@dataclass(frozen=True, eq=False)
class _Correction:
    """A fault and its correction: entries to set by (row, column), or another convention, joints or shift of a and alpha."""

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


def _corrections_of_the_table(table: DHTable) -> Iterator[_Correction]:
    """Yield the corrections of mistakes that affect the whole table."""
    other: Convention = "modified" if table.convention == "standard" else "standard"
    text = f"The table is in the {other} convention, but was read as {table.convention}."
    yield _Correction(Fault("other convention", text), convention=other)
    for shift, where in ((1, "one row too high"), (-1, "one row too low")):
        text = f"The columns a and alpha are {where}: a_{{i-1}} and a_i were confused."
        yield _Correction(Fault("column shifted", text), shift=shift)
    every, numbers = range(len(table.rows)), table.rows
    text = "The angles are in degrees, but were read as radians."
    yield _Correction(
        Fault("degrees", text),
        [(row, column, float(np.radians(numbers[row, column]))) for row in every for column in (ALPHA, THETA)],
    )
    text = "Every alpha has the wrong sign: it is the angle from z_{i-1} to z_i about x_i, by the right-hand rule."
    yield _Correction(
        Fault("sign of alpha", text, None, "alpha"), [(row, ALPHA, -numbers[row, ALPHA]) for row in every]
    )
    text = "The columns a and d are swapped: a is measured along x, d along z."
    yield _Correction(
        Fault("a and d swapped", text, None, "a"),
        [entry for row in every for entry in ((row, A, numbers[row, D]), (row, D, numbers[row, A]))],
    )


def _corrections_of_a_row(table: DHTable) -> Iterator[_Correction]:
    """Yield the corrections of mistakes in one row."""
    for row, (a, alpha, d, theta) in enumerate(table.rows):
        place = f"Row {row + 1}"
        if abs(np.sin(alpha)) > EQUIVALENCE_TOL:
            text = f"{place}: alpha has the wrong sign."
            yield _Correction(Fault("sign of alpha", text, row + 1, "alpha"), [(row, ALPHA, -alpha)])
        else:
            directions = "the same direction" if np.cos(alpha) < 0 else "opposite directions"
            text = f"{place}: the axes are parallel with {directions}: alpha should be {np.pi - abs(alpha):.4g}."
            yield _Correction(Fault("anti-parallel", text, row + 1, "alpha"), [(row, ALPHA, np.pi - abs(alpha))])
        if a != d:
            text = f"{place}: a and d are swapped. a is measured along x, d along z."
            yield _Correction(Fault("a and d swapped", text, row + 1, "a"), [(row, A, d), (row, D, a)])
        if d and table.joints[row] != "P":
            yield _Correction(Fault("sign of d", f"{place}: d has the wrong sign.", row + 1, "d"), [(row, D, -d)])
        if a:
            yield _Correction(Fault("sign of a", f"{place}: a has the wrong sign.", row + 1, "a"), [(row, A, -a)])
        if table.joints[row] != "F":
            joint_type, column = ("P", "d") if table.joints[row] == "R" else ("R", "theta")
            joints = table.joints[:row] + joint_type + table.joints[row + 1 :]
            kind = "prismatic" if joint_type == "P" else "revolute"
            text = f"{place}: the joint variable belongs in {column}, because this joint is {kind}."
            yield _Correction(Fault("variable in the wrong column", text, row + 1, column), joints=joints)
        if theta != alpha and table.joints[row] != "R":
            text = f"{place}: theta and alpha are swapped."
            yield _Correction(
                Fault("theta and alpha swapped", text, row + 1, "theta"), [(row, ALPHA, theta), (row, THETA, alpha)]
            )


def _corrections_of_a_number(table: DHTable, arm: Chain) -> Iterator[_Correction]:
    """Yield the corrections of one entry to a number from the arm's own table, or to a usual angle."""
    if "H" in arm.joint_types:
        return
    own = assign_frames(arm, convention=table.convention).table.rows
    lengths = np.concatenate([own[:, A], own[:, D]])
    usual = {column: {0.0, *lengths, *-lengths} for column in (A, D)}
    for column in (ALPHA, THETA):
        # If an axis is drawn in the opposite direction, an angle becomes its supplement.
        angles = np.concatenate([own[:, column], wrap_angle(np.pi - own[:, column])])
        usual[column] = {0.0, np.pi / 2, -np.pi / 2, np.pi, *angles, *-angles}
    for row, joint_type in enumerate(table.joints):
        for column, name in enumerate(COLUMNS):
            moves = (joint_type, name) in {("R", "theta"), ("P", "d")}
            for value in sorted(usual[column], key=lambda value: (abs(value), -value)) if not moves else ():
                text = f"Row {row + 1}: {name} should be {value:.4g}; the table has {table.rows[row, column]:.4g}."
                yield _Correction(Fault("wrong number", text, row + 1, name), [(row, column, float(value))])


def _describe_choices(equivalence: Equivalence) -> Iterator[str]:
    """Describe the choices in which two right descriptions of one arm differ."""
    for joint, (sign, offset) in enumerate(zip(equivalence.signs, equivalence.offsets, strict=True), start=1):
        if sign < 0:
            yield f"Joint {joint} has the opposite sign."
        if abs(offset) > EQUIVALENCE_TOL:
            yield f"Joint {joint} has another zero, {offset:.4g} away."
    for name, T in (("base", equivalence.base), ("tool", equivalence.tool)):
        if np.abs(T - np.eye(4)).max() > EQUIVALENCE_TOL:
            yield f"The {name} frames differ: {_describe_pose(T)}."


def _describe_pose(T: np.ndarray) -> str:
    degrees, metres = np.degrees(np.linalg.norm(log(T[:3, :3]))), np.linalg.norm(T[:3, 3])
    # Rounding removes errors such as 1e-17.
    return f"rotated by {round(float(degrees), 6):.4g} degrees, translated by {round(float(metres), 9):.4g} m"
