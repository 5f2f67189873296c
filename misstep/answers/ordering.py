"""Orders as answers: names in a sequence, each used once."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Named, Unreadable
from misstep.answers.choice import plain


@dataclass(frozen=True, eq=False)
class Ordering(Answer):
    r"""Names in an order, each used once.

    among  all names that may be typed; by default those of the value

    >>> answer = Ordering(["M", "e1", "e2"])
    >>> answer.read("E2, m, e1"), answer.resemblance(["e2", "M", "e1"], 0)[1]
    (['e2', 'M', 'e1'], 'Only one name is in the wrong place.\nIt is e2, at the beginning.')
    """

    value: Sequence[str]
    among: Sequence[str] = ()

    parts = ("the order",)

    @property
    def expected(self) -> str:
        if self.among:
            return f"a list of names among {', '.join(sorted(self.among))}, each at most once"
        return f"a list of the {len(self.value)} names {', '.join(sorted(self.value))}, each once"

    def read(self, given: Any) -> list[str]:
        if isinstance(given, str):
            given = [name for name in re.split(r"\s*(?:->|[,;<>→])\s*", given.strip(" ()[]")) if name]
        if isinstance(given, np.ndarray) and given.ndim == 1:
            given = given.tolist()
        if not isinstance(given, (list, tuple)) or not 0 < len(given) <= 10 * len(self.value):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        given = [self._names.get(plain(name), name) if isinstance(name, str) else name for name in given]
        for name in given:
            if not isinstance(name, str) or name not in (self.among or self.value):
                quotes = "" if isinstance(name, str) else " Did you leave out the quotes?"
                raise Unreadable(f"Expected {self.expected}; {validation.brief(name)} is none of them.{quotes}")
            if given.count(name) > 1:
                raise Unreadable(f"Expected {self.expected}; {name} appears {given.count(name)} times.")
        return list(given)

    @cached_property
    def _names(self) -> dict[str, str]:
        """The names by what matters in them; those that differ only in the case of a letter must be typed as they are."""
        known = self.among or self.value
        names = [plain(name) for name in known]
        return {one: name for one, name in zip(names, known, strict=True) if names.count(one) == 1}

    def agrees(self, one: Sequence[str], other: Sequence[str], tolerance: float = TOLERANCE) -> list[bool]:
        return [list(one) == list(other)]

    def resemblance(self, given: Sequence[str], part: int) -> Named | None:
        """Return whether the order is reversed, two neighbours are swapped, or one name is in the wrong place."""
        right, mine = list(self.value), list(given)
        if mine == right[::-1]:
            return "reversed", "Your order is the right one, reversed."
        if missing := set(right) - set(mine):
            return "left out", f"Missing: {len(missing)} of the {len(right)} names."
        if len(mine) > len(right):
            return "too many", "Your list has a name that does not belong to it."
        wrong = [k for k, name in enumerate(mine) if name != right[k]]
        if len(wrong) == 2 and wrong[1] - wrong[0] == 1:
            return "neighbours swapped", f"Two neighbours are swapped.\nThey are {mine[wrong[1]]} and {mine[wrong[0]]}."
        for end, one in enumerate(mine):
            if [name for name in mine if name != one] == [name for name in right if name != one]:
                where = {0: ", at the beginning", len(right) - 1: ", at the end"}.get(end, "")
                return "one in the wrong place", f"Only one name is in the wrong place.\nIt is {one}{where}."
        return None
