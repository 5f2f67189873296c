"""Reliability of kl.equivalent: it must recognise every legal choice of frames, and every change of the mechanism.

    python -m benchmarks.library.equivalence
    python -m benchmarks.library.equivalence 500        fewer arms

The arms are those of benchmarks/library/frames.py. With other legal choices they keep their motions, but have other
directions of x and z, origins on parallel axes, zero positions, signs, positions of prismatic axes, base and tool. Then one
entry of a table is changed by 1e-6 to 0.1. Many such changes have no effect (d between parallel axes, a next to a prismatic
joint); then the result is a map, and its residual is printed. A change certainly matters if it changes the angle between two
neighbouring axes; these cases are counted separately.
"""

import sys
import time

import numpy as np
from example_arms import arm, with_other_choices

import kinlib as kl


def main(count=5_000):
    """Print how often both answers are right, over `count` arms each."""
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
        f"{count} arms with other choices: {missed} not recognised; {milliseconds[0]:.1f} ms median, {milliseconds[1]:.0f} ms maximum"
    )

    same, twisted, wrong, largest, smallest = 0, 0, 0, 0.0, np.inf
    for _ in range(count):
        chain, _cases = arm(rng, int(rng.integers(2, 10)))
        table = kl.assign_frames(chain, convention="standard").table
        rows = table.rows.copy()
        row, column = rng.integers(table.n), rng.integers(4)
        rows[row, column] += 10 ** rng.uniform(-6, -1)
        result = kl.equivalent(chain, table.changed(rows=rows))
        if result:
            same, largest = same + 1, max(largest, result.difference)
        else:
            smallest = min(smallest, result.difference)
        if column == 1 and row < table.n - 1:
            twisted, wrong = twisted + 1, wrong + bool(result)
    print(f"{count} entries changed by 1e-6 to 0.1: {same} have no effect: maps with residuals up to {largest:.1e};")
    print(f"    {count - same} change the arm: no map has a residual below {smallest:.1e}")
    print(f"    of {twisted} changed twists between two axes, {wrong} were classified as the same mechanism")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
