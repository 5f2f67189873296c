"""The entries of an array: where one is, how large they are, which of them are right or rounded, and slips that are made in them."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from math import floor, log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer
from misstep.mistakes import Mistake
from misstep.validation import Array

ROUND_OFF = 1e-12
"""Smaller absolute values are zeros with an error of the computer's arithmetic."""

Slip = tuple[str, Any, str, str]
"""A mistake that people make by hand: its name, the wrong answer, and what is true of such an answer and of a part of it."""


class Entries(Answer):
    """An answer that is an array. By default all entries are one part."""

    @abstractmethod
    def same_entries(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        """Return, for each entry, whether two answers are the same there."""

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        same = self.same_entries(one, other, tolerance)
        return [bool(same[piece].all()) for piece in self.part_indices()]

    def part_indices(self) -> list[Any]:
        """Return, for each part, the index of its entries in the array."""
        return [...]

    def core_indices(self) -> list[Any]:
        """Return, for each part, the index of the entries that make it up, without those that are always the same."""
        return self.part_indices()


def scale_of(values: Array) -> float:
    """Return the scale of numbers of one kind: the power of ten above the largest of them, and at most 1.

    A thousandth of it is one unit in the third digit of the largest number. Three decimals are always enough, so it is at most 1;
    and it is 1 if all numbers are zero.

    >>> scale_of(np.array([0.32, 0.0])), scale_of(np.array(0.032)), scale_of(np.array([7.0, 90.0])), scale_of(np.array(1e-17))
    (1.0, 0.1, 1.0, 1.0)
    """
    largest = float(np.abs(values).max(initial=0.0))
    return 10.0 ** (floor(log10(largest)) + 1) if ROUND_OFF < largest < 1 else 1.0


def looks_rounded(given: Array, right: Array) -> bool:
    """Return whether numbers of one kind are the right ones, rounded to two or more significant digits.

    Each number must equal the right one, or the right one rounded to two or more digits; and at least one of them must be
    rounded. A number with fewer digits, such as 0, counts as rounded only beside such a number, if it is rounded to the same
    decimal.

    >>> looks_rounded(np.array([0.71, 0.0]), np.array([0.7071, 0.0032]))
    True
    >>> looks_rounded(np.array([0.7071, 0.0]), np.array([0.7071, 0.0203]))  # a length is missing
    False
    >>> looks_rounded(np.array(0.7), np.array(0.7071)), looks_rounded(np.array(0.72), np.array(0.7071))
    (False, False)
    """
    mine, exact = np.ravel(given), np.ravel(right)
    changed = ~equal_entries(mine, exact)
    units = [_rounding_unit(g, r) for g, r in zip(mine[changed], exact[changed], strict=True)]
    coarsest = max(filter(None, units), default=None)
    if coarsest is None:
        return False
    return all(
        unit or _is_rounded_to(g, r, coarsest) for unit, g, r in zip(units, mine[changed], exact[changed], strict=True)
    )


def entries_hint(same: NDArray[np.bool_], names: Sequence[str] | None = None) -> str:
    """Return how many entries are right, and where others are wrong; "" if all or none is right.

    names  the names of the entries of a vector

    >>> entries_hint(np.array([True, False, True])), entries_hint(np.array([True, False, False]), names="xyz")
    ('2 of the 3 entries are right. Look at entry 2.', '1 of the 3 entries is right. Look at y and z.')
    """
    right = int(np.count_nonzero(same))
    if right in (0, same.size):
        return ""
    wrong = [names[index[0]] if names else place_of(index) for index in np.argwhere(~same).tolist()]
    where = " and ".join(wrong) if len(wrong) < 3 else f"{wrong[0]} first"
    return f"{right} of the {same.size} entries {'is' if right == 1 else 'are'} right. Look at {where}."


def is_nearly_all(same: NDArray[np.bool_]) -> bool:
    """Return whether so few entries are wrong that their places help: one, or at most a third.

    >>> is_nearly_all(np.array([True, False])), is_nearly_all(np.array([True, True, True, False, False]))
    (True, False)
    """
    return bool(np.count_nonzero(~same) <= max(1, same.size // 3))


def place_of(index: Sequence[Any]) -> str:
    """Name the place of an entry, counted from 1.

    >>> place_of([1]), place_of([0, 1]), place_of([0, 1, 2])
    ('entry 2', 'row 1, column 2', 'entry (1, 2, 3)')
    """
    counted = [int(i) + 1 for i in index]
    if len(counted) == 2:
        return f"row {counted[0]}, column {counted[1]}"
    return f"entry {counted[0]}" if len(counted) == 1 else f"entry {tuple(counted)}"


def wrong_slips(
    answer: Answer, slips: Iterable[Slip], entries: Callable[[Any], Any] = np.asarray, pieces: Sequence[Any] = (...,)
) -> Iterator[Mistake]:
    """Yield the slips that lead to a wrong answer, each answer once, and each wrong part with one text only.

    entries  gives the entries of an answer that was read, as an array
    pieces   for each part, the index of its entries
    """

    def digests(array: Any) -> list[bytes]:
        array = array if array.dtype.kind == "U" else np.round(array / size, 9) + 0.0
        return [array[piece].tobytes() for piece in pieces]

    right = entries(answer.read(answer.value))
    size = 1.0 if right.dtype.kind == "U" else np.abs(right).max(initial=0.0) or 1.0
    known = set(enumerate(digests(right)))
    known_wholes = set()
    for name, given, text, part_text in slips:
        value = answer.read(given)
        whole = digests(entries(value))
        if tuple(whole) in known_wholes or all(answer.agrees(value, answer.value)):
            continue
        known_wholes.add(tuple(whole))
        is_new = bool(set(enumerate(whole)) - known)
        known |= set(enumerate(whole)) if part_text else set()
        yield Mistake(name, value, text, part_text if is_new else "")


def neighbours_swapped(X: Array) -> Iterator[Slip]:
    """Yield a matrix with two neighbouring rows or columns swapped."""
    for axis, name in enumerate(("row", "column")):
        for i in range(X.shape[axis] - 1):
            order = np.arange(X.shape[axis])
            order[[i, i + 1]] = i + 1, i
            yield (
                f"{name}s swapped",
                np.take(X, order, axis=axis),
                f"{name.capitalize()}s {i + 1} and {i + 2} are swapped.",
                "",
            )


def equal_entries(one: Array, other: Array) -> NDArray[np.bool_]:
    """Return, for each entry, whether two arrays differ there by no more than an error of the computer's arithmetic."""
    return np.asarray(np.abs(one - other) <= 1e-9 * np.abs(other) + ROUND_OFF)


def _rounding_unit(given: float, right: float) -> float | None:
    """Return the decimal to which a number was rounded, 0.01 for 0.71 and 0.7071; None if fewer than two digits are left."""
    if abs(right) <= ROUND_OFF:
        return None
    first = floor(log10(abs(right)))
    units = (10.0 ** (first + 1 - digits) for digits in range(2, 9))
    return next((unit for unit in units if _is_rounded_to(given, right, unit)), None)


def _is_rounded_to(given: float, right: float, unit: float) -> bool:
    counted = given / unit
    return bool(abs(given - right) <= 0.5 * unit * (1 + 1e-6) and abs(counted - round(counted)) < 1e-6)
