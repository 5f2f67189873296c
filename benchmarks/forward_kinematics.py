"""How fast: 100,000 poses of a PUMA 560 and of the youBot, in one call here and in two loops over Pinocchio.

    python -m benchmarks.forward_kinematics

All write every pose into one (N, 4, 4) array, and agree to 1e-13. "pinocchio" is the loop of its examples, which reads
data.oMi[n]; "its fastest" reads what updateFramePlacement returns, and spares a look-up. Medians of nine runs, in turns.
"""

import sys
import time
from functools import partial
from pathlib import Path
from statistics import median

import numpy as np

from kinlib import robots

sys.path.append(str(Path(__file__).parents[1] / "tests"))
import peers

N = 100_000


def seconds(work):
    """Time one run."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def main():
    """Print the table, one line a robot."""
    print(f"{'poses a second':<16}{'kinlib':>12}{'pinocchio':>12}{'ratio':>8}{'its fastest':>14}{'ratio':>8}")
    for robot in (robots.puma560(), robots.youbot()):
        q = np.random.default_rng(0).uniform(-np.pi, np.pi, (N, robot.n))
        model = peers.pinocchio_model(robot)
        loops = [partial(loop, model) for loop in (peers.pinocchio_loop_by_joint, peers.pinocchio_loop)]
        for loop in loops:
            np.testing.assert_allclose(robot.fk(q[:1000]), loop(q[:1000]), rtol=0, atol=1e-13)
        runs = [[seconds(partial(work, q)) for work in (robot.fk, *loops)] for _ in range(9)]
        ours, usual, fastest = (median(times) for times in zip(*runs, strict=True))
        print(
            f"{robot.name:<16}{N / ours:>12,.0f}{N / usual:>12,.0f}{usual / ours:>8.1f}"
            f"{N / fastest:>14,.0f}{fastest / ours:>8.1f}"
        )


if __name__ == "__main__":
    main()
