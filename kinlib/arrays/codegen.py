"""Code generation: trace an array formula once, and write what it computes as a plain Python function.

For a million configurations or poses an array formula is fast. For a single one it is slow, because NumPy spends its time on finding
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
from functools import cache
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import MAX_ROTATION_RAD

Tracers = NDArray[np.object_]

FEW_ELEMENTS = 20
"""Up to so many elements of a batch, one run of the generated code for each is faster than one run of the formula on arrays."""

FUNCTIONS: dict[str, Callable[..., float]] = {
    "cos": math.cos,
    "sin": math.sin,
    "sqrt": math.sqrt,
    # Those of NumPy, because their last digit can differ from Python's, and an element of a batch must give the same alone.
    "tan": lambda x: float(np.tan(x)),
    "arctan2": lambda y, x: float(np.arctan2(y, x)),
}
"""The functions that a generated program can call."""


class PythonProgram:
    """A generated function of n numbers, which computes one configuration at a time.

    source  its text
    lines   the number of its operations
    run     the function: it takes n numbers, and returns the entries of the result, row by row
    """

    def __init__(self, source: str) -> None:
        namespace: dict[str, Any] = dict(FUNCTIONS)
        exec(source, namespace)  # noqa: S102 - `trace_to_python` wrote it, from its own variable names and numbers
        self.source, self.lines = source, source.count("\n")
        self.run: Callable[..., tuple[float, ...]] = namespace["run"]

    def __reduce__(self) -> tuple[type[Self], tuple[str]]:
        # A function made by exec cannot be pickled for another process, but its text can.
        return type(self), (self.source,)


def trace_to_python(formula: Callable[[Tracers], NDArray[Any]], n: int) -> PythonProgram:
    """Trace a formula of n arguments, and generate the program that computes it without arrays.

    formula  takes an array (n,) and returns an array of any shape, using only +, -, *, /, @ and the FUNCTIONS of NumPy
    """
    lines: dict[str, str] = {}
    arguments = [f"q{i}" for i in range(1, n + 1)]
    entries = np.ravel(formula(np.array([Tracer(name, lines) for name in arguments], dtype=object)))
    body = [f"{name} = {expression}" for expression, name in lines.items()]
    results = ", ".join(_expression(entry) for entry in entries)
    return PythonProgram("\n    ".join([f"def run({', '.join(arguments)}):", *body, f"return {results}"]))


@cache
def columnwise_program(
    formula: Callable[[NDArray[Any]], NDArray[Any]], input_shape: tuple[int, ...]
) -> Callable[..., tuple[float, ...]]:
    """Generate, at the first call, the program that computes a formula for `apply_columnwise` for one element.

    The program takes the entries of the element, row by row, and returns those of the result, row by row.

    >>> halves_of_transpose = columnwise_program(lambda columns: columns.swapaxes(0, 1) / 2, (2, 2))
    >>> halves_of_transpose(1.0, 2.0, 3.0, 4.0)
    (0.5, 1.5, 1.0, 2.0)
    """

    def of_one(entries: Tracers) -> NDArray[Any]:
        return formula(entries.reshape(input_shape).T[..., None])[..., 0].T

    return trace_to_python(of_one, math.prod(input_shape)).run


def few_elements(x: NDArray[np.float64], size: int) -> list[list[float]]:
    """Return the entries of each element of x, of `size` numbers each, if generated code is to compute them; otherwise [].

    That is so for one element or a few, without NaN and without entries so large that a formula could overflow.

    >>> few_elements(np.eye(2), 4), few_elements(np.zeros((1000, 2)), 2), few_elements(np.array([1.0, np.nan]), 2)
    ([[1.0, 0.0, 0.0, 1.0]], [], [])
    """
    if x.size > FEW_ELEMENTS * size:
        return []
    elements = x.reshape(-1, size).tolist()
    # If any entry is NaN or infinite, so is the sum, and the comparison is false.
    return elements if sum(map(abs, x.ravel().tolist())) <= MAX_ROTATION_RAD else []


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

    def __truediv__(self, other: Any) -> "Tracer":
        return self._record(f"{self.name} / {_expression(other)}")

    def __rtruediv__(self, other: float) -> "Tracer":
        return self._record(f"{_expression(other)} / {self.name}")

    def __neg__(self) -> "Tracer":
        return self._record(f"-{self.name}")

    def cos(self) -> "Tracer":
        """Record the cosine; np.cos calls this method for each object of an array."""
        return self._record(f"cos({self.name})")

    def sin(self) -> "Tracer":
        """Record the sine; np.sin calls this method for each object of an array."""
        return self._record(f"sin({self.name})")

    def tan(self) -> "Tracer":
        """Record the tangent; np.tan calls this method for each object of an array."""
        return self._record(f"tan({self.name})")

    def sqrt(self) -> "Tracer":
        """Record the square root; np.sqrt calls this method for each object of an array."""
        return self._record(f"sqrt({self.name})")

    def arctan2(self, x: "Tracer") -> "Tracer":
        """Record the angle of the point (x, self); np.arctan2 calls this method for each object of an array."""
        return self._record(f"arctan2({self.name}, {x.name})")

    def _record(self, expression: str) -> "Tracer":
        return Tracer(self.lines.setdefault(expression, f"v{len(self.lines) + 1}"), self.lines)


def _equals(other: Any, number: float) -> bool:
    return not isinstance(other, Tracer) and other == number


def _expression(value: Any) -> str:
    return value.name if isinstance(value, Tracer) else repr(float(value))
