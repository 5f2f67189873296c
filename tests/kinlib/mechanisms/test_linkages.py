"""The linkages of the course: what they do, against plane geometry, books, a gripper's file and the theory of their kind."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath_oracle import intersections

from kinlib import exp, linkages

EXACT = 1e-12
X, Y, Z = np.eye(3)


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def close_angles(got, expected, atol=EXACT):
    close(np.sin((np.asarray(got) - expected) / 2), 0, atol / 2)


def apart(q, others):
    """The distance of a configuration of angles from the nearest of others."""
    return np.abs((others - q + np.pi) % (2 * np.pi) - np.pi).max(axis=-1).min()


def angle(vector):
    return np.arctan2(vector[1], vector[0])


def four_bar_configurations(ground, crank, coupler, rocker, A):
    """Both configurations at a crank angle, by the circles on which C lies."""
    B = crank * np.array([np.cos(A), np.sin(A)])
    D = np.array([ground, 0.0])
    for C in intersections(B, coupler, D, rocker):
        of_coupler, of_rocker = angle(C - B), angle(C - D)
        yield np.array([A, of_coupler - A, of_rocker, of_coupler - of_rocker])


FOUR_BARS = {
    "crank-rocker": (0.4, 0.1, 0.35, 0.3),
    "double crank": (0.1, 0.4, 0.3, 0.35),
    "rocker-crank": (0.4, 0.3, 0.35, 0.1),
    "Grashof double rocker": (0.4, 0.35, 0.1, 0.3),
    "non-Grashof": (4.0, 2.0, 2.5, 3.0),
}


@pytest.mark.parametrize("name", FOUR_BARS)
def test_a_four_bar_has_the_two_modes_that_two_circles_have(name):
    linkage = linkages.four_bar(*FOUR_BARS[name])
    expected = list(four_bar_configurations(*FOUR_BARS[name], -0.7))
    modes = linkage.assembly_modes(hold={"A": -0.7})
    assert len(modes) == len(expected) == 2
    for mode in modes:
        assert apart(mode, np.array(expected)) < EXACT


def test_a_non_grashof_crank_has_its_dead_points_where_coupler_and_rocker_are_aligned():
    """There the crank's triangle has the sides 4, 2 and 2.5 + 3: the law of cosines."""
    linkage = linkages.four_bar(*FOUR_BARS["non-Grashof"])
    curve = linkage.trace(linkage.assembly_modes(hold={"A": 0.5})[0], points=2000)
    farthest = np.arccos((16 + 4 - 5.5**2) / (2 * 4 * 2))
    turned = curve.q[[curve.q[:, 0].argmin(), curve.q[:, 0].argmax()]]
    close(turned[:, 0], [-farthest, farthest], atol=1e-4)
    close_angles(turned[:, 3], np.pi, atol=0.02)


@settings(max_examples=3)
@given(st.tuples(*[st.floats(0.5, 4.0)] * 4), st.floats(0, 2 * np.pi), st.integers(0, 1))
def test_grashof_s_condition_predicts_the_curves_of_any_four_bar(links, A, mode):
    """If s + l < p + q there are two curves, each the mirror image of the other, and otherwise one that is its own.

    The crank goes round if the shortest link is the crank or the ground. Source: Grashof (1883); McCarthy and Soh, 2.2.
    """
    ground, crank, *_ = links
    sides = sorted(links)
    margin = sides[1] + sides[2] - sides[0] - sides[3]
    assume(abs(margin) > 0.05)
    assume(sides[3] < sum(sides[:3]) - 0.05)
    assume(abs(crank * np.exp(1j * A) - ground) > 1e-3)  # where B is at D, the rocker is free
    configurations = list(four_bar_configurations(*links, A))
    assume(len(configurations) == 2)
    curve = linkages.four_bar(*links).trace(configurations[mode], points=1000)
    assert curve.closed
    assert np.abs(linkages.four_bar(*links).residual(curve.q)).max() < 1e-12
    assert (apart(-configurations[mode], curve.q) < 0.02) == (margin < 0)
    goes_round = margin > 0 and min(crank, ground) == sides[0]
    assert (abs(curve.q[-1, 0] - curve.q[0, 0]) > 1) == goes_round


def test_the_slider_is_where_the_textbook_says():
    """x = r cos A +- sqrt(l^2 - (e - r sin A)^2): the slider-crank of every book on engines."""
    offset = 0.4
    linkage = linkages.slider_crank(1, 3, offset)
    for A in (0.9, np.pi):
        modes = linkage.assembly_modes(hold={"A": A})
        root = np.sqrt(9 - (offset - np.sin(A)) ** 2)
        close(np.sort(modes[:, 2]), [np.cos(A) - root, np.cos(A) + root])
        close_angles(modes[:, 0] + modes[:, 1], modes[:, 3])
    curve = linkage.trace(linkage.assembly_modes(hold={"A": 1.0})[0], points=200)
    assert curve.closed
    close((curve.q[:, 2] - np.cos(curve.q[:, 0])) ** 2 + (offset - np.sin(curve.q[:, 0])) ** 2, 9)


