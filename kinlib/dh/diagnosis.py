"""Diagnose a DH table: find the mistake, or the two mistakes, that explain why it does not describe a given arm.

Every slip of `kinlib.dh.slips` is corrected in turn, in every place where it could have been made. If the corrected table has the
motions of the arm, up to the choices that are not fixed, the slip explains the table. One is preferred to two, then the fewest
edited entries; a number that is invented counts as one entry more, because some number explains almost anything. If several
explanations are equally simple, all of them are returned.

Most corrections are refuted by the invariants of the axes, for all of them at once, and only the rest is compared in full.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from typing import Any, Literal

import numpy as np

from kinlib.arrays.formatting import format_number
from kinlib.arrays.tolerances import EQUIVALENCE_TOL, PARALLEL_TOL_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import (
    NEARLY_PARALLEL_LOSS,
    Equivalence,
    describe_pose,
    equivalent,
    format_offset,
    measured_difference,
    neighbours,
)
from kinlib.dh.invariants import AxisInvariants, Booleans
from kinlib.dh.joint_maps import CHOICES, JointMap, identity_map, joint_maps
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.rounding import nearest_rows, rounding_effect, typed_half_units
from kinlib.dh.slips import (
    MIN_LENGTH_MM,
    NUMBERS,
    OTHER_CONVENTION,
    Correction,
    Fault,
    corrected_rows,
    corrected_table,
    corrections,
    corrections_of_joint_types,
    format_entries,
)
from kinlib.dh.table import Convention, DHTable, joint_axes, table_poses

MAX_TOLD, MAX_DIFFERENT_ENTRIES = 3, 8
"""How many equally simple explanations the text lists, and how many different entries."""

MAX_COMPARED = 15
"""How many corrected tables, of those whose invariants agree, are compared with the arm in full."""

MAX_PAIRS = 20_000
"""How many pairs of mistakes are tried."""

MAX_ROUNDED_TOL = 1e-2
"""If the rounding of a table's numbers changes its poses by more than this, mistakes are not looked for through it."""

MAX_HALF_UNITS = 2.0
"""By how many half units of the last digit a number may be off: the least squares do not find the smallest largest change."""

TYPED_POSE_TOL = 1e-6
"""How far the inverse of a pose may be off that a person typed."""

FILTER_TOL_FACTOR = 3
"""How many times the tolerance an invariant may be off before a correction is refuted by it."""

ROUGH = 0.3
"""How far axes may be off, in metres and radians, where numbers are fitted to them."""

Corrections = tuple[Correction, ...]


@dataclass(frozen=True, eq=False)
class TableExplanation:
    """Mistakes that together explain a table.

    faults      the mistakes
    table       the table with them
    corrected   the table without them, which describes the arm up to the choices that are not fixed
    is_a_choice whether the table is right up to choices that are fixed, and the faults are these choices
    """

    faults: Sequence[Fault]
    table: DHTable
    corrected: DHTable
    is_a_choice: bool = False


