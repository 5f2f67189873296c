"""Batches: every element is processed once, whatever the shape of the batch."""

import numpy as np
import pytest

from kinlib.arrays.batching import CHUNK_COLUMNS, apply_columnwise, cross, dot, split_into_chunks


@pytest.mark.parametrize("shape", [(), (0,), (1,), (5,), (2, 3), (2, 0, 3), (CHUNK_COLUMNS,), (2 * CHUNK_COLUMNS + 1,)])
def test_a_batch_of_any_shape_is_transposed_element_by_element(shape):
    X = np.random.default_rng(0).normal(size=(*shape, 2, 3))
    transposed = apply_columnwise(lambda columns: columns.swapaxes(0, 1), X, (2, 3), (3, 2))
    np.testing.assert_array_equal(transposed, X.swapaxes(-1, -2))


def test_a_chunk_has_the_columns_of_each_matrix_in_contiguous_memory():
    X = np.random.default_rng(0).normal(size=(7, 3, 3))
    ((chunk, columns),) = split_into_chunks(X[::-1], (3, 3))
    assert columns.flags.c_contiguous
    np.testing.assert_array_equal(columns[0, 2], X[::-1][chunk, 2, 0])


def test_every_element_is_in_one_chunk_of_bounded_length():
    found = [columns for _, columns in split_into_chunks(np.arange(2.0 * CHUNK_COLUMNS + 3)[:, None], (1,))]
    assert [part.shape[-1] for part in found] == [CHUNK_COLUMNS, CHUNK_COLUMNS, 3]
    np.testing.assert_array_equal(np.concatenate(found, axis=-1)[0], np.arange(2.0 * CHUNK_COLUMNS + 3))


@pytest.mark.oracle("numpy", dot, cross)
def test_dot_and_cross_are_those_of_numpy():
    u, v = np.random.default_rng(0).normal(size=(2, 50, 3))
    np.testing.assert_allclose(dot(u.T, v.T), (u * v).sum(axis=1), rtol=1e-14, atol=1e-14)
    np.testing.assert_allclose(cross(u.T, v.T).T, np.cross(u, v), rtol=0, atol=1e-14)
    np.testing.assert_allclose(cross(u[0], v[0]), np.cross(u[0], v[0]), rtol=0, atol=1e-14)


@pytest.mark.oracle("numpy", apply_columnwise, split_into_chunks)
@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (CHUNK_COLUMNS + 1,)])
def test_determinants_of_a_batch_are_those_of_numpy(shape):
    X = np.random.default_rng(1).normal(size=(*shape, 3, 3))
    found = apply_columnwise(lambda columns: dot(columns[0], cross(columns[1], columns[2])), X, (3, 3), ())
    np.testing.assert_allclose(found, np.linalg.det(X), rtol=0, atol=1e-13)
    cut = [np.linalg.det(columns.T) for _, columns in split_into_chunks(X, (3, 3))]
    np.testing.assert_allclose(np.concatenate(cut), np.linalg.det(X).ravel(), rtol=0, atol=1e-13)
