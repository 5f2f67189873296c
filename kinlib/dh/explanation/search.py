"""Search for the slips that explain a table: a list of candidates, a filter by invariants, a price, and a full comparison.

All slips of `kinlib.dh.slips` are corrected in all places at once, as arrays of rows. Most corrections are refuted by the invariants
of the axes, and only the rest is compared with the arm. The price of a correction is the number of entries that it edits; then the
numbers that it invents, because some number explains almost anything; then how large and unusual the change is.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import EQUIVALENCE_TOL
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.alignment import AxisInvariants
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import CHOICES, Equivalence, describe_pose, equivalent, format_offset
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.slips import NUMBERS, Fault, corrections, starting_tables, wrong_number
from kinlib.dh.table import DHTable, joint_axes, table_poses
from kinlib.rigid.angles import wrap_angle

FILTER_TOL_FACTOR = 3
"""How many times the tolerance an invariant may be off before a correction is refuted by it."""

Price = tuple[int, int, float]
"""The edited entries, the invented numbers, and how large and unusual the change is."""


@dataclass(frozen=True, eq=False)
class TableExplanation:
    """Mistakes that together explain a table.

    faults      the mistakes
    corrected   the table without them, which describes the arm up to the choices that are not fixed
    edits       how many entries they change; a pose or an invented number counts as one more
    is_a_choice whether the table is right up to choices that are fixed, and the faults are these choices
    """

    faults: Sequence[Fault]
    corrected: DHTable
    edits: int
    is_a_choice: bool = False

    def says_as_much(self, other: Self) -> bool:
        """Whether another explanation leads to the same table, up to full turns."""
        a, b = self.corrected, other.corrected
        is_same = (a.convention, a.joints, a.signs.tolist()) == (b.convention, b.joints, b.signs.tolist())
        off = a.rows - b.rows
        off[:, 1::2] = wrap_angle(off[:, 1::2])
        return is_same and bool(np.abs(off).max() < 1e-9)


def explain_by_slips(  # noqa: PLR0917
    table: DHTable,
    reference: Chain | DHTable,
    fixed: frozenset[str],
    tolerance: float,
    count: int,
    free_ends: frozenset[str] = frozenset(),
) -> list[TableExplanation]:
    """Return the explanations of a table by so many slips with the fewest edits, those with the smallest price first.

    free_ends   of the fixed choices, a base or a tool that may be wrong as well; then it is told, too
    """
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    found, wrong_ends = list[tuple[Price, TableExplanation]](), {f"wrong {end}" for end in free_ends}
    for faults, start in starting_tables(table, arm.joint_types):
        if len(faults) > count:
            continue
        right = assign_frames(arm, convention=start.convention).table
        if isinstance(reference, DHTable) and len(reference.rows) == len(table.rows):
            right = reference.converted(start.convention)
        search = _Search(start, arm, right.rows, fixed - free_ends, tolerance, len(faults) < count)
        for price, slips, corrected, compared in search.explanations(count - len(faults)):
            ends = [fault for fault in choices_as_faults(corrected, compared) if fault.name in wrong_ends]
            poses = {"base": compared.base @ corrected.base, "tool": corrected.tool @ compared.tool}
            mended = corrected.changed(**{end: poses[end] for end in free_ends})
            edits = price[0] + len(faults) + sum(map(_weight, ends))
            each = TableExplanation([*faults, *slips, *ends], mended, edits)
            if not any(each.says_as_much(other) for _, other in found):
                found.append(((edits, *price[1:]), each))
    return cheapest([each for _, each in sorted(found, key=lambda pair: pair[0])])


def cheapest(found: Sequence[TableExplanation]) -> list[TableExplanation]:
    """Return the explanations with the fewest edits."""
    return [each for each in found if each.edits == min(other.edits for other in found)]


def explain_by_choices(table: DHTable, found: Equivalence) -> TableExplanation | None:
    """Return the choices up to which a table is right as an explanation; None if it is not."""
    faults = choices_as_faults(table, found) if found.verdict == "same" else []
    if not faults:
        return None
    rows, signs = table.rows.copy(), table.signs.copy()
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        rows[row, column] += table.signs[row] * found.offsets[joint]
        signs[row] *= found.signs[joint]
    corrected = table.changed(rows=rows, signs=signs, base=found.base @ table.base, tool=table.tool @ found.tool)
    return TableExplanation(faults, corrected, sum(map(_weight, faults)), is_a_choice=True)


def choices_as_faults(table: DHTable, found: Equivalence) -> list[Fault]:
    """Write the choices in which a table differs from an arm as corrections, each with its numbers."""
    faults = []
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        name, letter, place = COLUMNS[column], table.joints[row], f"joint {joint + 1}"
        if text := format_offset(letter, float(table.signs[row] * found.offsets[joint])):
            base = " (or rotate the base by as much about axis 1)" if joint == 0 and letter == "R" else ""
            faults.append(Fault("another zero", f"{place}: add {text} to {name}{base}.", row + 1, name))
        if found.signs[joint] < 0:
            sign = "-" if table.signs[row] > 0 else "+"
            text = f"{place}: write {sign}q in {name}, because q counts in the opposite direction."
            faults.append(Fault("sign of a joint value", text, row + 1, name))
    for end, name, own, T in (
        ("base", "The base T_s0", table.base, found.base @ table.base),
        ("tool", "The tool transform", table.tool, table.tool @ found.tool),
    ):
        if (own != T).any():
            is_missing = np.abs(own - np.eye(4)).max() < EQUIVALENCE_TOL
            is_inverted = np.abs(own @ T - np.eye(4)).max() < 1e-6  # as a person types it
            what = "is missing" if is_missing else "is inverted" if is_inverted else "is wrong"
            faults.append(Fault(f"wrong {end}", f"{name} {what}: it should be {describe_pose(T, found.tolerance)}."))
    return faults


def _weight(fault: Fault) -> int:
    """How many edits a choice counts as: a pose is two."""
    return 2 if fault.name in {"wrong base", "wrong tool"} else 1


class _Search:
    """The corrections of a table that has the joint types of the arm, with the rows and the signs (N, m) that each leads to.

    corrects  whether corrections are sought; otherwise only the table itself is compared
    """

    def __init__(  # noqa: PLR0917
        self, table: DHTable, arm: Chain, right: Array, fixed: frozenset[str], tolerance: float, corrects: bool
    ) -> None:
        self.table, self.arm, self.fixed, self.tolerance = table, arm, fixed, tolerance
        known = corrections(table, right, "zeros" in fixed, "signs" in fixed) if corrects else []
        rows = np.array([each.change(table.rows) for each in known]).reshape(-1, *table.rows.shape)
        differs = np.abs(rows - table.rows) > 1e-12
        kept = [k for k, each in enumerate(known) if each.reversed or differs[k].any()]
        self.singles, self.rows = [known[k] for k in kept], rows[kept]
        m = range(len(table.rows))
        self.flips = np.array([[-1.0 if row in each.reversed else 1.0 for row in m] for each in self.singles]).reshape(
            -1, len(m)
        )
        self.invents = np.array([each.fault.name in NUMBERS for each in self.singles], dtype=bool)
        # Two rows that change places are two edits, and labels and invented numbers one more. Every entry of a column has to be wrong
        # in the same way, which is one more as well: a single entry is the simpler explanation.
        self.edits = differs[kept].sum(axis=(1, 2)) + self.invents
        for k, each in enumerate(self.singles):
            is_column = each.fault.row is None and each.fault.name.startswith("sign of")
            edits = min(self.edits[k], 2) if each.fault.name == "rows swapped" else self.edits[k] + is_column
            self.edits[k] = edits + bool(each.reversed)
        self.invariants = AxisInvariants(arm, FILTER_TOL_FACTOR * tolerance)

    def explanations(self, count: int) -> Iterator[tuple[Price, list[Fault], DHTable, Equivalence]]:
        """Yield the explanations by so many corrections with the fewest edits: price, faults, corrected table, its comparison."""
        least = None
        for price, places, rows, signs in self._candidates(count)[:60]:
            if least is not None and price[0] > least:
                return
            with suppress(ValueError):  # for example an angle of many turns, which no table has
                corrected = self.table.changed(rows=rows, signs=signs)
                compared = equivalent(corrected, self.arm, fixed=self.fixed, tolerance=self.tolerance)
                if compared.verdict == "same":
                    least = price[0]
                    faults = [self._described(self.singles[k].fault, corrected) for k in places]
                    yield price, faults, corrected, compared

    def _described(self, fault: Fault, corrected: DHTable) -> Fault:
        if fault.text or not fault.row or not fault.column:
            return fault
        return wrong_number(self.table, corrected, fault.row - 1, COLUMNS.index(fault.column))

    def _candidates(self, count: int) -> list[tuple[Price, list[int], Array, Array]]:
        """Return the corrections that can lead to the arm, the cheapest first: price, places in the singles, rows, signs.

        Invariants decide, and if nothing is free, the poses of a few q. A correction of a row comes after one of the whole table, as
        the singles are sorted.
        """
        singles = np.arange(len(self.singles))[:, None]
        places = self._pairs() if count > 1 else singles if count else np.zeros((1, 0), int)
        rows = self.rows[places[:, 0]] if count else self.table.rows[None]
        for place in np.unique(places[:, 1]) if count > 1 else ():
            is_here = places[:, 1] == place
            rows[is_here] = self.singles[place].change(rows[is_here])
        signs = self.table.signs * self.flips[places].prod(axis=1)
        agree = self.invariants.agree(self.invariants.of(*joint_axes(self.table, rows, signs)), "signs" in self.fixed)
        if self.fixed >= {*CHOICES} and agree.any():
            q = random_configurations(self.arm.n, 4)
            off = table_poses(self.table, rows[agree, None], q, signs[agree, None]) - self.arm.fk(q)
            agree[agree] = np.abs(off).max(axis=(1, 2, 3)) <= FILTER_TOL_FACTOR * self.tolerance
        numbers, edits = self.invents[places].sum(axis=1), self.edits[places].sum(axis=1)
        sizes = np.where(numbers > 0, np.abs(rows - self.table.rows).sum(axis=(1, 2)), 0.0)
        sizes += 1e-3 * (rows[:, :, [0, 2]] < 0).sum(axis=(1, 2))  # in most tables the lengths have one sign
        order = sorted((int(edits[k]), int(numbers[k]), round(float(sizes[k]), 9), k) for k in np.flatnonzero(agree))
        return [((e, n, size), places[k].tolist(), rows[k], signs[k]) for e, n, size, k in order]

    def _pairs(self) -> NDArray[np.intp]:
        """Return the pairs of which each one changes every invariant that is wrong without it, (N, 2)."""
        values = self.invariants.of(*joint_axes(self.table, self.rows, self.table.signs * self.flips))
        own = self.invariants.of(*joint_axes(self.table, self.table.rows))
        violated = self.invariants.violated(values).astype(float)
        unchanged = np.isclose(values, own, rtol=1e-9, atol=1e-10).astype(float)
        possible = violated @ unchanged.T == 0
        return np.argwhere(np.triu(possible & possible.T, 1))[:20_000]
