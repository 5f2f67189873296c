"""Drawings of linkages: bars as long as their links, and gaps where a loop is open."""

import numpy as np
import pytest

from kinlib import linkages
from kinlib.view.figures.linkage import draw_linkage, linkage_geometry

ALL = [
    linkages.four_bar(0.4, 0.1, 0.35, 0.3),
    linkages.slider_crank(0.1, 0.3, 0.05),
    linkages.five_bar(1, (1, 1), (1, 1)),
    linkages.ten_links(),
    linkages.parallelogram(),
    linkages.triangle(),
    linkages.stretched_arch(),
    linkages.bennett(),
    linkages.bricard(),
    linkages.sarrus(),
    linkages.stewart_gough(),
]
each = pytest.mark.parametrize("mechanism", ALL, ids=lambda mechanism: mechanism.name)


@each
def test_an_assembled_linkage_has_no_gap(mechanism):
    guesses = (np.random.default_rng(seed).uniform(-0.5, 0.5, mechanism.n) for seed in range(20))
    found = next(found for found in map(mechanism.assemble, guesses) if found.converged)
    geometry = linkage_geometry(mechanism, found.q)
    assert np.abs(geometry.first - geometry.second).max() < 1e-9
    assert draw_linkage(mechanism, found.q).alt.endswith("It is closed.")


def test_an_open_linkage_shows_its_gap_and_gives_its_width():
    mechanism = linkages.four_bar(4, 1, 3.5, 3)
    picture = draw_linkage(mechanism, [0, 0, 0, 0])
    # Stretched out along x the coupler ends at 1 + 3.5, the rocker at 4 + 3.
    assert "It is open: at C a gap of 2.5 is left." in picture.alt
    assert "#b35900" in picture.svg
    assert "#b35900" not in draw_linkage(mechanism, mechanism.assemble([1, 0, 2, 0]).q).svg
