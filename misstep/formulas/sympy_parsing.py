"""Symbolic expressions as text: what `str` makes of them, read back as SymPy, with nothing run.

SymPy's own reader is `eval`. A judge that reads what a stranger wrote needs less: `formula_text` reads it as it reads what
people type, and here the tree becomes SymPy's.
"""

import ast
from typing import Any

from misstep.formulas import parsing

LONGEST = 10_000
"""No formula that SymPy makes for a person has more characters."""

HIGHEST = 64
"""The highest power of a number that is worked out: towers of powers would fill any memory."""

FUNCTIONS = tuple(name for name in parsing.FUNCTIONS if name not in {"abs", "Matrix"})
"""What SymPy knows by the same name. A matrix comes entry by entry."""

NUMBERS = ("pi", "E", "I")


def expression(text: str) -> Any:
    """Read the text of a SymPy expression, as `str` writes it.

    Raises ValueError for what the language does not have, with the place.

    >>> expression("a*cos(q1) + b**2/3")
    a*cos(q1) + b**2/3
    """
    try:
        return _value(parsing.parse(text, LONGEST, on_paper=False))
    except RecursionError as error:
        raise ValueError(f"{text[:60]!r} is nested too deeply for a formula.") from error


def _value(node: ast.expr) -> Any:
    import sympy as sp

    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return sp.sympify(number)
        case ast.Name(id=name):
            return getattr(sp, name) if name in NUMBERS else sp.Symbol(name)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=operand):
            return -_value(operand) if isinstance(sign, ast.USub) else _value(operand)
        case ast.BinOp(left=left, op=op, right=right):
            return _combined(op, _value(left), _value(right))
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in FUNCTIONS and arguments:
            return _called(getattr(sp, name), [_value(argument) for argument in arguments])
    raise ValueError(f"{ast.unparse(node)[:60]!r} is not part of a formula here; functions are {', '.join(FUNCTIONS)}.")


def _called(function: Any, arguments: list[Any]) -> Any:
    try:
        return function(*arguments)
    except TypeError as error:
        raise ValueError(f"{function} takes another number of arguments than {len(arguments)}.") from error


def _power(base: Any, exponent: Any) -> Any:
    if base.is_number and exponent.is_number and not (abs(exponent) <= HIGHEST and abs(base) <= 10**12):
        raise ValueError(f"A power of numbers goes up to {HIGHEST} here.")
    return base**exponent


def _combined(op: ast.operator, one: Any, other: Any) -> Any:
    match op:
        case ast.Add():
            return one + other
        case ast.Sub():
            return one - other
        case ast.Mult():
            return one * other
        case ast.Div():
            return one / other
        case ast.Pow():
            return _power(one, other)
    raise ValueError(f"{type(op).__name__} is not part of a formula here: write +, -, *, / and **.")
