"""Drawn frames, judged by the rules: every right assignment passes, and each broken rule is named at its frame."""

import numpy as np
import pytest

import kinlib as kl
from kinlib import assign_frames, check_frames

ARM = kl.robots.youbot()
RIGHT = assign_frames(ARM, convention="standard").frames


def drawn(frame, change):
    """The right frames with one of them changed from within."""
    frames = RIGHT.copy()
    frames[frame] = frames[frame] @ change
    return frames


def rules(frames, convention="standard"):
    return {(breach.frame, breach.rule) for breach in check_frames(ARM, frames, convention)}


@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("name", ["rpr", "rppr", "rprr", "youbot", "puma560", "rpr_lecture7", "angled_arm"])
def test_every_assignment_of_ours_passes(name, convention):
    arm = getattr(kl.robots, name)()
    assert check_frames(arm, assign_frames(arm, convention=convention).frames, convention) == []


def test_another_right_assignment_passes_too():
    """x_4 turned round, with y_4; the last frame may stand anywhere that its x allows."""
    half_turn = kl.exp([0, 0, np.pi, 0, 0, 0])
    assert rules(drawn(4, half_turn)) == set()
    assert rules(drawn(0, kl.exp([0, 0, 1.0, 0, 0, 0.3]))) == set()


BROKEN = {
    "a left-handed frame": (drawn(3, np.diag([1, -1, 1, 1])), (3, "right-handed")),
    "axes that are not unit": (drawn(3, np.diag([2, 1, 1, 1])), (3, "right-handed")),
    "z off its direction": (drawn(2, kl.exp([0.3, 0, 0, 0, 0, 0])), (2, "z along axis")),
    "an origin beside the axis": (drawn(2, kl.exp([0, 0, 0, 0, 0.1, 0])), (2, "origin on axis")),
    "x turned about z": (drawn(1, kl.exp([0, 0, 0.3, 0, 0, 0])), (1, "x square to z")),
    "x beside the common normal": (drawn(1, kl.exp([0, 0, 0, 0, 0, 0.2])), (1, "x meets z")),
}


@pytest.mark.parametrize(("frames", "broken"), BROKEN.values(), ids=BROKEN)
def test_each_broken_rule_is_named_at_its_frame(frames, broken):
    assert broken in rules(frames)


def test_frames_of_the_other_convention_are_recognised():
    breaches = check_frames(ARM, assign_frames(ARM, convention="modified").frames, "standard")
    assert any("as in the other convention" in breach.text for breach in breaches)


def test_a_prismatic_axis_may_lie_anywhere():
    arm = kl.robots.rpr_lecture7()
    frames = assign_frames(arm, convention="modified").frames.copy()
    assert not [breach for breach in check_frames(arm, frames, "modified") if breach.rule == "origin on axis"]
    frames[2, :3, 3] += (0.1, 0, 0)
    assert "origin on axis" not in {breach.rule for breach in check_frames(arm, frames, "modified")}


def test_a_frame_too_few_is_refused():
    with pytest.raises(ValueError, match=r"frames should have shape \(6, 4, 4\).*got \(5, 4, 4\).*missing"):
        check_frames(ARM, RIGHT[1:], "standard")
    with pytest.raises(ValueError, match="convention should be"):
        check_frames(ARM, RIGHT, "paul")
