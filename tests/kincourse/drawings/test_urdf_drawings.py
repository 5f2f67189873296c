"""The drawings of lecture 09: a joint with its origin and its axis, and the tree of a URDF with a path and a loop."""

import re

import numpy as np
import pytest

from kincourse.lecture_09_urdf.compare_urdf_readers import ARM, FOUR_BAR
from kincourse.lecture_09_urdf.drawings import draw_urdf_joint, draw_urdf_tree
from kinlib.rigid.rpy import origin
from kinlib.view.drawing.picture import vector_text

LEAN = origin((0.3, 0.2, 0.4), (-np.pi / 2, 0, 0))


def test_the_text_alternative_gives_the_axis_in_both_frames():
    for q in (0.6, 0.7):
        alt = draw_urdf_joint(LEAN, (0, 0, 1), q, ("post", "rod")).alt
        assert "The axis (0, 0, 1) of the joint frame has the direction (0, 1, 0) in {post}" in alt
        assert f"its x along {vector_text([np.cos(q), 0, -np.sin(q)])}." in alt
    with pytest.raises(ValueError, match=r"axis must be a unit vector; got \(0, 0, 2\), of length 2"):
        draw_urdf_joint(LEAN, (0, 0, 2), 0.6)


def test_every_link_and_joint_is_named_and_a_joint_that_closes_a_loop_is_dashed():
    loop = draw_urdf_tree(FOUR_BAR)
    for name in ("ground", "crank", "coupler", "rocker", *(f"{pin} (continuous)" for pin in "ABCD")):
        assert f">{name}</text>" in loop.svg
        assert name in loop.alt
    assert "Dashed: from ground by D (continuous) to rocker, which then has a second parent." in loop.alt
    assert loop.svg.count("stroke-dasharray") == 1
    joint = re.search(r'<joint name="D".*?</joint>', FOUR_BAR, re.DOTALL)[0]
    for tree in (draw_urdf_tree(ARM), draw_urdf_tree(FOUR_BAR.replace(joint, ""))):
        assert "Dashed" not in tree.alt
        assert "stroke-dasharray" not in tree.svg
    assert draw_urdf_tree(ARM, ("mast", "camera")).alt.endswith("Bold: the path mast, camera.")
    with pytest.raises(ValueError, match="the first element of a URDF must be <robot>"):
        draw_urdf_tree("<sdf/>")
