"""One row of a DH table as an answer: four numbers, judged one by one, angles up to whole turns."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from kinlib.check import Array
from kinlib.dh_rows import ANGLES, COLUMNS
from kinlib.practice.answers import TOLERANCE, Numbers


@dataclass(frozen=True, eq=False)
class Row(Numbers):
    """The numbers of one row, (4,), in the order a, alpha, d, theta: metres and radians.

    >>> Row(np.array([0.4, 0, 0, np.pi])).agrees(np.array([0.4, 0, 0, -np.pi]), np.array([0.4, 0, 0.1, np.pi]))
    [True, True, False, True]
    """

    noun: ClassVar[str] = "a, alpha, d, theta in metres and radians, an array"

    @property
    def parts(self) -> Sequence[str]:
        return COLUMNS

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        return same_row(one, other, tolerance)

    def hint(self, given: Array, part: int) -> str:
        if COLUMNS[part] in ANGLES and abs(given[part]) > 4 * np.pi:
            return "This is more than two full turns. Is it in degrees?"
        if abs(given[part] + self.value[part]) <= TOLERANCE:
            return "The size is right, the sign is not."
        return ""


def same_row(one: Array, other: Array, tolerance: float) -> list[bool]:
    """Compare two rows column by column, angles up to whole turns."""
    apart = np.abs(one - other)
    for column in ANGLES:
        k = COLUMNS.index(column)
        # A turn is measured as the chord that it makes: 2 sin(angle / 2), which knows no whole turns.
        apart[k] = np.abs(2 * np.sin(apart[k] / 2))
    allowed = tolerance * np.maximum(1.0, np.maximum(np.abs(one), np.abs(other)))
    allowed[[COLUMNS.index(column) for column in ANGLES]] = tolerance
    return [bool(fine) for fine in apart <= allowed]
