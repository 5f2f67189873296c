"""Diagnose a DH table: find the mistake, or the two mistakes, that explain why it does not describe a given arm.

Every known mistake is corrected in turn, in every row where it could have been made. If the corrected table has the motions of
the arm, up to the choices that are free, the mistake explains the table. One mistake is preferred to two, then the fewest
edited entries; a wrong number counts as one entry more, because some number explains almost anything. If several explanations
are equally simple, all of them are returned.

Most corrections are refuted by the invariants of the axes, for all of them at once, and only the rest is compared in full.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations, pairwise
from typing import Literal

import numpy as np

from kinlib.arrays.tolerances import EQUIVALENCE_TOL
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import CHOICES, Equivalence, describe_pose, equivalent
from kinlib.dh.invariants import AxisInvariants, Booleans
from kinlib.dh.mistakes import (
    ALPHA,
    ANGLES,
    LENGTHS,
    NUMBERS,
    OTHER_CONVENTION,
    Correction,
    D,
    Fault,
    corrected_rows,
    corrections_of_joint_types,
    known_corrections,
)
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.printed_digits import ALMOST_1, Rounding, judge_rounding
from kinlib.dh.table import Convention, DHTable, _joint_axes, _table_poses

MAX_TOLD = 3
"""How many equally simple explanations the text lists."""

MAX_COMPARED = 15
"""How many corrected tables, of those whose invariants agree, are compared with the arm in full."""

MAX_WRONG_ANGLES = 2
"""How many angles between neighbouring axes a single mistake makes wrong at most, apart from one in the whole table."""

MAX_PAIRS = 20_000
"""How many pairs of mistakes are tried."""

MAX_ROUNDED_TOL = 1e-2
"""If the rounding of a table's numbers changes its poses by more than this, mistakes are not looked for through it."""

TYPED_POSE_TOL = 1e-6
"""How far the inverse of a pose may be off that a person typed."""

FILTER_TOL_FACTOR = 3
"""How many times the tolerance an invariant may be off before a correction is refuted by it."""

Corrections = tuple[Correction, ...]


@dataclass(frozen=True, eq=False)
class TableExplanation:
    """Mistakes that together explain a table.

    faults     the mistakes
    table      the table with them
    corrected  the table without them, which describes the arm up to the choices that are not fixed
    """

    faults: Sequence[Fault]
    table: DHTable
    corrected: DHTable


