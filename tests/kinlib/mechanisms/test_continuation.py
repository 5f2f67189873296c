"""Well-known curves, traced: their lengths, turning points, crossings and ends."""

import mpmath
import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline
from scipy.signal import find_peaks
from scipy.spatial import distance

from kinlib.mechanisms.continuation import Curve, CurveTracer

EXACT = 1e-12
ROUNDED = 1e-15
STEPS = [0.3, 0.03]


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def plane_curve(value, slopes, turns=(False, False), limits=((-np.inf, np.inf),) * 2):
    """The curve value(x, y) = 0, with the gradient of its left side."""

    def equations(points):
        x, y = points.T
        return value(x, y)[:, None], np.stack(slopes(x, y), axis=-1)[:, None, :]

    return CurveTracer(equations, 1e-13, ["x", "y"], np.array(turns), np.array(limits))


def circle(limits=((-np.inf, np.inf),) * 2):
    return plane_curve(lambda x, y: x * x + y * y - 1, lambda x, y: (2 * x, 2 * y), limits=limits)


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


def straightened(path, curve):
    """Its length by 4001 chords: to 1e-5."""
    return path.resample(curve, 4001).length[-1]


# --- closed curves ---


@pytest.mark.oracle("axiom: the points of a unit circle", CurveTracer.follow)
@pytest.mark.parametrize("step", STEPS)
def test_a_circle_is_traced_once(step):
    curve = circle().follow(np.array([0.6, 0.8]), step, 1000)
    assert curve.closed
    assert curve.ends == ("closed", "closed")
    assert curve.residual < ROUNDED
    close(np.linalg.norm(curve.q, axis=1), 1)
    close(curve.q[-1], curve.q[0])
    close(straightened(circle(), curve), 2 * np.pi, atol=1e-5)
    # A unit tangent is perpendicular to the radius, and its sense of rotation does not change.
    close(np.linalg.norm(curve.tangents, axis=1), 1)
    around = curve.q[:, 0] * curve.tangents[:, 1] - curve.q[:, 1] * curve.tangents[:, 0]
    close(around, np.full(len(around), around[0]))
    assert (np.diff(curve.length) <= step * 1.3).all()


def test_a_closed_curve_may_have_a_turning_point_at_its_start():
    for start in ([1.0, 0.0], [0.0, -1.0]):
        curve = circle().follow(np.array(start), 0.05, 1000)
        for lines in (curve, circle().resample(curve, 200)):
            assert [len(lines.turning_points(i)) for i in range(2)] == [2, 2]


def test_a_curve_that_passes_near_its_start_is_not_closed():
    """x = 30 y winds round a torus thirty times, a fifth of a radian from winding to winding, and each passes as the first."""
    path = plane_curve(lambda x, y: x - 30 * y, lambda x, y: (1 + 0 * x, -30 + 0 * y), turns=(True, True))
    curve = path.follow(np.zeros(2), 2.0, 1000)
    assert curve.closed
    close(curve.length[-1], 2 * np.pi * np.sqrt(901))


@pytest.mark.parametrize("count", [77])
def test_a_curve_closes_if_a_step_ends_exactly_at_its_start(count):
    """A last step that ends at the start to the last digit, or to all but the last, is the last one."""
    path = plane_curve(lambda x, y: x - 2 * y - 1, lambda x, y: (1 + 0 * x, -2 + 0 * y), turns=(True, True))
    length = 2 * np.pi * np.sqrt(5)
    curve = path.follow(np.array([1.0, 0.0]), length / count, 1000)
    assert curve.closed
    assert len(curve.q) == count + 1
    close(curve.length[-1], length)


def test_a_prediction_with_curvature_is_corrected_in_two_steps():
    """Ahead along the tangent it would take three; a step that overshoots would leave the circle in other places."""
    asked = []
    once = circle()

    def counted(x):
        asked.append(len(x))
        return once.equations(x)

    curve = CurveTracer(counted, 1e-13, once.names, once.is_angle, once.limits).follow(np.array([1.0, 0.0]), 0.2, 1000)
    assert np.count_nonzero(np.array(asked) == 1) <= 3 * len(curve.q) + 5
    close(np.diff(curve.length)[:-1], 0.2, atol=4e-3)


