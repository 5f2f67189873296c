"""Entries or one row of a DH table as an answer: each entry is judged by itself, and angles modulo a full turn."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS, is_plausible_angle
from misstep.answers.base import TOLERANCE
from misstep.answers.entries import Slip
from misstep.answers.likeness import Likeness, copied_row
from misstep.answers.number import LENGTH, PURE, Numbers


def symbol(name: str) -> str:
    r"""Return the name of an entry as mathematics.

    >>> symbol("alpha_2"), symbol("d")
    ('$\\alpha_2$', '$d$')
    """
    return f"$\\{name}$" if name.startswith(ANGLE_COLUMNS) else f"${name}$"


@dataclass(frozen=True, eq=False)
class DHEntriesAnswer(Numbers):
    """Named entries of a DH table, shape (k,): lengths in metres, angles in radians.

    An entry is an angle if its name contains alpha or theta. Each entry is a part.

    >>> DHEntriesAnswer(np.array([0.4, np.pi]), names=["a_1", "theta_1"]).agrees(np.array([0.4, -np.pi]), np.array([0.4, np.pi]))
    [True, True]
    """

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{len(self.names)} numbers, {', '.join(self.names)}, lengths in metres and angles in radians"

    @property
    def parts(self) -> Sequence[str]:
        # A card capitalizes the first word of a sentence, and "A_1" (a link transform) is not a_1 (a length).
        return [name if " " in name else f"entry {symbol(name)}" for name in self.names]

    def read(self, given: Any) -> Array:
        # Rows of four entries may be given as a table.
        shape = (len(self._rows(self.value)), len(COLUMNS))
        return super().read(np.ravel(given) if shape[0] > 1 and _has_shape(given, shape) else given)

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        angles_agree = _same_angle(one, other, tolerance)
        return np.where(self.kinds() == PURE, angles_agree, super().same_entries(one, other, tolerance))

    def part_indices(self) -> list[int]:
        return list(range(len(self.names)))

    def kinds(self) -> NDArray[np.int_]:
        return np.array([PURE if self._is_angle(part) else LENGTH for part in range(len(self.names))])

    def place(self, index: Sequence[Any]) -> str:
        return str(self.parts[index[0]])

    def entry_slips(self) -> Iterator[Slip]:
        for name, rows, text, part in super().entry_slips():
            yield name, rows, text, part if name == "sign of one entry" else ""  # a swap takes two parts

    def length_entries(self) -> NDArray[np.bool_]:
        return np.asarray(self.kinds() == LENGTH)

    def angle_entries(self) -> NDArray[np.bool_]:
        return np.asarray(self.kinds() == PURE)

    def explanation(self, given: Array, part: int) -> tuple[str, str] | None:
        if len(rows := self._rows(given)) > 1:
            row = part // len(COLUMNS)
            typed, ours = (list(self._rows(X)[..., None]) for X in (given, self.value))
            if copied := copied_row(typed, ours, row, [f"row {k + 1}" for k in range(len(rows))]):
                return copied
        mine, right = float(given[part]), float(self.value[part])
        cases: tuple[tuple[Any, str, str], ...]
        if self._is_angle(part):
            cases = (
                (_same_angle(mine, -right), "sign of an entry", "The size is right, the sign is not."),
                (
                    _same_angle(np.radians(mine), right),
                    "an entry in degrees",
                    "This is the right angle in degrees. Give it in radians.",
                ),
                (
                    _same_angle(np.radians(mine), -right),
                    "an entry in degrees and its sign",
                    "This is in degrees, and its sign is wrong.",
                ),
                (abs(mine) <= TOLERANCE, "left out", "This is 0, but the angle is not 0."),
                (_same_angle(mine, right + np.pi), "half a turn", "It differs from the right angle by half a turn."),
            )
        else:
            cases = (
                (abs(mine + right) <= TOLERANCE, "sign of an entry", "The size is right, the sign is not."),
                (
                    abs(mine - 1000 * right) <= min(1, 100 * abs(right)),
                    "unit of length",
                    "This is the right length in millimetres. Give it in metres.",
                ),
                (abs(mine) <= TOLERANCE, "left out", "This is 0, but the length is not 0."),
            )
        return next(((name, text) for is_so, name, text in cases if is_so), None)

    def arrangement(self, given: Array) -> tuple[str, str] | None:
        """Return how the rows of a table that are listed one after the other are the right ones in another order."""
        found = None
        if len(self._rows(given)) > 1:
            mine, right = (self._rows(X)[..., None] for X in (given, self.value))
            found = Likeness(mine, right, columns=[symbol(name) for name in COLUMNS]).order()
        return found or super().arrangement(given)

    def _rows(self, entries: Array) -> Array:
        """The entries as whole rows of a table, (n, 4); none if they are not such rows."""
        return np.reshape(entries, (-1, len(COLUMNS))) if len(entries) % len(COLUMNS) == 0 else np.empty((0, 4))

    def hint(self, given: Array, part: int) -> str:
        if self._is_angle(part) and not is_plausible_angle(given[part]):
            return f"This is read as {given[part]:g} rad, more than a full turn. Is it in degrees?"
        return ""

    def _is_angle(self, part: int) -> bool:
        return any(angle in self.names[part] for angle in ANGLE_COLUMNS)


def _has_shape(given: Any, shape: tuple[int, int]) -> bool:
    try:
        return bool(np.shape(given) == shape)
    except Exception:  # reading the shape of a student's object may raise any error
        return False


def _same_angle(one: Any, other: Any, tolerance: float = TOLERANCE) -> Any:
    # The chord 2 sin(x / 2) of an angular difference x does not change when x changes by a full turn.
    return np.abs(2 * np.sin((one - other) / 2)) <= tolerance


@dataclass(frozen=True, eq=False)
class DHRowAnswer(DHEntriesAnswer):
    """One row of a DH table, shape (4,): a, alpha, d, theta, in metres and radians. Each entry is a part.

    >>> DHRowAnswer(np.array([0.4, 0, 0, np.pi])).agrees(np.array([0.4, 0, 0, -np.pi]), np.array([0.4, 0, 0.1, np.pi]))
    [True, True, False, True]
    """

    names: Sequence[str] = COLUMNS
    noun: ClassVar[str] = "row"

    def arrangement(self, given: Array) -> tuple[str, str] | None:
        for order in list(permutations(range(4)))[1:]:
            if all(self.same_entries(given, self.value[list(order)])) and len(set(np.round(self.value, 3))) == 4:
                theirs, ours = (", ".join(symbol(COLUMNS[k]) for k in ks) for ks in (order, range(4)))
                return "order of the numbers", f"Your numbers are in the order {theirs}. Give them in the order {ours}."
        return super().arrangement(given)
