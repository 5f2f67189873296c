"""A choice with its reason: an option and a number, a place or a further name, so that trying the options solves nothing."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, Named, Unreadable, seen_at_sight
from misstep.answers.choice import Choice
from misstep.problem import Problem


@dataclass(frozen=True, eq=False)
class ReasonedChoice(Answer):
    """One of several named options, and an answer that shows why; there are points only for both.

    >>> from misstep.answers.number import Numbers
    >>> answer = ReasonedChoice(Choice("b", {"a": "left", "b": "right"}), Numbers(np.array(0.5)))
    >>> answer.expected
    "a pair (option, reason): one of 'a', 'b', and one number"
    >>> answer.agrees(answer.read(("B", "1/2")), answer.value), answer.agrees(answer.read(["a", 0.5]), answer.value)
    ([True, True], [False, True])
    """

    choice: Choice
    reason: Answer

    parts = ("the choice", "the reason")

    @property
    def value(self) -> tuple[str, Any]:
        return self.choice.value, self.reason.value

    @property
    def expected(self) -> str:
        return f"a pair (option, reason): {self.choice.expected}, and {self.reason.expected}"

    def read(self, given: Any) -> tuple[str, Any]:
        if isinstance(given, np.ndarray) and given.ndim == 1:
            given = given.tolist()
        if not isinstance(given, (list, tuple)) or len(given) != 2:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return self.choice.read(given[0]), self.reason.read(given[1])

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        pairs = ((self.choice, one[0], other[0]), (self.reason, one[1], other[1]))
        return [all(answer.agrees(mine, right, tolerance)) for answer, mine, right in pairs]

    def seen(self, given: Any, part: int | None) -> Named | None:
        return seen_at_sight(self.reason, given[1]) if part == 1 else None

    def resemblance(self, given: Any, part: int | None) -> Named | None:
        return self.reason.resemblance(given[1], 0 if len(self.reason.parts) == 1 else None) if part == 1 else None

    def counts(self, given: Any, right: Sequence[bool]) -> bool:
        return False


def with_reason(problem: Problem, reason: Answer) -> Problem:
    """Return a problem whose answer is a choice with a reason as its second part; its mistakes are those of the choice.

    >>> from misstep.answers.number import Numbers
    >>> from misstep.mistakes import mistake
    >>> side = Problem("Which side?", Choice("b", {"a": "left", "b": "right"}), [mistake("left", "a", "It is not.", "It is not.")])
    >>> with_reason(side, Numbers(np.array(0.5))).mistakes[0].value
    ('a', array(0.5))
    """
    if not isinstance(problem.answer, Choice):
        raise ValueError(f"problem must have a Choice as its answer; got {type(problem.answer).__name__}.")
    mistakes = [
        replace(wrong, value=(wrong.value, reason.value), part=wrong.part or wrong.message)
        for wrong in problem.mistakes
    ]
    return replace(problem, answer=ReasonedChoice(problem.answer, reason), mistakes=mistakes)
