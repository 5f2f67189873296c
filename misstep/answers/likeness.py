"""What an answer looks like beside the right one, without asking how it came about: left as it was, another unit, rounded, in
another order, with other signs.

All arrays here have one more axis than the answer, the last one: for a formula or a function its values at several inputs, for
numbers a single value. So the same comparison serves all three.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from misstep.validation import Array

RELATIVE = 1e-3
"""The accepted error of a number relative to its size, so that nothing is said of a number that is hidden in the tolerance."""

MAX_PLACES = 3
"""How many wrong entries are named one by one."""

Named = tuple[str, str]
"""The name of what is wrong, and a sentence that is true of the part."""


@dataclass(frozen=True, eq=False)
class Likeness:
    """A part of an answer and of the right one, shape (..., inputs), and what is known about its entries.

    lengths, angles  which entries are lengths, and angles in radians
    unit             the unit of the lengths
    place            names an entry by its index
    reordered        what is said of the right numbers in another order
    is_formula       whether the entries are formulas, which are compared exactly

    >>> right = np.array([[0.5], [-0.25], [0.0]])
    >>> Likeness(0 * right, right).at_sight(), Likeness(1000 * right, right, lengths=np.ones(3, bool)).at_sight()[0]
    (('placeholder', 'Every number is 0. Put in the numbers that you find.'), 'millimetres')
    >>> Likeness(np.abs(right), right).resemblance()
    ('signs', 'The sizes are right, but no minus sign is left.')
    >>> Likeness(right[[1, 2, 0]], right).resemblance()[1]
    'These are the right numbers, but not in the right order.'
    """

    mine: Array
    right: Array
    lengths: NDArray[np.bool_] | None = None
    angles: NDArray[np.bool_] | None = None
    unit: str = "m"
    place: Callable[[Sequence[int]], str] = lambda index: f"entry {', '.join(str(i + 1) for i in index)}"
    reordered: str = "These are the right numbers, but not in the right order."
    tolerance: float = RELATIVE
    is_formula: bool = False

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
            return "placeholder", IDENTITY
        return None

    def resemblance(self) -> Named | None:
        """Return how the numbers differ from the right ones as a whole: by signs, by a factor, or by their order."""
        if not self.mine.any() and self._is_seen(self.right).any():
            return "left at 0", ZERO
        if self._equal(self.mine, self.right).all():
            return None
        return self._signs() or self.factor() or self.order()

    @property
    def _has_unit(self) -> bool:
        return any(mask is not None and mask.any() for mask in (self.lengths, self.angles))

    def _unit(self) -> Named | None:
        for which, is_angle in ((self.lengths, False), (self.angles, True)):
            if which is None or not which.any():
                continue
            mine, right = self.mine[which], self.right[which]
            if not (self._is_seen(right).any() and self._equal(self.mine[~which], self.right[~which]).all()):
                continue
            if is_angle:
                if self._in_degrees(mine, right):
                    return DEGREES
                if self._relative(mine, np.radians(right)).all():
                    return "converted twice", "This was in radians already, and is converted to radians once more."
            for name, factor, text in () if is_angle else LENGTH_UNITS[self.unit]:
                if self._relative(mine, factor * right).all():
                    return name, text
        return None

    def _rounded(self) -> Named | None:
        if self.is_formula or self._equal(self.mine, self.right).all() or not self.mine.any():
            return None
        for decimals in (3, 2, 1, 0):
            if (np.abs(self.mine - np.round(self.right, decimals)) < 1e-9).all():
                return "rounded", ROUNDED
        return None

    def _signs(self) -> Named | None:
        mine, right = self.mine, self.right
        if not self._equal(np.abs(mine), np.abs(right)).all() or mine.size == mine.shape[-1]:
            return None
        wrong = ~self._equal(mine, right)
        if not wrong.any():
            return None
        count, seen = np.count_nonzero(wrong), np.count_nonzero(self._is_seen(right).any(axis=-1))
        if count == seen:
            return "all signs", "The sizes are right, and all signs are wrong."
        if not self.is_formula and (mine >= 0).all():
            return "signs", "The sizes are right, but no minus sign is left."
        if count > MAX_PLACES:
            return "signs", f"The sizes are right, but {count} signs are wrong."
        places = " and ".join(self.place(index) for index in np.argwhere(wrong).tolist())
        return "signs", f"The sizes are right, but not {'the sign' if count == 1 else 'the signs'} of {places}."

    def factor(self) -> Named | None:
        """Return whether these are the right numbers, multiplied by a factor."""
        seen = self._is_seen(self.right)
        if np.count_nonzero(seen.any(axis=-1)) < 2:
            return None
        factor = float(np.median(self.mine[seen] / self.right[seen]))
        if not 0.01 < abs(factor) < 100 or not self._relative(self.mine, factor * self.right).all():
            return None
        for size, (name, text) in FACTORS.items():
            if abs(factor - size) < 0.005 * size:
                return name, f"This is {text} the right one."
        return "factor", "These are the right numbers, all multiplied by the same factor."

    def order(self) -> Named | None:
        """Return whether these are the right numbers in another order."""
        return self._reordered() or self._moved_rows()

    def _reordered(self) -> Named | None:
        mine, right = self.mine, self.right
        if mine.ndim == 1:
            return None
        for name, text, changed in _arrangements(right):
            if changed.shape == mine.shape and self._equal(mine, changed).all():
                return name, text
        one, other = (np.sort(x.reshape(-1, x.shape[-1]), axis=0) for x in (mine, right))
        count = one.shape[0]
        if mine.ndim == 2 and 1 < count <= 4:
            for order in list(permutations(range(count)))[1:]:
                if self._equal(mine, right[list(order)]).all():
                    return "order of the numbers", self.reordered
        if 2 < count <= 6 and not self.is_formula and np.unique(np.round(other[:, 0], 6)).size > 3:
            if self._equal(one, other).all():
                return "order of the numbers", self.reordered
            one, other = (np.sort(np.abs(x), axis=0) for x in (one, other))
            if self._equal(one, other).all():
                return "order and signs", "These are the right sizes, but their order and their signs are not right."
        return None

    def _moved_rows(self) -> Named | None:
        """Return whether all rows are moved by one, so that one of them falls out, and another one fills the gap."""
        mine, right = self.mine, self.right
        if mine.ndim != 3 or len(mine) < 3:
            return None
        is_right: NDArray[np.bool_] = np.all(self._equal(mine, right), axis=1)
        if np.count_nonzero(is_right) > 1:
            return None
        for where, moved, place, gap, lost in (
            ("down", self._equal(mine[1:], right[:-1]), 0, "first", "last"),
            ("up", self._equal(mine[:-1], right[1:]), -1, "last", "first"),
        ):
            if moved.all():
                filled = f"the {gap} one is there twice" if is_right[place] else f"your {gap} row is an extra one"
                text = f"Your rows are moved {where} by one: the {lost} one of the right rows is missing, and {filled}."
                return ROWS_MOVED, text
        return None

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


def copied_row(mine: Sequence[Array], right: Sequence[Array], part: int, names: Sequence[str]) -> Named | None:
    """Return whether a row of an answer is another row of the same answer, where the right rows differ.

    mine, right  the parts of an answer and of the right one, each with one more axis
    """
    for other, name in enumerate(names):
        if other == part or mine[part].ndim < 2 or mine[part].shape != mine[other].shape:
            continue
        if np.allclose(mine[part], mine[other], rtol=0, atol=1e-9) and not np.allclose(right[part], right[other]):
            return "copied row", f"It is the same as your {name.removeprefix('the ')}, number for number."
    return None


def _arrangements(X: Array) -> Iterator[tuple[str, str, Array]]:
    """Yield an array with its rows or columns in another order, with the name and the sentence for it."""
    if X.ndim == 3:
        rows, columns = X.shape[:2]
        if rows == columns:
            yield "transposed", "This is the transpose of the right one.", X.swapaxes(0, 1)
        for axis, what, count in ((1, "column", columns), (0, "row", rows)):
            if 1 < count <= 4:
                for order in list(permutations(range(count)))[1:]:
                    listed = ", ".join(str(k + 1) for k in order)
                    text = (
                        f"The {what}s are right, but their order is not: yours are {what}s {listed} of the right one."
                    )
                    is_swap = sum(k == place for place, k in enumerate(order)) > 1
                    name = f"two {what}s swapped" if is_swap else f"{what}s in another order"
                    yield name, text, np.take(X, order, axis=axis)
            elif count > 4:
                for shift, where in ((1, "down"), (-1, "up")):
                    text = f"The {what}s are right, but moved one {what} {where}."
                    yield f"{what}s shifted", text, np.roll(X, shift, axis=axis)
                yield f"{what}s reversed", f"The {what}s are right, but in the reverse order.", np.flip(X, axis=axis)


ROWS_MOVED = "rows moved"
"""The name of rows of which one fell out."""

REORDERED = {ROWS_MOVED, "rows in another order", "rows shifted", "rows reversed"}
"""The names of orders in which at most one row keeps its place: one that stands right does so by chance."""

DEGREES = ("degrees", "This is right in degrees. Give it in radians.")

ZERO = "This is 0, and the right number is not."

UNTOUCHED = "{}. Put in the numbers that you find."
"""What is said of a placeholder."""

IDENTITY = UNTOUCHED.format("This is the identity matrix")

ROUNDED = "These are the right numbers, but rounded too much. Keep at least four significant digits."

LENGTH_UNITS = {
    "m": (
        ("millimetres", 1000.0, "This is right in millimetres. Give it in metres."),
        ("centimetres", 100.0, "This is right in centimetres. Give it in metres."),
        ("kilometres", 1e-3, "This is a thousand times too small. Give it in metres."),
    ),
    "mm": (
        ("metres", 1e-3, "This is right in metres. Give it in millimetres."),
        ("centimetres", 0.1, "This is right in centimetres. Give it in millimetres."),
        ("micrometres", 1000.0, "This is a thousand times too large. Give it in millimetres."),
    ),
    "moments": (
        ("millimetres", 1000.0, "Only $v$ is wrong: it is in millimetres. Give it in metres."),
        ("centimetres", 100.0, "Only $v$ is wrong: it is in centimetres. Give it in metres."),
        ("kilometres", 1e-3, "Only $v$ is wrong: it is a thousand times too small."),
    ),
}
"""For each unit those that are mistaken for it: the name, the factor, and what is said."""

FACTORS = {
    2.0: ("doubled", "twice"),
    0.5: ("halved", "half"),
    10.0: ("factor", "ten times"),
    0.1: ("factor", "a tenth of"),
}
"""The factors that have a word of their own: the name of the mistake, and the word."""
