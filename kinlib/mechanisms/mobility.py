"""The set of configurations in which a linkage closes: its dimension is the mobility, its isolated points are the assembly modes.

Two more meanings of mobility are easier to compute, and not always right: the Gruebler-Kutzbach count and the infinitesimal one.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import Equations, is_nonzero, null_space, on_planes, polish, solve
from kinlib.rigid.lie import ad

PROBE_DISTANCE = 0.02
"""How far away another closed configuration is sought, in radians and metres. If a degree of freedom is only infinitesimal, the
residual there is about PROBE_DISTANCE^2 or, in the rarest linkages, PROBE_DISTANCE^4 = 2e-7: far more than the tolerance of
about 1e-12 to which a configuration closes."""

MODE_TOL = 1e-5
"""Two configurations are different assembly modes if an entry of the pose of some body differs by more than this. At a dead
point two modes become one, and there the search finds it only to the square root of the residual, about 1e-6."""


class Mobility(NamedTuple):
    """The mobility of a linkage at one configuration.

    kutzbach              the Gruebler-Kutzbach count: the degrees of freedom of all joints, minus the equations of the loops. It is
                          wrong as soon as some of these are redundant
    infinitesimal         the first-order mobility: the number of independent joint velocities that the loops allow here, which is
                          that of all joints minus the rank of the Jacobian. Some of them cannot be continued to a motion
    finite                the dimension of the set of configurations nearby that close as well, found by searching for them
    singular_values (n,)  of the Jacobian about the centre of each loop, the largest first; they do not depend on where the
                          linkage is drawn, and infinitesimal is the number of those that are 0
    directions (n, k)     an orthonormal basis of the joint velocities that the loops allow here, one in each column
    """

    kutzbach: int
    infinitesimal: int
    finite: int
    singular_values: Array
    directions: Array


def group_dimension(screws: Array) -> int:
    """Find the dimension of the smallest group of rigid motions that contains these joints: the number of equations of a loop.

    screws (k, 6) -> 3 for a planar or a spherical linkage, 6 for most others. The Lie brackets of twists in the Lie algebra
    of a group are in it too, so they are added until no new twist appears.

    Source: Modern Robotics, 2.2.1, where m is 3 or 6; Herve, Analyse structurelle des mecanismes par groupe des
    deplacements (1978).

    >>> parallel = np.array([[0, 0, 1, 0, 0, 0], [0, 0, 1, 0, -1, 0], [0, 0, 1, 1, 0, 0]])
    >>> group_dimension(parallel)                                   # rotations about parallels of z: a planar linkage
    3
    """
    dimension, twists = 0, screws
    while True:
        _, s, Vt = np.linalg.svd(twists)
        basis = Vt[: np.count_nonzero(is_nonzero(s))]
        if len(basis) == dimension:
            return dimension
        brackets = (ad(basis) @ basis.T).swapaxes(1, 2).reshape(-1, 6)
        dimension, twists = len(basis), np.concatenate([basis, brackets])


def finite_mobility(equations: Equations, x: Array, directions: Array) -> int:
    """Find the dimension of the set of solutions around x: how many of the directions (n, k) at x lead to other solutions.

    A set of dimension d intersects d random hyperplanes near x, but not d + 1. So d is counted down from the number of
    directions until a solution near x is found that lies on d hyperplanes.

    >>> double_root = Equations(lambda x: (x * x, 2 * x[:, :, None]), 1e-12, np.array([False]))
    >>> finite_mobility(double_root, np.zeros(1), np.eye(1))     # x^2 = 0: the Jacobian at 0 is 0, but 0 is the only solution
    0
    """
    # The planes are random but the result must not be: every call draws the same ones.
    rng = np.random.default_rng(0)
    for d in range(directions.shape[1], 0, -1):
        for _ in range(12):  # at a crossing of branches some sets of planes miss all branches
            mix, _ = np.linalg.qr(rng.normal(size=(directions.shape[1], d)))
            offsets = rng.normal(size=d)
            offsets *= PROBE_DISTANCE / np.linalg.norm(offsets)
            planes = on_planes(equations, x, directions @ mix, offsets)
            found = solve(planes, (x + directions @ mix @ offsets)[None])
            if found.residual[0] <= equations.tolerance and np.linalg.norm(found.x[0] - x) < 10 * PROBE_DISTANCE:
                return d
    return 0


def search_modes(equations: Equations, search_range: Array, poses: Callable[[Array], Array]) -> Array:
    """Search for all solutions (k, n), from random guesses within +-search_range (n,), until nothing new is found.

    poses  of the bodies at points (m, n), first dimension m: equal at two solutions of one mode

    Raises ValueError if the linkage can still move at a solution.

    >>> square = Equations(lambda x: (x * x - 4, 2 * x[:, :, None]), 1e-12, np.array([False]))
    >>> search_modes(square, np.array([5.0]), poses=lambda x: x)
    array([[-2.],
           [ 2.]])
    """
    # The guesses are random but the result must not be: every call draws the same ones.
    rng = np.random.default_rng(0)
    modes, known, hits, idle_rounds = list[Array](), list[Array](), list[int](), 0
    lower = -np.pi - 1e-6  # so pi is -pi even with a rounding error
    # If every mode has been found at least twice, it is likely that none is missing (Good, 1953).
    while idle_rounds < (10 if 1 in hits else 1):
        idle_rounds += 1
        found = solve(equations, rng.uniform(-search_range, search_range, (192, len(search_range))), iterations=40)
        exact = polish(equations, found.x[found.residual <= equations.tolerance])
        solutions = np.where(equations.is_angle, (exact.x - lower) % (2 * np.pi) + lower, exact.x)
        for x, pose, J in zip(solutions, poses(solutions), exact.jacobian, strict=True):
            if same := [k for k, other in enumerate(known) if np.abs(pose - other).max() <= MODE_TOL]:
                hits[same[0]] += 1
            elif mobility := finite_mobility(equations, x, null_space(J)[0]):
                raise ValueError(f"No degree of freedom may be left; got {mobility}. Hold more joint values.")
            else:
                modes, known, hits, idle_rounds = [*modes, x], [*known, pose], [*hits, 1], 0
    return np.array(sorted([*mode] for mode in modes)).reshape(-1, len(search_range))
