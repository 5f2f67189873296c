"""Branch points: configurations at which several motions with one degree of freedom meet, and the directions of these motions.

A motion x(s) with the velocity t = x' at a configuration satisfies the equations r(x) = 0 to second order, if

    J t = 0        and        J x'' + H(t, t) = 0,        with the Jacobian J and the second derivative H of r.

J x'' is a combination of the columns of J. So some x'' exists if and only if L^T H(t, t) = 0, where the columns of L are a basis
of the left null space of J. With t = N c, where the columns of N are a basis of the null space of J, these are quadratic
equations for c: where two curves cross, one equation for two unknowns, whose two solutions are the two tangents.
"""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import START_TOL_FACTOR, Equations, is_nonzero, null_space, solve

DIFFERENCE_STEP = 1e-5
"""The step of central differences: their error is about its square, and their rounding error about 1e-16 divided by it."""

NEARLY_SINGULAR_RTOL = 1e-3
"""If a singular value is below this, relative to the largest, a branch point is sought nearby."""

MAX_DISTANCE = 1e-3
"""How far the branch point may be from a configuration that is given for it: a configuration found by `assemble` near a branch
point is accurate to about 1e-6 only, and a typed one to its digits."""

QUADRATIC_RTOL = 1e-7
"""Coefficients of the second-order condition below this, relative to the second derivatives of all residuals, count as 0."""

CONDITION_TOL = 1e-8
"""A direction fulfils the second-order condition if its residual is at most this: differences leave errors of about 1e-10."""

SAME_DIRECTION_TOL_RAD = 1e-3
"""Directions at a smaller angle are one: where two curves touch, both have one direction, known to the square root of the error."""

STARTS_PER_DIMENSION = 64
"""The number of random directions, for each dimension of the null space, from which solutions of the condition are sought."""


def nearest_branch_point(equations: Equations, x: Array, tolerance: float) -> Array:
    """Find the branch point near a solution x (n,), or return x itself if there is none within MAX_DISTANCE.

    At a branch point y the Jacobian has a null space of more than one dimension: r(y) = 0, J(y) V = 0, and V0^T V = I, with V0
    the right singular vectors of the small singular values at x. These equations determine y to the full precision, while
    r(y) = 0 alone determines it only to the square root of the tolerance.

    >>> def cross(x):                                                     # sin(x) sin(y) = 0 and z = 0
    ...     (s, t, z), (c, d, _) = np.where([[1], [1], [0]], np.sin(x.T), x.T), np.cos(x.T)
    ...     J = np.zeros((len(x), 2, 3))
    ...     J[:, 0, 0], J[:, 0, 1], J[:, 1, 2] = c * t, s * d, 1
    ...     return np.stack([s * t, z], axis=1), J
    >>> nearest_branch_point(cross, np.array([1e-5, 0.0, 0.0]), tolerance=1e-12).round(12) + 0.0
    array([0., 0., 0.])
    """
    _, s, Vt = np.linalg.svd(equations(x[None])[1][0])
    k = len(x) - int(np.count_nonzero(s > NEARLY_SINGULAR_RTOL * s[0]))
    if k < 2:
        return x
    V0, n = Vt[-k:], len(x)

    def singular(z: Array) -> tuple[Array, Array]:
        """The three equations for one (y, V), V written row by row."""
        y, V = z[0, :n], z[0, n:].reshape(k, n)
        r, J = (values[0] for values in equations(y[None]))
        size = r.size
        jacobian = np.zeros((size * (k + 1) + k * k, n * (k + 1)))
        jacobian[:size, :n] = J
        for i, dJ in enumerate(_derivatives(equations, y, V)):
            rows, columns = slice(size * (i + 1), size * (i + 2)), slice(n * (i + 1), n * (i + 2))
            # The second derivative is symmetric: the derivative of J v by y is that of J along v.
            jacobian[rows, :n], jacobian[rows, columns] = dJ, J
            jacobian[size * (k + 1) + k * i :, columns][:k] = V0
        residual = np.concatenate([r, (V @ J.T).ravel(), (V @ V0.T - np.eye(k)).ravel()])
        return residual[None], jacobian[None]

    found = solve(singular, np.concatenate([x, V0.ravel()])[None], tolerance, iterations=20)
    y = found.x[0, :n]
    is_near = np.linalg.norm(y - x) <= MAX_DISTANCE and found.residual[0] <= START_TOL_FACTOR * tolerance
    return y if is_near else x


