"""Rigid motions as exponentials: the groups SO(3) and SE(3), and the twists that generate them.

A twist is (omega, v) stacked in one 6-vector, as in Modern Robotics. Every function takes any leading batch shape and
distinguishes the two groups by the last dimensions: 3 and 3x3 for rotations, 6 and 4x4 for rigid motions.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import tolerances, validation
from kinlib.arrays.batching import Chunks, apply_columnwise, cross, dot, split_into_chunks
from kinlib.arrays.codegen import columnwise_program, few_elements
from kinlib.arrays.validation import Array

TINY = np.finfo(float).tiny
"""Added to the numerator and the denominator of a quotient, it turns 0 / 0 into the limit, and changes no other value."""

FIRST_COLUMN_MIN = 1 / 4
"""For 4w^2 from here on, `log` uses the first column of 4 q q^T: up to 151 degrees."""

Formula = Callable[[NDArray[Any]], NDArray[Any]]
"""A formula for `apply_columnwise`."""


def hat(x: ArrayLike) -> Array:
    """Write a rotation vector or a twist as the matrix of so(3) or se(3) that represents it.

    (..., 3) -> (..., 3, 3), the skew-symmetric matrix with hat(w) u = w x u;
    (..., 6) -> (..., 4, 4), the matrix [[hat(omega), v], [0, 0]].

    Raises ValueError for any other last dimension, for a matrix that is already skew-symmetric, and for NaN or infinity.
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
    X = validation.array(X, "X")
    if X.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"X must have shape (..., 3, 3) or (..., 4, 4); got {X.shape}.")
    W = X[..., :3, :3]
    # The tolerance is relative to the largest entry: the rounding error of an entry of 1e9 would be a fault in one of 1.
    scale = np.maximum(1, np.abs(W).max(axis=(-2, -1), keepdims=True))
    if (np.abs(W + np.swapaxes(W, -1, -2)) > tolerances.ORTHONORMALITY_TOL * scale).any():
        raise ValueError(
            "The rotation block of X must be skew-symmetric, but it differs from minus its transpose. "
            "Is X a rotation? Then take its log first."
        )
    omega = W[..., [2, 0, 1], [1, 2, 0]]
    if X.shape[-1] == 3:
        return omega
    if (np.abs(X[..., 3, :]) > tolerances.ORTHONORMALITY_TOL).any():
        raise ValueError(
            "The last row of an se(3) matrix must be zero, but that of X is not. Is X a pose? Then take its log first."
        )
    return np.concatenate([omega, X[..., :3, 3]], axis=-1)


def exp(x: ArrayLike) -> Array:
    """Compute the matrix exponential of a rotation vector or a twist: the motion along it for one unit of time.

    (..., 3) -> (..., 3, 3):  R = I + a W + b W^2, Rodrigues' formula;
    (..., 6) -> (..., 4, 4):  the same R, and p = (I + b W + c W^2) v.

    Here theta = |omega|, W = hat(omega), a = sin(theta) / theta, b = (1 - cos(theta)) / theta^2 and
    c = (theta - sin(theta)) / theta^3. For a screw axis S and a joint value q, the factor of the PoE formula is exp(S q).

    Raises ValueError for any other last dimension, for a skew-symmetric 3x3 matrix, whose vee is meant, for NaN or infinity, and
    for an angle that double precision cannot resolve.
    Source: Modern Robotics, (3.51) and (3.88); "Forward kinematics II" calls the series that this sums the true form.

    >>> exp([0, 0, np.pi / 2, 0, 0, 0]).round(3) + 0.0
    array([[ 0., -1.,  0.,  0.],
           [ 1.,  0.,  0.,  0.],
           [ 0.,  0.,  1.,  0.],
           [ 0.,  0.,  0.,  1.]])
    """
    x = _generator(x)
    formula, shape = (_exp_rotation, (3, 3)) if x.shape[-1] == 3 else (_exp_motion, (4, 4))
    if few := few_elements(x, x.shape[-1]):
        return _apply_to_each(formula, few, x.shape[-1:]).reshape(x.shape[:-1] + shape)
    return apply_columnwise(formula, x, x.shape[-1:], shape, split=_split_into_resolvable_chunks)


