"""Angles as answers: compared modulo a full turn, and if there are several, in any order if the problem allows it.

What a card says of degrees for radians is in misstep/display/sentences.py.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep.answers.accuracy import TOLERANCE
from misstep.answers.entries import Slip
from misstep.answers.likeness import Named
from misstep.answers.number import Numbers
from misstep.formulas.evaluation import numeral
from misstep.validation import Array

TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class Angles(Numbers):
    """One angle or k angles, shape (k,): 3 pi / 2 and -pi / 2 are the same angle. Each angle is a part.

    any_order  whether the order of the k angles is irrelevant

    >>> Angles(np.array([0.5, -0.5]), any_order=True).read([2 * np.pi - 0.5, 0.5]).round(9)
    array([ 0.5, -0.5])
    >>> bearing = Angles(np.array(np.pi / 2))
    >>> bearing.read("-270°").round(4)
    np.float64(1.5708)
    """

    unit: str = "rad"
    any_order: bool = False
    noun: ClassVar[str] = "angles, an array"

    def _within_half_a_turn(self, angle: Array) -> Array:
        return np.asarray((angle + np.pi) % TURN - np.pi)

    @property
    def expected(self) -> str:
        return super().expected + (", in any order" if self.any_order else "")

    @property
    def parts(self) -> Sequence[str]:
        if self._right.ndim == 0:
            return ["the angle"]
        return (
            ["one angle", "the other angle"]
            if len(self._right) == 2
            else [f"angle {i + 1}" for i in range(self._right.size)]
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

    def typed(self, text: str) -> float:
        plain = re.sub(r"\s*(deg|degrees?)$", "°", text.strip())
        return numeral(re.sub(r"\s*rad(ians?)?$", "", plain))

    def _difference(self, angles: Array) -> tuple[int, float]:
        error = angles - self._right
        return int(np.count_nonzero(~self.same_entries(angles, self._right))), float((error * error).sum())

    def _modulo_turns(self, angles: Array) -> Array:
        shifted = self._right + self._within_half_a_turn(angles - self._right)
        # An angle of more than two turns is most likely in degrees. It keeps its size, and with it its precision.
        return np.where(np.abs(angles) > 2 * TURN, angles, shifted)

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        size = np.maximum(self._scales, np.minimum(np.abs(one), np.abs(other)))
        far = (np.abs(one) > 2 * TURN) & (np.abs(other) > 2 * TURN)  # in another unit, where this turn means nothing
        difference = np.where(far, one - other, self._within_half_a_turn(one - other))
        return np.asarray(np.abs(difference) <= tolerance * size, dtype=bool)

    def appearance(self, given: Array, part: int | None) -> Named | None:
        if part is None and (seen := self._placeholder(given)):
            return seen
        if part is not None or not self.any_order:
            return super().appearance(given, part)
        # The order in which most angles are right does not count if none is, as with degrees.
        orders = (given[list(order)] for order in permutations(range(len(given))))
        return next(filter(None, (self.likeness(angles, None).at_sight() for angles in orders)), None)

    def _placeholder(self, given: Array) -> Named | None:
        return replace(self.likeness(given, None), mine=self._within_half_a_turn(given)[..., None]).placeholder()

    def arrangement(self, given: Array) -> Named | None:
        found = super().arrangement(given)
        if found and found[0] not in {"doubled", "halved"}:
            return found
        # A full turn more has another half.
        halves = [angles / 2 for angles in (self._within_half_a_turn(self._right), self._right % TURN)]
        for name, text, values in (("doubled", "twice", [2 * self._right]), ("halved", "half of", halves)):
            if len(self.parts) > 1 and any(self._are_the_same(given, value) for value in values):
                return name, f"These are {text} the right angles."
        return None

    def _are_the_same(self, given: Array, angles: Array) -> bool:
        orders = permutations(range(len(angles))) if self.any_order else [range(len(angles))]
        return any(self.same_entries(given, angles[list(order)]).all() for order in orders)

    def _factor_slips(self) -> Iterator[Slip]:
        # Twice an angle is the same angle for all its numbers; half of it is not.
        largest = np.abs(self._right).max()
        for name, value, *texts in super()._factor_slips():
            if name == "doubled":
                also = ", up to full turns." if 2 * largest > TURN / 2 else "."
                yield (name, value, *(text.removesuffix(".") + also for text in texts))
            elif name == "halved" and largest <= TURN / 2:
                yield (name, value, *texts)

    def place(self, index: Sequence[Any]) -> str:
        return self.parts[int(index[0])]

    def whole_slips(self) -> Iterator[Slip]:
        yield from super().whole_slips()
        X = self._right
        half, names = np.pi, ("$\\pi$", "$\\pi/2$")
        yield ("half a turn off", X + half, "Your answer is half a turn off.", "This is half a turn off.")
        yield (
            "supplement",
            half - X,
            f"Your answer is {names[0]} minus the right one.",
            f"This is {names[0]} minus the right angle.",
        )
        other = "the angle from the other axis, or the arcsine in place of the arccosine."
        yield (
            "complement",
            half / 2 - X,
            f"Your answer is {names[1]} minus the right one: {other}",
            f"This is {names[1]} minus the right angle: {other}",
        )

    def part_indices(self) -> list[Any]:
        return [...] if self._right.ndim == 0 else list(range(len(self._right)))
