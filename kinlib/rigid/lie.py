"""Rigid motions as exponentials: the groups SO(3) and SE(3), and the twists that generate them.

A twist is (omega, v) stacked in one 6-vector, as in Modern Robotics. Every function takes any leading batch shape and
distinguishes the two groups by the last dimensions: 3 and 3x3 for rotations, 6 and 4x4 for rigid motions.

Every function of an `ArrayLike` raises ValueError for another shape, for NaN or infinity, for a matrix that is not a rotation or a
pose where one is needed, and for a skew-symmetric matrix, whose vee is meant, where a rotation vector is.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array

SERIES_BELOW_RAD = 1e-4
"""For smaller angles, coefficients that divide by theta^2 are the first two terms of their series; the third is below 1e-17."""


def hat(x: ArrayLike) -> Array:
    """Write a rotation vector or a twist as the matrix of so(3) or se(3) that represents it.

    (..., 3) -> (..., 3, 3), the skew-symmetric matrix with hat(w) u = w x u;
    (..., 6) -> (..., 4, 4), the matrix [[hat(omega), v], [0, 0]].

    Source: Modern Robotics, (3.30) and (3.71).

    >>> hat([0, 0, 1]) @ [1, 0, 0]
    array([0., 1., 0.])
    """
    return _hat(_generator(x))


def vee(X: ArrayLike) -> Array:
    """Read the rotation vector or the twist from its matrix: the inverse of hat.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6).

    Raises ValueError for a matrix outside so(3) and se(3): its rotation block is not skew-symmetric, or its last row is not zero.
    Source: Modern Robotics, (3.30) and (3.71).

    >>> vee(hat([1, 2, 3, 4, 5, 6]))
    array([1., 2., 3., 4., 5., 6.])
    """
    X = _square(X)
    omega = X[..., [2, 0, 1], [1, 2, 0]]
    x = omega if X.shape[-1] == 3 else np.concatenate([omega, X[..., :3, 3]], axis=-1)
    # The tolerance is relative to the largest entry: the rounding error of an entry of 1e9 would be a fault in one of 1.
    scale = np.maximum(1, np.abs(X).max(axis=(-2, -1), keepdims=True))
    if (np.abs(_hat(x) - X) > tolerances.ORTHONORMALITY_TOL * scale).any():
        raise ValueError(
            "X must be skew-symmetric, with a last row of zeros if it is 4x4. Is X a rotation or a pose? Then take its log first."
        )
    return x


def exp(x: ArrayLike) -> Array:
    """Compute the matrix exponential of a rotation vector or a twist: the motion along it for one unit of time.

    (..., 3) -> (..., 3, 3):  R = I + a W + b W^2, Rodrigues' formula;
    (..., 6) -> (..., 4, 4):  the same R, and p = (I + b W + c W^2) v.

    Here theta = |omega|, W = hat(omega), a = sin(theta) / theta, b = (1 - cos(theta)) / theta^2 and
    c = (theta - sin(theta)) / theta^3. For a screw axis S and a joint value q, the factor of the PoE formula is exp(S q).

    Raises ValueError for an angle that double precision cannot resolve.
    Source: Modern Robotics, (3.51) and (3.88); "Forward kinematics II" calls the series that this sums the true form.

    >>> exp([0, 0, np.pi / 2])[:, 0].round(3) + 0.0
    array([0., 1., 0.])
    """
    x = _generator(x)
    with np.errstate(over="ignore"):  # an angle that overflows is refused, too
        theta = validation.rotation_angles(_length(x[..., :3]))[..., None, None]
    small = theta < SERIES_BELOW_RAD
    t = np.where(small, 1.0, theta)
    a = np.where(small, 1 - theta**2 / 6, np.sin(t) / t)
    b = np.where(small, 1 / 2 - theta**2 / 24, 2 * np.sin(t / 2) ** 2 / t**2)  # 1 - cos(t), without its cancellation
    c = np.where(small, 1 / 6 - theta**2 / 120, (t - np.sin(t)) / t**3)

    W, identity = _hat(x[..., :3]), np.eye(3)
    W2 = W @ W
    R = identity + a * W + b * W2
    if x.shape[-1] == 3:
        return R
    p = (identity + b * W + c * W2) @ x[..., 3:, None]
    return homogeneous(R, p[..., 0])


def log(X: ArrayLike) -> Array:
    """Compute the rotation vector or the twist whose exponential is X: the motion that reaches X in one unit of time.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6). The angle |omega| lies in [0, pi]. At exactly pi both omega and
    -omega are right, and the one whose largest component is positive is returned; of equally large components, the first
    decides.

    With W = hat(omega):  v = (I - W / 2 + k W^2) p,  k = (1 - (theta / 2) cot(theta / 2)) / theta^2.

    The screw axis of the motion is the whole twist divided by its angle |omega|, or by |v| if omega is 0: see kl.line.

    Source: Modern Robotics, 3.2.3.3 and (3.91), (3.92); the rotation is computed through its unit quaternion.

    >>> log(exp([0, 0, np.pi / 2, 1, 0, 0])).round(6) + 0.0
    array([0.      , 0.      , 1.570796, 1.      , 0.      , 0.      ])
    """
    X = validation.rotations_or_poses(X, "X")
    q = _quaternion(X[..., :3, :3])
    w, axis = q[..., :1], q[..., 1:]
    sine = _length(axis)[..., None]
    half = np.arctan2(sine, w)  # theta / 2
    per_sine = np.where(sine > 0, half, 1.0) / np.where(sine > 0, sine, w)  # half / sine, and its limit, 1 / w
    omega = 2 * per_sine * axis
    if X.shape[-1] == 3:
        return omega
    small = half < SERIES_BELOW_RAD
    k = np.where(small, 1 / 12 + half**2 / 180, (1 - per_sine * w) / np.where(small, 1.0, 2 * half) ** 2)
    W, p = _hat(omega), X[..., :3, 3:]
    v = p - W @ p / 2 + k[..., None] * (W @ (W @ p))
    return np.concatenate([omega, v[..., 0]], axis=-1)


def inverse(X: ArrayLike) -> Array:
    """Invert a rotation or a rigid motion: T_ab becomes T_ba.

    (..., 3, 3) -> (..., 3, 3), R^T;  (..., 4, 4) -> (..., 4, 4), [[R^T, -R^T p], [0, 1]].

    Source: Modern Robotics, (3.64).

    >>> inverse([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])[:3, 3] + 0.0
    array([-2.,  0.,  0.])
    """
    X = validation.rotations_or_poses(X, "X")
    Rt = np.swapaxes(X[..., :3, :3], -1, -2)
    return Rt.copy() if X.shape[-1] == 3 else homogeneous(Rt, -(Rt @ X[..., :3, 3:])[..., 0])


def adjoint(X: ArrayLike) -> Array:
    """Compute the adjoint, which changes the frame of twists: for T = T_ab, [Ad_T] takes twists in {b} to twists in {a}.

    (..., 4, 4) -> (..., 6, 6), [[R, 0], [hat(p) R, R]]; (..., 3, 3) -> (..., 3, 3), R itself.
    It satisfies hat(Ad_T x) = T hat(x) T^-1.

    Source: Modern Robotics, definition 3.20.

    >>> T = exp([0, 0, 0, 2, 0, 0])                 # two metres along x
    >>> adjoint(T) @ [0, 0, 1, 0, 0, 0]             # the same rotation about z, now with its moment
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    X = validation.rotations_or_poses(X, "X")
    R = X[..., :3, :3]
    if X.shape[-1] == 3:
        return R.copy()
    Ad = np.zeros((*X.shape[:-2], 6, 6))
    Ad[..., :3, :3] = Ad[..., 3:, 3:] = R
    Ad[..., 3:, :3] = _hat(X[..., :3, 3]) @ R
    return Ad


