"""What a formula means: its values at a few points, to thirty digits.

Two formulas are one function if they have the same values; sin(2q) is 2 sin(q) cos(q), and no rule of algebra is asked.
Formulas come as SymPy made them, or as a text that `formula_text` reads, and both are worked out in the same steps. Each
step is bounded in size, and their number is bounded: a tower of powers costs a sentence, not an hour.
"""

import ast
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from misstep.formulas.parsing import FUNCTIONS, parse
from misstep.validation import Array

POINTS = 5
"""At so many points formulas are compared. One alone would tell nearly all apart."""

MOST = 5000
"""No formula that a person finds has more parts."""

DIGITS = mpmath.MPContext()
DIGITS.dps = 30

LARGEST, LEAST, HIGHEST = DIGITS.mpf(10**12), DIGITS.mpf(10) ** -60, 64
"""No value on the way is larger, nor any exponent; what is smaller than the least is zero."""

CONSTANTS = {"pi": DIGITS.mpf(DIGITS.pi), "E": DIGITS.mpf(DIGITS.e), "I": DIGITS.mpc(0, 1)}
OTHERWISE = {"Abs": "fabs", "abs": "fabs", "ln": "log"}
CALLED = {name: getattr(DIGITS, OTHERWISE.get(name, name)) for name in FUNCTIONS if name != "Matrix"}
SPELT = {sp.pi: "pi", sp.E: "E", sp.I: "I"}

Values = tuple[Any, ...]
"""A number of thirty digits for each point."""


@dataclass(frozen=True)
class Formula:
    """A formula, or a matrix of them, that was read: what came, its values (..., POINTS), and whether it holds decimals."""

    given: Any
    values: Array
    rounded: bool


