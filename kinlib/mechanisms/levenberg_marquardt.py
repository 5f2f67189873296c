"""Solve systems of equations that may be overdetermined, underdetermined or dependent: the closure of a linkage is often all three.

Newton's step would invert the Jacobian. The Jacobian of a linkage is seldom square and often rank-deficient, so the step is
built from its singular value decomposition: it has no component along directions that change nothing, and far from a
solution it is damped.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array

Equations = Callable[[Array], tuple[Array, Array]]
"""x (m, n) -> the residuals (m, e), and their Jacobians (m, e, n): m points at once."""

RANK_RTOL = 1e-7
"""Singular values below this, relative to the largest, count as 0. A configuration in which branches cross is known only to
the square root of the residual, about 1e-8, so its smallest singular value has this size and is never exactly 0."""

MIN_GAIN_RATIO = 1e-3
"""A step that achieves less than this fraction of the decrease that its linear model predicts is rejected, and the damping of
the next one is increased."""

START_TOL_FACTOR = 1e3
"""The residual of a point that the caller passes as a solution may be this many times the tolerance: it may have been found by
another method, or typed with few digits."""

MIN_PREDICTED_DECREASE = 1e-12
"""The search ends if the best step is predicted to decrease |r|^2 by no more than this fraction of it."""


@dataclass(frozen=True, eq=False)
class Solution:
    """Where the search ended, from each of m guesses.

    x           (m, n)     the last point
    residual    (m,)       the norm of the residual there
    jacobian    (m, e, n)  of the equations there
    iterations             the number of steps of the slowest search
    """

    x: Array
    residual: Array
    jacobian: Array
    iterations: int


def solve(equations: Equations, guess: Array, tolerance: float, iterations: int = 100) -> Solution:
    """Find the solution near each guess by damped Gauss-Newton steps (Levenberg-Marquardt), m guesses (m, n) at once.

    Each step solves (J^T J + mu |r|^2 I) dx = -J^T r. The damping vanishes with the residual r, so that the search
    converges quadratically even where the solutions form curves and J is rank-deficient. mu grows if a step decreases the
    residual by less than the linear model predicts. A search ends where |r| <= tolerance, where no step decreases r, or
    after `iterations` steps.

    Source: Fan and Yuan, On the quadratic convergence of the Levenberg-Marquardt method without nonsingularity
    assumption (2005).

    >>> circle = lambda x: ((x * x).sum(-1, keepdims=True) - 1, 2 * x[:, None, :])      # one equation for two unknowns
    >>> solve(circle, np.array([[3.0, 4.0]]), tolerance=1e-12).x.round(9)               # the nearest point of the circle
    array([[0.6, 0.8]])
    """
    x = np.array(guess, dtype=float)
    r, J = equations(x)
    size = np.linalg.norm(r, axis=-1)
    mu = np.ones(len(x))
    active = size > tolerance
    count = 0
    while active.any() and count < iterations:
        count += 1
        at = np.flatnonzero(active)
        dx, predicted_size = _step(J[at], r[at], mu[at] * size[at] ** 2)
        r_new, J_new = equations(x[at] + dx)
        size_new = np.linalg.norm(r_new, axis=-1)
        predicted_decrease, decrease = size[at] ** 2 - predicted_size**2, size[at] ** 2 - size_new**2
        accepted = (decrease > MIN_GAIN_RATIO * predicted_decrease) & (size_new < size[at])
        moved = at[accepted]
        x[moved] += dx[accepted]
        r[moved], J[moved], size[moved] = r_new[accepted], J_new[accepted], size_new[accepted]
        mu[at] = np.where(accepted, np.maximum(mu[at] / 4, 1e-8), mu[at] * 4)
        # At a local minimum the gradient vanishes and the residual does not, so no step is predicted to decrease it.
        active[at] = (size[at] > tolerance) & (predicted_decrease > MIN_PREDICTED_DECREASE * size[at] ** 2)
    return Solution(x, size, J, count)


def null_space(J: Array) -> tuple[Array, Array]:
    """Find an orthonormal basis (n, k) of the null space of a Jacobian (e, n), and all its n singular values, the largest first.

    >>> directions, singular_values = null_space(np.array([[1.0, 0.0]]))
    >>> np.abs(directions.T), singular_values
    (array([[0., 1.]]), array([1., 0.]))
    """
    _, s, Vt = np.linalg.svd(J)
    values = np.zeros(J.shape[-1])
    values[: len(s)] = s
    return Vt[~is_nonzero(values)].T, values


def is_nonzero(singular_values: Array) -> NDArray[np.bool_]:
    """Find which singular values (..., k), the largest first, are more than rounding errors relative to the largest.

    >>> is_nonzero(np.array([2.0, 1e-3, 1e-15]))
    array([ True,  True, False])
    """
    mask: NDArray[np.bool_] = singular_values > RANK_RTOL * np.maximum(singular_values[..., :1], 1e-300)
    return mask


def _step(J: Array, r: Array, damping: Array) -> tuple[Array, Array]:
    """Compute the damped steps (m, n), and the norms (m,) of the residuals that the linear model predicts after them."""
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    components = (np.swapaxes(U, -1, -2) @ r[..., None])[..., 0]
    gain = np.where(is_nonzero(s), s / (s * s + damping[:, None] + np.finfo(float).tiny), 0.0)
    dx = -(np.swapaxes(Vt, -1, -2) @ (gain * components)[..., None])[..., 0]
    predicted_size = np.linalg.norm(r + (J @ dx[..., None])[..., 0], axis=-1)
    return dx, predicted_size
