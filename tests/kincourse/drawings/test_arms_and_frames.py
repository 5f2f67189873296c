"""The drawings of lecture 01: the readings of a pose, and a rotation."""

from itertools import product

import numpy as np
from scipy.spatial.transform import Rotation

from kincourse.lecture_01_frames.drawings import draw_rotation
from kinlib.view.drawing.canvas import view_axes


def test_the_text_alternative_gives_the_rotation_that_scipy_computes_and_where_the_axis_points():
    """The sign of the sine says whether the first axis rotates towards the second or away from it."""
    for (axis, view), degrees in product(enumerate(("side", "front", "top")), (35, -70)):
        words = draw_rotation(axis, degrees).alt
        first, second = "xyz"[(axis + 1) % 3], "xyz"[(axis + 2) % 3]
        turned = Rotation.from_rotvec(np.radians(degrees) * np.eye(3)[axis]).as_matrix()
        sign = "" if turned["xyz".index(second), "xyz".index(first)] > 0 else "-"
        assert f"{first}_b is {first}_a rotated by {abs(degrees)} degrees towards {sign}{second}_a" in words
        assert f"points {'at' if view_axes(view)[0][axis] > 0 else 'away from'} you" in words
