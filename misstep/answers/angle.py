"""Angles as answers: compared modulo a full turn, and if there are several, in any order if the problem allows it."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep.answers.base import TOLERANCE, Named
from misstep.answers.number import Numbers
from misstep.formulas.evaluation import numeral
from misstep.mutants.expression import Slip
from misstep.validation import Array

TURN = 2 * np.pi

SLIPS = (
    Slip("sign", "take the angle with the opposite sign", lambda x: -x),
    Slip("half a turn", "add half a turn", lambda x: x + np.pi),
    Slip("supplement", "take $\\pi$ minus the angle", lambda x: np.pi - x),
    Slip("complement", "take $\\pi/2$ minus the angle, as from the other axis", lambda x: np.pi / 2 - x),
    Slip("doubled", "take twice the angle", lambda x: 2 * x),
    Slip("halved", "take half of the angle", lambda x: ((x + np.pi) % TURN - np.pi) / 2),
    Slip("halved", "take half of the angle", lambda x: x % TURN / 2),
)
"""The slips that people make in any angle."""


@dataclass(frozen=True, eq=False)
class Angles(Numbers):
    """One angle or k angles in radians, shape (k,): 3 pi / 2 and -pi / 2 are the same angle. Each angle is a part.

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

    @property
    def parts(self) -> Sequence[str]:
        count = np.size(self.value)
        if np.ndim(self.value) == 0:
            return ["the angle"]
        return ["one angle", "the other angle"] if count == 2 else [f"angle {i + 1}" for i in range(count)]

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
        error, wrong = angles - self.value, int(np.count_nonzero(~self.same_entries(angles, self.value)))
        # The order in which most angles are right does not count if none is, as with degrees.
        return 0 if self.likeness(angles, None).at_sight() else wrong, float((error * error).sum())

    def _modulo_turns(self, angles: Array) -> Array:
        shifted = self.value + _within_half_a_turn(angles - self.value)
        # An angle of more than two turns is most likely in degrees. It keeps its size, and with it its precision.
        return np.where(np.abs(angles) > 2 * TURN, angles, shifted)

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        size = np.maximum(self._scales, np.minimum(np.abs(one), np.abs(other)))
        far = (np.abs(one) > 2 * TURN) & (np.abs(other) > 2 * TURN)  # in another unit, where this turn means nothing
        difference = np.where(far, one - other, _within_half_a_turn(one - other))
        return np.asarray(np.abs(difference) <= tolerance * size, dtype=bool)

    @property
    def slips(self) -> Sequence[Slip]:
        return SLIPS

    def placeholder(self, given: Array) -> Named | None:
        return replace(self.likeness(given, None), mine=_within_half_a_turn(given)[..., None]).placeholder()


def _within_half_a_turn(angle: Array) -> Array:
    return np.asarray((angle + np.pi) % TURN - np.pi)