@dataclass(frozen=True, eq=False, repr=False)
class Diagnosis:
    """The result of a diagnosis.

    verdict       "right"; "rounded", if the table differs from the arm by no more than its numbers are rounded; "undecided", if
                  rounding or nearly parallel axes may explain the difference, and no mistake does; or "wrong"

    table, arm    the table that was diagnosed, and the arm
    comparison    of this table and the arm, up to the choices that are not fixed; if the table is "rounded", to within the rounding
    explanations  all explanations that are equally simple, the most plausible one first; empty if the table is right
    nearest       if nothing explains the table: the table with other numbers that describes the arm, as few as were found
    up_to         the choices up to which it does, in words, if these are fixed
    unfixed       the comparison up to every choice, if some of them are fixed and no single entry explains the table
    tolerance     differences below it are not mentioned
    rounding      what the digits of the table show of their rounding, in words; "" with a given tolerance
    in_pairs      whether pairs of mistakes were tried
    """

    verdict: Literal["right", "rounded", "undecided", "wrong"]
    table: DHTable
    arm: Chain
    comparison: Equivalence
    explanations: Sequence[TableExplanation] = ()
    nearest: DHTable | None = None
    up_to: str = ""
    unfixed: Equivalence | None = None
    tolerance: float = EQUIVALENCE_TOL
    rounding: str = ""
    in_pairs: bool = True

    @property
    def faults(self) -> Sequence[Fault]:
        """The mistakes of the first explanation; empty if the table is right or nothing explains it."""
        return self.explanations[0].faults if self.explanations else ()

    @property
    def corrected(self) -> DHTable | None:
        """The table without these mistakes, which is equivalent to the arm; None if nothing explains the table."""
        if self.explanations:
            return self.explanations[0].corrected
        return self.table if self.verdict in {"right", "rounded"} else None

    @property
    def difference(self) -> str:
        """The largest difference between the uncorrected table and the arm, in words; empty if there is none or it is explained."""
        if self.verdict in {"right", "rounded"} or self.explanations:
            return ""
        return self.comparison.reason.replace("the first", "the table").replace("the second", "the arm")

    def __repr__(self) -> str:
        return f"Diagnosis({self.verdict!r}: {' '.join(str(self).splitlines())})"

    def __str__(self) -> str:
        if self.verdict in {"right", "rounded"}:
            return "\n".join(self._agreement())
        told = self._told_mistakes()
        rounding = f" The digits of its numbers ({self.rounding}) do not explain it." if self.rounding else ""
        if self.verdict == "undecided":
            cause = (
                f"its numbers may only be rounded ({self.rounding})" if self.rounding else "axes are nearly parallel"
            )
            also = ", or:" if told else "."
            lines = [
                f"Whether this table describes the arm cannot be decided: {cause}{also}",
                *(told or [self.difference]),
            ]
            return "\n".join(lines).rstrip()
        if told:
            return "\n".join(told)
        mistakes = "No known mistake, and no pair of them," if self.in_pairs else "No known mistake"
        lines = [f"{mistakes} was found that explains this table.{rounding} {self.difference}".rstrip()]
        if self.nearest is not None:
            lines += [
                f"It would describe the arm{self.up_to} with these numbers, the largest difference first:",
                *_different_entries(self.table, self.nearest),
            ]
        return "\n".join(lines)

    def _told_mistakes(self) -> list[str]:
        """Write the explanations, one in a line."""
        # Another number for the same entry is the same mistake.
        told = {
            tuple((fault.name, fault.row, fault.column) for fault in explanation.faults): explanation
            for explanation in reversed(self.explanations)
        }
        explanations = [*reversed(told.values())]
        texts = [[fault.text for fault in explanation.faults] for explanation in explanations]
        if not texts:
            return []
        if len(texts) == 1:
            lines = texts[0]
            if explanations[0].is_a_choice:
                lines = ["The table describes the arm after these changes of choices that are fixed here:", *lines]
            elif len(lines) > 1:  # other pairs may lead to the same motions, so this one is no fact
                lines = ["The table agrees with the arm after these changes:", *lines]
            return lines
        lines = ["Either: " + " ".join(texts[0]), *("or: " + " ".join(text) for text in texts[1:MAX_TOLD])]
        if len(texts) > MAX_TOLD:
            more = len(texts) - MAX_TOLD
            lines.append(f"({more} more {'is' if more == 1 else 'are'} as simple.)")
        return lines

    def _agreement(self) -> Iterator[str]:
        """Describe how well a table describes the arm, for the same q, and up to which choices."""
        digits = f" to the digits that are printed ({self.rounding})" if self.verdict == "rounded" else ""
        found = self.comparison
        choices = found.choices(self.tolerance)
        metres, radians = measured_difference(self.table.to_chain(), self.arm)
        differ = (
            f"differ by up to {format_number(metres, 3)} m and {format_number(math.degrees(radians), 3, zero=1e-6)}°, "
        )
        differ += "at 1000 random configurations."
        if not choices:
            yield f"This table describes the arm{digits}" + (f"; their poses {differ}" if digits else ".")
            return
        yield f"For the same q, the poses of the table and of the arm {differ}"
        yield f"The table describes the arm{digits}, up to these choices:"
        yield from (fault.text for fault in _choices_as_faults(self.table, found, self.tolerance))
        kinds = {name for name, _ in choices}
        if kinds & {"zeros", "signs"} and (texts := _singles_for_same_q(self.table, self.arm, kinds)):
            yield f"If q is meant to be the same: {' Or: '.join(texts)}"
        differing = ", ".join(f'"{name}"' for name in CHOICES if name in kinds)
        yield f"To count these as mistakes, pass fixed=[{differing}]."