def test_a_steep_rise_between_level_parts_is_not_skipped():
    """Before and after it the curve has the same direction, so the tangents of a long step would not show it."""
    path = plane_curve(
        lambda x, y: y - 0.3 * np.tanh(100 * x),
        lambda x, y: (-30 / np.cosh(100 * x) ** 2, 1 + 0 * y),
        limits=((-1, 1), (-np.inf, np.inf)),
    )
    curve = path.follow(np.array([-1.0, -0.3]), 0.3, 1000)
    assert curve.ends == ("limit of x", "limit of x")
    assert np.diff(curve.length).max() < 0.35
    assert np.abs(np.diff(curve.q[:, 1])).max() < 0.3


def test_redundant_equations_give_the_same_curve():
    once = circle()

    def thrice(x):
        r, J = once.equations(x)
        return np.concatenate([r, -2 * r, r], axis=1), np.concatenate([J, -2 * J, J], axis=1)

    path = CurveTracer(thrice, 1e-13, ["x", "y"], once.is_angle, once.limits)
    close(path.follow(np.array([1.0, 0.0]), 0.1, 1000).q, once.follow(np.array([1.0, 0.0]), 0.1, 1000).q)


# --- branches that cross, and branches that almost do ---


@pytest.mark.parametrize("step", STEPS)
def test_tracing_continues_straight_through_a_crossing(step):
    """The lemniscate of Bernoulli, b = 1, through its double point: as long as both leaves, 2 sqrt(2) lemniscate constants."""
    curve = cassini(1.0).follow(start_of(1.0), step, 2000)
    assert curve.closed
    assert on_both_sides(curve)
    lemniscate = mpmath.gamma(0.25) ** 2 / (2 * mpmath.sqrt(2 * mpmath.pi))
    close(straightened(cassini(1.0), curve), float(2 * mpmath.sqrt(2) * lemniscate), atol=1e-4)


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("near", [0.1, 1e-3, 1e-6])
def test_tracing_stays_on_its_branch_where_two_almost_meet(near, step):
    """Cassini's ovals come as near to each other as sqrt(8 |1 - b|), and are one or two all the same."""
    for b in (1 - near, 1 + near):
        curve = cassini(b).follow(start_of(b), step, 2000)
        assert curve.closed
        assert on_both_sides(curve) == (b > 1)
        if near >= 1e-2:
            close(straightened(cassini(b), curve), cassini_length(b), atol=1e-4)


@pytest.mark.parametrize("near", [1e-1, 1e-5])
def test_at_a_waist_the_opposite_side_is_not_taken_for_the_start(near):
    """At its waist the oval is sqrt(b^2 - 1) wide on either side, and both sides are parallel."""
    b = 1 + near
    for step in STEPS:
        curve = cassini(b).follow(np.array([0.0, np.sqrt(b * b - 1)]), step, 2000)
        assert curve.closed
        assert on_both_sides(curve)
        assert curve.q[:, 1].min() < 0 < curve.q[:, 1].max()


def test_a_start_at_a_crossing_is_refused():
    with pytest.raises(
        ValueError, match=r"Exactly one direction must lead away.*; got 2\. .*start at another configuration of one"
    ):
        cassini(1.0).follow(np.zeros(2), 0.1, 1000)


# --- ends ---


@pytest.mark.parametrize("step", STEPS)
def test_a_cubic_turns_twice_between_its_limits(step):
    """x = y^3 - y has its turning points at y = +-1/sqrt(3), and meets x = 6 at y = 2."""
    path = plane_curve(
        lambda x, y: y**3 - y - x, lambda x, y: (-1 + 0 * x, 3 * y * y - 1), limits=((-6, 6), (-np.inf, np.inf))
    )
    curve = path.follow(np.array([0.0, 0.0]), step, 1000)
    assert not curve.closed
    assert curve.ends == ("limit of x", "limit of x")
    close(np.sort(curve.q[[0, -1]], axis=0), [[-6, -2], [6, 2]])
    turned = curve.turning_points(0)
    close(np.abs(curve.q[turned, 1]), 1 / np.sqrt(3), atol=step)
    close(np.abs(curve.q[turned, 0]), 2 / np.sqrt(27), atol=step**2 * 2)
    laid = path.resample(curve, 101)
    close(laid.q[[0, -1]], curve.q[[0, -1]])
    assert laid.ends == curve.ends


