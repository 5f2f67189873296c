"""Points and directions as answers."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from misstep.answers.base import ROUNDING_TOLERANCE
from misstep.answers.number import Numbers


@dataclass(frozen=True, eq=False)
class VectorsAnswer(Numbers):
    """Named vectors in rows, shape (k, 3); each vector is a part.

    >>> VectorsAnswer(np.eye(2, 3), names=["the point", "the direction"]).agrees(np.zeros((2, 3)), np.eye(2, 3))
    [False, False]
    """

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{super().expected}, in rows: {', '.join(self.names)}"

    @property
    def parts(self) -> Sequence[str]:
        return self.names

    def hint(self, given: Array, part: int) -> str:
        if np.allclose(np.sort(np.abs(given[part])), np.sort(np.abs(self.value[part])), atol=ROUNDING_TOLERANCE):
            return "Its components have the right sizes; their order or their signs are not right."
        return ""

    def part_indices(self) -> list[int]:
        return list(range(len(self.value)))
