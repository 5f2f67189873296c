"""How often kl.equivalent is right: a yes for every legal re-choice, a no for every change that matters.

    python -m benchmarks.library.equivalence
    python -m benchmarks.library.equivalence 500        fewer arms

Arms are those of benchmarks/library/frames.py. Re-chosen, they keep their motions and change all else: directions of x and z,
origins on parallel axes, zeros, signs, places of slides, base, tool. Then one entry of their table is changed, by 1e-6 to
0.1. Many such changes change nothing (d between parallel axes, a beside a slide): a yes there comes with a map, and its
difference is printed. A no is sure where neighbouring axes stand to each other at another angle, which is counted too.
"""

import sys
import time

import numpy as np
from example_arms import arm, with_other_choices

import kinlib as kl


def main(count=5_000):
    """Print how often a yes and a no are right, over `count` arms each."""
    rng = np.random.default_rng(0)
    missed, seconds = 0, []
    for _ in range(count):
        chain, _cases = arm(rng, int(rng.integers(2, 10)))
        other = with_other_choices(rng, chain)
        start = time.perf_counter()
        missed += not kl.equivalent(chain, other)
        seconds.append(time.perf_counter() - start)
    milliseconds = 1e3 * np.median(seconds), 1e3 * max(seconds)
    print(
        f"{count} arms re-chosen: {missed} missed; {milliseconds[0]:.1f} ms in the median, {milliseconds[1]:.0f} at most"
    )

    yes, twisted, wrong, worst, nearest = 0, 0, 0, 0.0, np.inf
    for _ in range(count):
        chain, _cases = arm(rng, int(rng.integers(2, 10)))
        table = kl.assign_frames(chain, convention="standard").table
        rows = table.rows.copy()
        row, column = rng.integers(table.n), rng.integers(4)
        rows[row, column] += 10 ** rng.uniform(-6, -1)
        found = kl.equivalent(chain, table.changed(rows=rows))
        if found:
            yes, worst = yes + 1, max(worst, found.difference)
        else:
            nearest = min(nearest, found.difference)
        if column == 1 and row < table.n - 1:
            twisted, wrong = twisted + 1, wrong + bool(found)
    print(
        f"{count} entries changed by 1e-6 to 0.1: {yes} change nothing, shown by maps that are off by {worst:.1e} at most;"
    )
    print(f"    {count - yes} change the arm, and no map comes nearer than {nearest:.1e}")
    print(f"    of {twisted} changed twists between two axes, {wrong} were called the same mechanism")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
