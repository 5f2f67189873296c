"""Drawings of a frame assignment: each step adds to them, the text alternative contains the step, and the arm stays in view."""

import re

import numpy as np
import pytest

import kinlib as kl
from kinlib import robots
from kinlib.view.figures.frame_assignment import draw_assignment

CONVENTIONS = ["standard", "modified"]

each_convention = pytest.mark.parametrize("convention", CONVENTIONS)


def labels(picture):
    """Return the labels in a drawing, such as x1. A subscript is an element of its own."""
    words = re.findall(r"<text[^>]*>(.*?)</text>", picture.svg, flags=re.DOTALL)
    return {re.sub(r"<[^>]*>", "", word).strip() for word in words}


@each_convention
@pytest.mark.parametrize("chain", [robots.rprr(), robots.youbot()], ids=lambda chain: chain.name)
def test_the_text_alternative_of_every_step_contains_its_sentence(chain, convention):
    found = kl.assign_frames(chain, convention=convention)
    for k, step in enumerate(found.steps):
        picture = draw_assignment(found, k)
        assert step.text in picture.alt
        assert step.text in picture.caption
        assert step.others in picture.caption


@each_convention
def test_a_frame_appears_axis_by_axis(convention):
    found = kl.assign_frames(robots.youbot(), convention=convention)
    seen = {}
    for k, step in enumerate(found.steps):
        if step.frame == 1 and step.kind in {"normal", "origin", "x", "y"}:
            seen[step.kind] = labels(draw_assignment(found, k))
    assert not {"z1", "x1", "y1"} & seen["normal"]
    assert {"O1", "z1"} <= seen["origin"]
    assert "x1" not in seen["origin"]
    assert {"z1", "x1"} <= seen["x"]
    assert {"z1", "x1", "y1"} <= seen["y"]


@each_convention
def test_the_arm_stays_in_view_if_a_common_normal_is_far_away(convention):
    angle = 1e-6
    joints = [((0, 0, 1), (0, 0, 0)), ((0, np.sin(angle), np.cos(angle)), (0.5, 0, 0.1)), ((1, 0, 0), (0.9, 0, 0.3))]
    chain = robots.arm(joints, robots.pose(np.eye(3), (1, 0, 0.3)), "leaning arm", "a test")
    found = kl.assign_frames(chain, convention=convention)
    for k in [*range(len(found.steps)), None]:
        numbers = [abs(float(x)) for x in re.findall(r'[xy]\d?="(-?[\d.]+)"', draw_assignment(found, k).svg)]
        assert max(numbers) < 1000


def test_a_step_that_does_not_exist_is_refused():
    found = kl.assign_frames(robots.rpr(), convention="standard")
    for until in (-1, 99, 1.5, "x"):
        with pytest.raises(ValueError, match="until must be the index of a step of this assignment, 0 to"):
            draw_assignment(found, until)
