"""Numbers and arrays of numbers as answers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from misstep import validation
from misstep.answers.base import MAX_NUMBER, TOLERANCE, Answer, Unreadable
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class Numbers(Answer):
    """An array of real numbers of a given shape.

    unit  the unit of all numbers, for feedback

    The array is one part, unless a subclass overrides `parts` and `part_indices`.

    >>> Numbers(np.array([1.0, 2.0]), unit="m").read([1, 2])
    array([1., 2.])
    """

    value: Array
    unit: str = ""
    noun: ClassVar[str] = "an array"

    @property
    def expected(self) -> str:
        shape = np.shape(self.value)
        what = f"{self.noun} of shape {shape}" if shape else "one number"
        return f"{what} in {self.unit}" if self.unit else what

    @property
    def parts(self) -> Sequence[str]:
        return ["the answer"]

    def read(self, given: Any) -> Array:
        expected_shape = np.shape(self.value)
        try:
            shape = np.shape(given)
        except Exception as error:  # reading the shape of a student's object may raise any error
            raise Unreadable(f"Expected {self.expected}; got {_kind(given)} whose rows differ in length.") from error
        if shape != expected_shape:
            description = f"{_kind(given)} of shape {shape}" if shape else validation.brief(given)
            raise Unreadable(f"Expected {self.expected}; got {description}.{self.remedy(shape)}")
        try:
            values = validation.array(given, "your answer")
        except ValueError as error:
            raise Unreadable(f"Expected {self.expected}. {_sentence(str(error))}") from error
        except Exception as error:
            raise Unreadable(
                f"Expected {self.expected}; got {_kind(given)} that does not turn into numbers."
            ) from error
        if (largest := np.abs(values).max(initial=0.0)) > MAX_NUMBER:
            raise Unreadable(f"Expected {self.expected}; got {largest:.3g}. Was there a division by almost zero?")
        return values

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        allowed = tolerance * np.maximum(1.0, np.maximum(np.abs(one), np.abs(other)))
        same = np.abs(one - other) <= allowed
        return [bool(np.all(same[piece])) for piece in self.part_indices()]

    def part_indices(self) -> list[Any]:
        """Return, for each part, the index of its entries in the array."""
        return [...]

    def pins_down(self, given: Array, part: int) -> bool:
        entries = np.abs(given[self.part_indices()[part]])
        return bool(np.count_nonzero(np.minimum(entries, np.abs(entries - 1)) > TOLERANCE) >= 2)

    def remedy(self, shape: tuple[int, ...]) -> str:
        """Return a sentence on how to repair an answer of this wrong shape, with a leading space; "" if there is none."""
        expected = np.shape(self.value)
        if len(shape) == 2 and shape[::-1] == expected:
            return " Rows and columns are swapped: try .T."
        if np.prod(shape) == np.prod(expected):
            return f" The count of numbers is right, the arrangement is not: try np.reshape(..., {expected})."
        return ""


def _kind(given: Any) -> str:
    name = type(given).__name__
    return f"{'an' if name == 'ndarray' or name[:1] in 'aeiouAEIOU' else 'a'} {name}"


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:]
