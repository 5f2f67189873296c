"""The exponential with 40 digits: the series itself, summed by mpmath, in nothing but matrix products.

It shares no formula with the library: no sine, no branch, no small-angle case. What it says is rounded once.
"""

import mpmath
import numpy as np

DIGITS = 40


def hat(x):
    """The matrix of a rotation vector (3 numbers) or a twist (6), in mpmath."""
    wx, wy, wz, *v = x
    if not v:
        return mpmath.matrix([[0, -wz, wy], [wz, 0, -wx], [-wy, wx, 0]])
    return mpmath.matrix([[0, -wz, wy, v[0]], [wz, 0, -wx, v[1]], [-wy, wx, 0, v[2]], [0, 0, 0, 0]])


def exp(x):
    """exp of a rotation vector or twist of doubles, correctly rounded to doubles."""
    with mpmath.workdps(DIGITS):
        return doubles(mpmath.expm(hat([mpmath.mpf(float(value)) for value in x])))


def product_of_exponentials(screws, q, home):
    """e^[S1]q1 ... e^[Sn]qn M, multiplied with 40 digits and rounded once."""
    with mpmath.workdps(DIGITS):
        T = mpmath.eye(4)
        for S, value in zip(screws, q, strict=True):
            T = T * mpmath.expm(hat([mpmath.mpf(float(s)) * mpmath.mpf(float(value)) for s in S]))
        return doubles(T * mpmath.matrix(home.tolist()))


def doubles(matrix):
    return np.array(matrix.tolist(), dtype=float)
