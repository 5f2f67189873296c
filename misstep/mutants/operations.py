"""Operations of a solution that are the same in every subject: functions of angles, vectors, arrays put together."""

from collections.abc import Callable
from typing import Any

import numpy as np

from misstep.mutants.expression import ATOM, Expression, Operation, Slip, Slips, negative, power, transpose

DEGREES_ADVICE = "`np.sin`, `np.cos` and exponentials take radians: use `np.radians` first."


def _angle_slips(node: Expression) -> Slips:
    yield Slip(
        "sign of an angle",
        f"take ${node.latex}$ with the opposite sign",
        negative(node),
        everywhere="take each angle with the opposite sign",
    )
    yield Slip("halved", f"take half of ${node.latex}$", node / 2, everywhere="take half of each angle")
    yield Slip("doubled", f"take twice ${node.latex}$", 2 * node, everywhere="take twice each angle")


def _slide_slips(node: Expression) -> Slips:
    yield Slip("sign of a length", f"take ${node.latex}$ with the opposite sign", negative(node))
    text = f"convert ${node.latex}$ from degrees to radians, although it is a length"
    yield Slip(
        "length in radians", text, radians(node), everywhere="convert the lengths from degrees to radians as well"
    )


def _length_slips(node: Expression) -> Slips:
    yield Slip("sign of a length", f"take ${node.latex}$ with the opposite sign", negative(node))


def _vector_slips(node: Expression) -> Slips:
    yield Slip("sign of a vector", f"take ${node.latex}$ with the opposite sign", negative(node))


ANGLE = Operation("angle", lambda: None, str, _angle_slips)
"""The kind of a given angle."""

LENGTH = Operation("length", lambda: None, str, _length_slips)
"""The kind of a given length."""

SLIDE = Operation("slide", lambda: None, str, _slide_slips)
"""The kind of a length that is given beside angles in degrees, as the value of a prismatic joint is."""

VECTOR = Operation("vector", lambda: None, str, _vector_slips)
"""The kind of a given vector."""


def _radians_slips(node: Expression) -> Slips:
    angle = node.arguments[0]
    text, all_of_them = f"use the degrees of ${angle.latex}$ as radians", "use degrees as radians"
    yield Slip("degrees", text, angle, everywhere=all_of_them, advice=DEGREES_ADVICE)
    text = f"convert ${angle.latex}$ to radians twice"
    yield Slip("converted twice", text, radians(node), everywhere="convert to radians twice", one_by_one=False)


def _sine_slips(node: Expression) -> Slips:
    yield Slip(
        "sine and cosine swapped",
        f"use the cosine of ${node.arguments[0].latex}$, where its sine belongs",
        cos(*node.arguments),
        everywhere="swap sine and cosine",
    )


def _cosine_slips(node: Expression) -> Slips:
    yield Slip(
        "sine and cosine swapped",
        f"use the sine of ${node.arguments[0].latex}$, where its cosine belongs",
        sin(*node.arguments),
        everywhere="swap sine and cosine",
    )


def _arctan2_slips(node: Expression) -> Slips:
    yield Slip("arguments of arctan2", "swap the two arguments of `np.arctan2`", arctan2(*node.arguments[::-1]))
    yield Slip(
        "arctan for arctan2",
        "take `np.arctan` of the quotient, which does not know the quadrant",
        _arctan(*node.arguments),
    )


def _root_slips(node: Expression) -> Slips:
    yield Slip("root left out", "leave out the square root", node.arguments[0])


def _square_slips(node: Expression) -> Slips:
    yield Slip("square left out", f"leave out the square of ${node.arguments[0].latex}$", node.arguments[0])


def _unit_slips(node: Expression) -> Slips:
    text = f"use ${node.arguments[0].latex}$ as it is, without dividing it by its length"
    yield Slip("not a unit vector", text, node.arguments[0])
    if np.count_nonzero(node.value) > 1:  # otherwise all of these are the length
        for what, size in _WRONG_LENGTHS.items():
            text = f"divide ${node.arguments[0].latex}$ by {what} instead of its length"
            yield Slip("not a unit vector", text, node.arguments[0] / size(node.arguments[0].value))


def _cross_slips(node: Expression) -> Slips:
    a, b = node.arguments
    yield Slip("order", f"write ${b.latex} \\times {a.latex}$ instead of ${a.latex} \\times {b.latex}$", cross(b, a))


def _inverse_slips(node: Expression) -> Slips:
    inner = node.arguments[0]
    yield Slip(
        "inverse left out",
        f"use ${inner.latex}$, where its inverse belongs",
        inner,
        everywhere="leave out every inverse",
    )
    yield Slip(
        "transpose for inverse",
        f"transpose ${inner.latex}$ instead of inverting it",
        transpose(inner),
        everywhere="transpose instead of inverting",
    )


def _concatenation_slips(node: Expression) -> Slips:
    if len(node.arguments) == 2:
        first, second = node.arguments
        yield Slip(
            "halves swapped",
            f"put ${second.latex}$ before ${first.latex}$",
            concatenate(second, first),
            everywhere="swap the halves",
        )


def _stack_slips(node: Expression) -> Slips:
    what = "entries" if np.ndim(node.value) == 1 else "rows"
    for i in range(len(node.arguments) - 1):
        rows = list(node.arguments)
        if rows[i].key != rows[i + 1].key:
            rows[i : i + 2] = rows[i + 1], rows[i]
            yield Slip(f"{what} swapped", f"swap {what} {i + 1} and {i + 2}", stack(*rows))


def _listed(*entries: str) -> str:
    return f"({', '.join(entries)})"


_WRONG_LENGTHS: dict[str, Callable[[Any], Any]] = {
    "the square of its length": lambda x: x @ x,
    "the sum of its entries": np.sum,
    "the sum of the sizes of its entries": lambda x: np.abs(x).sum(),
    "its largest entry": lambda x: np.abs(x).max(),
}
"""Numbers by which people divide a vector where its length belongs."""

radians = Operation("radians", np.radians, "{0}".format, _radians_slips)
"""An angle in degrees as radians."""

sin = Operation("sine", np.sin, "\\sin {0}".format, _sine_slips)
cos = Operation("cosine", np.cos, "\\cos {0}".format, _cosine_slips)
arctan2 = Operation("arctan2", np.arctan2, "\\operatorname{{atan2}}({0}, {1})".format, _arctan2_slips)
_arctan = Operation("arctan", lambda y, x: np.arctan(y / x), "\\arctan({0} / {1})".format)
sqrt = Operation("root", np.sqrt, "\\sqrt{{{0}}}".format, _root_slips)
square = Operation("square", np.square, power("2"), _square_slips)
unit = Operation("unit vector", lambda x: x / np.linalg.norm(x), "{0} / |{0}|".format, _unit_slips)


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


cross = Operation("cross product", cross_product, "{0} \\times {1}".format, _cross_slips)
inverse = Operation("inverse", np.linalg.inv, power("{-1}"), _inverse_slips, involution=True)
concatenate = Operation(
    "concatenate",
    lambda *parts: np.concatenate([np.atleast_1d(part) for part in parts]),
    _listed,
    _concatenation_slips,
)
stack = Operation("stack", lambda *rows: np.stack(rows), _listed, _stack_slips)
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