def ad(x: ArrayLike) -> Array:
    """Write the Lie bracket with a twist x as a matrix, 6x6: the adjoint representation of se(3).

    (..., 6) -> (..., 6, 6), [[hat(omega), 0], [hat(v), hat(omega)]], so that hat(ad(x) y) = hat(x) hat(y) - hat(y) hat(x).
    ad(x) y = [x, y] is the velocity at which the motion along x changes y.

    Source: Modern Robotics, definition 8.1.

    >>> ad([0, 0, 1, 0, 0, 0]) @ [1, 0, 0, 0, 0, 0]       # a rotation about z moves an axis along x towards y
    array([0., 1., 0., 0., 0., 0.])
    """
    x = validation.vectors(x, "x", 6)
    matrix = np.zeros((*x.shape[:-1], 6, 6))
    matrix[..., :3, :3] = matrix[..., 3:, 3:] = _hat(x[..., :3])
    matrix[..., 3:, :3] = _hat(x[..., 3:])
    return matrix


def left_jacobian_inverse(x: ArrayLike) -> Array:
    """Write the inverse of the left Jacobian of SE(3): how log(E) changes when E = exp(x) is followed by a small twist V.

    (..., 6) -> (..., 6, 6), J(x)^-1 with log(exp(V) E) = x + J(x)^-1 V + O(V^2):  J(x)^-1 = I - A/2 + b A^2 + c A^4,  A = ad(x).

    The angle of x must be at most pi, as that of each twist which log returns.
    Source: the series A / (exp(A) - 1); of its even part, (theta / 2) cot(theta / 2), value and slope give b and c.

    >>> left_jacobian_inverse([0, 0, 0, 1, 2, 0])[3:, 2]  # beside a translation by p, V about z: z x p / 2
    array([-1. ,  0.5,  0. ])
    """
    A = ad(x)
    half = _length(A[..., [2, 0, 1], [1, 2, 0]])[..., None, None] / 2
    small = half < 0.02
    t = np.where(small, 1.0, half)
    value, slope = 1 - t / np.tan(t), (t / np.sin(t)) ** 2 - t / np.tan(t)  # of 1 - t cot(t)
    b = np.where(small, 1 / 12 - half**4 / 1890, (4 * value - slope) / (8 * t**2))
    c = np.where(small, -1 / 720 - half**2 / 3780, (2 * value - slope) / (32 * t**4))
    squared = A @ A
    return np.asarray(np.eye(6) - A / 2 + b * squared + c * squared @ squared)


