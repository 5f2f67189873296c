"""Answers made by hand for the census: wrong ones of the kind that students give, and right ones in an unusual form.

They are a second opinion on the feedback. So no module of this folder imports the engine, the problems or kinlib, except for
the class of tables that students hand in: every answer is computed from the given values with plain NumPy and SymPy. Each
lecture has a module, which is imported only if needed.
"""

from collections.abc import Callable, Iterable, Iterator, Set
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import Any


@dataclass(frozen=True, eq=False)
class WrongAnswer:
    """A wrong answer of the kind that students give, made by hand, and the words by which feedback may name its mistake.

    label  what was done: "R for its transpose"
    value  the answer as a student would hand it in: an array, a text, a function
    did    keywords: if feedback names a mistake, at least one of them must occur in its name or message, in any case
    right  whether the answer is right, in an unusual but correct form, and must have full marks

    >>> WrongAnswer("doubled", 4, frozenset({"twice", "2"})).is_named_by("You took twice the length.")
    True
    """

    label: str
    value: Any
    did: frozenset[str] = frozenset()
    right: bool = False

    def is_named_by(self, text: str) -> bool:
        """Return whether a name or message contains one of the keywords."""
        return any(word.casefold() in text.casefold() for word in self.did)


Maker = Callable[[Any, Any], Iterable[WrongAnswer]]
"""Makes the answers to one student's problem from its given values and, if they do not determine it, its right answer."""

_MAKERS: dict[str, Maker] = {}


def wrong_answers(number: str) -> Callable[[Maker], Maker]:
    """Register a function `make(given, answer)` for a problem, "01.5", or for a task of the robot sheets, "robot.home_pose"."""

    def register(make: Maker) -> Maker:
        _MAKERS[number] = make
        return make

    return register


def wrong(answers: dict[str, tuple[Any, str]]) -> Iterator[WrongAnswer]:
    """Make wrong answers from a dictionary: label -> (value, keywords separated by commas)."""
    for label, (value, words) in answers.items():
        yield WrongAnswer(label, value, frozenset(word.strip() for word in words.split(",")))


def alike(words: Set[str], answers: dict[str, Any]) -> Iterator[WrongAnswer]:
    """Make wrong answers of one kind, with the same keywords, from a dictionary: label -> value."""
    for label, value in answers.items():
        yield WrongAnswer(label, value, frozenset(words))


def right(answers: dict[str, Any]) -> Iterator[WrongAnswer]:
    """Make right answers in an unusual form from a dictionary: label -> value."""
    for label, value in answers.items():
        yield WrongAnswer(label, value, right=True)


def other_letters(options: dict[str, str], answer: str) -> Iterator[WrongAnswer]:
    """Every other letter as a wrong answer, with the words for it, and the right one in other forms."""
    yield from wrong(
        {f"{letter} for {answer}": (letter, words) for letter, words in options.items() if letter != answer}
    )
    yield from right({"a capital": answer.upper(), "with spaces": f" {answer} "})


def answers_by_hand(number: str, given: Any, answer: Any) -> list[WrongAnswer]:
    """Return all answers made by hand for one student's problem; an empty list for a number without any.

    given   the given values, `sheet.given(k)`
    answer  the right answer, `sheet.problem(k).answer.value`
    """
    sheet = number.split(".", maxsplit=1)[0]
    module = f"{__name__}.{'lecture_' + sheet if sheet.isdigit() else 'robot_sheets'}"
    if find_spec(module):  # the sheet of a new lecture has none yet
        import_module(module)
    return list(_MAKERS[number](given, answer)) if number in _MAKERS else []
