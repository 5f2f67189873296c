"""Search for the slips that explain a table, or for choices that are fixed, or for a few other numbers.

Slips are found by a list of candidates, a filter by invariants, a price, and a full comparison. All slips of `kinlib.dh.slips` are
corrected in all places at once, as arrays of rows. Most corrections are refuted by the invariants of the axes, and only the rest is
compared with the arm. The price of a correction is the number of entries that it edits, in which a number that it invents counts
twice, because some number explains almost anything; then how large and unusual the change is.
"""

from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import MAX_ROTATION_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.alignment import COMPARED_CONFIGURATIONS, AxisInvariants, Map, fitted, nearest_maps
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import ROUGH, Equivalence, equivalent
from kinlib.dh.parsing import joint_entries
from kinlib.dh.slips import ANGLES, CHOICES, WRONG_NUMBER, Fault, corrections, starting_tables, wrong_number
from kinlib.dh.table import DHTable, joint_axes
from kinlib.rigid.lie import wrap_angle

FILTER_TOL_FACTOR = 3
"""How many times the tolerance an invariant may be off before a correction is refuted by it."""

MAX_PAIRS, MAX_COMPARED = 20_000, 100


@dataclass(frozen=True, eq=False)
class TableExplanation:
    """Mistakes that together explain a table.

    faults      the mistakes
    corrected   the table without them, which describes the arm up to the choices that are not fixed
    edits       how many entries they change; a pose or an invented number counts as one more
    """

    faults: Sequence[Fault]
    corrected: DHTable
    edits: int

    @property
    def is_a_choice(self) -> bool:
        """Whether the table is right up to choices that are fixed, and the faults are these choices."""
        return {fault.name for fault in self.faults} <= {*CHOICES.values()}

    def says_as_much(self, other: Self) -> bool:
        """Whether another explanation leads to the same table, up to full turns."""
        a, b = self.corrected, other.corrected
        if (a.convention, a.joints, a.signs.tolist()) != (b.convention, b.joints, b.signs.tolist()):
            return False
        return largest_difference(*(each.link_transforms(np.zeros(each.n)) for each in (a, b))) < 1e-9


def explain_by_slips(  # noqa: PLR0917
    table: DHTable, reference: Chain | DHTable, fixed: frozenset[str], tolerance: float, count: int, half_unit: Array
) -> list[TableExplanation]:
    """Return the explanations of a table by so many slips with the fewest edits, those with the smallest price first.

    half_unit  (m, 4) how far the numbers may be off by their digits
    """
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    candidates = [
        ((edits + len(faults), size), start, [*faults, *slips], rows)
        for faults, start in starting_tables(table, arm.joint_types)
        for (edits, size), slips, rows in _candidates(
            start, arm, reference, fixed, tolerance, count - len(faults), half_unit
        )
    ]
    found = list[TableExplanation]()
    for (edits, _), start, faults, rows in sorted(candidates, key=lambda each: each[0]):
        if found and edits > found[0].edits:
            break
        with suppress(ValueError):  # for example an angle of many turns, which no table has
            each = TableExplanation(faults, start.changed(rows=rows), edits)
            is_same = equivalent(each.corrected, arm, fixed=fixed, tolerance=tolerance).verdict == "same"
            if is_same and not any(each.says_as_much(other) for other in found):
                found.append(each)
    return found


def explain_by_choices(table: DHTable, found: Equivalence, names: Collection[str] = CHOICES) -> TableExplanation:
    """Return the choices of these names in which a table differs from an arm as corrections, each with its numbers."""
    faults, (moving, column) = found.choices(table, names), np.transpose(joint_entries(table.joints))
    rows, signs = table.rows.copy(), table.signs.copy()
    rows[moving, column] += signs[moving] * found.offsets * ("zeros" in names)
    rows[:, 3] = np.where(np.abs(rows[:, 3]) > 2 * np.pi, wrap_angle(rows[:, 3]), rows[:, 3])
    signs[moving] *= found.signs if "signs" in names else 1.0
    ends = {"base": found.base @ table.base, "tool": table.tool @ found.tool}
    corrected = table.changed(rows=rows, signs=signs, **{name: T for name, T in ends.items() if name in names})
    return TableExplanation(faults, corrected, len(faults) + sum(fault.row is None for fault in faults))


def explain_by_numbers(
    table: DHTable, arm: Chain, fixed: frozenset[str], half_unit: Array, noise: float
) -> list[TableExplanation]:
    """Find few other numbers with which a table describes the arm, the largest difference first; [] if none are found."""
    if table.joints.replace("F", "") != arm.joint_types or np.abs(table.rows).max() > MAX_ROTATION_RAD:
        return []  # a fit resolves no longer length
    tolerance, half = max(noise, 1e-6), np.maximum(half_unit, 1e-6)
    is_free = np.zeros(half.shape, dtype=bool)
    is_free[tuple(np.transpose(joint_entries(table.joints)))] = "zeros" not in fixed
    start = min(nearest_maps(table.to_chain(), arm, fixed, tolerance, ROUGH), key=lambda each: each.difference)
    change = _few_changes(table, arm, start, fixed, np.where(is_free, 1.0, half))
    is_changed = ~is_free & (np.abs(change) > 1.05 * half)
    right = (table.rows + change).round(7)
    right[:, ANGLES] = wrap_angle(right[:, ANGLES])  # a fit may have made full turns
    nearest = table.changed(rows=np.where(is_changed, right, table.rows))
    if equivalent(nearest, arm, fixed=fixed, tolerance=tolerance).verdict != "same":
        return []
    off = np.abs(nearest.rows - table.rows)
    places = sorted(np.argwhere(off > 0).tolist(), key=lambda place: -off[tuple(place)])
    faults = [wrong_number(table, row, column, float(right[row, column])) for row, column in places]
    return [TableExplanation(faults, nearest, 2 * len(faults))]