def exponentials(S: Array, q: Array) -> Array:
    """Compute the factors e^[S_1]q_1, ..., e^[S_n]q_n of the PoE formula, with the joint in the first dimension.

    Screw axes S (n, 6), joint values q (..., n) -> (n, ..., 4, 4). For |omega| = 1 the angle of S q is q, and

        e^[S]q = I + q D + sin(q) ([S] - D) + (1 - cos(q)) [S]^2,    D = [S] + [S]^3,

    where D is the translation along the axis for each radian. For a prismatic joint [S]^2 = 0, and I + q [S] is left.
    The screw axes are not validated: `kinlib.rigid.screw.axes` does that.

    Source: Modern Robotics, (3.51) and (3.88): R = I + sin(q) W + (1 - cos(q)) W^2, p = (I q + (1 - cos(q)) W + (q - sin(q)) W^2) v.

    >>> exponentials(np.array([[0, 0, 1, 0, -1, 0]]), np.array([np.pi / 2])).round(3)[0, :3, 3]
    array([ 1., -1.,  0.])
    """
    S1 = _hat(S)
    S2 = S1 @ S1
    D = S1 + S2 @ S1
    D[:, :3, :3] = 0.0  # W + W^3, up to rounding
    matrices = np.stack([np.broadcast_to(np.eye(4), S1.shape), D, S1 - D, S2], axis=-1).reshape(len(S), 16, 4)
    angle = np.moveaxis(q, -1, 0)
    flat = angle.reshape(len(S), math.prod(q.shape[:-1]))
    numbers = np.stack([np.ones_like(flat), flat, np.sin(flat), 1 - np.cos(flat)], axis=1)
    factors = (matrices @ numbers).reshape(len(S), 4, 4, *angle.shape[1:])
    return np.moveaxis(factors, (1, 2), (-2, -1))


