"""The drawings of lectures 00, 01 and 10: the parts of an arm, the readings of a pose, a rotation, and two arms with one tray."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import kinlib as kl
from kincourse.lecture_00_start_here.drawings import draw_parts
from kincourse.lecture_01_frames.drawings import draw_rotation, draw_three_readings
from kincourse.lecture_10_one_robot_four_ways.drawings import draw_two_arms
from kinlib.chains.robots import X, Y, Z, pose, rpr, youbot
from kinlib.view.drawing.canvas import view_axes


def test_every_part_is_named_in_the_text_alternative():
    alt = draw_parts(youbot()).alt
    assert [f"joint {i} (revolute)" in alt for i in range(1, 6)] == [True] * 5
    assert [f"link {i}" in alt for i in range(1, 5)] == [True] * 4
    assert alt.index("base") < alt.index("joint 1") < alt.index("link 1") < alt.index("end-effector")


def test_the_text_alternative_says_where_the_end_effector_is():
    x, y, z = rpr().home[:3, 3]
    assert f"end-effector at ({x:.3g}, {y:.3g}, {z:.3g}) m" in draw_parts(rpr()).alt


def test_links_without_length_have_no_label():
    svg = draw_parts(youbot()).svg
    assert all(f"link {i}" in svg for i in (1, 2, 3))
    assert "link 4" not in svg


def test_the_text_alternative_has_the_pose_and_both_coordinates_of_the_point():
    T = pose((Y, -X, Z), (2, 1, 0))
    alt = draw_three_readings(T, [0.5, 0.25, 0]).alt
    assert "frame {b} at (2, 1, 0) in {a}, rotated by 90 degrees" in alt
    assert "(0.5, 0.25, 0) in {b} is (1.75, 1.5, 0) in {a}" in alt
    assert alt != draw_three_readings(np.eye(4), [0.5, 0.25, 0]).alt


def test_all_three_readings_have_a_title():
    svg = draw_three_readings(pose((X, Y, Z), (1, 0, 0)), [0.5, 0.5, 0]).svg
    assert all(title in svg for title in ("pose", "change of coordinates", "motion"))


@pytest.mark.parametrize(
    ("T", "point"),
    [(pose((X, -Z, Y), (1, 0, 0)), [1, 0, 0]), (pose((X, Y, Z), (0, 0, 1)), [1, 0, 0]), (np.eye(4), [0, 0, 1])],
)
def test_what_leaves_the_plane_is_refused(T, point):
    with pytest.raises(ValueError, match="rotation about z"):
        draw_three_readings(T, point)


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


TRAY_Q = np.radians([0, -75, 60, 0, -75, 0])


def pair(width):
    """Two PUMAs that hold the ends of a tray, and the base of the second."""
    robot = kl.robots.puma560()
    left, other = (
        kl.Chain(robot.screws, robot.home @ pose((Y, Z, X), (0, side * width / 2, 0.15)), robot.joint_points)
        for side in (1, -1)
    )
    base = left.fk(TRAY_Q) @ kl.inverse(other.fk(TRAY_Q))
    points = other.joint_points @ base[:3, :3].T + base[:3, 3]
    return left, kl.Chain(other.screws @ kl.adjoint(base).T, base @ other.home, points), base


def test_the_text_says_where_the_tray_and_the_bases_are():
    left, right, base = pair(0.8)
    alt = draw_two_arms(left, right, TRAY_Q, TRAY_Q, width=0.8, base=base).alt
    assert "0.8 m wide" in alt
    assert "(0, 0, 0) and (0, -0.8, 0)" in alt
    moved = TRAY_Q + 0.3 * np.eye(6)[0]
    assert alt != draw_two_arms(left, left, moved, moved, width=0.8, base=np.eye(4)).alt


def test_arms_that_do_not_hold_the_same_tray_are_refused():
    left, right, base = pair(0.8)
    with pytest.raises(ValueError, match="same pose"):
        draw_two_arms(left, right, TRAY_Q, TRAY_Q + 0.1, width=0.8, base=base)
