"""Levenberg-Marquardt: against SciPy's least squares, on systems that are over- or underdetermined or dependent."""

import numpy as np
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import root

from kinlib.mechanisms.levenberg_marquardt import RANK_RTOL, is_nonzero, null_space, solve


def close(got, expected, atol=1e-12):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def rosenbrock(x):
    """(10 (y - x^2), 1 - x), 0 at (1, 1): a banana-shaped valley in which plain Gauss-Newton leaps about."""
    r = np.stack([10 * (x[:, 1] - x[:, 0] ** 2), 1 - x[:, 0]], axis=-1)
    J = np.zeros((len(x), 2, 2))
    J[:, 0, 0], J[:, 0, 1], J[:, 1, 0] = -20 * x[:, 0], 10, -1
    return r, J


def test_solve_finds_the_solution_that_scipy_finds():
    guesses = np.random.default_rng(1).uniform(-3, 3, (20, 2))
    found = solve(rosenbrock, guesses, tolerance=1e-13)
    assert (found.residual <= 1e-13).all()
    oracle = [
        root(lambda x: rosenbrock(x[None])[0][0], guess, method="lm", options={"xtol": 1e-15}).x for guess in guesses
    ]
    close(found.x, oracle)


@given(st.integers(1, 6), st.integers(1, 6), st.integers(0, 6), st.integers(0, 99))
def test_null_space_is_scipy_s(rows, columns, rank, seed):
    rng = np.random.default_rng(seed)
    J = rng.normal(size=(rows, rank)) @ rng.normal(size=(rank, columns))
    directions, values = null_space(J)
    oracle = scipy.linalg.null_space(J, rcond=RANK_RTOL)
    close(directions @ directions.T, oracle @ oracle.T, atol=1e-9)
    assert values.shape == (columns,)
    assert (np.diff(values) <= 0).all()
    assert np.count_nonzero(is_nonzero(values)) == columns - directions.shape[1]
