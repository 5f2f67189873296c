"""The picture of two arms that hold one tray."""

import numpy as np
import pytest

import kinlib as kl
from kincourse.lecture_10_one_robot_four_ways.drawings import draw_two_arms
from kinlib.chains.robots import X, Y, Z, pose

Q = np.radians([0, -75, 60, 0, -75, 0])


def pair(width):
    """Two PUMAs that hold the ends of a tray, and the base of the second."""
    robot = kl.robots.puma560()
    left, other = (
        kl.Chain(robot.screws, robot.home @ pose((Y, Z, X), (0, side * width / 2, 0.15)), robot.joint_points)
        for side in (1, -1)
    )
    base = left.fk(Q) @ kl.inverse(other.fk(Q))
    points = other.joint_points @ base[:3, :3].T + base[:3, 3]
    return left, kl.Chain(other.screws @ kl.adjoint(base).T, base @ other.home, points), base


def test_the_text_says_where_the_tray_and_the_bases_are():
    left, right, base = pair(0.8)
    alt = draw_two_arms(left, right, Q, Q, width=0.8, base=base).alt
    assert "0.8 m wide" in alt
    assert "(0, 0, 0) and (0, -0.8, 0)" in alt
    moved = Q + 0.3 * np.eye(6)[0]
    assert alt != draw_two_arms(left, left, moved, moved, width=0.8, base=np.eye(4)).alt


def test_arms_that_do_not_hold_the_same_tray_are_refused():
    left, right, base = pair(0.8)
    with pytest.raises(ValueError, match="same pose"):
        draw_two_arms(left, right, Q, Q + 0.1, width=0.8, base=base)
