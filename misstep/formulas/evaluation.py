"""Values of formulas at a few points, by which formulas are compared: sin(2q) is 2 sin(q) cos(q), and no algebra is needed.

There is one reader: what SymPy has made is read as the text that SymPy writes of it. Nothing of a formula is run.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice
from random import Random
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from misstep.formulas.parsing import FUNCTIONS, parse
from misstep.validation import Array

POINT_COUNT = 5
"""The number of points at which formulas are compared. A single one would already distinguish nearly all of them."""

MAX_VALUE = 1e12
"""The largest absolute value, also of intermediate results."""

MAX_PARTS = 5000
"""The most parts of a formula."""

CONSTANTS = {"pi": np.pi, "E": np.e, "e": np.e, "I": 1j, **dict.fromkeys(("nan", "zoo", "oo", "inf"), np.inf)}
"""The numbers with a name, and what SymPy writes where there is none."""

OPERATIONS: dict[type[ast.operator] | type[ast.unaryop], Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}

Values = NDArray[np.complex128]
"""The values at the points, (POINT_COUNT,)."""


def _atan2(y: Values, x: Values) -> Values:
    if y.imag.any() or x.imag.any():
        raise ValueError("It has no value at some points.")
    return np.arctan2(y.real, x.real) + 0j


VALUES: dict[str, Callable[..., Any]] = {
    name: getattr(np, name) for name in ("sin", "cos", "tan", "sqrt", "exp", "log", "abs")
}
VALUES |= {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": _atan2, "ln": np.log, "Abs": np.abs}
"""The functions of the language; all but atan2 have one argument."""


@dataclass(frozen=True)
class Formula:
    """A formula or a matrix of formulas by its values (..., POINT_COUNT), and whether it has rounded decimals."""

    values: Array
    rounded: bool


class Reader:
    """Reads formulas in some symbols, each of which has a value at each point; a positive symbol has positive values.

    Symbols are identified by their names: theta_1, theta1 and θ₁ are the same symbol, and so is q_1 unless it is declared as a
    symbol of its own. The usual shorthand works, too: c_23 is the cosine of the sum of angles 2 and 3.
    """

    def __init__(self, symbols: Sequence[sp.Symbol]) -> None:
        self._points = {_key(symbol.name): _random_values(symbol) for symbol in symbols}
        self._names = ", ".join(symbol.name for symbol in symbols) or "there are none"

    @property
    def points(self) -> list[dict[str, float]]:
        """The values of the symbols at each of the points, by their names without underscores and braces."""
        return [{name: float(values[k].real) for name, values in self._points.items()} for k in range(POINT_COUNT)]

    def read(self, given: Any, shape: tuple[int, ...] | None = None) -> Formula:
        """Evaluate text, a SymPy expression or matrix, a number, or a list or an array of these.

        shape   the shape that it must have, without dimensions of size 1

        Raises ValueError for what is not a formula, for another shape, for symbols that are not declared, and if there is no
        finite real value.
        """
        try:
            given_shape, entries = _unpacked(given)
            given_shape = tuple(size for size in given_shape if size != 1)
            if shape is not None and given_shape != shape:
                comma = isinstance(given, str) and re.search(r"\d,\d", given)
                hint = " The decimal sign is a point, as in 0.5." if comma else ""
                raise ValueError(f"Yours is {shaped(given_shape)}.{hint}")
            parts = [part for entry in entries for part in ast.walk(entry)]
            if len(parts) > 4 * MAX_PARTS:
                raise ValueError(f"It has more than {MAX_PARTS} parts. Is there a shorter way to write it?")
            with np.errstate(all="ignore"):
                values = [_real(self._value(entry)) for entry in entries]
        except RecursionError as error:
            raise ValueError("This is nested too deeply to be a closed form.") from error
        rounded = any(
            isinstance(part, ast.Constant) and isinstance(part.value, float) and part.value % 1 for part in parts
        )
        numbers = np.array(values, dtype=float).reshape(*given_shape, POINT_COUNT)
        return Formula(numbers, rounded)

    def _value(self, tree: ast.expr) -> Values:
        """Return the values of a part of a formula."""
        match tree:
            case ast.Constant(value=int() | float() as number):
                found: Any = np.full(POINT_COUNT, float(number) if abs(number) <= MAX_VALUE else np.inf, complex)
            case ast.Name(id=name):
                found = self._symbol(name)
            case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATIONS:
                found = OPERATIONS[type(op)](self._value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
                one, other = self._value(left), self._value(right)
                if isinstance(op, ast.Div) and not other.all():
                    raise ValueError("It divides by zero.")
                found = OPERATIONS[type(op)](one, other)
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in VALUES:
                if len(arguments) != (2 if name == "atan2" else 1):
                    raise ValueError(f"{name} takes another number of arguments than {len(arguments)}.")
                found = VALUES[name](*map(self._value, arguments))
            case _:
                raise ValueError("Only numbers, names, + - * / ^ and functions such as sin(q) make a formula.")
        if not (np.abs(found) <= MAX_VALUE).all():  # in this form it also refuses NaN
            raise ValueError(f"An intermediate value grows beyond {MAX_VALUE:.0e}. Is there a division by zero?")
        return np.asarray(found, dtype=complex)

    def _symbol(self, name: str) -> Values:
        """Return the values of a symbol, of a shorthand such as c_23 or s_theta, or of pi, E, e or I."""
        key = _key(name)
        if declared := self._declared(key):
            return self._points[declared]
        if short := re.fullmatch(r"([cs])(\d+|\D\w*)", key):
            names = [f"q{digit}" for digit in short[2]] if short[2].isdigit() else [short[2]]
            if all(angles := [self._declared(name) for name in names]):
                return np.asarray((np.cos if key[0] == "c" else np.sin)(sum(self._points[one] for one in angles)))
        if name in CONSTANTS:
            return np.full(POINT_COUNT, CONSTANTS[name], dtype=complex)
        if name in FUNCTIONS:
            raise ValueError(f"{name} must be followed by brackets: {name}(q)**2, not {name}^2(q).")
        cut = name if len(name) <= 40 else name[:37] + "..."
        raise ValueError(f"{cut} is none of the symbols here: {self._names}.")

    def _declared(self, key: str) -> str:
        """Return the declared symbol of this name, where q1 is theta1; "" if there is none."""
        other = re.sub(r"^(q|theta)(?=\d)", lambda letter: "theta" if letter[0] == "q" else "q", key)
        return next((name for name in (key, other) if name in self._points), "")


def numeral(text: str) -> float:
    """Return the number that a text writes, which may be computed from others. Raises ValueError for any other text.

    >>> numeral(" 1/3 ") == 1 / 3, numeral("−0.5"), numeral("2e-3"), round(numeral("3pi/2"), 4)
    (True, -0.5, 0.002, 4.7124)
    """
    try:
        return float(Reader([]).read(text, ()).values[0])
    except ValueError as error:
        raise ValueError(f"{text[:40]!r} is not a number. {error}") from error


def shaped(shape: tuple[int, ...]) -> str:
    """Describe a shape in words."""
    if len(shape) < 2:
        return f"a vector of {shape[0]} formulas" if shape else "one formula"
    return f"a {'x'.join(map(str, shape))} matrix of formulas"


def text_of(formula: sp.Expr) -> str:
    """Return the text of a SymPy expression. Raises ValueError if it has more than MAX_PARTS parts, which may share much."""
    if sum(1 for _ in islice(sp.preorder_traversal(formula), MAX_PARTS + 1)) > MAX_PARTS:
        raise ValueError(f"It has more than {MAX_PARTS} parts. Is there a shorter way to write it?")
    return str(formula)


def _unpacked(given: Any, depth: int = 0) -> tuple[tuple[int, ...], list[ast.expr]]:  # noqa: PLR0911 - one for each form
    """Return the shape of a formula or of a matrix of formulas, and its entries row by row, as syntax trees."""
    match given:
        case str():
            return _unpacked(parse(given), depth)
        case int() | float() | np.integer() | np.floating() if not isinstance(given, bool):
            return (), [ast.Constant(given.item() if isinstance(given, np.generic) else given)]
        case ast.Call(func=ast.Name(id="Matrix"), args=[matrix]):
            return _unpacked(matrix, depth)
        case ast.List() | ast.Tuple():
            given = given.elts
        case sp.MatrixBase() | sp.NDimArray():  # before expressions, because an immutable matrix is one
            given = given.tolist()
        case sp.Expr():
            return (), [parse(text_of(given))]
        case np.ndarray() if given.ndim == 0:
            return _unpacked(given.item(), depth)
        case ast.expr():
            return (), [given]
    if not isinstance(given, list | tuple | np.ndarray):
        raise ValueError(f"A value of type {type(given).__name__} is not a formula.")
    if depth > 2 or (given.size if isinstance(given, np.ndarray) else len(given)) > MAX_PARTS:
        raise ValueError("It has more entries than any matrix here.")
    rows = [_unpacked(row, depth + 1) for row in given]
    if len({shape for shape, _ in rows}) != 1:
        raise ValueError("Its rows differ in length." if rows else "It is empty.")
    return (len(rows), *rows[0][0]), [entry for _, entries in rows for entry in entries]


def _real(values: Values) -> Array:
    if (np.abs(values.imag) > 1e-9 * np.maximum(1, np.abs(values))).any():
        raise ValueError("Its values are not real. Is there a root or a logarithm of something negative?")
    return values.real


def _random_values(symbol: sp.Symbol) -> Values:
    """Return random values for a symbol. They depend on its name only, so they are the same in every process."""
    chance = Random(_key(symbol.name))
    least, most = (0.2, 2.0) if symbol.is_positive else (-3.0, 3.0)
    return np.array([least + (most - least) * chance.random() for _ in range(POINT_COUNT)], dtype=complex)


def _key(name: str) -> str:
    """Return a name without the marks in which spellings differ: theta_{1} and theta1 are the same."""
    return re.sub(r"[\\_{}\s]", "", name)
