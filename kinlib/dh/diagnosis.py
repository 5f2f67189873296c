"""Diagnose a DH table: find the mistake, or the two mistakes, that explain why it does not describe a given arm.

Every slip of `kinlib.dh.slips` is corrected in turn, in every place where it could have been made. If the corrected table has the
motions of the arm, up to the choices that are not fixed, the slip explains the table. One is preferred to two, then the fewest
edited entries; a number that is invented counts as one entry more, because some number explains almost anything. If several
explanations are equally simple, all of them are returned.

Most corrections are refuted by the invariants of the axes, for all of them at once, and only the rest is compared in full.
"""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from kinlib.arrays.formatting import format_number
from kinlib.arrays.tolerances import EQUIVALENCE_TOL, PARALLEL_TOL_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.assignment import assign_frames
from kinlib.dh.equivalence import (
    CHOICES,
    NEARLY_PARALLEL_LOSS,
    ROUGH,
    Equivalence,
    describe_pose,
    equivalent,
    format_offset,
    measured_difference,
    nearest_maps,
    neighbours,
)
from kinlib.dh.invariants import AxisInvariants, Booleans
from kinlib.dh.parsing import COLUMNS, joint_entries
from kinlib.dh.rounding import nearest_rows, rounding_effect, typed_half_units
from kinlib.dh.slips import (
    MIN_LENGTH_MM,
    NUMBERS,
    OTHER_CONVENTION,
    Correction,
    Fault,
    corrections,
    corrections_of_joint_types,
    wrong_number,
)
from kinlib.dh.table import Convention, DHTable, joint_axes, table_poses

MAX_TOLD, MAX_DIFFERENT_ENTRIES = 3, 8
"""How many equally simple explanations the text lists, and how many different entries."""

MAX_COMPARED, MAX_PAIRS = 60, 20_000
"""How many corrected tables whose invariants agree are compared with the arm in full, and how many pairs of mistakes are tried."""

MAX_ROUNDED_TOL, MAX_HALF_UNITS = 1e-2, 2.0
"""Through a larger effect of rounding, mistakes are not looked for; and by how many half units of its last digit a number is off."""

TYPED_POSE_TOL = 1e-6
"""How far the inverse of a pose may be off that a person typed."""

