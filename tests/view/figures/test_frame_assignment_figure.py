"""Drawings of a frame assignment: each step adds to them, the text alternative contains the step, and the arm stays in view."""

import re

import numpy as np
import pytest

import kinlib as kl
from kinlib import robots
from kinlib.view.figures.frame_assignment import draw_assignment

CONVENTIONS = ["standard", "modified"]

each_convention = pytest.mark.parametrize("convention", CONVENTIONS)


@each_convention
def test_the_arm_stays_in_view_if_a_common_normal_is_far_away(convention):
    angle = 1e-6
    joints = [((0, 0, 1), (0, 0, 0)), ((0, np.sin(angle), np.cos(angle)), (0.5, 0, 0.1)), ((1, 0, 0), (0.9, 0, 0.3))]
    chain = robots.arm(joints, robots.pose(np.eye(3), (1, 0, 0.3)), "leaning arm", "a test")
    found = kl.assign_frames(chain, convention=convention)
    for k in [*range(len(found.steps)), None]:
        numbers = [abs(float(x)) for x in re.findall(r'[xy]\d?="(-?[\d.]+)"', draw_assignment(found, k).svg)]
        assert max(numbers) < 1000
