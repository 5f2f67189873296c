"""Rodrigues' formula in solutions: the matrix of a twist, the rotation of an exponential, and its position."""

from collections.abc import Callable

import numpy as np
from numpy import cos, sin

from kinlib.arrays.validation import Array
from misstep.mutants.expression import Change, Changes, Expression, Operation, given
from misstep.mutants.operations import ANGLE, unit

I = np.eye(3)
SQUARED_ENTRIES = "In NumPy, `W * W` and `W**2` square entry by entry; the square of a matrix is `W @ W`."
UNIT_AXIS = "It folds the powers with $[\\omega]^3 = -[\\omega]$, which needs $|\\omega| = 1$."
ODD_SINE = "The odd powers of $[\\omega]$ fold into $[\\omega]$, and odd is the sine."
OUTER = "For a unit vector, $[\\omega]^2 = \\omega\\,\\omega^T - I$."
SERIES = (
    "The exponential of a matrix is a series of its powers; folded, its sums are $\\sin\\theta$ and $1 - \\cos\\theta$."
)
AT_ZERO = "At $\\theta = 0$ the rotation is $I$."
G = "$G(\\theta) = I\\,\\theta + (1 - \\cos\\theta)\\,[\\omega] + (\\theta - \\sin\\theta)\\,[\\omega]^2$."
STRAIGHT = (
    "That is the way of a translation, with $\\omega = 0$. Here $v$ is carried round with the body: $G(\\theta)\\,v$."
)


def angle_symbol(theta: float) -> Expression:
    """The angle theta of a formula, in radians.

    >>> [change.name for change, _ in angle_symbol(1.0).changes()][0]
    'converted to radians'
    """
    text = "convert $\\theta$ from degrees to radians, although it is in radians"
    return given("\\theta", theta, ANGLE).mistaken_for(np.radians(theta), "converted to radians", text)


def hat(w: Array) -> Array:
    """The matrix [w] (3, 3) of w (3,), without the checks of `kinlib.rigid.lie.hat`, because each mutant computes it.

    >>> hat(np.array([1.0, 2.0, 3.0]))[0]
    array([ 0., -3.,  2.])
    """
    x, y, z = w
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _rotation(w: Array, q: float) -> Array:
    size = np.sqrt(w @ w) or 1.0
    return _powers(hat(w / size), np.sin(size * q), 1 - np.cos(size * q))


def _position(w: Array, v: Array, q: float) -> Array:
    size = np.sqrt(w @ w) or 1.0
    angle = size * q
    G = _powers(hat(w / size), 1 - np.cos(angle), angle - np.sin(angle), identity=angle)
    position: Array = G @ v / size
    return position


def _powers(W: Array, first: float, second: float, square: Array | None = None, identity: float = 1.0) -> Array:
    """identity I + first W + second W^2."""
    total: Array = identity * I + first * W + second * (W @ W if square is None else square)
    return total


def truncated(A: Array, terms: int) -> Array:
    """The first terms of the series of the matrix exponential, (n, n).

    >>> truncated(np.array([[2.0]]), 3)
    array([[5.]])
    """
    total = term = np.eye(len(A))
    for k in range(1, terms):
        term = term @ A / k
        total = total + term
    return total


Formula = Callable[[Array, float], Array]
Wrong = tuple[str, str, str, Formula]

_ROTATIONS: list[Wrong] = [
    (
        "coefficients swapped",
        "swap $\\sin\\theta$ and $1 - \\cos\\theta$",
        ODD_SINE,
        lambda W, q: _powers(W, 1 - cos(q), sin(q)),
    ),
    (
        "cos for 1 - cos",
        "write $\\cos\\theta$ instead of $1 - \\cos\\theta$",
        AT_ZERO,
        lambda W, q: _powers(W, sin(q), cos(q)),
    ),
    (
        "cos for 1 - cos",
        "write $1 + \\cos\\theta$ instead of $1 - \\cos\\theta$",
        AT_ZERO,
        lambda W, q: _powers(W, sin(q), 1 + cos(q)),
    ),
    ("no identity", "leave out the identity $I$", AT_ZERO, lambda W, q: _powers(W, sin(q), 1 - cos(q), identity=0)),
    ("term left out", "leave out the term with $[\\omega]^2$", "", lambda W, q: _powers(W, sin(q), 0)),
    (
        "sign",
        "take the term with $[\\omega]^2$ with the opposite sign",
        "",
        lambda W, q: _powers(W, sin(q), cos(q) - 1),
    ),
    (
        "square left out",
        "write $[\\omega]$ instead of $[\\omega]^2$",
        "",
        lambda W, q: _powers(W, sin(q), 1 - cos(q), W),
    ),
    (
        "entry by entry",
        "square $[\\omega]$ entry by entry",
        SQUARED_ENTRIES,
        lambda W, q: _powers(W, sin(q), 1 - cos(q), W * W),
    ),
    (
        "outer product",
        "write $\\omega\\,\\omega^T$ instead of $[\\omega]^2$",
        OUTER,
        lambda W, q: _powers(W, sin(q), 1 - cos(q), W @ W + I),
    ),
    ("series cut short", "stop the series after two terms", SERIES, lambda W, q: truncated(W * q, 2)),
    ("series cut short", "stop the series after three terms", SERIES, lambda W, q: truncated(W * q, 3)),
    ("series cut short", "stop the series after four terms", SERIES, lambda W, q: truncated(W * q, 4)),
    ("exponential of each entry", "take the exponential entry by entry (`np.exp`)", SERIES, lambda W, q: np.exp(W * q)),
    ("sine and cosine swapped", "swap sine and cosine", AT_ZERO, lambda W, q: _powers(W, cos(q), 1 - sin(q))),
]
"""Wrong rotations about a unit axis: a name, what was done, what is right, and the matrix of [omega] and theta."""

