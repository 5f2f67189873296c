"""DH tables as answers: typed as text, dictionaries or numbers, and right if they describe the same mechanism.

The DH table of an arm is not unique, so tables are not compared entry by entry. Two tables agree if they are equivalent,
that is, if they describe the same mechanism up to the choice of zero configuration, joint signs, base and tool. With
`anchored`, these choices are given by the problem, and two tables agree only if their poses are the same for the same q.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import largest_difference, random_configurations
from kinlib.dh.diagnosis import Diagnosis, diagnose
from kinlib.dh.equivalence import equivalent
from kinlib.dh.table import DHTable
from misstep.answers.base import TOLERANCE, Answer, StoredObjects, Unreadable

MAX_TEXT_LENGTH = 10_000
"""Maximum number of characters of a typed table. A longer text is refused, because parsing it would take too long."""

POSE_TOLERANCE_FACTOR = 3
"""How many times the tolerance of one entry a pose may be off: the rounding errors of the rows add up along the arm."""


@dataclass(frozen=True, eq=False)
class DHTableAnswer(Answer):
    """A DH table of an arm, in a given convention.

    value     the right table; its convention, base and tool are those of the problem
    anchored  whether the poses must be equal for the same q; otherwise every equivalent table is right
    lengths   values in metres for the names of lengths that a typed table may use

    >>> import numpy as np
    >>> right = DHTable([[0.4, 0, 0, 0], [0.3, 0, 0, 0]], convention="standard")
    >>> flipped = DHTable([[-0.4, 0, 0, np.pi], [0.3, 0, 0, -np.pi]], convention="standard")
    >>> DHTableAnswer(right).agrees(flipped, right)
    [True]
    """

    stored_objects: ClassVar[StoredObjects] = {DHTable: DHTable.from_dict}

    value: DHTable
    anchored: bool = False
    lengths: Mapping[str, float] = field(default_factory=dict)

    @property
    def expected(self) -> str:
        return (
            f"a DH table in the {self.value.convention} convention with {self.value.n} joints ({self.value.joints}): "
            "text with a head such as 'a | alpha | d | theta', or one dictionary a row, with q1, q2, ... for what moves"
        )

    @property
    def parts(self) -> Sequence[str]:
        return ["the table"]

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
        if table.n != self.value.n:
            raise Unreadable(f"Expected {self.expected}; your table has {table.n} joints ({table.joints}).")
        return table

    def _between_given_ends(self, table: DHTable) -> DHTable:
        """The table with the base and the tool of the problem, if it has none of its own: only the rows are asked for."""
        if not self.anchored or table.n != self.value.n or all(self.agrees(table, self.value)):
            return table
        ends = {"base": (table.base, self.value.base), "tool": (table.tool, self.value.tool)}
        return table.changed(**{end: ours for end, (own, ours) in ends.items() if (own == np.eye(4)).all()})

    def _typed(self, given: Any) -> DHTable:
        if len(given) > (MAX_TEXT_LENGTH if isinstance(given, str) else 4 * len(self.value.rows)):
            raise Unreadable(f"Expected {self.expected}; got {validation.describe(given)}, which is too long.")
        named = isinstance(given, str) or any(isinstance(row, Mapping) for row in given)
        joints = "" if named else self.value.joints
        base, tool = self.value.base, self.value.tool
        return DHTable(
            given, convention=self.value.convention, joints=joints, base=base, tool=tool, lengths=self.lengths
        )

    def agrees(self, one: DHTable, other: DHTable, tolerance: float = TOLERANCE) -> list[bool]:
        if one.n != other.n or one.convention != other.convention:
            return [False]
        if not self.anchored:
            return [bool(equivalent(one, other, tolerance=POSE_TOLERANCE_FACTOR * tolerance, simplest=False))]
        q = random_configurations(one.n, 16)
        return [bool(largest_difference(one.fk(q), other.fk(q)) <= POSE_TOLERANCE_FACTOR * tolerance)]

    def explanation(self, given: DHTable, part: int) -> tuple[str, str] | None:
        """Return the name of the mistake in a wrong table and a sentence on it, or None if no known mistake explains it."""
        ours = self.value
        if given.convention != ours.convention:
            text = (
                f"Your table is in the {given.convention} convention, and the problem asks for the {ours.convention} one. Row i has "
                "$a_i$ and $\\alpha_i$ in the standard convention, $a_{i-1}$ and $\\alpha_{i-1}$ in the modified one."
            )
            return "other convention", text
        if given.joints != ours.joints:
            return (
                "variable in the wrong column",
                f"Its joints are {given.joints}; those of the arm are {ours.joints}. Which column holds the variable?",
            )
        diagnosis = self._diagnose(given)
        if diagnosis.right:
            return "another start", "Your table moves like the arm, from another start. " + _choices(diagnosis)
        if not diagnosis.faults:
            return None
        name = " and ".join(dict.fromkeys(fault.name for fault in diagnosis.faults))
        if name == "wrong number":
            # The right number would give the answer away, so the sentence names only the place.
            fault = diagnosis.faults[0]
            return name, f"All but one entry can stand: look again at {fault.column} in row {fault.row}."
        return name, str(diagnosis)

    def hint(self, given: DHTable, part: int) -> str:
        explained = self.explanation(given, part)
        return explained[1] if explained else self._diagnose(given).difference.replace("the table", "your table")

    def remark(self, given: DHTable) -> str:
        """Return how a right table differs from ours, where the rules leave a choice; "" if it does not."""
        if not self.anchored:
            return _choices(self._diagnose(given))
        if given.joints != self.value.joints:
            return ""
        theirs, ours = (_frames(table) for table in (given, self.value))
        choices = [
            choice
            for i, (own, other) in enumerate(zip(ours, theirs, strict=True))
            for choice in _frame_choices(i, own, other, given.convention)
        ]
        return f"It differs from ours where the rules leave a choice: {'; '.join(choices)}." if choices else ""

    def _diagnose(self, given: DHTable) -> Diagnosis:
        return diagnose(given, self.value, tolerance=POSE_TOLERANCE_FACTOR * TOLERANCE, in_pairs=False)


def _choices(diagnosis: Diagnosis) -> str:
    return " ".join(str(diagnosis).splitlines()[1:])


def _frames(table: DHTable) -> list[Array]:
    """The frames at q = 0, from frame 0 to the last one, as {s} sees them."""
    return list(accumulate([table.base, *table.link_transforms(np.zeros(table.n))], np.matmul))


def _frame_choices(i: int, ours: Array, theirs: Array, convention: str) -> Iterator[str]:
    """Describe how frame i of a table differs from ours, where it does by more than the accepted error."""
    tolerance = POSE_TOLERANCE_FACTOR * TOLERANCE
    x, z = theirs[:3, 0] @ ours[:3, 0], theirs[:3, 2] @ ours[:3, 2]
    if z < 1 - tolerance:
        joint = i + 1 if convention == "standard" else i
        yield f"z_{i} is reversed, so the variable of joint {joint} has a minus sign"
    if x < 1 - tolerance:
        turn = np.degrees(np.arccos(np.clip(x, -1, 1)))
        yield f"x_{i} is reversed" if turn > 180 - 1 else f"x_{i} is rotated by {turn:.3g} degrees"
    if (distance := np.linalg.norm(theirs[:3, 3] - ours[:3, 3])) > tolerance:
        yield f"O_{i} is {distance:.3g} m away"
