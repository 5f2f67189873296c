"""What an answer looks like beside the right one, without asking how it came about: left as it was, another unit, rounded, in
another order, with other signs.

All arrays here have one more axis than the answer, the last one: for a formula or a function its values at several inputs, for
numbers a single value. So the same comparison serves all three.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from misstep.answers.base import TOLERANCE, Named
from misstep.validation import Array

PURE, LENGTH, ANGLE, OTHER = range(4)
"""The kinds of numbers: those of size 1, as in a direction or a rotation; lengths; angles in radians; and all others."""

KINDS = {"m": LENGTH, "mm": LENGTH, "m/s": LENGTH, "rad": ANGLE}
"""The kind of numbers with a unit."""

ROUND_OFF = 1e-12
"""Smaller absolute values are zeros with an error of the computer's arithmetic."""

OTHER_UNIT = "This is right in {}. Give it in {}."
"""What is said of the right numbers in another unit, with both units."""

IN_DEGREES = OTHER_UNIT.format("degrees", "radians")

ZERO = "This is 0, and the right number is not."

UNTOUCHED = "{}. Put in the numbers that you find."
"""What is said of a placeholder."""


@dataclass(frozen=True, eq=False)
class Likeness:
    r"""A part of an answer and of the right one, shape (..., inputs), and what is known about its entries.

    kinds      the kind of each entry
    unit       the unit of the lengths, by default metres
    place      names an entry by its index
    columns    the names of the columns, if they have any
    tolerance  how far a number may be off: nothing is said of a number that is hidden in it
    """

    mine: Array
    right: Array
    kinds: NDArray[np.int_] | int = OTHER
    unit: str = "m"
    place: Callable[[Sequence[int]], str] = lambda index: f"entry {', '.join(str(i + 1) for i in index)}"
    columns: Sequence[str] = ()
    tolerance: float = TOLERANCE

    def at_sight(self) -> Named | None:
        """Return what is seen before any mistake is looked for: a placeholder, another unit, too few digits."""
        if self._equal(self.mine, self.right).all():
            return None
        return self.placeholder() or self._unit() or self._rounded()

    def placeholder(self) -> Named | None:
        """Return whether the numbers are those with which an array is made: zeros, ones, the identity."""
        mine, right, n = self.mine, self.right, self.mine.shape[0] if self.mine.ndim > 1 else 1
        is_one = mine.size == mine.shape[-1]
        if not mine.any() and self._is_seen(right).any() and not (is_one and not self._has_unit):  # a count may be 0
            return "placeholder", ZERO if is_one else UNTOUCHED.format("Every number is 0")
        if not is_one and (mine == 1).all() and not (right == 1).all():
            return "placeholder", UNTOUCHED.format("Every number is 1")
        is_square = mine.ndim == 3 and mine.shape[1] == n
        if is_square and (mine == np.eye(n)[..., None]).all() and not self._equal(mine, right).all():
            return "placeholder", UNTOUCHED.format("This is the identity matrix")
        return None

    def resemblance(self) -> Named | None:
        """Return how the numbers differ from the right ones as a whole: by signs, by a factor, or by their order."""
        if not self.mine.any() and self._is_seen(self.right).any():
            return "left at 0", ZERO
        is_square = self.mine.ndim == 3 and len(self.mine) == self.mine.shape[1]
        if is_square and self._equal(self.mine, self.right.swapaxes(0, 1)).all():
            return "transposed", "This is the transpose of the right one."
        return self._signs() or self.factor() or self.order() or self._mostly_zeros()

    def _mostly_zeros(self) -> Named | None:
        filled, seen = (np.count_nonzero(x) for x in (self.mine.any(axis=-1), self._is_seen(self.right).any(axis=-1)))
        if filled == 1 < seen and not self._equal(self.mine, self.right)[self.mine.any(axis=-1)].any():
            return "zeros", "Only one of your numbers is not 0; more of the right ones are not 0."
        return None

    @property
    def _has_unit(self) -> bool:
        return bool(np.isin(self.kinds, (LENGTH, ANGLE)).any())

    def _unit(self) -> Named | None:
        wanted, others = UNITS.get(self.unit, UNITS["m"])
        for kind in (LENGTH, ANGLE):
            which = self.kinds == kind
            mine, right = self.mine[which], self.right[which]
            if not (self._is_seen(right).any() and self._equal(self.mine[~which], self.right[~which]).all()):
                continue
            if kind == ANGLE and self._in_degrees(mine, right):
                return "degrees", IN_DEGREES
            for name, factor in others.items() if kind == LENGTH else ():
                if self._relative(mine, factor * right).all():
                    return name, OTHER_UNIT.format(name, wanted)
        return None

    def _rounded(self) -> Named | None:
        mine, right = (x.reshape(-1, x.shape[-1]) for x in (self.mine, self.right))
        wrong = np.ravel(~self._equal(mine, right))
        unit = 10.0 ** (np.floor(np.log10(np.maximum(np.abs(right), 1e-12))) - 2)  # of the third digit
        is_rounded = bool((np.abs(mine - unit * np.round(right / unit)) < 1e-6 * unit)[wrong].all())
        # Numbers left at 0 are not rounded, one digit may be that of another number, and one 1 in each row and column another rotation.
        is_other = self.mine.ndim > 2 and all((np.abs(self.mine).sum(axis=k) == 1).all() for k in (0, 1))
        count, least = np.count_nonzero(wrong), np.abs(right[wrong]).min()
        for decimals in (3, 2, 1, 0) if 2 * np.count_nonzero(mine[wrong]) >= count else ():
            has_two_digits = decimals != 1 and least >= 10.0 ** (1 - decimals)
            is_told = has_two_digits or count > (1 if decimals else np.inf if is_other else 2)
            is_rounded |= bool(is_told and (np.abs(mine - np.round(right, decimals)) < 1e-9).all())
        text = "These are the right numbers, but rounded too much. Keep at least four significant digits."
        return ("rounded", text) if is_rounded else None

    def _signs(self) -> Named | None:
        mine, right = self.mine, self.right
        wrong, is_one = ~self._equal(mine, right), mine.size == mine.shape[-1]
        if not wrong.any() or not (self._equal(mine, -right) | ~wrong).all():
            return None
        count, seen = np.count_nonzero(wrong), np.count_nonzero(self._is_seen(right).any(axis=-1))
        if is_one or count == seen:
            text = f"{SIGNS}\nLook at the signs: every one is wrong."
            return "all signs", "The size is right.\nLook at the sign." if is_one else text
        if count > 3:
            return "signs", f"{SIGNS}\nLook at the signs: {count} are wrong."
        places = " and ".join(self.place(index) for index in np.argwhere(wrong).tolist())
        return "signs", f"{SIGNS}\nLook at the sign{'' if count == 1 else 's'} of {places}."

    def factor(self) -> Named | None:
        """Return whether these are the right numbers, multiplied by a factor."""
        seen, is_one = self._is_seen(self.right), self.mine.size == self.mine.shape[-1]
        if np.count_nonzero(seen.any(axis=-1)) < (1 if is_one and self._has_unit else 2):
            return None
        factor = float(np.median(self.mine[seen] / self.right[seen]))
        if not 1e-3 <= abs(factor) <= 1e3 or not self._relative(self.mine, factor * self.right).all():
            return None
        for size, name, text in ((2, "doubled", "twice"), (0.5, "halved", "half")):
            if abs(factor - size) < 0.005 * size:
                return name, f"This is {text} the right one." if is_one else f"{SCALED}\nEach is {text} the right one."
        return None if is_one else ("factor", SCALED)

    def order(self) -> Named | None:
        """Return whether these are the right numbers in another order: of the columns, of the rows, or one by one."""
        mine, right = self.mine, self.right
        if mine.ndim == 1 or self._equal(mine, right).all():
            return None
        has_few_columns = mine.ndim == 3 and mine.shape[1] <= 4
        if has_few_columns and (order := self._permutation(mine.swapaxes(0, 1), right.swapaxes(0, 1))):
            return _order_of("column", order, self.columns)
        if mine.ndim > 2 and (order := self._permutation(mine, right)):
            return _order_of("row", order)
        single, right_ones = (x.reshape(-1, x.shape[-1]) for x in (mine, right))
        is_short = mine.ndim == 2 and len(single) <= 4
        is_telling = len(single) <= 6 and np.unique(np.round(right, 6)).size > 3
        if (is_short or is_telling) and self._permutation(single, right_ones):
            named = ", ".join(self.columns) if len(self.columns) == len(single) else ""
            where = f"in the order {named}" if named else "in the right order"
            return "order of the numbers", f"These are the right numbers, but not {where}."
        return self._moved_rows() if mine.ndim > 2 < len(mine) else None

    def _permutation(self, mine: Array, right: Array) -> list[int] | None:
        """Return for each row, column or number where it belongs, if they are the right ones, each once."""
        order: list[int] = []
        for k, one in enumerate(mine):
            places = [j for j, other in enumerate(right) if j not in order and self._equal(one, other).all()]
            if not places:
                return None
            order.append(k if k in places else places[0])
        return order

    def _moved_rows(self) -> Named | None:
        """Return whether all rows are moved by one, so that one of them falls out, and another one fills the gap."""
        mine, right = self.mine, self.right
        is_down, is_up = (self._equal(*pair).all() for pair in ((mine[1:], right[:-1]), (mine[:-1], right[1:])))
        stay = np.count_nonzero(self._equal(mine, right).reshape(len(mine), -1).all(axis=1))
        if not (is_down or is_up) or stay > 1:
            return None
        where, lost = ("down", "last") if is_down else ("up", "first")
        return "rows moved", f"Your rows are moved {where} by one: the {lost} one of the right rows is missing."

    def _is_seen(self, values: Array) -> NDArray[np.bool_]:
        return np.asarray(np.abs(values) > 2 * self.tolerance)

    def _equal(self, one: Array, other: Array) -> NDArray[np.bool_]:
        """Return, for each entry, whether it is equal at all inputs."""
        size = np.maximum(1.0, np.maximum(np.abs(one), np.abs(other)))
        return np.asarray((np.abs(one - other) <= self.tolerance * size).all(axis=-1))

    def _relative(self, one: Array, other: Array) -> NDArray[np.bool_]:
        return np.asarray(np.abs(one - other) <= self.tolerance * np.abs(other) + 1e-9)

    def _in_degrees(self, mine: Array, right: Array) -> bool:
        """Return whether angles are the right ones in degrees, less full turns; whole degrees are enough."""
        difference = np.remainder(mine - np.degrees(right) + 180, 360) - 180
        is_whole = (mine == np.round(mine)).all()
        return bool((np.abs(difference) <= (0.5 if is_whole else 0.05 + 5e-4 * np.abs(mine))).all() and mine.any())


