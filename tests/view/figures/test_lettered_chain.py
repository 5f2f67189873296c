"""The drawing of a chain with letters: the text alternative says what the drawing shows, and changes with it."""

import re

import numpy as np
import pytest

from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.lettered_arms import draw_lettered_arm
from kinlib.view import draw_lettered_chain


@pytest.mark.parametrize("student", ["ada", "bob"])
def test_the_arm_can_be_rebuilt_from_the_text_alternative_alone(student):
    robot = draw_lettered_arm(ArmSampler(student, "03.9"))
    alt = draw_lettered_chain(robot.chain, robot.letters).alt
    unit = {
        sign + name: (-1 if sign else 1) * e for name, e in zip("xyz", np.eye(3), strict=True) for sign in ("", "-")
    }
    links = [unit[found] for found in re.findall(r"L_\d along (-?[xyz])", alt)]
    axes = [unit[found] for found in re.findall(r"axis along (-?[xyz])", alt)]
    tool = [[float(entry) for entry in found.split(", ")] for found in re.findall(r"[xyz] = \(([^)]*)\)", alt)]
    np.testing.assert_array_equal(links, robot.links)
    np.testing.assert_array_equal(axes, robot.axes)
    np.testing.assert_array_equal(tool, robot.tool)
    assert f"({robot.joint_types})" in alt
