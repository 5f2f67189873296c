"""Branch points: the directions of all motions that meet there, against curves that algebra factors, and tracing each of them."""

import numpy as np
import pytest
import sympy as sp

from kinlib import linkages
from kinlib.mechanisms.branch_points import branch_directions, nearest_branch_point
from kinlib.mechanisms.closure import Closure
from kinlib.mechanisms.continuation import CurveTracer
from kinlib.mechanisms.mechanism import Mechanism

x, y = sp.symbols("x y")
FOUR_BARS = {
    "parallelogram": (4, 1, 4, 1),
    "rhombus": (1, 1, 1, 1),
    "kite": (2, 2, 1, 1),
    "kite with short ground": (1, 1, 2, 2),
    "of one curve that crosses itself": (3, 2, 4, 3),
}
"""Lengths of ground, crank, coupler and rocker: ground + rocker = crank + coupler, so they close when they lie flat at q = 0."""


def eliminated(ground, crank, coupler, rocker):
    """The numerator of |BC|^2 - coupler^2 in x = tan(A / 2) and y = tan(D / 2), with B and C at the ends of crank and rocker."""
    B = crank * sp.Matrix([1 - x**2, 2 * x]) / (1 + x**2)
    C = sp.Matrix([ground, 0]) + rocker * sp.Matrix([1 - y**2, 2 * y]) / (1 + y**2)
    return sp.expand(sp.numer(sp.together((C - B).dot(C - B) - coupler**2)))


def tangents_by_sympy(polynomial):
    """The slopes (A', D') of all branches at A = D = 0: the factors of the terms of the lowest degree."""
    terms = sp.Poly(polynomial, x, y).terms()
    lowest = min(sum(powers) for powers, _ in terms)
    cone = sum(c * x**i * y**j for (i, j), c in terms if i + j == lowest)
    slopes = [(1, s) for s in sp.solve(cone.subs(x, 1), y)] + [(0, 1)] * (sp.Poly(cone, x, y).degree(y) < lowest)
    return np.array([[float(value) for value in slope] for slope in slopes])


def vanishes_on(factor, A, D):
    """Whether a polynomial of tan(A / 2) and tan(D / 2) is 0 at all these angles, also where a tangent is infinite."""
    powers = [sp.Poly(factor, x, y).degree(symbol) if factor.has(symbol) else 0 for symbol in (x, y)]
    values = sp.lambdify((x, y), factor, "numpy")(np.tan(A / 2), np.tan(D / 2))
    return np.abs(values * np.cos(A / 2) ** powers[0] * np.cos(D / 2) ** powers[1]).max() < 1e-8


def one_each(directions, expected):
    """Each direction is parallel to exactly one of the expected ones, and each of these to one of them."""
    across = directions[:, None, 0] * expected[:, 1] - directions[:, None, 1] * expected[:, 0]
    parallel = np.abs(across) < 1e-8 * np.linalg.norm(directions[:, None], axis=-1) * np.linalg.norm(expected, axis=-1)
    return (parallel.sum(axis=0) == 1).all() and (parallel.sum(axis=1) == 1).all()


@pytest.mark.oracle("sympy", Mechanism.branch_directions, Closure.branch_directions, branch_directions)
@pytest.mark.parametrize("name", FOUR_BARS)
def test_the_directions_are_the_tangents_of_all_factors(name):
    directions = linkages.four_bar(*FOUR_BARS[name]).branch_directions(np.zeros(4))
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1, atol=1e-12)
    assert one_each(directions[:, [0, 2]], tangents_by_sympy(eliminated(*FOUR_BARS[name])))