def entries_hint(same: NDArray[np.bool_], names: Sequence[str] | None = None) -> Named | None:
    r"""Return how many entries are right, and where others are wrong, if they are few: one, or at most a third.

    names  the names of the entries of a vector

    >>> entries_hint(np.array([True, False, True])), entries_hint(np.array([True, False, False]), names="xyz")
    (('one entry', '2 of the 3 entries are right.\nLook at entry 2.'), None)
    """
    wrong, count = np.argwhere(~same).tolist(), int(np.count_nonzero(same))
    if not wrong or not count or len(wrong) > max(1, same.size // 3):
        return None
    places = [names[index[0]] if names else place_of(index) for index in wrong]
    where = " and ".join(places) if len(places) < 3 else f"{places[0]} first"
    text = f"{count} of the {same.size} entries {'is' if count == 1 else 'are'} right.\nLook at {where}."
    return ("one entry" if len(wrong) == 1 else ""), text


def place_of(index: Sequence[int]) -> str:
    """Name the place of an entry, counted from 1."""
    counted = [int(i) + 1 for i in index]
    if len(counted) == 2:
        return f"row {counted[0]}, column {counted[1]}"
    return f"entry {counted[0]}" if len(counted) == 1 else f"entry {tuple(counted)}"


def _order_of(what: str, order: Sequence[int], names: Sequence[str] = ()) -> Named:
    """Return the name and the sentence for right rows or columns in another order.

    names  their names; by default they are numbered
    """
    moved = [k + 1 for k, place in enumerate(order) if k != place]
    if len(order) > 4 and list(order) == list(range(len(order)))[::-1]:
        return f"{what}s reversed", f"The {what}s are right, but in the reverse order."
    some = "two" if len(moved) == 2 else "some"
    name = f"{some} {what}s moved" if len(order) - len(moved) > 1 else f"{what}s in another order"
    if names:
        theirs, ours = (", ".join(names[k] for k in ks) for ks in (order, range(len(order))))
        return name, f"Each row is in the order {theirs}. Give it in the order {ours}."
    if len(moved) == 2:
        return name, f"Two {what}s are swapped.\nThey are {what}s {moved[0]} and {moved[1]}."
    listed = ", ".join(str(k + 1) for k in order)
    return name, f"The {what}s are right, but their order is not.\nYours are {what}s {listed} of the right answer."


REORDERED = {"rows moved", "rows in another order", "rows reversed", "columns in another order", "two columns moved"}
"""The names of orders in which a row that stands right does so by chance: at most one keeps its place, or columns are mixed up."""

UNITS = {
    "m": ("metres", {"millimetres": 1000.0, "centimetres": 100.0}),
    "mm": ("millimetres", {"metres": 1e-3, "centimetres": 0.1}),
    "m/s": ("metres per second", {"millimetres per second": 1000.0}),
}
"""For each unit its name, and those that are mistaken for it, each with its factor."""

SIGNS = "Apart from the signs, this is right."

SCALED = "These are the right numbers, all multiplied by the same factor."
