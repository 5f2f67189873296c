"""Speed of forward kinematics of a PUMA 560, in batches and one pose at a time, compared with three other libraries.

    python -m benchmarks forward_kinematics

Batches: 100,000 configurations in, one array of shape (N, 4, 4) out. Pinocchio takes one configuration per call, so it is
measured in the fastest loop that we know and in the loop of its examples, which reads `data.oMi[n]`. Its bare calls leave
each pose in an object of Pinocchio. The Robotics Toolbox is compiled, and its neighbouring constants are merged
(`ETS.compile`). modern_robotics takes one configuration per call too, and is so slow that it gets only 1,000. One at a time:
the same configurations in a Python loop, for kinlib and for the peer.
All results agree to 1e-12 before anything is timed.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

import kinlib as kl
from benchmarks.measure import Curve, Row, Workload, compare, installed, measure_batches, measure_growth

BATCH_JOINTS = (6, 7, 30)
"""The arms whose batches are measured for each size: two common numbers of joints, and that of a humanoid."""

JOINTS = (1, 2, 4, 8, 16, 32, 64)


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of the table, batches first."""
    robot, q = puma560(100 if quick else 100_000)
    peers = {
        "Pinocchio, fastest loop": (partial(pinocchio, robot, q, "pinocchio_loop"), 4.0),
        "Pinocchio, the loop of its examples": (partial(pinocchio, robot, q, "pinocchio_loop_by_joint"), 4.0),
        "Robotics Toolbox, compiled": (partial(toolbox, robot, q), 2.5),
        "modern_robotics, a loop": (partial(modern_robotics, robot, q[:1000]), 1000.0),
    }
    batch = "100,000 PUMA 560 poses at once, each"
    yield from compare(batch, Workload(lambda: robot.fk(q), len(q)), peers, rounds=1 if quick else 7)

    q = q[:10_000]
    single = {"Robotics Toolbox, compiled": (partial(toolbox, robot, q, is_batch=False), 15 / 12)}
    yield from compare("one PUMA 560 pose", Workload(lambda: [robot.fk(row) for row in q], len(q)), single)


def curves(quick: bool = False) -> Iterator[Curve]:
    """Measure how the time of a batch grows with the size of the batch, beside Pinocchio, and with the number of joints."""
    for n in BATCH_JOINTS:
        robot, q = random_arm(n), configurations(n, 1_000 if quick else 1_000_000)
        loop = q[: 100 if quick else 10_000]
        peers = {
            "Pinocchio, bare calls": partial(pinocchio_bare, robot, loop),
            "Pinocchio, a loop that fills an array": partial(pinocchio, robot, loop, "pinocchio_loop"),
        }
        yield measure_batches(
            f"poses of an arm of {n} joints", "configurations", {"kinlib": robot.fk}, installed(peers), q
        )

    count = 1_000 if quick else 10_000

    def arm(n: float) -> Workload:
        chain, q = random_arm(int(n)), configurations(int(n), count)
        return Workload(lambda: chain.fk(q))

    yield measure_growth(f"{count:,} poses at once", "joints", JOINTS, arm)


def random_arm(n: int) -> kl.Chain:
    """Return an arm whose joints rotate about random lines, so that no entry of its constants is 0 or 1."""
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(n, 3))
    return kl.Chain(kl.screw(axes / np.linalg.norm(axes, axis=1, keepdims=True), rng.normal(size=(n, 3))), np.eye(4))


def configurations(n: int, count: int) -> np.ndarray:
    """Return `count` random configurations of n joints."""
    return np.random.default_rng(0).uniform(-np.pi, np.pi, (count, n))


def puma560(count: int) -> tuple[kl.Chain, np.ndarray]:
    """Return the robot and `count` random configurations."""
    robot = kl.robots.puma560()
    return robot, configurations(robot.n, count)


def pinocchio(robot: kl.Chain, q: np.ndarray, loop: str) -> Workload:
    """Prepare one of the loops of tests/support/pinocchio_oracle.py."""
    import pinocchio_oracle

    run = partial(getattr(pinocchio_oracle, loop), pinocchio_oracle.pinocchio_model(robot), q)
    np.testing.assert_allclose(run()[:1000], robot.fk(q[:1000]), rtol=0, atol=1e-12)
    return Workload(run, len(q))


def pinocchio_bare(robot: kl.Chain, q: np.ndarray) -> Workload:
    """Prepare calls of Pinocchio alone, which leave each pose in its own object."""
    import pinocchio as pin
    import pinocchio_oracle

    model = pinocchio_oracle.pinocchio_model(robot)
    data, tool = model.createData(), model.getFrameId("tool")

    def run() -> None:
        for row in q:
            pin.forwardKinematics(model, data, row)
            pin.updateFramePlacement(model, data, tool)

    run()
    np.testing.assert_allclose(data.oMf[tool].homogeneous, robot.fk(q[-1]), rtol=0, atol=1e-12)
    return Workload(run, len(q))


def toolbox(robot: kl.Chain, q: np.ndarray, is_batch: bool = True) -> Workload:
    """Prepare the Robotics Toolbox on the standard DH table of the same arm, with neighbouring constants multiplied."""
    from roboticstoolbox import ET, ETS
    from spatialmath import SE3

    table = kl.assign_frames(robot, convention="standard").table
    steps = [[ET.Rz(theta), ET.Rz(), ET.tz(d), ET.tx(a), ET.Rx(alpha)] for a, alpha, d, theta in table.rows]
    ends = [ET.SE3(SE3(T, check=False)) for T in (table.base, table.tool)]
    ets = ETS([ends[0], *(step for row in steps for step in row), ends[1]]).compile()
    np.testing.assert_allclose(ets.eval(q[:1000]), robot.fk(q[:1000]), rtol=0, atol=1e-12)
    return Workload((lambda: ets.eval(q)) if is_batch else (lambda: [ets.eval(row) for row in q]), len(q))


def modern_robotics(robot: kl.Chain, q: np.ndarray) -> Workload:
    """Prepare the code of the book."""
    import modern_robotics as mr

    columns = robot.screws.T
    np.testing.assert_allclose(mr.FKinSpace(robot.home, columns, q[0]), robot.fk(q[0]), rtol=0, atol=1e-12)
    return Workload(lambda: np.array([mr.FKinSpace(robot.home, columns, row) for row in q]), len(q))