@pytest.mark.oracle("sympy", Mechanism.trace, Closure.trace, CurveTracer.follow)
@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("name", [name for name in FOUR_BARS if "itself" not in name])
def test_in_each_direction_the_trace_stays_on_one_factor(name, sense):
    """A parallelogram keeps A = D, an antiparallelogram 5 tan(A/2) = -3 tan(D/2), and a folded kite keeps A = 0, for example."""
    linkage = linkages.four_bar(*FOUR_BARS[name])
    factors = [
        factor for factor, _ in sp.factor_list(eliminated(*FOUR_BARS[name]))[1] if factor.subs({x: 0, y: 0}) == 0
    ]
    followed = []
    for direction in linkage.branch_directions(np.zeros(4)):
        curve = linkage.trace(np.zeros(4), direction=sense * direction)
        assert curve.closed
        assert curve.residual < 1e-12
        np.testing.assert_allclose(curve.q[0], 0, atol=1e-12)
        np.testing.assert_allclose(curve.tangents[0], sense * direction, atol=1e-9)
        (on,) = [k for k, factor in enumerate(factors) if vanishes_on(factor, *curve.q[:, [0, 2]].T)]
        followed.append(on)
    assert sorted(followed) == list(range(len(factors)))


@pytest.mark.parametrize("points", [None, 50])
def test_of_one_curve_that_crosses_itself_both_branches_are_the_whole_curve(points):
    linkage = linkages.four_bar(*FOUR_BARS["of one curve that crosses itself"])
    one, other = (
        linkage.trace(np.zeros(4), direction=d, points=points) for d in linkage.branch_directions(np.zeros(4))
    )
    assert one.closed
    assert other.closed
    np.testing.assert_allclose(one.length[-1], other.length[-1], rtol=1e-2)
    assert abs(one.tangents[0] @ other.tangents[0]) < 0.9


@pytest.mark.parametrize("direction", [[1, 0, 0, 0], [0.3, 0, 0.2, 0], [0, -1, 0, 0], [-1, 0, 0.9, 0]])
def test_the_motion_nearest_to_the_direction_is_followed(direction):
    linkage = linkages.four_bar(4, 1, 4, 1)
    tangent = linkage.trace(np.zeros(4), direction=direction).tangents[0]
    nearest = np.abs(linkage.branch_directions(np.zeros(4)) @ direction).max()
    np.testing.assert_allclose(tangent @ direction, nearest, atol=1e-9)


@pytest.mark.parametrize("A", [0.0, np.pi])
def test_a_change_point_that_was_assembled_is_found_to_full_precision(A):
    """Two modes become one there, so the loop closes to within 1e-13 at a distance of about 1e-6."""
    linkage = linkages.four_bar(4, 1, 4, 1)
    found = linkage.assemble([A, -A + 1e-3, A + 1e-3, -A - 1e-3], hold={"A": A})
    exact = np.array([A, -A, A, -A])
    assert found.converged
    assert 1e-10 < np.abs(found.q - exact).max() < 1e-4
    assert len(linkage.branch_directions(found.q)) == 2
    for direction in linkage.branch_directions(exact):
        curve = linkage.trace(found.q, direction=direction)
        np.testing.assert_allclose(curve.q[0], exact, atol=1e-10)
        np.testing.assert_allclose(curve.tangents[0], direction, atol=1e-8)


def test_at_a_regular_configuration_the_direction_chooses_the_sense():
    linkage = linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    start = linkage.assembly_modes(hold={"A": 1.0})[0]
    assert len(linkage.branch_directions(start)) == 1
    for sense in (1, -1):
        curve = linkage.trace(start, direction=[sense, 0, 0, 0])
        assert curve.closed
        assert np.sign(curve.q[1, 0] - curve.q[0, 0]) == sense


def test_three_cranks_that_lie_flat_have_one_motion_of_the_two_directions_of_first_order():
    linkage = linkages.parallelogram()
    flat = np.array([-1, 1] * 3) * np.pi / 2
    assert linkage.mobility(flat).infinitesimal == 2
    (direction,) = linkage.branch_directions(flat)
    np.testing.assert_allclose(direction, np.array([1, -1] * 3) / np.sqrt(6), atol=1e-9)
    assert linkage.trace(flat, direction=direction).closed


