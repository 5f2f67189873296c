"""Numbers and arrays of numbers as answers; of some several arrays are the same answer, as of a quaternion and its negative."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import floor, log10
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep import validation
from misstep.answers.base import MAX_NUMBER, TOLERANCE, Answer, Named, Unreadable
from misstep.answers.likeness import ANGLE, IN_DEGREES, KINDS, OTHER, PURE, ROUND_OFF, Likeness, entries_hint, place_of
from misstep.formulas.evaluation import numeral
from misstep.validation import Array


@dataclass(frozen=True, eq=False)
class Numbers(Answer):
    """A number, or an array of numbers of a given shape.

    value  the right numbers
    unit   the unit of all numbers, for feedback
    scale  a size that matters, as one number or one for each entry; by default `scale_of` the numbers of the same kind
    test   a check of each part that a student can do, in a sentence with the own numbers; "" if the part passes it

    A number may be off by a thousandth of itself, or of its scale: three digits of the largest number of its kind are enough,
    0 is right for 1e-17, and wrong for 3e-7. The array is one part, unless a subclass overrides `parts`. A vector, and whatever
    `may_be_listed`, may also be a list, a row or a column of its numbers, one after the other.

    >>> Numbers(np.array([1.0, 2.0]), unit="m").read([1, "4/2 m"])
    array([1., 2.])
    >>> small = Numbers(np.array(3e-7))
    >>> small.agrees(np.array(0.0), small.value), small.agrees(np.array(3e-7), small.value)
    ([False], [True])
    """

    value: Any
    unit: str = ""
    scale: Any = field(default=None, kw_only=True)
    test: Callable[[Any], str] | None = field(default=None, kw_only=True)
    noun: ClassVar[str] = "an array"
    may_be_listed: ClassVar[bool] = False

    @property
    def expected(self) -> str:
        shape = np.shape(self.value)
        what = f"{self.noun} of shape {shape}" if shape else "one number"
        return what + (f" in {self.unit}" if self.unit else "")

    @property
    def parts(self) -> Sequence[str]:
        return ["the answer"]

    def part_indices(self) -> list[Any]:
        """Return, for each part, the index of its entries in the array: a single part has all, and several have a row each."""
        count = len(self.parts)
        return [...] if count == 1 and np.shape(self.value)[:1] != (1,) else list(range(count))

    def core_indices(self) -> list[Any]:
        """Return, for each part, the index of the entries that make it up, without those that are always the same."""
        return self.part_indices()

    def read(self, given: Any) -> Array:
        def refused(what: str) -> Unreadable:
            return Unreadable(f"Expected {self.expected}; got {what}")

        expected = np.shape(self.value)
        try:
            shape = np.shape(given)
        except Exception as error:  # reading the shape of a student's object may raise any error
            raise refused(f"{_kind(given)} whose rows differ in length.") from error
        count, is_list = np.size(self.value), self.may_be_listed or len(expected) < 2  # [x] can only mean x
        if shape != expected and is_list and shape in ((count,), (count, 1), (1, count)):
            given = np.reshape(given, expected)
        elif shape != expected:
            quotes = " Give a list without quotes around it." if isinstance(given, str) and expected else ""
            found = f"{_kind(given)} of shape {shape}" if shape else validation.brief(given)
            raise refused(f"{found}.{quotes or self.remedy(shape)}")
        try:
            values = validation.array(self._with_typed(given), "your answer")
        except ValueError as error:
            text = str(error)
            raise Unreadable(f"Expected {self.expected}. {text[0].upper()}{text[1:]}") from error
        except Exception as error:
            raise refused(f"{_kind(given)} that does not turn into numbers.") from error
        if (largest := np.abs(values).max(initial=0)) > MAX_NUMBER:
            raise refused(f"{largest:.3g}. Was there a division by almost zero?")
        return values

    def _with_typed(self, given: Any) -> Any:
        """Return numbers in which those that are typed as text are read. Raises ValueError for text that is no number."""
        values = np.asarray(given)
        entries = values.ravel().tolist() if values.dtype.kind in "OU" else []
        if not any(isinstance(x, str) for x in entries):
            return given
        filled = np.empty(values.shape, dtype=object)
        filled.ravel()[:] = [self.typed(x) if isinstance(x, str) else x for x in entries]
        return filled

    def typed(self, text: str) -> float:
        """Return the number that a text writes; the unit of the answer may follow it. Raises ValueError for any other text."""
        return numeral(re.sub(rf"(?<![A-Za-z]){re.escape(self.unit)}$", "", text.strip()))

    def remedy(self, shape: tuple[int, ...]) -> str:
        """Return a sentence on how to repair an answer of this wrong shape, with a leading space; "" if there is none."""
        expected = np.shape(self.value)
        if len(shape) == 2 and shape[::-1] == expected:
            return " Rows and columns are swapped: try .T."
        if expected and np.prod(shape) == np.prod(expected):
            return f" The count of numbers is right, the arrangement is not: try np.reshape(..., {expected})."
        return ""

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        same = self.same_entries(one, other, tolerance)
        return [bool(same[piece].all()) for piece in self.part_indices()]

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        """Return, for each entry, whether two arrays have the same number there."""
        size = np.maximum(self._scales, np.maximum(np.abs(one), np.abs(other)))
        return np.asarray(np.abs(one - other) <= tolerance * size)

    def kinds(self) -> NDArray[np.int_]:
        """Return the kind of each entry: numbers of one kind can be compared in size, and PURE ones have the scale 1."""
        return np.full(np.shape(self.value), KINDS.get(self.unit, OTHER))

    @cached_property
    def _scales(self) -> Array:
        value = np.asarray(self.value, dtype=float)
        if self.scale is not None:
            return np.broadcast_to(np.asarray(self.scale, dtype=float), value.shape)
        scales, kinds = np.ones(value.shape), self.kinds()
        for kind in set(kinds.ravel().tolist()) - {PURE}:
            scales[kinds == kind] = scale_of(value[kinds == kind])
        return scales

    def likeness(self, given: Array, part: int | None) -> Likeness:
        """Return a part of an answer, or with None the whole, beside the right one."""
        piece = ... if part is None else self.core_indices()[part]
        mine, right = (np.asarray(x, dtype=float)[piece][..., None] for x in (given, self.value))
        places = np.moveaxis(np.indices(np.shape(self.value)), 0, -1)[piece]
        kinds = np.atleast_1d(self.kinds()[piece])
        return Likeness(mine, right, kinds, self.unit, lambda index: self.place(places[tuple(index)]))

    def place(self, index: Sequence[Any]) -> str:
        """Name the place of an entry of the whole array."""
        return self.parts[int(index[0])] if np.size(self.value) == len(self.parts) > 1 else place_of(index)

    def placeholder(self, given: Array) -> Named | None:
        return self.likeness(given, None).placeholder()

    def seen(self, given: Array, part: int) -> Named | None:
        seen = self.likeness(given, part).at_sight()
        if seen is None and len(self.parts) > 1:  # that a short part is rounded is seen in the others
            whole = self.likeness(given, None).at_sight()
            return whole if whole and whole[0] == "rounded" else None
        return seen

    def resemblance(self, given: Array, part: int) -> Named | None:
        return self.likeness(given, part).resemblance() or self._place(given, part)

    def order(self, given: Array) -> Named | None:
        likeness = self.likeness(given, None)
        if self.has_alike_rows or len(self.parts) == len(np.atleast_2d(self.value)) > 1:
            return likeness.order()
        is_list = np.ndim(self.value) == 1 and len(self.parts) == np.size(self.value) > 1
        if not is_list or (self.same_entries(given, self.value) & (np.abs(self.value) > TOLERANCE)).any():
            return None
        factor = likeness.factor()
        return likeness.order() or (factor if factor and factor[0] in {"doubled", "halved"} else None)

    def _place(self, given: Array, part: int) -> Named | None:
        """Return which row belongs here instead, or where few entries are wrong."""
        rows = self.parts if np.ndim(self.value) > 1 and len(self.parts) == len(self.value) else ()
        for other, name in enumerate(rows):
            order = [other if k == part else k for k in range(len(self.parts))]
            if other != part and self.agrees(given, self.value[order])[part]:
                return "another row", f"This is what belongs to {name}."
        same = self.same_entries(given, self.value)[self.core_indices()[part]]
        if np.size(same) > 1:
            return entries_hint(same)
        if self.agrees(given, self.value).count(False) == 1 < len(self.parts):
            return "one entry", "All others are right. Look again at this one."
        return None

    def check(self, given: Array, part: int) -> str:
        return self.test(np.asarray(given)[self.part_indices()[part]]) if self.test else ""


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

    def seen(self, given: Array, part: int) -> Named | None:
        """Return whether it is a placeholder or in degrees, by its meaning: an entry that differs from ours is not wrong for that."""
        seen, angles = self.likeness(given, part).at_sight(), self.kinds() == ANGLE
        if seen and seen[0] != "degrees":
            return seen
        is_in_degrees = angles.any() and self.agrees(np.where(angles, np.radians(given), given), self.value)[part]
        return ("degrees", IN_DEGREES) if is_in_degrees else None

    def resemblance(self, given: Array, part: int) -> Named | None:
        """Return what is true of all entries at once."""
        seen = self.likeness(given, part).resemblance()
        # Single entries of another right answer may differ from ours.
        return seen if seen and seen[0] in {"all signs", "factor", "doubled", "halved"} else None


def scale_of(values: Array) -> float:
    """Return the scale of numbers of one kind: the power of ten above the largest of them, and at most 1.

    A thousandth of it is one unit in the third digit of the largest number. Three decimals are always enough, so it is at most 1;
    and it is 1 if all numbers are zero.

    >>> scale_of(np.array([0.32, 0.0])), scale_of(np.array(0.032)), scale_of(np.array([7.0, 90.0])), scale_of(np.array(1e-17))
    (1.0, 0.1, 1.0, 1.0)
    """
    largest = float(np.abs(values).max(initial=0.0))
    return 10.0 ** (floor(log10(largest)) + 1) if ROUND_OFF < largest < 1 else 1.0


def _kind(given: Any) -> str:
    name = type(given).__name__
    return f"{'an' if name == 'ndarray' or name[:1] in 'aeiouAEIOU' else 'a'} {name}"