def diagnose(
    table: Any,
    reference: Chain | DHTable,
    fixed: Collection[str] = (),
    *,
    convention: Convention | None = None,
    tolerance: float | None = None,
    in_pairs: bool = True,
) -> Diagnosis:
    """Find the mistakes in a table, given the arm that it is meant to describe.

    table      a DHTable; or its rows, as DHTable takes them, with `convention`
    fixed      what may not differ: any of "base", "tool", "zeros" and "signs". By default a table is right if it has the motions
               of the arm up to these four choices; with all four it is right only if its poses are those of the arm
    tolerance  how far the poses of a right table may be off, in metres and radians. By default 1e-8, and a table is not accused
               of what the rounding of its numbers explains, as far as their digits show
    in_pairs   whether pairs of mistakes are tried if no single one explains the table

    Raises ValueError if the first argument is not a table and the second not an arm, if the two have different numbers of
    joints, because then they cannot be compared, and for a name in fixed that is none of the four.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> printed = assign_frames(puma560(), convention="modified").table
    >>> print(diagnose(printed.changed(convention="standard"), puma560()))
    The table is in the modified convention, but was read as standard.
    """
    if convention is not None and not isinstance(table, DHTable | Chain):
        table = DHTable(table, convention=convention)
    if not isinstance(table, DHTable) or not isinstance(reference, Chain | DHTable):
        order = " They seem to be swapped." if isinstance(reference, DHTable) else ""
        raise ValueError(
            "diagnose takes a DHTable, or rows and convention=..., and the arm that it should describe, diagnose(table, arm); "
            f"got {type(table).__name__} and {type(reference).__name__}.{order}"
        )
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if table.n != arm.n:
        raise ValueError(
            f"The table must have as many joints as the arm, {arm.n} ({arm.joint_types}); it has {table.n} ({table.joints})."
        )
    fixed = frozenset(fixed)
    exact = EQUIVALENCE_TOL if tolerance is None else tolerance
    comparison = equivalent(table, arm, fixed=fixed, tolerance=exact)
    found = Diagnosis("wrong", table, arm, comparison, tolerance=exact, in_pairs=in_pairs)
    if comparison.verdict == "same":
        return replace(found, verdict="right")
    half_unit, noise, rounding = np.zeros(table.rows.shape), exact, _Rounding("excluded", comparison)
    if tolerance is None and table.joints.replace("F", "") == arm.joint_types:
        half_unit, words = typed_half_units(table.rows)
        noise = max(rounding_effect(table, half_unit), exact)
        rounding = _judge_rounding(table, arm, fixed, half_unit, noise)
        found = replace(found, rounding=words)
    if rounding.verdict == "rounded":
        return replace(found, verdict="rounded", comparison=rounding.comparison, tolerance=noise)
    if comparison.verdict == "undecided":
        return replace(found, verdict="undecided")
    return _explained(found, reference, fixed, half_unit, noise, rounding)


