"""Nearly parallel axes: the common normal is where the drawing says, and leaves the picture as the angle becomes smaller."""

import numpy as np
import pytest

from kincourse.lecture_07_frame_assignment.drawings import draw_nearly_parallel_axes
from kinlib.dh.common_normal import common_normal

X, Y, Z = np.eye(3)


@pytest.mark.parametrize("degrees", [30, 9, 2, 0.1])
def test_the_height_of_the_normal_is_that_of_the_common_normal(degrees):
    angle = np.radians(degrees)
    normal = common_normal(
        (Z, 0 * Z), (Z * np.cos(angle) - Y * np.sin(angle), 0.5 * Y + 0.2 * X), X, at_other_point=True
    )
    picture = draw_nearly_parallel_axes(degrees)
    assert f"{normal.start[2]:.3g} m above the floor" in picture.alt
    assert ("inside the picture" in picture.alt) == ("<circle" in picture.svg.partition("common normal")[0][-400:])


def test_parallel_axes_have_a_normal_at_every_height():
    assert "at every height" in draw_nearly_parallel_axes(0).alt


@pytest.mark.parametrize("degrees", [-1, 90, np.nan])
def test_other_angles_are_refused(degrees):
    with pytest.raises(ValueError, match="at least 0 and less than 90"):
        draw_nearly_parallel_axes(degrees)