@pytest.mark.parametrize("beyond", [0.5, 1e-3])
@pytest.mark.parametrize("step", STEPS)
def test_a_limit_is_met_even_if_one_step_passes_it_and_returns(beyond, step):
    """A step is a cubic, which errs by its fourth power over 384: with steps of 0.3 an excursion of 1e-6 may pass unseen."""
    if step**4 / 384 > beyond:
        return
    curve = circle(limits=((-np.inf, 1 - beyond), (-np.inf, np.inf))).follow(np.array([-1.0, 0.0]), step, 1000)
    assert curve.ends == ("limit of x", "limit of x")
    close(curve.q[[0, -1], 0], 1 - beyond, atol=1e-11)
    assert (curve.q[:, 0] <= 1 - beyond + 1e-9).all()


@pytest.mark.parametrize("start", [-0.02, 0.28])
def test_a_maximum_beyond_a_limit_is_found_from_either_side(start):
    """Of the two handles of a step one alone reaches beyond the limit: that of the point beside the top."""
    path = plane_curve(
        lambda x, y: y + 0.3 * x * x, lambda x, y: (0.6 * x, 1 + 0 * y), limits=((-1, 1), (-np.inf, -3e-5))
    )
    curve = path.follow(np.array([start, -0.3 * start**2]), 0.3, 1000)
    assert sorted(curve.ends) == ["limit of x", "limit of y"]
    close(np.sort(np.abs(curve.q[[0, -1], 0])), [0.01, 1], atol=1e-10)
    assert (curve.q[:, 0] * start > 0).all()


@pytest.mark.parametrize(("start", "stop"), [(0.0, 0), (0.3, 1)])
def test_a_small_maximum_beyond_a_limit_is_found(start, stop):
    """Here the handles reach beyond the limit by little, and the top by less than a thousandth of the step."""
    top = np.polynomial.Polynomial([1, -1]) ** 2 * np.polynomial.Polynomial([-1, 2]) * 0.015 - 3e-4

    def value(x, y):
        return y - top(x / 0.3)

    path = plane_curve(value, lambda x, y: (-top.deriv()(x / 0.3) / 0.3, 1 + 0 * y), limits=((-0.1, 1), (-np.inf, 0)))
    curve = path.follow(np.array([start, top(start / 0.3)]), 0.3, 1000)
    feet = 0.3 * np.sort(top.roots().real)
    close(curve.q[[-1, 0][stop], 0], feet[stop])


@pytest.mark.parametrize("step", [0.02])
def test_a_curve_that_touches_a_limit_continues(step):
    """Steps of 0.02 are cubics that err by 4e-10: nearer than what counts as the same."""
    assert circle(limits=((-1, 1), (-1, 1))).follow(np.array([0.6, 0.8]), step, 1000).closed


def test_a_curve_ends_at_the_first_of_two_limits():
    path = circle(limits=((-np.inf, 0.8), (-0.9, np.inf)))
    curve = path.follow(np.array([-1.0, 0.0]), 0.5, 1000)
    ends = dict(zip(curve.ends, curve.q[[0, -1]], strict=True))
    close(ends["limit of x"], [0.8, 0.6])
    close(ends["limit of y"], [-np.sqrt(1 - 0.81), -0.9])


