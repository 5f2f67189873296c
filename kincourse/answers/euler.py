"""Angles of three rotations about coordinate axes as answers: all angles that give the right rotation are right."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.rigid.rpy import origin
from misstep.answers.base import TOLERANCE
from misstep.answers.number import ANGLE, Equivalent

ANGLES_TOLERANCE_FACTOR = 3
"""How many times the tolerance of one entry a rotation may be off: the rounding errors of three angles add up."""


def rpy_rotation(angles: Array) -> Array:
    """The rotation by roll, pitch and yaw, (3,) -> (3, 3)."""
    return origin(rpy=angles)[:3, :3]


@dataclass(frozen=True, eq=False)
class EulerAnglesAnswer(Equivalent):
    """Three angles for each of two rotations, in rows and in radians; the second rotation is at the singular case.

    Each row is a part, and right if it gives the right rotation.
    """

    noun: ClassVar[str] = "roll, pitch and yaw in radians, one row for each rotation, an array"
    meaning: Callable[[Array], Array] = field(default=rpy_rotation, kw_only=True)

    @property
    def parts(self) -> Sequence[str]:
        return ["the angles for $R_1$", "the angles for $R_2$"]

    def kinds(self) -> NDArray[np.int_]:
        return np.full(np.shape(self.value), ANGLE)

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        off = [np.abs(self.meaning(mine) - self.meaning(yours)).max() for mine, yours in zip(one, other, strict=True)]
        return [bool(distance <= ANGLES_TOLERANCE_FACTOR * tolerance) for distance in off]
