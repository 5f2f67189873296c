"""Length and time of symbolic forward kinematics, compared with multiplying the factors, with simplifying, and with a peer.

    python -m benchmarks symbolic               the PUMA 560 alone: at most 0.1 s and 275 operations
    python -m benchmarks.library.symbolic               each robot of the course, compared with others
    python -m benchmarks.library.symbolic --quick       without simplify

The PUMA 560 has a symbol for each joint and numbers for its lengths. SymPy's cache is cleared before each round, and no
result is simplified. Operations are counted by SymPy's count_ops.

The second table gives milliseconds and operations for each robot of the course. "multiplied": the exponentials of the
joints and the home pose, multiplied one after the other. "simplified": the same, and then sympy.simplify of each entry.
"toolbox": the Robotics Toolbox for Python on the DH table of the same robot, simplified by its own method; its PUMA 560
has floating-point lengths, and it supports no helical joint. Every column starts with an empty cache and is timed once, and
its result agrees with kl.Chain to 1e-9 at one configuration.
"""

import sys
import time
from collections.abc import Iterator
from functools import reduce
from inspect import get_annotations, getmembers, isfunction
from statistics import median

import numpy as np
import sympy as sp
from sympy.core.cache import clear_cache

import kinlib as kl
from benchmarks.measure import ROUNDS, Row, Workload, time_interleaved

MAX_SECONDS, MAX_OPERATIONS = 0.1, 275
"""Targets for the PUMA 560."""


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of the table, which have upper bounds instead of a peer."""
    robot = kl.robots.puma560()

    def compute() -> sp.Matrix:
        clear_cache()
        return kl.symbolic.fk(robot)

    operations = int(sp.count_ops(compute()))
    (times,) = time_interleaved([Workload(compute)], rounds=1 if quick else ROUNDS)
    yield Row("symbolic forward kinematics, PUMA 560", "s", median(times), MAX_SECONDS, at_most=True)
    yield Row(
        "symbolic forward kinematics, PUMA 560, operations", "operations", operations, MAX_OPERATIONS, at_most=True
    )


def multiplied(robot):
    """Multiply the factors of the space form without simplifying."""
    values = zip(robot.screws, kl.symbolic.joints(robot.n), strict=True)
    factors = [kl.symbolic.exp(kl.symbolic.exact(S) * value) for S, value in values]
    return reduce(sp.Matrix.multiply, [*factors, kl.symbolic.exact(robot.home)])


def simplified(robot):
    """Multiply, then simplify each entry."""
    return multiplied(robot).applyfunc(sp.simplify)


def toolbox(robot):
    """Use the Robotics Toolbox on the standard DH table of the same arm, with exact entries."""
    from roboticstoolbox import DHRobot, PrismaticDH, RevoluteDH

    table = kl.assign_frames(robot, convention="standard").table
    links = []
    for numbers, joint_type in zip(table.rows, table.joints, strict=True):
        a, alpha, d, theta = kl.symbolic.exact(numbers)
        if joint_type == "R":
            links.append(RevoluteDH(a=a, alpha=alpha, d=d, offset=theta))
        else:
            links.append(PrismaticDH(a=a, alpha=alpha, theta=theta, offset=d))
    arm = DHRobot(links, symbolic=True)
    T = sp.Matrix(arm.fkine(kl.symbolic.joints(robot.n)).simplify().A)
    return kl.symbolic.exact(table.base) * T * kl.symbolic.exact(table.tool)


def cell(make, robot):
    """Format one entry of the table: milliseconds and operations."""
    clear_cache()
    start = time.perf_counter()
    try:
        T = make(robot)
    except Exception as error:  # a peer may fail in any way; the table shows the kind of error
        return f"{type(error).__name__:>22}"
    milliseconds = 1e3 * (time.perf_counter() - start)
    q = np.linspace(0.3, 1.7, robot.n)
    at_q = T.subs(dict(zip(kl.symbolic.joints(robot.n), q, strict=True))).evalf()
    np.testing.assert_allclose(np.array(at_q, dtype=float), robot.fk(q), rtol=0, atol=1e-9)
    return f"{milliseconds:>12,.0f} ms{sp.count_ops(T):>7}"


def main(quick=False):
    """Print the table, one line for each robot."""
    kl.symbolic.fk(kl.robots.rpr())  # modules that are loaded at first use must not count
    makers = [kl.symbolic.fk, multiplied] if quick else [kl.symbolic.fk, multiplied, simplified, toolbox]
    families = [f for _, f in getmembers(kl.robots, isfunction) if get_annotations(f).get("return") is kl.Chain]
    print(f"{'':<18}" + "".join(f"{name:>22}" for name in ["kinlib", *(make.__name__ for make in makers[1:])]))
    for robot in (family() for family in families if family is not kl.robots.arm):
        print(f"{robot.name:<18}" + "".join(cell(make, robot) for make in makers), flush=True)


if __name__ == "__main__":
    main("--quick" in sys.argv)