FILTER_TOL_FACTOR = 3
"""How many times the tolerance an invariant may be off before a correction is refuted by it."""


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
    tolerance     differences below it are not mentioned
    rounding      what the digits of the table show of their rounding, in words; "" with a given tolerance
    """

    verdict: Literal["right", "rounded", "undecided", "wrong"]
    table: DHTable
    arm: Chain
    comparison: Equivalence
    explanations: Sequence[TableExplanation] = ()
    nearest: DHTable | None = None
    up_to: str = ""
    tolerance: float = EQUIVALENCE_TOL
    rounding: str = ""

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
        if self.verdict == "undecided":
            cause = (
                f"its numbers may only be rounded ({self.rounding})" if self.rounding else "axes are nearly parallel"
            )
            or_else = ", or:" if told else "."
            lines = [f"Whether this table describes the arm cannot be decided: {cause}{or_else}"]
            return "\n".join([*lines, *(told or [self.difference])]).rstrip()
        if told:
            return "\n".join(told)
        lines = [f"No known mistake was found that explains this table. {self.difference}".rstrip()]
        if self.nearest is not None:
            faults = different_entries(self.table, self.nearest)
            lines.append(f"It would describe the arm{self.up_to} with these numbers, the largest difference first:")
            lines += [fault.text for fault in faults[:MAX_DIFFERENT_ENTRIES]]
            if (more := len(faults) - MAX_DIFFERENT_ENTRIES) > 0:
                lines.append(f"({more} more differ by less.)")
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
        if len(texts) < 2:
            lines = texts[0] if texts else []
            if texts and explanations[0].is_a_choice:
                return ["The table describes the arm after these changes of choices that are fixed here:", *lines]
            # Other pairs may lead to the same motions, so this one is no fact.
            return ["The table agrees with the arm after these changes:", *lines] if len(lines) > 1 else lines
        lines = ["Either: " + " ".join(texts[0]), *("or: " + " ".join(text) for text in texts[1:MAX_TOLD])]
        if (more := len(texts) - MAX_TOLD) > 0:
            lines.append(f"({more} more {'is' if more == 1 else 'are'} as simple.)")
        return lines

    def _agreement(self) -> Iterator[str]:
        """Describe how well a table describes the arm, for the same q, and up to which choices."""
        digits = f" to the digits that are printed ({self.rounding})" if self.verdict == "rounded" else ""
        choices = self.comparison.choices(self.tolerance)
        metres, radians = measured_difference(self.table.to_chain(), self.arm)
        differ = f"{format_number(metres, 3)} m and {format_number(math.degrees(radians), 3, zero=1e-6)}°, at 1000 random configurations."
        if not choices:
            yield f"This table describes the arm{digits}" + (
                f"; their poses differ by up to {differ}" if digits else "."
            )
            return
        yield f"For the same q, the poses of the table and of the arm differ by up to {differ}"
        yield f"The table describes the arm{digits}, up to these choices:"
        yield from (fault.text for fault in _choices_as_faults(self.table, self.comparison, self.tolerance))
        kinds = {name for name, _ in choices}
        if kinds & {"zeros", "signs"}:
            fixed = frozenset(CHOICES) - ({"base", "tool"} & kinds)
            found = _explain(self.table, self.arm, None, fixed, max(self.tolerance, EQUIVALENCE_TOL), 1)
            texts = [each.faults[0].text for each in found if each.faults[0].name not in NUMBERS]
            if texts:
                yield f"If q is meant to be the same: {' Or: '.join(texts[:MAX_TOLD])}"
        differing = ", ".join(f'"{name}"' for name in CHOICES if name in kinds)
        yield f"To count these as mistakes, pass fixed=[{differing}]."


def diagnose(
    table: Any,
    reference: Any,
    fixed: Collection[str] = (),
    *,
    convention: Convention | None = None,
    tolerance: float | None = None,
    in_pairs: bool = True,
) -> Diagnosis:
    """Find the mistakes in a table, given the arm that it is meant to describe.

    table      a DHTable; or its rows, as DHTable takes them, with `convention`
    reference  the arm: a chain, a URDF file as `load_urdf` takes it, or another table
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
    table, reference = _table_or_arm(table, convention), _table_or_arm(reference, convention)
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
    found = Diagnosis("wrong", table, arm, equivalent(table, arm, fixed=fixed, tolerance=exact), tolerance=exact)
    if found.comparison.verdict == "same":
        return replace(found, verdict="right")
    if "H" in arm.joint_types:
        return replace(found, verdict="undecided" if found.comparison.verdict == "undecided" else "wrong")
    half, noise, rounding, near = np.zeros(table.rows.shape), exact, "excluded", found.comparison
    if tolerance is None and table.joints.replace("F", "") == arm.joint_types:
        half, words = typed_half_units(table.rows)
        noise = max(rounding_effect(table, half), exact)
        near = equivalent(table, arm, fixed=fixed, tolerance=noise)
        rounding = _judge_rounding(table, arm, near, fixed, half, noise)
        found = replace(found, rounding=words)
    if rounding == "rounded":
        return replace(found, verdict="rounded", comparison=near, tolerance=noise)
    if found.comparison.verdict == "undecided":
        return replace(found, verdict="undecided")
    count = 2 if in_pairs else 1
    has_noise = near.verdict != "same"
    found = replace(found, explanations=_explanations(found, reference, fixed, half, noise, has_noise, count))
    is_plain = any(len(each.faults) == 1 and _is_plain(each, table, half) for each in found.explanations)
    if rounding == "possible" and not is_plain:
        return replace(found, verdict="undecided")
    return found if found.explanations else _with_nearest(found, fixed, half, noise, count)


