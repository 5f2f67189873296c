"""Diagnose a DH table: find the mistake, or the two mistakes, that explain why it does not describe a given arm.

If a table with a slip corrected has the motions of the arm, up to the choices that are not fixed, the slip explains the table. One is
preferred to two, then the fewest edited entries. If several explanations are equally simple, all of them are returned. What is right
up to choices that are fixed is explained by these choices, and what nothing explains is told entry by entry.
"""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_number
from kinlib.arrays.tolerances import EQUIVALENCE_TOL, TYPED_PI_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.equivalence import CHOICES, Equivalence, equivalent, measured_difference
from kinlib.dh.explanation.rounding import nearest_table, rounding_effect, typed_half_units, with_right_angles
from kinlib.dh.explanation.search import TableExplanation, explain_by_choices, explain_by_slips
from kinlib.dh.slips import NUMBERS, Fault, wrong_number
from kinlib.dh.table import Convention, DHTable
from kinlib.urdf.chains import load_urdf

MAX_TOLD, MAX_DIFFERENT_ENTRIES, MAX_ROUNDED_TOL = 3, 8, 2e-2
"""How many equally simple explanations the text lists, and how many different entries; and up to which effect of rounding a
table is called right, and mistakes are looked for."""

CLEARLY_LESS, SEVERAL_UNITS = 4, 5
"""The part of a difference that is left without a wrong number, and by how many half units this one is off at least."""

TAKEN_AS_RIGHT_ANGLES = "Angles that round to those of the table were taken as multiples of 45 degrees."


