"""Straight-line programs: a formula for arrays, run once on names instead of numbers, writes itself out.

For a million configurations an array formula is fast. For a single one it is slow: NumPy spends its time on finding out,
again and again, that the arrays are small and which of their entries are 0. Both can be found out beforehand. `write_out`
gives the formula numbers that know only their names. They cannot compute; they note what is done to them, a line each, and
leave out what is known: 0 x, 1 x, x + 0. The notes are a program without loops, calls or arrays, for this one robot.

>>> turn = write_out(lambda q: np.array([[np.cos(q[0]), 0 * q[0]], [1 * np.sin(q[0]), 2 * q[0]]]), 1)
>>> print(turn.source)
def run(q1):
    v1 = cos(q1)
    v2 = sin(q1)
    v3 = 2.0 * q1
    return v1, 0.0, v2, v3
>>> turn.run(np.pi / 2)[2:]
(1.0, 3.141592653589793)

Source: partial evaluation, as in Jones, Gomard and Sestoft, Partial Evaluation and Automatic Program Generation (1993).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

Names = NDArray[np.object_]


class StraightLine:
    """A program of n numbers, for one configuration at a time.

    source  its text
    run     the program: n numbers in, the entries of the result out, row by row
    """

    def __init__(self, source: str) -> None:
        space: dict[str, Any] = {"cos": math.cos, "sin": math.sin}
        exec(source, space)  # noqa: S102 - written by `write_out`, of names that it chose and of numbers
        self.source = source
        self.run: Callable[..., tuple[float, ...]] = space["run"]

    def __reduce__(self) -> tuple[type[Self], tuple[str]]:
        # A function made by exec cannot travel to another process; its text can.
        return type(self), (self.source,)


def write_out(formula: Callable[[Names], NDArray[Any]], n: int) -> StraightLine:
    """Write a formula out as the straight-line program of its n arguments.

    formula  takes an array (n,) and gives an array of any shape, by +, -, *, @, np.cos and np.sin alone
    """
    lines: dict[str, str] = {}
    arguments = [f"q{i}" for i in range(1, n + 1)]
    entries = np.ravel(formula(np.array([Name(text, lines) for text in arguments], dtype=object)))
    body = [f"{name} = {text}" for text, name in lines.items()]
    results = ", ".join(entry.text if isinstance(entry, Name) else repr(float(entry)) for entry in entries)
    return StraightLine("\n    ".join([f"def run({', '.join(arguments)}):", *body, f"return {results}"]))


@dataclass(frozen=True, eq=False)
class Name:
    """A number of which only the name is known. What is done to it is noted in lines, once each."""

    text: str
    lines: dict[str, str]

    def __add__(self, other: Any) -> "Name":
        return self if _is(other, 0) else self._noted(f"{self.text} + {_text(other)}")

    def __radd__(self, other: float) -> "Name":
        return self + other

    def __sub__(self, other: Any) -> "Name":
        return self if _is(other, 0) else self._noted(f"{self.text} - {_text(other)}")

    def __rsub__(self, other: float) -> "Name":
        return -self + other

    def __mul__(self, other: Any) -> "Name | float":
        if _is(other, 0):
            return 0.0
        if _is(other, 1):
            return self
        return -self if _is(other, -1) else self._noted(f"{_text(other)} * {self.text}")

    def __rmul__(self, other: float) -> "Name | float":
        return self * other

    def __neg__(self) -> "Name":
        return self._noted(f"-{self.text}")

    def cos(self) -> "Name":
        """What np.cos asks of an object."""
        return self._noted(f"cos({self.text})")

    def sin(self) -> "Name":
        """What np.sin asks of an object."""
        return self._noted(f"sin({self.text})")

    def _noted(self, line: str) -> "Name":
        return Name(self.lines.setdefault(line, f"v{len(self.lines) + 1}"), self.lines)


def _is(other: Any, number: float) -> bool:
    return not isinstance(other, Name) and other == number


def _text(other: Any) -> str:
    return other.text if isinstance(other, Name) else repr(float(other))
