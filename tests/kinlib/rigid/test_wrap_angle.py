"""Angles between -pi and pi: against pytransform3d, and left as they are where they lie there already."""

import numpy as np
import pytest
import pytransform3d.rotations as pr
from hypothesis import given
from hypothesis import strategies as st

from kinlib.rigid.angles import wrap_angle


@pytest.mark.oracle("pytransform3d", wrap_angle)
@given(st.floats(-100, 100))
def test_a_wrapped_angle_is_that_of_pytransform3d(angle):
    off = wrap_angle(angle) - pr.norm_angle(angle)
    # Beside the cut, rounding decides between pi and -pi.
    assert min(abs(off), abs(abs(off) - 2 * np.pi)) < 1e-13
    assert abs(wrap_angle(angle)) <= np.pi + 1e-14


def test_half_a_turn_is_pi_on_both_sides():
    np.testing.assert_array_equal(wrap_angle([np.pi, -np.pi, 3 * np.pi, -3 * np.pi]), np.full(4, np.pi))
    assert wrap_angle(np.zeros((2, 0, 3))).shape == (2, 0, 3)
