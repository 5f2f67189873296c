"""Solve equations that may be too many, too few, or not independent: the closure of a linkage is often all three.

Newton's step would invert the Jacobian. A linkage's Jacobian is seldom square and often short of rank, so the step is
built from its singular values: along directions that change nothing it does not go, and far from a solution it is damped.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array

Equations = Callable[[Array], tuple[Array, Array]]
"""x (m, n) -> what is left over (m, e), and its Jacobian (m, e, n): m points at once."""

RANK = 1e-7
"""Singular values below this, in parts of the largest, count as 0. A posture at a crossing of branches is known to the
square root of the residual, 1e-8 or so, and its smallest singular value is as small as that and never 0."""

TOLD = 1e-3
"""A step must bring at least this part of what its linear model promised, or the next one is damped more."""

ROUGH = 1e3
"""A point given as a solution may leave so many times more than what counts as solved: it was found elsewhere, or typed."""

DEAD_END = 1e-12
"""Where the best step promises to lessen |r|^2 by no more than this part of it, the search is over."""


@dataclass(frozen=True, eq=False)
class Solution:
    """Where the search came to an end, from each of m guesses.

    x           (m, n)     the last point
    residual    (m,)       the norm of what is left over there
    jacobian    (m, e, n)  of the equations, there
    iterations             steps taken by the slowest
    """

    x: Array
    residual: Array
    jacobian: Array
    iterations: int


def solve(equations: Equations, guess: Array, closed: Array | float, iterations: int = 100) -> Solution:
    """Find the solution near each guess: damped Gauss-Newton, m guesses (m, n) side by side.

    Each step solves (J^T J + mu |r|^2 I) dx = -J^T r, so that the damping fades as the residual r does, and what was
    found converges quadratically even where solutions form curves and J is short of rank. mu grows where a step brought
    less than its linear model promised. A guess is done where |r| <= closed, or where no step leads further down.

    Source: Fan and Yuan, On the quadratic convergence of the Levenberg-Marquardt method without nonsingularity
    assumption (2005).

    >>> circle = lambda x: ((x * x).sum(-1, keepdims=True) - 1, 2 * x[:, None, :])      # one equation for two unknowns
    >>> solve(circle, np.array([[3.0, 4.0]]), closed=1e-12).x.round(9)                  # it goes straight to the circle
    array([[0.6, 0.8]])
    """
    x = np.array(guess, dtype=float)
    r, J = equations(x)
    size = np.linalg.norm(r, axis=-1)
    closed = np.broadcast_to(closed, size.shape)
    mu = np.ones(len(x))
    active = size > closed
    count = 0
    while active.any() and count < iterations:
        count += 1
        at = np.flatnonzero(active)
        dx, left = _step(J[at], r[at], mu[at] * size[at] ** 2)
        r_new, J_new = equations(x[at] + dx)
        size_new = np.linalg.norm(r_new, axis=-1)
        promised, brought = size[at] ** 2 - left**2, size[at] ** 2 - size_new**2
        better = (brought > TOLD * promised) & (size_new < size[at])
        taken = at[better]
        x[taken] += dx[better]
        r[taken], J[taken], size[taken] = r_new[better], J_new[better], size_new[better]
        mu[at] = np.where(better, np.maximum(mu[at] / 4, 1e-8), mu[at] * 4)
        # At a dead end the gradient vanishes and the residual does not: every step promises next to nothing.
        active[at] = (size[at] > closed[at]) & (promised > DEAD_END * size[at] ** 2)
    return Solution(x, size, J, count)


def null_space(J: Array) -> tuple[Array, Array]:
    """The directions (n, k) that a Jacobian (e, n) does not see, and all its n singular values, the largest first.

    >>> directions, singular_values = null_space(np.array([[1.0, 0.0]]))
    >>> np.abs(directions.T), singular_values
    (array([[0., 1.]]), array([1., 0.]))
    """
    _, s, Vt = np.linalg.svd(J)
    values = np.zeros(J.shape[-1])
    values[: len(s)] = s
    return Vt[~seen(values)].T, values


def seen(singular_values: Array) -> NDArray[np.bool_]:
    """Which singular values (..., k) are more than rounding, beside the largest.

    >>> seen(np.array([2.0, 1e-3, 1e-15]))
    array([ True,  True, False])
    """
    counts: NDArray[np.bool_] = singular_values > RANK * np.maximum(singular_values[..., :1], 1e-300)
    return counts


def _step(J: Array, r: Array, damping: Array) -> tuple[Array, Array]:
    """The damped step (m, n), and the norm (m,) of what the linear model leaves over after it."""
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    along = (np.swapaxes(U, -1, -2) @ r[..., None])[..., 0]
    gain = np.where(seen(s), s / (s * s + damping[:, None] + np.finfo(float).tiny), 0.0)
    dx = -(np.swapaxes(Vt, -1, -2) @ (gain * along)[..., None])[..., 0]
    left = np.linalg.norm(r + (J @ dx[..., None])[..., 0], axis=-1)
    return dx, left