def log(X: ArrayLike) -> Array:
    """Compute the rotation vector or the twist whose exponential is X: the motion that reaches X in one unit of time.

    (..., 3, 3) -> (..., 3); (..., 4, 4) -> (..., 6). The angle |omega| lies in [0, pi]. At exactly pi both omega and
    -omega are right, and the one whose largest component is positive is returned; of equally large components, the first
    decides.

    With W = hat(omega):  v = (I - W / 2 + k W^2) p,  k = (1 - (theta / 2) cot(theta / 2)) / theta^2.

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, 3.2.3.3 and (3.91), (3.92); the rotation is computed through its unit quaternion.

    >>> log(exp([0, 0, np.pi / 2, 1, 0, 0])).round(6)
    array([0.      , 0.      , 1.570796, 1.      , 0.      , 0.      ])
    """
    X = validation.matrices_3x3_or_4x4(X, "X")
    formula, size = (_log_rotation, 3) if X.shape[-1] == 3 else (_log_motion, 6)
    if few := validation.few_rigid_matrices(X):
        return _log_each(few, X.shape[-2:]).reshape(*X.shape[:-2], size)
    return apply_columnwise(formula, X, X.shape[-2:], (size,), split=validation.split_into_rigid_chunks)


def inverse(X: ArrayLike) -> Array:
    """Invert a rotation or a rigid motion: T_ab becomes T_ba.

    (..., 3, 3) -> (..., 3, 3), R^T;  (..., 4, 4) -> (..., 4, 4), [[R^T, -R^T p], [0, 1]].

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, (3.64).

    >>> inverse([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])[:3, 3] + 0.0
    array([-2.,  0.,  0.])
    """
    X = validation.matrices_3x3_or_4x4(X, "X")
    return _apply_to_rigid(_transpose if X.shape[-1] == 3 else _inverse_pose, X, X.shape[-1])