def _table_or_arm(given: Any, convention: Convention | None) -> Any:
    """Read the path or the text of a URDF file as a chain, and rows as a table."""
    from kinlib.urdf.chains import load_urdf

    if isinstance(given, os.PathLike) or (isinstance(given, str) and (given.endswith(".urdf") or "<robot" in given)):
        return load_urdf(given)
    return given if convention is None or isinstance(given, DHTable | Chain) else DHTable(given, convention=convention)


def _judge_rounding(  # noqa: PLR0917
    table: DHTable, arm: Chain, near: Equivalence, fixed: frozenset[str], half_unit: Array, effect: float
) -> Literal["rounded", "possible", "excluded"]:
    """Judge whether numbers that round to those of the table describe the arm."""
    sines = neighbours(arm)[0]
    smallest = sines[sines > PARALLEL_TOL_RAD].min(initial=1.0)
    if near.verdict != "same":
        return "excluded" if near.verdict == "different" and effect <= 0.1 * smallest else "possible"
    fit = nearest_rows(table, arm, near, fixed, half_unit, few=False)
    if fit is None or fit.difference > max(EQUIVALENCE_TOL, 1e-2 * effect):
        return "possible"
    off = np.abs(fit.rows - table.rows) / half_unit
    for entry in joint_entries(table.joints) if "zeros" not in fixed else ():
        off[entry] = 0.0
    # No numbers within their half units have a smaller sum of squares than these.
    is_excluded = np.linalg.norm(off) > 1.05 * math.sqrt(off.size) and smallest > 0.1
    return "rounded" if off.max() <= MAX_HALF_UNITS else "excluded" if is_excluded else "possible"


def _is_plain(explanation: TableExplanation, table: DHTable, half_unit: Array) -> bool:
    """Whether an explanation is a usual mistake, or one number whose correction has as few digits as the others."""
    fault = explanation.faults[0]
    if fault.name not in NUMBERS:
        return not explanation.is_a_choice and fault.name != "columns in another order"
    rows, changed = explanation.corrected.rows, explanation.corrected.rows != table.rows
    unit = 2 * half_unit[changed]
    return bool((np.abs(rows[changed] - np.round(rows[changed] / unit) * unit) < 1e-9).all())


def _explanations(  # noqa: PLR0917
    found: Diagnosis,
    reference: Chain | DHTable,
    fixed: frozenset[str],
    half_unit: Array,
    noise: float,
    has_noise: bool,
    count: int,
) -> list[TableExplanation]:
    """Explain a table that differs from the arm: exactly, or else through the noise that its rounded numbers have."""
    table, arm, exact = found.table, found.arm, found.tolerance
    if np.abs(table.rows[:, [0, 2]]).max() > MIN_LENGTH_MM and noise > exact:  # in case that they are in millimetres
        metres = table.changed(rows=table.rows * (1e-3, 1, 1e-3, 1))
        noise = max(rounding_effect(metres, typed_half_units(metres.rows)[0]), exact)
    has_noise &= exact < noise <= MAX_ROUNDED_TOL
    for bound in [exact, noise] if has_noise else [exact]:
        found_now = _explain(table, arm, reference, fixed, bound, 1)
        explained = [each for each in found_now if not _needs_rounding(each, table, half_unit)]
        choice = None
        if fixed and not any(each.edits <= 1 for each in explained):
            choice = _choice(table, equivalent(table, arm, tolerance=bound), bound)
        if not explained and count > 1 and not (choice and choice.edits <= 2):
            found_now = _explain(table, arm, reference, fixed, bound, 2) if bound == exact else []
            if ends := fixed & {"base", "tool"}:
                found_now += _explain(table, arm, reference, fixed, bound, 1, fixed - ends)
            least = min((each.edits for each in found_now), default=0)
            explained = [
                each for each in found_now if each.edits == least and not _needs_rounding(each, table, half_unit)
            ]
        if choice and not any(_says_as_much(each, choice) for each in explained):
            is_pair = bool(explained) and len(explained[0].faults) > 1
            if not explained or choice.edits < explained[0].edits + is_pair:
                return [choice]
        if explained:
            return explained
    return []


