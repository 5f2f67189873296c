"""Screw axes: compared with Modern Robotics and with the motion of points, and converted back to lines."""

import modern_robotics as mr
import numpy as np
import pytest
import pytransform3d.transformations as pt
from hypothesis import given
from hypothesis import strategies as st
from strategies import directions, points, screws

from kinlib import line, screw

Z = (0, 0, 1)


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


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: screw(Z, pitch=[0.0, np.nan]),
            r"pitch must be a finite number, or inf .*; got nan\. .*negate the axis",
        ),
        (lambda: screw((0, 0, 2)), r"axis must be a unit vector; its length is 2\. .*Divide it by its norm"),
        (lambda: line([[*Z, 0, 0, 0], [0, 0, 0, 0, 3, 4]]), r"In S\[1\] the length of v \(omega is zero.*\) is 5\. "),
        (lambda: line(np.zeros(6)), r"In S the length of v .* is 0\. A revolute joint needs an axis, and a prismatic"),
        (
            lambda: line([1e-17, 0, 0, 0, 0, 1]),
            r"length of omega is 1e-17\. .* needs a direction, and an omega of 0",
        ),
    ],
)
def test_what_is_no_screw_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()
