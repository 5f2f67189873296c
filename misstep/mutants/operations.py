"""Operations of a solution that are the same in every subject: functions of angles, vectors, arrays put together."""

from collections.abc import Callable
from typing import Any

import numpy as np

from misstep.mutants.expression import ATOM, Change, Changes, Expression, Operation, negative, power, transpose

DEGREES_ADVICE = "`np.sin`, `np.cos` and exponentials take radians: use `np.radians` first."


def _angle_changes(node: Expression) -> Changes:
    yield (
        Change(
            "sign of an angle", f"take ${node.latex}$ with the opposite sign", "take each angle with the opposite sign"
        ),
        negative(node),
    )
    yield Change("half the angle", f"take half of ${node.latex}$", "take half of each angle"), node / 2
    yield Change("double the angle", f"take twice ${node.latex}$", "take twice each angle"), 2 * node


def _slide_changes(node: Expression) -> Changes:
    yield Change("sign of a length", f"take ${node.latex}$ with the opposite sign"), negative(node)
    text = f"convert ${node.latex}$ from degrees to radians, although it is a length"
    yield Change("length in radians", text, "convert the lengths from degrees to radians as well"), radians(node)


def _length_changes(node: Expression) -> Changes:
    yield Change("sign of a length", f"take ${node.latex}$ with the opposite sign"), negative(node)


def _vector_changes(node: Expression) -> Changes:
    yield Change("sign of a vector", f"take ${node.latex}$ with the opposite sign"), negative(node)


def _matrix_changes(node: Expression) -> Changes:
    yield Change("transposed", f"use the transpose of ${node.latex}$, which belongs there as it is"), transpose(node)


ANGLE = Operation("angle", lambda: None, str, _angle_changes)
"""The kind of a given angle."""

LENGTH = Operation("length", lambda: None, str, _length_changes)
"""The kind of a given length."""

SLIDE = Operation("slide", lambda: None, str, _slide_changes)
"""The kind of a length that is given beside angles in degrees, as the value of a prismatic joint is."""

VECTOR = Operation("vector", lambda: None, str, _vector_changes)
"""The kind of a given vector."""

MATRIX = Operation("matrix", lambda: None, str, _matrix_changes)
"""The kind of a given matrix."""


def _radians_changes(node: Expression) -> Changes:
    angle = node.arguments[0]
    text, all_of_them = f"use the degrees of ${angle.latex}$ as radians", "use degrees as radians"
    yield Change("degrees", text, all_of_them, DEGREES_ADVICE), angle
    text = f"convert ${angle.latex}$ to radians twice"
    yield Change("converted twice", text, "convert to radians twice", one_by_one=False), radians(node)


def _sine_changes(node: Expression) -> Changes:
    yield (
        Change(
            "sine and cosine swapped",
            f"use the cosine of ${node.arguments[0].latex}$, where its sine belongs",
            "swap sine and cosine",
        ),
        cos(*node.arguments),
    )


def _cosine_changes(node: Expression) -> Changes:
    yield (
        Change(
            "sine and cosine swapped",
            f"use the sine of ${node.arguments[0].latex}$, where its cosine belongs",
            "swap sine and cosine",
        ),
        sin(*node.arguments),
    )


def _arctan2_changes(node: Expression) -> Changes:
    yield Change("arguments of arctan2", "swap the two arguments of `np.arctan2`"), arctan2(*node.arguments[::-1])
    yield (
        Change("arctan for arctan2", "take `np.arctan` of the quotient, which does not know the quadrant"),
        _arctan(*node.arguments),
    )


def _root_changes(node: Expression) -> Changes:
    yield Change("root left out", "leave out the square root"), node.arguments[0]


def _square_changes(node: Expression) -> Changes:
    yield Change("square left out", f"leave out the square of ${node.arguments[0].latex}$"), node.arguments[0]


def _exponential_changes(node: Expression) -> Changes:
    exponent = node.arguments[0]
    text = f"take the exponent ${exponent.latex}$ with the opposite sign"
    if exponent.operation is not negative:  # which has this change already
        yield Change("sign of an exponent", text), exp(negative(exponent))


def _logarithm_changes(node: Expression) -> Changes:
    other, base = (log10, "10") if node.operation is log else (log, "e")
    yield (
        Change("base of a logarithm", f"take the logarithm of ${node.arguments[0].latex}$ to the base {base}"),
        other(*node.arguments),
    )
    yield Change("logarithm left out", f"leave out the logarithm of ${node.arguments[0].latex}$"), node.arguments[0]


