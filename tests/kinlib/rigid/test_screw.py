"""Screw axes: compared with Modern Robotics and with the motion of points, and converted back to lines."""

import modern_robotics as mr
import numpy as np
import pytransform3d.transformations as pt
from hypothesis import given
from hypothesis import strategies as st
from strategies import directions, points, screws

from kinlib import line, screw


def close(got, expected, atol=1e-13):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


@given(points(), directions(), st.floats(-1, 1))
def test_a_screw_agrees_with_modern_robotics(point, axis, pitch):
    close(screw(axis, point, pitch), mr.ScrewToAxis(point, axis, pitch))
    close(screw(axis, point), mr.ScrewToAxis(point, axis, 0))


@given(screws())
def test_a_line_is_the_one_of_pytransform3d(S):
    point, axis, pitch = pt.screw_parameters_from_screw_axis(S)
    for got, expected in zip(line(S), (axis, point, pitch), strict=True):
        close(got, expected)
