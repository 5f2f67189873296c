"""Points and directions as answers."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from misstep.answers.base import Named
from misstep.answers.likeness import Likeness, entries_hint
from misstep.answers.number import Numbers

XYZ = ("$x$", "$y$", "$z$")

HOMOGENEOUS = " These are homogeneous coordinates: leave off the last entry (1 for a point, 0 for a direction), so that x, y, z are left."

UNIT_TOLERANCE = 0.01
"""How far the length of a unit vector with two decimals may be from 1."""


@dataclass(frozen=True, eq=False)
class VectorsAnswer(Numbers):
    """Named vectors in rows, shape (k, 3); each vector is a part. Without names it is a single vector, shape (3,)."""

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{super().expected}, in rows: {', '.join(self.names)}" if self.names else super().expected

    @property
    def parts(self) -> Sequence[str]:
        return self.names or ["the answer"]

    def likeness(self, given: Array, part: int | None) -> Likeness:
        return replace(super().likeness(given, part), columns=XYZ)

    def check(self, given: Array, part: int) -> str:
        mine, right = (float(np.linalg.norm(X[self.part_indices()[part]])) for X in (given, self.value))
        if self.unit or abs(right - 1) > UNIT_TOLERANCE or abs(mine - 1) <= UNIT_TOLERANCE:
            return ""
        return f"A direction is a unit vector; the length of yours is {mine:.3g}."

    def resemblance(self, given: Array, part: int) -> Named | None:
        row = self._place(given, part)
        if found := self.likeness(given, part).resemblance() or (row if row and row[0] == "another row" else None):
            return found
        return entries_hint(self.same_entries(given, self.value)[self.part_indices()[part]], XYZ)

    def order(self, given: Array) -> Named | None:
        found = super().order(given)
        if found or not self.unit or np.ndim(self.value) < 2:
            return found
        steps = np.diff(self.value, axis=0, prepend=0 * self.value[:1])
        if all(self.agrees(given, steps)) and not all(self.agrees(steps, self.value)):
            text = (
                "These are the steps from each point to the next one. The points are wanted, each from the same origin."
            )
            return "steps", text
        return None

    def remedy(self, shape: tuple[int, ...]) -> str:
        if shape == (*np.shape(self.value)[:-1], 4):
            return HOMOGENEOUS
        return super().remedy(shape)

    def place(self, index: Sequence[Any]) -> str:
        component = XYZ[int(index[-1])]
        return f"{component} of {self.names[int(index[0])]}" if self.names else component
