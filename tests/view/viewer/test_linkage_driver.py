"""Closed chains in the viewer: every configuration on the slider is closed."""

import numpy as np
import pytest

from kinlib.mechanisms.linkages import bennett, four_bar, slider_crank
from kinlib.view import drive

GRASHOF = four_bar(0.4, 0.1, 0.35, 0.3)
START = GRASHOF.assembly_modes(hold={"A": 1.0})[0]


def curves_of(shown):
    return [np.array([stop["q"] for stop in variant["stops"]]) for variant in shown.mode["variants"].values()]


@pytest.mark.parametrize(
    ("linkage", "guess"),
    [(GRASHOF, START), (bennett(), [1, 2, 1, 2]), (slider_crank(0.3, 0.8), [1, 0, 1, 0])],
    ids=["crank-rocker", "Bennett", "slider-crank"],
)
def test_every_point_of_the_curve_through_the_start_is_closed(linkage, guess):
    (curve,) = curves_of(drive(linkage, linkage.assemble(guess).q))
    assert np.linalg.norm(linkage.residual(curve), axis=-1).max() < 1e-11


def test_the_first_configuration_is_the_start():
    shown = drive(GRASHOF, START, across=("A", "D"))
    assert np.abs(np.exp(1j * np.array(shown.q)) - np.exp(1j * START)).max() < 0.03
    assert shown.q == shown.stops[int(shown.at)]["q"]


def test_curves_can_be_given_with_labels():
    curve = GRASHOF.trace(START, points=30).q
    shown = drive(GRASHOF, START, curves=[curve, curve[:9]], labels=["elbow up", "a part"])
    closed = {name: variant["closed"] for name, variant in shown.mode["variants"].items()}
    assert closed == {"elbow up": True, "a part": False}
