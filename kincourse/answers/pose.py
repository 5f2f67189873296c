"""Poses as answers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from misstep.answers.base import NEAR, TOLERANCE
from misstep.answers.number import Numbers
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class PoseAnswer(Numbers):
    """One pose, (4, 4); its rotation and its position are the parts, each with its share of the last row.

    >>> PoseAnswer(np.eye(4)).agrees(np.eye(4), np.diag([1, -1, -1, 1.0]))
    [False, True]
    """

    noun: ClassVar[str] = "a pose, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["rotation", "position"]

    def hint(self, given: Array, part: int) -> str:
        R = given[:3, :3]
        # Entries typed with three decimals make R^T R stray by a few thousandths; a real fault makes it stray by more.
        rigid = np.allclose(R.T @ R, np.eye(3), atol=NEAR) and np.linalg.det(R) > 0
        if part == 0 and not rigid:
            return "It is no rotation at all: its columns should be unit, square and right-handed."
        closed = np.allclose(given[3], (0, 0, 0, 1), atol=TOLERANCE)
        return "" if closed else "The last row of a pose is 0 0 0 1, whatever stands above it."

    def part_indices(self) -> list[Any]:
        return [np.s_[:, :3], np.s_[:, 3]]
