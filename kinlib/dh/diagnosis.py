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
from kinlib.dh.alignment import neighbours
from kinlib.dh.equivalence import Equivalence, equivalent, measured_difference
from kinlib.dh.explanation.rounding import rounding_effect, typed_half_units, with_right_angles
from kinlib.dh.explanation.search import TableExplanation, explain_by_choices, explain_by_numbers, explain_by_slips
from kinlib.dh.slips import ANGLES, CHOICES, WRONG_NUMBER, Fault
from kinlib.dh.table import Convention, DHTable
from kinlib.urdf.chains import load_urdf

MAX_TOLD, MAX_DIFFERENT_ENTRIES, MAX_ROUNDED_TOL = 3, 8, 2e-2
"""How many equally simple explanations the text lists, and how many different entries; and up to which effect of rounding a
table is called right, and mistakes are looked for."""

CLEARLY_LESS, SEVERAL_UNITS = 4, 5
"""The part of a difference that is left without a wrong number, and by how many half units this one is off at least."""

NOT_EXPLAINED = "No known mistake was found that explains this table."

TAKEN_AS_RIGHT_ANGLES = "Angles that round to those of the table were taken as multiples of 45 degrees."


@dataclass(frozen=True, eq=False, repr=False)
class Diagnosis:
    """The result of a diagnosis.

    verdict       "right"; "rounded", if the table differs from the arm by no more than the rounding of its numbers can, and 2 cm;
                  "undecided", if rounding or nearly parallel axes may explain the difference, and no mistake does; or "wrong"
    table, arm    the table that was diagnosed, and the arm
    comparison    of this table and the arm, up to the choices that are not fixed; if the table is "rounded", to within the rounding
    explanations  all explanations that are equally simple, the most plausible one first; empty if the table is right. If no slips
                  explain the table, the one with other numbers that describe the arm, as few as were found
    rounding      what the digits of the table show of their rounding, in words; "" with a given tolerance
    note          what was taken for granted
    """

    verdict: Literal["right", "rounded", "undecided", "wrong"]
    table: DHTable
    arm: Chain
    comparison: Equivalence
    explanations: Sequence[TableExplanation] = ()
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
            cause = f"its numbers may only be rounded ({self.rounding})" * bool(self.rounding)
            cause = cause or "axes are nearly parallel"
            lines = [f"Whether this table describes the arm cannot be decided: {cause}.", self.difference]
        return "\n".join([*lines, self.note]).rstrip()

    def _told_mistakes(self) -> list[str]:
        """Write the explanations, one in a line."""
        # Another number for the same entry is the same mistake.
        told = {tuple((f.name, f.row, f.column) for f in each.faults): each for each in reversed(self.explanations)}
        texts = [[fault.text for fault in each.faults] for each in reversed(told.values())]
        if not texts:
            return [f"{NOT_EXPLAINED} {self.difference}"]
        if len(texts) > 1:
            return ["Either: " + " ".join(texts[0]), *("or: " + " ".join(text) for text in texts[1:MAX_TOLD])]
        if self.explanations[0].is_a_choice:
            digits = " to the digits that are printed" * bool(self.rounding)
            head = f"The table describes the arm{digits} after these changes of choices that are fixed here:"
            return [head, *texts[0]]
        if len(texts[0]) > 2:
            head = "It would describe the arm with these numbers, the largest difference first:"
            return [NOT_EXPLAINED, head, *texts[0][:MAX_DIFFERENT_ENTRIES]]
        # Other pairs may lead to the same motions, so this one is no fact.
        return ["The table agrees with the arm after these changes:"] * (len(texts[0]) > 1) + texts[0]

    def _agreement(self) -> Iterator[str]:
        """Describe how well a table describes the arm, for the same q, and up to which choices."""
        digits = f" to the digits that are printed ({self.rounding})" if self.verdict == "rounded" else ""
        choices = explain_by_choices(self.table, self.comparison).faults
        metres, radians = measured_difference(self.table.to_chain(), self.arm)
        degrees = format_number(math.degrees(radians), 3, zero=1e-6)
        differ = f"differ by up to {format_number(metres, 3)} m and {degrees}°, at 1000 random configurations."
        if not choices:
            yield f"This table describes the arm{digits}" + (f"; their poses {differ}" if digits else ".")
            return
        yield f"For the same q, the poses of the table and of the arm {differ}"
        yield f"The table describes the arm{digits}, up to these choices:"
        yield from (fault.text for fault in choices)
        kinds = {name for name, fault in CHOICES.items() if any(each.name == fault for each in choices)}
        if changed := sum(fault.row is not None for fault in choices):  # zeros and signs
            fixed, exact = frozenset(CHOICES) - ({"base", "tool"} & kinds), np.zeros_like(self.table.rows)
            one_slip = explain_by_slips(self.table, self.arm, fixed, self.comparison.tolerance, 1, exact)
            told = [each.faults[0] for each in one_slip if each.faults[0].row is None or each.edits <= changed]
            texts = [fault.text for fault in told if fault.name != WRONG_NUMBER]
            yield from [f"If q is meant to be the same: {' Or: '.join(texts[:MAX_TOLD])}"] * bool(texts)
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
        plain = with_right_angles(table)
        half, _ = typed_half_units(plain.rows)
        noise = max(rounding_effect(plain, half), exact)
        is_other = bool(np.abs(plain.rows - table.rows).max() > TYPED_PI_ERROR)
        found = replace(found, rounding=typed_half_units(table.rows)[1], note=TAKEN_AS_RIGHT_ANGLES * is_other)
    near = equivalent(plain, arm, fixed=names, tolerance=noise)
    if near.verdict == "same" and near.difference <= MAX_ROUNDED_TOL:
        # A number that is off by several of its units is no rounded one, if nearly all of the difference goes with it. Up to free
        # choices, rounded tables have such numbers, too.
        bound, clear = near.difference / CLEARLY_LESS, list[TableExplanation]()
        if names >= {*CHOICES}:
            clear = explain_by_slips(plain, reference, names, bound, 1, SEVERAL_UNITS * half)
        return replace(found, verdict="wrong" if clear else "rounded", comparison=near, explanations=clear)
    # Rounding changes the angle of two neighbouring axes by no more than the angles of the rows between them.
    angles = np.array([neighbours(each)[0] for each in (plain.to_chain(), arm)])
    angles_agree = np.abs(angles[0] - angles[1]).max(initial=0.0) <= half[:, ANGLES].sum()
    is_near = near.verdict == "same" and angles_agree
    searches = [(plain, exact), *[(table, exact)] * bool((plain.rows != table.rows).any())]
    searches += [(plain, min(noise, MAX_ROUNDED_TOL))] * (noise > exact and not is_near)
    for start, bound in searches if compared.verdict == "different" else ():
        slips = 1 if is_near or bound > exact else 2  # two numbers can explain the rounding of all of them
        if explanations := _explanations(start, reference, names, bound, half, slips if in_pairs else 0):
            return replace(found, explanations=explanations)
    if is_near or "undecided" in {compared.verdict, near.verdict}:
        return replace(found, verdict="undecided")
    return replace(found, explanations=explain_by_numbers(plain, arm, names, half, noise) if in_pairs else [])


def _explanations(  # noqa: PLR0917
    table: DHTable, reference: Chain | DHTable, fixed: frozenset[str], bound: float, half: Array, max_slips: int
) -> Sequence[TableExplanation]:
    """Explain a table by one slip; or by choices that are fixed, or two slips, whichever changes less; with 0 only by one slip."""
    one = explain_by_slips(table, reference, fixed, bound, 1, half)
    if not max_slips or any(each.edits <= 1 for each in one):
        return one
    compared = equivalent(table, reference, tolerance=bound)
    choices = [explain_by_choices(table, compared, fixed)] * (bool(fixed) and compared.verdict == "same")
    is_found = bool(one) or any(each.edits <= 2 for each in choices)
    two = [] if is_found or max_slips < 2 else explain_by_slips(table, reference, fixed, bound, 2, half)
    several = [each for each in (one, two, choices) if each]
    return min(several, key=lambda found: found[0].edits + (found is two), default=[])
