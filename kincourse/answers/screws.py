"""Screw axes (omega, v) as answers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from misstep.answers.base import TOLERANCE
from misstep.answers.number import Numbers
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class ScrewsAnswer(Numbers):
    """Screw axes (omega, v) in rows, shape (n, 6), or a single one, shape (6,); each screw axis is a part.

    >>> ScrewsAnswer(np.eye(2, 6)).parts
    ['screw 1', 'screw 2']
    """

    names: Sequence[str] = ()
    noun: ClassVar[str] = "screw axes (omega, v), an array"

    @property
    def expected(self) -> str:
        several = super().expected
        return several if np.ndim(self.value) > 1 else several.replace("screw axes", "a screw axis")

    @property
    def parts(self) -> Sequence[str]:
        rows = 1 if self.value.ndim == 1 else len(self.value)
        return self.names or [f"screw {i + 1}" for i in range(rows)]

    def hint(self, given: Array, part: int) -> str:
        theirs, right = np.atleast_2d(given)[part], np.atleast_2d(self.value)[part]
        omega, v = (bool(np.allclose(theirs[half], right[half], atol=TOLERANCE)) for half in (slice(3), slice(3, 6)))
        if omega:
            return "Its omega is right, its v is not."
        return "Its v is right, its omega is not." if v else ""

    def remedy(self, shape: tuple[int, ...]) -> str:
        if shape == (3,) and np.shape(self.value) == (6,):
            return " A screw axis is (omega, v), six numbers: is the other half missing?"
        return super().remedy(shape)

    def part_indices(self) -> list[Any]:
        return [...] if self.value.ndim == 1 else list(range(len(self.value)))