def adjoint(X: ArrayLike) -> Array:
    """Compute the adjoint, which changes the frame of twists: for T = T_ab, [Ad_T] takes twists in {b} to twists in {a}.

    (..., 4, 4) -> (..., 6, 6), [[R, 0], [hat(p) R, R]]; (..., 3, 3) -> (..., 3, 3), R itself.
    It satisfies hat(Ad_T x) = T hat(x) T^-1.

    Raises ValueError for a matrix that is not a rotation or a pose.
    Source: Modern Robotics, definition 3.20.

    >>> T = exp([0, 0, 0, 2, 0, 0])                 # two metres along x
    >>> adjoint(T) @ [0, 0, 1, 0, 0, 0]             # the same rotation about z, now with its moment
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    X = validation.matrices_3x3_or_4x4(X, "X")
    return _apply_to_rigid(np.copy if X.shape[-1] == 3 else _adjoint_of_pose, X, 3 if X.shape[-1] == 3 else 6)


def nearest_rotation(X: ArrayLike) -> Array:
    """Compute the rotation nearest to a matrix that is almost one, for example because its entries were rounded.

    (..., 3, 3) -> (..., 3, 3): with the singular value decomposition R = U D V^T, it is U V^T, the nearest one in the Frobenius norm.
    (..., 4, 4) -> (..., 4, 4): the same for the rotation of a pose; its position stays.

    Raises ValueError for another shape, for NaN, for a matrix whose entries differ from those of a rotation by more than 0.1, and
    for a reflection.
    Source: Horn, Hilden and Negahdaripour, Closed-form solution of absolute orientation using orthonormal matrices, 1988.

    >>> nearest_rotation([[0.7071, -0.7071, 0], [0.7071, 0.7071, 0], [0, 0, 1]])[0, 0]
    np.float64(0.7071067811865475)
    """
    X = validation.array(X, "X").copy()
    if X.shape[-2:] not in {(3, 3), (4, 4)}:
        raise ValueError(f"X must have shape (..., 3, 3) or (..., 4, 4); got {X.shape}.")
    R = X[..., :3, :3]
    U, _, Vt = np.linalg.svd(R)
    nearest = U @ Vt
    distance = np.abs(nearest - R).max(initial=0.0)
    if distance > tolerances.ROUNDED_ROTATION_TOL or (np.linalg.det(nearest) < 0).any():
        what = "a reflection" if distance <= tolerances.ROUNDED_ROTATION_TOL else f"one that differs by {distance:.2g}"
        raise ValueError(
            f"X must be almost a rotation, within {tolerances.ROUNDED_ROTATION_TOL} in each entry; got {what}. "
            "Are its columns the axes of the frame, right-handed and of length 1?"
        )
    if X.shape[-1] == 4 and (X[..., 3, :] != (0, 0, 0, 1)).any():
        raise ValueError("The last row of a pose must be 0 0 0 1; got another one. Is X transposed?")
    R[...] = nearest
    return X


def homogeneous(R: ArrayLike, p: ArrayLike) -> Array:
    """Write a homogeneous transformation from its rotation and its position: T = [[R, p], [0, 1]].

    R (..., 3, 3), p (..., 3), batch dimensions that broadcast -> (..., 4, 4). The columns of R are the axes of the frame.
    If you have the axes one by one, use `kinlib.chains.robots.pose`. R is not validated to be a rotation.

    Source: Modern Robotics, (3.62).

    >>> homogeneous(np.eye(3), [1, 2, 3])
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

    axis (..., 3), not zero -> (..., 3): the cross product of the axis with the coordinate axis at the largest angle to it, so
    that no digits are lost.

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
        if x.shape[-2:] == (4, 4):
            advice = "Is it the matrix of a twist? Then take its vee first, exp(vee(x))."
        elif x.ndim > 1 and x.shape[-2] in {3, 6}:
            advice = "Are the components in the first dimension? Try x.T."
        else:
            advice = "A twist is (omega, v), six numbers."
        raise ValueError(f"x must be a rotation vector (..., 3) or a twist (..., 6); got shape {x.shape}. {advice}")
    if x.shape == (3, 3) and x.any() and np.array_equal(x, -x.T):
        raise ValueError(
            "x must be a rotation vector (..., 3) or a twist (..., 6); got a skew-symmetric 3x3 matrix, which would be read as three "
            "rotation vectors. Take its vee first, exp(vee(x))."
        )
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


def _apply_to_rigid(formula: Formula, X: Array, size: int) -> Array:
    """Apply a formula to rotations or poses, and collect its square results (..., size, size); validate X first.

    Raises ValueError for a matrix that is not a rotation or a pose.
    """
    if few := validation.few_rigid_matrices(X):
        return _apply_to_each(formula, few, X.shape[-2:]).reshape(*X.shape[:-2], size, size)
    return apply_columnwise(formula, X, X.shape[-2:], (size, size), split=validation.split_into_rigid_chunks)


def _apply_to_each(formula: Formula, elements: list[list[float]], input_shape: tuple[int, ...]) -> Array:
    """Apply a formula to a few elements, one after the other, by generated code: a tenth of the time of an array for one."""
    run = columnwise_program(formula, input_shape)
    return np.array([run(*entries) for entries in elements])


