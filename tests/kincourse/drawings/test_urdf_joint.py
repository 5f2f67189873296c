"""A joint of a URDF: the picture and its text alternative show origin, axis and child frame of the joint that is drawn."""

import numpy as np
import pytest

from kincourse.lecture_09_urdf.drawings import draw_urdf_joint
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.picture import vector_text

LEAN = origin((0.3, 0.2, 0.4), (-np.pi / 2, 0, 0))


def test_the_text_alternative_gives_the_axis_in_both_frames():
    alt = draw_urdf_joint(LEAN, (0, 0, 1), 0.6, ("post", "rod")).alt
    assert "The axis (0, 0, 1) of the joint frame has the direction (0, 1, 0) in {post}" in alt
    assert f"its x along {vector_text([np.cos(0.6), 0, -np.sin(0.6)])}." in alt


def test_another_joint_has_another_text_alternative():
    right = draw_urdf_joint(LEAN, (0, 0, 1), 0.6).alt
    other = [
        draw_urdf_joint(LEAN, (0, 0, 1), 0.7),
        draw_urdf_joint(LEAN, (0, 1, 0), 0.6),
        draw_urdf_joint(origin((0.3, 0.2, 0.5), (-np.pi / 2, 0, 0)), (0, 0, 1), 0.6),
        draw_urdf_joint(LEAN, (0, 0, 1), 0.6, prismatic=True),
    ]
    assert len({right, *(picture.alt for picture in other)}) == 5


def test_a_prismatic_joint_moves_the_child_along_the_axis():
    assert "At q = 0.6 m the frame {child} of the child link is at (0.3, 0.8, 0.4)" in (
        draw_urdf_joint(LEAN, (0, 0, 1), 0.6, prismatic=True).alt
    )


def test_the_frame_at_zero_is_drawn_in_grey_only_if_the_joint_has_moved():
    grey = "#b6bec6"
    assert grey in draw_urdf_joint(LEAN, (0, 0, 1), 0.6).svg
    assert grey not in draw_urdf_joint(LEAN, (0, 0, 1), 0.0).svg


def test_an_axis_that_is_no_unit_vector_is_refused():
    with pytest.raises(ValueError, match=r"axis must be a unit vector; got \(0, 0, 2\), of length 2"):
        draw_urdf_joint(LEAN, (0, 0, 2), 0.6)
