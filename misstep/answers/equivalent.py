"""Numbers of which several arrays are the same answer, such as a quaternion and its negative."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from misstep.answers.base import TOLERANCE, Named
from misstep.answers.likeness import IN_DEGREES
from misstep.answers.number import Numbers, scale_of
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class Equivalent(Numbers):
    """An array of numbers that is compared by its meaning, in one part: all arrays with the same meaning are the same answer.

    meaning  the function from an answer to an array of any shape that is equal for equal answers, and only for these
    scale    the size that matters in the meaning; by default `scale_of` its numbers

    >>> right = np.array([0.8, 0.6, 0.0, 0.0])  # a quaternion; its negative is the same rotation
    >>> answer = Equivalent(right, meaning=lambda q: np.outer(q, q))
    >>> answer.agrees(-right, right), answer.agrees(right[[1, 0, 2, 3]], right)
    ([True], [False])
    """

    meaning: Callable[[Array], Array] = field(kw_only=True)

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        mine, yours, right = (self.meaning(np.asarray(x, dtype=float)) for x in (one, other, self.value))
        size = scale_of(right) if self.scale is None else self.scale
        near = np.abs(mine - yours) <= tolerance * np.maximum(size, np.maximum(np.abs(mine), np.abs(yours)))
        return [bool(near.all())]

    def seen(self, given: Array, part: int | None) -> Named | None:
        """Return whether it is a placeholder or in degrees, by its meaning: an entry that differs from ours is not wrong for that."""
        likeness = Numbers.likeness(self, given, part)
        seen = likeness.placeholder() if part is None else likeness.at_sight()
        if seen and (part is None or seen[0] != "degrees"):
            return seen
        radians = np.where(self.angle_entries(), np.radians(given), given)
        fine = self.agrees(radians, self.value)
        is_in_degrees = self.angle_entries().any() and (all(fine) if part is None else fine[part])
        return ("degrees", IN_DEGREES) if is_in_degrees else None

    def resemblance(self, given: Array, part: int | None) -> Named | None:
        """Return what is true of all entries at once."""
        seen = None if part is None else self.likeness(given, part).resemblance()
        # Single entries of another right answer may differ from ours.
        return seen if seen and seen[0] in {"all signs", "factor", "doubled", "halved"} else None
