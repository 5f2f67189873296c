"""Rigid motions in a few lines of NumPy, apart from kinlib, so that a fault of kinlib cannot hide in the census."""

from functools import reduce
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
I3, I4 = np.eye(3), np.eye(4)


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


def twist(S: Any) -> Array:
    """The matrix [S] (4, 4) of a twist (omega, v)."""
    return np.block([[hat(S[:3]), np.reshape(S[3:], (3, 1))], [np.zeros((1, 4))]])


def expm(A: Array) -> Array:
    """The matrix exponential: eighteen terms of the series of A / 2**s, squared s times.

    >>> expm(hat([0, 0, np.pi / 2])).round(6) + 0.0
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    s = max(0, int(np.ceil(np.log2(np.abs(A).sum() + 1e-300))))
    return np.linalg.matrix_power(series(A / 2**s, 18), 2**s)


def series(A: Array, terms: int) -> Array:
    """The first terms of the series of the matrix exponential."""
    term = total = np.eye(len(A))
    for k in range(1, terms):
        term = term @ A / k
        total = total + term
    return total


def exp(S: Any, q: float = 1.0) -> Array:
    """The exponential of S q: a rotation for S (3,), a pose for S (6,)."""
    S = np.asarray(S, dtype=float) * q
    return expm(hat(S) if S.shape == (3,) else twist(S))


def Ad(T: Any) -> Array:
    """The adjoint (6, 6) of a pose, for twists (omega, v) in columns."""
    R, p = parts(T)
    return np.block([[R, np.zeros((3, 3))], [hat(p) @ R, R]])


def rot(axis: Any, degrees: float) -> Array:
    """The rotation (3, 3) about a unit vector, or about axis number 0, 1 or 2."""
    w = I3[axis] if isinstance(axis, int) else np.asarray(axis)
    return exp(w, np.radians(degrees))


def product(*factors: Any) -> Array:
    """The matrix product of all factors."""
    return np.array(reduce(np.matmul, factors))


def negated(x: Any, *index: Any) -> Array:
    """A copy of x with the entries at these indices negated."""
    y = np.array(x, dtype=float)
    for i in index:
        y[i] = -y[i]
    return y


def negated_one(x: Any, which: int = 0) -> Array:
    """A copy of x with the sign of one of its entries wrong, which is not zero: the first one, the second one, ..."""
    places = [tuple(place) for place in np.argwhere(np.abs(x) > 0.01)]
    return negated(x, places[which % len(places)])


def swapped(x: Any, i: int, j: int, axis: int = 0) -> Array:
    """A copy of x with two entries, rows (axis 0) or columns (axis 1) swapped."""
    order = list(range(np.shape(x)[axis]))
    order[i], order[j] = j, i
    return np.take(np.array(x, dtype=float), order, axis=axis)


def halves_swapped(S: Any) -> Array:
    """Screws (..., 6) with (v, omega) for (omega, v)."""
    return np.roll(np.asarray(S, dtype=float), 3, axis=-1)