def _needs_rounding(explanation: TableExplanation, table: DHTable, half_unit: Array) -> bool:
    """Whether one of the mistakes is a number that only has fewer decimals than it should have."""
    is_close = np.abs(explanation.corrected.rows - table.rows) <= 1.05 * half_unit
    numbers = [fault for fault in explanation.faults if fault.name in NUMBERS and fault.row and fault.column]
    return any(is_close[fault.row - 1, COLUMNS.index(fault.column)] for fault in numbers if fault.row and fault.column)


def _choice(table: DHTable, near: Equivalence, tolerance: float) -> TableExplanation | None:
    """Return the choices up to which a table is right as an explanation; None if it is not."""
    faults = _choices_as_faults(table, near, tolerance) if near.verdict == "same" else []
    if not faults:
        return None
    rows, signs = table.rows.copy(), table.signs.copy()
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        rows[row, column] += table.signs[row] * near.offsets[joint]
        signs[row] *= near.signs[joint]
    corrected = table.changed(rows=rows, signs=signs, base=near.base @ table.base, tool=table.tool @ near.tool)
    return TableExplanation(faults, corrected, sum(map(_weight, faults)), is_a_choice=True)


def _weight(fault: Fault) -> int:
    """How many edits a fault counts as, beside the entries that it changes: a pose is two."""
    return 2 if fault.name in {"wrong base", "wrong tool"} else 1


def _choices_as_faults(table: DHTable, found: Equivalence, tolerance: float) -> list[Fault]:
    """Write the choices in which a table differs from an arm as corrections, each with its numbers."""
    faults = []
    for joint, (row, column) in enumerate(joint_entries(table.joints)):
        name, letter, place = COLUMNS[column], table.joints[row], f"joint {joint + 1}"
        if text := format_offset(letter, float(table.signs[row] * found.offsets[joint]), tolerance):
            base = " (or rotate the base by as much about axis 1)" if joint == 0 and letter == "R" else ""
            faults.append(Fault("another zero", f"{place}: add {text} to {name}{base}.", row + 1, name))
        if found.signs[joint] < 0:
            sign = "-" if table.signs[row] > 0 else "+"
            text = f"{place}: write {sign}q in {name}, because q counts in the opposite direction."
            faults.append(Fault("sign of q", text, row + 1, name))
    for end, own, T in (("base", table.base, found.base @ table.base), ("tool", table.tool, table.tool @ found.tool)):
        if np.abs(T - own).max() > tolerance:
            is_missing = np.abs(own - np.eye(4)).max() < EQUIVALENCE_TOL
            is_inverted = np.abs(own @ T - np.eye(4)).max() < TYPED_POSE_TOL
            what = "is missing" if is_missing else "is inverted" if is_inverted else "is wrong"
            name = {"base": "The base T_s0", "tool": "The tool transform"}[end]
            faults.append(Fault(f"wrong {end}", f"{name} {what}: it should be {describe_pose(T, tolerance)}."))
    return faults


def _with_nearest(
    found: Diagnosis, fixed: frozenset[str], half_unit: Array, noise: float, max_faults: int
) -> Diagnosis:
    """Add the table with few other numbers that describes the arm to a diagnosis that found no mistake."""
    table, up_to = found.table, ""
    nearest = _nearest_table(table, found.arm, fixed, half_unit, noise)
    if nearest is None and fixed:
        nearest = _nearest_table(table, found.arm, frozenset(), half_unit, noise)
        up_to = f", up to {', '.join(CHOICES)},"
    if nearest is None:
        return found
    if np.abs(nearest.rows - table.rows).max() < NEARLY_PARALLEL_LOSS:
        return replace(found, verdict="undecided")  # as small as what nearly parallel axes lose
    faults = different_entries(table, nearest)
    if len(faults) <= max_faults and not up_to:
        return replace(found, explanations=[TableExplanation(faults, nearest, 2 * len(faults))])
    return replace(found, nearest=nearest, up_to=up_to)


