"""Angles as answers: the same after a full turn, and where several are asked for at once, in any order."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any, ClassVar

import numpy as np

from misstep.answers.base import ROUNDING_TOLERANCE
from misstep.answers.number import Numbers
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class Angles(Numbers):
    """Angles in radians, one or a few, (k,): 3 pi / 2 and -pi / 2 are one angle.

    any_order  whether the k angles are a set; each is a part

    >>> Angles(np.array([0.5, -0.5]), any_order=True).read([2 * np.pi - 0.5, 0.5]).round(9)
    array([ 0.5, -0.5])
    """

    unit: str = "rad"
    any_order: bool = False
    noun: ClassVar[str] = "angles, an array"

    @property
    def expected(self) -> str:
        return super().expected + (", in any order" if self.any_order else "")

    @property
    def parts(self) -> Sequence[str]:
        if self.value.ndim == 0:
            return ["the angle"]
        return (
            ["one angle", "the other angle"]
            if len(self.value) == 2
            else [f"angle {i + 1}" for i in range(self.value.size)]
        )

    def read(self, given: Any) -> Array:
        """Read angles, each within half a turn of the one that it is compared with.

        Raises Unreadable with what was expected and what came.
        """
        angles = super().read(given)
        if not self.any_order:
            return self._near(angles)
        # The order in which most of them are right, and the others nearest, is the one that was meant.
        orders = [self._near(angles[list(order)]) for order in permutations(range(len(angles)))]
        return min(orders, key=self._misfit)

    def _misfit(self, angles: Array) -> tuple[int, float]:
        off = np.abs(angles - self.value)
        return int(np.count_nonzero(off > ROUNDING_TOLERANCE)), float((off * off).sum())

    def _near(self, angles: Array) -> Array:
        turned: Array = self.value + np.remainder(angles - self.value + np.pi, 2 * np.pi) - np.pi
        return turned

    def part_indices(self) -> list[Any]:
        return [...] if self.value.ndim == 0 else list(range(len(self.value)))
