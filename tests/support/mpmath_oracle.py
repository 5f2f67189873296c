"""The exponential with 40 digits: the series itself, summed by mpmath, in nothing but matrix products.

It shares no formula with the library: no sine, no branch, no small-angle case. What it says is rounded once.
"""

import mpmath
import numpy as np

DIGITS = 40


def exp(x):
    """exp of a rotation vector or a twist."""
    with mpmath.workdps(DIGITS):
        return doubles(mpmath.expm(hat(numbers(x))))


def fk(chain, q):
    """e^[S1]q1 ... e^[Sn]qn M, as it stands."""
    with mpmath.workdps(DIGITS):
        return doubles(product(chain, numbers(q)))


def hat(x):
    """The matrix of a rotation vector (3 numbers) or a twist (6)."""
    wx, wy, wz, *v = x
    if not v:
        return mpmath.matrix([[0, -wz, wy], [wz, 0, -wx], [-wy, wx, 0]])
    return mpmath.matrix([[0, -wz, wy, v[0]], [wz, 0, -wx, v[1]], [-wy, wx, 0, v[2]], [0, 0, 0, 0]])


def product(chain, q):
    T = mpmath.eye(4)
    for S, value in zip(chain.screws, q, strict=True):
        T = T * mpmath.expm(hat(numbers(S)) * value)
    return T * mpmath.matrix(chain.home.tolist())


def numbers(x):
    return [mpmath.mpf(float(value)) for value in x]


def doubles(matrix):
    return np.array(matrix.tolist(), dtype=float)


def log(T):
    """log of a pose whose turn is between 0 and pi: the angle from the trace, and v from p = (1/1! + W/2! + W^2/3! ...) v."""
    with mpmath.workdps(DIGITS):
        R, p = T[:3, :3], T[:3, 3]
        theta = mpmath.acos((R[0, 0] + R[1, 1] + R[2, 2] - 1) / 2)
        scale = theta / (2 * mpmath.sin(theta))
        omega = [scale * x for x in (R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1])]
        along = mpmath.zeros(3)
        term = mpmath.eye(3)
        for k in range(1, 80):
            along += term
            term = term * hat(omega) / (k + 1)
        return [*omega, *mpmath.lu_solve(along, p)]


def residual_jacobian(chain, q):
    """How log(fk(q)) changes with each value, by differences over 1e-12: neither an adjoint nor a Bernoulli number."""
    with mpmath.workdps(DIGITS):
        q, h = numbers(q), mpmath.mpf("1e-12")
        columns = []
        for i in range(chain.n):
            ahead, behind = (log(product(chain, [x + (i == j) * s for j, x in enumerate(q)])) for s in (h, -h))
            columns.append([(a - b) / (2 * h) for a, b in zip(ahead, behind, strict=True)])
        return doubles(mpmath.matrix(columns).T)


def intersections(one, r, other, s):
    """The intersections of two circles, of radius r and s about two points, with 30 digits; [] if none."""
    with mpmath.workdps(30):
        offset = mpmath.mpc(*other) - mpmath.mpc(*one)
        d = abs(offset)
        along = (d * d + r * r - s * s) / (2 * d)
        square = r * r - along * along
        if square < 0:
            return []
        points = [mpmath.mpc(*one) + offset / d * mpmath.mpc(along, sign * mpmath.sqrt(square)) for sign in (1, -1)]
        return [np.array([float(p.real), float(p.imag)]) for p in points]
