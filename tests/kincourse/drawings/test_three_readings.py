"""The three readings of a pose: the text alternative has the numbers that are drawn, and only plane motions are accepted."""

import numpy as np
import pytest

from kincourse.lecture_01_frames.drawings import draw_three_readings
from kinlib.chains.robots import X, Y, Z, pose


def test_the_text_alternative_has_the_pose_and_both_coordinates_of_the_point():
    T = pose((Y, -X, Z), (2, 1, 0))
    alt = draw_three_readings(T, [0.5, 0.25, 0]).alt
    assert "frame {b} at (2, 1, 0) in {a}, rotated by 90 degrees" in alt
    assert "(0.5, 0.25, 0) in {b} is (1.75, 1.5, 0) in {a}" in alt
    assert alt != draw_three_readings(np.eye(4), [0.5, 0.25, 0]).alt


def test_all_three_readings_have_a_title():
    svg = draw_three_readings(pose((X, Y, Z), (1, 0, 0)), [0.5, 0.5, 0]).svg
    assert all(title in svg for title in ("pose", "change of coordinates", "motion"))


@pytest.mark.parametrize(
    ("T", "point"),
    [(pose((X, -Z, Y), (1, 0, 0)), [1, 0, 0]), (pose((X, Y, Z), (0, 0, 1)), [1, 0, 0]), (np.eye(4), [0, 0, 1])],
)
def test_what_leaves_the_plane_is_refused(T, point):
    with pytest.raises(ValueError, match="rotation about z"):
        draw_three_readings(T, point)