@dataclass(frozen=True, eq=False, repr=False)
class Diagnosis:
    """The result of a diagnosis.

    verdict       "right"; "rounded", if the table differs from the arm by no more than its numbers are rounded; "undecided", if
                  rounding or nearly parallel axes may explain the difference, and no mistake does; or "wrong"

    table         the table that was diagnosed
    comparison    of this table and the arm, up to the choices that are free
    explanations  all explanations that are equally simple, the most plausible one first; empty if the table is right
    tolerance     differences below it are not mentioned
    unfixed       the comparison up to every choice, if some of them are fixed and the table is not right
    in_pairs      whether pairs of mistakes were tried
    rounding      how far the numbers of a table that is not right may be off, read from their digits; None with a given tolerance
    """

    table: DHTable
    comparison: Equivalence
    explanations: Sequence[TableExplanation] = ()
    tolerance: float = EQUIVALENCE_TOL
    unfixed: Equivalence | None = None
    in_pairs: bool = True
    rounding: Rounding | None = None

    @property
    def verdict(self) -> Literal["right", "rounded", "undecided", "wrong"]:
        """What is known of the table; only a wrong one is accused of mistakes."""
        rounding = self.rounding
        if self.comparison.verdict == "same":
            return "right"
        if rounding and rounding.verdict == "explains":
            return "rounded"
        if rounding and rounding.verdict == "possible":
            # Where coarse rounding may be the cause, only a single mistake that invents no numbers outweighs it.
            return "wrong" if any(_is_plain(each, rounding) for each in self.explanations) else "undecided"
        return "undecided" if self.comparison.verdict == "undecided" and not self.explanations else "wrong"

    @property
    def faults(self) -> Sequence[Fault]:
        """The mistakes of the first explanation; empty if the table is right or nothing explains it. Possible ones if undecided."""
        return self.explanations[0].faults if self.explanations else ()

    @property
    def corrected(self) -> DHTable | None:
        """The table without these mistakes, which is equivalent to the arm; None if nothing explains the table."""
        if self.explanations:
            return self.explanations[0].corrected
        return self.table if self.verdict in {"right", "rounded"} else None

    @property
    def difference(self) -> str:
        """The first difference between the uncorrected table and the arm, in words; empty if there is none or it is explained."""
        if self.verdict in {"right", "rounded"} or self.explanations:
            return ""
        if self.unfixed and self.unfixed.verdict == "same":
            choices = " ".join(text for _, text in self.unfixed.choices(self.tolerance))
            return f"The table describes the arm only up to choices that are fixed here. {choices}".rstrip()
        return self.comparison.reason.replace("the first", "the table").replace("the second", "the arm")

    def __repr__(self) -> str:
        return f"Diagnosis({self.verdict!r}: {' '.join(str(self).splitlines())})"

    def __str__(self) -> str:
        if self.verdict in {"right", "rounded"}:
            return self._describe_agreement()
        limit = self.rounding.limit if self.rounding else ""
        if self.verdict == "undecided":
            told = self._told_mistakes()
            also = (
                "either its numbers are only rounded, or:\n" + "\n".join(told)
                if told
                else "no known mistake explains it."
            )
            return (
                f"Whether this table describes the arm cannot be decided: {also}\n{limit or self.difference}".rstrip()
            )
        if not self.explanations:
            mistakes = "No known mistake, and no pair of them," if self.in_pairs else "No known mistake"
            return f"{mistakes} was found that explains this table. {self.difference} {limit}".rstrip()
        return "\n".join([*self._told_mistakes(), *([limit] if limit else [])])

    def _told_mistakes(self) -> list[str]:
        """Write the explanations, one in a line."""
        if not self.explanations:
            return []
        # Another number for the same entry is the same mistake.
        told = {
            tuple((fault.name, fault.row, fault.column) for fault in explanation.faults): explanation
            for explanation in reversed(self.explanations)
        }
        texts = [[fault.text for fault in explanation.faults] for explanation in reversed(told.values())]
        lines = texts[0]
        if len(texts) == 1 < len(lines):  # other pairs may lead to the same motions, so this one is no fact
            lines = ["The table agrees with the arm after these changes:", *lines]
        if len(texts) > 1:
            lines = ["Either: " + " ".join(texts[0]), *("or: " + " ".join(text) for text in texts[1:MAX_TOLD])]
        if len(texts) > MAX_TOLD:
            more = len(texts) - MAX_TOLD
            lines.append(f"({more} more {'is' if more == 1 else 'are'} as simple.)")
        return lines

    def _describe_agreement(self) -> str:
        """Describe how well a table describes the arm, and up to which choices."""
        comparison, tolerance, accuracy = self.comparison, self.tolerance, ""
        if self.rounding:
            comparison, tolerance = self.rounding.nearest, max(self.rounding.effect, tolerance)
            digits = (
                f"the rounding of its numbers ({self.rounding.units})" if self.rounding.units else "double precision"
            )
            accuracy = f" to within {digits}; its poses differ by up to "
            accuracy += f"{comparison.difference:.2g}"
        choices = comparison.choices(tolerance)
        lines = [f"This table describes the arm{accuracy}{', up to these choices:' if choices else '.'}"]
        lines += [text for _, text in choices]
        if choices:
            differing = ", ".join(f'"{name}"' for name in CHOICES if name in dict(choices))
            lines += [f"A table that differs in them is wrong if you pass fixed=[{differing}]."]
        return "\n".join(lines)


