"""Orders as answers: names in a sequence, each used once."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, Unreadable
from misstep.answers.choice import plain
from misstep.answers.entries import wrong_slips
from misstep.mistakes import Mistake


@dataclass(frozen=True, eq=False)
class Ordering(Answer):
    """Names in an order, each used once.

    >>> Ordering(["M", "e1"]).read(["e1", "M"]), Ordering(["M", "e1"]).read("E1, m")
    (['e1', 'M'], ['e1', 'M'])
    """

    value: Sequence[str]

    parts = ("the order",)

    @property
    def expected(self) -> str:
        return f"a list of the {len(self.value)} names {', '.join(sorted(self.value))}, each once"

    def read(self, given: Any) -> list[str]:
        if isinstance(given, str):
            given = [name for name in re.split(r"\s*(?:->|[,;<>→])\s*", given.strip(" ()[]")) if name]
        if isinstance(given, np.ndarray) and given.ndim == 1:
            given = given.tolist()
        if not isinstance(given, (list, tuple)) or len(given) > 10 * len(self.value):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        given = [self._names.get(plain(name), name) if isinstance(name, str) else name for name in given]
        unknown = [name for name in given if not isinstance(name, str) or name not in self.value]
        if unknown:
            quotes = "" if isinstance(unknown[0], str) else " Did you leave out the quotes?"
            raise Unreadable(f"Expected {self.expected}; {validation.brief(unknown[0])} is none of them.{quotes}")
        missing = [name for name in self.value if given.count(name) != 1]
        if missing:
            count = given.count(missing[0])
            found = f"{missing[0]} appears {count} times" if count else f"{missing[0]} is missing"
            raise Unreadable(f"Expected {self.expected}; {found}.")
        return list(given)

    @cached_property
    def _names(self) -> dict[str, str]:
        """The names by what matters in them; those that differ only in the case of a letter must be typed as they are."""
        names = [plain(name) for name in self.value]
        return {one: name for one, name in zip(names, self.value, strict=True) if names.count(one) == 1}

    def agrees(self, one: Sequence[str], other: Sequence[str], tolerance: float = TOLERANCE) -> list[bool]:
        return [list(one) == list(other)]

    def slips(self) -> Iterator[Mistake]:
        """Yield the right order with the changes that people make by hand."""
        right = list(self.value)
        changes = [("reversed", right[::-1], "Your order is the right one, reversed.")]
        for i in range(len(right) - 1):
            one, other = right[i : i + 2]
            swapped = [*right[:i], other, one, *right[i + 2 :]]
            changes.append(("neighbours swapped", swapped, f"Only {one} and {other} are swapped."))
        for i, one in enumerate(right):
            rest = right[:i] + right[i + 1 :]
            for end in range(len(right)):
                if abs(end - i) > 1:
                    where = {0: ": at the beginning", len(rest): ": at the end"}.get(end, "")
                    text = f"Only {one} is in the wrong place{where}."
                    changes.append(("one in the wrong place", [*rest[:end], one, *rest[end:]], text))
        return wrong_slips(self, ((name, value, text, text) for name, value, text in changes))