def _explained(  # noqa: PLR0917
    found: Diagnosis,
    reference: Chain | DHTable,
    fixed: frozenset[str],
    half_unit: Array,
    noise: float,
    rounding: _Rounding,
) -> Diagnosis:
    """Explain a table that differs from the arm: exactly, or else through the noise that its rounded numbers have."""
    table, exact = found.table, found.tolerance
    bounds = [(exact, 2 if found.in_pairs else 1)]
    if noise > exact and rounding.comparison.verdict != "same":
        if np.abs(table.rows[:, [0, 2]]).max() > MIN_LENGTH_MM:  # in case that they are in millimetres
            in_metres = table.changed(rows=table.rows * (1e-3, 1, 1e-3, 1))
            noise = max(rounding_effect(in_metres, typed_half_units(in_metres.rows)[0]), exact)
        bounds += [(noise, 1)] * (exact < noise <= MAX_ROUNDED_TOL)
    explanations: list[TableExplanation] = []
    for bound, count in bounds:
        explanations = [
            each for each in _explain(table, reference, fixed, bound, count) if not _needs_rounding(each, half_unit)
        ]
        if explanations:
            break
    # No choices are fewer changes than a single entry.
    is_simple = any(len(each.faults) == 1 and _count_edits(each) <= 1 for each in explanations)
    unfixed = None
    for bound, _ in bounds if fixed and not is_simple else ():
        near = equivalent(table, found.arm, tolerance=bound)
        unfixed = near if unfixed is None else unfixed
        if near.verdict == "same":
            explanations = _with_choices(explanations, table, near, bound)
            break
    found = replace(found, explanations=explanations, unfixed=unfixed)
    # Where coarse rounding may be the cause, only a single mistake that invents no numbers outweighs it.
    if rounding.verdict == "possible" and not any(
        len(each.faults) == 1 and _is_plain(each, half_unit) for each in explanations
    ):
        return replace(found, verdict="undecided")
    if explanations or "H" in found.arm.joint_types:
        return found
    nearest, up_to = _nearest_table(table, found.arm, fixed, half_unit, noise), ""
    if nearest is None and fixed:
        nearest, up_to = (
            _nearest_table(table, found.arm, frozenset(), half_unit, noise),
            f", up to {', '.join(CHOICES)},",
        )
    places = [] if nearest is None else _different_places(table, nearest)
    if nearest is not None and np.abs(nearest.rows - table.rows).max() < NEARLY_PARALLEL_LOSS:
        return replace(found, verdict="undecided")  # as small as what nearly parallel axes lose
    if nearest is not None and len(places) <= bounds[0][1] and not up_to:
        faults = [_wrong_number(table, nearest, row, column) for row, column in places]
        return replace(found, explanations=[TableExplanation(faults, table, nearest)])
    return replace(found, nearest=nearest, up_to=up_to)


@dataclass(frozen=True)
class _Rounding:
    """Whether the rounding of the numbers explains why a table does not have the poses of an arm, and the comparison within it."""

    verdict: Literal["rounded", "possible", "excluded"]
    comparison: Equivalence


def _judge_rounding(table: DHTable, arm: Chain, fixed: frozenset[str], half_unit: Array, effect: float) -> _Rounding:
    """Judge whether numbers that round to those of the table describe the arm."""
    near = equivalent(table, arm, fixed=fixed, tolerance=effect)
    sines = neighbours(arm.lines)[0]
    smallest = sines[sines > PARALLEL_TOL_RAD].min(initial=1.0)
    if near.verdict == "different" and effect <= 0.1 * smallest:
        return _Rounding("excluded", near)
    if near.verdict == "same":
        start = JointMap(near.base, near.tool, near.signs, near.offsets)
        fit = nearest_rows(table, arm, start, fixed, half_unit, few=False)
        if fit and fit.difference <= max(EQUIVALENCE_TOL, 1e-2 * effect):
            is_bounded = np.ones(table.rows.shape, bool)
            for entry in joint_entries(table.joints) if "zeros" not in fixed else ():
                is_bounded[entry] = False
            off = np.abs((fit.rows - table.rows) / half_unit)[is_bounded]
            if off.max() <= MAX_HALF_UNITS:
                return _Rounding("rounded", near)
            # No numbers within their half units have a smaller sum of squares than these.
            if np.linalg.norm(off) > 1.05 * math.sqrt(off.size) and smallest > 0.1:
                return _Rounding("excluded", near)
    return _Rounding("possible", near)


def _needs_rounding(explanation: TableExplanation, half_unit: Array) -> bool:
    """Whether one of the mistakes is a number that only has fewer decimals than it should have."""
    is_close = np.abs(explanation.corrected.rows - explanation.table.rows) <= 1.05 * half_unit
    return any(
        is_close[fault.row - 1, COLUMNS.index(fault.column)]
        for fault in explanation.faults
        if fault.name in NUMBERS and fault.row and fault.column
    )


