"""Poses and screw axes as answers: the parts that are judged, and the hints for wrong ones."""

import numpy as np
import pytest

from kincourse import find_sheet
from kincourse.answers.dh_row import DHRowsAnswer
from kincourse.answers.frames import DHFramesAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import OriginAnswer, PoseAnswer
from kincourse.answers.screws import ScrewsAnswer, TwistAnswer
from kinlib.chains.robots import rpr
from kinlib.dh.assignment import assign_frames
from kinlib.rigid.lie import exp
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from misstep.answers.base import Unreadable
from misstep.judge import judge
from misstep.problem import Problem

TURN = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


def turned(R, p=(1, 2, 3)):
    T = TURN.copy()
    T[:3, :3], T[:3, 3] = R, p
    return T


def test_a_pose_is_judged_by_rotation_and_position_and_what_is_no_rotation_is_told_so():
    for given, right_parts, hints in [
        (TURN, ["rotation", "position"], []),
        (turned(TURN[:3, :3], (9, 9, 9)), ["rotation"], [False]),
        (turned(np.eye(3)), ["position"], [False]),
        (turned(2 * np.eye(3)), ["position"], [True]),
        (turned([[0.87, -0.5, 0], [0.5, 0.87, 0], [0, 0, 1]]), ["position"], [False]),
        (turned(np.diag([1, 1, -1])), ["position"], [True]),
        (turned(2 * np.eye(3), (9, 9, 9)), [], [True, False]),
    ]:
        judgement = judge(Problem("", PoseAnswer(TURN), []), given)
        assert list(judgement.right_parts) == right_parts
        assert ["not a rotation matrix" in finding.message for finding in judgement.findings] == hints


def test_an_unreadable_value_is_refused_with_a_remedy():
    one, three = ScrewsAnswer(np.eye(1, 6)[0]), ScrewsAnswer(np.eye(3, 6))
    homogeneous = "homogeneous coordinates: leave off the last entry"
    for answer, given, words in [
        (three, np.eye(6, 3), "Rows and columns are swapped: try .T"),
        (one, [0, 0, 1], r"of shape \(6,\); got a list of shape \(3,\)\.$"),
        (three, np.zeros(18), "arrangement is not"),
        (one, 0, r"Expected a screw axis \(omega, v\), an array of shape \(6,\); got int 0\."),
        (three, np.zeros((2, 6)), r"an ndarray of shape \(2, 6\)\.$"),
        (one, np.zeros(5), r"an ndarray of shape \(5,\)\.$"),
        (VectorsAnswer(np.zeros((2, 3)), names=["the point", "the arrow"]), np.zeros((2, 4)), homogeneous),
        (VectorsAnswer(np.zeros(3), unit="m"), np.zeros(4), homogeneous),
    ]:
        with pytest.raises(Unreadable, match=words):
            answer.read(given)
    assert ScrewsAnswer(np.zeros((0, 6))).read(np.zeros((0, 6))).shape == (0, 6)


# --- the scale of each number ---

SMALL_ARM = ScrewsAnswer(np.array([[0, 0, 1, 0, -0.05, 0], [0, 1, 0, 0.02, 0, 0], [0, 0, 0, 1, 0, 0.0]]))


def test_moments_have_the_scale_of_the_lengths_and_directions_that_of_1():
    off = np.array([[0, 9e-4, 1, 0, -0.05, 9e-5], [0, 1, 0, 0.02, 0, 2e-4], [0, 0, 0, 1, 0, 9e-4]])
    assert SMALL_ARM.agrees(off, SMALL_ARM.value) == [True, False, True]


def test_a_position_has_the_scale_of_its_lengths():
    T = turned(np.eye(3), (0.05, 0, 3e-7))
    answer = PoseAnswer(T)
    assert answer.agrees(turned(np.eye(3), (0.05, 9e-5, 0)), T) == [True, True]
    assert answer.agrees(turned(np.eye(3), (0.05, 2e-4, 0)), T) == [True, False]
    assert answer.agrees(turned([[1, 9e-4, 0], [0, 1, 0], [0, 0, 1]], (0.05, 0, 0)), T) == [True, True]


# --- equal in meaning ---


def test_all_angles_of_the_same_rotation_are_right():
    for rpy in [(0.3, 0, 0), (-np.pi / 3, 0, 0), (0.1, 0.2, 0.3), (0.4, np.pi / 2, 0.1)]:
        roll, pitch, yaw = rpy
        right = np.array([[0.9, 0.4, 0.2], rpy])
        answer = OriginAnswer(right)
        for same in (
            (roll + np.pi, np.pi - pitch, yaw + np.pi),
            (roll + 2 * np.pi, pitch, yaw),
            roll_pitch_yaw(origin(rpy=rpy)[:3, :3]),
        ):
            assert answer.agrees(answer.read([right[0], same]), right) == [True]
        assert answer.agrees(answer.read([right[0], (roll + 0.01, pitch, yaw)]), right) == [False]
        off = np.array([right[0], (roll + 0.1, pitch, yaw)])
        assert answer.resemblance(off, 0) == ("another rpy", "The xyz is right, but the rpy is another rotation.")
        assert answer.resemblance(np.array([right[1], right[1]]), 0)[1].startswith(
            "The rpy is right, but the xyz is not."
        )


# --- the slips of each kind ---

ROTATION = exp(np.array([0.3, 0.4, 0.5]))
SCREWS = np.array([[0, 0, 1, 0.3, -2, 0.1], [0, 1, 0, 3, 0, 4], [0, 0, 0, 0.6, 0, 0.8]])
KINDS = {
    "pose": PoseAnswer(turned(ROTATION)),
    "screws": ScrewsAnswer(SCREWS),
    "twist": TwistAnswer(SCREWS[0]),
    "frames": DHFramesAnswer(assign_frames(rpr(), convention="standard").frames, chain=rpr(), convention="standard"),
    "rows": DHRowsAnswer(np.array([[0.3, 0.7, 0.2, 0.4], [0.25, -1.1, 0.35, 0.5]])),
}


@pytest.mark.parametrize("kind", KINDS)
def test_each_slip_of_a_kind_is_named(kind):
    problem = Problem("", KINDS[kind])
    assert len(problem.slips) > 1
    for slip in problem.slips:
        judgement = judge(problem, slip.value)
        assert judgement.fraction < 1
        named = {one.name for finding in judgement.findings for one in finding.mistakes}
        assert {slip.name, "placeholder"} & named, slip.name


def test_what_is_done_in_every_row_is_not_told_of_a_row_alone():
    problem = find_sheet("03_poe_space").problems[0].variant("a")
    slide = problem.given["letters"].index("P")
    typed = problem.answer.value * [1, 1, 1, -1, -1, -1]
    typed[slide] = np.roll(problem.answer.value[slide], 3)
    messages = [finding.message for finding in judge(problem, typed).findings]
    assert len(messages) == 2
    assert not [message for message in messages if "every row" in message]
