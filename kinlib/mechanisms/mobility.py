"""The mobility of a linkage, which has three meanings: Gruebler-Kutzbach count, infinitesimal mobility and finite mobility.

The Gruebler-Kutzbach formula counts bodies and joints. It is wrong as soon as constraints are redundant. The rank of the
Jacobian gives the infinitesimal (first-order) mobility: the number of independent joint velocities that the loops allow at
this configuration. But some of them cannot be continued to a motion. The finite mobility is the dimension of the set of
configurations nearby that close as well, and is found by searching for them.
"""

from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import Equations, is_nonzero, on_planes, solve
from kinlib.rigid.se3_jacobians import ad

PROBE_DISTANCE = 0.02
"""How far away another closed configuration is sought, in radians and metres. If a degree of freedom is only infinitesimal, the
residual there is about PROBE_DISTANCE^2 or, in the rarest linkages, PROBE_DISTANCE^4 = 2e-7: far more than the tolerance of
about 1e-12 to which a configuration closes."""


@dataclass(frozen=True, eq=False)
class Mobility:
    """The mobility of a linkage at one configuration.

    kutzbach              the Gruebler-Kutzbach count: the degrees of freedom of all joints, minus the equations of the loops,
                          as if these were all independent
    infinitesimal         the first-order mobility: the degrees of freedom of all joints, minus the rank of the Jacobian
    finite                the dimension of the motions that lead to other closed configurations
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

    screws (k, 6) -> for example 3 for a planar or a spherical linkage, 6 for most others. The Lie brackets of twists in the
    Lie algebra of a group are in it too, so they are added until no new twist appears.

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


def finite_mobility(equations: Equations, x: Array, directions: Array, tolerance: float) -> int:
    """Find the dimension of the set of solutions around x: how many of the directions (n, k) at x lead to other solutions.

    A set of dimension d intersects d random hyperplanes near x, but not d + 1. So d is counted down from the number of
    directions until a solution near x is found that lies on d hyperplanes.

    >>> double_root = lambda x: (x * x, 2 * x[:, :, None])       # x^2 = 0: the Jacobian at 0 is 0, but 0 is the only solution
    >>> finite_mobility(double_root, np.zeros(1), np.eye(1), tolerance=1e-12)
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
            found = solve(planes, (x + directions @ mix @ offsets)[None], tolerance)
            is_near = np.linalg.norm(found.x[0] - x) < 10 * PROBE_DISTANCE
            if found.residual[0] <= tolerance and is_near:
                return d
    return 0
