"""What the guides tell a contributor to write works."""

import re
import textwrap
from pathlib import Path

import numpy as np

from kinlib import robots

ROOT = Path(__file__).parents[2]


def test_the_robot_of_the_guide_is_a_robot():
    (block,) = re.findall(r"```python\n(.*?)```", (ROOT / "guides" / "library.md").read_text("utf-8"), re.DOTALL)
    names = dict(vars(robots))
    exec(textwrap.dedent(block), names)
    robot = names["two_link"]()
    assert robot.joint_types == "RR"
    assert "page" in robot.source
    np.testing.assert_allclose(robot.fk([np.pi / 2, 0])[:3, 3], (0, 0.9, 0), atol=1e-15)
