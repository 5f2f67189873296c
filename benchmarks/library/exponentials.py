"""How fast and how right: exp and log of 100,000 twists at once, here and by pytransform3d, which has them for batches too.

    python -m benchmarks exponentials

The twists turn by 0 to pi in all directions. Then the same functions are given turns near 0 and near pi, where formulas
lose their digits, and are held against 40-digit mpmath. The error of exp is the largest entry of exp(x) - X. log is given X
rounded to doubles, and errs by the motion that it names, the largest entry of exp(log(X)) - X: so a log that names the axis
from its other end at pi, as it may, is charged nothing. The worse one of both is told. Angle by angle, and for more
libraries: `python -m benchmarks.library.accuracy`.
"""

from collections.abc import Callable, Iterator
from functools import partial

import mpmath_oracle
import numpy as np

import kinlib as kl
from benchmarks.measure import Row, Way, compared

NEAR = {
    "near 0": [0.0, *(10.0**-k for k in range(1, 13))],
    "near pi": [np.pi, *(np.pi - 10.0**-k for k in range(1, 16))],
}
"""Angles, in radians."""

FASTER, MORE_ACCURATE = 2.0, 10.0
"""So many times better than the peer is wanted."""

PEER = "pytransform3d, its batches"
Function = Callable[[np.ndarray], np.ndarray]


def rows(quick: bool = False) -> Iterator[Row]:
    """Speed, then accuracy."""
    rng = np.random.default_rng(0)
    count = 100 if quick else 100_000
    x = twists(rng, rng.uniform(0, np.pi, count))
    for name, function, argument in [("exp", kl.exp, x), ("log", kl.log, kl.exp(x))]:
        make = partial(peer, name, argument, function)
        ours = Way(partial(function, argument), count)
        yield from compared(f"{name} of 100,000 at once, each", ours, {PEER: (make, FASTER)})

    for where, angles in NEAR.items():
        x = np.concatenate([twists(rng, np.full(2 if quick else 30, angle)) for angle in angles])
        T = np.array([mpmath_oracle.exp(row) for row in x])
        ours = max(worst(kl.exp, "exp", x, T), worst(kl.log, "log", x, T))
        try:
            theirs = max(worst(theirs_for("exp"), "exp", x, T), worst(theirs_for("log"), "log", x, T))
        except ModuleNotFoundError:
            theirs = None
        yield Row(f"worst error of exp and log {where}", "", ours, MORE_ACCURATE, PEER, theirs)


def twists(rng: np.random.Generator, angles: np.ndarray) -> np.ndarray:
    """A twist in a random direction for each angle, with |v| = 1."""
    units = rng.normal(size=(2, len(angles), 3))
    units /= np.linalg.norm(units, axis=-1, keepdims=True)
    return np.concatenate([angles[:, None] * units[0], units[1]], axis=1)


def theirs_for(name: str) -> Function:
    """Their exp or log, for twists (omega, v) like ours."""
    from pytransform3d import trajectories

    exp, log = (
        trajectories.transforms_from_exponential_coordinates,
        trajectories.exponential_coordinates_from_transforms,
    )
    return {"exp": exp, "log": log}[name]


def peer(name: str, argument: np.ndarray, ours: Function) -> Way:
    """Their function on the same argument, once it agrees with ours to 1e-6: how well they agree is not the question here."""
    theirs = theirs_for(name)
    np.testing.assert_allclose(theirs(argument[:1000]), ours(argument[:1000]), rtol=0, atol=1e-6)
    return Way(partial(theirs, argument), len(argument))


def worst(function: Function, name: str, x: np.ndarray, T: np.ndarray) -> float:
    """The largest error of exp on twists x, or of log on poses T = exp(x); infinite where the function fails."""
    with np.errstate(all="ignore"):
        values = function(x) if name == "exp" else np.array([mpmath_oracle.exp(row) for row in function(T)])
    return float(np.nan_to_num(np.abs(values - T), nan=np.inf).max())