@pytest.mark.parametrize(("limit", "first"), [(0.9, "y"), (1.1, "x")])
def test_a_curve_ends_at_the_first_of_two_limits_within_one_step(limit, first):
    path = plane_curve(
        lambda x, y: y - 2 * x, lambda x, y: (-2 + 0 * x, 1 + 0 * y), limits=((-0.5, 0.5), (-limit, limit))
    )
    for names, columns in (("xy", [0, 1]), ("yx", [1, 0])):
        swapped = CurveTracer(
            lambda q, columns=columns: tuple(
                part[..., columns] if part.ndim == 3 else part for part in path.equations(q[:, columns])
            ),
            *(1e-13, names, path.is_angle, path.limits[columns]),
        )
        curve = swapped.follow(np.zeros(2), 2.0, 1000)
        assert curve.ends == (f"limit of {first}",) * 2
        close(np.abs(curve.q[0, columns]), [min(0.5, limit / 2), min(1, limit)])


@pytest.mark.parametrize("step", STEPS)
def test_a_start_beyond_a_limit_by_rounding_may_only_return(step):
    """On its way out it would be back before a thousandth: that is no reason to let it."""
    path = plane_curve(lambda x, y: y + x * x, lambda x, y: (2 * x, 1 + 0 * y), limits=((-1, 1), (-np.inf, -5e-7)))
    for side in (1, -1):
        curve = path.follow(np.array([side * 5e-4, -2.5e-7]), step, 1000)
        assert sorted(curve.ends) == ["limit of x", "limit of y"]
        close(np.sort(side * curve.q[[0, -1], 0]), [7e-4, 1], atol=3e-4)


def test_a_start_beyond_a_limit_without_a_way_back_is_the_whole_curve():
    path = plane_curve(
        lambda x, y: x - y * y, lambda x, y: (1 + 0 * x, -2 * y), limits=((-np.inf, -5e-7), (-np.inf, np.inf))
    )
    curve = path.follow(np.array([1e-8, -1e-4]), 0.1, 1000)
    assert curve.ends == ("limit of x", "limit of x")
    close(curve.q, [[1e-8, -1e-4]])


def test_from_a_limit_a_curve_leads_only_inwards():
    curve = circle(limits=((-np.inf, 0.6), (-np.inf, np.inf))).follow(np.array([0.6, 0.8]), 0.1, 1000)
    assert curve.ends == ("limit of x", "limit of x")
    close(curve.q[[0, -1], 0], 0.6)
    close(straightened(circle(), curve), 2 * np.pi - 2 * np.arccos(0.6), atol=1e-5)


def test_a_straight_curve_ends_at_the_limit_that_it_starts_from():
    """Where a curve is straight its cubic has no cubic part but rounding, and that must not hide where it ends."""
    for rise in (1.0, -1.0, 0.3):
        path = plane_curve(
            lambda x, y, rise=rise: y - rise * x,
            lambda x, y, rise=rise: (-rise + 0 * x, 1 + 0 * y),
            limits=((0, 0.8), (-9, 9)),
        )
        curve = path.follow(np.zeros(2), 0.1, 1000)
        close(np.sort(curve.q[[0, -1], 0]), [0, 0.8])
        assert curve.ends == ("limit of x", "limit of x")


def test_between_equal_limits_a_curve_is_one_point():
    path = circle(limits=((0.6, 0.6), (-np.inf, np.inf)))
    curve = path.follow(np.array([0.6, 0.8]), 0.1, 1000)
    assert curve.ends == ("limit of x", "limit of x")
    close(curve.q, [[0.6, 0.8]])
    assert len(path.resample(curve, 10).q) == 1


@pytest.mark.parametrize("step", [0.1])
def test_a_curve_ends_at_a_cusp(step):
    """y^2 = x^3 comes to the origin along x, and goes back the way it came."""
    path = plane_curve(lambda x, y: y**2 - x**3, lambda x, y: (-3 * x * x, 2 * y), limits=((-1, 1), (-2, 2)))
    curve = path.follow(np.array([0.25, 0.125]), step, 1000)
    assert set(curve.ends) == {"limit of x", "lost: no configuration closes further on"}
    assert np.linalg.norm(curve.q, axis=1).min() < 1e-4


