"""The threads of lecture 04: as long as the moments that they stand for, and refused where there is no such form."""

import numpy as np
import pytest

from kinlib import robots
from kinlib.view.figures.mid_formula import axis_perpendiculars, draw_mid_formula

ARMS = [robots.rpr(), robots.rppr(), robots.youbot(), robots.puma560(), robots.mid_formula_arm(), robots.angled_arm()]


@pytest.mark.parametrize("chain", ARMS, ids=lambda chain: chain.name)
def test_a_thread_is_as_long_as_the_moment_of_its_screw(chain):
    """|v| of a joint that turns without pitch is the distance of its axis from the origin of whoever reads it."""
    turns = chain.screws[:, :3].any(axis=-1)
    for k in range(chain.n + 1):
        ends = axis_perpendiculars(chain, k)
        read = np.concatenate([chain.screws[:k], chain.body_screws[k:]])
        far = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
        np.testing.assert_allclose(far[turns], np.linalg.norm(read[turns, 3:], axis=-1), atol=1e-12)
        assert not far[~turns].any()


def test_a_thread_meets_the_axis_square():
    chain = robots.angled_arm()
    ends = axis_perpendiculars(chain, 2)
    np.testing.assert_allclose(np.sum((ends[:2, 1] - ends[:2, 0]) * chain.screws[:2, :3], axis=-1), 0, atol=1e-12)


def test_the_words_name_the_reader_of_each_axis():
    alt = draw_mid_formula(robots.rppr(), 1).alt
    assert "Read from {s}: S_1 at 2 m." in alt
    assert "Read from {b}: B_2 a slide, B_3 a slide, B_4 at 2 m." in alt


def test_all_may_be_read_from_one_side():
    assert "{b}" not in draw_mid_formula(robots.rppr(), 4).alt
    assert "{s}" not in draw_mid_formula(robots.rppr(), 0).alt


@pytest.mark.parametrize("k", [-1, 5, 1.5, None])
def test_a_form_that_there_is_not_is_refused(k):
    with pytest.raises(ValueError, match="k counts the joints that are read from"):
        draw_mid_formula(robots.rppr(), k)
