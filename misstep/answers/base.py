"""Kinds of answers: how each is read from whatever a student typed, compared, and shown.

An answer has parts (the screws of an arm, the rotation and the position of a pose), so that a sheet can say which part
is right and a mistake in one part does not cost the others. Reading never trusts: what cannot be read is `Unreadable`,
which says what was expected and what came.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

TOLERANCE = 1e-3
"""How far a number may be off, relative to its size where that is above 1: three printed decimals are enough."""

MAX_NUMBER = 1e12
"""No answer of the course is larger; what is has lost its way, and its square would not fit into a number."""

ROUNDING_TOLERANCE = 3e-2
"""Within this an answer was rounded on the way rather than misunderstood, and feedback says so."""


class Unreadable(ValueError):
    """What came is no answer of the kind that was asked for."""


class Answer(ABC):
    """The right answer of a problem, and the way to read and compare others of its kind."""

    value: Any
    inputs: Sequence[Any] = ()
    """What a function is called with, where the answer is one."""

    @property
    @abstractmethod
    def expected(self) -> str:
        """What to type, in words: "an array of shape (3, 6)"."""

    @property
    @abstractmethod
    def parts(self) -> Sequence[str]:
        """The names of the parts that are judged and scored one by one."""

    @abstractmethod
    def read(self, given: Any) -> Any:
        """Read what a student typed. Raises Unreadable with what was expected and what came."""

    @abstractmethod
    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        """Compare two values that were read, part by part."""

    def with_inputs(self, seed: int) -> "Answer":
        """The same answer, asked for at inputs drawn anew. Only a function has inputs."""
        return self

    def hint(self, given: Any, part: int) -> str:
        """What is right about a wrong part, if anything is: a first foothold for a mistake that nobody foresaw."""
        return ""
