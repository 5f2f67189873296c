"""The drawing of a joint of a URDF, with its origin and its axis."""

import numpy as np

from kincourse.lecture_09_urdf.drawings import draw_urdf_joint
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.picture import vector_text

LEAN = origin((0.3, 0.2, 0.4), (-np.pi / 2, 0, 0))


def test_the_text_alternative_gives_the_axis_in_both_frames():
    for q in (0.6, 0.7):
        alt = draw_urdf_joint(LEAN, (0, 0, 1), q, ("post", "rod")).alt
        assert "The axis (0, 0, 1) of the joint frame has the direction (0, 1, 0) in {post}" in alt
        assert f"its x along {vector_text([np.cos(q), 0, -np.sin(q)])}." in alt