def test_a_held_value_has_no_direction():
    linkage = linkages.five_bar(3, (1, 4), (1, 1))
    q = np.zeros(linkage.n)
    held = linkage.branch_directions(q, hold={"D": 0.0})
    assert len(held) == 2
    assert (held[:, 2] == 0).all()
    for direction in held:
        curve = linkage.trace(q, hold={"D": 0.0}, direction=direction + 5 * np.eye(5)[2])
        np.testing.assert_allclose(curve.tangents[np.abs(curve.q).sum(axis=1).argmin()], direction, atol=1e-9)


# --- equations whose solutions are known ---


def tracer(value, jacobian, n, limit=1.0):
    """The solutions of equations that are given for one point each."""

    def equations(points):
        return np.array([value(*p) for p in points]), np.array([jacobian(*p) for p in points], dtype=float)

    return CurveTracer(equations, 1e-13, list("xyz")[:n], np.zeros(n, bool), np.tile([-limit, limit], (n, 1)))


@pytest.mark.oracle("axiom: the tangents of curves given by polynomials", CurveTracer.leaving, branch_directions)
def test_four_lines_through_one_point_in_space():
    """x^2 = z^2 and y^2 = z^2: two equations for directions within three dimensions."""
    lines = tracer(
        lambda x, y, z: [x * x - z * z, y * y - z * z], lambda x, y, z: [[2 * x, 0, -2 * z], [0, 2 * y, -2 * z]], 3
    )
    _, tangents = lines.leaving(np.zeros(3), 0.2)
    expected = np.array([[1, 1, 1], [1, 1, -1], [1, -1, 1], [1, -1, -1]]) / np.sqrt(3)
    np.testing.assert_allclose(tangents, expected, atol=1e-9)
    for tangent in expected:
        curve = lines.follow(np.zeros(3), 0.2, 100, tangent + 0.1 * np.eye(3)[0])
        np.testing.assert_allclose(np.abs(curve.q[[0, -1]]), 1, atol=1e-8)
        np.testing.assert_allclose(curve.q[-1], tangent * np.sqrt(3), atol=1e-8)


@pytest.mark.parametrize("angle", [0.5, 0.05, 5e-3])
def test_lines_that_cross_at_a_small_angle_are_not_mixed(angle):
    slope = np.tan(angle)
    lines = tracer(lambda x, y: [y * (y - slope * x)], lambda x, y: [[-slope * y, 2 * y - slope * x]], 2)
    for direction in ([1, 0], [np.cos(angle), np.sin(angle)]):
        curve = lines.follow(np.zeros(2), 0.2, 1000, np.array(direction))
        np.testing.assert_allclose(curve.q @ [-direction[1], direction[0]], 0, atol=1e-8)
        np.testing.assert_allclose(abs(curve.q[[0, -1], 0]), 1, atol=1e-8)


def test_a_cusp_is_left_in_one_sense_only():
    """y^2 = x^3 has its tangent along x, and no point left of the origin."""
    cusp = tracer(lambda x, y: [y * y - x**3], lambda x, y: [[-3 * x * x, 2 * y]], 2)
    _, tangents = cusp.leaving(np.zeros(2), 0.2)
    np.testing.assert_allclose(tangents, [[1, 0]], atol=1e-4)
    curve = cusp.follow(np.zeros(2), 0.2, 1000, np.array([1.0, 0.0]))
    assert sorted(curve.ends) == ["limit of x", "lost: no configuration closes further on"]
    np.testing.assert_allclose(curve.q[:, 1] ** 2, curve.q[:, 0] ** 3, atol=1e-12)


def test_of_curves_that_touch_one_is_followed():
    """y = x^2 and y = -x^2 have the same direction at the origin, so a direction cannot choose between them."""
    curves = tracer(lambda x, y: [y * y - x**4], lambda x, y: [[-4 * x**3, 2 * y]], 2)
    _, tangents = curves.leaving(np.zeros(2), 0.2)
    np.testing.assert_allclose(np.abs(tangents), [[1, 0]], atol=1e-4)
    curve = curves.follow(np.zeros(2), 0.2, 1000, np.array([1.0, 0.0]))
    np.testing.assert_allclose(np.abs(curve.q[[0, -1]]), 1, atol=1e-8)


