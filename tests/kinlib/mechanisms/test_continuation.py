"""Well-known curves, traced: their lengths, turning points, crossings and ends."""

import mpmath
import numpy as np
import pytest

from kinlib.mechanisms.continuation import trace_curve
from kinlib.mechanisms.levenberg_marquardt import Equations


def close(got, expected, atol):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def plane_curve(value, slopes, turns=(False, False)):
    """The curve value(x, y) = 0, with the gradient of its left side."""

    def equations(points):
        x, y = points.T
        return value(x, y)[:, None], np.stack(slopes(x, y), axis=-1)[:, None, :]

    return Equations(equations, 1e-13, np.array(turns))


def cassini(b):
    """The points whose distances to (-1, 0) and (1, 0) have the product b^2: two ovals for b < 1, one for b > 1."""
    return plane_curve(
        lambda x, y: (x * x + y * y) ** 2 - 2 * (x * x - y * y) + 1 - b**4,
        lambda x, y: (4 * x * (x * x + y * y) - 4 * x, 4 * y * (x * x + y * y) + 4 * y),
    )


def cassini_length(b):
    """Of one oval. The foci make z^2 = 1 + b^2 e^(is), so that |dz| = b^2 / (2 |z|) ds; for b > 1 it takes two turns of s."""

    def speed(s):
        return b * b / (2 * mpmath.sqrt(abs(1 + b * b * mpmath.expj(s))))

    return float(2 * (1 + (b > 1)) * mpmath.quad(speed, [0, 1, 2, 3, mpmath.pi]))


def on_both_sides(curve):
    return curve.q[:, 0].min() < 0 < curve.q[:, 0].max()


def start_of(b):
    return np.array([np.sqrt(1 + b * b), 0.0])


def length(curve):
    """By 4001 chords: to 1e-5."""
    return np.linalg.norm(np.diff(curve.q, axis=0), axis=1).sum()


@pytest.mark.parametrize("step", [0.3, 0.03])
def test_tracing_continues_straight_through_a_crossing(step):
    """The lemniscate of Bernoulli, b = 1, through its double point: as long as both leaves, 2 sqrt(2) lemniscate constants."""
    curve = trace_curve(cassini(1.0), start_of(1.0), 4001, step)
    assert curve.closed
    assert on_both_sides(curve)
    lemniscate = mpmath.gamma(0.25) ** 2 / (2 * mpmath.sqrt(2 * mpmath.pi))
    close(length(curve), float(2 * mpmath.sqrt(2) * lemniscate), atol=1e-4)


@pytest.mark.parametrize(("near", "step"), [(0.1, 0.3), (1e-3, 0.03), (1e-6, 0.3)])
def test_tracing_stays_on_its_branch_where_two_almost_meet(near, step):
    """Cassini's ovals come as near to each other as sqrt(8 |1 - b|), and are one or two all the same."""
    for b in (1 - near, 1 + near):
        curve = trace_curve(cassini(b), start_of(b), 4001, step)
        assert curve.closed
        assert on_both_sides(curve) == (b > 1)
        if near >= 1e-2:
            close(length(curve), cassini_length(b), atol=1e-4)


def test_a_start_off_the_curve_an_isolated_point_and_a_surface_are_refused():
    circle = plane_curve(lambda x, y: x * x + y * y - 1, lambda x, y: (2 * x, 2 * y))
    point = Equations(lambda x: (x, np.broadcast_to(np.eye(2), (len(x), 2, 2))), 1e-13, np.zeros(2, dtype=bool))
    surface = plane_curve(lambda x, y: 0 * (x + y), lambda x, y: (0 * x, 0 * y))
    for curve, start, says in (
        (circle, [2.0, 0.0], r"the residual is 3\. Assemble it first"),
        (point, [0.0, 0.0], r"got 0\. Nothing can move: the linkage is a structure\."),
        (surface, [0.0, 0.0], r"got 2\. Hold all degrees of freedom but one"),
    ):
        with pytest.raises(ValueError, match=says):
            trace_curve(curve, np.array(start))