def diagnose(
    table: DHTable,
    reference: Chain | DHTable,
    fixed: Collection[str] = (),
    *,
    tolerance: float | None = None,
    in_pairs: bool = True,
) -> Diagnosis:
    """Find the mistakes in a table, given the arm that it is meant to describe.

    fixed     what may not differ: any of "base", "tool", "zeros" and "signs". By default a table is right if it has the motions
              of the arm up to these four choices; with all four it is right only if its poses are those of the arm
    tolerance how far the poses of a right table may be off, in metres and radians. By default 1e-8, and a table is not accused
              of what the rounding of its numbers explains, as far as their digits show
    in_pairs  whether pairs of mistakes are tried if no single one explains the table

    Raises ValueError if the first argument is not a table and the second not an arm, if the two have different numbers of
    joints, because then they cannot be compared, and for a name in fixed that is none of the four.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> printed = assign_frames(puma560(), convention="modified").table
    >>> print(diagnose(printed.changed(convention="standard"), puma560()))
    The table is in the modified convention, but was read as standard.
    """
    kinds = ((table, DHTable), (reference, (Chain, DHTable)))
    if not all(isinstance(given, kind) for given, kind in kinds):
        order = " They seem to be swapped." if isinstance(reference, DHTable) else ""
        raise ValueError(
            "diagnose takes a DHTable and the arm that it should describe, diagnose(table, arm); "
            f"got {type(table).__name__} and {type(reference).__name__}.{order}"
        )
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if table.n != arm.n:
        raise ValueError(
            f"The table must have as many joints as the arm, {arm.n} ({arm.joint_types}); it has {table.n} ({table.joints})."
        )
    fixed = frozenset(fixed)
    bound = EQUIVALENCE_TOL if tolerance is None else tolerance
    comparison = equivalent(table, arm, fixed=fixed, tolerance=bound)
    found = Diagnosis(table, comparison, (), bound, in_pairs=in_pairs)
    if comparison.verdict == "same":
        return found
    rounding = None
    if tolerance is None and table.joints.replace("F", "") == arm.joint_types:
        rounding = judge_rounding(table, arm, fixed)
        found = replace(found, rounding=rounding)
    if found.verdict == "rounded" or comparison.verdict == "undecided":
        return found
    explanations = _explain(table, reference, fixed, bound, 2 if in_pairs else 1)
    if rounding:
        if any(_is_rounding(explanation, rounding) for explanation in explanations):
            return replace(found, rounding=replace(rounding, verdict="explains"))
        explanations = [each for each in explanations if not _needs_rounding(each, rounding)]
        is_beyond = rounding.verdict == "excluded" and rounding.nearest.verdict == "different"
        if not explanations and is_beyond and bound < rounding.effect <= MAX_ROUNDED_TOL:
            explanations = _explain(table, reference, fixed, rounding.effect, 1)
    unfixed = equivalent(table, arm, tolerance=bound) if fixed else None
    return replace(found, explanations=explanations, unfixed=unfixed)


def _is_plain(explanation: TableExplanation, rounding: Rounding) -> bool:
    """Whether an explanation is a single usual mistake, or one number whose correction has as few digits as the others.

    Rounding leads to such a number by chance only.
    """
    if len(explanation.faults) != 1 or explanation.faults[0].name == "columns in another order":
        return False
    rows, changed = explanation.corrected.rows, explanation.corrected.rows != explanation.table.rows
    unit = np.broadcast_to(2 * rounding.half_unit, rows.shape)[changed]
    step = np.where(unit > 0, unit, 1.0)
    has_few_digits = (unit > 0) & (np.abs(rows[changed] - np.round(rows[changed] / step) * step) < 1e-9)
    return explanation.faults[0].name not in NUMBERS or bool(has_few_digits.all())


def _is_rounding(explanation: TableExplanation, rounding: Rounding) -> bool:
    """Whether an explanation changes no number by more than its rounding."""
    corrected, table = explanation.corrected, explanation.table
    if corrected.changed(rows=table.rows) != table:
        return False  # something else than a number was corrected
    return bool((np.abs(corrected.rows - table.rows) <= ALMOST_1 * rounding.half_unit).all())


def _needs_rounding(explanation: TableExplanation, rounding: Rounding) -> bool:
    """Whether one of several mistakes is a number that only has fewer decimals than it should have."""
    corrected, table = explanation.corrected, explanation.table
    is_close = np.abs(corrected.rows - table.rows) <= ALMOST_1 * rounding.half_unit
    return any(
        is_close[fault.row - 1, COLUMNS.index(fault.column)]
        for fault in explanation.faults
        if fault.name in NUMBERS and fault.row and fault.column
    )