def _is_plain(explanation: TableExplanation, half_unit: Array) -> bool:
    """Whether an explanation is a usual mistake, or one number whose correction has as few digits as the others."""
    if explanation.is_a_choice or explanation.faults[0].name == "columns in another order":
        return False
    if explanation.faults[0].name not in NUMBERS:
        return True
    rows, changed = explanation.corrected.rows, explanation.corrected.rows != explanation.table.rows
    unit = 2 * half_unit[changed]
    return bool((np.abs(rows[changed] - np.round(rows[changed] / unit) * unit) < 1e-9).all())


def _with_choices(
    explanations: list[TableExplanation], table: DHTable, near: Equivalence, tolerance: float
) -> list[TableExplanation]:
    """Return the choices up to which a table is right in place of explanations that make more changes."""
    faults = _choices_as_faults(table, near, tolerance)
    rows, signs = table.rows.copy(), table.signs.copy()
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        rows[row, column] += table.signs[row] * near.offsets[joint]
        signs[row] *= near.signs[joint]
    corrected = table.changed(rows=rows, signs=signs, base=near.base @ table.base, tool=table.tool @ near.tool)
    choice = TableExplanation(faults, table, corrected, is_a_choice=True)
    if not explanations or any(_says_as_much(each, choice) for each in explanations):
        return explanations or [choice] * bool(faults)
    edits, changes = _count_edits(explanations[0]), sum(map(_weight, faults))
    is_pair = len(explanations[0].faults) > 1
    return [choice] if changes < edits or (changes == edits and is_pair) else explanations


def _count_edits(explanation: TableExplanation) -> int:
    """Count the entries that an explanation changes; a pose or an invented number counts as one more."""
    edits = int(np.sum(explanation.corrected.rows != explanation.table.rows))
    return edits + sum(_weight(fault) - 1 for fault in explanation.faults)


def _weight(fault: Fault) -> int:
    """How many edits a fault counts as, beside the entries that it changes: a pose or an invented number is two."""
    return 2 if fault.name in {*NUMBERS, "wrong base", "wrong tool"} else 1


def _choices_as_faults(table: DHTable, found: Equivalence, tolerance: float) -> list[Fault]:
    """Write the choices in which a table differs from an arm as corrections, each with its numbers."""
    faults = []
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        name, place = COLUMNS[column], f"joint {joint + 1}"
        letter = table.joints[row]
        if text := format_offset(letter, float(table.signs[row] * found.offsets[joint]), tolerance):
            base = " (or rotate the base by as much about axis 1)" if joint == 0 and letter == "R" else ""
            faults.append(Fault("another zero", f"{place}: add {text} to {name}{base}.", row + 1, name))
        if found.signs[joint] < 0:
            sign = "-" if table.signs[row] > 0 else "+"
            text = f"{place}: write {sign}q in {name}, because q counts in the opposite direction."
            faults.append(Fault("sign of q", text, row + 1, name))
    for end, own, T in (("base", table.base, found.base @ table.base), ("tool", table.tool, table.tool @ found.tool)):
        if np.abs(T - own).max() > tolerance:
            faults.append(_wrong_end(end, own, T, tolerance))
    return faults


def _wrong_end(end: str, typed: Array, right: Array, tolerance: float) -> Fault:
    """Describe a wrong base or tool."""
    name = {"base": "The base T_s0", "tool": "The tool transform"}[end]
    is_missing = np.abs(typed - np.eye(4)).max() < EQUIVALENCE_TOL
    is_inverted = np.abs(typed @ right - np.eye(4)).max() < TYPED_POSE_TOL
    what = "is missing" if is_missing else "is inverted" if is_inverted else "is wrong"
    return Fault(f"wrong {end}", f"{name} {what}: it should be {describe_pose(right, tolerance)}.")


def _singles_for_same_q(table: DHTable, arm: Chain, kinds: Collection[str]) -> list[str]:
    """Return the single mistakes that explain a table for the same q, up to a base and a tool that differ anyway."""
    found = _explain(table, arm, frozenset(CHOICES) - ({"base", "tool"} & {*kinds}), EQUIVALENCE_TOL, 1)
    texts = [each.faults[0].text for each in found if each.faults[0].name not in {*NUMBERS, "wrong base", "wrong tool"}]
    return texts[:MAX_TOLD]


