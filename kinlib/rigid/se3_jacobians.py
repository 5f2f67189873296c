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

SERIES_BELOW_RAD = 0.5
"""For rotations by less than this angle the power series is used, because the closed form divides differences by theta^4."""

SERIES_COEFFICIENTS = np.array(
    [1 / 12, 1 / 720, 1 / 30240, 1 / 1209600, 1 / 47900160, 691 / 1307674368000, 1 / 74724249600]
)
"""|B_2k| / (2k)! with the Bernoulli numbers B_2k: 1 - (theta/2) cot(theta/2) = sum over k of SERIES_COEFFICIENTS[k-1] theta^(2k).
Below SERIES_BELOW_RAD the terms left out are about 1e-15."""

_K = np.arange(1, len(SERIES_COEFFICIENTS) + 1)
_C2_COEFFICIENTS = np.flip((2 - _K) * SERIES_COEFFICIENTS)
_C4_COEFFICIENTS = np.flip(((1 - _K) * SERIES_COEFFICIENTS)[1:])


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

    (..., 6) -> (..., 6, 6), J(x)^-1 with log(exp(V) E) = x + J(x)^-1 V + O(V^2):  I - A/2 + c2 A^2 + c4 A^4,  A = ad(x).
    With theta = |omega| and f = 1 - (theta/2) cot(theta/2):  c2 theta^2 = 2f - theta f'/2,  c4 theta^4 = f - theta f'/2.

    Raises ValueError if x is not a twist. The angle theta must be less than 2 pi, where f is infinite; log returns an angle
    of at most pi.
    Source: the Bernoulli series sum B_k ad^k / k!, shortened by ad^5 = -2 theta^2 ad^3 - theta^4 ad.
    """
    A = ad(x)
    theta = np.linalg.norm(np.asarray(x, dtype=float)[..., :3], axis=-1)[..., None, None]
    square = theta * theta
    # Where the series is used, the closed form is evaluated at an angle of 1 instead, because it would divide by zero.
    safe = np.where(theta < SERIES_BELOW_RAD, 1.0, theta)
    half = safe / 2
    cot = 1 / np.tan(half)
    f = 1 - half * cot
    slope = (half / np.sin(half) ** 2 - cot) * safe / 4  # theta f' / 2
    c2 = np.where(theta < SERIES_BELOW_RAD, np.polyval(_C2_COEFFICIENTS, square), (2 * f - slope) / safe**2)
    c4 = np.where(theta < SERIES_BELOW_RAD, np.polyval(_C4_COEFFICIENTS, square), (f - slope) / safe**4)
    A2 = A @ A
    J_inverse: Array = np.eye(6) - A / 2 + c2 * A2 + c4 * (A2 @ A2)
    return J_inverse
