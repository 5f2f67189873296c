"""The drawings of lectures 00, 01 and 10: the parts of an arm, the readings of a pose, a rotation, and two arms with one tray."""

from itertools import product

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kincourse.lecture_00_start_here.drawings import draw_parts
from kincourse.lecture_01_frames.drawings import draw_rotation, draw_three_readings
from kinlib.chains.robots import X, Y, Z, pose, rpr, youbot
from kinlib.view.drawing.canvas import view_axes
from kinlib.view.drawing.picture import vector_text


def test_every_part_is_named_and_every_joint_is_where_it_is():
    """But not the end-effector: where it is, a blank step asks for."""
    for chain in (youbot(), rpr()):
        alt = draw_parts(chain).alt
        assert all(f"joint {i} (" in alt for i in range(1, chain.n + 1))
        assert all(f"link {i}" in alt for i in range(1, chain.n))
        assert alt.index("base") < alt.index("joint 1") < alt.index("link 1") < alt.index("end-effector")
        joints = chain.link_poses(np.zeros(chain.n))[:, :3, 3]
        assert all(f"{i} at {vector_text(p)}" in alt for i, p in enumerate(joints, start=1))
        assert alt.partition("Joints, in metres")[0].endswith("to the end-effector. ")
    svg = draw_parts(youbot()).svg
    assert all(f"link {i}" in svg for i in (1, 2, 3))
    assert "link 4" not in svg, "a link without length has no label"


def test_what_cannot_be_drawn_is_refused():
    for T, point in [
        (pose((X, -Z, Y), (1, 0, 0)), [1, 0, 0]),
        (pose((X, Y, Z), (0, 0, 1)), [1, 0, 0]),
        (np.eye(4), [0, 0, 1]),
    ]:
        with pytest.raises(ValueError, match="rotation about z"):
            draw_three_readings(T, point)
    with pytest.raises(ValueError, match="0, 1 or 2, for x, y or z; got 3"):
        draw_rotation(3, 20)


def test_the_text_alternative_gives_the_rotation_that_scipy_computes_and_where_the_axis_points():
    """The sign of the sine says whether the first axis rotates towards the second or away from it."""
    for (axis, view), degrees in product(enumerate(("side", "front", "top")), (35, -70)):
        words = draw_rotation(axis, degrees).alt
        first, second = "xyz"[(axis + 1) % 3], "xyz"[(axis + 2) % 3]
        turned = Rotation.from_rotvec(np.radians(degrees) * np.eye(3)[axis]).as_matrix()
        sign = "" if turned["xyz".index(second), "xyz".index(first)] > 0 else "-"
        assert f"{first}_b is {first}_a rotated by {abs(degrees)} degrees towards {sign}{second}_a" in words
        assert f"points {'at' if view_axes(view)[0][axis] > 0 else 'away from'} you" in words