def _nearest_table(
    table: DHTable, arm: Chain, fixed: frozenset[str], half_unit: Array, effect: float
) -> DHTable | None:
    """Find the table with few other numbers that describes the arm, beginning with the maps that fit roughly."""
    if table.joints.replace("F", "") != arm.joint_types:
        return None
    own = table.to_chain()
    rough = sorted(joint_maps(own, arm, fixed, ROUGH), key=lambda each: each.difference)[:2]
    unit = np.maximum(half_unit, 1e-6)
    for start in [identity_map(own, arm), *rough]:
        fit = nearest_rows(table, arm, start, fixed, unit, few=True)
        if fit and fit.difference <= max(effect, 1e-6):
            # A change below half a unit of the last digit is none, and two digits more than the table has are enough.
            finest = 10.0 ** np.floor(np.log10(unit / 50))
            rows = np.where(np.arange(4) % 2, fit.rows, np.round(fit.rows / finest) * finest)
            rows = np.where(np.abs(fit.rows - table.rows) <= 1.05 * half_unit, table.rows, rows)
            variables = joint_entries(table.joints) if "zeros" not in fixed else ()
            for entry in variables:
                rows[entry] = table.rows[entry]
            nearest = table.changed(rows=rows)
            if equivalent(nearest, arm, fixed=fixed, tolerance=max(effect, 1e-6)).verdict == "same":
                return nearest
    return None


def _different_places(table: DHTable, right: DHTable) -> list[tuple[int, int]]:
    """The places of the entries in which two tables differ, the largest difference first."""
    off = np.abs(right.rows - table.rows)
    return sorted(((i, j) for i, j in np.argwhere(off > 0).tolist()), key=lambda place: -off[place])


def _wrong_number(table: DHTable, right: DHTable, row: int, column: int) -> Fault:
    should, has = format_entries(float(right.rows[row, column]), float(table.rows[row, column]), column)
    text = f"Row {row + 1}: {COLUMNS[column]} should be {should}; the table has {has}."
    return Fault("wrong number", text, row + 1, COLUMNS[column])


def _different_entries(table: DHTable, right: DHTable) -> list[str]:
    """Write the entries in which two tables differ, the largest difference first."""
    places = _different_places(table, right)
    lines = [_wrong_number(table, right, *place).text for place in places[:MAX_DIFFERENT_ENTRIES]]
    more = len(places) - MAX_DIFFERENT_ENTRIES
    return lines + [f"({more} more differ by less.)"] * (more > 0)


def _explain(
    table: DHTable, reference: Chain | DHTable, fixed: frozenset[str], tolerance: float, max_faults: int
) -> list[TableExplanation]:
    """Return all explanations of a table with the smallest number of faults and of edited entries."""
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if "H" in arm.joint_types:
        return []
    # A wrong frame at an end is the mistake that remains if the table describes the arm up to this frame.
    possible = [end for end in ("base", "tool") if end in fixed]
    frames = [ends for count in range(3) for ends in combinations(possible, count)]
    # If the joint types differ, no other correction can help without these.
    searches = [
        _Search(table, tuple(start), reference, arm, fixed, tolerance)
        for start in corrections_of_joint_types(table, arm.joint_types)
    ]

    def numbers(explanation: TableExplanation) -> int:
        return sum(fault.name in NUMBERS for fault in explanation.faults)

    def is_end_wrong(explanation: TableExplanation) -> bool:
        return any(fault.name in {"wrong base", "wrong tool"} for fault in explanation.faults)

    for count in range(1, max_faults + 1):
        found: list[TableExplanation] = []
        for ends in frames:
            # What moves a frame moves whole arms, so mistakes in the rows come first, unless they are invented numbers.
            if len(ends) <= count and not any(numbers(each) == 0 for each in found):
                found += [each for search in searches for each in search.explanations(count - len(ends), ends)]
        if found:
            return sorted(found, key=lambda each: numbers(each) > 0 or not is_end_wrong(each))
    return []