def _nearest_table(
    table: DHTable, arm: Chain, fixed: frozenset[str], half_unit: Array, effect: float
) -> DHTable | None:
    """Find the table with few other numbers that describes the arm, beginning with the maps that fit roughly."""
    if table.joints.replace("F", "") != arm.joint_types:
        return None
    own, tolerance = table.to_chain(), max(effect, 1e-6)
    identity = Equivalence("same", signs=np.ones(arm.n), offsets=np.zeros(arm.n))
    rough = sorted(nearest_maps(own, arm, fixed, ROUGH), key=lambda each: each.difference)[:2]
    unit = np.maximum(half_unit, 1e-6)
    for start in [identity, *rough]:
        fit = nearest_rows(table, arm, start, fixed, unit, few=True)
        if fit and fit.difference <= tolerance:
            # A change below half a unit of the last digit is none, and two digits more than the table has are enough.
            finest = 10.0 ** np.floor(np.log10(unit / 50))
            rows = np.where(np.arange(4) % 2, fit.rows, np.round(fit.rows / finest) * finest)
            rows = np.where(np.abs(fit.rows - table.rows) <= 1.05 * half_unit, table.rows, rows)
            for entry in joint_entries(table.joints) if "zeros" not in fixed else ():
                rows[entry] = table.rows[entry]
            nearest = table.changed(rows=rows)
            if equivalent(nearest, arm, fixed=fixed, tolerance=tolerance).verdict == "same":
                return nearest
    return None


def different_entries(table: DHTable, right: DHTable) -> list[Fault]:
    """Describe the entries in which two tables differ, the largest difference first.

    >>> one, other = (DHTable([[1, 0, d, 0]], convention="standard") for d in (2, 3))
    >>> [fault.text for fault in different_entries(one, other)]
    ['Row 1: d should be 3; the table has 2.']
    """
    off = np.abs(right.rows - table.rows)
    places = sorted(np.argwhere(off > 0).tolist(), key=lambda place: -off[tuple(place)])
    return [wrong_number(table, right, row, column) for row, column in places]


def _explain(  # noqa: PLR0917
    table: DHTable,
    arm: Chain,
    reference: Chain | DHTable | None,
    fixed: frozenset[str],
    tolerance: float,
    count: int,
    searched: frozenset[str] | None = None,
) -> list[TableExplanation]:
    """Return all explanations of a table by so many faults with the smallest price, and by what else differs of what is fixed.

    searched   the choices that are fixed in the search; by default all that are fixed
    """
    right = [assign_frames(arm, convention=table.convention).table.rows]
    if isinstance(reference, DHTable):
        right.append(reference.converted(table.convention).rows)
    numbers = right[-1] if len(right[-1]) == len(table.rows) else right[0]
    found: list[TableExplanation] = []
    for start in corrections_of_joint_types(table, arm.joint_types):
        # If the joint types differ, no other correction can help without these.
        first = table
        for correction in start:
            first = correction.of(first)
        if len(start) <= count:
            search = _Search(first, arm, numbers, fixed if searched is None else searched, tolerance)
            found += search.explanations(table, [each.fault for each in start], count - len(start), fixed)
    return found