_POSITIONS: list[Wrong] = [
    ("straight on", "write $v\\,\\theta$", STRAIGHT, lambda _, q: I * q),
    (
        "R v",
        "write $R\\,v$",
        "That is how fast the point moves at the end.",
        lambda W, q: _powers(W, sin(q), 1 - cos(q)),
    ),
    ("v itself", "write $v$", "$v$ is a velocity, and $G(\\theta)\\,v$ is a position.", lambda _, q: I * q**0),
    (
        "coefficients swapped",
        "swap the coefficients of $[\\omega]$ and $[\\omega]^2$",
        G,
        lambda W, q: _powers(W, q - sin(q), 1 - cos(q), identity=q),
    ),
    (
        "no theta in front",
        "write $I$ instead of $I\\,\\theta$ in $G(\\theta)$",
        G,
        lambda W, q: _powers(W, 1 - cos(q), q - sin(q)),
    ),
    (
        "term left out",
        "leave out the term of $G(\\theta)$ with $[\\omega]^2$",
        G,
        lambda W, q: _powers(W, 1 - cos(q), 0, identity=q),
    ),
    (
        "term left out",
        "leave out the term of $G(\\theta)$ with $[\\omega]$",
        G,
        lambda W, q: _powers(W, 0, q - sin(q), identity=q),
    ),
    (
        "sign",
        "write $\\theta + \\sin\\theta$ instead of $\\theta - \\sin\\theta$",
        G,
        lambda W, q: _powers(W, 1 - cos(q), q + sin(q), identity=q),
    ),
    (
        "sign",
        "take the term with $[\\omega]^2$ with the opposite sign",
        G,
        lambda W, q: _powers(W, 1 - cos(q), sin(q) - q, identity=q),
    ),
    (
        "entry by entry",
        "square $[\\omega]$ entry by entry",
        SQUARED_ENTRIES,
        lambda W, q: _powers(W, 1 - cos(q), q - sin(q), W * W, identity=q),
    ),
]
"""Wrong matrices for G(theta), likewise."""


def _changes(table: list[Wrong], node: Expression, *v: Expression) -> Changes:
    """Yield the changes of a formula for a unit axis, each applied to an axis of any length."""
    omega, theta = node.arguments[0], node.arguments[-1]
    size = float(np.linalg.norm(omega.value))
    for name, text, advice, formula in table:
        change = Change(name, *(words.replace("\\theta", f"{{{theta.latex}}}") for words in (text, "", advice)))
        yield change, Operation(name, _with_unit_axis(formula, size), node.operation.latex)(omega, theta, *v)


def _with_unit_axis(formula: Formula, size: float) -> Callable[..., Array]:
    """A formula for a unit axis, as a function of an axis of this length. A velocity is per radian then."""

    def of(omega: Array, q: float, *v: Array) -> Array:
        G = formula(hat(omega) / size, size * q)
        return G @ v[0] / size if v else G

    return of


def _raw_axis(omega: Expression) -> Expression | None:
    """The axis as it is given, if it is not of unit length, or was not."""
    if omega.operation is unit:
        return omega.arguments[0]
    return omega if abs(np.linalg.norm(omega.value) - 1) > 1e-9 else None


def _rotation_changes(node: Expression) -> Changes:
    omega, theta = node.arguments
    yield from _changes(_ROTATIONS, node)
    if raw := _raw_axis(omega):
        text = f"use ${raw.latex}$, which is no unit vector, in Rodrigues' formula"
        yield Change("formula for a unit axis", text, _FOR_UNIT_AXES, UNIT_AXIS), _printed_rotation(raw, theta)


