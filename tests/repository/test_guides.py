"""What the guides tell a contributor or an instructor to write works."""

import argparse
import re
import shlex
import textwrap
from pathlib import Path

import numpy as np

from kinlib import robots
from misstep.grading.command import add_arguments

ROOT = Path(__file__).parents[2]


def test_the_robot_of_the_guide_is_a_robot():
    (block,) = re.findall(r"```python\n(.*?)```", (ROOT / "guides" / "library.md").read_text("utf-8"), re.DOTALL)
    names = dict(vars(robots))
    exec(textwrap.dedent(block), names)
    robot = names["two_link"]()
    assert robot.joint_types == "RR"
    assert "page" in robot.source
    np.testing.assert_allclose(robot.fk([np.pi / 2, 0])[:3, 3], (0, 0.9, 0), atol=1e-15)


def test_every_option_in_the_guide_for_instructors_is_an_option_of_misstep_grade():
    guide = (ROOT / "site" / "instructors.md").read_text("utf-8")
    parser = argparse.ArgumentParser(exit_on_error=False)
    add_arguments(parser)
    commands = [shlex.split(line)[2:] for line in guide.splitlines() if line.startswith("misstep grade")]
    assert len(commands) >= 2
    for arguments in commands:
        parser.parse_args(arguments)
    known = {option for action in parser._actions for option in action.option_strings}
    named = set(re.findall(r"(?<=`)--[a-z-]+", guide))
    assert named <= known
    assert len(named) >= 7
