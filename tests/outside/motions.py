"""Rigid motions, rows of tables and chains in a few lines of NumPy, so that a fault of kinlib cannot hide in the count."""

from functools import reduce
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
I3 = np.eye(3)


def hat(w: Any) -> Array:
    """The skew-symmetric matrix [w] (3, 3) of w (3,)."""
    x, y, z = w
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=float)


def pose(R: Any, p: Any) -> Array:
    """The pose (4, 4) with rotation R and position p."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def parts(T: Any) -> tuple[Array, Array]:
    """The rotation and the position of a pose."""
    return np.array(T)[:3, :3], np.array(T)[:3, 3]


def exp(S: Any, q: float = 1.0) -> Array:
    """The exponential of S q, a rotation for S (3,), a pose for S (6,): eighteen terms of A / 2**s, squared s times.

    >>> exp([0, 0, 1], np.pi / 2).round(6) + 0.0
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    S = np.asarray(S, dtype=float) * q
    A = hat(S[:3])
    if S.shape == (6,):
        A = np.block([[A, S[3:, None]], [np.zeros((1, 4))]])
    s = max(0, int(np.ceil(np.log2(np.abs(A).sum() + 1e-300))))
    term = total = np.eye(len(A))
    for k in range(1, 18):
        term = term @ A / 2**s / k
        total = total + term
    return np.linalg.matrix_power(total, 2**s)


def Ad(T: Any) -> Array:
    """The adjoint (6, 6) of a pose, for twists (omega, v) in columns."""
    R, p = parts(T)
    return np.block([[R, np.zeros((3, 3))], [hat(p) @ R, R]])


def rot(axis: Any, degrees: float) -> Array:
    """The rotation (3, 3) about a unit vector."""
    return exp(axis, np.radians(degrees))


def product(*factors: Any) -> Array:
    """The matrix product of all factors."""
    return np.array(reduce(np.matmul, factors))


def negated_one(x: Array) -> Array:
    """A copy of x with the wrong sign of its first entry that is not zero."""
    y = x.copy()
    y.flat[np.argmax(np.abs(x) > 0.01)] *= -1
    return y


def turn(axis: str, angle: float) -> Array:
    """The rotation (3, 3) about "x", "y" or "z" by an angle in radians."""
    return exp(I3["xyz".index(axis)], angle)


def logarithm(T: Array) -> Array:
    """The twist (6,) of a pose (4, 4), the inverse of `exp` for angles below pi.

    >>> logarithm(exp([0, 0, 1, 0, -2, 0])).round(9) + 0.0
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    R, p = parts(T)
    axial = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    sine = float(np.linalg.norm(axial))
    angle = float(np.arctan2(sine, (np.trace(R) - 1) / 2))
    w = axial * (angle / sine if sine > 1e-12 else 1.0)
    columns = np.column_stack([exp([*w, *v])[:3, 3] for v in I3])
    return np.concatenate([w, np.linalg.solve(columns, p)])


def link(row: Any, convention: str) -> Array:
    """The pose (4, 4) of one DH row a, alpha, d, theta, as a product of a motion along x and one along z.

    >>> link((1, 0, 0, np.pi / 2), "standard").round(6)[:3, 3]
    array([0., 1., 0.])
    """
    a, alpha, d, theta = row
    along_x, along_z = pose(turn("x", alpha), (a, 0, 0)), pose(turn("z", theta), (0, 0, d))
    return along_z @ along_x if convention == "standard" else along_x @ along_z


def chain(rows: Any, convention: str) -> Array:
    """The pose (4, 4) of the last frame of a table (m, 4) in frame 0."""
    return product(*(link(row, convention) for row in rows))


def at(rows: Any, joints: str, q: Any) -> Array:
    """The rows (m, 4) with joint values q (m,) added to theta where the letter is R, and to d where it is P.

    >>> at([[1, 0, 0, 0]], "P", [0.5])
    array([[1. , 0. , 0.5, 0. ]])
    """
    moved = np.array(rows, dtype=float)
    for i, letter in enumerate(joints):
        moved[i, 3 if letter == "R" else 2] += q[i]
    return moved


def rpy_matrix(rpy: Any, order: str = "zyx") -> Array:
    """The rotation by roll, pitch and yaw."""
    angles = dict(zip("xyz", rpy, strict=True))
    return product(*(turn(k, angles[k]) for k in order))
