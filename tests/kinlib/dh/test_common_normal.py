"""Common normals: each case of two lines by what makes it one; test_frame_assignment.py compares their feet with SciPy."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import directions, points

from kinlib.dh.common_normal import common_normal

X, Y, Z = np.eye(3)


def close(got, expected, atol=1e-12):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


@pytest.mark.parametrize(("before", "x"), [(X, X), (-X, -X), (-X + Z, -X), (Y, X), (Z, X)])
def test_for_intersecting_axes_x_is_close_to_the_previous_x(before, x):
    """X and -X are perpendicular to both Z and Y. If neither is closer, it is z x z'."""
    found = common_normal((Z, 5 * Z), (-Y, 2 * Y), before, at_other_point=True)
    assert found.case == "intersecting"
    close(found.x, x)
    close([found.start, found.end], np.zeros((2, 3)))


@given(directions(), points(), points(), st.sampled_from([1, -1]), st.booleans())
def test_parallel_axes_have_the_normal_at_one_joint_or_at_the_other(z, origin, other_point, sign, at_other_point):
    between = other_point - origin
    across = between - z * (z @ between)
    assume(np.linalg.norm(across) > 1e-3)
    found = common_normal((z, origin), (sign * z, other_point), X, at_other_point=at_other_point)
    assert found.case == {1: "parallel", -1: "antiparallel"}[sign]
    close(found.x, across / np.linalg.norm(across))
    close(found.end if at_other_point else found.start, other_point if at_other_point else origin)
    close(found.end - found.start, across)
    assert not found.is_unique
    assert found.sine < 1e-15


@pytest.mark.parametrize(
    ("angle", "nearly", "case"),
    [(1e-13, False, "parallel"), (1e-9, True, "skew"), (0.9e-5, True, "skew"), (1.1e-5, False, "skew")],
)
def test_what_is_nearly_parallel_is_said_and_may_be_taken_as_parallel(angle, nearly, case):
    leaning = (np.array([0, np.sin(angle), np.cos(angle)]), X)
    found = common_normal((Z, 0 * Z), leaning, Y, at_other_point=True)
    assert (found.is_nearly_parallel, found.case) == (nearly, case)
    assert found.sine == pytest.approx(angle)
    taken = common_normal((Z, 0 * Z), leaning, Y, at_other_point=True, parallel_below=1e-4)
    assert (taken.is_nearly_parallel, taken.case) == (nearly, "parallel")
