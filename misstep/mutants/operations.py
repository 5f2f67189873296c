"""Operations of a solution that are the same in every subject: functions of angles, vectors, arrays put together."""

from collections.abc import Iterator

import numpy as np

from misstep.mutants.expression import ALL_AT_ONCE, Expression, Operation, Slip, negative, power, table, transpose

DEGREES_ADVICE = "`np.sin`, `np.cos` and exponentials take radians: use `np.radians` first."


def _unit_slips(node: Expression) -> Iterator[Slip]:
    [x] = node.arguments
    yield Slip("not a unit vector", f"use ${x.latex}$ as it is, without dividing it by its length", x)
    if np.count_nonzero(x.value) > 1:  # otherwise its square may be its length
        yield Slip("not a unit vector", f"divide ${x.latex}$ by the square of its length", x / (x.value @ x.value))


def _stack_slips(node: Expression) -> Iterator[Slip]:
    what = "entries" if np.ndim(node.value) == 1 else "rows"
    for i in range(len(node.arguments) - 1):
        rows = list(node.arguments)
        if not np.array_equal(rows[i].value, rows[i + 1].value):
            rows[i : i + 2] = rows[i + 1], rows[i]
            yield Slip(f"{what} swapped", f"swap {what} {i + 1} and {i + 2}", stack(*rows))


def _listed(*entries: str) -> str:
    return f"({', '.join(entries)})"


# fmt: off
SIGN = "take ${}$ with the opposite sign"

ANGLE: Operation = Operation("angle", lambda: None, str, table(
    ("sign of an angle", f"{SIGN} |take each angle with the opposite sign", lambda q: negative(q)),
    ("halved", "take half of ${}$ |take half of each angle", lambda q: q / 2),
    ("doubled", "take twice ${}$ |take twice each angle", lambda q: 2 * q),
))
"""The kind of a given angle."""

LENGTH: Operation = Operation("length", lambda: None, str, table(("sign of a length", SIGN, lambda x: negative(x))))
"""The kind of a given length."""

SLIDE: Operation = Operation("slide", lambda: None, str, table(
    ("sign of a length", SIGN, lambda x: negative(x)),
    ("length in radians",
     "convert ${}$ from degrees to radians, although it is a length |convert the lengths from degrees to radians as well",
     lambda x: radians(x)),
))
"""The kind of a length that is given beside angles in degrees, as the value of a prismatic joint is."""

VECTOR: Operation = Operation("vector", lambda: None, str, table((
    "sign of a vector", f"{SIGN} |take each direction with the opposite sign", lambda x: negative(x))))
"""The kind of a given vector."""

radians: Operation = Operation("radians", np.radians, "{0}".format, table(
    ("degrees", "use the degrees of ${0}$ as radians |use degrees as radians", lambda q: q, DEGREES_ADVICE),
    ("converted twice", "convert ${0}$ to radians twice |convert to radians twice", lambda q: radians(radians(q)), "", ALL_AT_ONCE),
))
"""An angle in degrees as radians."""

sin: Operation = Operation("sine", np.sin, "\\sin {0}".format, table(
    ("sine and cosine swapped", "use the cosine of ${0}$, where its sine belongs |swap sine and cosine", lambda q: cos(q)),
))
cos: Operation = Operation("cosine", np.cos, "\\cos {0}".format, table(
    ("sine and cosine swapped", "use the sine of ${0}$, where its cosine belongs |swap sine and cosine", lambda q: sin(q)),
))
arctan2: Operation = Operation("arctan2", np.arctan2, "\\operatorname{{atan2}}({0}, {1})".format, table(
    ("arguments of arctan2", "swap the two arguments of `np.arctan2`", lambda y, x: arctan2(x, y)),
    ("arctan for arctan2", "take `np.arctan` of the quotient, which does not know the quadrant", lambda y, x: _arctan(y, x)),
))
_arctan: Operation = Operation("arctan", lambda y, x: np.arctan(y / x), "\\arctan({0} / {1})".format)
sqrt: Operation = Operation("root", np.sqrt, "\\sqrt{{{0}}}".format, table(("root left out", "leave out the square root", lambda x: x)))
square: Operation = Operation("square", np.square, power("2"), table(("square left out", "leave out the square of ${0}$", lambda x: x)))
unit: Operation = Operation("unit vector", lambda x: x / np.linalg.norm(x), "{0} / |{0}|".format, _unit_slips)
cross: Operation = Operation("cross product", np.cross, "{0} \\times {1}".format, table(
    ("order", "write ${1} \\times {0}$ instead of ${0} \\times {1}$", lambda a, b: cross(b, a)),
))
inverse: Operation = Operation("inverse", np.linalg.inv, power("{-1}"), table(
    ("inverse left out", "use ${0}$, where its inverse belongs |leave out every inverse", lambda A: A),
    ("transpose for inverse", "transpose ${0}$ instead of inverting it |transpose instead of inverting", lambda A: transpose(A)),
), involution=True)
concatenate: Operation = Operation("concatenate", lambda *both: np.concatenate([*map(np.atleast_1d, both)]), _listed, table(
    ("halves swapped", "put ${1}$ before ${0}$ |swap the halves", lambda first, second: concatenate(second, first)),
))
"""Two vectors or numbers as one vector."""
stack: Operation = Operation("stack", lambda *rows: np.stack(rows), _listed, _stack_slips)
"""Rows put on top of each other, or numbers as a vector."""
# fmt: on
