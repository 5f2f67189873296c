"""Drawn frames, judged by the rules: every right assignment passes, and each broken rule is named at its frame."""

import numpy as np
import pytest
from hypothesis import given
from outside.motions import pose
from strategies import rotations

import kinlib as kl
from kinlib import assign_frames, check_frames

ARM = kl.robots.youbot()
RIGHT = assign_frames(ARM, convention="standard").frames


def drawn(frame, change):
    """The right frames with one of them changed from within."""
    frames = RIGHT.copy()
    frames[frame] = frames[frame] @ change
    return frames


def along(x):
    """The right frames with another x_1, which need not be perpendicular to z_1 nor a unit vector."""
    frames = RIGHT.copy()
    frames[1, :3, 0] = x
    return frames


BROKEN = {
    "a left-handed frame": (
        drawn(3, np.diag([1, -1, 1, 1])),
        (3, "right-handed", "Frame 3 is left-handed: y_3 must be z_3 x x_3. Negate y_3."),
    ),
    "z off its direction": (
        drawn(2, kl.exp([0.3, 0, 0, 0, 0, 0])),
        (2, "z along axis", "z_2 must be along the axis of joint 3, but is not."),
    ),
    "an origin beside the axis": (
        drawn(2, kl.exp([0, 0, 0, 0, 0.1, 0])),
        (2, "origin on axis", "The origin of frame 2 must lie on the axis of joint 3; it is 0.1 m away."),
    ),
    "x turned about z": (
        drawn(1, kl.exp([0, 0, 0.3, 0, 0, 0])),
        (1, "x perpendicular to z", "x_1 must be perpendicular to z_0; the angle is 72.81 degrees."),
    ),
    "x along z": (
        along(2 * RIGHT[0, :3, 2]),
        (1, "x perpendicular to z", "x_1 must be perpendicular to z_0; the angle is 0 degrees."),
    ),
    "x beside the common normal": (
        drawn(1, kl.exp([0, 0, 0, 0, 0, 0.2])),
        (1, "x meets z", "The line of x_1 must intersect the axis z_0; it passes at a distance of 0.2 m. Is x_1"),
    ),
}


@pytest.mark.parametrize(("frames", "broken"), BROKEN.values(), ids=BROKEN)
def test_each_broken_rule_is_named_at_its_frame(frames, broken):
    breaches = check_frames(ARM, frames, "standard")
    assert any((breach.frame, breach.rule) == broken[:2] and breach.text.startswith(broken[2]) for breach in breaches)


@given(rotations())
def test_the_rules_do_not_hang_on_where_the_arm_stands(R):
    """Not on a rounding either, by which the determinant of a rotation falls short of 1."""
    T = pose(R, (1, 2, 3))
    moved = kl.Chain(ARM.screws @ kl.adjoint(T).T, T @ ARM.home)
    assert check_frames(moved, T @ RIGHT, "standard") == []
