"""Numbers of a student's own: the same numbers every time, and different numbers for every student.

A variant depends on the student, the problem and nothing else, on every machine and for years to come. Of Python's
generator only `random()` promises this, so everything here is built on it.
"""

import hashlib
import random
from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")


class Sampler:
    """A source of chance that belongs to one student and one problem.

    >>> sampler = Sampler("ada", "03.1")
    >>> sampler.integer(1, 6) == Sampler("ada", "03.1").integer(1, 6)
    True
    >>> sampler.choice("abc") in "abc", sampler.degrees(-90, 90) % 5, 0.1 <= sampler.length(0.1, 0.5) <= 0.5
    (True, 0, True)
    >>> sorted(sampler.shuffled([3, 1, 2]))
    [1, 2, 3]
    """

    def __init__(self, student: str, problem: str, attempt: int = 0) -> None:
        key = f"{student.strip().casefold()}/{problem}/{attempt}"
        self._random = random.Random(int.from_bytes(hashlib.sha256(key.encode()).digest()))

    def choice(self, options: Sequence[T]) -> T:
        """One of the options, each as likely as the next."""
        return options[int(self._random.random() * len(options))]

    def integer(self, low: int, high: int) -> int:
        """A whole number from low to high, both included."""
        return self.choice(range(low, high + 1))

    def length(self, low: float, high: float) -> float:
        """A length in metres from low to high, in steps of 5 cm: short enough to type."""
        return round(self.integer(round(low * 20), round(high * 20)) / 20, 2)

    def degrees(self, low: int, high: int) -> int:
        """An angle for people, in steps of 5 degrees, never 0: a joint that stands still tests nothing."""
        return self.choice([angle for angle in range(low, high + 1, 5) if angle])

    def shuffled(self, items: Sequence[T]) -> list[T]:
        """The items in a drawn order."""
        left = list(items)
        return [left.pop(int(self._random.random() * len(left))) for _ in items]
