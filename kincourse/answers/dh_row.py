"""Entries or one row of a DH table as an answer: each entry is judged by itself, and angles modulo a full turn."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS, is_plausible_angle
from misstep.answers.base import TOLERANCE
from misstep.answers.number import Numbers


@dataclass(frozen=True, eq=False)
class DHEntriesAnswer(Numbers):
    """Named entries of a DH table, shape (k,): lengths in metres, angles in radians.

    An entry is an angle if its name contains alpha or theta. Each entry is a part.

    >>> DHEntriesAnswer(np.array([0.4, np.pi]), names=["a_1", "theta_1"]).agrees(np.array([0.4, -np.pi]), np.array([0.4, np.pi]))
    [True, True]
    """

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{len(self.names)} numbers, {', '.join(self.names)}, lengths in metres and angles in radians"

    @property
    def parts(self) -> Sequence[str]:
        # A card capitalizes the first word of a sentence, and "A_1" (a link transform) is not a_1 (a length).
        return [name if " " in name else f"entry {name}" for name in self.names]

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        same = super().agrees(one, other, tolerance)
        # The chord 2 sin(x / 2) of an angular difference x does not change when x changes by a full turn.
        chord = np.abs(2 * np.sin((one - other) / 2)) <= tolerance
        return [bool(chord[k]) if self._is_angle(k) else same[k] for k in range(len(self.names))]

    def hint(self, given: Array, part: int) -> str:
        if self._is_angle(part) and not is_plausible_angle(given[part]):
            return f"This is read as {given[part]:g} rad, more than a full turn. Is it in degrees?"
        if abs(given[part] + self.value[part]) <= TOLERANCE:
            return "The size is right, the sign is not."
        return ""

    def part_indices(self) -> list[int]:
        return list(range(len(self.names)))

    def _is_angle(self, part: int) -> bool:
        return any(angle in self.names[part] for angle in ANGLE_COLUMNS)


@dataclass(frozen=True, eq=False)
class DHRowAnswer(DHEntriesAnswer):
    """One row of a DH table, shape (4,): a, alpha, d, theta, in metres and radians. Each entry is a part.

    >>> DHRowAnswer(np.array([0.4, 0, 0, np.pi])).agrees(np.array([0.4, 0, 0, -np.pi]), np.array([0.4, 0, 0.1, np.pi]))
    [True, True, False, True]
    """

    names: Sequence[str] = COLUMNS
    noun: ClassVar[str] = "row"
