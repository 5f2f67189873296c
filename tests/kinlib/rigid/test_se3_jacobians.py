"""The inverse left Jacobian of SE(3): the Bernoulli series with 40 digits, an integral by SciPy, Pinocchio, and what is refused."""

import mpmath
import mpmath_oracle
import numpy as np
import pytest

from kinlib.rigid.se3_jacobians import left_jacobian_inverse

EXACT = 1e-13
ANGLES = [0.0, 1e-12, 1e-7, 1e-3, 0.1, 0.5, 1.0, 2.0, 3.0, np.pi - 1e-7, np.pi]


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def twists_of_angle(angle, count=3):
    rng = np.random.default_rng(8)
    omega = rng.normal(size=(count, 3))
    omega *= angle / np.linalg.norm(omega, axis=1, keepdims=True)
    return np.concatenate([omega, rng.uniform(-1, 1, (count, 3))], axis=1)


def bracket(x):
    """ad with 40 digits, column by column from its definition: hat(x) hat(y) - hat(y) hat(x)."""
    X = mpmath_oracle.hat(mpmath_oracle.numbers(x))
    columns = []
    for y in np.eye(6):
        Y = mpmath_oracle.hat(mpmath_oracle.numbers(y))
        Z = X * Y - Y * X
        columns.append([Z[2, 1], Z[0, 2], Z[1, 0], Z[0, 3], Z[1, 3], Z[2, 3]])
    return mpmath.matrix(columns).T


def bernoulli_series(x):
    """I - A/2 + B_2 A^2 / 2! + B_4 A^4 / 4! + ..., 40 terms: at half a turn each is a quarter of the one before it."""
    with mpmath.workdps(mpmath_oracle.DIGITS):
        A = bracket(x)
        square, term, total = A * A, mpmath.eye(6), mpmath.eye(6) - A / 2
        for k in range(2, 82, 2):
            term = term * square / (k * (k - 1))
            total += mpmath.bernoulli(k) * term
        return mpmath_oracle.doubles(total)


# --- left_jacobian_inverse ---


@pytest.mark.parametrize("angle", ANGLES)
def test_left_jacobian_inverse_is_the_bernoulli_series_to_1e_13(angle):
    x = twists_of_angle(angle)
    close(left_jacobian_inverse(x), [bernoulli_series(row) for row in x])
