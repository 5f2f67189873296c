"""Rigid motions as exponentials: SO(3), SE(3) and the twists that generate them.

A twist is (omega, v) stacked in one 6-vector, as in Modern Robotics. Every function takes any leading batch shape and
tells the two groups apart by the last dimensions: 3 and 3x3 for rotations, 6 and 4x4 for rigid motions.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib import check
from kinlib.check import Array


def hat(x: ArrayLike) -> Array:
    """Write a rotation vector or a twist as the matrix by which it acts.

    (..., 3) -> (..., 3, 3), the skew matrix with hat(w) u = w x u;
    (..., 6) -> (..., 4, 4), the matrix [[hat(omega), v], [0, 0]].

    Raises ValueError for any other last dimension, and for NaN or infinity.
    Source: Modern Robotics, (3.30) and (3.71).

    >>> hat([0, 0, 1]) @ [1, 0, 0]
    array([0., 1., 0.])
    """
    return _hat(_generator(x))


def vee(X: ArrayLike) -> Array:
    """Read the rotation vector or the twist back from its matrix: the inverse of hat.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6).

    Raises ValueError for a matrix that no vector has: its rotation block is not skew, or its last row is not zero.
    Source: Modern Robotics, (3.30) and (3.71).

    >>> vee(hat([1, 2, 3, 4, 5, 6]))
    array([1., 2., 3., 4., 5., 6.])
    """
    X = check.array(X, "X")
    if X.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"vee takes (..., 3, 3) or (..., 4, 4); got shape {X.shape}.")
    W = X[..., :3, :3]
    # Skewness is a matter of scale: an entry of 1e9 may carry a rounding error that would be a fault beside 1.
    scale = np.maximum(1, np.abs(W).max(axis=(-2, -1), keepdims=True))
    if (np.abs(W + np.swapaxes(W, -1, -2)) > check.RIGID * scale).any():
        raise ValueError(
            "vee takes a skew matrix, and this one differs from minus its transpose. Is it a rotation? Then take its log first."
        )
    omega = W[..., [2, 0, 1], [1, 2, 0]]
    if X.shape[-1] == 3:
        return omega
    if (np.abs(X[..., 3, :]) > check.RIGID).any():
        raise ValueError(
            "The last row of an se(3) matrix is zero, and this one is not. Is it a pose? Then take its log first."
        )
    return np.concatenate([omega, X[..., :3, 3]], axis=-1)


def exp(x: ArrayLike) -> Array:
    """Move along a rotation vector or a twist for one unit of time.

    (..., 3) -> (..., 3, 3):  R = I + a W + b W^2, Rodrigues' formula;
    (..., 6) -> (..., 4, 4):  the same R, and p = (I + b W + c W^2) v.

    Here theta = |omega|, W = hat(omega), a = sin(theta) / theta, b = (1 - cos(theta)) / theta^2 and
    c = (theta - sin(theta)) / theta^3. For a screw axis S and a joint value q, the factor of the PoE formula is exp(S q).

    Raises ValueError for any other last dimension, for NaN or infinity, and for a turn too long to have a direction.
    Source: Modern Robotics, (3.51) and (3.88); the UIUC deck's "true form" is the series that this sums.

    >>> exp([0, 0, np.pi / 2, 0, 0, 0]).round(3) + 0.0
    array([[ 0., -1.,  0.,  0.],
           [ 1.,  0.,  0.,  0.],
           [ 0.,  0.,  1.,  0.],
           [ 0.,  0.,  0.,  1.]])
    """
    x = _generator(x)
    # hypot squares nothing, so that no vector is too long or too short to have a length.
    theta = check.turn(np.hypot.reduce(x[..., :3], axis=-1))[..., None, None]
    W = _hat(x[..., :3])
    W2 = W @ W
    a = np.sinc(theta / np.pi)
    # The half angle keeps every digit where 1 - cos(theta) would cancel.
    b = np.sinc(theta / (2 * np.pi)) ** 2 / 2
    R = np.eye(3) + a * W + b * W2
    if x.shape[-1] == 3:
        return R
    # Near 0 the error of 1 - a is divided by theta^2 and meets W^2, which shrinks as fast: no series is needed.
    c = _quotient(1 - a, theta**2)
    p = (np.eye(3) + b * W + c * W2) @ x[..., 3:, None]
    return _pose(R, p[..., 0])


def log(X: ArrayLike) -> Array:
    """Find the rotation vector or the twist whose exponential is X: the motion that reaches X in one unit of time.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6). The angle |omega| lies in [0, pi]; at exactly pi both omega and
    -omega are right, and the one whose largest component is positive is returned.

    With W = hat(omega):  v = (I - W / 2 + k W^2) p,  k = (1 - (theta / 2) cot(theta / 2)) / theta^2.

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, 3.2.3.3 and (3.91), (3.92); the rotation goes by way of its unit quaternion.

    >>> log(exp([0, 0, np.pi / 2, 1, 0, 0])).round(6)
    array([0.      , 0.      , 1.570796, 1.      , 0.      , 0.      ])
    """
    X = check.rigid(X, "X")
    omega = _rotation_log(X[..., :3, :3])
    if X.shape[-1] == 3:
        return omega
    theta = np.linalg.norm(omega, axis=-1)[..., None, None]
    W = _hat(omega)
    k = _quotient(1 - np.cos(theta / 2) / np.sinc(theta / (2 * np.pi)), theta**2)
    v = (np.eye(3) - W / 2 + k * (W @ W)) @ X[..., :3, 3, None]
    return np.concatenate([omega, v[..., 0]], axis=-1)


def inverse(X: ArrayLike) -> Array:
    """Undo a rotation or a rigid motion: T_ab becomes T_ba.

    (..., 3, 3) -> (..., 3, 3), R^T;  (..., 4, 4) -> (..., 4, 4), [[R^T, -R^T p], [0, 1]].

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, (3.64).

    >>> inverse([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])[:3, 3] + 0.0
    array([-2.,  0.,  0.])
    """
    X = check.rigid(X, "X")
    Rt = np.swapaxes(X[..., :3, :3], -1, -2)
    if X.shape[-1] == 3:
        return Rt
    return _pose(Rt, -(Rt @ X[..., :3, 3, None])[..., 0])


def adjoint(X: ArrayLike) -> Array:
    """Write the matrix that carries twists from one frame to another: [Ad_T] takes twists in {b} to {a} for T = T_ab.

    (..., 4, 4) -> (..., 6, 6), [[R, 0], [hat(p) R, R]]; (..., 3, 3) -> (..., 3, 3), R itself.
    It is what makes hat(Ad_T x) = T hat(x) T^-1.

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, definition 3.20.

    >>> T = exp([0, 0, 0, 2, 0, 0])                 # two metres along x
    >>> adjoint(T) @ [0, 0, 1, 0, 0, 0]             # the same turn about z, now with its moment
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    X = check.rigid(X, "X")
    if X.shape[-1] == 3:
        return X
    R = X[..., :3, :3]
    Ad = np.zeros((*X.shape[:-2], 6, 6))
    Ad[..., :3, :3] = Ad[..., 3:, 3:] = R
    Ad[..., 3:, :3] = _hat(X[..., :3, 3]) @ R
    return Ad