def _log_each(matrices: list[list[float]], shape: tuple[int, ...]) -> Array:
    """Compute the logarithms of a few rotations or poses, given by their entries, one after the other.

    Generated code has no branches, so the column of the quaternion is selected between two programs.
    """
    columns = columnwise_program(_quaternion_columns, shape)
    quaternions = [_accurate_column(columns(*entries)) for entries in matrices]
    if shape == (3, 3):
        return _apply_to_each(_rotation_vector, quaternions, (4,))
    with_positions = [[*q, *entries[3:12:4]] for q, entries in zip(quaternions, matrices, strict=True)]
    return _apply_to_each(_twist_of_quaternion_and_position, with_positions, (7,))


def _accurate_column(columns: tuple[float, ...]) -> list[float]:
    """Select one of the columns of 4 q q^T as `_quaternion` does, with w >= 0."""
    k = 0 if columns[0] >= FIRST_COLUMN_MIN else max((5, 10, 15), key=columns.__getitem__) // 5
    q = columns[4 * k : 4 * k + 4]
    return [-x for x in q] if q[0] < 0 else list(q)


# The functions below are written for `apply_columnwise`: vectors are (3, m), and matrices are given by their columns, so that
# X[column, row] has shape (m,). For generated code m is 1, and the entries are tracers.


def _split_into_resolvable_chunks(x: Array, input_shape: tuple[int, ...]) -> Chunks:
    """Split rotation vectors or twists as `split_into_chunks` does, and refuse angles that double precision cannot resolve."""
    for chunk, columns in split_into_chunks(x, input_shape):
        with np.errstate(over="ignore"):  # an angle that overflows is refused, too
            validation.rotation_angles(_length(columns[:3]))
        yield chunk, columns


def _transpose(R: Array) -> Array:
    """The inverses (3, 3, m) of rotations."""
    return R.swapaxes(0, 1)


def _inverse_pose(X: Array) -> Array:
    """The inverses (4, 4, m) of poses."""
    R, p = X[:3, :3], X[3, :3]
    inverse = np.zeros_like(X)
    inverse[:3, :3] = R.swapaxes(0, 1)
    inverse[3, :3] = [-dot(axis, p) for axis in R]
    inverse[3, 3] = 1.0
    return inverse


def _adjoint_of_pose(X: Array) -> Array:
    """The adjoints (6, 6, m) of poses (4, 4, m)."""
    R, p = X[:3, :3], X[3, :3]
    Ad = np.zeros((6, 6, X.shape[-1]), dtype=X.dtype)
    Ad[:3, :3] = Ad[3:, 3:] = R
    Ad[:3, 3:] = [cross(p, axis) for axis in R]
    return Ad


def _exp_rotation(omega: Array) -> Array:
    """Exponentials (3, 3, m) of rotation vectors (3, m)."""
    return _rodrigues(omega, *_cos_a_b(_length(omega)))


def _exp_motion(x: Array) -> Array:
    """Exponentials (4, 4, m) of twists (6, m)."""
    omega, v = x[:3], x[3:]
    theta = _length(omega)
    cos, a, b = _cos_a_b(theta)
    # Near 0 the error of 1 - a is divided by theta^2, and multiplied by W^2, which shrinks as fast: no series is needed.
    c = (1 - a) / (theta * theta + TINY)
    X = np.zeros((4, 4, len(theta)), dtype=x.dtype)
    X[:3, :3] = _rodrigues(omega, cos, a, b)
    X[3, :3] = a * v + b * cross(omega, v) + c * dot(omega, v) * omega
    X[3, 3] = 1.0
    return X


def _cos_a_b(theta: Array) -> tuple[Array, Array, Array]:
    """Compute cos(theta), a = sin(theta) / theta and b = (1 - cos(theta)) / theta^2 from the tangent of the half angle.

    The tangent keeps every digit where 1 - cos(theta) would cancel, and costs half as much as a sine and a cosine.
    """
    half = theta / 2
    t = np.tan(half)
    cos_squared = 1 / (1 + t * t)
    ratio = (t + TINY) / (half + TINY)
    return (1 - t * t) * cos_squared, ratio * cos_squared, ratio * ratio * cos_squared / 2


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
    return _rotation_vector(_quaternion(R))


