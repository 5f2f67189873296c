"""The tree of a URDF: every joint is drawn and named, a path is bold, and a joint that closes a loop is dashed."""

import re

import pytest

from kincourse.lecture_09_urdf.drawings import draw_urdf_tree
from kincourse.lecture_09_urdf.readers import ARM, FOUR_BAR


def test_every_link_and_joint_is_drawn_and_named():
    picture = draw_urdf_tree(FOUR_BAR)
    for name in (
        "ground",
        "crank",
        "coupler",
        "rocker",
        "A (continuous)",
        "B (continuous)",
        "C (continuous)",
        "D (continuous)",
    ):
        assert f">{name}</text>" in picture.svg
        assert name in picture.alt


def test_a_joint_that_closes_a_loop_is_dashed_and_named():
    loop, tree = draw_urdf_tree(FOUR_BAR), draw_urdf_tree(ARM)
    assert "Dashed: from ground by D (continuous) to rocker, which then has a second parent." in loop.alt
    assert loop.svg.count("stroke-dasharray") == 1
    assert "Dashed" not in tree.alt
    assert "stroke-dasharray" not in tree.svg


def test_without_the_closing_joint_the_same_links_are_a_tree():
    joint = re.search(r'<joint name="D".*?</joint>', FOUR_BAR, re.DOTALL)[0]
    assert "Dashed" not in draw_urdf_tree(FOUR_BAR.replace(joint, "")).alt


def test_a_path_is_bold():
    picture = draw_urdf_tree(ARM, ("mast", "camera"))
    assert picture.alt.endswith("Bold: the path mast, camera.")
    assert picture.svg.count('stroke-width="3.2"') == 1
    assert draw_urdf_tree(ARM).svg.count('stroke-width="3.2"') == 0


def test_another_format_is_refused():
    with pytest.raises(ValueError, match="the first element of a URDF must be <robot>"):
        draw_urdf_tree("<sdf/>")
