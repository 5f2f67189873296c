"""Poses and screw axes as answers: the parts that are judged, and the hints for wrong ones."""

import numpy as np
import pytest

from kincourse.answers.pose import PoseAnswer
from kincourse.answers.screws import ScrewsAnswer
from kinlib.chains.robots import youbot
from misstep.answers.base import Unreadable
from misstep.judge import judge
from misstep.problem import Problem


def test_a_pose_that_is_no_pose_is_told_so():
    p = Problem("Where?", PoseAnswer(youbot().home), [])
    judgement = judge(p, 2 * youbot().home)
    assert "no rotation at all" in judgement.findings[0].message


TURN = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


def turned(R, p=(1, 2, 3)):
    T = TURN.copy()
    T[:3, :3], T[:3, 3] = R, p
    return T


@pytest.mark.parametrize(
    ("given", "right_parts", "hints"),
    [
        (TURN, ["rotation", "position"], []),
        (turned(TURN[:3, :3], (9, 9, 9)), ["rotation"], [False]),
        (turned(np.eye(3)), ["position"], [False]),
        (turned(2 * np.eye(3)), ["position"], [True]),
        (turned([[0.87, -0.5, 0], [0.5, 0.87, 0], [0, 0, 1]]), ["position"], [False]),
        (turned(np.diag([1, 1, -1])), ["position"], [True]),
        (turned(2 * np.eye(3), (9, 9, 9)), [], [True, False]),
    ],
)
def test_a_pose_is_judged_by_rotation_and_position_and_what_is_no_rotation_is_told_so(given, right_parts, hints):
    judgement = judge(Problem("", PoseAnswer(TURN), []), given)
    assert list(judgement.right_parts) == right_parts
    assert ["no rotation at all" in finding.message for finding in judgement.findings] == hints


@pytest.mark.parametrize(
    ("row", "right_parts"),
    [
        ((0, 0, 0, 0), ["rotation"]),
        ((0, 0.5, 0, 1), ["position"]),
        ((1, 2, 3, 4), []),
        ((0, 0, 0, 1.0005), ["rotation", "position"]),
    ],
)
def test_a_pose_ends_in_a_row_of_its_own(row, right_parts):
    judgement = judge(Problem("", PoseAnswer(TURN), []), [*TURN[:3].tolist(), row])
    assert list(judgement.right_parts) == right_parts
    assert all(finding.message.startswith("The last row of a pose is 0 0 0 1") for finding in judgement.findings)


def test_a_pose_that_is_wrong_and_no_more_is_told_nothing_of_its_form():
    given = turned(np.eye(3), (9, 9, 9))
    given[3, 3] = 1.0005
    for finding in judge(Problem("", PoseAnswer(TURN), []), given).findings:
        assert finding.message.startswith("None of the mistakes")


def test_a_screw_is_told_which_half_is_right_if_one_is():
    right = np.array([0, 0, 1, 0, -2, 0.5])
    problem = Problem("", ScrewsAnswer(right), [])
    assert problem.answer.parts == ["screw 1"]
    told = {
        (0, 0, 1, 9, -2, 0.5): "Its omega is right, its v is not.",
        (0, 0.0005, 1, 9, -2, 0.5): "Its omega is right, its v is not.",
        (0, 2, 0, 0, -2, 0.5): "Its v is right, its omega is not.",
        (0, 1, 0, 9, -2, 0.5): "None of the mistakes",
    }
    for given, words in told.items():
        assert judge(problem, given).findings[0].message.startswith(words)


@pytest.mark.parametrize(
    ("answer", "given", "words"),
    [
        (ScrewsAnswer(np.eye(3, 6)), np.eye(6, 3), "Rows and columns are swapped: try .T"),
        (ScrewsAnswer(np.eye(1, 6)[0]), [0, 0, 1], "is the other half missing"),
        (ScrewsAnswer(np.eye(3, 6)), np.zeros(18), "arrangement is not"),
        (
            ScrewsAnswer(np.eye(1, 6)[0]),
            0,
            r"Expected a screw axis \(omega, v\), an array of shape \(6,\); got int 0\.",
        ),
        (ScrewsAnswer(np.eye(3, 6)), np.zeros((2, 6)), r"an ndarray of shape \(2, 6\)\.$"),
        (ScrewsAnswer(np.eye(1, 6)[0]), np.zeros(5), r"an ndarray of shape \(5,\)\.$"),
        (PoseAnswer(np.eye(4)), np.eye(4) - 1e13, r"got 1e\+13. Was there"),
    ],
)
def test_an_unreadable_value_is_refused_with_a_remedy(answer, given, words):
    with pytest.raises(Unreadable, match=words):
        answer.read(given)


def test_no_screws_at_all_may_be_an_answer():
    assert ScrewsAnswer(np.zeros((0, 6))).read(np.zeros((0, 6))).shape == (0, 6)