def _log_motion(X: Array) -> Array:
    """Twists (6, m) of poses (4, 4, m)."""
    return _twist(_quaternion(X[:3, :3]), X[3, :3])


def _rotation_vector(q: Array) -> Array:
    """Rotation vectors (3, m) of quaternions (4, m)."""
    half_omega, _, _ = _half_log(q)
    return 2 * half_omega


def _twist(q: Array, p: Array) -> Array:
    """Twists (6, m) of the poses with quaternions (4, m) and positions (3, m)."""
    u, half, cotangent = _half_log(q)
    x = np.empty((6, q.shape[-1]), dtype=q.dtype)
    np.multiply(u, 2, out=x[:3])
    # With omega = 2u, the products with W and W^2 are those with u, and k theta^2 = 1 - cotangent.
    x[3:] = cotangent * p - cross(u, p) + (1 - cotangent) / (half * half + TINY) * dot(u, p) * u
    return x


def _twist_of_quaternion_and_position(x: Array) -> Array:
    """The same for one array (7, m)."""
    return _twist(x[:4], x[4:])


def _half_log(q: Array) -> tuple[Array, Array, Array]:
    """omega / 2 as (3, m), theta / 2 and (theta / 2) cot(theta / 2) of quaternions (4, m) up to their length."""
    w, axis = q[0], q[1:]
    sine = _length(axis)
    half = np.arctan2(sine, w)
    # Without rotation, w is 4 and axis is 0, and half the angle is a quarter of `sine`: hence the factor 4.
    scale = (half + TINY) / (sine + 4 * TINY)
    return scale * axis, half, scale * w


def _quaternion(R: Array) -> Array:
    """Quaternions (4, m) of rotations (3, 3, m), up to their length, with w >= 0.

    With the unit quaternion q = (w, x, y, z) of R, the matrix 4 q q^T is linear in R. Its columns 4w q, 4x q, 4y q and 4z q
    are multiples of q, and a column that is not near zero has all its digits. Up to 151 degrees, where 4w is 1, the first
    column is used; beyond, the longest of the others. Neither small angles nor angles near pi are special cases.
    """
    q = np.empty((4, R.shape[-1]))
    q[0] = 1 + R[0, 0] + R[1, 1] + R[2, 2]
    q[1:] = R[1, 2] - R[2, 1], R[2, 0] - R[0, 2], R[0, 1] - R[1, 0]
    beyond = np.flatnonzero(q[0] < FIRST_COLUMN_MIN)
    columns = _quaternion_columns(R.take(beyond, axis=2))
    # The diagonal entries are 4x^2, 4y^2 and 4z^2, and the column of the largest one is the longest.
    longest = 1 + np.argmax([columns[1, 1], columns[2, 2], columns[3, 3]], axis=0)
    chosen = columns[longest, :, np.arange(len(beyond))].T
    # q and -q are the same rotation; w >= 0 selects the one whose angle is at most pi.
    q[:, beyond] = chosen * np.where(chosen[0] < 0, -1.0, 1.0)
    return q


def _quaternion_columns(X: Array) -> Array:
    """The matrix 4 q q^T, (4, 4, m), of rotations (3, 3, m), or of the rotations of poses (4, 4, m)."""
    (r11, r21, r31), (r12, r22, r32), (r13, r23, r33) = X[:3, :3]
    ww, xx, yy, zz = 1 + r11 + r22 + r33, 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33
    wx, wy, wz = r32 - r23, r13 - r31, r21 - r12
    xy, xz, yz = r21 + r12, r13 + r31, r32 + r23
    return np.array([[ww, wx, wy, wz], [wx, xx, xy, xz], [wy, xy, yy, yz], [wz, xz, yz, zz]])


def _length(u: Array) -> Array:
    """The lengths (m,) of vectors (k, m)."""
    return np.sqrt(dot(u, u))
