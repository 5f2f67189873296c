"""SymPy expressions as text: what `str` writes of them, read back without running it.

SymPy's own reader is `eval`, which a judge must not apply to text that others wrote.
"""

import operator
from collections.abc import Sequence
from typing import Any

from misstep.formulas import parsing
from misstep.formulas.walker import MAX_EXPONENT, Operation, Walker

MAX_CHARACTERS = 10_000
"""The most characters of a formula that SymPy writes. Each part has at least one, so there are no more parts either."""

FUNCTIONS = tuple(name for name in parsing.FUNCTIONS if name not in {"abs", "Matrix"})
"""The functions that have the same name in SymPy. A matrix is stored entry by entry."""

CONSTANTS = ("pi", "E", "I")

MAX_VALUE = 10**12
"""The largest absolute value of a number in a power or a function: the sine of exp(exp(30)) would take SymPy hours."""


def expression(text: str) -> Any:
    """Read the text of a SymPy expression, as `str` writes it.

    Raises ValueError for what the language does not have, with the place.

    >>> expression("a*cos(q1) + b**2/3")
    a*cos(q1) + b**2/3
    """
    try:
        tree = parsing.parse(text, MAX_CHARACTERS, implicit_products=False)
        return Walker(SymbolicAlgebra(), MAX_CHARACTERS).value(tree)
    except RecursionError as error:
        raise ValueError(f"{text[:60]!r} is nested too deeply for a formula.") from error


class SymbolicAlgebra:
    """The algebra whose values are SymPy expressions."""

    functions = FUNCTIONS

    def number(self, number: Any) -> Any:
        """Return the number as SymPy has it."""
        import sympy as sp

        return sp.sympify(number)

    def symbol(self, name: str) -> Any:
        """Return pi, E or I, or else a symbol without assumptions."""
        import sympy as sp

        return getattr(sp, name) if name in CONSTANTS else sp.Symbol(name)

    def apply(self, operation: Operation, *values: Any) -> Any:
        """Apply an operation. Raises ValueError for a power of numbers that is too large to compute."""
        if operation is operator.pow:
            base, exponent = values
            if base.is_number and exponent.is_number and not (abs(exponent) <= MAX_EXPONENT and abs(base) <= MAX_VALUE):
                raise ValueError(f"A power of numbers goes up to {MAX_EXPONENT} here.")
        return operation(*values)

    def call(self, function: str, arguments: Sequence[Any]) -> Any:
        """Call SymPy's function of this name. Raises ValueError for a number as argument that is too large to compute with."""
        import sympy as sp

        if not all(abs(number) <= MAX_VALUE for number in arguments if number.is_number):
            raise ValueError(f"The argument of {function} is a number beyond {MAX_VALUE:.0e}.")
        return getattr(sp, function)(*arguments)
