"""Speed and accuracy of exp and log, compared with pytransform3d, which also computes batches, and with modern_robotics.

    python -m benchmarks exponentials

The twists have angles from 0 to pi and random directions, and are computed 100,000 at once. Then each of 1,000 is given to one
call of exp, log, adjoint or inverse; modern_robotics does not validate its argument. Then exp and log get angles near 0 and
near pi, where formulas lose digits, and are compared with mpmath at 40 digits. The error of exp is the largest entry of exp(x) - X.
log is given X rounded to double precision; its error is the largest entry of exp(log(X)) - X, so a log that returns the
opposite axis at pi, as it may, has no error from that. The larger of the two errors is reported. For each angle, and for
more libraries: `python -m benchmarks.library.accuracy`.
"""

from collections.abc import Callable, Iterator
from functools import partial

import mpmath_oracle
import numpy as np

import kinlib as kl
from benchmarks.measure import Curve, Row, Workload, compare, installed, measure_batches

ANGLES_RAD = {
    "near 0": [0.0, *(10.0**-k for k in range(1, 13))],
    "near pi": [np.pi, *(np.pi - 10.0**-k for k in range(1, 16))],
}
MIN_SPEEDUP, MIN_ERROR_RATIO = 2.0, 10.0
"""Targets: how many times faster, and more accurate, than the peer kinlib must be."""

PEER = "pytransform3d, batches"
Function = Callable[[np.ndarray], np.ndarray]


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of speed, then those of accuracy."""
    rng = np.random.default_rng(0)
    count = 100 if quick else 100_000
    x = twists(rng, rng.uniform(0, np.pi, count))
    for name, function, argument, kind in [("exp", kl.exp, x, "twists"), ("log", kl.log, kl.exp(x), "poses")]:
        prepare = partial(peer, name, argument, function)
        ours = Workload(partial(function, argument), count)
        yield from compare(f"{name} of 100,000 {kind} at once, each", ours, {PEER: (prepare, MIN_SPEEDUP)})

    x = x[:1_000]
    T = kl.exp(x)
    for name, argument in {"exp": x, "log": T, "adjoint": T, "inverse": T}.items():
        function = getattr(kl, name)
        ours = Workload(lambda function=function, argument=argument: [function(one) for one in argument], len(x))
        yield from compare(f"one {name}", ours, {"modern_robotics": (partial(modern_robotics, name, argument), 1.0)})

    for where, angles in ANGLES_RAD.items():
        x = np.concatenate([twists(rng, np.full(2 if quick else 30, angle)) for angle in angles])
        T = np.array([mpmath_oracle.exp(row) for row in x])
        ours = max(max_error(kl.exp, "exp", x, T), max_error(kl.log, "log", x, T))
        try:
            theirs = max(max_error(peer_function("exp"), "exp", x, T), max_error(peer_function("log"), "log", x, T))
        except ModuleNotFoundError:
            theirs = None
        yield Row(f"worst error of exp and log {where}", "", ours, MIN_ERROR_RATIO, PEER, theirs)


def curves(quick: bool = False) -> Iterator[Curve]:
    """Measure how the time of a batch grows with its size, beside a peer that computes batches and two that do not."""
    rng = np.random.default_rng(0)
    x = twists(rng, rng.uniform(0, np.pi, 1_000 if quick else 1_000_000))
    for name, function, argument, kind in [("exp", kl.exp, x, "twists"), ("log", kl.log, kl.exp(x), "poses")]:
        functions = {"kinlib": function, **installed({PEER: partial(peer_function, name)})}
        loops = {
            "Pinocchio, bare calls": partial(pinocchio, name, argument[:1_000]),
            "modern_robotics, a loop": partial(modern_robotics, name, argument[:1_000]),
        }
        yield measure_batches(f"{name} of {kind}", kind, functions, installed(loops), argument)


def twists(rng: np.random.Generator, angles: np.ndarray) -> np.ndarray:
    """Return a twist in a random direction for each angle, with |v| = 1."""
    units = rng.normal(size=(2, len(angles), 3))
    units /= np.linalg.norm(units, axis=-1, keepdims=True)
    return np.concatenate([angles[:, None] * units[0], units[1]], axis=1)


def peer_function(name: str) -> Function:
    """Return the exp or log of pytransform3d, which takes twists (omega, v) as kinlib does."""
    from pytransform3d import trajectories

    exp, log = (
        trajectories.transforms_from_exponential_coordinates,
        trajectories.exponential_coordinates_from_transforms,
    )
    return {"exp": exp, "log": log}[name]


def peer(name: str, argument: np.ndarray, ours: Function) -> Workload:
    """Prepare the same call of pytransform3d. Both must agree to 1e-6; the accuracy is measured separately."""
    theirs = peer_function(name)
    np.testing.assert_allclose(theirs(argument[:1000]), ours(argument[:1000]), rtol=0, atol=1e-6)
    return Workload(partial(theirs, argument), len(argument))


def modern_robotics(name: str, arguments: np.ndarray) -> Workload:
    """Prepare the same function of modern_robotics, for one argument after the other."""
    import modern_robotics as mr

    names = {"exp": "MatrixExp6", "log": "MatrixLog6", "adjoint": "Adjoint", "inverse": "TransInv"}
    function = getattr(mr, names[name])
    given = [mr.VecTose3(x) for x in arguments] if name == "exp" else list(arguments)
    result = mr.se3ToVec(function(given[0])) if name == "log" else function(given[0])
    np.testing.assert_allclose(result, getattr(kl, name)(arguments[0]), rtol=0, atol=1e-6)
    return Workload(lambda: [function(one) for one in given], len(given))


def pinocchio(name: str, arguments: np.ndarray) -> Workload:
    """Prepare calls of Pinocchio alone, from and to its own objects."""
    import pinocchio as pin

    given = [pin.Motion(x[3:], x[:3]) for x in arguments] if name == "exp" else [pin.SE3(T) for T in arguments]
    function = {"exp": pin.exp6, "log": pin.log6}[name]
    result = function(given[0])
    found = result.homogeneous if name == "exp" else np.concatenate([result.angular, result.linear])
    np.testing.assert_allclose(found, getattr(kl, name)(arguments[0]), rtol=0, atol=1e-9)
    return Workload(lambda: [function(one) for one in given], len(given))


def max_error(function: Function, name: str, x: np.ndarray, T: np.ndarray) -> float:
    """Return the largest error of exp of twists x, or of log of poses T = exp(x); infinity if the function returns NaN."""
    with np.errstate(all="ignore"):
        values = function(x) if name == "exp" else np.array([mpmath_oracle.exp(row) for row in function(T)])
    return float(np.nan_to_num(np.abs(values - T), nan=np.inf).max())
