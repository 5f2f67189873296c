"""Rodrigues' formula in solutions: the rotation of an exponential, and its position."""

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy import cos, sin

from kinlib.arrays.validation import Array
from kinlib.rigid.lie import hat
from misstep.mutants.expression import Expression, Operation, Slip, Slips, given
from misstep.mutants.operations import ANGLE, unit

I = np.eye(3)
UNIT_AXIS = "The formula is derived with $[\\omega]^3 = -[\\omega]$, which holds for $|\\omega| = 1$ only."
SERIES = (
    "The exponential of a matrix is the series of all its powers; its sums are $\\sin \\theta$ and $1 - \\cos \\theta$."
)
G = "$G(\\theta) = I\\,\\theta + (1 - \\cos \\theta)\\,[\\omega] + (\\theta - \\sin \\theta)\\,[\\omega]^2$."
FOR_UNIT_AXES = "use formulas for a unit axis, although the axis is no unit vector"

Coefficients = Callable[[float], tuple[float, float, float]]
"""The coefficients of I, [omega] and [omega]^2 in a formula for a unit axis, as functions of theta."""

Square = Callable[[Array], Array]
"""What is written as the square of [omega]."""

RODRIGUES: Coefficients = lambda q: (1, sin(q), 1 - cos(q))  # noqa: E731
INTEGRAL: Coefficients = lambda q: (q, 1 - cos(q), q - sin(q))  # noqa: E731
"""The coefficients of G(theta), the integral of Rodrigues' formula."""

# fmt: off
_ROTATIONS: list[tuple[str, str, Coefficients]] = [
    ("coefficients swapped", "swap $\\sin \\theta$ and $1 - \\cos \\theta$", lambda q: (1, 1 - cos(q), sin(q))),
    ("cos for 1 - cos", "write $\\cos \\theta$ instead of $1 - \\cos \\theta$", lambda q: (1, sin(q), cos(q))),
    ("cos for 1 - cos", "write $1 + \\cos \\theta$ instead of $1 - \\cos \\theta$", lambda q: (1, sin(q), 1 + cos(q))),
    ("no identity", "leave out the identity $I$", lambda q: (0, sin(q), 1 - cos(q))),
    ("term left out", "leave out the term with $[\\omega]^2$", lambda q: (1, sin(q), 0)),
    ("series cut short", "stop the series after two terms", lambda q: (1, q, 0)),
    ("series cut short", "stop the series after four terms", lambda q: (1, q - q**3 / 6, q**2 / 2)),
    ("sine and cosine swapped", "swap sine and cosine", lambda q: (1, cos(q), 1 - sin(q))),
    ("another function", "write $\\theta$, where $\\sin \\theta$ belongs", lambda q: (1, q, 1 - cos(q))),
    ("another function", "write $1$, where $\\sin \\theta$ belongs", lambda q: (1, 1, 1 - cos(q))),
    ("another function", "write $\\theta^2 / 2$, where $1 - \\cos \\theta$ belongs", lambda q: (1, sin(q), q**2 / 2)),
]

_POSITIONS: list[tuple[str, str, Coefficients]] = [
    ("straight on", "write $v\\,\\theta$", lambda q: (q, 0, 0)),
    ("R v", "write $R\\,v$", RODRIGUES),
    ("v itself", "write $v$", lambda _: (1, 0, 0)),
    ("coefficients swapped", "swap the coefficients of $[\\omega]$ and $[\\omega]^2$", lambda q: (q, q - sin(q), 1 - cos(q))),
    ("no theta in front", "write $I$ instead of $I\\,\\theta$ in $G(\\theta)$", lambda q: (1, 1 - cos(q), q - sin(q))),
    ("term left out", "leave out the term of $G(\\theta)$ with $[\\omega]^2$", lambda q: (q, 1 - cos(q), 0)),
    ("term left out", "leave out the term of $G(\\theta)$ with $[\\omega]$", lambda q: (q, 0, q - sin(q))),
    ("sign", "write $\\theta + \\sin \\theta$ instead of $\\theta - \\sin \\theta$", lambda q: (q, 1 - cos(q), q + sin(q))),
    ("sine and cosine swapped", "swap sine and cosine", lambda q: INTEGRAL(np.pi / 2 - q)),
    ("another function", "write $\\cos \\theta$, where $1 - \\cos \\theta$ belongs", lambda q: (q, cos(q), q - sin(q))),
    ("another function", "write $\\sin \\theta$, where $\\theta - \\sin \\theta$ belongs", lambda q: (q, 1 - cos(q), sin(q))),
]

# fmt: on

_SQUARES: list[tuple[str, str, Square]] = [
    ("square left out", "write $[\\omega]$ instead of $[\\omega]^2$", lambda W: W),
    ("entry by entry", "square $[\\omega]$ entry by entry", lambda W: W * W),
    ("outer product", "write the outer product $\\omega\\,\\omega^T$ instead of $[\\omega]^2$", lambda W: W @ W + I),
]

