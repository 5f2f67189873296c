"""Entries, one row or the rows of a DH table as an answer: angles are compared modulo a full turn."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kincourse.mistakes.dh import slips_of_rows, symbol
from kinlib.arrays.validation import Array
from kinlib.dh.parsing import ANGLE_COLUMNS, COLUMNS, is_plausible_angle
from misstep.answers.base import TOLERANCE, Named
from misstep.answers.likeness import ANGLE, LENGTH, Likeness
from misstep.answers.number import Numbers
from misstep.mutants.expression import Slip


class _DHNumbers(Numbers):
    """Numbers of a DH table, lengths and angles; angles are compared modulo a full turn."""

    def same_entries(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        angles_agree = _same_angle(one, other, tolerance)
        return np.where(self.kinds() == ANGLE, angles_agree, super().same_entries(one, other, tolerance))

    def likeness(self, given: Array, part: int | None) -> Likeness:
        found = super().likeness(given, part)
        angles = np.atleast_1d((self.kinds() == ANGLE)[... if part is None else part])[..., None]
        # A larger number is in degrees, and an angle with the other sign is no turn away.
        is_turned = angles & (np.abs(found.mine) < 4 * np.pi) & (np.abs(found.mine + found.right) > TOLERANCE)
        turns = np.where(is_turned, np.round((found.mine - found.right) / (2 * np.pi)), 0)
        return replace(found, right=found.right + 2 * np.pi * turns.reshape(found.right.shape))


@dataclass(frozen=True, eq=False)
class DHEntriesAnswer(_DHNumbers):
    """Named entries of a DH table, shape (k,): lengths in metres, angles in radians.

    An entry is an angle if its name contains alpha or theta. Each entry is a part.
    """

    names: Sequence[str] = ()

    @property
    def expected(self) -> str:
        return f"{len(self.names)} numbers, {', '.join(self.names)}, lengths in metres and angles in radians"

    @property
    def parts(self) -> Sequence[str]:
        # A card capitalizes the first word of a sentence, and "A_1" (a link transform) is not a_1 (a length).
        return [name if " " in name else f"entry {symbol(name)}" for name in self.names]

    def kinds(self) -> NDArray[np.int_]:
        return np.array([ANGLE if self._is_angle(part) else LENGTH for part in range(len(self.names))])

    def resemblance(self, given: Array, part: int) -> Named | None:
        if found := super().resemblance(given, part):
            return found
        is_angle = self._is_angle(part)
        if is_angle and _same_angle(given[part], self.value[part] + np.pi):
            return "half a turn", "It differs from the right angle by half a turn."
        text = f"This is read as {given[part]:g} rad, more than a full turn. Is it in degrees?"
        return ("", text) if is_angle and not is_plausible_angle(given[part]) else None

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether half of the entries are right, which no wrong method gives."""
        return 2 * sum(right) >= len(right)

    def _is_angle(self, part: int) -> bool:
        return any(angle in self.names[part] for angle in ANGLE_COLUMNS)


@dataclass(frozen=True, eq=False)
class DHRowAnswer(DHEntriesAnswer):
    """One row of a DH table, shape (4,): a, alpha, d, theta, in metres and radians. Each entry is a part."""

    names: Sequence[str] = COLUMNS

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether all but one are right: by a wrong method, both lengths or both angles are."""
        return sum(right) >= len(right) - 1


@dataclass(frozen=True, eq=False)
class DHRowsAnswer(_DHNumbers):
    """Rows of a DH table at q = 0, shape (m, 4): a, alpha, d, theta, in metres and radians. Each row is a part."""

    noun: ClassVar[str] = "rows of a, alpha, d, theta in metres and radians, an array"
    alike_rows: ClassVar[bool] = True
    may_be_listed: ClassVar[bool] = True

    @property
    def parts(self) -> Sequence[str]:
        return [f"row {i + 1}" for i in range(len(self.value))]

    def kinds(self) -> NDArray[np.int_]:
        return np.broadcast_to([LENGTH, ANGLE, LENGTH, ANGLE], np.shape(self.value))

    def place(self, index: Sequence[Any]) -> str:
        return f"{symbol(COLUMNS[index[1]])} in row {index[0] + 1}"

    @property
    def slips(self) -> Sequence[Slip]:
        return slips_of_rows()

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether a right row is not so short that any method gives it, nor one that another unit leaves as it is."""
        seen = self.likeness(given, None).at_sight() if sum(right) < len(right) - 1 else None
        return has_a_telling_row(given, right) and (seen is None or seen[0] == "rounded")

    def likeness(self, given: Array, part: int | None) -> Likeness:
        return replace(super().likeness(given, part), columns=[symbol(name) for name in COLUMNS])

    def resemblance(self, given: Array, part: int) -> Named | None:
        """Return how the row resembles the right one, or which columns are wrong."""
        wrong = np.flatnonzero(~self.same_entries(given, self.value)[part])
        if found := self.likeness(given, part).resemblance():
            return found
        if len(wrong) < 3:
            columns = [COLUMNS[k] for k in wrong]
            symbols = " and ".join(map(symbol, columns))
            return f"wrong {' and '.join(columns)}", f"Some numbers of this row are right.\nLook at its {symbols}."
        return self._place(given, part)


def has_a_telling_row(rows: Array, right: Sequence[bool]) -> bool:
    """Return whether one of the right rows has two numbers that are not 0: wrong methods get others right, too."""
    return any(fine and np.count_nonzero(np.abs(row) > TOLERANCE) > 1 for fine, row in zip(right, rows, strict=True))


def _same_angle(one: Any, other: Any, tolerance: float = TOLERANCE) -> Any:
    # The chord 2 sin(x / 2) of an angular difference x does not change when x changes by a full turn.
    return np.abs(2 * np.sin((one - other) / 2)) <= tolerance * np.clip(np.abs(one), 1, 2 * np.pi)