def branch_directions(equations: Equations, x: Array) -> Array:
    """Find the unit tangents (b, n) that the second-order condition allows at a solution x (n,), each with one of its signs.

    At a regular point this is the tangent of the curve. At a branch point a tangent may still belong to no motion, if the
    condition of third order forbids it. Curves that touch have one tangent in common.

    Raises ValueError if the condition leaves a continuum of directions: the solutions are then not curves, or the branches
    differ only in derivatives of higher order.

    >>> cross = lambda x: (x[:, :1] * x[:, 1:], x[:, None, ::-1])         # x y = 0: the two axes
    >>> branch_directions(cross, np.zeros(2)).round(9) + 0.0
    array([[1., 0.],
           [0., 1.]])
    """
    J = equations(x[None])[1][0]
    N, _ = null_space(J)
    k = N.shape[1]
    if not k:
        return np.empty((0, len(x)))
    quadratics = _second_order_condition(equations, x, J, N)

    def condition(c: Array) -> tuple[Array, Array]:
        """c^T Q c = 0 for each Q, and |c|^2 = 1."""
        Qc = np.einsum("aij,mj->mai", np.concatenate([quadratics, np.eye(k)[None]]), c)
        values = np.einsum("mai,mi->ma", Qc, c)
        values[:, -1] -= 1
        return values, 2 * Qc

    # The starts are random but the result must not be: every call draws the same ones.
    starts = np.random.default_rng(0).normal(size=(STARTS_PER_DIMENSION * k, k))
    starts /= np.linalg.norm(starts, axis=1, keepdims=True)
    found = solve(condition, starts, tolerance=0.0, iterations=60)
    coordinates: list[Array] = []
    for c in found.x[found.residual <= CONDITION_TOL]:
        if all(abs(c @ other) < np.cos(SAME_DIRECTION_TOL_RAD) for other in coordinates):
            coordinates.append(c / np.linalg.norm(c))
    # k - 1 quadratic equations have at most 2^(k - 1) isolated solutions, by Bezout's theorem.
    if len(coordinates) > 2 ** (k - 1):
        raise ValueError(
            "The curves through this configuration must have single tangents; to second order it can move in a continuum of "
            f"directions, within {k} dimensions. Hold all degrees of freedom but one, or start at another configuration."
        )
    tangents = np.array(coordinates).reshape(-1, k) @ N.T
    # Both signs of a tangent are right. Fix one, so that the same configuration gives the same tangents on every machine.
    largest = np.argmax(np.abs(tangents) > np.abs(tangents).max(axis=1, keepdims=True) - CONDITION_TOL, axis=1)
    tangents *= np.sign(tangents[np.arange(len(tangents)), largest])[:, None]
    ordered: Array = tangents[np.lexsort(tangents.round(6).T[::-1])[::-1]]
    return ordered


def _second_order_condition(equations: Equations, x: Array, J: Array, N: Array) -> Array:
    """Independent quadratic forms Q (a, k, k), all 0 for the coordinates c of a tangent N c of a motion."""
    U, s, _ = np.linalg.svd(J)
    L = U[:, np.count_nonzero(is_nonzero(s)) :]
    derivatives = _derivatives(equations, x, N.T)
    forms = np.einsum("el,ken,nj->lkj", L, derivatives, N)
    k = N.shape[1]
    _, sizes, independent = np.linalg.svd((forms + forms.swapaxes(1, 2)).reshape(-1, k * k), full_matrices=False)
    scale = max(float(np.linalg.norm(derivatives)), np.finfo(float).tiny)
    return independent[sizes > QUADRATIC_RTOL * scale].reshape(-1, k, k)


def _derivatives(equations: Equations, x: Array, directions: Array) -> Array:
    """The derivatives (k, e, n) of the Jacobian at x (n,) along k directions (k, n)."""
    h = DIFFERENCE_STEP * directions
    J = equations(np.concatenate([x + h, x - h]))[1]
    derivatives: Array = (J[: len(h)] - J[len(h) :]) / (2 * DIFFERENCE_STEP)
    return derivatives
