"""Count the right tables that `kl.equivalent` and `kl.diagnose` accuse: there must be none.

    PYTHONPATH=tests/support python evidence/checks/right_tables.py --arms 0 2000

Each arm has 2 to 7 joints, some or all of whose neighbouring axes are nearly parallel, at an angle from 1e-14 to 1e-2 rad. Its
tables in both conventions are right by construction; they are judged as they are, and with 0 to 12 decimals. A table may be
called right, rounded or undecided; "wrong" and "different" are accusations, which are printed. Ends with 1 if there is any.
"""

import argparse
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator

import numpy as np
from example_arms import arm

import kinlib as kl

DECIMALS = 13
"""How many numbers of decimals there are: 0 to 12."""


def drawn_arm(rng: np.random.Generator, angle: float) -> kl.Chain:
    """Draw an arm whose neighbouring axes are nearly parallel: all of them, or some among the other cases."""
    cases = {"cases": ()} if rng.random() < 0.5 else {}
    return arm(rng, int(rng.integers(2, 8)), angle=angle, slides=rng.choice([0, 0.25]), **cases)[0]


def judged(number: int) -> Iterator[tuple[str, int | None, str]]:
    """Judge the tables of one arm: yield the convention, the decimals (None for all) and the verdict, for each of them."""
    rng = np.random.default_rng([35, number])
    chain = drawn_arm(rng, 10 ** rng.uniform(-14, -2))
    for k, convention in enumerate(("standard", "modified")):
        table = kl.assign_frames(chain, convention=convention).table
        yield convention, None, kl.equivalent(table, chain).verdict
        yield convention, None, kl.diagnose(table, chain).verdict
        # Arm by arm, every number of decimals has its turn.
        decimals = (2 * number + 7 * k) % DECIMALS
        yield convention, decimals, kl.diagnose(table.changed(rows=table.rows.round(decimals)), chain).verdict


def main() -> int:
    """Judge the arms of the command line and print the verdicts by the number of decimals."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--arms", nargs=2, type=int, default=(0, 2000), metavar=("FIRST", "END"))
    parser.add_argument("--list", action="store_true", help="print every verdict")
    given = parser.parse_args()
    tally, accused, start = defaultdict(Counter), 0, time.process_time()
    for number in range(*given.arms):
        for convention, decimals, verdict in judged(number):
            tally[decimals][verdict] += 1
            is_accused = verdict in {"wrong", "different"}
            accused += is_accused
            if given.list or is_accused:
                print(f"arm {number}, {convention}, {decimals} decimals: {verdict}", flush=True)
    for decimals, counts in sorted(tally.items(), key=lambda item: (item[0] is None, item[0])):
        print(f"{'all' if decimals is None else decimals:>4} decimals: {dict(counts)}")
    print(f"{accused} right tables accused; {time.process_time() - start:.0f} s of processor time")
    return bool(accused)


if __name__ == "__main__":
    sys.exit(main())
