"""Drawings of linkages: bars as long as their links, and gaps where a loop is open."""

import re

import modern_robotics as mr
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinlib import linkages
from kinlib.view.figures.linkage import LinkageGeometry, describe_linkage, draw_linkage, is_planar, linkage_geometry

ALL = [
    linkages.four_bar(0.4, 0.1, 0.35, 0.3),
    linkages.slider_crank(0.1, 0.3, 0.05),
    linkages.five_bar(1, (1, 1), (1, 1)),
    linkages.ten_links(),
    linkages.parallelogram(),
    linkages.triangle(),
    linkages.stretched_arch(),
    linkages.three_rrr(),
    linkages.bennett(),
    linkages.bricard(),
    linkages.sarrus(),
    linkages.stewart_gough(),
]
each = pytest.mark.parametrize("mechanism", ALL, ids=lambda mechanism: mechanism.name)

angles = st.floats(-20, 20)


def drawn_names(picture):
    words = re.findall(r"<text[^>]*>(.*?)</text>", picture.svg, flags=re.DOTALL)
    return {re.sub(r"<[^>]*>", "", word).strip() for word in words}


@given(st.lists(angles, min_size=4, max_size=4))
def test_every_bar_keeps_its_length_in_any_configuration_open_or_closed(q):
    """The lengths in the drawing are those with which the linkage was made."""
    geometry = linkage_geometry(linkages.four_bar(4, 1, 3.5, 3), q)
    lengths = {body: np.linalg.norm(ends[1] - ends[0]) for body, ends in geometry.corners.items()}
    assert lengths == pytest.approx({"ground": 4, "crank": 1, "coupler": 3.5, "rocker": 3}, abs=1e-9)


@given(st.lists(angles, min_size=4, max_size=4))
def test_a_prismatic_joint_is_drawn_on_its_rail_at_its_value(q):
    geometry = linkage_geometry(linkages.slider_crank(0.1, 0.3, 0.05), q)
    np.testing.assert_allclose(geometry.first[2], [q[2], 0.05, 0], atol=1e-12)
    np.testing.assert_allclose(geometry.corners["slider"][1], geometry.first[2], atol=1e-9)


@each
def test_an_assembled_linkage_has_no_gap(mechanism):
    guesses = (np.random.default_rng(seed).uniform(-0.5, 0.5, mechanism.n) for seed in range(20))
    found = next(found for found in map(mechanism.assemble, guesses) if found.converged)
    assert linkage_geometry(mechanism, found.q).gap.max() < 1e-9
    assert draw_linkage(mechanism, found.q).alt.endswith("It is closed.")


def test_an_open_linkage_shows_its_gap_and_gives_its_width():
    mechanism = linkages.four_bar(4, 1, 3.5, 3)
    picture = draw_linkage(mechanism, [0, 0, 0, 0])
    # Stretched out along x the coupler ends at 1 + 3.5, the rocker at 4 + 3.
    assert "It is open: at C a gap of 2.5 is left." in picture.alt
    assert "#b35900" in picture.svg
    assert "#b35900" not in draw_linkage(mechanism, mechanism.assemble([1, 0, 2, 0]).q).svg


@each
def test_every_joint_is_labelled_and_described(mechanism):
    picture = draw_linkage(mechanism, np.zeros(mechanism.n))
    for joint in mechanism.joints:
        assert f"{joint.name} joins {joint.bodies[0]} and {joint.bodies[1]} at" in picture.alt
    shown = {name.replace("θ", "theta_").removeprefix("joint ") for name in drawn_names(picture)}
    assert {joint.name.removeprefix("joint ") for joint in mechanism.joints} <= shown
    assert not {"A", "pin"} & drawn_names(draw_linkage(mechanism, np.zeros(mechanism.n), names=False))


def test_a_named_point_moves_with_its_body():
    mechanism = linkages.four_bar(4, 1, 3.5, 3)
    geometry = linkage_geometry(mechanism, [np.pi / 2, -np.pi / 2, 0, 0], {"P": ("coupler", (2, 0.5, 0))})
    # B has moved to (0, 1), and the coupler is still parallel to x.
    np.testing.assert_allclose(geometry.points["P"], [1, 1.5, 0], atol=1e-12)


def test_a_point_of_an_unknown_body_is_refused():
    with pytest.raises(ValueError, match="has the bodies ground, crank, rocker, coupler; got 'rod'"):
        draw_linkage(linkages.four_bar(4, 1, 3.5, 3), np.zeros(4), points={"P": ("rod", (0, 0, 0))})


@pytest.mark.oracle("modern_robotics", linkage_geometry, LinkageGeometry.all)
def test_the_pins_of_a_slider_crank_are_where_modern_robotics_computes_them():
    """Crank 0.1, rod 0.3: the pin B moves with the crank, and the slider translates along x."""
    q = np.array([0.7, -0.2, 0.35, 0.5])
    drawn = linkage_geometry(linkages.slider_crank(0.1, 0.3, 0.05), q).all
    B = mr.MatrixExp6(mr.VecTose3([0, 0, 0.7, 0, 0, 0])) @ [0.1, 0, 0, 1]
    for pin in (B[:3], [0, 0, 0], [0.35, 0.05, 0]):
        assert np.linalg.norm(drawn - pin, axis=1).min() < 1e-12


@pytest.mark.oracle("numpy", LinkageGeometry.gap)
def test_the_gap_of_an_open_four_bar_is_the_distance_between_its_two_ends():
    """All angles 0: the coupler ends at 0.1 + 0.35, the rocker at 0.4 + 0.3."""
    geometry = linkage_geometry(linkages.four_bar(0.4, 0.1, 0.35, 0.3), np.zeros(4))
    assert geometry.gap.max() == pytest.approx(np.linalg.norm(np.array([0.45, 0]) - [0.7, 0]), abs=1e-12)


def test_the_text_alternative_of_a_linkage():
    linkage = linkages.stretched_arch(0.2, 0.9)
    assert describe_linkage(linkage, linkage_geometry(linkage, np.zeros(3))) == (
        "stretched arch with the bodies ground, left, right. A joins ground and left at (0, 0); B joins left and right at "
        "(0.2, 0); C joins ground and right at (1.1, 0). All lengths in metres. It is closed."
    )


@pytest.mark.oracle("modern_robotics", is_planar)
@each
def test_a_linkage_is_planar_if_the_exponentials_of_modern_robotics_keep_z(mechanism):
    """For each joint by itself, the row of z stays (0, 0, 1, 0)."""
    screws = np.concatenate([joint.screws for joint in mechanism.joints])
    moved = [mr.MatrixExp6(mr.VecTose3(0.7 * S)) for S in screws]
    assert is_planar(mechanism) == all(np.allclose(T[2], [0, 0, 1, 0]) for T in moved)


def test_the_text_says_where_the_joints_of_the_grey_configuration_are():
    linkage = linkages.four_bar(4, 1, 3.5, 3)
    one, other = linkage.assembly_modes(hold={"A": 1.0})
    alt = draw_linkage(linkage, one, ghost=other).alt
    places = linkage.joint_points(other)
    said = re.search(r"In grey: (.*)\.$", alt)[1]
    for name, place in zip("ABDC", places, strict=True):
        assert f"{name} at ({place[0]:.3g}, " in said.replace("(-0,", "(0,") or abs(place[0]) < 1e-5
    assert said != re.search(r"In grey: (.*)\.$", draw_linkage(linkage, one, ghost=one).alt)[1]
