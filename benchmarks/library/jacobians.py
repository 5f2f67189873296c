"""How fast: space Jacobians of a PUMA 560, 100,000 in one call here and in a loop over Pinocchio.

    python -m benchmarks jacobians

Both end as one (N, 6, n) array of twists (omega, v) in the base frame. Pinocchio has the same Jacobian in `data.J`, its
halves the other way round; they are exchanged at the end, for all at once. Both agree to 1e-12 before they are timed.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

import kinlib as kl
from benchmarks.library.forward_kinematics import puma560
from benchmarks.measure import Row, Way, compared


def rows(quick: bool = False) -> Iterator[Row]:
    """The row of the table."""
    robot, q = puma560(100 if quick else 100_000)
    peers = {"Pinocchio, a loop": (partial(pinocchio, robot, q), 3.0)}
    ours = Way(lambda: robot.jacobian(q), len(q))
    yield from compared("100,000 PUMA 560 space Jacobians at once, each", ours, peers, rounds=1 if quick else 7)


def pinocchio(robot: kl.Chain, q: np.ndarray) -> Way:
    """Jacobians (N, 6, n), one after the other."""
    import pinocchio as pin
    import pinocchio_oracle

    model = pinocchio_oracle.pinocchio_model(robot)
    data = model.createData()

    def run() -> np.ndarray:
        J = np.empty((len(q), 6, robot.n))
        for i, row in enumerate(q):
            J[i] = pin.computeJointJacobians(model, data, row)
        return np.roll(J, 3, axis=1)

    np.testing.assert_allclose(run()[:1000], robot.jacobian(q[:1000]), rtol=0, atol=1e-12)
    return Way(run, len(q))