@dataclass(frozen=True, eq=False)
class _Search:
    """The search for the simplest corrections of a table: a list of candidates, a filter by invariants, a price, a comparison."""

    table: DHTable
    arm: Chain
    numbers: Array
    fixed: frozenset[str]
    tolerance: float

    def explanations(
        self, table: DHTable, faults: list[Fault], count: int, fixed: frozenset[str]
    ) -> list[TableExplanation]:
        """Return the explanations by this number of corrections, after those of the joint types, with the smallest price."""
        singles = self._singles
        if not count:
            places = np.zeros((1 if faults else 0, 0), dtype=int)
        else:
            places = np.arange(len(singles))[:, None] if count == 1 else self._pairs
        rows, signs, is_other = self._corrected(places)
        agree = np.flatnonzero(self._may_agree(rows, signs, is_other))
        numbers = self._is_number[places].sum(axis=1)
        changed = np.abs(rows - table.rows) > 1e-12
        size = np.where(numbers > 0, np.abs(rows - table.rows).sum(axis=(1, 2)), 0.0)
        negative = 1e-3 * (rows[:, :, [0, 2]] < 0).sum(axis=(1, 2))  # in most tables the lengths have one sign
        edits = self._edits[places].sum(axis=1) + (0 if count else changed.sum(axis=(1, 2))) + len(faults)
        prices = sorted((int(edits[k]), int(numbers[k]), round(float(size[k] + negative[k]), 9), k) for k in agree)
        found, least = list[TableExplanation](), 0
        for price in prices[:MAX_COMPARED]:
            if found and price[0] > least:
                break
            chosen = [singles[place] for place in places[price[-1]]]
            corrected = self.table
            try:
                for correction in chosen:
                    corrected = correction.of(corrected)
            except ValueError:  # for example an angle of many turns, which no table has
                continue
            compared = equivalent(corrected, self.arm, fixed=self.fixed, tolerance=self.tolerance)
            if compared.verdict != "same":
                continue
            told = [*faults, *(self._described(each.fault, corrected) for each in chosen)]
            choices = _choices_as_faults(corrected, compared, self.tolerance) if self.fixed != fixed else []
            choices = [fault for fault in choices if fault.name.removeprefix("wrong ") in fixed - self.fixed]
            ends = {"base": compared.base @ corrected.base, "tool": corrected.tool @ compared.tool}
            corrected = corrected.changed(**{end: T for end, T in ends.items() if end in fixed - self.fixed})
            explanation = TableExplanation(told + choices, corrected, price[0] + sum(map(_weight, choices)))
            if not any(_says_as_much(other, explanation) for other in found):
                found, least = [*found, explanation], price[0]
        return found

    def _described(self, fault: Fault, corrected: DHTable) -> Fault:
        if fault.text or not fault.row or not fault.column:
            return fault
        return wrong_number(self.table, corrected, fault.row - 1, COLUMNS.index(fault.column))

    @cached_property
    def _singles(self) -> list[Correction]:
        return corrections(self.table, self.numbers, "zeros" in self.fixed, "signs" in self.fixed)

    @cached_property
    def _is_number(self) -> Booleans:
        return np.array([each.fault.name in NUMBERS for each in self._singles])

    @cached_property
    def _edits(self) -> Array:
        """The entries that each correction changes; two rows that change places are two, and labels and invented numbers one more.

        Every entry of a column has to be wrong in the same way, which is one more as well: a single entry is the simpler explanation.
        """
        edits = []
        for each, rows in zip(self._singles, self._rows_of_singles, strict=True):
            changed = int(np.sum(np.abs(rows - self.table.rows) > 1e-12))
            is_column = each.fault.row is None and each.fault.name.startswith("sign of")
            labels = bool(each.convention) + bool(each.reversed) + is_column + (each.fault.name in NUMBERS)
            edits.append((min(changed, 2) if each.fault.name == "rows swapped" else changed) + labels)
        return np.array(edits)

    @cached_property
    def _rows_of_singles(self) -> Array:
        return np.array([each.change(self.table.rows) for each in self._singles])

    @cached_property
    def _invariants(self) -> AxisInvariants:
        return AxisInvariants(self.arm, FILTER_TOL_FACTOR * self.tolerance)

    @cached_property
    def _pairs(self) -> Array:
        """The pairs of which each one changes every invariant that is wrong without it, (N, 2)."""
        values = self._values(*self._corrected(np.arange(len(self._singles))[:, None]))
        own = self._values(*self._corrected(np.zeros((1, 0), dtype=int)))
        violated = self._invariants.violated(values).astype(float)
        unchanged = np.isclose(values, own, rtol=1e-9, atol=1e-10).astype(float)
        possible = violated @ unchanged.T == 0
        return np.argwhere(np.triu(possible & possible.T, 1))[:MAX_PAIRS]

    def _corrected(self, places: Array) -> tuple[Array, Array, Booleans]:
        """Make the corrections at these places, (N, count): rows (N, m, 4), signs (N, m), and whether the convention changes (N,).

        A correction of a row comes after one of the whole table, as the singles are sorted.
        """
        rows = np.repeat(self.table.rows[None], len(places), axis=0)
        signs = np.repeat(self.table.signs[None], len(places), axis=0)
        is_other = np.zeros(len(places), bool)
        for column in places.T:
            for place in np.unique(column):
                single, chosen = self._singles[place], column == place
                rows[chosen] = single.change(rows[chosen])
                is_other[chosen] ^= single.convention is not None
                signs[np.ix_(chosen, [*single.reversed])] *= -1
        return rows, signs, is_other

    def _values(self, rows: Array, signs: Array, is_other: Booleans) -> Array:
        """Compute the invariants of the corrected tables, (N, k)."""
        axes = self._of_both(is_other, lambda table, of: self._invariants.of(*joint_axes(table, rows[of], signs[of])))
        return axes

    def _may_agree(self, rows: Array, signs: Array, is_other: Booleans) -> Booleans:
        """Return which of the corrected tables can be the arm, as far as their invariants and the poses of a few q show it."""
        agree = self._invariants.agree(self._values(rows, signs, is_other), "signs" in self.fixed)
        if self.fixed >= {"zeros", "signs"} and agree.any():
            q = random_configurations(self.arm.n, 4)
            rows, signs = rows[agree], signs[agree]
            poses = self._of_both(
                is_other[agree], lambda table, of: table_poses(table, rows[of, None], q, signs[of, None])
            )
            agree[agree] = _same_motion(poses, self.arm.fk(q), self.fixed, FILTER_TOL_FACTOR * self.tolerance)
        return agree

    def _of_both(self, is_other: Booleans, compute: Any) -> Array:
        """Compute something of the tables of one convention, and of those of the other."""
        found = compute(self.table, ~is_other)
        values = np.zeros((len(is_other), *found.shape[1:]))
        values[~is_other] = found
        if is_other.any():
            other = self.table.changed(convention=OTHER_CONVENTION[self.table.convention])
            values[is_other] = compute(other, is_other)
        return values


def _says_as_much(one: TableExplanation, other: TableExplanation) -> bool:
    """Whether an explanation that was found leads to the table of another one."""
    a, b = one.corrected, other.corrected
    return (a.convention, a.joints, a.signs.tolist()) == (b.convention, b.joints, b.signs.tolist()) and bool(
        np.abs(a.rows - b.rows).max() < 1e-9
    )


def _same_motion(poses: Array, right: Array, fixed: frozenset[str], loose: float) -> Booleans:
    """Return which poses (N, k, 4, 4) are the right ones (k, 4, 4) up to the frames at the ends that are free."""

    def motions(T: Array) -> Array:
        start = np.linalg.inv(T[..., :1, :, :])
        if fixed >= {"base", "tool"}:
            return T
        if "base" in fixed:
            return T[..., 1:, :, :] @ start
        if "tool" in fixed:
            return start @ T[..., 1:, :, :]
        return np.asarray(np.trace(T[..., 1:, :3, :3] @ start[..., :3, :3], axis1=-2, axis2=-1))

    same: Booleans = np.abs(motions(poses) - motions(right)).reshape(len(poses), -1).max(axis=-1) <= loose
    return same
