"""How many freedoms a linkage has: counted, felt, and had.

Counting bodies and joints is one answer, and it errs as soon as constraints repeat each other. The rank of the Jacobian is
another: it tells the freedoms that a hand would feel, and some of them lead nowhere. The third goes and looks: from this
posture, is there another one nearby, in that direction, that closes too?
"""

from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import Equations, seen, solve
from kinlib.rigid.se3_jacobians import ad

REACH = 0.02
"""How far away the next posture is sought, in radians and metres. A freedom that is only infinitesimal leaves a gap of the
size REACH^2 or, for the rarest linkages, REACH^4 = 2e-7 there: far more than the 1e-12 to which a posture closes."""

NEAR = 10
"""A posture farther away than this many times REACH is another one, and proves nothing about this one."""

TRIALS = 12
"""Directions tried for each number of freedoms: at a crossing of branches some lie so that they miss them all."""


@dataclass(frozen=True, eq=False)
class Mobility:
    """The freedoms of a linkage in one posture.

    kutzbach              freedoms of the joints, less those that the loops take if all their equations are independent
    instantaneous         freedoms of the joints, less the rank of the Jacobian: what a hand would feel here
    finite                freedoms that really lead somewhere, to postures that close
    singular_values (n,)  of the Jacobian about the middle of each loop, so that they are the same wherever the linkage is
                          drawn, the largest first; instantaneous counts those that are 0
    directions (n, k)     joint speeds that the loops let through here, one a column
    """

    kutzbach: int
    instantaneous: int
    finite: int
    singular_values: Array
    directions: Array

    def __str__(self) -> str:
        """Say it in words.

        >>> from kinlib.mechanisms.linkages import stretched_arch
        >>> print(stretched_arch().mobility([0, 0, 0]))
        Counting gives 0. Here the loops let 1 through, but none leads anywhere: ...
        """
        counted = f"Counting gives {self.kutzbach}."
        felt = f"Here the loops let {self.instantaneous} through"
        if self.finite == self.instantaneous:
            had = "and as many lead on." if self.finite else "so nothing moves."
        elif self.finite:
            had = (
                f"but only {self.finite} at a time leads on: this posture is singular, a crossing of branches perhaps."
            )
        else:
            had = "but none leads anywhere: it is infinitesimal, and this posture is singular."
        return f"{counted} {felt}, {had}"


def group_dimension(screws: Array) -> int:
    """The dimension of the smallest group of motions that holds these joints: how many equations a loop of them can pose.

    screws (k, 6) -> 3 for a planar or a spherical linkage, 6 for most others: brackets of twists are twists of the group
    too, and they are added until no new one comes.

    Source: Modern Robotics, 2.2.1, where m is 3 or 6; Herve, Analyse structurelle des mecanismes par groupe des
    deplacements (1978).

    >>> parallel = np.array([[0, 0, 1, 0, 0, 0], [0, 0, 1, 0, -1, 0], [0, 0, 1, 1, 0, 0]])
    >>> group_dimension(parallel)                                   # turns about z: a planar linkage
    3
    """
    basis = _basis(screws)
    while len(basis) < len(
        wider := _basis(np.concatenate([basis, (ad(basis) @ basis.T[None]).swapaxes(1, 2).reshape(-1, 6)]))
    ):
        basis = wider
    return len(basis)


def _basis(twists: Array) -> Array:
    """Orthonormal twists (k, 6) that span the same space."""
    _, s, Vt = np.linalg.svd(twists)
    return Vt[: np.count_nonzero(seen(s))]


def finite_freedoms(equations: Equations, x: Array, directions: Array, closed: float) -> int:
    """The dimension of the set of solutions around x: how many freedoms (n, k) at x lead to other solutions.

    A set of d dimensions is met by d planes put across it at random, a little away from x, and missed by d + 1. So from
    the number of directions downwards: is there, near x, a solution on that many planes?

    >>> shaky = lambda x: (x * x, 2 * x[:, :, None])       # x^2 = 0: the Jacobian at 0 is 0, and yet nothing moves
    >>> finite_freedoms(shaky, np.zeros(1), np.eye(1), closed=1e-12)
    0
    """
    # The planes are drawn at random, and the answer must not be: every call draws the same ones.
    rng = np.random.default_rng(0)
    for d in range(directions.shape[1], 0, -1):
        for _ in range(TRIALS):
            mix, _ = np.linalg.qr(rng.normal(size=(directions.shape[1], d)))
            away = rng.normal(size=d)
            away *= REACH / np.linalg.norm(away)
            if _meets(equations, x, directions @ mix, away, closed):
                return d
    return 0


def _meets(equations: Equations, x: Array, across: Array, away: Array, closed: float) -> bool:
    """Whether the solutions near x meet the planes across.T (y - x) = away."""

    def on_the_planes(y: Array) -> tuple[Array, Array]:
        r, J = equations(y)
        planes = np.broadcast_to(across.T, (len(y), *across.T.shape))
        return np.concatenate([r, (y - x) @ across - away], axis=1), np.concatenate([J, planes], axis=1)

    found = solve(on_the_planes, (x + across @ away)[None], closed)
    return bool(found.residual[0] <= closed and np.linalg.norm(found.x[0] - x) < NEAR * REACH)
