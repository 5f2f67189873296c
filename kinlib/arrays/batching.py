"""Batches: apply a formula that is written for columns of numbers to any number of poses or configurations.

NumPy is fast along contiguous memory. A formula for poses should therefore not process one pose after the other, but one
*entry* after the other: each entry of R and each component of a twist is one long row, and every line of the formula is one
pass over such rows. `apply_columnwise` lays a batch out in this way, one chunk at a time, and restores the shape of the
results.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CHUNK_COLUMNS = 5000
"""Number of columns processed at a time: the sixteen rows of that many poses fit into a core's cache, which makes long batches
twice as fast. It is not a power of two, because then the rows would compete for the same few places in the cache."""

Chunks = Iterator[tuple[slice, Array]]
"""Parts of a batch, each laid out for a formula, with the slice of the batch that it comes from."""


def split_into_chunks(x: Array, input_shape: tuple[int, ...]) -> Chunks:
    """Split a batch (..., *input_shape) into chunks, each laid out for a formula: (*input_shape reversed, m).

    >>> [(chunk, columns.shape) for chunk, columns in split_into_chunks(np.zeros((9000, 3, 3)), (3, 3))]
    [(slice(0, 5000, None), (3, 3, 5000)), (slice(5000, 10000, None), (3, 3, 4000))]
    """
    elements = x.reshape(-1, *input_shape)
    for start in range(0, len(elements), CHUNK_COLUMNS):
        chunk = slice(start, start + CHUNK_COLUMNS)
        yield chunk, np.ascontiguousarray(elements[chunk].T)


def apply_columnwise(
    formula: Callable[[Array], Array],
    x: Array,
    input_shape: tuple[int, ...],
    output_shape: tuple[int, ...],
    split: Callable[[Array, tuple[int, ...]], Chunks] = split_into_chunks,
) -> Array:
    """Apply a formula to a batch (..., *input_shape), and collect its results as (..., *output_shape).

    The formula receives m elements at a time with their axes reversed, (*input_shape reversed, m), and returns
    (*output_shape reversed, m). So a matrix is given by its columns: R[0] is the x axis of every pose, and R[0, 2] the z
    component of each x axis. Another function to `split` the batch may also validate it, and raise an error.

    >>> lengths = apply_columnwise(lambda v: np.sqrt(v[0] ** 2 + v[1] ** 2), np.array([[3.0, 4.0], [5.0, 12.0]]), (2,), ())
    >>> lengths
    array([ 5., 13.])
    """
    results = np.empty((*x.shape[: x.ndim - len(input_shape)], *output_shape))
    for chunk, columns in split(x, input_shape):
        results.reshape(-1, *output_shape)[chunk] = formula(columns).T
    return results


def dot(u: Array, v: Array) -> Array:
    """Compute the scalar products (m,) of vectors (k, m).

    >>> dot(np.array([[3.0], [4.0]]), np.array([[3.0], [4.0]]))
    array([25.])
    """
    products: Array = (u * v).sum(axis=0)
    return products


def cross(u: Array, v: Array) -> Array:
    """Compute the cross products (3, m) of vectors (3, m).

    >>> cross(np.array([[1.0], [0.0], [0.0]]), np.array([[0.0], [1.0], [0.0]])).T
    array([[0., 0., 1.]])
    """
    (a, b, c), (x, y, z) = u, v
    # Each row is written directly into the result: stacking three finished rows would copy them. The "..." also makes this
    # work for a single vector, whose rows have shape ().
    products = np.empty_like(u)
    np.subtract(b * z, c * y, out=products[0, ...])
    np.subtract(c * x, a * z, out=products[1, ...])
    np.subtract(a * y, b * x, out=products[2, ...])
    return products