def _explain(
    table: DHTable, reference: Chain | DHTable, fixed: frozenset[str], tolerance: float, max_faults: int
) -> list[TableExplanation]:
    """Return all explanations of a table with the smallest number of faults and of edited entries."""
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if "H" in arm.joint_types:
        return []
    # If the joint types differ, no other correction can help without these.
    starts = []
    for start in corrections_of_joint_types(table, arm.joint_types):
        letters = dict(enumerate(table.joints))
        for correction in start:
            letters |= correction.letters
        starts.append((table.changed(joints="".join(letters.values())), start))
    # A wrong frame at an end is the mistake that remains if the table describes the arm up to this frame.
    possible = [end for end in ("base", "tool") if end in fixed]
    frames = [ends for count in range(3) for ends in combinations(possible, count)]
    searches = {
        ends: [_Search(with_types, start, reference, arm, fixed, tolerance, ends) for with_types, start in starts]
        for ends in frames
    }

    def numbers(explanation: TableExplanation) -> int:
        return sum(fault.name in NUMBERS for fault in explanation.faults)

    def is_end_wrong(explanation: TableExplanation) -> bool:
        return any(fault.name in {"wrong base", "wrong tool"} for fault in explanation.faults)

    for count in range(1, max_faults + 1):
        found: list[TableExplanation] = []
        for ends in frames:
            # What moves a frame moves whole arms, so mistakes in the rows come first, unless they are invented numbers.
            if len(ends) <= count and not any(numbers(each) == 0 for each in found):
                found += [each for search in searches[ends] for each in search.explanations(count - len(ends))]
        # With free zeros too many tables fit: only where these count, two steps say something.
        if count == 2 and "zeros" in fixed and not any(numbers(each) == 0 for each in found):
            found += [each for search in searches[()] for each in search.explanations_in_two_steps()]
        if found:
            return sorted(found, key=lambda each: numbers(each) > 0 or not is_end_wrong(each))
    return []