class Reader:
    """Reads formulas in some symbols, each of which has a value at each point; a positive symbol has positive ones.

    Symbols are known by their names: theta_1, theta1 and θ₁ are one, and so is q_1 unless it is a symbol of its own. With
    them the shorthand is known: c_23 is the cosine of the sum of angles 2 and 3.

    >>> Reader(sp.symbols("q_1 q_2")).read("c1*s12").values.shape
    (5,)
    """

    def __init__(self, symbols: Sequence[sp.Symbol]) -> None:
        self._points = {_key(symbol.name): _drawn(symbol) for symbol in symbols}
        self._names = ", ".join(symbol.name for symbol in symbols) or "there are none"
        self._left = MOST
        self._rounded = False
        self._known: dict[sp.Expr, Values] = {}

    @property
    def first_point(self) -> dict[str, float]:
        """What the symbols are at the first of the points, to be told to a person."""
        return {name: float(values[0]) for name, values in self._points.items()}

    def read(self, given: Any, shape: tuple[int, ...] | None = None) -> Formula:
        """Work out a text, a SymPy expression or matrix, a number, or a list or an array of these.

        shape   what it should have, without dimensions of one

        Raises ValueError for what is no formula, for another shape, for symbols that are not declared, and where there is
        no finite real value.
        """
        self._left, self._rounded, self._known = MOST, False, {}
        try:
            came, entries = _unpacked(given)
            came = tuple(size for size in came if size != 1)
            if shape is not None and came != shape:
                raise ValueError(f"Yours is {shaped(came)}.")
            values = [[_real(value) for value in self._value(entry)] for entry in entries]
        except RecursionError as error:
            raise ValueError("This is nested too deeply to be a closed form.") from error
        return Formula(given, np.array(values, dtype=float).reshape(*came, POINTS), self._rounded)

    def _value(self, part: Any) -> Values:
        self._left -= 1
        if self._left < 0:
            raise ValueError(f"It has more than {MOST} parts. Is there a shorter way to write it?")
        if isinstance(part, ast.expr):
            return self._typed(part)
        if isinstance(part, sp.Expr):
            # SymPy's expressions share their parts: what is met a thousand times is worked out once.
            if part not in self._known:
                self._known[part] = self._made(part)
            return self._known[part]
        if isinstance(part, int | float | np.integer | np.floating):
            return self._number(part)
        raise ValueError(f"What came is of type {type(part).__name__}, no formula.")

    def _typed(self, node: ast.expr) -> Values:
        match node:
            case ast.Constant(value=int() | float() as number):
                return self._number(number)
            case ast.Name(id=name):
                return self._named(name)
            case ast.UnaryOp(op=op, operand=operand) if type(op) in SIGNS:
                return _each(SIGNS[type(op)], self._value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
                return _each(OPERATIONS[type(op)], self._value(left), self._value(right))
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
                return self._called(name, arguments)
        raise ValueError("Only numbers, names, + - * / ^ and functions such as sin(q) make a formula.")

    def _made(self, expression: sp.Expr) -> Values:
        match expression:
            case sp.Symbol():
                return self._named(expression.name)
            case sp.Integer() | sp.Rational() | sp.Float():
                return self._number(expression)
            case sp.Add() | sp.Mul() | sp.Pow():
                operation = OPERATIONS[{sp.Add: ast.Add, sp.Mul: ast.Mult, sp.Pow: ast.Pow}[expression.func]]
                value, *others = map(self._value, expression.args)
                for other in others:
                    value = _each(operation, value, other)
                return value
        if expression in (sp.nan, sp.zoo, sp.oo, -sp.oo):
            raise ValueError("It holds NaN or infinity. Was there a division by zero?")
        if expression in SPELT:
            return self._named(SPELT[expression])
        return self._called(expression.func.__name__, expression.args)

    def _number(self, number: Any) -> Values:
        plain = number.item() if isinstance(number, np.generic) else number
        values = _each(lambda: DIGITS.convert(plain)) * POINTS
        # 2.0 was not rounded by anybody: an array of 0 and 1 may have become one of floats on the way.
        self._rounded |= isinstance(plain, float | sp.Float) and not float(plain).is_integer()
        return values

    def _called(self, name: str, arguments: Iterable[Any]) -> Values:
        if name not in CALLED:
            raise ValueError(f"{_cut(name)} is no function here. There are {', '.join(CALLED)}.")
        values = [self._value(argument) for argument in arguments]
        if len(values) != (2 if name == "atan2" else 1):
            raise ValueError(f"{name} takes another number of arguments than {len(values)}.")
        return _each(CALLED[name], *values)

    def _named(self, name: str) -> Values:
        found = self._symbol(_key(name)) or self._short(_key(name))
        if found:
            return found
        if name in CONSTANTS:
            return (CONSTANTS[name],) * POINTS
        if name in FUNCTIONS:
            raise ValueError(f"{name} wants its brackets at once: {name}(q)**2, not {name}^2(q).")
        raise ValueError(f"{_cut(name)} is none of the symbols here: {self._names}.")

    def _symbol(self, key: str) -> Values | None:
        other = re.sub(r"^(q|theta)(?=\d)", lambda letter: "theta" if letter[0] == "q" else "q", key)
        return self._points.get(key) or self._points.get(other)

    def _short(self, key: str) -> Values | None:
        """The values of c_23, s_1 or s_theta, if there are such angles."""
        short = re.fullmatch(r"([cs])(\d+)|([cs])(\D\w*)", key)
        if short is None:
            return None
        angles = [self._symbol(f"q{digit}") for digit in short[2]] if short[2] else [self._symbol(short[4])]
        if not all(angles):
            return None
        total = _each(lambda *parts: DIGITS.fsum(parts), *angles)
        return _each(CALLED["cos" if key[0] == "c" else "sin"], total)


def shaped(shape: tuple[int, ...]) -> str:
    """Say a shape in words.

    >>> shaped(()), shaped((3,)), shaped((3, 3))
    ('one formula', 'a vector of 3 formulas', 'a 3x3 matrix of formulas')
    """
    if len(shape) < 2:
        return f"a vector of {shape[0]} formulas" if shape else "one formula"
    return f"a {'x'.join(map(str, shape))} matrix of formulas"


def _power(base: Any, exponent: Any) -> Any:
    if abs(exponent) > HIGHEST:
        raise ValueError(f"Exponents go up to {HIGHEST} here.")
    return DIGITS.power(base, exponent)


SIGNS: dict[type[ast.unaryop], Callable[..., Any]] = {ast.USub: lambda x: -x, ast.UAdd: lambda x: x}
OPERATIONS: dict[type[ast.operator], Callable[..., Any]] = {
    ast.Add: lambda x, y: x + y,
    ast.Sub: lambda x, y: x - y,
    ast.Mult: lambda x, y: x * y,
    ast.Div: lambda x, y: x / y,
    ast.Pow: _power,
}


def _each(operation: Callable[..., Any], *values: Any) -> Values:
    """Apply an operation at each point; to no values at all, once."""
    try:
        results = [operation(*point) for point in zip(*values, strict=True)] if values else [operation()]
    except ZeroDivisionError as error:
        raise ValueError("It divides by zero.") from error
    except ValueError:
        raise
    except Exception as error:  # mpmath raises what it likes where a function has no value
        raise ValueError("It has no value at some points.") from error
    # Written so that NaN, which is neither above nor below, is refused too.
    if not all(abs(result) <= LARGEST for result in results):
        raise ValueError(f"On the way a value grows beyond {float(LARGEST):.0e}. Is there a division by zero?")
    return tuple(result if abs(result) >= LEAST else DIGITS.zero for result in results)


def _real(value: Any) -> float:
    if isinstance(value, DIGITS.mpc):
        if abs(value.imag) > 1e-20 * max(1, abs(value)):
            raise ValueError("Its values are not real. Is there a root or a logarithm of something negative?")
        value = value.real
    return float(value)


def _drawn(symbol: sp.Symbol) -> Values:
    """Values for a symbol, by its name: the same ones whenever and wherever it is asked for."""
    chance = Random(_key(symbol.name))
    least, most = (0.2, 2.0) if symbol.is_positive else (-3.0, 3.0)
    return tuple(DIGITS.mpf(least + (most - least) * chance.random()) for _ in range(POINTS))


def _unpacked(given: Any, depth: int = 0) -> tuple[tuple[int, ...], list[Any]]:
    """The shape of a formula or of a matrix of them, and its entries row by row."""
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
    if isinstance(given, sp.MatrixBase):
        given = given.tolist()
    if isinstance(given, np.ndarray) and given.ndim == 0:
        return _unpacked(given.item(), depth)
    if not isinstance(given, list | tuple | np.ndarray):
        return (), [given]
    if depth > 2 or (given.size if isinstance(given, np.ndarray) else len(given)) > MOST:
        raise ValueError("It has more entries than any matrix here.")
    rows = [_unpacked(row, depth + 1) for row in given]
    if len({shape for shape, _ in rows}) != 1:
        raise ValueError("Its rows differ in length." if rows else "It is empty.")
    return (len(rows), *rows[0][0]), [entry for _, entries in rows for entry in entries]


def _key(name: str) -> str:
    """A name without what spells it differently: theta_{1} and theta1 are one."""
    return re.sub(r"[\\_{}\s]", "", name)


def _cut(name: str) -> str:
    return name if len(name) <= 40 else name[:37] + "..."
