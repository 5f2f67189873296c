"""Choices as answers: one of several named options, alone or with a reason, so that trying the options solves nothing."""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Named, Unreadable


def plain(text: str) -> str:
    """Return the letters, digits and signs of a text, in small letters, with Greek letters by their names.

    >>> plain(" (B) "), plain("theta 3"), plain("θ₃"), plain("-X")
    ('b', 'theta3', 'theta3', '-x')
    """
    letters = (
        name.split()[-1] if (name := unicodedata.name(letter, "")).startswith("GREEK") else letter
        for letter in unicodedata.normalize("NFKC", text)
    )
    return "".join(letter for letter in "".join(letters).lower() if letter.isalnum() or letter in "+-")


@dataclass(frozen=True, eq=False)
class Choice(Answer):
    """One of several named options; each wrong one is a mistake of the problem.

    >>> choice = Choice("b", {"a": "to the left", "b": "to the right"})
    >>> choice.read(" B "), choice.read("(b)"), choice.read("To the right.")
    ('b', 'b', 'b')
    """

    value: str
    options: Mapping[str, str]

    parts = ("the choice",)

    @property
    def expected(self) -> str:
        return f"one of {', '.join(map(repr, self.options))}"

    def read(self, given: Any) -> str:
        texts = [(plain(text), option) for option, text in self.options.items()]
        # The name of an option goes before the text of another one, and a text that two of them have names neither.
        options = {text: option for text, option in texts if text and [one for one, _ in texts].count(text) == 1}
        options |= {plain(option) + text: option for text, option in texts}
        options |= {word + plain(option): option for word in ("option", "answer", "") for option in self.options}
        if isinstance(given, int | np.integer) and not isinstance(given, bool):
            given = str(given)
        if not isinstance(given, str) or plain(given) not in options:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return options[plain(given)]

    def agrees(self, one: str, other: str, tolerance: float = TOLERANCE) -> list[bool]:
        return [one == other]


@dataclass(frozen=True, eq=False)
class ReasonedChoice(Answer):
    """One of several named options, and an answer that shows why; there are points only for both.

    called  the name of the second: "the sum"

    >>> from misstep.answers.number import Numbers
    >>> answer = ReasonedChoice(Choice("b", {"a": "left", "b": "right"}), Numbers(np.array(0.5)))
    >>> answer.expected
    "a pair (option, reason): one of 'a', 'b', and one number"
    >>> answer.agrees(answer.read(("B", "1/2")), answer.value), answer.agrees(answer.read(["a", 0.5]), answer.value)
    ([True, True], [False, True])
    """

    choice: Choice
    reason: Answer
    called: str = "the reason"

    @property
    def parts(self) -> Sequence[str]:
        return ["the choice", self.called]

    @property
    def value(self) -> tuple[str, Any]:
        return self.choice.value, self.reason.value

    @property
    def expected(self) -> str:
        return f"a pair (option, reason): {self.choice.expected}, and {self.reason.expected}"

    def read(self, given: Any) -> tuple[str, Any]:
        if not isinstance(given, (list, tuple)) or len(given) != 2:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return self.choice.read(given[0]), self.reason.read(given[1])

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        pairs = ((self.choice, one[0], other[0]), (self.reason, one[1], other[1]))
        return [all(answer.agrees(mine, right, tolerance)) for answer, mine, right in pairs]

    def seen(self, given: Any, part: int) -> Named | None:
        return self.reason.at_sight(given[1]) if part == 1 else None

    def resemblance(self, given: Any, part: int) -> Named | None:
        if part == 0:
            return None
        return self.reason.resemblance(given[1], 0) if len(self.reason.parts) == 1 else self.reason.order(given[1])

    def counts(self, given: Any, right: Sequence[bool]) -> bool:
        return False
