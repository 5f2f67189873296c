"""Speed of tracing a closed chain, compared with a plain loop over scipy.optimize.root on the same equations.

    python -m benchmarks loops          the times
    python -m benchmarks.library.loops          residuals, and the difference between the two

Both compute the same 361 configurations of one revolution. kinlib follows the curve by its arc length and uses the Jacobian.
The loop changes the driving joint step by step and starts each search at the previous configuration, as in a first attempt.
It solves six equations for the remaining unknowns, about three, so its method is "lm". Both reach the same configurations.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np
from scipy.optimize import root

from benchmarks.measure import Row, Workload, compare
from kinlib import linkages
from kinlib.mechanisms.mechanism import Mechanism

POINTS = 361

MIN_SPEEDUP = 5.0
"""Target: how many times faster than the loop kinlib must be."""


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield a row for each linkage."""
    count, rounds = (19, 1) if quick else (POINTS, 5)
    for name, (linkage, start) in linkages_and_starts().items():
        peers = {
            "scipy.optimize.root, a loop": (partial(peer, linkage, linkage.trace(start, points=count).q), MIN_SPEEDUP)
        }
        by_kinlib = Workload(partial(linkage.trace, start, points=count))
        yield from compare(f"{name}, {POINTS} configurations", by_kinlib, peers, rounds)


def peer(linkage: Mechanism, configurations: np.ndarray) -> Workload:
    """Prepare the loop, which must reach the same configurations."""
    loop = partial(plain_loop, linkage, configurations, driver=0)
    np.testing.assert_allclose(loop(), configurations, rtol=0, atol=1e-6)
    return Workload(loop)


def linkages_and_starts() -> dict[str, tuple[Mechanism, np.ndarray]]:
    """Return the linkages, each with a configuration in which it closes."""
    bennett = linkages.bennett()
    crank_rocker = linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    return {
        "four-bar linkage": (crank_rocker, crank_rocker.assembly_modes(hold={"A": 1.0})[0]),
        "Bennett's linkage": (bennett, bennett.assemble([1, 2, 1, 2]).q),
    }


def plain_loop(linkage, configurations, driver):
    """Compute the configurations again, one after the other, for given values of the driving joint."""
    free = [i for i in range(linkage.n) if i != driver]
    q = configurations[0].copy()
    solutions = [q.copy()]
    for value in configurations[1:, driver]:
        q[driver] = value

        def equations(x, q=q):
            full = q.copy()
            full[free] = x
            return linkage.residual(full)

        q[free] = root(equations, q[free], method="lm", options={"xtol": 1e-14, "ftol": 1e-14}).x
        solutions.append(q.copy())
    return np.array(solutions)


def main() -> None:
    """Trace with both, and print the residuals and the largest difference."""
    print(f"{POINTS} configurations            residual    of the loop difference")
    for name, (linkage, start) in linkages_and_starts().items():
        by_kinlib = linkage.trace(start, points=POINTS).q
        by_loop = plain_loop(linkage, by_kinlib, driver=0)
        residuals = [np.linalg.norm(linkage.residual(q), axis=1).max() for q in (by_kinlib, by_loop)]
        print(f"{name:26} {residuals[0]:12.1e} {residuals[1]:14.1e} {np.abs(by_kinlib - by_loop).max():10.1e}")


if __name__ == "__main__":
    main()
