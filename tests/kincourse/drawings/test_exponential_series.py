"""Drawings of the exponential series and of screw motions: they end where the exponential takes the point or frame."""

import mpmath
import mpmath_oracle
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import points, screws

from kincourse.lecture_02_matrix_exponential.drawings import draw_series
from kincourse.lecture_02_matrix_exponential.drawings.exponential_series import partial_sums
from kinlib import exp, inverse, log, robots, screw
from kinlib.view.figures.screw_motions import draw_motions


@pytest.mark.parametrize("q", [0.0, 1e-9, np.pi / 2, -2.0, 2 * np.pi])
@pytest.mark.parametrize("chain", [robots.rpr(), robots.hrr(), robots.angled_arm()], ids=lambda chain: chain.name)
def test_the_sums_converge_to_the_exponential(chain, q):
    for S in chain.screws:
        goal = exp(S * q) @ np.append(chain.home[:3, 3], 1.0)
        np.testing.assert_allclose(partial_sums(S, q, chain.home[:3, 3], 60)[-1], goal[:3], atol=1e-12)


def test_a_translation_needs_two_terms():
    sums = partial_sums((0, 0, 0, 0, 0, 1), 2.0, (1, 2, 3), 5)
    np.testing.assert_array_equal(sums[1:], np.broadcast_to((1, 2, 5), (4, 3)))


def test_each_term_is_orthogonal_to_the_one_before():
    steps = np.diff(partial_sums(robots.rpr().screws[0], 1.3, (0, 1, 2), 12), axis=0)
    np.testing.assert_allclose(np.sum(steps[1:] * steps[:-1], axis=-1), 0, atol=1e-12)


def test_four_terms_are_on_the_circle_at_the_root_of_three_and_not_at_the_goal():
    """|1 + i t - t^2/2 - i t^3/6| = 1 at t = sqrt(3), so the sum is a rotation, but the wrong one."""
    picture = draw_series((0, 0, 1, 0, 0, 0), np.sqrt(3), (1, 0, 0), 4)
    assert picture.caption == "4 terms: the sum is 0.36 m from its goal, less than 1e-12 m off the circle"


def test_a_helical_joint_is_refused():
    with pytest.raises(ValueError, match=r"S must be the screw axis of a revolute joint, of pitch 0; got pitch 0\.1"):
        draw_series(robots.hrr().screws[0], 1.0, (1, 0, 0), 3)


@pytest.mark.parametrize("terms", [0, -1])
def test_fewer_than_one_term_is_refused(terms):
    with pytest.raises(ValueError, match="terms must be at least 1"):
        draw_series((0, 0, 1, 0, 0, 0), 1.0, (1, 0, 0), terms)


def test_the_text_alternative_describes_each_motion_and_its_end():
    arm = robots.hrr()
    alt = draw_motions(arm.home, {"screw": arm.screws[0] * np.pi, "slide": screw((0, 0, 1), pitch=np.inf) * 0.5}).alt
    assert 'Motion "screw": a rotation by 180 degrees about (0, 0, 1), 0.314 m along it, to (-0.8, 0, 0.314).' in alt
    assert 'Motion "slide": a translation by 0.5 m, to (0.8, 0, 0.5).' in alt


def test_the_motion_between_two_poses_ends_at_the_second():
    arm = robots.youbot()
    goal = arm.fk([0, 0, np.pi / 2, -np.pi / 2, -np.pi / 4])
    alt = draw_motions(arm.home, {"one screw": log(goal @ inverse(arm.home))}).alt
    assert alt.endswith("to (0.405, 0, 0.282).")


@pytest.mark.parametrize("motions", [{}, dict.fromkeys("abcde", np.eye(1, 6)[0])])
def test_no_motion_and_too_many_motions_are_refused(motions):
    with pytest.raises(ValueError, match="motions must contain 1 to 4 twists"):
        draw_motions(np.eye(4), motions)


@pytest.mark.oracle("mpmath", partial_sums)
@given(screws(), st.floats(-3, 3), points())
def test_each_sum_is_a_sum_of_powers_with_40_digits(S, q, point):
    with mpmath.workdps(mpmath_oracle.DIGITS):
        X = mpmath_oracle.hat(mpmath_oracle.numbers(S)) * mpmath.mpf(q)
        start = mpmath.matrix([*mpmath_oracle.numbers(point), 1])
        sums, total = [], mpmath.zeros(4)
        for k in range(6):
            total += X**k / mpmath.factorial(k)
            sums.append(mpmath_oracle.doubles((total * start).T)[0, :3])
    np.testing.assert_allclose(partial_sums(S, q, point, 6), sums, rtol=0, atol=1e-12)
