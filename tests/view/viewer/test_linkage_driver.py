"""Closed chains in the viewer: every configuration on the slider is closed, and every assembly mode has its curve."""

import numpy as np
import pytest

from kinlib.mechanisms.linkages import bennett, four_bar, slider_crank
from kinlib.view import drive

GRASHOF = four_bar(0.4, 0.1, 0.35, 0.3)
START = GRASHOF.assembly_modes(hold={"A": 1.0})[0]


@pytest.fixture(scope="module")
def crank_rocker():
    return drive(GRASHOF, START, across=("A", "D"))


def curves_of(shown):
    return [np.array([stop["q"] for stop in variant["stops"]]) for variant in shown.mode["variants"].values()]


@pytest.mark.parametrize(
    ("linkage", "guess", "curves"),
    [
        (GRASHOF, START, 2),  # Grashof: the coupler cannot change sides
        (four_bar(0.4, 0.3, 0.25, 0.3), [1, 1, 2, 1], 1),  # not Grashof: one curve passes through both
        (bennett(), [1, 2, 1, 2], 1),
        (slider_crank(0.3, 0.8), [1, 0, 1, 0], 2),  # the slider on either side
    ],
    ids=["crank-rocker", "triple rocker", "Bennett", "slider-crank"],
)
def test_each_assembly_mode_has_its_curve_and_every_point_is_closed(linkage, guess, curves):
    shown = drive(linkage, linkage.assemble(guess).q)
    found = curves_of(shown)
    assert len(found) == curves
    for curve in found:
        assert np.linalg.norm(linkage.residual(curve), axis=-1).max() < 1e-11


def test_the_curve_of_a_full_turn_of_the_crank_is_cut_at_half_a_turn(crank_rocker):
    for curve in curves_of(crank_rocker):
        crank = curve[:, 0]
        assert (np.diff(crank) > 0).all()
        assert abs(crank[0] + np.pi) < 0.06
        assert crank[-1] - crank[0] == pytest.approx(2 * np.pi)


def test_the_first_configuration_is_the_start(crank_rocker):
    assert np.abs(np.exp(1j * np.array(crank_rocker.q)) - np.exp(1j * START)).max() < 0.03
    assert crank_rocker.q == crank_rocker.stops[int(crank_rocker.at)]["q"]


def test_curves_can_be_given_with_labels():
    curve = GRASHOF.trace(START, points=30).q
    shown = drive(GRASHOF, START, curves=[curve], labels=["elbow up"])
    assert {name: variant["closed"] for name, variant in shown.mode["variants"].items()} == {"elbow up": True}
