"""The walk over a formula: each part of the tree is read once, and an algebra computes its value.

A formula is a syntax tree from `misstep.formulas.parsing`, a SymPy expression, or a number. What the parts become depends
on the algebra: numbers at some points (`evaluation`), or SymPy expressions (`sympy_parsing`).
"""

import ast
import operator
from collections.abc import Callable, Container, Sequence
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

import numpy as np

Value = TypeVar("Value")
Operation = Callable[..., Any]

MAX_PARTS = 5000
"""The most parts of a formula that a person types."""

MAX_EXPONENT = 64
"""The largest exponent of a power of numbers: a tower of powers would fill any memory."""

OPERATIONS: dict[type[ast.operator] | type[ast.unaryop], Operation] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}
"""The operations of the language; the algebra gets them as functions of the module `operator`."""


class Algebra(Protocol[Value]):
    """How the parts of a formula become values. Each method raises ValueError for what has no value in the algebra."""

    @property
    def functions(self) -> Container[str]:
        """The names of the functions that `call` evaluates; all but atan2 have one argument."""

    def number(self, number: Any) -> Value:
        """Return the value of a number."""

    def symbol(self, name: str) -> Value:
        """Return the value of a symbol or of a constant such as pi."""

    def apply(self, operation: Operation, *values: Value) -> Value:
        """Apply one of OPERATIONS to values."""

    def call(self, function: str, arguments: Sequence[Value]) -> Value:
        """Return the value of one of the functions."""


class Node(NamedTuple):
    """One part of a formula: a number, a symbol, an operation or a call, and the parts below it."""

    kind: str
    content: Any
    parts: Sequence[Any] = ()


class Walker(Generic[Value]):
    """Computes formulas in one algebra, with at most `max_parts` parts altogether.

    >>> class Text:
    ...     functions = ("sin", "cos")
    ...     def number(self, number): return str(number)
    ...     def symbol(self, name): return name
    ...     def apply(self, operation, *values): return f"{operation.__name__}({', '.join(values)})"
    ...     def call(self, function, arguments): return f"{function}({', '.join(arguments)})"
    >>> Walker(Text()).value(ast.parse("2*sin(q) - a", mode="eval").body)
    'sub(mul(2, sin(q)), a)'
    """

    def __init__(self, algebra: Algebra[Value], max_parts: int = MAX_PARTS) -> None:
        self._algebra = algebra
        self._max_parts = self._parts_left = max_parts
        self._known: dict[Any, Value] = {}

    def value(self, part: Any) -> Value:
        """Compute a formula.

        Raises ValueError for a part that is not in the language, and for more than `max_parts` parts; RecursionError for a
        formula that is nested too deeply.
        """
        self._parts_left -= 1
        if self._parts_left < 0:
            raise ValueError(f"It has more than {self._max_parts} parts. Is there a shorter way to write it?")
        if isinstance(part, ast.expr):
            return self._compute(_typed_node(part))
        if isinstance(part, int | float | np.integer | np.floating):
            return self._algebra.number(part)
        import sympy as sp

        if not isinstance(part, sp.Expr):
            raise ValueError(f"A value of type {type(part).__name__} is not a formula.")
        # SymPy expressions share their parts: a part that occurs a thousand times is computed once.
        if part not in self._known:
            self._known[part] = self._compute(_sympy_node(part))
        return self._known[part]

    def _compute(self, node: Node) -> Value:
        algebra = self._algebra
        match node.kind:
            case "number":
                return algebra.number(node.content)
            case "symbol":
                return algebra.symbol(node.content)
            case "call" if node.content not in algebra.functions:
                raise ValueError(f"{node.content[:40]} is not a function that a formula may contain. Is it misspelt?")
        values = [self.value(part) for part in node.parts]
        if node.kind == "call":
            if len(values) != (2 if node.content == "atan2" else 1):
                raise ValueError(f"{node.content} takes another number of arguments than {len(values)}.")
            return algebra.call(node.content, values)
        if len(values) == 1:
            return algebra.apply(node.content, *values)
        total, *others = values
        for value in others:
            total = algebra.apply(node.content, total, value)
        return total


def _typed_node(tree: ast.expr) -> Node:
    match tree:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return Node("number", number)
        case ast.Name(id=name):
            return Node("symbol", name)
        case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATIONS:
            return Node("operation", OPERATIONS[type(op)], [operand])
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
            return Node("operation", OPERATIONS[type(op)], [left, right])
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            return Node("call", name, arguments)
    raise ValueError("Only numbers, names, + - * / ^ and functions such as sin(q) make a formula.")


def _sympy_node(part: Any) -> Node:
    import sympy as sp

    match part:
        case sp.Symbol():
            return Node("symbol", part.name)
        case sp.Integer() | sp.Rational() | sp.Float():
            return Node("number", part)
        case sp.Add():
            return Node("operation", operator.add, part.args)
        case sp.Mul():
            return Node("operation", operator.mul, part.args)
        case sp.Pow():
            return Node("operation", operator.pow, part.args)
    if part in (sp.nan, sp.zoo, sp.oo, -sp.oo):
        raise ValueError("It holds NaN or infinity. Was there a division by zero?")
    constants = {sp.pi: "pi", sp.E: "E", sp.I: "I"}
    return Node("symbol", constants[part]) if part in constants else Node("call", part.func.__name__, part.args)
