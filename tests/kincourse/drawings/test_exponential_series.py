"""Drawings of the exponential series and of screw motions: they end where the exponential takes the point or frame."""

import mpmath
import mpmath_oracle
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from strategies import points, screws

from kincourse.lecture_02_matrix_exponential.drawings import draw_series
from kincourse.lecture_02_matrix_exponential.drawings.exponential_series import partial_sums


def test_four_terms_are_on_the_circle_at_the_root_of_three_and_not_at_the_goal():
    """|1 + i t - t^2/2 - i t^3/6| = 1 at t = sqrt(3), so the sum is a rotation, but the wrong one."""
    picture = draw_series((0, 0, 1, 0, 0, 0), np.sqrt(3), (1, 0, 0), 4)
    assert picture.caption == "4 terms: the sum is 0.36 m from its goal, less than 1e-12 m off the circle"


@given(screws(), st.floats(-3, 3), points())
def test_each_sum_is_a_sum_of_powers_with_40_digits(S, q, point):
    with mpmath.workdps(mpmath_oracle.DIGITS):
        X = mpmath_oracle.hat(mpmath_oracle.numbers(S)) * mpmath.mpf(q)
        start = mpmath.matrix([*mpmath_oracle.numbers(point), 1])
        sums, total = [], mpmath.zeros(4)
        for k in range(6):
            total += X**k / mpmath.factorial(k)
            sums.append(mpmath_oracle.doubles((total * start).T)[0, :3])
    np.testing.assert_allclose(partial_sums(S, q, point, 6), sums, rtol=0, atol=1e-12)
