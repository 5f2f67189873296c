"""Speed of the space Jacobians of a PUMA 560: 100,000 in one call, compared with a loop over Pinocchio.

    python -m benchmarks jacobians

Both return one array of shape (N, 6, n) of twists (omega, v) in the base frame. Pinocchio stores the same Jacobian in
`data.J` with (v, omega); the two halves are interchanged at the end, for all Jacobians at once. Its bare calls leave each
Jacobian in `data.J`. Both agree to 1e-12 before they are timed.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

import kinlib as kl
from benchmarks.library.forward_kinematics import BATCH_JOINTS, configurations, puma560, random_arm
from benchmarks.measure import Curve, Row, Workload, compare, installed, measure_batches

MAX_NUMBERS = 100_000_000
"""A batch whose Jacobians would take more than 800 MB is not measured."""


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the row of the table."""
    robot, q = puma560(100 if quick else 100_000)
    peers = {"Pinocchio, a loop": (partial(pinocchio, robot, q), 3.0)}
    ours = Workload(lambda: robot.jacobian(q), len(q))
    yield from compare("100,000 PUMA 560 space Jacobians at once, each", ours, peers, rounds=1 if quick else 7)


def curves(quick: bool = False) -> Iterator[Curve]:
    """Measure how the time of a batch grows with its size, beside Pinocchio."""
    for n in BATCH_JOINTS:
        count = 1_000 if quick else 1_000_000
        robot, q = random_arm(n), configurations(n, count if 6 * n * count <= MAX_NUMBERS else count // 10)
        loop = q[: 100 if quick else 10_000]
        peers = {
            "Pinocchio, bare calls": partial(pinocchio_bare, robot, loop),
            "Pinocchio, a loop that fills an array": partial(pinocchio, robot, loop),
        }
        name = f"space Jacobians of an arm of {n} joints"
        yield measure_batches(name, "configurations", {"kinlib": robot.jacobian}, installed(peers), q)


def pinocchio_bare(robot: kl.Chain, q: np.ndarray) -> Workload:
    """Prepare calls of Pinocchio alone, which leave each Jacobian in its data."""
    import pinocchio as pin
    import pinocchio_oracle

    model = pinocchio_oracle.pinocchio_model(robot)
    data = model.createData()

    def run() -> None:
        for row in q:
            pin.computeJointJacobians(model, data, row)

    run()
    np.testing.assert_allclose(np.roll(data.J, 3, axis=0), robot.jacobian(q[-1]), rtol=0, atol=1e-12)
    return Workload(run, len(q))


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