_ADVICE = {
    "coefficients swapped": "The odd powers of $[\\omega]$ are multiples of $[\\omega]$, and their coefficients add up to the sine.",
    **dict.fromkeys(
        ("cos for 1 - cos", "no identity", "sine and cosine swapped"), "At $\\theta = 0$ the rotation is $I$."
    ),
    "series cut short": SERIES,
    "entry by entry": "In NumPy, `W * W` and `W**2` square entry by entry; the square of a matrix is `W @ W`.",
    "outer product": "For a unit vector, $[\\omega]^2 = \\omega\\,\\omega^T - I$.",
}

_POSITION_ADVICE = {
    **dict.fromkeys((name for name, *_ in _POSITIONS), G),
    "straight on": "$v\\,\\theta$ is the straight line of a translation, with $\\omega = 0$. Here $v$ rotates with the body: "
    "$G(\\theta)\\,v$.",
    "R v": "$R\\,v$ is a velocity, namely that of the point at the end of the motion.",
    "v itself": "$v$ is a velocity, and $G(\\theta)\\,v$ is a position.",
}


def angle_symbol(theta: float) -> Expression:
    """The angle theta of a formula, in radians."""
    text = "convert $\\theta$ from degrees to radians, although it is in radians"
    return given("\\theta", theta, ANGLE).mistaken_for(("converted to radians", text, np.radians(theta)))


def truncated(A: Array, terms: int) -> Array:
    """The first terms of the series of the matrix exponential, (n, n)."""
    total = term = np.eye(len(A))
    for k in range(1, terms):
        term = term @ A / k
        total = total + term
    return total


def _squared(W: Array) -> Array:
    square: Array = W @ W
    return square


def _formula(coefficients: Coefficients, square: Square, size: float, w: Array, q: float, *v: Array) -> Array:
    """A formula for a unit axis, applied to an axis w of this size; with v, the position that the matrix gives."""
    W, (first, second, third) = hat(w / size), coefficients(size * q)
    M: Array = first * I + second * W + third * square(W)
    return M @ v[0] / size if v else M


def _size(w: Array) -> float:
    return float(np.sqrt(w @ w)) or 1.0


def _slips(table: list[tuple[str, str, Coefficients]], right: Coefficients, node: Expression, *v: Expression) -> Slips:
    omega, theta = node.arguments[0], node.arguments[-1]
    advice = _ADVICE | _POSITION_ADVICE if v else _ADVICE
    wrong: list[tuple[str, str, Coefficients, Square]] = [(name, text, which, _squared) for name, text, which in table]
    wrong += [(name, text, right, square) for name, text, square in _SQUARES]
    for name, text, coefficients, square in wrong:
        said, why = (words.replace("\\theta", theta.latex) for words in (text, advice.get(name, "")))
        formula = partial(_formula, coefficients, square, _size(omega.value))
        # With some angles another function has the same value, which is no reason to draw other numbers.
        instead = Operation(name, formula, node.operation.latex)(omega, theta, *v)
        yield Slip(name, said, instead, advice=why, may_coincide=name == "another function")
    if raw := _raw_axis(omega):
        where = f"the formula of $G({theta.latex})$" if v else "Rodrigues' formula"
        text = f"use ${raw.latex}$, which is no unit vector, in {where}"
        printed = Operation("unit axis", partial(_formula, right, _squared, 1.0), node.operation.latex)(raw, theta, *v)
        yield Slip("formula for a unit axis", text, printed, everywhere=FOR_UNIT_AXES, advice=UNIT_AXIS)


def _raw_axis(omega: Expression) -> Expression | None:
    """The axis as it is given, if it is not of unit length, or was not."""
    if omega.operation is unit:
        return omega.arguments[0]
    return omega if abs(np.linalg.norm(omega.value) - 1) > 1e-9 else None


def _rotation_slips(node: Expression) -> Slips:
    omega, theta = node.arguments
    yield from _slips(_ROTATIONS, RODRIGUES, node)
    text = "take the exponential entry by entry (`np.exp`)"
    yield Slip("exponential of each entry", text, _entrywise(omega, theta), advice=SERIES)


# fmt: off
rotation_exp: Operation = Operation(
    "rotation", lambda w, q: _formula(RODRIGUES, _squared, _size(w), w, q), "e^{{[{0}]{1}}}".format, _rotation_slips
)
"""The rotation e^{[omega] theta}, by Rodrigues' formula; omega need not be of unit length."""

position_exp: Operation = Operation(
    "position",
    lambda w, v, q: _formula(INTEGRAL, _squared, _size(w), w, q, v),
    lambda _, v, theta: f"G({theta})\\,{v}" if not v.startswith("-") else f"G({theta})\\,({v})",
    lambda node: _slips(_POSITIONS, INTEGRAL, node, node.arguments[1]),
)
"""The position of e^{[S] theta} for S = (omega, v) with omega not zero: G(theta) v."""

_entrywise: Operation = Operation("entrywise exponential", lambda w, q: np.exp(hat(w) * q), "e^{{[{0}]{1}}}".format)
# fmt: on