def _generator(x: ArrayLike) -> Array:
    x = check.array(x, "x")
    if x.shape[-1:] not in {(3,), (6,)}:
        fits = x.ndim > 1 and x.shape[-2] in {3, 6}
        cause = "Are the components in the first dimension? Try x.T." if fits else "A twist is (omega, v), six numbers."
        raise ValueError(f"A rotation vector is (..., 3) and a twist (..., 6); got shape {x.shape}. {cause}")
    return x


def _hat(x: Array) -> Array:
    if x.shape[-1] == 6:
        X = np.zeros((*x.shape[:-1], 4, 4))
        X[..., :3, :3] = _hat(x[..., :3])
        X[..., :3, 3] = x[..., 3:]
        return X
    W = np.zeros((*x.shape, 3))
    W[..., [2, 0, 1], [1, 2, 0]] = x
    return W - np.swapaxes(W, -1, -2)


def _rotation_log(R: Array) -> Array:
    # With the unit quaternion q = (w, x, y, z) of R, the matrix 4 q q^T is linear in R. Each of its columns is a
    # multiple of q, and the longest one is never near zero: no case for small angles, none for angles near pi.
    xx, yy, zz = R[..., 0, 0], R[..., 1, 1], R[..., 2, 2]
    qq = np.empty((*R.shape[:-2], 4, 4))
    qq[..., 0, 0] = 1 + xx + yy + zz
    qq[..., 1, 1] = 1 + xx - yy - zz
    qq[..., 2, 2] = 1 - xx + yy - zz
    qq[..., 3, 3] = 1 - xx - yy + zz
    Rt = np.swapaxes(R, -1, -2)
    qq[..., 0, 1:] = qq[..., 1:, 0] = (R - Rt)[..., [2, 0, 1], [1, 2, 0]]
    qq[..., [1, 1, 2], [2, 3, 3]] = qq[..., [2, 3, 3], [1, 1, 2]] = (R + Rt)[..., [0, 0, 1], [1, 2, 2]]
    longest = np.argmax(np.diagonal(qq, axis1=-2, axis2=-1), axis=-1)
    q = np.take_along_axis(qq, longest[..., None, None], axis=-1)[..., 0]
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    # q and -q are the same rotation; w >= 0 picks the shorter way round.
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(sine, q[..., :1])
    # Below 1e-160 the sine underflows to 0, and there angle / sine has long since become 2.
    stretch = np.full_like(angle, 2.0)
    np.divide(angle, sine, out=stretch, where=sine > 0)
    omega: Array = stretch * q[..., 1:]
    return omega


def _quotient(numerator: Array, denominator: Array) -> Array:
    """Divide by theta^2, and say 0 where theta^2 is 0: there the quotient multiplies W^2 = 0."""
    quotient = np.zeros_like(numerator)
    np.divide(numerator, denominator, out=quotient, where=denominator > 0)
    return quotient


def _pose(R: Array, p: Array) -> Array:
    T = np.zeros((*p.shape[:-1], 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1.0
    return T
