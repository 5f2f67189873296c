"""DH tables as answers: typed as text, dictionaries or numbers, and right if they describe the same mechanism.

The DH table of an arm is not unique, so tables are not compared entry by entry. Two tables agree if they are equivalent,
that is, if they describe the same mechanism up to the choice of zero configuration, joint signs, base and tool. With
`anchored`, these choices are given by the problem, and two tables agree only if their poses are the same for the same q. Then each
row is a part: those rows are wrong without which, as few as possible, the others could stay as they are.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from kincourse.answers.dh_row import has_a_telling_row
from kincourse.answers.table_rows import POSE_TOLERANCE_FACTOR, wrong_rows
from kincourse.mistakes.dh import slips_of_table, symbol, with_symbols
from kinlib.arrays import validation
from kinlib.chains.chain import largest_difference, random_configurations
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import Equivalence, equivalent
from kinlib.dh.slips import CHOICES, Fault
from kinlib.dh.table import DHTable
from misstep.answers.base import TOLERANCE, Answer, Named, Unreadable
from misstep.answers.likeness import UNTOUCHED
from misstep.diagnosis.explanation import MAX_ALTERNATIVES
from misstep.mutants.expression import Slip
from misstep.storage import OBJECTS

MAX_TEXT_LENGTH = 10_000
"""Maximum number of characters of a typed table. A longer text is refused, because parsing it would take too long."""

ENDS = {
    "base": "Your first row begins in {s}. The problem gives frame 0, which is not {s}, so the way from {s} to it is in no row.",
    "tool": "Your last row ends at the tool. The problem gives the last frame, so the way from it to the tool is in no row.",
}
"""What is said of rows that lead from {s} to the tool, where a base and a tool are given."""


@dataclass(frozen=True, eq=False)
class DHTableAnswer(Answer):
    """A DH table of an arm, in a given convention.

    value     the right table; its convention, base and tool are those of the problem
    anchored  whether the poses must be equal for the same q; otherwise every equivalent table is right
    printed   whether the statement prints most rows, so that they earn nothing
    lengths   values in metres for the names of lengths that a typed table may use
    """

    value: DHTable
    anchored: bool = False
    printed: bool = False
    lengths: Mapping[str, float] = field(default_factory=dict)

    @property
    def expected(self) -> str:
        return (
            f"a DH table in the {self.value.convention} convention with {self.value.n} joints ({self.value.joints}): "
            "text with a header such as 'a | alpha | d | theta', or one dictionary per row, with q1, q2, ... for the joint variables"
        )

    @property
    def parts(self) -> Sequence[str]:
        is_by_row = self.anchored and not self.printed
        return [f"row {i + 1}" for i in range(self.value.n)] if is_by_row else ["the table"]

    def read(self, given: Any) -> DHTable:
        if isinstance(given, DHTable):
            table = self._between_given_ends(given)
        else:
            try:
                table = self._typed(given)
            except Unreadable:
                raise
            except Exception as error:  # a student's object may raise any exception when it is read
                reason = str(error) if isinstance(error, ValueError) else f"Got {validation.describe(given)}."
                raise Unreadable(f"Expected {self.expected}. {reason}") from error
        if (table.n, table.convention) != (self.value.n, self.value.convention):
            is_short = table.n != self.value.n
            yours = f"has {table.n} joints ({table.joints})" if is_short else f"is in the {table.convention} convention"
            raise Unreadable(f"Expected {self.expected}; your table {yours}.")
        return table

    def _between_given_ends(self, table: DHTable) -> DHTable:
        """The table with the base and the tool of the problem, if it has none of its own: only the rows are asked for."""
        if not self.anchored or table.n != self.value.n or _is_same(table, self.value):
            return table
        ends = {"base": (table.base, self.value.base), "tool": (table.tool, self.value.tool)}
        return table.changed(**{end: ours for end, (own, ours) in ends.items() if (own == np.eye(4)).all()})

    def _typed(self, given: Any) -> DHTable:
        if len(given) > (MAX_TEXT_LENGTH if isinstance(given, str) else 4 * len(self.value.rows)):
            raise Unreadable(f"Expected {self.expected}; got {validation.describe(given)}, which is too long.")
        named = isinstance(given, str) or any(isinstance(row, Mapping) for row in given)
        joints = "" if named else self.value.joints
        given = given if named else np.reshape(given, (-1, 4))  # the numbers may be listed one after the other
        base, tool = self.value.base, self.value.tool
        return DHTable(
            given, convention=self.value.convention, joints=joints, base=base, tool=tool, lengths=self.lengths
        )

    def agrees(self, one: DHTable, other: DHTable, tolerance: float = TOLERANCE) -> list[bool]:
        if not self.anchored:
            return [equivalent(one, other, tolerance=POSE_TOLERANCE_FACTOR * tolerance).verdict == "same"]
        is_same = _is_same(one, other, tolerance)
        if is_same or self.printed or one.joints != other.joints or other != self.value:
            return [is_same] * len(self.parts)
        wrong = self._wrong_rows(one)
        return [i not in wrong for i in range(one.n)]

    def _wrong_rows(self, given: DHTable) -> Sequence[int]:
        """The rows that must be changed, as few as possible: those of a single mistake rather than others."""
        fewest = wrong_rows(given, self.value)
        for each in self._diagnose(given).explanations:
            if each.is_a_choice:
                continue
            wrong, right = (np.column_stack([table.rows, table.signs]) for table in (given, each.corrected))
            changed: list[int] = np.flatnonzero((wrong != right).any(axis=1)).tolist()
            if 0 < len(changed) <= len(fewest):
                return changed
        return fewest

    def counts(self, given: DHTable, right: Sequence[bool]) -> bool:
        """Return whether a right row is not so short that any method gives it, and no mistake runs through the whole table."""
        found = [one for one in self._diagnose(given).explanations if not one.is_a_choice]
        runs_through = sum(right) < len(right) - 1 and any(one.faults[0].row is None for one in found[:1])
        return has_a_telling_row(given.rows, right) and not runs_through

    def placeholder(self, given: DHTable) -> Named | None:
        if given.rows.any() or not self.value.rows.any():
            return None
        return "placeholder", UNTOUCHED.format("Every number is 0")

    @property
    def slips(self) -> Sequence[Slip]:
        """The slips in the whole table that cannot be undone in a wrong table, because numbers are lost, and signs of q."""
        return slips_of_table(self.value)

    def resemblance(self, given: DHTable, part: int) -> Named | None:
        """Return the name of the mistake in a wrong table and a sentence on it, or how it differs from the right one."""
        return self._fault(given) or self._difference(given)

    def _fault(self, given: DHTable) -> Named | None:
        ours = self.value
        if given.joints != ours.joints:
            return (
                "variable in the wrong column",
                f"Its joints are {given.joints}; those of the arm are {ours.joints}. Which column holds the variable?",
            )
        for end, text in ENDS.items() if self.anchored else ():
            without = given.changed(**{end: np.eye(4)})
            if (getattr(ours, end) != np.eye(4)).any() and all(self.agrees(without, ours)):
                return f"{end} forgotten", text
        diagnosis = self._diagnose(given)
        # Rows that were typed have the base and the tool of the problem, so these are not what is wrong.
        sound = {
            f"wrong {end}"
            for end in ENDS
            if np.allclose(getattr(given, end), getattr(ours, end), rtol=0, atol=TOLERANCE)
        }
        explanations = [
            one.faults
            for one in diagnosis.explanations
            if not one.is_a_choice and not any(f.name in sound for f in one.faults)
        ]
        wrong = {i + 1 for i in self._wrong_rows(given)} if len(self.parts) > 1 else set()
        fitting = [faults for faults in explanations if all(fault.row in {None, *wrong} for fault in faults)]
        if fitting or (explanations and len(wrong) != 1):
            name, text = _described(fitting or explanations)
            if len(wrong) == 1:  # the name of the part tells the row
                text = text.replace(f"Row {min(wrong)}: ", "").replace("In one row, ", "").partition("\nLook at row")[0]
            return name, text[:1].upper() + text[1:]
        free = equivalent(given, self.value, tolerance=POSE_TOLERANCE_FACTOR * TOLERANCE) if self.anchored else None
        if free is None or free.verdict != "same":
            return None
        return "another start", f"Your table moves like the arm, from another start. {_choices(free)}"

    def _difference(self, given: DHTable) -> Named | None:
        if self.agrees(given, self.value).count(False) == 1 < len(self.parts):
            return "wrong row", "All other rows can stay as they are. Look at the numbers of this one."
        difference = self._diagnose(given).difference.replace("the table", "your table")
        return ("other axes", difference) if difference else None

    def check(self, given: DHTable, part: int) -> str:
        """Return where the table ends at q = 0, which is drawn, if base, tool and joint values are those of the problem."""
        if not self.anchored:
            return ""
        mine, right = (table.fk(np.zeros(table.n)) for table in (given, self.value))
        tolerance = POSE_TOLERANCE_FACTOR * TOLERANCE
        if largest_difference(mine, right) <= tolerance:
            return "At $q = 0$ your table is right."
        # What a student multiplies are the rows, without the base and the tool, which the statement may not give.
        own, other = (
            table.changed(base=np.eye(4), tool=np.eye(4)).fk(np.zeros(table.n))[:3, 3] for table in (given, self.value)
        )
        if np.abs(own - other).max() <= tolerance:
            return "At $q = 0$ your last frame has other axes."
        place = ", ".join(f"{x:.4g}" for x in own.round(4) + 0.0)
        return f"At $q = 0$ your last frame is at $({place})$ in frame 0."

    def remark(self, given: DHTable) -> str:
        """Return the choices in which a right table differs from ours, if the problem leaves them; "" if it does not."""
        return "" if self.anchored else _choices(self._diagnose(given).comparison)

    def _diagnose(self, given: DHTable) -> Diagnosis:
        return _diagnosis(given, self.value, self.anchored)


def _is_same(one: DHTable, other: DHTable, tolerance: float = TOLERANCE) -> bool:
    """Whether two tables in one convention have the same poses for the same q."""
    q = random_configurations(one.n, 16)
    return bool(largest_difference(one.fk(q), other.fk(q)) <= POSE_TOLERANCE_FACTOR * tolerance)


OBJECTS["DHTable"] = DHTable.from_dict


@lru_cache(maxsize=16)
def _diagnosis(given: DHTable, right: DHTable, anchored: bool) -> Diagnosis:
    fixed = CHOICES if anchored else ()
    return diagnose(given, right, fixed, tolerance=POSE_TOLERANCE_FACTOR * TOLERANCE, in_pairs=False)


def _choices(found: Equivalence) -> str:
    """Describe the choices in which a table differs from ours, each in a sentence."""
    return " ".join(f"{fault.text[0].upper()}{fault.text[1:]}" for fault in found.choices())


def _described(alternatives: Sequence[Sequence[Fault]]) -> tuple[str, str]:
    """Name and describe the faults of each explanation. A right number would give the answer away, so only its place is named."""
    names = [" and ".join(dict.fromkeys(one.name for one in faults)) for faults in alternatives]
    name = " or ".join(list(dict.fromkeys(names))[:MAX_ALTERNATIVES])
    if all([fault.name for fault in faults] == ["wrong number"] for faults in alternatives):
        places = list(dict.fromkeys(f"{symbol(str(fault.column))} in row {fault.row}" for (fault,) in alternatives))
        return name, f"All but one entry can stay as they are.\nLook again at {' or '.join(places[:MAX_ALTERNATIVES])}."
    texts = [
        " ".join(
            f"Row {fault.row}: {fault.column} has a wrong number." if fault.name == "wrong number" else fault.text
            for fault in faults
        )
        for faults in alternatives
    ]
    texts = list(dict.fromkeys(map(with_symbols, texts)))[:MAX_ALTERNATIVES]
    text = texts[0] if len(texts) == 1 else f"Either: {' Or: '.join(texts)}"
    rows = {fault.row for faults in alternatives[:1] for fault in faults}
    if len(texts) == 1 and len(rows) == 1 and text.startswith("Row ") and text.count("Row ") == 1:
        place, _, what = text.partition(": ")
        text = f"In one row, {what[0].lower()}{what[1:]}\nLook at row {place.removeprefix('Row ')}."
    return name, text
