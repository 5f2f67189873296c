"""Sets and multisets as answers: elements in any order, such as the solutions of an equation, or eigenvalues."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE, Accuracy
from misstep.answers.base import Answer, Unreadable
from misstep.answers.entries import scale_of
from misstep.answers.number import Numbers
from misstep.answers.text import Text
from misstep.formulas.numerals import numeral
from misstep.mistakes import Mistake

MAX_MEMBERS = 200
"""The most elements of a set."""

Read = tuple[Any, ...]


@dataclass(frozen=True, eq=False)
class Members(Answer):
    """A set, or with `repeated` a multiset: numbers of any kind, or texts.

    value     the elements, at least one
    repeated  whether it matters how often an element appears
    accuracy  how far a number may be off, as in Numbers

    >>> answer = Members([2, 3])
    >>> [answer.agrees(answer.read(given), answer.value) for given in ({3, 2}, "{2, 3}", [2, 3, 3], {2})]
    [[True], [True], [True], [False]]
    >>> eigenvalues = Members([1 + 2j, 1 - 2j, 3.0, 3.0], repeated=True)
    >>> eigenvalues.agrees(eigenvalues.read([3, 1 - 2j, 3, 1 + 2j]), eigenvalues.value)
    [True]
    """

    value: Iterable[Any]
    repeated: bool = False
    accuracy: Accuracy | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        object.__setattr__(self, "value", list(self.value))
        if not self.value:
            raise ValueError("A set must have at least one element; got none. For an empty one take Interval('{}').")

    @cached_property
    def item(self) -> Answer:
        """The kind of answer that each element is."""
        values = list(self.value)
        if all(isinstance(value, str) for value in values):
            return Text(values[0])
        numbers = np.asarray([numeral(value) if isinstance(value, str) else value for value in values])
        is_counted = numbers.dtype.kind in "iuO"
        return Numbers(numbers[0], accuracy=self.accuracy, scale=None if is_counted else scale_of(numbers))

    parts = ("the set",)

    @property
    def expected(self) -> str:
        kind = "texts" if isinstance(self.item, Text) else "numbers"
        return f"a list of {kind} in any order" + (", each as often as it appears" if self.repeated else "")

    def read(self, given: Any) -> Read:
        if isinstance(given, str):
            inner = re.fullmatch(r"\s*[\[({](.*)[\])}]\s*", given, re.DOTALL)
            given = self._typed(inner[1] if inner else given)
        if isinstance(given, np.ndarray):
            given = given.tolist()  # each row or number is an element, and is refused if it is none
        if not isinstance(given, set | frozenset | list | tuple):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        if len(given) > MAX_MEMBERS:
            raise Unreadable(f"Expected {self.expected}; got {len(given)} elements.")
        read: list[Any] = []
        for one in given:
            try:
                if isinstance(one, list | tuple | np.ndarray):
                    raise Unreadable("An element is no list.")
                element = self.item.read(one)
            except Unreadable as error:
                raise Unreadable(f"Expected {self.expected}. Element {validation.brief(one)}: {error}") from error
            if self.repeated or not any(all(self.item.agrees(element, other)) for other in read):
                read.append(element)
        return tuple(read)

    def _typed(self, text: str) -> list[str]:
        """Cut a text into elements: "2, 3" or, of numbers, also "x = 2 or x = 3"."""
        if isinstance(self.item, Text):
            return re.split("[,;]", text)
        elements = re.split(r"[,;∨]|\band\b|\bor\b", text)
        return [re.sub(r"^\s*[^\W\d]\w*\s*=", "", one) for one in elements] if text.strip() else []

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        one, other = (some if isinstance(some, tuple) else self.read(some) for some in (one, other))
        return [len(one) == len(other) == self._count_pairs(one, other, tolerance)]

    def explanation(self, given: Read, part: int) -> tuple[str, str] | None:
        count = self._count_pairs(given, self._right)
        is_of_right, is_complete = (
            all(any(self._is_same(mine, yours) for yours in others) for mine in some)
            for some, others in ((given, self._right), (self._right, given))
        )
        if is_of_right and is_complete:
            return "multiplicity", "The elements are right. How often each of them appears is not."
        if count == len(given):
            return "elements missing", f"All that you gave is right, and {_counted(len(self._right) - count)} missing."
        if count == len(self._right):
            return "elements too many", f"All the right ones are there. {_counted(len(given) - count)} too many."
        return None

    def hint(self, given: Read, part: int) -> str:
        count = self._count_pairs(given, self._right)
        return f"{count} of your {len(given)} elements {'is' if count == 1 else 'are'} right." if count else ""

    def slips(self) -> Iterator[Mistake]:
        """Yield the set with all signs wrong, if it is another one."""
        if isinstance(self.item, Numbers):
            opposite = tuple(-one for one in self._right)
            if not all(self.agrees(opposite, self._right)):
                yield Mistake("all signs", opposite, "The elements have the right size and the wrong signs.")

    def _is_same(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> bool:
        return all(self.item.agrees(one, other, tolerance))

    def _count_pairs(self, one: Read, other: Read, tolerance: float = TOLERANCE) -> int:
        """Return how many elements of two sets can be paired, each with one that is the same answer."""
        taken: dict[int, int] = {}

        def finds_partner(mine: int, tried: set[int]) -> bool:
            for yours, element in enumerate(other):
                if yours not in tried and self._is_same(one[mine], element, tolerance):
                    tried.add(yours)
                    if yours not in taken or finds_partner(taken[yours], tried):
                        taken[yours] = mine
                        return True
            return False

        return sum(finds_partner(mine, set()) for mine in range(len(one)))


def _counted(count: int) -> str:
    return f"{count} element{'s are' if count > 1 else ' is'}"