def _few_changes(table: DHTable, arm: Chain, start: Map, fixed: frozenset[str], unit: Array) -> Array:
    """Find changes (m, 4) of few numbers after which a table describes an arm, from a map that nearly does.

    The four motions of each row are those of a chain of 4 m joints whose values are the numbers. So its body Jacobian says how
    the poses change with the numbers, and each step is a least-squares problem, in which an entry costs its change in units, and
    less, the more it changed in the step before.
    """
    order = [3, 2, 0, 1] if table.convention == "standard" else [1, 0, 3, 2]
    axes = np.eye(6)[[3, 0, 5, 2]]  # of a, alpha, d, theta in the frame that the row begins with
    motions = Chain(np.tile(axes[order], (len(table.rows), 1)), np.eye(4))
    q = random_configurations(arm.n, COMPARED_CONFIGURATIONS)
    values = np.tile(table.rows, (len(q), 1, 1))
    row, column = np.transpose(joint_entries(table.joints))
    values[:, row, column] += table.signs[row] * (start.signs * q + start.offsets)
    values = values[..., order].reshape(len(q), -1)
    X, Y, target = start.base @ table.base, table.tool @ start.tool, arm.fk(q)
    base, tool = (np.full(6, float(name not in fixed)) for name in ("base", "tool"))
    # Of parallel axes, any d can change; it is the one that is given.
    first, units = np.where(table.rows[:, order] == 0, 0.1, 1.0).ravel(), unit[:, order].ravel()

    def scale(change: Array) -> Array:
        weights = np.abs(change / units) + 1e-2 if change.any() else first
        return np.concatenate([base, units * weights, tool])

    change = fitted(motions, values, X, Y, target, scale, steps=20)[1]
    return change.reshape(-1, 4)[:, np.argsort(order)]


def _candidates(  # noqa: PLR0917
    table: DHTable,
    arm: Chain,
    reference: Chain | DHTable,
    fixed: frozenset[str],
    tolerance: float,
    count: int,
    half_unit: Array,
) -> list[tuple[tuple[int, float], list[Fault], Array]]:
    """Return the rows that so many corrections of a table with the joint types of the arm lead to, the cheapest first.

    Invariants decide what can lead to the arm, and if nothing is free, the poses of a few q. A correction of a row comes after one of
    the whole table, as `corrections` are sorted.
    """
    if count <= 0:
        return [((0, 0.0), [], table.rows)] * (count == 0)
    right = reference if isinstance(reference, DHTable) else assign_frames(arm, table.convention).table
    right = right.converted(table.convention)
    known = [
        each
        for each in corrections(table, right.rows, fixed, half_unit)
        if np.abs(each[1](table.rows) - table.rows).max() > 1e-12
    ]
    rows, start = np.array([change(table.rows) for _, change in known]), table.rows
    invents = np.array([fault.name == WRONG_NUMBER for fault, _ in known])
    # Every entry of a column has to be wrong in the same way: that a single entry is wrong is simpler.
    is_of_all = np.array([fault.row is None and fault.name.startswith("sign of") for fault, _ in known])
    edits = (np.abs(rows - start) > 1e-12).sum(axis=(1, 2)) + (invents | is_of_all)
    invariants = AxisInvariants(arm, FILTER_TOL_FACTOR * tolerance)
    places = np.arange(len(known))[:, None]
    if count > 1:
        places = _pairs(invariants, table, rows)
        start = rows[places[:, 0]]
        rows = start.copy()
        for place in np.unique(places[:, 1]):
            is_here = places[:, 1] == place
            rows[is_here] = known[place][1](rows[is_here])
    agree = invariants.agree(invariants.of(*joint_axes(table, rows)), "signs" in fixed)
    # A number that differs from the one after the first correction by no more than its digits is no wrong one.
    agree &= ~invents[places[:, -1]] | (np.abs(rows - start) > 1.05 * half_unit).any(axis=(1, 2))
    if fixed >= {*CHOICES} and agree.any():
        q = random_configurations(arm.n, 4)
        off = np.abs(table.fk(q, rows[agree, None]) - arm.fk(q)).max(axis=(1, 2, 3))
        agree[agree] = off <= FILTER_TOL_FACTOR * tolerance
    edits = edits[places].sum(axis=1)
    sizes = np.where(invents[places].any(axis=1), np.abs(rows - table.rows).sum(axis=(1, 2)), 0.0)
    sizes += 1e-3 * (rows[:, :, [0, 2]] < 0).sum(axis=(1, 2))  # in most tables the lengths have one sign
    order = sorted((int(edits[k]), round(float(sizes[k]), 9), k) for k in np.flatnonzero(agree))
    return [((e, size), [known[p][0] for p in places[k]], rows[k]) for e, size, k in order][:MAX_COMPARED]


def _pairs(invariants: AxisInvariants, table: DHTable, rows: Array) -> NDArray[np.intp]:
    """Return the pairs of corrections of which each one changes every invariant that is wrong without it, (N, 2)."""
    values, own = (invariants.of(*joint_axes(table, each)) for each in (rows, table.rows))
    violated = invariants.violated(values).astype(float)
    unchanged = np.isclose(values, own, rtol=1e-9, atol=1e-10).astype(float)
    possible = violated @ unchanged.T == 0
    return np.argwhere(np.triu(possible & possible.T, 1))[:MAX_PAIRS]
