"""Slips with a given value, the same in every problem: negated, left out, converted, reversed, inverted, exchanged.

The answer is what the right solution makes of the wrong value, so a slip is written once and not for each problem.
"""

from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import combinations
from types import SimpleNamespace
from typing import Any

import numpy as np

from outside import Kinds
from outside.motions import I3, parts, pose
from outside.shared import DEGREES, LEFT_OUT, ORDER, SIGN, SWAP, TRANSPOSE

WITHOUT_SLIPS = frozenset({"formula", "letter", "line", "order", "pose function"})
"""The kinds of answers that are no numbers."""

ANGLES = frozenset({
    "degrees", "alpha_degrees", "theta_degrees", "headings_degrees", "rpy_1_in_degrees", "alpha", "theta", "tilt", "rpy", "q",
    "values", "rates",
})  # fmt: skip
"""The given values that are angles, or joint values."""

LENGTHS = frozenset({"a", "d", "lead", "longer", "offset", "left", "along", "rate_3"})
"""The given numbers that are no angles, but may be negative or 0."""

NOTHING = f"{LEFT_OUT}|kept|left at|0|at zero|home|unchanged|only"
"""The words for a value that plays no part."""


def slips_of_given(given: Any, kind: str, solve: Callable[[Any], Any]) -> Kinds:
    """Return the answers with one given value wrong, or with two exchanged."""
    made: Kinds = {}
    with np.errstate(all="ignore"):
        for did, changed, words in _slips(_numbers(given)) if kind not in WITHOUT_SLIPS else ():
            # With some values there is no answer.
            with suppress(ArithmeticError, AssertionError, IndexError, ValueError):
                made[did] = solve(SimpleNamespace(**{**vars(given), **changed})), f"{words}|{'|'.join(changed)}"
    return made


def _numbers(given: Any) -> dict[str, Any]:
    """The given values that are numbers or arrays of numbers."""
    found = {}
    for name, value in vars(given).items():
        with suppress(TypeError, ValueError):
            found[name] = np.asarray(value, dtype=float)
    return found


def _slips(values: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any], str]]:
    """Yield what was done, the values that are wrong, and the words for it."""
    for name, x in values.items():
        if x.ndim == 1 or name in ANGLES | LENGTHS:
            yield f"negated {name}", {name: -x}, f"{SIGN}|other way|inver"
        if x.ndim == 1 or name in LENGTHS:
            yield f"left out {name}", {name: 0 * x}, NOTHING
        for did, value, words in _of_pose(x) if x.shape == (4, 4) else _of_angles(x) if name in ANGLES else ():
            yield f"{did} {name}", {name: value}, words
    for (one, x), (other, y) in combinations(values.items(), 2):
        pair = {one, other}
        if x.shape == y.shape and (x.shape == (4, 4) or pair <= ANGLES or pair <= LENGTHS):
            yield f"exchanged {one} and {other}", {one: y, other: x}, SWAP


def _of_angles(x: Any) -> Iterator[tuple[str, Any, str]]:
    yield "took the degrees of", np.degrees(x), DEGREES
    yield "converted once more", np.radians(x), f"{DEGREES}|length"
    for i, unit in enumerate(np.eye(x.size) if x.ndim else ()):
        yield f"negated entry {i + 1} of", x * (1 - 2 * unit), f"{SIGN}|other way|inver"
        yield f"left out entry {i + 1} of", x * (1 - unit), NOTHING
    if x.ndim:
        yield "reversed", x[::-1], f"{ORDER}|revers|yaw"


def _of_pose(T: Any) -> Iterator[tuple[str, Any, str]]:
    R, p = parts(T)
    yield "left out", np.eye(4), f"{NOTHING}|identity|given"
    yield "inverted", np.linalg.inv(T), "inver|direction|other way|back"
    yield "transposed the rotation of", pose(R.T, p), TRANSPOSE
    yield "did not rotate", pose(I3, p), "rotat|turn|identity|moved|R = I"
    yield "did not move", pose(R, 0 * p), "rotat|position|moved|moment|origin|p"
