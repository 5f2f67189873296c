"""Rotations and poses as answers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from misstep.answers.base import ROUNDING_TOLERANCE, TOLERANCE
from misstep.answers.number import Numbers
from misstep.validation import Array

NOT_A_ROTATION = "It is no rotation at all: its columns should be unit, square and right-handed."


@dataclass(frozen=True, eq=False)
class RotationAnswer(Numbers):
    """One rotation matrix, shape (3, 3), in one part.

    >>> RotationAnswer(np.eye(3)).expected
    'a rotation, an array of shape (3, 3)'
    """

    noun: ClassVar[str] = "a rotation, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["the rotation"]

    def hint(self, given: Array, part: int) -> str:
        return "" if _is_rotation(given) else NOT_A_ROTATION


@dataclass(frozen=True, eq=False)
class PoseAnswer(Numbers):
    """One pose, shape (4, 4), in two parts: the rotation and the position, each with its entries of the last row.

    >>> PoseAnswer(np.eye(4)).agrees(np.eye(4), np.diag([1, -1, -1, 1.0]))
    [False, True]
    """

    noun: ClassVar[str] = "a pose, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["rotation", "position"]

    def hint(self, given: Array, part: int) -> str:
        if part == 0 and not _is_rotation(given[:3, :3]):
            return NOT_A_ROTATION
        closed = np.allclose(given[3], (0, 0, 0, 1), atol=TOLERANCE)
        return "" if closed else "The last row of a pose is 0 0 0 1, whatever stands above it."

    def part_indices(self) -> list[Any]:
        return [np.s_[:, :3], np.s_[:, 3]]


def _is_rotation(R: Array) -> bool:
    # Entries typed with three decimals change R^T R by a few thousandths, and a real mistake changes it by more.
    return bool(np.allclose(R.T @ R, np.eye(3), atol=ROUNDING_TOLERANCE) and np.linalg.det(R) > 0)