def _unit_changes(node: Expression) -> Changes:
    text = f"use ${node.arguments[0].latex}$ as it is, without dividing it by its length"
    yield Change("not a unit vector", text), node.arguments[0]
    if np.count_nonzero(node.value) > 1:  # otherwise all of these are the length
        for what, size in _WRONG_LENGTHS.items():
            text = f"divide ${node.arguments[0].latex}$ by {what} instead of its length"
            yield Change("not a unit vector", text), node.arguments[0] / size(node.arguments[0].value)


def _cross_changes(node: Expression) -> Changes:
    a, b = node.arguments
    yield Change("order", f"write ${b.latex} \\times {a.latex}$ instead of ${a.latex} \\times {b.latex}$"), cross(b, a)


def _inverse_changes(node: Expression) -> Changes:
    inner = node.arguments[0]
    yield (
        Change("inverse left out", f"use ${inner.latex}$, where its inverse belongs", "leave out every inverse"),
        inner,
    )
    yield (
        Change(
            "transpose for inverse",
            f"transpose ${inner.latex}$ instead of inverting it",
            "transpose instead of inverting",
        ),
        transpose(inner),
    )


def _concatenation_changes(node: Expression) -> Changes:
    if len(node.arguments) == 2:
        first, second = node.arguments
        yield (
            Change("halves swapped", f"put ${second.latex}$ before ${first.latex}$", "swap the halves"),
            concatenate(second, first),
        )


def _stack_changes(node: Expression) -> Changes:
    what = "entries" if np.ndim(node.value) == 1 else "rows"
    for i in range(len(node.arguments) - 1):
        rows = list(node.arguments)
        if rows[i].key != rows[i + 1].key:
            rows[i : i + 2] = rows[i + 1], rows[i]
            yield Change(f"{what} swapped", f"swap {what} {i + 1} and {i + 2}"), stack(*rows)


def _listed(*entries: str) -> str:
    return f"({', '.join(entries)})"


_WRONG_LENGTHS: dict[str, Callable[[Any], Any]] = {
    "the square of its length": lambda x: x @ x,
    "the sum of its entries": np.sum,
    "the sum of the sizes of its entries": lambda x: np.abs(x).sum(),
    "its largest entry": lambda x: np.abs(x).max(),
}
"""Numbers by which people divide a vector where its length belongs."""

radians = Operation("radians", np.radians, "{0}".format, _radians_changes)
"""An angle in degrees as radians."""

sin = Operation("sine", np.sin, "\\sin {0}".format, _sine_changes)
cos = Operation("cosine", np.cos, "\\cos {0}".format, _cosine_changes)
arctan2 = Operation("arctan2", np.arctan2, "\\operatorname{{atan2}}({0}, {1})".format, _arctan2_changes)
_arctan = Operation("arctan", lambda y, x: np.arctan(y / x), "\\arctan({0} / {1})".format)
sqrt = Operation("root", np.sqrt, "\\sqrt{{{0}}}".format, _root_changes)
square = Operation("square", np.square, power("2"), _square_changes)
exp = Operation("exponential", np.exp, "\\exp({0})".format, _exponential_changes)
log = Operation("natural logarithm", np.log, "\\ln {0}".format, _logarithm_changes)
log10 = Operation("logarithm", np.log10, "\\log_{{10}} {0}".format, _logarithm_changes)
unit = Operation("unit vector", lambda x: x / np.linalg.norm(x), "{0} / |{0}|".format, _unit_changes)


def cross_product(a: Any, b: Any) -> Any:
    """Return a x b.

    np.cross spends most of its time on the order of axes, which a single pair of vectors does not need.

    >>> cross_product(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))
    array([0., 0., 1.])
    """
    if np.shape(a) != (3,) or np.shape(b) != (3,):
        return np.cross(a, b)
    (a1, a2, a3), (b1, b2, b3) = a, b
    return np.array([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1])


cross = Operation("cross product", cross_product, "{0} \\times {1}".format, _cross_changes)
inverse = Operation("inverse", np.linalg.inv, power("{-1}"), _inverse_changes, involution=True)
concatenate = Operation(
    "concatenate",
    lambda *parts: np.concatenate([np.atleast_1d(part) for part in parts]),
    _listed,
    _concatenation_changes,
)
stack = Operation("stack", lambda *rows: np.stack(rows), _listed, _stack_changes)
"""Rows put on top of each other, or numbers as a vector."""


def function(name: str, of: Any, latex: str) -> Operation:
    """Make an operation about which people make no mistake of their own from a function of arrays.

    latex  the LaTeX, with {0}, {1} for the arguments

    >>> from misstep.mutants.expression import given
    >>> cube = function("cube", lambda x: x**3, "{0}^3")
    >>> cube(given("x", 2.0)).value
    8.0
    """
    return Operation(name, of, latex.format, binds=ATOM)
