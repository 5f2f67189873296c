"""Individual numbers for each student: different for every student, and the same whenever they are drawn again.

A variant depends on the student's id and the number of the problem only, on every machine and in every version of Python.
Python guarantees this only for `random()` of its generator, so everything here uses nothing else.
"""

import hashlib
import random
from collections.abc import Sequence
from typing import TypeVar

T = TypeVar("T")


class Sampler:
    """A random generator for one student and one problem.

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
        """Draw one of the options, all with the same probability."""
        return options[int(self._random.random() * len(options))]

    def integer(self, low: int, high: int) -> int:
        """Draw a whole number from low to high, both included."""
        return self.choice(range(low, high + 1))

    def length(self, low: float, high: float) -> float:
        """Draw a length in metres from low to high, in steps of 5 cm, so that it is short enough to type."""
        return round(self.integer(round(low * 20), round(high * 20)) / 20, 2)

    def degrees(self, low: int, high: int) -> int:
        """Draw an angle in degrees, in steps of 5, but never 0, because an angle of 0 hides most mistakes."""
        return self.choice([angle for angle in range(low, high + 1, 5) if angle])

    def shuffled(self, items: Sequence[T]) -> list[T]:
        """Return the items in a random order."""
        left = list(items)
        return [left.pop(int(self._random.random() * len(left))) for _ in items]
