"""What the guides tell a contributor to write works."""

import re
import textwrap
from pathlib import Path

import numpy as np

import kincourse.lecture_03_poe_space.problems as sheet_03
from kinlib import robots
from misstep.census import census_of

ROOT = Path(__file__).parents[2]
GUIDES = ROOT / "guides"


def run_block(guide, section, namespace):
    """Run the Python block of a section of a guide, and return the names that it defines."""
    text = (GUIDES / guide).read_text("utf-8").partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    (block,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    defined = dict(namespace)
    exec(textwrap.dedent(block), defined)
    return defined


def test_the_robot_of_the_guide_is_a_robot():
    robot = run_block("library.md", "How to add a robot", vars(robots))["two_link"]()
    assert robot.joint_types == "RR"
    assert "page" in robot.source
    np.testing.assert_allclose(robot.fk([np.pi / 2, 0])[:3, 3], (0, 0.9, 0), atol=1e-15)


def test_the_problem_of_the_guide_is_true_of_what_students_answer():
    template = run_block("lectures.md", "How to add a problem", vars(sheet_03))["revolute_joint"]
    row = census_of(template, [f"student {k}" for k in range(5)])
    assert row.wrong > 5
    assert not row.counts, row.examples