@pytest.mark.oracle("axiom: the solution of sin(x) sin(y) = 0, z = 0 where both factors are 0", nearest_branch_point)
@pytest.mark.parametrize(("off", "found"), [(5e-4, True), (2e-3, False)])
def test_a_branch_point_is_sought_nearby_only(off, found):
    def equations(p):
        s, c = np.sin(p), np.cos(p)
        J = np.zeros((len(p), 2, 3))
        J[:, 0, 0], J[:, 0, 1], J[:, 1, 2] = c[:, 0] * s[:, 1], s[:, 0] * c[:, 1], 1
        return np.stack([s[:, 0] * s[:, 1], p[:, 2]], axis=1), J

    near = nearest_branch_point(equations, np.array([off, 0.0, 0.0]), 1e-13)
    np.testing.assert_allclose(near, [0 if found else off, 0, 0], atol=1e-12)


NOWHERE = {
    "a point": (lambda x, y: [x * x + y * y], lambda x, y: [[2 * x, 2 * y]]),
    "a point that the second order does not exclude": (
        lambda x, y: [y * y + x**4],
        lambda x, y: [[4 * x**3, 2 * y]],
    ),
}


@pytest.mark.parametrize("name", NOWHERE)
def test_where_no_curve_leaves_there_is_no_direction(name):
    point = tracer(*NOWHERE[name], 2)
    assert point.leaving(np.zeros(2), 0.2)[1].shape == (0, 2)
    with pytest.raises(ValueError, match=r"At least one motion .* got 0\. Nothing can move"):
        point.follow(np.zeros(2), 0.2, 100, np.ones(2))


# --- what is refused ---


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda m: m.trace(np.zeros(4), direction=[1, 0, 0]), r"direction must have shape \(\.\.\., 4\); got \(3,\)"),
        (lambda m: m.trace(np.zeros(4), direction=np.eye(4)), r"direction must have shape \(4,\); got \(4, 4\)"),
        (lambda m: m.trace(np.zeros(4), direction=[np.nan] * 4), r"direction contains NaN"),
        (lambda m: m.trace(np.zeros(4), direction=np.zeros(4)), r"perpendicular to all of them\. Pass one of them\."),
        (
            lambda m: m.trace(np.zeros(4)),
            r"got 2\. .*pass as `direction` one of those that Mechanism\.branch_directions finds",
        ),
        (lambda m: m.branch_directions([0.5, 0.5, 2, 0]), r"A curve must start at a solution"),
        (lambda m: m.branch_directions(np.zeros(4), step=-1), r"step must be a positive length"),
    ],
)
def test_directions_that_choose_nothing_are_refused(ask, message):
    with pytest.raises(ValueError, match=message):
        ask(linkages.four_bar(4, 1, 4, 1))


def test_the_bisector_of_two_motions_is_refused():
    linkage = linkages.four_bar(4, 1, 4, 1)
    one, other = linkage.branch_directions(np.zeros(4))
    with pytest.raises(ValueError, match=r"direction must be nearest to one of .*, which is as near to two of them"):
        linkage.trace(np.zeros(4), direction=one + other)


def test_two_degrees_of_freedom_have_a_continuum_of_directions():
    linkage = linkages.five_bar(1, (1, 1), (1, 1))
    q = linkage.assembly_modes(hold={"A": 1.8, "D": 1.0})[0]
    with pytest.raises(ValueError, match=r"continuum of directions, within 2 dimensions\. Hold all degrees of freedom"):
        linkage.trace(q, direction=np.ones(5))


def test_a_structure_has_no_direction():
    arch = linkages.stretched_arch()
    assert arch.branch_directions(np.zeros(3)).shape == (0, 3)
    with pytest.raises(
        ValueError, match=r"At least one motion .* got 0\. Nothing can move: the linkage is a structure"
    ):
        arch.trace(np.zeros(3), direction=[1, -2, 1])
