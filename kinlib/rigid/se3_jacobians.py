"""How the logarithm of a rigid motion changes when the motion changes: Newton's method needs this to close a loop.

If a motion E is followed by a small twist V, it becomes exp(V) E. Its logarithm would change by V itself if motions commuted.
They do not, and the correction is a power series in the Lie bracket of twists.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import hat


def ad(x: ArrayLike) -> Array:
    """Write the Lie bracket with a twist x as a matrix, 6x6: the adjoint representation of se(3).

    (..., 6) -> (..., 6, 6), [[hat(omega), 0], [hat(v), hat(omega)]], so that hat(ad(x) y) = hat(x) hat(y) - hat(y) hat(x).
    ad(x) y = [x, y] is the velocity at which the motion along x changes y.

    Source: Modern Robotics, definition 8.1.
    """
    x = validation.vectors(x, "x", 6)
    matrix = np.zeros((*x.shape[:-1], 6, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = hat(x[..., :3])
    matrix[..., 3:, :3] = hat(x[..., 3:])
    return matrix


def left_jacobian_inverse(x: ArrayLike) -> Array:
    """Write the inverse of the left Jacobian of SE(3): how log(E) changes when E = exp(x) is followed by a small twist V.

    (..., 6) -> (..., 6, 6), J(x)^-1 with log(exp(V) E) = x + J(x)^-1 V + O(V^2):  J(x) = I + A/2! + A^2/3! + ...,  A = ad(x).

    The angle of x must be at most pi, as that of each twist which log returns.
    Source: J(x) is the integral of exp(s ad(x)) over s from 0 to 1, term by term.
    """
    A, identity = ad(x), np.eye(6)
    squared, J = A @ A, identity
    for k in range(30, 0, -2):  # two terms at a time; at half a turn the next one is below 1e-17
        J = identity + A / k + squared @ J / (k * (k + 1))
    return np.asarray(np.linalg.inv(J))
