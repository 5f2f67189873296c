"""How fast a closed chain is traced, beside a plain loop over scipy.optimize.root on the same equations.

    python -m benchmarks loops          the times
    python -m benchmarks.library.loops          with residuals, and how far the two are apart

Both find the same 361 configurations of one turn. kinlib follows the curve by its length and knows the Jacobian; the loop turns
the driver step by step and starts each search at the configuration before, which is what one writes first. It is given six
equations in the three or so unknowns that are left, so its method is "lm". Both end at the same configurations.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np
from scipy.optimize import root

from benchmarks.measure import Row, Way, compared
from kinlib import linkages
from kinlib.mechanisms.mechanism import Mechanism

POINTS = 361

WANTED = 5.0
"""So many times faster than the loop."""


def rows(quick: bool = False) -> Iterator[Row]:
    """A row for each linkage."""
    count, rounds = (19, 1) if quick else (POINTS, 5)
    for name, (linkage, start) in starts().items():
        peers = {"scipy.optimize.root, a loop": (partial(peer, linkage, linkage.trace(start, points=count).q), WANTED)}
        ours = Way(partial(linkage.trace, start, points=count))
        yield from compared(f"{name}, {POINTS} configurations of one turn", ours, peers, rounds)


def peer(linkage: Mechanism, configurations: np.ndarray) -> Way:
    """The loop, once it has found the same configurations."""
    loop = partial(plain_loop, linkage, configurations, driver=0)
    np.testing.assert_allclose(loop(), configurations, rtol=0, atol=1e-6)
    return Way(loop)


def starts() -> dict[str, tuple[Mechanism, np.ndarray]]:
    """The linkages, each with a configuration in which it closes."""
    bennett = linkages.bennett()
    crank_rocker = linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    return {
        "four-bar": (crank_rocker, crank_rocker.assembly_modes(hold={"A": 1.0})[0]),
        "Bennett's linkage": (bennett, bennett.assemble([1, 2, 1, 2]).q),
    }


def plain_loop(linkage, configurations, driver):
    """Find the configurations once more, one after the other, with the driver's values given."""
    free = [i for i in range(linkage.n) if i != driver]
    q = configurations[0].copy()
    found = [q.copy()]
    for value in configurations[1:, driver]:
        q[driver] = value

        def equations(x, q=q):
            whole = q.copy()
            whole[free] = x
            return linkage.residual(whole)

        q[free] = root(equations, q[free], method="lm", options={"xtol": 1e-14, "ftol": 1e-14}).x
        found.append(q.copy())
    return np.array(found)


def main() -> None:
    """Trace both ways, and print residuals and how far they are apart."""
    print(f"{POINTS} configurations of one turn       residual    of the loop   apart by")
    for name, (linkage, start) in starts().items():
        ours = linkage.trace(start, points=POINTS).q
        theirs = plain_loop(linkage, ours, driver=0)
        residuals = [np.linalg.norm(linkage.residual(q), axis=1).max() for q in (ours, theirs)]
        print(f"{name:26} {residuals[0]:12.1e} {residuals[1]:14.1e} {np.abs(ours - theirs).max():10.1e}")


if __name__ == "__main__":
    main()