def test_the_stewart_gough_platform_reaches_the_pose_of_its_leg_lengths():
    """A leg is as long as head and foot are apart: nothing else is asked of the plate's pose."""
    linkage = linkages.stewart_gough()
    zero = np.zeros(linkage.n)
    mobility = linkage.mobility(zero)
    assert (mobility.kutzbach, mobility.infinitesimal, mobility.finite) == (6, 6, 6)
    feet = np.array([joint.point for joint in linkage.joints if joint.name[0] == "U"])
    heads = np.array([joint.point for joint in linkage.joints if joint.name[0] == "S"])
    T = exp([0.1, -0.15, 0.2, 0.05, -0.03, 0.04])
    moved = heads @ T[:3, :3].T + T[:3, 3]
    stretch = np.linalg.norm(moved - feet, axis=1) - np.linalg.norm(heads - feet, axis=1)
    found = linkage.assemble(zero, hold={f"P{i}": s for i, s in enumerate(stretch, start=1)})
    assert found.converged
    close(linkage.poses(found.q)["plate"], T, atol=1e-10)


@pytest.mark.parametrize(("a", "alpha", "b"), [(0.7, 0.4, 1.2), (1.0, 2.0, 0.5)])
def test_bennett_s_linkage_obeys_bennett_s_relation(a, alpha, b):
    """tan(t1/2) tan(t2/2) is constant, sin((beta + alpha)/2) / sin((beta - alpha)/2): Bennett (1903); Hunt, 10.4."""
    linkage = linkages.bennett(a, alpha, b)
    start = linkage.assemble([1, 2, 1, 2])
    assert start.residual < EXACT
    curve = linkage.trace(start.q)
    assert curve.closed
    beta = np.arcsin(b * np.sin(alpha) / a)
    t1, t2, t3, t4 = curve.q.T
    left = np.sin(t1 / 2) * np.sin(t2 / 2) * np.sin((beta - alpha) / 2)
    close(left, np.cos(t1 / 2) * np.cos(t2 / 2) * np.sin((beta + alpha) / 2))
    close_angles(t1, -t3)
    close_angles(t2, -t4)
    for q in curve.q[::20]:
        mobility = linkage.mobility(q)
        assert (mobility.kutzbach, mobility.infinitesimal, mobility.finite) == (-2, 1, 1)


def test_bricard_s_joints_satisfy_the_equation_of_chen_you_and_tarnai():
    """For twists of a right angle, cos(a) + cos(b) + cos(a) cos(b) = 0, every other hinge alike: their (2005) equation."""
    linkage = linkages.bricard()
    start = linkage.assemble([1, -2, 1, -2, 1, -2])
    assert start.residual < EXACT
    curve = linkage.trace(start.q)
    assert curve.closed
    a, b = np.cos(curve.q[:, 0]), np.cos(curve.q[:, 1])
    close(a + b + a * b, 0)
    close_angles(curve.q[:, ::2], curve.q[:, :1])
    close_angles(curve.q[:, 1::2], curve.q[:, 1:2])
    mobility = linkage.mobility(curve.q[10])
    assert (mobility.kutzbach, mobility.infinitesimal, mobility.finite) == (0, 1, 1)


def test_sarrus_s_top_translates_along_a_straight_line():
    """From as high as the plates are long above the ground to as far below it; it passes through its floor unhindered."""
    linkage = linkages.sarrus(side=0.3, rise=0.2)
    curve = linkage.trace(np.zeros(6), points=400)
    assert curve.closed
    T = linkage.poses(curve.q)["top"]
    close(T[:, :3, :3], np.broadcast_to(np.eye(3), (400, 3, 3)))
    close(T[:, :2, 3], 0)
    height = T[:, 2, 3] + 2 * 0.2
    most = 2 * 0.2 * np.sqrt(2)
    close([height.min(), height.max()], [-most, most], atol=1e-3)


def test_the_ring_of_ten_links_has_mobility_8_in_every_configuration():
    """LaValle's (4.3.3): ten links in a ring, one of them on the ground by a hinge: 11 joint values, 3 equations."""
    linkage = linkages.ten_links()
    assert linkage.names == (*(f"theta_{i}" for i in range(1, 6)), *(f"theta_{i}" for i in range(10, 5, -1)), "pin")
    rng = np.random.default_rng(5)
    for _ in range(3):
        found = linkage.assemble(rng.uniform(-2, 2, 11))
        assert found.converged
        mobility = linkage.mobility(found.q)
        assert (mobility.kutzbach, mobility.infinitesimal, mobility.finite) == (8, 8, 8)
        # The deck's equation: the tips of both branches are one point.
        tips = [sum(np.exp(1j * np.cumsum(branch))) for branch in (found.q[:5], found.q[5:10])]
        close(tips[0], tips[1])