@dataclass(frozen=True, eq=False)
class _Search:
    """The search for the simplest corrections of a table: a list of candidates, a filter by invariants, a price, a comparison.

    start  the corrections that give the table the joint types of the arm; they are part of every candidate
    """

    table: DHTable
    start: Corrections
    reference: Chain | DHTable
    arm: Chain
    fixed: frozenset[str]
    tolerance: float

    def explanations(self, count: int, ends: tuple[str, ...]) -> list[TableExplanation]:
        """Return the explanations by this number of faults in the rows, and wrong frames at these ends, with the smallest price."""
        more = count - len(self.start)
        if more < 0:
            return []
        fixed = self.fixed - {*ends}
        added: Iterable[Corrections] = (
            [(), ((single,) for single in self._singles), self._pairs()][more] if more else [()]
        )
        candidates = [self.start + each for each in added]
        agree = self._may_agree(candidates, fixed)
        priced = sorted(
            (self._price(candidate), k)
            for k, candidate in enumerate(candidates)
            if agree[k] and (ends or self.start or self._is_edit(candidate))
        )
        found: list[tuple[float, Corrections, TableExplanation]] = []
        for price, k in priced[:MAX_COMPARED]:
            if found and price[0] > found[0][0]:
                break
            try:
                corrected = corrected_table(self.table, candidates[k])
            except ValueError:  # for example an angle of many turns, which no table has
                continue
            compared = equivalent(corrected, self.arm, fixed=fixed, tolerance=self.tolerance)
            if compared.verdict == "same":
                right = {"base": compared.base @ corrected.base, "tool": corrected.tool @ compared.tool}
                faults = [each.fault for each in candidates[k]]
                faults += [_wrong_end(end, getattr(corrected, end), right[end], self.tolerance) for end in ends]
                explanation = TableExplanation(
                    faults, self.table, corrected.changed(**{end: right[end] for end in ends})
                )
                if not any(_says_as_much(other, explanation) for _, _, other in found):
                    found.append((price[0], candidates[k], explanation))
        return [explanation for _, _, explanation in found]

    def _price(self, candidate: Corrections) -> tuple[float, float, float]:
        """The number of edits, where an invented number counts twice; how many of these; and how large and unusual the change is."""
        rows = corrected_rows(self.table.rows, candidate)
        changed = np.abs(rows - self.table.rows) > 1e-12
        numbers = sum(each.fault.name in NUMBERS for each in candidate)
        labels = sum(bool(each.convention) + len(each.letters) + bool(each.reversed) for each in candidate)
        # Every entry of a column has to be wrong in the same way: a single entry is the simpler explanation.
        columns = sum(each.fault.row is None and each.fault.name.startswith("sign of") for each in candidate)
        # Two rows that change places are two edits, however many entries they have.
        is_swap = any(each.fault.name == "rows swapped" for each in candidate)
        edits = min(int(changed.sum()), 2) if is_swap else int(changed.sum())
        # A wrong number is often near the right one. In most tables the lengths have one sign.
        size = float(np.abs(rows - self.table.rows)[changed].sum()) if numbers else 0.0
        return edits + numbers + labels + columns, numbers, round(size + 1e-3 * int((rows[:, [0, 2]] < 0).sum()), 9)

    def _is_edit(self, candidate: Corrections) -> bool:
        """Whether corrections edit anything. Without a change, the table is the one that has been compared already."""
        if any(each.convention or each.letters or each.reversed for each in candidate):
            return True
        return bool((np.abs(corrected_rows(self.table.rows, candidate) - self.table.rows) > 1e-12).any())

    @cached_property
    def _singles(self) -> list[Correction]:
        """The known corrections, without those that edit nothing, such as swapping two equal rows."""
        right = [assign_frames(self.arm, convention=self.table.convention).table.rows]
        if isinstance(self.reference, DHTable):
            right.append(self.reference.converted(self.table.convention).rows)
        numbers = right[-1] if len(right[-1]) == len(self.table.rows) else right[0]
        known = corrections(self.table, numbers, "zeros" in self.fixed, "signs" in self.fixed)
        return [each for each in known if self._is_edit((each,))]

    @cached_property
    def _invariants(self) -> AxisInvariants:
        return AxisInvariants(self.arm, FILTER_TOL_FACTOR * self.tolerance)

    def _pairs(self) -> Iterator[Corrections]:
        """Yield the pairs of which each one changes every invariant that is wrong without it."""
        values = self._values([(single,) for single in self._singles])
        violated = self._invariants.violated(values).astype(float)
        unchanged = np.isclose(values, self._values([()]), rtol=1e-9, atol=1e-10).astype(float)
        possible = violated @ unchanged.T == 0
        for one, two in np.argwhere(np.triu(possible & possible.T, 1))[:MAX_PAIRS]:
            first, second = self._singles[one], self._singles[two]
            if not (first.convention and second.convention) and not first.reversed & second.reversed:
                yield first, second

    def _values(self, candidates: Sequence[Corrections]) -> Array:
        """Compute the invariants of the corrected tables, (N, k)."""
        return self._of_all(candidates, lambda table, rows: self._invariants.of(*joint_axes(table, rows)))

    def _may_agree(self, candidates: Sequence[Corrections], fixed: frozenset[str]) -> Booleans:
        """Return which of the corrected tables can be the arm, as far as their invariants and the poses of a few q show it."""
        if not candidates:
            return np.zeros(0, bool)
        agree = self._invariants.agree(self._values(candidates), "signs" in fixed)
        if fixed >= {"zeros", "signs"}:
            q = random_configurations(self.arm.n, 4)
            poses = self._of_all(candidates, lambda table, rows: table_poses(table, rows[:, None], q))
            agree &= _same_motion(poses, self.arm.fk(q), fixed, FILTER_TOL_FACTOR * self.tolerance)
        return agree

    def _of_all(self, candidates: Sequence[Corrections], compute: Any) -> Array:
        """Compute something from the rows of all corrected tables (N, m, 4), for those of one convention and signs at a time."""
        other = OTHER_CONVENTION[self.table.convention]
        groups: dict[tuple[Convention, frozenset[int]], list[int]] = {}
        for k, candidate in enumerate(candidates):
            convention = other if any(each.convention for each in candidate) else self.table.convention
            groups.setdefault((convention, frozenset().union(*(each.reversed for each in candidate))), []).append(k)
        letters = dict(enumerate(self.table.joints))
        for each in self.start:
            letters |= each.letters
        values: dict[int, Array] = {}
        for (convention, reversed_rows), members in groups.items():
            signs = np.where([row in reversed_rows for row in range(len(self.table.rows))], -1, 1) * self.table.signs
            table = self.table.changed(convention=convention, signs=signs, joints="".join(letters.values()))
            rows = np.array([corrected_rows(self.table.rows, candidates[k]) for k in members])
            values.update(zip(members, compute(table, rows), strict=True))
        return np.array([values[k] for k in range(len(candidates))])


