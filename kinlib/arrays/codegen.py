"""Code generation: trace an array formula once, and write what it computes as a plain Python function.

For a million configurations an array formula is fast. For a single one it is slow, because NumPy spends its time on finding
out, again and again, that the arrays are small and which of their entries are 0. Both can be determined beforehand.
`trace_to_python` calls the formula with tracers instead of numbers. A tracer does not compute; it records each operation as
one line of Python and leaves out what is known: 0 x, 1 x, x + 0. The recorded lines are a program without loops, calls of
NumPy or arrays, for this one robot.

>>> rotation = trace_to_python(lambda q: np.array([[np.cos(q[0]), 0 * q[0]], [1 * np.sin(q[0]), 2 * q[0]]]), 1)
>>> print(rotation.source)
def run(q1):
    v1 = cos(q1)
    v2 = sin(q1)
    v3 = 2.0 * q1
    return v1, 0.0, v2, v3
>>> rotation.run(np.pi / 2)[2:]
(1.0, 3.141592653589793)

Source: partial evaluation, as in Jones, Gomard and Sestoft, Partial Evaluation and Automatic Program Generation (1993).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

Tracers = NDArray[np.object_]


class PythonProgram:
    """A generated function of n numbers, which computes one configuration at a time.

    source  its text
    run     the function: it takes n numbers, and returns the entries of the result, row by row
    """

    def __init__(self, source: str) -> None:
        namespace: dict[str, Any] = {"cos": math.cos, "sin": math.sin}
        exec(source, namespace)  # noqa: S102 - `trace_to_python` wrote it, from its own variable names and numbers
        self.source = source
        self.run: Callable[..., tuple[float, ...]] = namespace["run"]

    def __reduce__(self) -> tuple[type[Self], tuple[str]]:
        # A function made by exec cannot be pickled for another process, but its text can.
        return type(self), (self.source,)


def trace_to_python(formula: Callable[[Tracers], NDArray[Any]], n: int) -> PythonProgram:
    """Trace a formula of n arguments, and generate the program that computes it without arrays.

    formula  takes an array (n,) and returns an array of any shape, using only +, -, *, @, np.cos and np.sin
    """
    lines: dict[str, str] = {}
    arguments = [f"q{i}" for i in range(1, n + 1)]
    entries = np.ravel(formula(np.array([Tracer(name, lines) for name in arguments], dtype=object)))
    body = [f"{name} = {expression}" for expression, name in lines.items()]
    results = ", ".join(_expression(entry) for entry in entries)
    return PythonProgram("\n    ".join([f"def run({', '.join(arguments)}):", *body, f"return {results}"]))


@dataclass(frozen=True, eq=False)
class Tracer:
    """A stand-in for a number, which records the operations applied to it.

    name   the variable that holds the number in the generated program
    lines  the recorded operations: each expression, once, and the variable that holds its value
    """

    name: str
    lines: dict[str, str]

    def __add__(self, other: Any) -> "Tracer":
        return self if _equals(other, 0) else self._record(f"{self.name} + {_expression(other)}")

    def __radd__(self, other: float) -> "Tracer":
        return self + other

    def __sub__(self, other: Any) -> "Tracer":
        return self if _equals(other, 0) else self._record(f"{self.name} - {_expression(other)}")

    def __rsub__(self, other: float) -> "Tracer":
        return -self + other

    def __mul__(self, other: Any) -> "Tracer | float":
        if _equals(other, 0):
            return 0.0
        if _equals(other, 1):
            return self
        return -self if _equals(other, -1) else self._record(f"{_expression(other)} * {self.name}")

    def __rmul__(self, other: float) -> "Tracer | float":
        return self * other

    def __neg__(self) -> "Tracer":
        return self._record(f"-{self.name}")

    def cos(self) -> "Tracer":
        """Record the cosine; np.cos calls this method for each object of an array."""
        return self._record(f"cos({self.name})")

    def sin(self) -> "Tracer":
        """Record the sine; np.sin calls this method for each object of an array."""
        return self._record(f"sin({self.name})")

    def _record(self, expression: str) -> "Tracer":
        return Tracer(self.lines.setdefault(expression, f"v{len(self.lines) + 1}"), self.lines)


def _equals(other: Any, number: float) -> bool:
    return not isinstance(other, Tracer) and other == number


def _expression(value: Any) -> str:
    return value.name if isinstance(value, Tracer) else repr(float(value))