def compose(A: Array, B: Array) -> Array:
    """Compute the product A B of poses (..., 4, 4) with batch dimensions that broadcast; they are not validated.

    It is A @ B, and faster where the same entry of all configurations lies side by side in memory, as `exponentials` puts it.

    >>> compose(exp([0, 0, 0, 1, 0, 0]), exp([0, 0, 0, 0, 2, 0]))[:3, 3]
    array([1., 2., 0.])
    """
    product: Array = np.einsum("...ij,...jk->...ik", A, B)
    return product


def moved_screw(T: Array, S: Array) -> Array:
    """Compute a screw axis after motions: Ad(T) S = (R omega, R v + p x R omega).

    T (..., 4, 4), S (6,) -> (..., 6). The poses are not validated; `adjoint` is the matrix Ad(T).

    Source: Modern Robotics, definition 3.20.

    >>> moved_screw(homogeneous(np.eye(3), [2, 0, 0]), np.array([0, 0, 1, 0, 0, 0])) + 0.0
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    omega, v = (np.einsum("...ij,j->...i", T[..., :3, :3], part) for part in (S[:3], S[3:]))
    return np.concatenate([omega, v + cross(T[..., :3, 3], omega)], axis=-1)


def nearest_rotation(X: ArrayLike) -> Array:
    """Compute the rotation nearest to a matrix that is almost one, for example because its entries were rounded.

    (..., 3, 3) -> (..., 3, 3): with the singular value decomposition R = U D V^T, it is U V^T, the nearest one in the Frobenius norm.
    (..., 4, 4) -> (..., 4, 4): the same for the rotation of a pose; its position stays.

    Raises ValueError for a reflection, and for a matrix that differs by more than 0.1 in an entry.
    Source: Horn, Hilden and Negahdaripour, Closed-form solution of absolute orientation using orthonormal matrices, 1988.

    >>> nearest_rotation([[0.7071, -0.7071, 0], [0.7071, 0.7071, 0], [0, 0, 1]])[0, 0]
    np.float64(0.7071067811865475)
    """
    X = _square(X).copy()
    R = X[..., :3, :3]
    U, _, Vt = np.linalg.svd(R)
    nearest = U @ Vt
    distance = np.abs(nearest - R).max(initial=0.0)
    if distance > 0.1 or (np.linalg.det(nearest) < 0).any():
        raise ValueError(f"X must be almost a right-handed rotation, to 0.1 in an entry; it differs by {distance:.2g}.")
    R[...] = nearest
    return X


def homogeneous(R: ArrayLike, p: ArrayLike) -> Array:
    """Write a homogeneous transformation from its rotation and its position: T = [[R, p], [0, 1]].

    R (..., 3, 3), p (..., 3), batch dimensions that broadcast -> (..., 4, 4). The columns of R are the axes of the frame.
    If you have the axes one by one, use `kinlib.chains.robots.pose`. R is not validated to be a rotation.

    Source: Modern Robotics, (3.62).

    >>> homogeneous(np.eye(3), [1, 2, 3])[:, 3]
    array([1., 2., 3., 1.])
    """
    R, p = np.asarray(R, dtype=float), np.asarray(p, dtype=float)
    T = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1.0
    return T


def cross(u: Array, v: Array) -> Array:
    """Compute the cross products (..., 3) of vectors (..., 3): np.cross would take ten times as long for one pair.

    >>> cross(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))
    array([0., 0., 1.])
    """
    product: Array = u[..., [1, 2, 0]] * v[..., [2, 0, 1]] - u[..., [2, 0, 1]] * v[..., [1, 2, 0]]
    return product


def perpendicular(axis: ArrayLike) -> Array:
    """Choose a unit vector perpendicular to an axis, the same one every time.

    axis (..., 3), not zero -> (..., 3): the cross product of the axis with the coordinate axis at the largest angle to it, so
    that no digits are lost.

    >>> perpendicular([0, 3, 0])
    array([0., 0., 1.])
    """
    axis = np.asarray(axis, dtype=float)
    farthest = np.eye(3)[np.argmin(np.abs(axis), axis=-1)]
    across = cross(farthest, axis)
    unit: Array = across / np.linalg.norm(across, axis=-1, keepdims=True)
    return unit


def wrap_angle(angle: ArrayLike) -> Array:
    """Wrap angles into the interval (-pi, pi] by adding multiples of a full turn.

    angle (...) in radians -> (...). An angle that is in the interval already is returned unchanged, to the last bit.

    >>> wrap_angle([-np.pi, 7.0]).round(4)
    array([3.1416, 0.7168])
    """
    angle = np.asarray(angle, dtype=float)
    # Near -pi the quotient is rounded to -1/2, so the formula would change angles that are in the interval already.
    is_inside = (-np.pi < angle) & (angle <= np.pi)
    return np.where(is_inside, angle, angle - 2 * np.pi * np.ceil(angle / (2 * np.pi) - 0.5))


def _generator(x: ArrayLike) -> Array:
    x = validation.array(x, "x")
    if x.shape[-1:] not in {(3,), (6,)}:
        raise ValueError(
            f"x must be a rotation vector (..., 3) or a twist (..., 6); got shape {x.shape}. Try x.T, or the vee of a matrix."
        )
    if x.shape == (3, 3) and x.any() and np.array_equal(x, -x.T):
        raise ValueError("x must be a rotation vector or a twist; got a skew-symmetric matrix. Take exp(vee(x)).")
    return x


def _square(X: ArrayLike) -> Array:
    X = validation.array(X, "X")
    if X.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"X must have shape (..., 3, 3) or (..., 4, 4); got {X.shape}.")
    return X


def _hat(x: Array) -> Array:
    if x.shape[-1] == 6:
        X = np.zeros((*x.shape[:-1], 4, 4))
        X[..., :3, :3] = _hat(x[..., :3])
        X[..., :3, 3] = x[..., 3:]
        return X
    W = np.zeros((*x.shape, 3))
    W[..., [2, 0, 1], [1, 2, 0]] = x
    return W - np.swapaxes(W, -1, -2)


def _quaternion(R: Array) -> Array:
    """Compute the quaternions (..., 4) of rotations (..., 3, 3), up to their length, with w >= 0.

    With the unit quaternion q = (w, x, y, z) of R, the matrix 4 q q^T is linear in R. Its columns 4w q, 4x q, 4y q and 4z q
    are multiples of q, and the longest one has all its digits. Neither small angles nor angles near pi are special cases.
    """
    (r11, r12, r13), (r21, r22, r23), (r31, r32, r33) = np.moveaxis(R, (-2, -1), (0, 1))
    ww, xx, yy, zz = 1 + r11 + r22 + r33, 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33
    wx, wy, wz = r32 - r23, r13 - r31, r21 - r12
    xy, xz, yz = r21 + r12, r13 + r31, r32 + r23
    columns = np.array([[ww, wx, wy, wz], [wx, xx, xy, xz], [wy, xy, yy, yz], [wz, xz, yz, zz]])
    # The diagonal entries are 4w^2, 4x^2, 4y^2 and 4z^2, and the column of the largest one is the longest.
    longest = np.argmax([ww, xx, yy, zz], axis=0)
    q = np.moveaxis(np.take_along_axis(columns, longest[None, None], axis=0)[0], 0, -1)
    # q and -q are the same rotation; w >= 0 selects the one whose angle is at most pi.
    quaternion: Array = np.where(q[..., :1] < 0, -q, q)
    return quaternion


def _length(u: Array) -> Array:
    length: Array = np.sqrt(np.einsum("...i,...i", u, u))
    return length
