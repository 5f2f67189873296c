"""Choices as answers: one of several named options."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Unreadable


@dataclass(frozen=True, eq=False)
class Choice(Answer):
    """One of several named options; each wrong one is a mistake of the problem.

    >>> choice = Choice("b", {"a": "to the left", "b": "to the right"})
    >>> choice.read(" B "), choice.read("(b)")
    ('b', 'b')
    """

    value: str
    options: Mapping[str, str]

    @property
    def expected(self) -> str:
        return f"one of {', '.join(map(repr, self.options))}"

    @property
    def parts(self) -> Sequence[str]:
        return ["the choice"]

    def read(self, given: Any) -> str:
        letter = given.strip().strip("().").lower() if isinstance(given, str) and len(given) < 100 else given
        if not isinstance(letter, str) or letter not in self.options:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return letter

    def agrees(self, one: str, other: str, tolerance: float = TOLERANCE) -> list[bool]:
        return [one == other]
