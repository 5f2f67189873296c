"""Solve systems of equations that may be overdetermined, underdetermined or dependent: the closure of a linkage is often all three.

The Jacobian of a linkage is seldom square and often rank-deficient, so Newton's step is built from its singular value
decomposition: it has no component along directions that change nothing, and far from a solution it is damped.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array

RANK_RTOL = 1e-7
"""Singular values below this, relative to the largest, count as 0. A configuration in which branches cross is known only to
the square root of the residual, about 1e-8, so its smallest singular value has this size and is never exactly 0."""


@dataclass(frozen=True, eq=False)
class Equations:
    """Equations in n unknowns.

    linearize        x (m, n) -> the residuals (m, e), and their Jacobians (m, e, n): m points at once
    tolerance        a point solves them if the norm of its residual is at most this
    is_angle  (n,)   which unknowns are angles, and so the same again after 2 pi
    """

    linearize: Callable[[Array], tuple[Array, Array]]
    tolerance: float
    is_angle: NDArray[np.bool_]


class Solution(NamedTuple):
    """Where the search ended from each of m guesses: x (m, n), |r| (m,) and J (m, e, n) there."""

    x: Array
    residual: Array
    jacobian: Array


def solve(equations: Equations, guess: Array, iterations: int = 100) -> Solution:
    """Find the solution near each guess by damped Gauss-Newton steps (Levenberg-Marquardt), m guesses (m, n) at once.

    Each step solves (J^T J + mu |r|^2 I) dx = -J^T r. The damping vanishes with the residual r, so that the search
    converges quadratically even where the solutions form curves. mu falls after a step that decreases |r|, and grows after
    one that does not, which is not taken. A search ends where |r| is at most the tolerance, or after `iterations` steps.

    Source: Fan and Yuan, On the quadratic convergence of the Levenberg-Marquardt method without nonsingularity
    assumption (2005).
    """
    x = np.array(guess, dtype=float)
    r, J = equations.linearize(x)
    size, mu = np.linalg.norm(r, axis=-1), np.ones(len(x))
    active = size > equations.tolerance
    for _ in range(iterations):
        if not (k := np.flatnonzero(active)).size:
            break
        U, s, Vt = np.linalg.svd(J[k], full_matrices=False)
        gain = is_nonzero(s) * s / (s * s + (mu[k] * size[k] ** 2)[:, None] + np.finfo(float).tiny)
        dx = -np.einsum("mkn,mk,mek,me->mn", Vt, gain, U, r[k])
        r_new, J_new = equations.linearize(x[k] + dx)
        better = np.linalg.norm(r_new, axis=-1) < size[k]
        taken = k[better]
        x[taken] += dx[better]
        r[taken], J[taken], size[taken] = r_new[better], J_new[better], np.linalg.norm(r_new[better], axis=-1)
        mu[k] = np.where(better, np.maximum(mu[k] / 4, 1e-8), mu[k] * 4)
        # At a minimum the steps shrink to 0.
        moves = np.linalg.norm(dx, axis=-1) > 1e-12 * (1 + np.linalg.norm(x[k], axis=-1))
        active[k] = (size[k] > equations.tolerance) & moves
    return Solution(x, size, J)


def polish(equations: Equations, x: Array) -> Solution:
    """Take one more step from solutions (m, n): near them a step squares the error, so only rounding errors are left."""
    return solve(replace(equations, tolerance=0.0), x, iterations=1)


def validate_solution(equations: Equations, x: Array) -> tuple[Array, Array]:
    """Find the solution (n,) at a point that the caller passes as one, and its Jacobian (e, n); ValueError if it is none."""
    r, _ = equations.linearize(x[None])
    if (residual := np.linalg.norm(r)) > 1e3 * equations.tolerance:  # it may be typed with few digits
        raise ValueError(f"The linkage must be closed here; the residual is {residual:.2g}. Assemble it first.")
    found = solve(equations, x[None])
    return found.x[0], found.jacobian[0]


def null_space(J: Array) -> tuple[Array, Array]:
    """Find an orthonormal basis (n, k) of the null space of a Jacobian (e, n), and all its n singular values, the largest first."""
    _, s, Vt = np.linalg.svd(J)
    values = np.pad(s, (0, J.shape[-1] - len(s)))
    return Vt[~is_nonzero(values)].T, values


def is_nonzero(singular_values: Array) -> NDArray[np.bool_]:
    """Find which singular values (..., k), the largest first, are more than rounding errors relative to the largest."""
    return np.asarray(singular_values > RANK_RTOL * np.maximum(singular_values[..., :1], 1e-300))


def on_planes(equations: Equations, x: Array, normals: Array, offsets: Array) -> Equations:
    """Add to equations those of hyperplanes, normals.T (y - x) = offsets, with normals (n, k) and offsets (k,)."""

    def with_planes(y: Array) -> tuple[Array, Array]:
        r, J = equations.linearize(y)
        planes = np.broadcast_to(normals.T, (len(y), *normals.T.shape))
        return np.concatenate([r, (y - x) @ normals - offsets], axis=1), np.concatenate([J, planes], axis=1)

    return replace(equations, linearize=with_planes)
