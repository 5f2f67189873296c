"""The drawing of a chain with letters: the text alternative says what the drawing shows, and changes with it."""

import re

import numpy as np
import pytest

from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.lettered_arms import draw_lettered_arm
from kinlib import robots
from kinlib.view import draw_lettered_chain


def lettered(student):
    return draw_lettered_arm(ArmSampler(student, "03.9"))


@pytest.mark.parametrize("student", ["ada", "bob"])
def test_the_arm_can_be_rebuilt_from_the_text_alternative_alone(student):
    robot = lettered(student)
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


def test_a_letter_without_a_length_is_refused():
    with pytest.raises(ValueError, match="letters must have 5 entries"):
        draw_lettered_chain(robots.plain_arm(), ["L_0", "L_1", "", "L_2", "L_3"])
