"""Mistakes: named errors, the wrong answers to which they lead, and the feedback for them."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class Mistake:
    """A named error, the wrong answer to which it leads, and the feedback for a student who gave this answer."""

    name: str
    value: Any
    message: str


def mistake(name: str, value: Any, message: str) -> Mistake:
    """Make a Mistake; the value is the wrong answer, or a function that computes it.

    >>> mistake("sign", lambda: -1, "You turned the wrong way.").value
    -1
    """
    return Mistake(name, value() if callable(value) else value, message)
