"""How fast: poses of a PUMA 560, many at once and one by one, here and by three libraries that others use.

    python -m benchmarks forward_kinematics

Many at once: 100,000 configurations in, one (N, 4, 4) array out. Pinocchio takes one at a time, so it is given the
fastest loop that we know, and the loop of its examples, which reads `data.oMi[n]`. The Robotics Toolbox is compiled, and has
been told to merge its constants (`ETS.compile`). modern_robotics takes one at a time too, so slowly that it gets a few only.
One by one: the same configurations in a loop of Python, for us as for the peer. All agree to 1e-12 before any is timed.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

import kinlib as kl
from benchmarks.measure import Curve, Row, Way, compared, grown

JOINTS = (1, 2, 4, 8, 16, 32, 64)


def rows(quick: bool = False) -> Iterator[Row]:
    """The rows of the table, batches first."""
    robot, q = puma560(100 if quick else 100_000)
    peers = {
        "Pinocchio, its fastest loop": (partial(pinocchio, robot, q, "pinocchio_loop"), 4.0),
        "Pinocchio, the loop of its examples": (partial(pinocchio, robot, q, "pinocchio_loop_by_joint"), 4.0),
        "Robotics Toolbox, compiled": (partial(toolbox, robot, q), 2.5),
        "modern_robotics, a loop": (partial(modern_robotics, robot, q[:1000]), 1000.0),
    }
    many = "100,000 PUMA 560 poses at once, each"
    yield from compared(many, Way(lambda: robot.fk(q), len(q)), peers, rounds=1 if quick else 7)

    q = q[:10_000]
    single = {"Robotics Toolbox, compiled": (partial(toolbox, robot, q, is_batch=False), 15 / 12)}
    yield from compared("one PUMA 560 pose", Way(lambda: [robot.fk(row) for row in q], len(q)), single)


def curves(quick: bool = False) -> Iterator[Curve]:
    """How the time of a batch grows with the arm, and with the batch."""
    rng = np.random.default_rng(0)
    most = 1_000 if quick else 10_000

    def arm(n: float) -> Way:
        axes, q = rng.normal(size=(int(n), 3)), rng.uniform(-np.pi, np.pi, (most, int(n)))
        screws = kl.screw(axes / np.linalg.norm(axes, axis=1, keepdims=True), rng.normal(size=(int(n), 3)))
        chain = kl.Chain(screws, np.eye(4))
        return Way(lambda: chain.fk(q))

    def batch(size: float) -> Way:
        robot, q = puma560(int(size))
        return Way(lambda: robot.fk(q))

    sizes = [10**k for k in range(4 if quick else 7)]
    yield grown(f"{most:,} poses at once", "joints", JOINTS, arm)
    yield grown("PUMA 560 poses at once", "configurations", sizes, batch)


def puma560(count: int) -> tuple[kl.Chain, np.ndarray]:
    """The robot, and as many configurations."""
    robot = kl.robots.puma560()
    return robot, np.random.default_rng(0).uniform(-np.pi, np.pi, (count, robot.n))


def pinocchio(robot: kl.Chain, q: np.ndarray, loop: str) -> Way:
    """One of the loops of tests/support/pinocchio_oracle.py."""
    import pinocchio_oracle

    run = partial(getattr(pinocchio_oracle, loop), pinocchio_oracle.pinocchio_model(robot), q)
    np.testing.assert_allclose(run()[:1000], robot.fk(q[:1000]), rtol=0, atol=1e-12)
    return Way(run, len(q))


def toolbox(robot: kl.Chain, q: np.ndarray, is_batch: bool = True) -> Way:
    """The Robotics Toolbox on the standard table of the same arm, its neighbouring constants multiplied out."""
    from roboticstoolbox import ET, ETS
    from spatialmath import SE3

    table = kl.assign_frames(robot, convention="standard").table
    steps = [[ET.Rz(theta), ET.Rz(), ET.tz(d), ET.tx(a), ET.Rx(alpha)] for a, alpha, d, theta in table.rows]
    ends = [ET.SE3(SE3(T, check=False)) for T in (table.base, table.tool)]
    ets = ETS([ends[0], *(step for row in steps for step in row), ends[1]]).compile()
    np.testing.assert_allclose(ets.eval(q[:1000]), robot.fk(q[:1000]), rtol=0, atol=1e-12)
    return Way((lambda: ets.eval(q)) if is_batch else (lambda: [ets.eval(row) for row in q]), len(q))


def modern_robotics(robot: kl.Chain, q: np.ndarray) -> Way:
    """The code of the book."""
    import modern_robotics as mr

    columns = robot.screws.T
    np.testing.assert_allclose(mr.FKinSpace(robot.home, columns, q[0]), robot.fk(q[0]), rtol=0, atol=1e-12)
    return Way(lambda: np.array([mr.FKinSpace(robot.home, columns, row) for row in q]), len(q))
