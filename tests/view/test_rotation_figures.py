"""Drawings of sheet 01: two frames with one axis in common, and frames that can be read off a grid."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kinlib.chains.robots import X, Y, Z, pose
from kinlib.view import draw_frames
from kinlib.view.drawing.canvas import view_axes
from kinlib.view.figures.frames import draw_rotation


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("degrees", [35, -70])
def test_the_words_of_a_turn_say_what_scipy_turns(axis, degrees):
    """The first axis leans towards the second, or away from it, by the sign of the sine."""
    words = draw_rotation(axis, degrees).alt
    first, second = "xyz"[(axis + 1) % 3], "xyz"[(axis + 2) % 3]
    turned = Rotation.from_rotvec(np.radians(degrees) * np.eye(3)[axis]).as_matrix()
    share = turned["xyz".index(second), "xyz".index(first)]
    sign = "" if share > 0 else "-"
    assert f"{first}_b is {first}_a turned by {abs(degrees)} degrees towards {sign}{second}_a" in words


@pytest.mark.parametrize(("axis", "view", "facing"), [(0, "side", "at"), (1, "front", "away from"), (2, "top", "at")])
def test_the_words_of_a_turn_say_where_the_shared_axis_points(axis, view, facing):
    towards_the_eye = view_axes(view)[0][axis] > 0
    assert (facing == "at") == towards_the_eye
    assert f"points {facing} you" in draw_rotation(axis, 20).alt


def test_a_turn_about_no_axis_is_refused():
    with pytest.raises(ValueError, match="0, 1 or 2, for x, y or z; got 3"):
        draw_rotation(3, 20)


def test_numbers_bring_the_height_and_the_foot_of_each_frame():
    frames = {"s": np.eye(4), "b": pose((Y, Z, X), (3, -2, 1.5))}
    with_numbers = draw_frames(frames, arrows=False, numbers=True).svg
    without = draw_frames(frames, arrows=False).svg
    assert "(3, -2)" in with_numbers
    assert ">1.5<" in with_numbers
    assert "(3, -2)" not in without
