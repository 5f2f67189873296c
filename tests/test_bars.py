"""Four bars by compass and ruler, against the solver that closes any linkage, and against what the lengths must be."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kinlib import linkages
from kinlib.practice.bars import Bars, slider_place

lengths = st.floats(0.1, 2)
angles = st.floats(-np.pi, np.pi)


@given(st.tuples(lengths, lengths, lengths, lengths), angles)
def test_both_modes_close_the_loop_of_the_library(four, A):
    bars = Bars(*four)
    assume(np.hypot(*(bars.crank * np.array([np.cos(A), np.sin(A)]) - (bars.ground, 0))) > 1e-2)
    try:
        modes = bars.modes(A)
    except ValueError:
        return
    np.testing.assert_allclose(linkages.four_bar(*four).residual(modes), 0, atol=1e-7)


@given(st.tuples(lengths, lengths, lengths, lengths), angles)
def test_coupler_and_rocker_are_as_long_as_they_should_be_on_either_side(four, A):
    bars = Bars(*four)
    assume(np.hypot(*(bars.crank * np.array([np.cos(A), np.sin(A)]) - (bars.ground, 0))) > 1e-2)
    try:
        B, D, C = bars.joints(A)
    except ValueError:
        return
    np.testing.assert_allclose(np.linalg.norm(C - B, axis=1), bars.coupler, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(C - D, axis=1), bars.rocker, atol=1e-7)
    way, left = D - B, C[0] - B
    assert way[0] * left[1] - way[1] * left[0] >= -1e-12  # flat triangles have no left


def test_the_search_of_the_library_finds_the_same_two_modes():
    four = (0.4, 0.1, 0.35, 0.3)
    found = linkages.four_bar(*four).assembly_modes(hold={"A": 1.0})
    mine = Bars(*four).modes(1.0)
    np.testing.assert_allclose(found[np.argsort(found[:, 1])], mine[np.argsort(mine[:, 1])], atol=1e-12)


def test_the_dead_point_is_where_the_traced_crank_turns_back():
    linkage = linkages.four_bar(0.5, 0.3, 0.3, 0.3)
    curve = linkage.trace(linkage.assembly_modes(hold={"A": 0.5})[0], points=2001)
    assert curve.q[:, 0].max() == pytest.approx(Bars(0.5, 0.3, 0.3, 0.3).dead_point(), abs=1e-5)


@given(lengths, st.floats(0.2, 3), st.floats(-0.5, 0.5), angles, st.sampled_from([1, -1]))
def test_the_slider_is_a_rod_away_from_the_crank_pin(crank, rod, offset, A, side):
    assume(abs(offset - crank * np.sin(A)) < rod)
    B = crank * np.array([np.cos(A), np.sin(A)])
    slider = np.array([slider_place(crank, rod, offset, A, side), offset])
    assert np.linalg.norm(slider - B) == pytest.approx(rod, abs=1e-9)
    assert side * (slider - B)[0] >= 0


def test_bars_that_do_not_reach_are_refused_with_the_distance():
    with pytest.raises(ValueError, match="From B to D it is 5 m: circles of 1 and 1 m do not meet"):
        Bars(4, 1, 1, 1).joints(np.pi)


def test_a_crank_that_turns_right_round_has_no_dead_point():
    with pytest.raises(ValueError, match="not held back"):
        Bars(0.4, 0.1, 0.35, 0.3).dead_point()


def test_a_crank_pin_on_the_rocker_pin_is_refused():
    with pytest.raises(ValueError, match="B stands on D"):
        Bars(1, 1, 2, 2).joints(0.0)
