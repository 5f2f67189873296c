"""Numbers and arrays of numbers as answers."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import MAX_NUMBER, Unreadable
from misstep.answers.entries import (
    ROUND_OFF,
    Entries,
    Slip,
    entries_hint,
    equal_entries,
    is_nearly_all,
    looks_rounded,
    neighbours_swapped,
    place_of,
    scale_of,
    wrong_slips,
)
from misstep.answers.likeness import LENGTH_UNITS, Likeness, Named, has_three_digits
from misstep.display.sentences import OTHER_UNIT
from misstep.formulas.evaluation import numeral
from misstep.mistakes import Mistake
from misstep.validation import Array

HIDDEN = 1e-6
"""Smaller sizes are 0 for an explanation, whatever the tolerance of the answer is."""

LENGTH = 1
"""The kind of lengths in an answer whose other numbers have none."""

PURE = 0
"""The kind of numbers of size 1: directions, entries of a rotation, angles beside lengths."""

SMALLER_UNITS = {
    "m": (1000, "millimetres", "metres"),
    "metres": (1000, "millimetres", "metres"),
    "mm": (1e-3, "metres", "millimetres"),
    "rad": (180 / np.pi, "degrees", "radians"),
    "radians": (180 / np.pi, "degrees", "radians"),
    "degrees": (np.pi / 180, "radians", "degrees"),
    "°": (np.pi / 180, "radians", "degrees"),
}
"""For each unit: by how much a number grows in the unit that is mistaken for it, and the names of both."""


@dataclass(frozen=True, eq=False)
class Numbers(Entries):
    """A number, or an array of numbers of a given shape.

    value  the right numbers
    unit   the unit of all numbers, for feedback
    scale  a size that matters, as one number or one for each entry; by default `scale_of` the numbers of the same kind
    test   a check of each part that a student can do, in a sentence with the own numbers; "" if the part passes it

    A number may be off by a thousandth of itself, or of its scale: three digits of the largest number of its kind are enough,
    0 is right for 1e-17, and wrong for 3e-7. The array is one part, unless a subclass overrides `parts` and `part_indices`.

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

    @property
    def expected(self) -> str:
        shape = np.shape(self.value)
        what = f"{self.noun} of shape {shape}" if shape else "one number"
        return what + (f" in {self.unit}" if self.unit else "")

    @cached_property
    def _right(self) -> Array:
        return np.asarray(self.value, dtype=float)

    @property
    def parts(self) -> Sequence[str]:
        return ["the answer"]

    def read(self, given: Any) -> Array:
        if isinstance(given, validation.FUNCTIONS):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}. Give its value, as in f(x).")
        expected_shape = np.shape(self.value)
        try:
            shape = np.shape(given)
        except Exception as error:  # reading the shape of a student's object may raise any error
            raise Unreadable(f"Expected {self.expected}; got {_kind(given)} whose rows differ in length.") from error
        if not expected_shape and 0 < len(shape) <= 2 and np.prod(shape) == 1:
            return self.read(np.asarray(given).ravel()[0])  # [x] can only mean x
        if len(expected_shape) == 1 and shape in (column := (*expected_shape, 1), column[::-1]):
            given = np.ravel(given)  # a column or a row of a matrix lists the same numbers
        elif shape != expected_shape:
            description = f"{_kind(given)} of shape {shape}" if shape else validation.brief(given)
            quotes = " Give a list without quotes around it." if isinstance(given, str) and expected_shape else ""
            raise Unreadable(f"Expected {self.expected}; got {description}.{quotes or self.remedy(shape)}")
        try:
            values = validation.array(self._with_typed(given), "your answer")
        except ValueError as error:
            raise Unreadable(f"Expected {self.expected}. {_sentence(str(error))}") from error
        except Exception as error:
            raise Unreadable(
                f"Expected {self.expected}; got {_kind(given)} that does not turn into numbers."
            ) from error
        largest = np.abs(values).max(initial=0)
        if largest > MAX_NUMBER:
            raise Unreadable(f"Expected {self.expected}; got {largest:.3g}. Was there a division by almost zero?")
        return values

    def _with_typed(self, given: Any) -> Any:
        """Return numbers in which those that are typed as text are read. Raises ValueError for text that is no number."""
        values = given if isinstance(given, np.ndarray) else np.asarray(given)
        if values.dtype.kind not in "OU" or not any(isinstance(x, str) for x in values.ravel().tolist()):
            return given
        entries = [self.typed(x) if isinstance(x, str) else x for x in values.ravel().tolist()]
        filled = np.empty(values.shape, dtype=object)
        filled.ravel()[:] = entries
        return filled

    def typed(self, text: str) -> float:
        """Return the number that a text writes; the unit of the answer may follow it. Raises ValueError for any other text."""
        plain = text.strip()
        unit = self.unit if self.unit and plain.endswith(self.unit) else ""
        return numeral(plain[: len(plain) - len(unit)])

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        """Return, for each entry, whether two arrays have the same number there."""
        size = np.maximum(self._scales, np.maximum(np.abs(one), np.abs(other)))
        return np.asarray(np.abs(one - other) <= tolerance * size)

    def kinds(self) -> NDArray[np.int_]:
        """Return a label for each entry: numbers with the same label can be compared in size, and PURE ones have the scale 1."""
        return np.ones(np.shape(self.value), dtype=int)

    @cached_property
    def _scales(self) -> Array:
        value = self._right
        scales = np.ones(value.shape)
        if self.scale is not None:
            return np.broadcast_to(np.asarray(self.scale, dtype=float), value.shape)
        kinds = self.kinds()
        for kind in set(kinds.ravel().tolist()) - {PURE}:
            scales[kinds == kind] = scale_of(value[kinds == kind])
        return scales

    def appearance(self, given: Array, part: int | None) -> Named | None:
        if part is None:
            return self.likeness(given, None).placeholder()
        seen = self.likeness(given, part).at_sight()
        if seen is None and len(self.parts) > 1:  # that a short part is rounded is seen in the others
            whole = self.likeness(given, None).at_sight()
            return whole if whole and whole[0] == "rounded" else None
        return seen

    def arrangement(self, given: Array) -> Named | None:
        if self.rows_are_alike or len(self.parts) == len(np.atleast_2d(self.value)) > 1:
            return self.likeness(given, None).order()
        is_list = np.ndim(self.value) == 1 and len(self.parts) == np.size(self.value) > 1
        is_found = self.same_entries(given, self.value) & (np.abs(self.value) > HIDDEN)
        if not is_list or is_found.any():
            return None
        likeness = self.likeness(given, None)
        factor = likeness.factor()
        return likeness.order() or (factor if factor and factor[0] in {"doubled", "halved"} else None)

    def shows(self, given: Array, value: Array) -> list[bool]:
        # A number that is hidden in the tolerance is no 0: one of the two was not found by the method of the other.
        hidden = np.asarray((np.abs(given) < HIDDEN) == (np.abs(value) < HIDDEN))
        pieces = self.part_indices()
        agrees = self.agrees(given, value)
        if not all(agrees):
            same, is_typed = self.same_entries(given, value), has_three_digits(given, value)
            typed = same | has_three_digits(given, value, or_zeros=True)
            agrees = [
                fine or bool(np.all(typed[piece]) and np.any(is_typed[piece] & ~same[piece]))
                for fine, piece in zip(agrees, pieces, strict=True)
            ]
        return [fine and bool(np.all(hidden[piece])) for fine, piece in zip(agrees, pieces, strict=True)]

    def explanation(self, given: Array, part: int) -> Named | None:
        return self.likeness(given, part).resemblance()

    def check(self, given: Array, part: int) -> str:
        return self.test(np.asarray(given)[self.part_indices()[part]]) if self.test else ""

    def description(self, given: Array, part: int) -> Named | None:
        same = self.same_entries(given, self.value)[self.core_indices()[part]]
        if self.rows_are_alike:
            for other, name in enumerate(self.parts):
                order = [other if k == part else k for k in range(len(self.parts))]
                if other != part and self.agrees(given, self.value[order])[part]:
                    return "another row", f"This is what belongs to {name}."
        if np.size(same) > 1:
            return ("one entry", self.hint(given, part)) if np.count_nonzero(~same) == 1 else None
        if self.agrees(given, self.value).count(False) == 1 < len(self.parts):
            return "one entry", "All others are right. Look again at this one."
        return None

    def likeness(self, given: Array, part: int | None) -> Likeness:
        """Return a part of an answer, or with None the whole, beside the right one."""
        piece = ... if part is None else self.core_indices()[part]
        mine, right = (np.asarray(x, dtype=float)[piece][..., None] for x in (given, self.value))
        places = np.moveaxis(np.indices(np.shape(self.value)), 0, -1)[piece]
        lengths, angles = (np.atleast_1d(mask[piece]) for mask in (self.length_entries(), self.angle_entries()))
        unit = self.unit if self.unit in LENGTH_UNITS else "m"
        return Likeness(mine, right, lengths, angles, unit, lambda index: self.place(places[tuple(index)]))

    def length_entries(self) -> NDArray[np.bool_]:
        """Return which entries are lengths in `unit`."""
        return np.full(np.shape(self.value), self.unit in {"m", "metres", "mm"})

    def angle_entries(self) -> NDArray[np.bool_]:
        """Return which entries are angles in radians."""
        return np.full(np.shape(self.value), self.unit in {"rad", "radians"})

    def is_rounded(self, given: Array, part: int) -> bool:
        """Return whether a wrong part is the right one, rounded to two or more significant digits."""
        piece = self.part_indices()[part]
        mine, right = (np.ravel(array[piece]) for array in (given, self._right))
        kinds = np.resize(self.kinds()[piece], mine.shape)
        groups = [(mine[kinds == kind], right[kinds == kind]) for kind in set(kinds.ravel().tolist())]
        changed = [group for group in groups if not equal_entries(*group).all()]
        return bool(changed) and all(looks_rounded(*group) for group in changed)

    def hint(self, given: Array, part: int) -> str:
        piece = self.part_indices()[part]
        same = self.same_entries(given, self.value)[piece]
        return entries_hint(same) if is_nearly_all(same) else ""

    def remedy(self, shape: tuple[int, ...]) -> str:
        """Return a sentence on how to repair an answer of this wrong shape, with a leading space; "" if there is none."""
        expected = np.shape(self.value)
        if not expected:
            return ""
        if len(shape) == 2 and shape[::-1] == expected:
            return " Rows and columns are swapped: try .T."
        if np.prod(shape) == np.prod(expected):
            return f" The count of numbers is right, the arrangement is not: try np.reshape(..., {expected})."
        return ""

    def slips(self) -> Iterator[Mistake]:
        """Yield the right answer with the changes that people make by hand; what is said of each is true of the answer itself."""
        changes = [*self.whole_slips(), *self._factor_slips(), *self.entry_slips()]
        return wrong_slips(self, changes, pieces=self.part_indices())

    def whole_slips(self) -> Iterator[Slip]:
        """Yield the slips in the whole array; for every value of the same shape the same ones in the same order."""
        X = self._right
        if X.ndim == 2:
            if X.shape[0] == X.shape[1]:
                yield ("transposed", X.T, "Your answer is the transpose of the right one.", "")
            yield from neighbours_swapped(X)
        is_one = X.ndim == 0
        yield (
            "all signs",
            -X,
            f"The {'size is right, but the sign' if is_one else 'sizes are right, but every sign'} is wrong.",
            "The sizes are right, but every sign is wrong.",
        )
        if self.unit in SMALLER_UNITS:
            factor, wrong, right = SMALLER_UNITS[self.unit]
            text = OTHER_UNIT.format(wrong, right)
            yield (wrong, X * factor, text, text)

    def _factor_slips(self) -> Iterator[Slip]:
        X = self._right
        # A rotation has no double, and a small whole number is too often the double of another one.
        if (self.kinds() != PURE).all() and (self.unit or (X % 1).any()):
            yield ("doubled", 2 * X, "Your answer is twice the right one.", "This is twice the right one.")
            yield ("halved", X / 2, "Your answer is half the right one.", "This is half the right one.")
            for factor in (10, 100, 1000) if X.ndim == 0 else ():
                for number, text in ((X * factor, f"{factor} times"), (X / factor, f"1/{factor} of")):
                    yield ("power of ten", number, f"Your answer is {text} the right one.", "")

    def entry_slips(self) -> Iterator[Slip]:
        """Yield the slips in one entry, or in two of the same row or column of a part."""
        X = self._right
        if X.ndim == 0:
            return
        places, owners = np.arange(X.size).reshape(X.shape), np.zeros(X.shape, dtype=int)
        for owner, piece in enumerate(self.part_indices()):
            owners[piece] = owner
        for entry in places[np.abs(X) > ROUND_OFF]:
            signs = np.where(places == entry, -1, 1)
            # A check shows which one; where there is none, its place is told.
            is_shown = self.check(X * signs, int(owners.flat[entry]))
            place = "" if is_shown else f": {self.place(np.unravel_index(entry, X.shape))}"
            text = f"Only one sign is wrong{place}."
            yield ("sign of one entry", X * signs, text, text)
        pieces, parts = self.slip_indices(), self.part_indices()
        for piece in pieces:
            for one, other in combinations(np.ravel(places[piece]), 2):
                indices = [np.unravel_index(entry, X.shape) for entry in (one, other)]
                if X.flat[one] == X.flat[other] or np.count_nonzero(np.not_equal(*indices)) > 1:
                    continue
                order = places.copy()
                order.flat[[one, other]] = other, one
                swapped = " and ".join(map(self.place, indices))
                # Where each entry is a part, one part cannot show that two of them are swapped.
                part = f"Two entries are swapped in this part: {swapped}." if len(pieces) == len(parts) else ""
                yield ("two entries swapped", X.ravel()[order], f"Two entries are swapped: {swapped}.", part)

    def slip_indices(self) -> list[Any]:
        """Return the indices of entries among which two in the same row or column may be swapped."""
        pieces = self.part_indices()
        return [...] if all(np.ndim(np.asarray(self.value)[piece]) == 0 for piece in pieces) else pieces

    def place(self, index: Sequence[Any]) -> str:
        """Name the place of an entry of the whole array."""
        return place_of(index)


def _kind(given: Any) -> str:
    name = type(given).__name__
    return f"{'an' if name == 'ndarray' or name[:1] in 'aeiouAEIOU' else 'a'} {name}"


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:]