def _says_as_much(one: TableExplanation, other: TableExplanation) -> bool:
    """Whether an explanation that was found leads to the table of another one."""
    a, b = one.corrected, other.corrected
    return (a.convention, a.joints, a.signs.tolist()) == (b.convention, b.joints, b.signs.tolist()) and bool(
        np.abs(a.rows - b.rows).max() < 1e-9
    )


def _same_motion(poses: Array, right: Array, fixed: frozenset[str], loose: float) -> Booleans:
    """Return which poses (N, k, 4, 4) are the right ones (k, 4, 4) up to the frames at the ends that are free."""
    motions = []
    for T in (poses, right):
        start = T[..., :1, :, :]
        if fixed >= {"base", "tool"}:
            motions.append(T)
        elif "base" in fixed:
            motions.append(T[..., 1:, :, :] @ np.linalg.inv(start))
        elif "tool" in fixed:
            motions.append(np.linalg.inv(start) @ T[..., 1:, :, :])
        else:
            motions.append(np.trace(T[..., 1:, :3, :3] @ np.swapaxes(start[..., :3, :3], -1, -2), axis1=-2, axis2=-1))
    ours, theirs = motions[0].reshape(len(poses), -1), motions[1].reshape(1, -1)
    same: Booleans = np.abs(ours - theirs).max(axis=-1) <= loose
    return same
