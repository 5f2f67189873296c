"""Batches: a formula written for columns of numbers, swept over any number of poses or configurations.

NumPy is fast along memory. A formula for poses should therefore not see one pose after the other, but one *entry* after
the other: each entry of R, each component of a twist is a long row of its own, and every line of the formula is one sweep
over such rows. `sweep` lays a batch out in this way, a piece at a time, and puts the results back as they came.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CHUNK = 8192
"""Columns worked on at a time: a pose's sixteen rows of them fit in a core's cache, worth a factor of two on long batches."""


def sweep(formula: Callable[[Array], Array], x: Array, takes: tuple[int, ...], gives: tuple[int, ...]) -> Array:
    """Apply a formula to a batch (..., *takes), and bring its results together as (..., *gives).

    The formula is given m elements at a time with their axes reversed, (*takes reversed, m), and returns (*gives reversed,
    m): a matrix comes as its columns, R[0] is the x axis of every pose, and R[0, 2] the z component of each.

    >>> lengths = sweep(lambda v: np.sqrt(v[0] ** 2 + v[1] ** 2), np.array([[3.0, 4.0], [5.0, 12.0]]), (2,), ())
    >>> lengths
    array([ 5., 13.])
    """
    results = np.empty((*x.shape[: x.ndim - len(takes)], *gives))
    for piece, columns in pieces(x, takes):
        results.reshape(-1, *gives)[piece] = formula(columns).T
    return results


def pieces(x: Array, takes: tuple[int, ...]) -> Iterator[tuple[slice, Array]]:
    """Cut a batch (..., *takes) into pieces, each laid out for a formula, (*takes reversed, m), with the slice it is from.

    >>> [(piece, columns.shape) for piece, columns in pieces(np.zeros((9000, 3, 3)), (3, 3))]
    [(slice(0, 8192, None), (3, 3, 8192)), (slice(8192, 16384, None), (3, 3, 808))]
    """
    elements = x.reshape(-1, *takes)
    for start in range(0, len(elements), CHUNK):
        piece = slice(start, start + CHUNK)
        yield piece, np.ascontiguousarray(elements[piece].T)


def dot(u: Array, v: Array) -> Array:
    """The scalar products (m,) of vectors (k, m).

    >>> dot(np.array([[3.0], [4.0]]), np.array([[3.0], [4.0]]))
    array([25.])
    """
    products: Array = np.einsum("im,im->m", u, v)
    return products


def cross(u: Array, v: Array) -> Array:
    """The vector products (3, m) of vectors (3, m).

    >>> cross(np.array([[1.0], [0.0], [0.0]]), np.array([[0.0], [1.0], [0.0]])).T
    array([[0., 0., 1.]])
    """
    (a, b, c), (x, y, z) = u, v
    # Each row is written where it belongs: to collect three finished ones would copy them. One vector has rows of shape ().
    products = np.empty_like(u)
    np.subtract(b * z, c * y, out=products[0, ...])
    np.subtract(c * x, a * z, out=products[1, ...])
    np.subtract(a * y, b * x, out=products[2, ...])
    return products
