"""Mistakes: a wrong way with a name, the answer that it gives, and what to say to a student who gave that answer."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class Mistake:
    """A named wrong way, the answer it leads to, and what to say to the person who took it."""

    name: str
    value: Any
    message: str


def mistake(name: str, value: Any, message: str) -> Mistake:
    """Name a wrong way. The value is the answer that it gives, or a function that computes it.

    >>> mistake("sign", lambda: -1, "You turned the wrong way.").value
    -1
    """
    return Mistake(name, value() if callable(value) else value, message)
