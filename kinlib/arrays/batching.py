"""Batches: a formula written for columns of numbers, swept over any number of poses or configurations.

NumPy is fast along memory. A formula for poses should therefore not see one pose after the other, but one *entry* after
the other: each entry of R, each component of a twist is a long row of its own, and every line of the formula is one sweep
over such rows. `sweep` lays a batch out in this way, a piece at a time, and puts the results back as they came.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CHUNK = 5000
"""Columns worked on at a time: a pose's sixteen rows of them fit in a core's cache, worth a factor of two on long batches.
No power of two, by which rows would begin at addresses for which a cache has few places."""

Pieces = Iterator[tuple[slice, Array]]
"""Parts of a batch, each laid out for a formula, with the slice that it is from."""


def pieces(x: Array, takes: tuple[int, ...]) -> Pieces:
    """Cut a batch (..., *takes) into pieces, each laid out for a formula: (*takes reversed, m).

    >>> [(piece, columns.shape) for piece, columns in pieces(np.zeros((9000, 3, 3)), (3, 3))]
    [(slice(0, 5000, None), (3, 3, 5000)), (slice(5000, 10000, None), (3, 3, 4000))]
    """
    elements = x.reshape(-1, *takes)
    for start in range(0, len(elements), CHUNK):
        piece = slice(start, start + CHUNK)
        yield piece, np.ascontiguousarray(elements[piece].T)


def sweep(
    formula: Callable[[Array], Array],
    x: Array,
    takes: tuple[int, ...],
    gives: tuple[int, ...],
    cut: Callable[[Array, tuple[int, ...]], Pieces] = pieces,
) -> Array:
    """Apply a formula to a batch (..., *takes), and bring its results together as (..., *gives).

    The formula is given m elements at a time with their axes reversed, (*takes reversed, m), and returns (*gives reversed,
    m): a matrix comes as its columns, R[0] is the x axis of every pose, and R[0, 2] the z component of each. Another way to
    `cut` the batch may refuse some of it.

    >>> lengths = sweep(lambda v: np.sqrt(v[0] ** 2 + v[1] ** 2), np.array([[3.0, 4.0], [5.0, 12.0]]), (2,), ())
    >>> lengths
    array([ 5., 13.])
    """
    results = np.empty((*x.shape[: x.ndim - len(takes)], *gives))
    for piece, columns in cut(x, takes):
        results.reshape(-1, *gives)[piece] = formula(columns).T
    return results


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
