"""Drawings of rotations about a coordinate axis, and frames whose coordinates can be read off a numbered grid."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kincourse.lecture_01_frames.drawings import draw_rotation
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.view import draw_frames
from kinlib.view.drawing.canvas import view_axes


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("degrees", [35, -70])
def test_the_text_alternative_gives_the_rotation_that_scipy_computes(axis, degrees):
    """The sign of the sine says whether the first axis rotates towards the second or away from it."""
    words = draw_rotation(axis, degrees).alt
    first, second = "xyz"[(axis + 1) % 3], "xyz"[(axis + 2) % 3]
    turned = Rotation.from_rotvec(np.radians(degrees) * np.eye(3)[axis]).as_matrix()
    share = turned["xyz".index(second), "xyz".index(first)]
    sign = "" if share > 0 else "-"
    assert f"{first}_b is {first}_a rotated by {abs(degrees)} degrees towards {sign}{second}_a" in words


@pytest.mark.parametrize(("axis", "view", "facing"), [(0, "side", "at"), (1, "front", "away from"), (2, "top", "at")])
def test_the_text_alternative_says_where_the_common_axis_points(axis, view, facing):
    towards_the_viewer = view_axes(view)[0][axis] > 0
    assert (facing == "at") == towards_the_viewer
    assert f"points {facing} you" in draw_rotation(axis, 20).alt


def test_another_axis_is_refused():
    with pytest.raises(ValueError, match="0, 1 or 2, for x, y or z; got 3"):
        draw_rotation(3, 20)


def test_a_numbered_grid_labels_height_and_foot_of_each_frame():
    frames = {"s": np.eye(4), "b": pose((Y, Z, X), (3, -2, 1.5))}
    with_numbers = draw_frames(frames, arrows=False, numbers=True).svg
    without = draw_frames(frames, arrows=False).svg
    assert "(3, -2)" in with_numbers
    assert ">1.5<" in with_numbers
    assert "(3, -2)" not in without