@dataclass(frozen=True, eq=False, repr=False)
class Diagnosis:
    """The result of a diagnosis.

    verdict       "right"; "rounded", if the table differs from the arm by no more than the rounding of its numbers can, and 2 cm;
                  "undecided", if rounding or nearly parallel axes may explain the difference, and no mistake does; or "wrong"
    table, arm    the table that was diagnosed, and the arm
    comparison    of this table and the arm, up to the choices that are not fixed; if the table is "rounded", to within the rounding
    explanations  all explanations that are equally simple, the most plausible one first; empty if the table is right
    nearest       if nothing explains the table: the table with other numbers that describes the arm, as few as were found
    up_to         the choices up to which it does, in words, if these are fixed
    rounding      what the digits of the table show of their rounding, in words; "" with a given tolerance
    note          what was taken for granted
    """

    verdict: Literal["right", "rounded", "undecided", "wrong"]
    table: DHTable
    arm: Chain
    comparison: Equivalence
    explanations: Sequence[TableExplanation] = ()
    nearest: DHTable | None = None
    up_to: str = ""
    rounding: str = ""
    note: str = ""

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
        lines = self._told_mistakes()
        if self.verdict == "undecided":
            rounded = f"its numbers may only be rounded ({self.rounding})"
            cause = rounded if self.rounding else "axes are nearly parallel"
            lines = [f"Whether this table describes the arm cannot be decided: {cause}.", self.difference]
        elif not lines:
            difference = self.difference if self.nearest is None else ""
            lines = [f"No known mistake was found that explains this table. {difference}".rstrip()]
        if self.nearest is not None:
            faults = _different_entries(self.table, self.nearest)
            lines.append(f"It would describe the arm{self.up_to} with these numbers, the largest difference first:")
            lines += [fault.text for fault in faults[:MAX_DIFFERENT_ENTRIES]]
        return "\n".join([*lines, self.note]).rstrip()

    def _told_mistakes(self) -> list[str]:
        """Write the explanations, one in a line."""
        # Another number for the same entry is the same mistake.
        told = {tuple((f.name, f.row, f.column) for f in each.faults): each for each in reversed(self.explanations)}
        texts = [[fault.text for fault in each.faults] for each in reversed(told.values())]
        if len(texts) > 1:
            return ["Either: " + " ".join(texts[0]), *("or: " + " ".join(text) for text in texts[1:MAX_TOLD])]
        if texts and self.explanations[0].is_a_choice:
            digits = " to the digits that are printed" * bool(self.rounding)
            head = f"The table describes the arm{digits} after these changes of choices that are fixed here:"
            return [head, *texts[0]]
        if texts and len(texts[0]) > 1:  # other pairs may lead to the same motions, so this one is no fact
            return ["The table agrees with the arm after these changes:", *texts[0]]
        return texts[0] if texts else []

    def _agreement(self) -> Iterator[str]:
        """Describe how well a table describes the arm, for the same q, and up to which choices."""
        found = self.comparison
        digits = f" to the digits that are printed ({self.rounding})" if self.verdict == "rounded" else ""
        kinds = {name for name, _ in found.choices()}
        metres, radians = measured_difference(self.table.to_chain(), self.arm)
        degrees = format_number(math.degrees(radians), 3, zero=1e-6)
        differ = f"differ by up to {format_number(metres, 3)} m and {degrees}°, at 1000 random configurations."
        if not kinds:
            yield f"This table describes the arm{digits}" + (f"; their poses {differ}" if digits else ".")
            return
        yield f"For the same q, the poses of the table and of the arm {differ}"
        yield f"The table describes the arm{digits}, up to these choices:"
        yield from (fault.text for fault in explain_by_choices(self.table, found).faults)
        if kinds & {"zeros", "signs"}:
            fixed = frozenset(CHOICES) - ({"base", "tool"} & kinds)
            exact = np.zeros_like(self.table.rows)
            one_slip = explain_by_slips(self.table, self.arm, fixed, found.tolerance, 1, exact)
            changed = sum(name in {"zeros", "signs"} for name, _ in found.choices())
            told = [each.faults[0] for each in one_slip if each.faults[0].row is None or each.edits <= changed]
            texts = [fault.text for fault in told if fault.name not in NUMBERS]
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
    reference  the arm: a chain, the path or the text of a URDF file, or another table
    fixed      what may not differ: any of "base", "tool", "zeros" and "signs". By default a table is right if it has the motions
               of the arm up to these four choices; with all four it is right only if its poses are those of the arm
    tolerance  how far the poses of a right table may be off, in metres and radians. By default 1e-8, and a table is not accused
               of what the rounding of its numbers explains, as far as their digits show
    in_pairs   whether pairs of mistakes, choices that are fixed, and other numbers are tried if no single slip explains the table

    Raises ValueError if the two have different numbers of joints, because then they cannot be compared.

    >>> printed = kl.assign_frames(kl.robots.puma560(), convention="modified").table
    >>> print(diagnose(printed.changed(convention="standard"), kl.robots.puma560()))
    The table is in the modified convention, but was read as standard.
    """
    if convention is not None and not isinstance(table, DHTable):
        table = DHTable(table, convention=convention)
    if isinstance(reference, str | os.PathLike):
        reference = load_urdf(reference)
    validation.instance(table, "table", DHTable)
    validation.instance(reference, "reference", Chain, DHTable)
    arm = reference.to_chain() if isinstance(reference, DHTable) else reference
    if table.n != arm.n:
        raise ValueError(f"The table must have the joints of the arm, {arm.joint_types}; it has {table.joints}.")
    names, exact = frozenset(fixed), EQUIVALENCE_TOL if tolerance is None else tolerance
    compared = equivalent(table, arm, fixed=names, tolerance=exact)
    found = Diagnosis("right" if compared.verdict == "same" else "wrong", table, arm, compared)
    if found.verdict == "right" or "H" in arm.joint_types:
        return found
    plain, half, noise = table, np.zeros(table.rows.shape), exact
    if tolerance is None:
        half, words = typed_half_units(table.rows)
        plain = with_right_angles(table, half)
        half = typed_half_units(plain.rows)[0]
        noise = max(rounding_effect(plain, half), exact)
        is_other = np.abs(plain.rows - table.rows).max() > TYPED_PI_ERROR
        found = replace(found, rounding=words, note=TAKEN_AS_RIGHT_ANGLES * bool(is_other))
    near = equivalent(plain, arm, fixed=names, tolerance=noise)
    if near.verdict == "same":
        # A number that is off by several of its units is no rounded one, if nearly all of the difference goes with it. Up to free
        # choices, rounded tables have such numbers, too.
        bound, clear = near.difference / CLEARLY_LESS, list[TableExplanation]()
        if bound > exact and names >= {*CHOICES}:
            clear = explain_by_slips(plain, reference, names, bound, 1, SEVERAL_UNITS * half)
        if clear or near.difference <= MAX_ROUNDED_TOL:
            found = replace(found, verdict="wrong" if clear else "rounded", comparison=near, explanations=clear)
            return replace(found, note=found.note * bool(clear))
    if compared.verdict == "undecided":
        return replace(found, verdict="undecided")
    is_near, is_typed = near.verdict == "same", bool((plain.rows != table.rows).any())
    searches = [(plain, exact), *[(table, exact)] * is_typed]
    searches += [(plain, min(noise, MAX_ROUNDED_TOL))] * (noise > exact and not is_near)
    for start, bound in searches:
        slips = 1 if is_near or bound > exact else 2  # two numbers can explain the rounding of all of them
        if explanations := _explanations(start, reference, names, half, bound, in_pairs, slips):
            return replace(found, explanations=explanations)
    if near.verdict != "different":
        return replace(found, verdict="undecided")
    return _with_nearest(replace(found, table=plain), names, half, noise) if in_pairs else found


def _explanations(  # noqa: PLR0917
    table: DHTable,
    reference: Chain | DHTable,
    fixed: frozenset[str],
    half: Array,
    bound: float,
    in_pairs: bool,
    max_slips: int,
) -> Sequence[TableExplanation]:
    """Explain a table by one slip; or by choices that are fixed, or two slips, whichever changes less."""
    found = explain_by_slips(table, reference, fixed, bound, 1, half)
    if not in_pairs or any(each.edits <= 1 for each in found):
        return found
    compared = equivalent(table, reference, tolerance=bound)
    choices = [explain_by_choices(table, compared, fixed)] * (bool(fixed) and compared.verdict == "same")
    if not found and max_slips > 1 and not any(each.edits <= 2 for each in choices):
        found = explain_by_slips(table, reference, fixed, bound, 2, half)
    is_pair = bool(found) and len(found[0].faults) > 1
    return choices if choices and (not found or choices[0].edits < found[0].edits + is_pair) else found


def _with_nearest(found: Diagnosis, fixed: frozenset[str], half: Array, noise: float) -> Diagnosis:
    """Add the table with few other numbers that describes the arm to a diagnosis that found no mistake."""
    table, up_to = found.table, ""
    nearest = nearest_table(table, found.arm, fixed, half, noise)
    if nearest is None and fixed:
        nearest, up_to = nearest_table(table, found.arm, frozenset(), half, noise), f", up to {', '.join(CHOICES)},"
    if nearest is None:
        return found
    faults = _different_entries(table, nearest)
    if len(faults) <= 2 and not up_to:
        return replace(found, explanations=[TableExplanation(faults, nearest, 2 * len(faults))])
    return replace(found, nearest=nearest, up_to=up_to)


def _different_entries(table: DHTable, right: DHTable) -> list[Fault]:
    """Describe the entries in which two tables differ, the largest difference first."""
    off = np.abs(right.rows - table.rows)
    places = sorted(np.argwhere(off > 0).tolist(), key=lambda place: -off[tuple(place)])
    return [wrong_number(table, row, column, float(right.rows[row, column])) for row, column in places]