def _position_changes(node: Expression) -> Changes:
    omega, v, theta = node.arguments
    yield from _changes(_POSITIONS, node, v)
    if raw := _raw_axis(omega):
        text = f"use ${raw.latex}$, which is no unit vector, in the formula of $G({theta.latex})$"
        yield Change("formula for a unit axis", text, _FOR_UNIT_AXES, UNIT_AXIS), _printed_position(raw, v, theta)


def _skew_changes(node: Expression) -> Changes:
    antisymmetric = "A cross product changes sign when its factors are swapped: $[\\omega]^T = -[\\omega]$."
    first_row = "$[\\omega]\\,u = \\omega \\times u$, so the first row is $(0, -\\omega_z, \\omega_y)$."
    for name, text, advice, wrong in (
        ("no minus signs", "leave out the minus signs", antisymmetric, lambda w: abs(hat(w))),
        ("symmetric", "write a symmetric matrix", antisymmetric, lambda w: np.triu(hat(w)) - np.tril(hat(w))),
        (
            "components in another order",
            "write $x$, $y$, $z$ from left to right",
            first_row,
            lambda w: hat(w[::-1] * (1, -1, 1)),
        ),
        ("components swapped", "swap $x$ and $z$", first_row, lambda w: hat(w[::-1])),
        ("diagonal", "write the components on the diagonal as well", "It holds zeros.", lambda w: hat(w) + np.diag(w)),
    ):
        yield (
            Change(name, f"{text} in ${node.latex}$", advice=advice),
            Operation(name, wrong, "[{0}]".format)(*node.arguments),
        )


def _twist_changes(node: Expression) -> Changes:
    W, v = node.arguments
    if W.operation is skew:
        [omega] = W.arguments
        text = f"put ${v.latex}$ into the block and ${omega.latex}$ into the column"
        advice = "Here a twist is $(\\omega, v)$, the rotation first."
        yield Change("halves swapped", text, advice=advice), twist_matrix(skew(v), omega)
        cross = Operation("cross product", np.matmul, "{0}\\,{1}".format)
        yield Change("moment for v", f"write $\\omega \\times {v.latex}$ into the column"), twist_matrix(W, cross(W, v))
    below = np.diag([0.0, 0, 0, 1])
    for name, text, advice, wrong in (
        (
            "like a pose",
            "write a 1 into the corner",
            "That is a pose's; $[S]$ is a velocity of poses, and the last row of a pose never changes.",
            lambda S: S + below,
        ),
        ("last row", "write $v$ into the last row", "It is the last column.", _with_last_row),
        ("last row", "write $v$ into the last row as well", "It is only the last column.", lambda S: S + _column(S).T),
        ("v left out", "leave out $v$", "", lambda S: S - _column(S)),
        (
            "identity added",
            "add the identity",
            "The diagonal of $[S]$ holds zeros; $I + [S]$ is the beginning of $e^{[S]}$.",
            lambda S: S + np.eye(4),
        ),
    ):
        yield Change(name, text, advice=advice), Operation(name, wrong, "{0}".format)(node)


def _column(S: Array) -> Array:
    column: Array = S * (0, 0, 0, 1)
    return column


def _with_last_row(S: Array) -> Array:
    moved: Array = S - _column(S) + _column(S).T
    return moved


skew = Operation("skew-symmetric matrix", hat, "[{0}]".format, _skew_changes)
"""The skew-symmetric matrix [omega] (3, 3)."""

twist_matrix = Operation(
    "matrix of a twist",
    lambda W, v: np.block([[W, v[:, None]], [np.zeros((1, 4))]]),
    "({0}, {1})".format,
    _twist_changes,
)
"""The matrix [S] (4, 4) of a twist, from [omega] and v."""

rotation_exp = Operation("rotation", _rotation, "e^{{[{0}]{1}}}".format, _rotation_changes)
"""The rotation e^{[omega] theta}, by Rodrigues' formula; omega need not be of unit length."""

position_exp = Operation("position", _position, "G({2})\\,{1}".format, _position_changes)
"""The position of e^{[S] theta} for S = (omega, v) with omega not zero: G(theta) v."""

_printed_rotation = Operation("(3.51)", lambda w, q: _powers(hat(w), np.sin(q), 1 - np.cos(q)), "e^{{[{0}]{1}}}".format)
_printed_position = Operation(
    "(3.88)", lambda w, v, q: _powers(hat(w), 1 - np.cos(q), q - np.sin(q), identity=q) @ v, "G({2})\\,{1}".format
)
_FOR_UNIT_AXES = "use formulas for a unit axis, although the axis is no unit vector"
