"""How fast a closed chain is traced, beside a plain loop over scipy.optimize.root on the same equations.

    python -m benchmarks.loops

Both find the same 361 postures of one turn. kinlib follows the curve by its length and knows the Jacobian; the loop turns
the driver step by step and starts each search at the posture before, which is what one writes first. It is given six
equations in the three or so unknowns that are left, so its method is "lm". Medians of a few runs, all in one process.
"""

import time

import numpy as np
from scipy.optimize import root

from kinlib import linkages

POINTS = 361


def plain_loop(linkage, postures, driver):
    """Find the postures once more, one after the other, with the driver's values given."""
    free = [i for i in range(linkage.n) if i != driver]
    q = postures[0].copy()
    found = [q.copy()]
    for value in postures[1:, driver]:
        q[driver] = value

        def equations(x, q=q):
            whole = q.copy()
            whole[free] = x
            return linkage.residual(whole)

        q[free] = root(equations, q[free], method="lm", options={"xtol": 1e-14, "ftol": 1e-14}).x
        found.append(q.copy())
    return np.array(found)


def seconds(work, runs):
    """The median time of a few runs, and what the last one gave."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return np.median(times), result


def main():
    """Trace the four-bar and Bennett's linkage both ways, and print times and residuals."""
    print(f"{POINTS} postures of one turn       kinlib      residual     scipy root   residual     ratio   apart by")
    bennett = linkages.bennett()
    crank_rocker = linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    starts = {
        "four-bar, crank-rocker": (crank_rocker, crank_rocker.assembly_modes(hold={"A": 1.0})[0]),
        "Bennett's linkage": (bennett, bennett.assemble([1, 2, 1, 2]).q),
    }
    for name, (linkage, start) in starts.items():
        ours, curve = seconds(lambda linkage=linkage, start=start: linkage.trace(start, points=POINTS), 5)
        theirs, postures = seconds(lambda linkage=linkage, q=curve.q: plain_loop(linkage, q, driver=0), 3)
        residuals = [np.linalg.norm(linkage.residual(q), axis=1).max() for q in (curve.q, postures)]
        print(
            f"{name:26} {1e3 * ours:8.0f} ms    {residuals[0]:9.1e} {1e3 * theirs:11.0f} ms    {residuals[1]:9.1e} "
            f"{theirs / ours:9.1f}  {np.abs(curve.q - postures).max():9.1e}"
        )


if __name__ == "__main__":
    main()