@dataclass(frozen=True, eq=False)
class _Search:
    """The search for the simplest corrections of a table, which has the joint types of the arm after those at the start.

    ends  the frames that are wrong too, of "base" and "tool"; their mistakes are added to each explanation
    """

    table: DHTable
    start: Corrections
    reference: Chain | DHTable
    arm: Chain
    all_fixed: frozenset[str]
    tolerance: float
    ends: tuple[str, ...] = ()

    @property
    def fixed(self) -> frozenset[str]:
        """What may not differ, apart from the frames that are wrong."""
        return self.all_fixed - set(self.ends)

    def explanations(self, count: int) -> list[TableExplanation]:
        """Return the explanations by this number of faults in the rows with the fewest edited entries."""
        more = count - len(self.start)
        if more < 0:
            return []
        added: Iterable[Corrections] = [()]
        if more:
            added = self._pairs() if more == 2 else ((single,) for single in self._singles)
        candidates = [self.start + corrections for corrections in added]
        candidates = [c for c in candidates if all(_can_combine(*pair) for pair in pairwise(c))]
        agree = self._may_agree(candidates)
        priced = [
            (self._price(c), k, c)
            for k, (c, possible) in enumerate(zip(candidates, agree, strict=True))
            if possible and (self._edits(c) or self.ends)
        ]
        found: dict[Corrections, DHTable] = {}
        wrong_ends: dict[Corrections, list[Fault]] = {}
        price = 0.0
        for (entries, *_), _, corrections in sorted(priced)[:MAX_COMPARED]:
            if found and entries > price:
                break
            try:
                corrected = self._corrected(corrections)
            except ValueError:  # for example an angle of many turns, which no table has
                continue
            compared = equivalent(corrected, self.arm, fixed=self.fixed, tolerance=self.tolerance)
            if compared.verdict == "same":
                right = {"base": compared.base @ corrected.base, "tool": corrected.tool @ compared.tool}
                wrong_ends[corrections] = [_wrong_end(end, getattr(corrected, end), right[end]) for end in self.ends]
                found[corrections], price = corrected.changed(**{end: right[end] for end in self.ends}), entries
        return [
            TableExplanation([*(c.fault for c in kept), *wrong_ends[kept]], self.table, found[kept])
            for kept in self._without_details(list(found))
        ]

    def explanations_in_two_steps(self) -> list[TableExplanation]:
        """Return the explanations by a mistake in the whole table, such as its convention, and another one in the table without it."""
        found = []
        for whole in self._singles:
            if whole.fault.row is not None or self.start:
                continue
            angles = self._invariants.violated(self._values([(whole,)])[0])[: self.arm.n - 1]
            if np.count_nonzero(angles) > MAX_WRONG_ANGLES:
                continue
            try:
                rest = replace(self, table=self._corrected((whole,)))
            except ValueError:  # for example an angle of many turns, which no table has
                continue
            found += [
                replace(each, faults=[whole.fault, *each.faults], table=self.table) for each in rest.explanations(1)
            ]
        return found

    def _corrected(self, corrections: Corrections) -> DHTable:
        rows = corrected_rows(self.table.rows, corrections)
        convention = next((c.convention for c in corrections if c.convention), self.table.convention)
        return self.table.changed(rows=rows, convention=convention, signs=self._signs(corrections))

    def _signs(self, corrections: Corrections) -> Array:
        """The signs of the corrected table, (m,)."""
        signs = self.table.signs.copy()
        for correction in corrections:
            signs[sorted(correction.turned)] *= -1
        return signs

    def _changes(self, corrections: Corrections) -> dict[tuple[int, int], float]:
        """The entries that corrections edit, with their new values."""
        rows = corrected_rows(self.table.rows, corrections)
        return {(int(i), int(j)): float(rows[i, j]) for i, j in np.argwhere(np.abs(rows - self.table.rows) > 1e-12)}

    def _edits(self, corrections: Corrections) -> bool:
        """Whether corrections edit anything. Without a change, the table is the one that has been compared already."""
        is_edited = self.start or any(c.convention or c.letters or c.turned for c in corrections)
        return bool(is_edited or self._changes(corrections))

    def _price(self, corrections: Corrections) -> list[float]:
        """The number of edited entries, where a number counts twice and a label once; then what is less plausible."""
        numbers = sum(c.fault.name in NUMBERS for c in corrections)
        labels = sum(bool(c.convention) + len(c.letters) + bool(c.turned) for c in corrections)
        # Every entry of a column has to be wrong in the same way: a single entry is the simpler explanation.
        columns = sum(c.fault.row is None and c.fault.name.startswith("sign of") for c in corrections)
        rows = corrected_rows(self.table.rows, corrections)
        changes = self._changes(corrections)
        # If nothing but zeros moves to where it has an effect, the place from which they come is no evidence.
        moves_zeros = len(changes) > 1 and not any(changes[entry] for entry in changes if self._counts(entry))
        # A wrong number is often near the right one. In most tables the lengths of a column have one sign, and the twists cancel.
        distance = sum(abs(changes[entry] - self.table.rows[entry]) for entry in changes) if numbers else 0.0
        negative, positive = (rows[:, LENGTHS] < 0).sum(axis=0), (rows[:, LENGTHS] > 0).sum(axis=0)
        unusual = np.minimum(negative, positive).sum(), negative.sum(), abs(np.sum(rows[:, ALPHA]))
        # Two rows that change places are two edits, however many entries they have.
        swapped = any(c.fault.name == "rows swapped" for c in corrections)
        entries = (min(len(changes), 2) if swapped else len(changes)) + numbers + labels + columns
        terms = entries, moves_zeros and not labels, numbers, len(changes), distance, *unusual
        return [round(float(term), 9) for term in terms]

    def _counts(self, entry: tuple[int, int]) -> bool:
        return "zeros" in self.fixed or entry not in joint_entries(self.table.joints)

    def _without_details(self, candidates: list[Corrections]) -> list[Corrections]:
        """Leave out what another explanation says as well: the same table, or a number that was swapped with another one.

        A number such as 0 or 90 degrees may be in the other place by chance, so then both explanations are kept.
        """

        def is_usual(changes: dict[tuple[int, int], float]) -> bool:
            return any(
                value == 0 or (column in ANGLES and abs(np.sin(2 * value)) < EQUIVALENCE_TOL)
                for (_, column), value in changes.items()
            )

        kept: list[tuple[Corrections, dict[tuple[int, int], float], int]] = []
        for candidate in candidates:
            changes, numbers = self._changes(candidate), sum(c.fault.name in NUMBERS for c in candidate)
            if not any(
                changes == others if numbers <= fewer else changes.items() <= others.items() and not is_usual(changes)
                for one, others, fewer in kept
                if [(c.convention, c.turned) for c in one] == [(c.convention, c.turned) for c in candidate]
            ):
                kept.append((candidate, changes, numbers))
        return [candidate for candidate, _, _ in kept]

    @cached_property
    def _singles(self) -> list[Correction]:
        """The known corrections, without those that edit nothing, such as swapping two equal rows."""
        known = known_corrections(self.table, self._right_rows, self._more_d, self.fixed)
        return [correction for correction in known if self._edits((correction,))]

    @cached_property
    def _right_rows(self) -> list[Array]:
        """The rows of right tables of the arm: of an assigned one, and of the one that is given, if it is a table."""
        own = assign_frames(self.arm, convention=self.table.convention).table.rows
        given = [self.reference.converted(self.table.convention).rows] if isinstance(self.reference, DHTable) else []
        return [own, *given]

    @cached_property
    def _more_d(self) -> dict[int, list[float]]:
        """The values of d, by row, for which the distance of two common normals along an axis is that of the arm."""
        moving = [row for row, _ in joint_entries(self.table.joints)]
        invariants, values = self._invariants, self._values([self.start])[0]
        return {
            moving[joint]: [
                self.table.rows[moving[joint], D] + sign * (turned * right - wrong)
                for sign in (1, -1)
                for turned in (1, -1)
            ]
            for joints, right, wrong in invariants.distances_along(values)
            for joint in joints
        }

    @cached_property
    def _invariants(self) -> AxisInvariants:
        return AxisInvariants(self.arm, FILTER_TOL_FACTOR * self.tolerance, "signs" in self.fixed)

    def _pairs(self) -> Iterator[Corrections]:
        """Yield the pairs of which each one changes every invariant that is wrong without it."""
        values = self._values([(single,) for single in self._singles])
        violated = self._invariants.violated(values).astype(float)
        unchanged = np.isclose(values, self._values([()]), rtol=1e-9, atol=1e-10).astype(float)
        possible = violated @ unchanged.T == 0
        for one, two in np.argwhere(np.triu(possible & possible.T, 1))[:MAX_PAIRS]:
            yield self._singles[one], self._singles[two]

    def _values(self, candidates: Sequence[Corrections]) -> Array:
        """Compute the invariants of the corrected tables, (N, k)."""
        return self._by_setting(candidates, lambda table, rows: self._invariants.of(*_joint_axes(table, rows)))

    def _may_agree(self, candidates: Sequence[Corrections]) -> Booleans:
        """Return which of the corrected tables can be the arm, as far as their invariants and their free choices show it."""
        if not candidates:
            return np.zeros(0, bool)
        agree = self._invariants.agree(self._values(candidates))
        if self.fixed >= {"zeros", "signs"}:
            q = random_configurations(self.arm.n, 4)
            poses = self._by_setting(candidates, lambda table, rows: _table_poses(table, rows[:, None], q))
            loose = FILTER_TOL_FACTOR * self.tolerance
            agree &= _same_motion(poses, self.arm.fk(q), self.fixed, loose)
        return agree

    def _by_setting(self, candidates: Sequence[Corrections], compute: Callable[[DHTable, Array], Array]) -> Array:
        """Compute something from the rows of all corrected tables (N, m, 4), for those of one convention and signs at a time."""
        other = OTHER_CONVENTION[self.table.convention]
        groups: dict[tuple[Convention, tuple[float, ...]], list[int]] = {}
        for number, candidate in enumerate(candidates):
            convention = other if any(c.convention for c in candidate) else self.table.convention
            groups.setdefault((convention, tuple(self._signs(candidate))), []).append(number)
        parts: list[tuple[list[int], Array]] = []
        for (convention, signs), members in groups.items():
            rows = np.array([corrected_rows(self.table.rows, candidates[number]) for number in members])
            parts.append((members, compute(self.table.changed(convention=convention, signs=signs), rows)))
        values = np.empty((len(candidates), *parts[0][1].shape[1:]))
        for members, part in parts:
            values[members] = part
        return values


def _can_combine(one: Correction, other: Correction) -> bool:
    """Whether the order of two corrections has no effect."""
    if one.entries.keys() & other.entries.keys() or (one.convention and other.convention):
        return False
    if one.turned & other.turned:
        return False
    return not any(
        number.fault.name in NUMBERS
        and scale.factors is not None
        and any(scale.factors[k] != 1 for k in number.entries)
        for number, scale in ((one, other), (other, one))
    )


def _wrong_end(end: str, typed: Array, right: Array) -> Fault:
    """Describe a wrong base or tool."""
    name = {"base": "The base T_s0", "tool": "The tool transform"}[end]
    is_missing = np.abs(typed - np.eye(4)).max() < EQUIVALENCE_TOL
    is_inverted = np.abs(typed @ right - np.eye(4)).max() < TYPED_POSE_TOL
    what = "is missing" if is_missing else "is inverted" if is_inverted else "is wrong"
    return Fault(f"wrong {end}", f"{name} {what}: it should be {describe_pose(right)}.")


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
    ours, theirs = (motion.reshape(len(motion) if motion is motions[0] else 1, -1) for motion in motions)
    same: Booleans = np.abs(ours - theirs).max(axis=-1) <= loose
    return same
