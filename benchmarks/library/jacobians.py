"""Speed of the space Jacobians of a PUMA 560: 100,000 in one call, compared with a loop over Pinocchio.

    python -m benchmarks jacobians

Both return one array of shape (N, 6, n) of twists (omega, v) in the base frame. Pinocchio stores the same Jacobian in
`data.J` with (v, omega); the two halves are interchanged at the end, for all Jacobians at once. Both agree to 1e-12 before
they are timed.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

import kinlib as kl
from benchmarks.library.forward_kinematics import puma560
from benchmarks.measure import Row, Workload, compare


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the row of the table."""
    robot, q = puma560(100 if quick else 100_000)
    peers = {"Pinocchio, a loop": (partial(pinocchio, robot, q), 3.0)}
    ours = Workload(lambda: robot.jacobian(q), len(q))
    yield from compare("100,000 PUMA 560 space Jacobians at once, each", ours, peers, rounds=1 if quick else 7)


def pinocchio(robot: kl.Chain, q: np.ndarray) -> Workload:
    """Prepare a loop that computes Jacobians of shape (N, 6, n), one after the other."""
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
    return Workload(run, len(q))
