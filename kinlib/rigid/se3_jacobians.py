"""How the logarithm of a rigid motion changes when the motion changes: Newton's method needs this to close a loop.

If a motion E is followed by a small twist V, it becomes exp(V) E. Its logarithm would change by V itself if motions commuted.
They do not, and the correction is a power series in the Lie bracket of twists.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import hat

TERMS = 30
"""How many terms of the series are summed: at half a turn each is a quarter of the one before it."""

_B = [1 / 12]
"""b_k = |B_2k| / (2k)! with the Bernoulli numbers B_2k: 1 - (theta/2) cot(theta/2) = sum over k of b_k theta^(2k). The derivative
of the cotangent is -1 - cot^2, so (2k + 1) b_k is the sum of all b_j b_(k-j)."""
while len(_B) <= TERMS:
    _B.append(float(np.dot(_B, _B[::-1])) / (2 * len(_B) + 3))

_K = np.arange(1, TERMS + 1)
_C2_AND_C4 = np.stack([(2 - _K) * _B[:-1], -_K * _B[1:]], axis=1)


def ad(x: ArrayLike) -> Array:
    """Write the Lie bracket with a twist x as a matrix, 6x6: the adjoint representation of se(3).

    (..., 6) -> (..., 6, 6), [[hat(omega), 0], [hat(v), hat(omega)]], so that hat(ad(x) y) = hat(x) hat(y) - hat(y) hat(x).
    ad(x) y = [x, y] is the velocity at which the motion along x changes y.

    Raises ValueError if x is not a twist.
    Source: Modern Robotics, definition 8.1.
    """
    x = validation.vectors(x, "x", 6)
    matrix = np.zeros((*x.shape[:-1], 6, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = hat(x[..., :3])
    matrix[..., 3:, :3] = hat(x[..., 3:])
    return matrix


def left_jacobian_inverse(x: ArrayLike) -> Array:
    """Write the inverse of the left Jacobian of SE(3): how log(E) changes when E = exp(x) is followed by a small twist V.

    (..., 6) -> (..., 6, 6), J(x)^-1 with log(exp(V) E) = x + J(x)^-1 V + O(V^2):  I - A/2 + c2 A^2 + c4 A^4,  A = ad(x),
    c2 = sum over k of (2 - k) b_k theta^(2k - 2),  c4 = sum over k of (1 - k) b_k theta^(2k - 4),  theta = |omega|.

    Raises ValueError if x is not a twist. The angle theta must be at most pi, as that of each twist which log returns.
    Source: the Bernoulli series sum B_k ad^k / k!, shortened by ad^5 = -2 theta^2 ad^3 - theta^4 ad.
    """
    A = ad(x)
    square = np.sum(np.asarray(x, dtype=float)[..., :3] ** 2, axis=-1)
    c2, c4 = np.moveaxis(square[..., None] ** (_K - 1) @ _C2_AND_C4, -1, 0)[..., None, None]
    A2 = A @ A
    J_inverse: Array = np.eye(6) - A / 2 + c2 * A2 + c4 * (A2 @ A2)
    return J_inverse
