"""The square of two angles: no curve is lost where it leaves the square, and a mark is where its angles are."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kincourse.lecture_08_closed_chains.drawings.torus import (
    LEFT_PX,
    SQUARE_PX,
    TOP_PX,
    draw_torus,
    side_by_side,
    split_where_wrapped,
)
from kinlib import linkages
from kinlib.view import draw_linkage

angles = st.floats(-20, 20)
LABELS = {"xlabel": "A", "ylabel": "D"}


@given(st.lists(st.tuples(angles, angles), min_size=1, max_size=20))
def test_a_curve_that_is_split_stays_the_same_curve(points):
    pieces = np.concatenate(split_where_wrapped(np.array(points)))
    assert np.abs(pieces).max() <= 180
    np.testing.assert_allclose(np.exp(1j * np.radians(pieces)), np.exp(1j * np.array(points)), atol=1e-9)


def test_no_line_runs_across_the_square():
    """A curve of three full turns is cut where it leaves the square, not connected by a line from edge to edge."""
    turn = np.linspace(0, 6 * np.pi, 400)
    picture = draw_torus({"round": np.stack([turn, turn / 3], axis=1)}, **LABELS)
    curves = re.findall(r'points="([^"]*)" fill="none" stroke="#7d3ac1"', picture.svg)
    assert len(curves) == 4
    for curve in curves:
        x = [float(pair.split(",")[0]) for pair in curve.split()]
        assert np.abs(np.diff(x)).max() < 0.05 * SQUARE_PX


def test_a_mark_is_drawn_at_its_angles():
    picture = draw_torus({"still": np.zeros((2, 2))}, {"now": [2 * np.pi - np.pi / 2, np.pi / 2]}, **LABELS)
    x, y = map(float, re.search(r'<circle cx="([\d.]+)" cy="([\d.]+)"', picture.svg).groups())
    assert (x, y) == pytest.approx((LEFT_PX + SQUARE_PX / 4, TOP_PX + SQUARE_PX / 4), abs=0.1)
    assert all(f">{name}</text>" in picture.svg for name in ("now", "still", "A", "D"))


def test_curves_differ_by_dash_as_well_as_by_colour():
    picture = draw_torus({name: np.zeros((2, 2)) + k for k, name in enumerate("abc")}, **LABELS)
    kinds = re.findall(r'stroke="(#[^"]+)" stroke-width="2.2"( stroke-dasharray="[^"]*")?', picture.svg)
    assert len({colour for colour, _ in kinds}) == len({dash for _, dash in kinds}) == 3
    with pytest.raises(ValueError, match="at most 3 entries, one per line style; got 4"):
        draw_torus({name: np.zeros((2, 2)) for name in "abcd"}, **LABELS)


def test_two_pictures_side_by_side_have_both_text_alternatives():
    one = draw_torus({"a": np.zeros((2, 2))}, **LABELS)
    two = side_by_side(one, draw_linkage(linkages.triangle(), [0, 0, 0]), "caption")
    assert one.alt in two.alt
    assert "triangle with the bodies" in two.alt
    assert two.svg.count("<svg ") == 3
    assert two.caption == "caption"
