"""Close a linkage: from a guess, in all its assembly modes, and along its motion.

Some joint values may be held, for example the angle of a driver; the equations are then solved for the other values. The
results are configurations with all joint values, also those that are held.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.mechanisms.continuation import Curve, CurveTracer
from kinlib.mechanisms.levenberg_marquardt import Equations, null_space, solve
from kinlib.mechanisms.mobility import finite_mobility

MODE_TOL = 1e-5
"""Two configurations are different assembly modes if an entry of the pose of some body differs by more than this. At a dead
point two modes become one, and there the search finds it only to the square root of the residual, about 1e-6."""


@dataclass(frozen=True, eq=False)
class Closure:
    """The closure equations of a linkage, to be solved for the k joint values that are not held.

    equations            of these values
    start         (k,)   a guess for them, or a configuration that closes
    with_held            the configurations (m, n) that values (m, k) are, with those that are held
    is_angle      (k,)   which values are angles, and so the same again after 2 pi
    search_range  (k,)   the values are sought in [-search_range, search_range]
    tolerance            the linkage is closed if the norm of the residual is at most this
    """

    equations: Equations
    start: Array
    with_held: Callable[[Array], Array]
    is_angle: NDArray[np.bool_]
    search_range: Array
    tolerance: float

    def assemble(self) -> tuple[Array, float]:
        """Come as near to a closed configuration as possible: the configuration (n,), and its residual."""
        found = solve(self.equations, self.start[None], self.tolerance)
        return self.with_held(found.x)[0], float(found.residual[0])

    def search_modes(self, poses: Callable[[Array], Array]) -> Array:
        """Search for all configurations (k, n) that close, from random guesses, until nothing new is found.

        poses  of the bodies in configurations (m, n), first dimension m: equal in two configurations of one mode

        Raises ValueError if the linkage can still move in a configuration that closes.
        """
        # The guesses are random but the result must not be: every call draws the same ones.
        rng = np.random.default_rng(0)
        modes, known, hits, idle_rounds = list[Array](), list[Array](), list[int](), 0
        lower = -np.pi - 1e-6  # so pi is -pi even with a rounding error
        # If every mode has been found at least twice, it is likely that none is missing (Good, 1953).
        while idle_rounds < (10 if 1 in hits else 1):
            idle_rounds += 1
            guesses = rng.uniform(-self.search_range, self.search_range, (192, len(self.start)))
            found = solve(self.equations, guesses, self.tolerance, iterations=40)
            # Near a solution a step squares the error, so one more step leaves only rounding errors.
            exact = solve(self.equations, found.x[found.residual <= self.tolerance], tolerance=0.0, iterations=1)
            x = np.where(self.is_angle, (exact.x - lower) % (2 * np.pi) + lower, exact.x)
            candidates = self.with_held(x)
            for q, pose, free, J in zip(candidates, poses(candidates), x, exact.jacobian, strict=True):
                k = next((k for k, other in enumerate(known) if np.abs(pose - other).max() <= MODE_TOL), len(known))
                if k < len(known):
                    hits[k] += 1
                    continue
                if mobility := finite_mobility(self.equations, free, null_space(J)[0], self.tolerance):
                    raise ValueError(f"No degree of freedom may be left; got {mobility}. Hold more joint values.")
                modes, known, hits, idle_rounds = [*modes, q], [*known, pose], [*hits, 1], 0
        return np.array(sorted([*mode] for mode in modes)).reshape(-1, candidates.shape[1])

    def trace(self, step: float, points: int | None) -> Curve:
        """Follow the motion from the start in both directions; points: at equal steps, if a number is given."""
        curve = CurveTracer(self.equations, self.tolerance, self.is_angle).follow(self.start, step, 5000, points)
        return replace(curve, q=self.with_held(curve.q))
