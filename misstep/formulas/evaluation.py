"""Values of formulas: numbers with thirty digits at a few points, by which formulas are compared.

Two formulas are the same function if they have the same values: sin(2q) is 2 sin(q) cos(q), and no rule of algebra is needed.
SymPy expressions and typed text are computed by the same walk. The values, the exponents and the number of steps are bounded,
so a tower of powers is refused at once instead of taking an hour.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from misstep.formulas.parsing import FUNCTIONS, parse
from misstep.formulas.walker import MAX_EXPONENT, MAX_PARTS, Operation, Walker
from misstep.validation import Array

POINT_COUNT = 5
"""The number of points at which formulas are compared. A single one would already distinguish nearly all of them."""

MAX_VALUE = 10**12
"""The largest absolute value, also of intermediate results."""

MIN_VALUE = 1e-60
"""Smaller absolute values are set to zero."""

CONSTANTS = {"pi": "pi", "E": "e", "e": "e", "I": "j"}
"""The constants of a formula, with their names in mpmath."""
MPMATH_NAMES = {"Abs": "fabs", "abs": "fabs", "ln": "log"}
"""The functions that mpmath calls by another name."""

Values = tuple[Any, ...]
"""A number of thirty digits for each point."""


@cache
def digits() -> Any:
    """Return the arithmetic with thirty digits. mpmath is imported with the first formula, because most sheets begin with numbers."""
    import mpmath

    context = mpmath.MPContext()
    context.dps = 30
    return context


@dataclass(frozen=True)
class Formula:
    """A formula or a matrix of formulas: as it was given, its values (..., POINT_COUNT), and what occurs in it.

    rounded  whether it has rounded decimals
    symbols  the names of its symbols, without underscores and braces
    """

    given: Any
    values: Array
    rounded: bool
    symbols: frozenset[str] = frozenset()


class Reader:
    """Reads formulas in some symbols, each of which has a value at each point; a positive symbol has positive values.

    Symbols are identified by their names: theta_1, theta1 and θ₁ are the same symbol, and so is q_1 unless it is declared as a
    symbol of its own. The usual shorthand works, too: c_23 is the cosine of the sum of angles 2 and 3.

    >>> Reader(sp.symbols("q_1 q_2")).read("c1*s12").values.shape
    (5,)
    """

    def __init__(self, symbols: Sequence[sp.Symbol]) -> None:
        self._points = {_key(symbol.name): _random_values(symbol) for symbol in symbols}
        self._names = ", ".join(symbol.name for symbol in symbols) or "there are none"

    @property
    def points(self) -> list[dict[str, float]]:
        """The values of the symbols at each of the points, by their names without underscores and braces."""
        return [{name: float(values[k]) for name, values in self._points.items()} for k in range(POINT_COUNT)]

    def read(self, given: Any, shape: tuple[int, ...] | None = None) -> Formula:
        """Evaluate text, a SymPy expression or matrix, a number, or a list or an array of these.

        shape   the shape that it must have, without dimensions of size 1

        Raises ValueError for what is not a formula, for another shape, for symbols that are not declared, and if there is no
        finite real value.
        """
        algebra = _NumericAlgebra(self._points, self._names)
        walker = Walker(algebra)
        try:
            given_shape, entries = _unpacked(given)
            given_shape = tuple(size for size in given_shape if size != 1)
            if shape is not None and given_shape != shape:
                # More entries than expected, and text such as 0,5: a decimal comma has cut numbers in two.
                is_longer = np.prod(given_shape) > np.prod(shape)
                comma = is_longer and isinstance(given, str) and re.search(r"\d,\d", given)
                hint = " A comma separates entries; the decimal sign is a point, as in 0.5." if comma else ""
                raise ValueError(f"Yours is {shaped(given_shape)}.{hint}")
            values = [[_real(value) for value in walker.value(entry)] for entry in entries]
        except RecursionError as error:
            raise ValueError("This is nested too deeply to be a closed form.") from error
        numbers = np.array(values, dtype=float).reshape(*given_shape, POINT_COUNT)
        return Formula(given, numbers, algebra.has_rounded, frozenset(algebra.symbols))


def numeral(text: str) -> float:
    """Return the number that a text writes, which may be computed from others. Raises ValueError for any other text.

    >>> numeral(" 1/3 ") == 1 / 3, numeral("−0.5"), numeral("2e-3"), round(numeral("3pi/2"), 4)
    (True, -0.5, 0.002, 4.7124)
    """
    try:
        return float(Reader([]).read(text, ()).values[0])
    except ValueError as error:
        raise ValueError(f"{text[:40]!r} is not a number. {error}") from error


class _NumericAlgebra:
    """The algebra whose values are numbers at the points.

    points       the values of each symbol, by its name without underscores and braces
    names        the names of the symbols, for messages
    has_rounded  whether a number with decimals has occurred
    symbols      the names of the symbols that have occurred
    """

    functions = tuple(name for name in FUNCTIONS if name != "Matrix")

    def __init__(self, points: Mapping[str, Values], names: str) -> None:
        self._points = points
        self._names = names
        self.has_rounded = False
        self.symbols: set[str] = set()

    def number(self, number: Any) -> Values:
        """Return the number, the same at every point."""
        plain = number.item() if isinstance(number, np.generic) else number
        values = _at_each_point(lambda: digits().convert(plain)) * POINT_COUNT
        # 2.0 is not rounded: an array of 0 and 1 becomes an array of floats without anybody rounding it.
        self.has_rounded |= isinstance(plain, float | sp.Float) and not float(plain).is_integer()
        return values

    def symbol(self, name: str) -> Values:
        """Return the values of a symbol, of a shorthand such as c_23, or of pi, E, e or I."""
        values = self._symbol(_key(name)) or self._shorthand(_key(name))
        if values:
            return values
        if name in CONSTANTS:
            return (+getattr(digits(), CONSTANTS[name]),) * POINT_COUNT
        if name in FUNCTIONS:
            raise ValueError(f"{name} must be followed by brackets: {name}(q)**2, not {name}^2(q).")
        raise ValueError(f"{_cut(name)} is none of the symbols here: {self._names}.")

    def apply(self, operation: Operation, *values: Values) -> Values:
        """Apply an operation at each point."""
        return _at_each_point(_power if operation is operator.pow else operation, *values)

    def call(self, function: str, arguments: Sequence[Values]) -> Values:
        """Evaluate a function at each point."""
        return _at_each_point(getattr(digits(), MPMATH_NAMES.get(function, function)), *arguments)

    def _symbol(self, key: str) -> Values | None:
        other = re.sub(r"^(q|theta)(?=\d)", lambda letter: "theta" if letter[0] == "q" else "q", key)
        found = next((name for name in (key, other) if name in self._points), None)
        if found is None:
            return None
        self.symbols.add(found)
        return self._points[found]

    def _shorthand(self, key: str) -> Values | None:
        """Return the values of c_23, s_1 or s_theta, or None if there are no such angles."""
        short = re.fullmatch(r"([cs])(\d+)|([cs])(\D\w*)", key)
        if short is None:
            return None
        angles = [self._symbol(f"q{digit}") for digit in short[2]] if short[2] else [self._symbol(short[4])]
        if not all(angles):
            return None
        total = _at_each_point(lambda *parts: digits().fsum(parts), *angles)
        return self.call("cos" if key[0] == "c" else "sin", [total])


def shaped(shape: tuple[int, ...]) -> str:
    """Describe a shape in words.

    >>> shaped(()), shaped((3,)), shaped((3, 3))
    ('one formula', 'a vector of 3 formulas', 'a 3x3 matrix of formulas')
    """
    if len(shape) < 2:
        return f"a vector of {shape[0]} formulas" if shape else "one formula"
    return f"a {'x'.join(map(str, shape))} matrix of formulas"


def _power(base: Any, exponent: Any) -> Any:
    if abs(exponent) > MAX_EXPONENT:
        raise ValueError(f"Exponents go up to {MAX_EXPONENT} here.")
    return digits().power(base, exponent)


def _at_each_point(operation: Callable[..., Any], *values: Any) -> Values:
    """Apply an operation at each point; to no values at all, once."""
    try:
        results = [operation(*point) for point in zip(*values, strict=True)] if values else [operation()]
    except ZeroDivisionError as error:
        raise ValueError("It divides by zero.") from error
    except ValueError:
        raise
    except Exception as error:  # mpmath raises various errors if a function has no value
        raise ValueError("It has no value at some points.") from error
    # Written in this form, the comparison also refuses NaN, which is neither above nor below.
    if not all(abs(result) <= MAX_VALUE for result in results):
        raise ValueError(f"An intermediate value grows beyond {float(MAX_VALUE):.0e}. Is there a division by zero?")
    return tuple(result if abs(result) >= MIN_VALUE else digits().zero for result in results)


def _real(value: Any) -> float:
    if isinstance(value, digits().mpc):
        if abs(value.imag) > 1e-20 * max(1, abs(value)):
            raise ValueError("Its values are not real. Is there a root or a logarithm of something negative?")
        value = value.real
    return float(value)


def _random_values(symbol: sp.Symbol) -> Values:
    """Return random values for a symbol. They depend on its name only, so they are the same in every process."""
    chance = Random(_key(symbol.name))
    least, most = (0.2, 2.0) if symbol.is_positive else (-3.0, 3.0)
    return tuple(digits().mpf(least + (most - least) * chance.random()) for _ in range(POINT_COUNT))


def _unpacked(given: Any, depth: int = 0) -> tuple[tuple[int, ...], list[Any]]:
    """Return the shape of a formula or of a matrix of formulas, and its entries row by row."""
    if isinstance(given, str):
        return _unpacked(parse(given), depth)
    if (
        isinstance(given, ast.Call)
        and isinstance(given.func, ast.Name)
        and given.func.id == "Matrix"
        and len(given.args) == 1
    ):
        return _unpacked(given.args[0], depth)
    if isinstance(given, ast.List | ast.Tuple):
        given = given.elts
    if isinstance(given, sp.MatrixBase | sp.NDimArray):
        given = given.tolist()
    if isinstance(given, np.ndarray) and given.ndim == 0:
        return _unpacked(given.item(), depth)
    if not isinstance(given, list | tuple | np.ndarray):
        return (), [given]
    if depth > 2 or (given.size if isinstance(given, np.ndarray) else len(given)) > MAX_PARTS:
        raise ValueError("It has more entries than any matrix here.")
    rows = [_unpacked(row, depth + 1) for row in given]
    if len({shape for shape, _ in rows}) != 1:
        raise ValueError("Its rows differ in length." if rows else "It is empty.")
    return (len(rows), *rows[0][0]), [entry for _, entries in rows for entry in entries]


def _key(name: str) -> str:
    """Return a name without the marks in which spellings differ: theta_{1} and theta1 are the same."""
    return re.sub(r"[\\_{}\s]", "", name)


def _cut(name: str) -> str:
    return name if len(name) <= 40 else name[:37] + "..."
