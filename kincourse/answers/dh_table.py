"""DH tables as answers: typed as text, dictionaries or numbers, and right if they describe the same mechanism.

The DH table of an arm is not unique, so tables are not compared entry by entry. Two tables agree if they are equivalent,
that is, if they describe the same mechanism up to the choice of zero configuration, joint signs, base and tool. With
`anchored`, these choices are given by the problem, and two tables agree only if their poses are the same for the same q.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from kinlib.arrays import validation
from kinlib.chains.chain import largest_difference, random_configurations
from kinlib.dh.diagnosis import diagnose
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
            table = given
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
        if one.n != other.n:
            return [False]
        if not self.anchored:
            return [bool(equivalent(one, other, tolerance=POSE_TOLERANCE_FACTOR * tolerance, simplest=False))]
        q = random_configurations(one.n, 16)
        return [bool(largest_difference(one.fk(q), other.fk(q)) <= POSE_TOLERANCE_FACTOR * tolerance)]

    def hint(self, given: DHTable, part: int) -> str:
        if given.joints != self.value.joints:
            return f"Its joints are {given.joints}; those of the arm are {self.value.joints}. Which column holds the variable?"
        diagnosis = diagnose(given, self.value, tolerance=POSE_TOLERANCE_FACTOR * TOLERANCE, in_pairs=False)
        if diagnosis.right:
            return "Your table moves like the arm, from another start. " + " ".join(str(diagnosis).splitlines()[1:])
        if [fault.name for fault in diagnosis.faults] == ["wrong number"]:
            # The right number would give the answer away, so the hint names only the place.
            return f"All but one entry can stand: look again at {diagnosis.faults[0].column} in row {diagnosis.faults[0].row}."
        if diagnosis.faults:
            return str(diagnosis)
        return diagnosis.difference.replace("the table", "your table")
