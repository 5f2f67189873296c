"""Nearly parallel axes: the common normal is where the drawing says, and leaves the picture as the angle becomes smaller."""

import numpy as np

from kincourse.lecture_07_frame_assignment.drawings import draw_nearly_parallel_axes
from kinlib.dh.common_normal import common_normal
from kinlib.view.drawing.figure_colours import ORANGE

X, Y, Z = np.eye(3)


def test_the_height_of_the_normal_is_that_of_the_common_normal():
    for degrees in (30, 9, 2, 0.1):
        angle = np.radians(degrees)
        tilted = Z * np.cos(angle) - Y * np.sin(angle)
        normal = common_normal((Z, 0 * Z), (tilted, 0.5 * Y + 0.2 * X), X, at_other_point=True)
        picture = draw_nearly_parallel_axes(degrees)
        assert f"{normal.start[2]:.3g} m above the floor" in picture.alt
        dot = f'r="6" fill="{ORANGE}"'
        assert ("inside the picture" in picture.alt) == (dot in picture.svg)
    assert "at every height" in draw_nearly_parallel_axes(0).alt
