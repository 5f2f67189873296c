"""Angles as answers: compared modulo a full turn, and if there are several, in any order if the problem allows it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep.answers.base import TOLERANCE
from misstep.answers.number import Numbers, Slip
from misstep.validation import Array


def _within_half_a_turn(angle: Array) -> Array:
    return np.asarray(np.remainder(angle + np.pi, 2 * np.pi) - np.pi)


@dataclass(frozen=True, eq=False)
class Angles(Numbers):
    """One angle or k angles, shape (k,), in radians: 3 pi / 2 and -pi / 2 are the same angle. Each angle is a part.

    any_order  whether the order of the k angles is irrelevant

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
        """Read angles, each shifted by full turns to within half a turn of the one with which it is compared.

        Raises Unreadable with what was expected and what was given.
        """
        angles = super().read(given)
        if not self.any_order:
            return self._modulo_turns(angles)
        # Take the order in which most angles are right and the others are nearest: the student most likely meant this one.
        orders = [self._modulo_turns(angles[list(order)]) for order in permutations(range(len(angles)))]
        return min(orders, key=self._difference)

    def _difference(self, angles: Array) -> tuple[int, float]:
        error = angles - self.value
        return int(np.count_nonzero(~self.same_entries(angles, self.value))), float((error * error).sum())

    def _modulo_turns(self, angles: Array) -> Array:
        shifted = self.value + _within_half_a_turn(angles - self.value)
        # An angle of more than two turns is most likely in degrees. It keeps its size, and with it its precision.
        return np.where(np.abs(angles) > 4 * np.pi, angles, shifted)

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        size = np.maximum(self._scales, np.minimum(np.abs(one), np.abs(other)))
        return np.asarray(np.abs(_within_half_a_turn(one - other)) <= tolerance * size)

    def place(self, index: Sequence[Any]) -> str:
        return self.parts[int(index[0])]

    def whole_slips(self) -> Iterator[Slip]:
        yield from super().whole_slips()
        yield ("half a turn off", self.value + np.pi, "Your answer is half a turn off.", "This is half a turn off.")
        yield (
            "supplement",
            np.pi - self.value,
            "Your answer is pi minus the right one.",
            "This is pi minus the right angle.",
        )
        yield (
            "complement",
            np.pi / 2 - self.value,
            "Your answer is pi/2 minus the right one: the angle from the other axis, or the arcsine in place of the arccosine.",
            "This is pi/2 minus the right angle: the angle from the other axis, or the arcsine in place of the arccosine.",
        )

    def part_indices(self) -> list[Any]:
        return [...] if self.value.ndim == 0 else list(range(len(self.value)))
