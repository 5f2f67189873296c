"""Rigid motions as exponentials: SO(3), SE(3) and the twists that generate them.

A twist is (omega, v) stacked in one 6-vector, as in Modern Robotics. Every function takes any leading batch shape and
tells the two groups apart by the last dimensions: 3 and 3x3 for rotations, 6 and 4x4 for rigid motions.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.batching import cross, dot, sweep
from kinlib.arrays.validation import Array

TINY = np.finfo(float).tiny
"""Added above and below the line of a quotient that has a limit, it makes 0 / 0 that limit, and changes nothing else."""


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
    X = validation.array(X, "X")
    if X.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"vee takes (..., 3, 3) or (..., 4, 4); got shape {X.shape}.")
    W = X[..., :3, :3]
    # Skewness is a matter of scale: an entry of 1e9 may carry a rounding error that would be a fault beside 1.
    scale = np.maximum(1, np.abs(W).max(axis=(-2, -1), keepdims=True))
    if (np.abs(W + np.swapaxes(W, -1, -2)) > validation.RIGID * scale).any():
        raise ValueError(
            "vee takes a skew matrix, and this one differs from minus its transpose. Is it a rotation? Then take its log first."
        )
    omega = W[..., [2, 0, 1], [1, 2, 0]]
    if X.shape[-1] == 3:
        return omega
    if (np.abs(X[..., 3, :]) > validation.RIGID).any():
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
    return sweep(_exp_rotation, x, (3,), (3, 3)) if x.shape[-1] == 3 else sweep(_exp_motion, x, (6,), (4, 4))


def log(X: ArrayLike) -> Array:
    """Find the rotation vector or the twist whose exponential is X: the motion that reaches X in one unit of time.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6). The angle |omega| lies in [0, pi]; at exactly pi both omega and
    -omega are right, and the one whose largest component is positive is returned; of several, the first is.

    With W = hat(omega):  v = (I - W / 2 + k W^2) p,  k = (1 - (theta / 2) cot(theta / 2)) / theta^2.

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, 3.2.3.3 and (3.91), (3.92); the rotation goes by way of its unit quaternion.

    >>> log(exp([0, 0, np.pi / 2, 1, 0, 0])).round(6)
    array([0.      , 0.      , 1.570796, 1.      , 0.      , 0.      ])
    """
    X = validation.motions(X, "X")
    if X.shape[-1] == 3:
        return sweep(_log_rotation, X, (3, 3), (3,), cut=validation.rigid_pieces)
    return sweep(_log_motion, X, (4, 4), (6,), cut=validation.rigid_pieces)


def inverse(X: ArrayLike) -> Array:
    """Undo a rotation or a rigid motion: T_ab becomes T_ba.

    (..., 3, 3) -> (..., 3, 3), R^T;  (..., 4, 4) -> (..., 4, 4), [[R^T, -R^T p], [0, 1]].

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, (3.64).

    >>> inverse([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])[:3, 3] + 0.0
    array([-2.,  0.,  0.])
    """
    X = validation.rigid(X, "X")
    Rt = np.swapaxes(X[..., :3, :3], -1, -2)
    if X.shape[-1] == 3:
        return Rt.copy()
    return pose(Rt, -(Rt @ X[..., :3, 3, None])[..., 0])


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
    X = validation.rigid(X, "X")
    if X.shape[-1] == 3:
        return X.copy()
    R = X[..., :3, :3]
    Ad = np.zeros((*X.shape[:-2], 6, 6))
    Ad[..., :3, :3] = Ad[..., 3:, 3:] = R
    Ad[..., 3:, :3] = _hat(X[..., :3, 3]) @ R
    return Ad


def pose(R: ArrayLike, p: ArrayLike) -> Array:
    """Write a homogeneous transformation from its rotation and its position: T = [[R, p], [0, 1]].

    R (..., 3, 3), p (..., 3), batch dimensions that broadcast -> (..., 4, 4). The columns of R are the axes of the frame;
    `kinlib.chains.robots.pose` takes the axes one after the other instead. R is not checked to be a rotation.

    Source: Modern Robotics, (3.62).

    >>> pose(np.eye(3), [1, 2, 3])
    array([[1., 0., 0., 1.],
           [0., 1., 0., 2.],
           [0., 0., 1., 3.],
           [0., 0., 0., 1.]])
    """
    R, p = np.asarray(R, dtype=float), np.asarray(p, dtype=float)
    T = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1.0
    return T


def perpendicular(axis: ArrayLike) -> Array:
    """Choose a unit vector perpendicular to an axis, the same one every time.

    axis (..., 3), not zero -> (..., 3): the coordinate axis farthest from it, crossed with it. No digits are lost.

    >>> perpendicular([[0, 0, 1], [0, 3, 0]]) + 0.0
    array([[ 0., -1.,  0.],
           [ 0.,  0.,  1.]])
    """
    axis = np.asarray(axis, dtype=float)
    farthest = np.eye(3)[np.argmin(np.abs(axis), axis=-1)]
    across = np.cross(farthest, axis)
    unit: Array = across / np.linalg.norm(across, axis=-1, keepdims=True)
    return unit


def _generator(x: ArrayLike) -> Array:
    x = validation.array(x, "x")
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


# What follows is written for `sweep`: vectors are (3, m), matrices come as their columns, X[column, row] of shape (m,).


def _exp_rotation(omega: Array) -> Array:
    """Exponentials (3, 3, m) of rotation vectors (3, m)."""
    return _rodrigues(omega, *_cos_a_b(_length(omega)))


def _exp_motion(x: Array) -> Array:
    """Exponentials (4, 4, m) of twists (6, m)."""
    omega, v = x[:3], x[3:]
    theta = _length(omega)
    cos, a, b = _cos_a_b(theta)
    # Near 0 the error of 1 - a is divided by theta^2 and meets W^2, which shrinks as fast: no series is needed.
    c = (1 - a) / (theta * theta + TINY)
    X = np.zeros((4, 4, len(theta)))
    X[:3, :3] = _rodrigues(omega, cos, a, b)
    X[3, :3] = a * v + b * cross(omega, v) + c * dot(omega, v) * omega
    X[3, 3] = 1.0
    return X


def _cos_a_b(theta: Array) -> tuple[Array, Array, Array]:
    """cos(theta), a = sin(theta) / theta and b = (1 - cos(theta)) / theta^2, by the tangent of the half angle.

    It keeps every digit where 1 - cos(theta) would cancel, and costs half as much as a sine and a cosine.
    """
    half = validation.turn(theta) / 2
    t = np.tan(half)
    share = 1 / (1 + t * t)
    ratio = (t + TINY) / (half + TINY)
    return (1 - t * t) * share, ratio * share, ratio * ratio * share / 2


def _rodrigues(omega: Array, cos: Array, a: Array, b: Array) -> Array:
    """R = I + a W + b W^2, where W^2 = omega omega^T - theta^2 I makes it  cos(theta) I + a W + b omega omega^T."""
    R = (b * omega)[:, None] * omega
    R[[0, 1, 2], [0, 1, 2]] += cos
    around = (a * omega)[[2, 0, 1]]
    R[[0, 1, 2], [1, 2, 0]] += around
    R[[1, 2, 0], [0, 1, 2]] -= around
    return R


def _log_rotation(R: Array) -> Array:
    """Rotation vectors (3, m) of rotations (3, 3, m)."""
    half_omega, _, _ = _half_log(R)
    return 2 * half_omega


def _log_motion(X: Array) -> Array:
    """Twists (6, m) of poses (4, 4, m)."""
    u, half, cotangent = _half_log(X[:3, :3])
    p = X[3, :3]
    x = np.empty((6, X.shape[-1]))
    np.multiply(u, 2, out=x[:3])
    # With omega = 2u, the products with W and W^2 are those with u, and k theta^2 = 1 - cotangent.
    x[3:] = cotangent * p - cross(u, p) + (1 - cotangent) / (half * half + TINY) * dot(u, p) * u
    return x


def _half_log(R: Array) -> tuple[Array, Array, Array]:
    """omega / 2 as (3, m), theta / 2 and (theta / 2) cot(theta / 2) of rotations (3, 3, m), by their quaternions."""
    w, axis = _quaternion(R)
    sine = _length(axis)
    half = np.arctan2(sine, w)
    # Where there is no turn, w is 4 and axis is 0: half the angle is a quarter of what stands for its sine.
    stretch = (half + TINY) / (sine + 4 * TINY)
    return stretch * axis, half, stretch * w


def _quaternion(R: Array) -> tuple[Array, Array]:
    """Quaternions of rotations (3, 3, m), up to their length: w >= 0 as (m,), and (x, y, z) as (3, m).

    With the unit quaternion q = (w, x, y, z) of R, the matrix 4 q q^T is linear in R. Its columns 4w q, 4x q, 4y q and 4z q
    are multiples of q, and one that is not near zero has all its digits: the first up to 151 degrees, where 4w is 1, and the
    longest of the others beyond. There is no case for small angles, and none for angles near pi.
    """
    q = np.empty((4, R.shape[-1]))
    q[0] = 1 + R[0, 0] + R[1, 1] + R[2, 2]
    q[1:] = R[1, 2] - R[2, 1], R[2, 0] - R[0, 2], R[0, 1] - R[1, 0]
    beyond = np.flatnonzero(q[0] < 1 / 4)
    q[:, beyond] = _quaternion_of_long_turn(R.take(beyond, axis=2))
    return q[0], q[1:]


def _quaternion_of_long_turn(R: Array) -> Array:
    """Quaternions (4, m) up to their length, with w >= 0, by the longest of the columns 4x q, 4y q and 4z q."""
    (r11, r21, r31), (r12, r22, r32), (r13, r23, r33) = R
    xx, yy, zz = 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33
    wx, wy, wz = r32 - r23, r13 - r31, r21 - r12
    xy, xz, yz = r21 + r12, r13 + r31, r32 + r23
    # The entry on the diagonal is 4x^2, 4y^2 or 4z^2: where one is largest, so is its column.
    q = np.where(yy > xx, [wy, xy, yy, yz], [wx, xx, xy, xz])
    q = np.where(zz > np.maximum(xx, yy), [wz, xz, yz, zz], q)
    # q and -q are the same rotation; w >= 0 picks the shorter way round.
    return q * np.where(q[0] < 0, -1.0, 1.0)


def _length(u: Array) -> Array:
    """The lengths (m,) of vectors (k, m)."""
    return np.sqrt(dot(u, u))