def test_a_curve_is_left_unfinished_after_max_steps():
    path = plane_curve(lambda x, y: y - x, lambda x, y: (-1 + 0 * x, 1 + 0 * y))
    curve = path.follow(np.array([0.0, 0.0]), 0.1, 20)
    assert curve.ends == ("20 points", "20 points")
    assert len(curve.q) == 41
    assert path.follow(np.array([0.0, 0.0]), 0.1, 1).ends == ("1 point", "1 point")


# --- points at equal steps ---


def test_a_resampled_curve_has_equal_steps_and_closes():
    small = plane_curve(lambda x, y: x * x + y * y - 0.04, lambda x, y: (2 * x, 2 * y))
    for path, start, step in (
        (circle(), [1.0, 0.0], 0.2),
        (small, [0.2, 0.0], 0.04),
        (cassini(1.1), start_of(1.1), 0.2),
    ):
        curve = path.follow(np.array(start), step, 1000)
        for count in (2, 10, 361):
            laid = path.resample(curve, count)
            assert len(laid.q) == count
            assert laid.residual < 10 * ROUNDED
            close(laid.q[-1], laid.q[0])
        steps = np.diff(laid.length)
        assert steps.max() / steps.min() < 1.02
        along = laid.q[2:] - laid.q[:-2]
        close((laid.tangents[1:-1] * along).sum(1) / np.linalg.norm(along, axis=1), 1, atol=2e-3)


def drawn(count=40, far=7.0):
    """A curve of cosines, whose tangents are known."""
    s = np.linspace(0.1, far, count)
    q = np.stack([np.cos(s), np.sin(2 * s), 0.5 * s], axis=1)
    rates = np.stack([-np.sin(s), 2 * np.cos(2 * s), np.full(count, 0.5)], axis=1)
    return s, Curve(q, rates / np.linalg.norm(rates, axis=1, keepdims=True), False, ("limit", "limit"), 0.0)


@pytest.mark.oracle("scipy", Curve.interpolate, Curve.length)
@pytest.mark.parametrize("count", [7])
def test_interpolation_agrees_with_scipy_s_hermite_spline(count):
    _, curve = drawn()
    s = np.cumsum([0.0, *map(distance.euclidean, curve.q, curve.q[1:])])
    close(curve.length, s)
    spline = CubicHermiteSpline(s, curve.q, curve.tangents)
    close(curve.interpolate(count), spline(np.linspace(0, s[-1], count)))


@pytest.mark.oracle("scipy", Curve.turning_points)
def test_turning_points_agree_with_scipy_s_peaks():
    _, curve = drawn(4001)
    for i in (0, 1):
        peaks = [found for sign in (1, -1) for found in find_peaks(sign * curve.q[:, i])[0]]
        turned = curve.turning_points(i)
        assert len(turned) == len(peaks) > 1
        assert set(turned - np.sort(peaks)) <= {0, 1}  # it counts the first point beyond the peak


# --- errors ---


def test_a_start_that_is_not_a_solution_is_refused():
    with pytest.raises(
        ValueError,
        match=r"A curve must start at a solution; the residual of this start is 3\. Assemble the linkage first",
    ):
        circle().follow(np.array([2.0, 0.0]), 0.1, 1000)


def test_a_start_typed_with_fewer_digits_is_corrected():
    start = np.array([0.6, 0.8]) + 1e-11
    close(np.linalg.norm(circle().follow(start, 0.1, 1000).q, axis=1), 1, atol=1e-15)


def test_an_isolated_point_and_a_surface_are_refused():
    free = circle()
    both = CurveTracer(
        lambda x: (x, np.broadcast_to(np.eye(2), (len(x), 2, 2))), 1e-13, ["x", "y"], free.is_angle, free.limits
    )
    with pytest.raises(
        ValueError,
        match=r"Exactly one direction must lead away.*; got 0\. Nothing can move: the linkage is a structure\.",
    ):
        both.follow(np.zeros(2), 0.1, 1000)
    nothing = plane_curve(lambda x, y: 0 * (x + y), lambda x, y: (0 * x, 0 * y))
    with pytest.raises(
        ValueError, match=r"Exactly one direction must lead away.*; got 2\. Hold all degrees of freedom but one"
    ):
        nothing.follow(np.zeros(2), 0.1, 1000)
