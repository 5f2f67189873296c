"""Poses and screw axes as answers: the parts that are judged, and the hints for wrong ones."""

import numpy as np
import pytest

from kincourse.answers.frames import DHFramesAnswer
from kincourse.answers.point import VectorsAnswer
from kincourse.answers.pose import INVERSE, OTHER_FRAME, OriginAnswer, PoseAnswer, RotationAnswer
from kincourse.answers.screws import ScrewsAnswer, TwistAnswer
from kinlib.chains.robots import rpr
from kinlib.dh.assignment import assign_frames
from kinlib.rigid.lie import exp, inverse
from kinlib.rigid.rpy import origin, roll_pitch_yaw
from misstep.answers.base import Unreadable
from misstep.display.sentences import IDENTITY, UNKNOWN
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


def test_a_pose_ends_in_a_row_of_its_own():
    for row, right_parts in {
        (0, 0, 0, 0): ["rotation"],
        (0, 0.5, 0, 1): ["position"],
        (1, 2, 3, 4): [],
        (0, 0, 0, 1.0005): ["rotation", "position"],
    }.items():
        judgement = judge(Problem("", PoseAnswer(TURN), []), [*TURN[:3].tolist(), row])
        assert list(judgement.right_parts) == right_parts
        assert all(
            "the last row of a pose is 0 0 0 1" in finding.message.replace("The", "the")
            for finding in judgement.findings
        )


def test_a_pose_that_is_wrong_and_no_more_is_told_nothing_of_its_form():
    given = turned(exp(np.array([0.3, 0.4, 0.5])), (9, 9, 9))
    given[3, 3] = 1.0005
    for finding in judge(Problem("", PoseAnswer(TURN), []), given).findings:
        assert finding.message == UNKNOWN


def test_a_screw_is_told_which_half_is_right_if_one_is():
    right = np.array([0, 0, 1, 0, -2, 0.5])
    problem = Problem("", ScrewsAnswer(right), [])
    assert problem.answer.parts == ["screw 1"]
    told = {
        (0, 0, 1, 9, -2, 0.5): "$\\omega$ is right, but $v$ is not. Look at $v_x$: all other entries are right.",
        (0, 0.0005, 1, 9, -2, 0.5): "$\\omega$ is right, but $v$ is not.",
        (0, 2, 0, 0, -2, 0.5): "$v$ is right, but $\\omega$ is not.",
        (0, 1, 0, 9, -2, 0.5): "$\\omega$ is not right.",
    }
    for given, words in told.items():
        assert judge(problem, given).findings[0].message.startswith(words)


def test_an_unreadable_value_is_refused_with_a_remedy():
    one, three = ScrewsAnswer(np.eye(1, 6)[0]), ScrewsAnswer(np.eye(3, 6))
    homogeneous = "homogeneous coordinates: leave off the last entry"
    for answer, given, words in [
        (three, np.eye(6, 3), "Rows and columns are swapped: try .T"),
        (one, [0, 0, 1], "is the other half missing"),
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


def test_a_missing_length_is_not_called_rounded():
    answer = PoseAnswer(turned(np.eye(3), (0.4251, 0, 0.0203)))
    assert not answer.is_rounded(turned(np.eye(3), (0.4251, 0, 0)), 1)
    assert answer.is_rounded(turned(np.eye(3), (0.43, 0, 0.02)), 1)
    assert not answer.is_rounded(turned(np.eye(3), (0.43, 0, 0.05)), 1)


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
        assert answer.description(off, 0) == ("another rpy", "The xyz is right, but the rpy is another rotation.")
        assert answer.description(np.array([right[1], right[1]]), 0)[1].startswith(
            "The rpy is right, but the xyz is not."
        )
        assert answer.description(np.array([right[1], right[0]]), 0) is None


# --- hints ---


def test_hints_name_the_wrong_entries():
    R = exp(np.array([0.3, 0.4, 0.5]))
    T = turned(R, (1, 2, 3))
    wrong = T.copy()
    wrong[0, 1] += 0.2
    assert PoseAnswer(T).hint(wrong, 0) == "8 of the 9 entries are right. Look at row 1, column 2."
    assert RotationAnswer(R).hint(wrong[:3, :3], 0) == "8 of the 9 entries are right. Look at row 1, column 2."
    assert PoseAnswer(T).hint(turned(R, (1, 2, 9)), 1) == "2 of the 3 entries are right. Look at $z$."
    assert PoseAnswer(T).hint(turned(R, (1, 8, 9)), 1) == ""
    points = VectorsAnswer(np.array([[1.0, 2, 3], [4, 5, 6]]), names=["the point", "the arrow"])
    assert points.hint(np.array([[1.0, 2, 9], [6, 4, 5]]), 0) == "2 of the 3 entries are right. Look at $z$."
    assert points.hint(np.array([[1.0, 2, 9], [6, 4, 5]]), 1).startswith("Its components have the right sizes")
    assert points.hint(np.array([[1.0, 2, 9], [6, 4, 7]]), 1) == ""


# --- slips: each text is a claim, and the value shows it ---


def check_slips(answer, expected):
    found = {slip.message: slip.value for slip in answer.slips()}
    for text, value in expected.items():
        np.testing.assert_allclose(found[text], value, rtol=0, atol=1e-12, err_msg=text)
    assert not any(all(answer.agrees(value, answer.value)) for value in found.values())


def test_the_slips_of_a_pose_are_what_their_texts_say():
    R, p = exp(np.array([0.3, 0.4, 0.5])), np.array([1.0, 2, 3])
    T = turned(R, p)
    swapped = T[:, [1, 0, 2, 3]]
    expected = {
        "The position is right; the rotation is the transpose of the right one.": turned(R.T, p),
        "Your pose is the inverse of the right one: it says where the frame of reference lies, seen from the other one.": np.linalg.inv(
            T
        ),
        "The rotation is right; the position is that of the inverse pose.": turned(R, -R.T @ p),
        "Your matrix is the transpose of the right one, last row included.": T.T,
        "The rotation is right; every sign of the position is wrong.": turned(R, -p),
        INVERSE: turned(R.T, -p),
        "The rotation is right; the position is in millimetres. Give it in metres.": turned(R, 1000 * p),
        "The position is right; the rotation is left at the identity.": turned(np.eye(3), p),
        "The rotation is right; the position is left at 0.": turned(R, (0, 0, 0)),
        "Columns 1 and 2 of the rotation are swapped.": swapped,
        "Only one sign is wrong: $x$ of the position.": turned(R, (-1, 2, 3)),
        "Two entries are swapped: $y$ of the position and $z$ of the position.": turned(R, (1, 3, 2)),
    }
    check_slips(PoseAnswer(T), expected)
    check_slips(RotationAnswer(R), {"Your rotation is the transpose of the right one.": R.T})


def test_the_text_for_a_part_of_a_pose_speaks_of_this_part_alone():
    T = turned(exp(np.array([0.3, 0.4, 0.5])))
    for slip in PoseAnswer(T).slips():
        for is_right, other in zip(PoseAnswer(T).agrees(slip.value, T), ("position", "rotation"), strict=True):
            assert is_right or other not in slip.part


def test_the_slips_of_screws_are_what_their_texts_say():
    S = np.array([[0, 0, 1, 0.3, -2, 0.1], [0, 1, 0, 3, 0, 4], [0, 0, 0, 0.6, 0, 0.8]])
    expected = {
        "Every screw axis has $v$ in front of $\\omega$. The order is $(\\omega, v)$.": S[:, [3, 4, 5, 0, 1, 2]],
        "Every screw axis has the opposite direction: every sign is wrong.": -S,
        "Every $\\omega$ is right; every moment $v$ has the wrong sign.": [*(S[:2] * [1, 1, 1, -1, -1, -1]), S[2]],
        "Every $v$ is right; every $\\omega$ has the wrong sign.": S * [-1, -1, -1, 1, 1, 1],
        "Every $\\omega$ is right; every moment $v$ is left at 0.": [*(S[:2] * [1, 1, 1, 0, 0, 0]), S[2]],
        "Every direction is in $v$, and $\\omega$ is 0, as if all joints were prismatic.": [
            [0, 0, 0, 0, 0, 1],
            [0, 0, 0, 0, 1, 0],
            S[2],
        ],
        "The direction of a translation is in $\\omega$. It belongs in $v$, and $\\omega$ is 0.": [
            *S[:2],
            [0.6, 0, 0.8, 0, 0, 0],
        ],
        "The moments $v$ are in millimetres. Give them in metres.": [*(S[:2] * [1, 1, 1, 1e3, 1e3, 1e3]), S[2]],
        "The screw axes are right, but their order is reversed.": S[::-1],
        "The rows of screw 2 and screw 3 are swapped.": S[[0, 2, 1]],
        "Only one sign is wrong: $v_y$ of screw 1.": [[0, 0, 1, 0.3, 2, 0.1], *S[1:]],
        "Two entries are swapped: $v_x$ of screw 2 and $v_z$ of screw 2.": [S[0], [0, 1, 0, 4, 0, 3], S[2]],
    }
    check_slips(ScrewsAnswer(S), expected)
    check_slips(TwistAnswer(S[0]), {"It has $v$ in front of $\\omega$. The order is $(\\omega, v)$.": np.roll(S[0], 3)})


def test_a_slip_in_one_screw_is_named_for_this_screw():
    S = np.array([[0, 0, 1, 0.3, -2, 0], [0, 1, 0, 3, 0, 4.0]])
    judgement = judge(Problem("", ScrewsAnswer(S), []), [S[0], np.roll(S[1], 3)])
    assert [(finding.parts, finding.message) for finding in judgement.findings] == [
        (["screw 2"], "It has $v$ in front of $\\omega$. The order is $(\\omega, v)$.")
    ]


def test_the_slips_of_vectors_are_what_their_texts_say():
    right = np.array([[1.0, 2, 3], [4, 5, 6]])
    expected = {"Only one sign is wrong: $z$ of the arrow.": right * [[1, 1, 1], [1, 1, -1]]}
    check_slips(VectorsAnswer(right, names=["the point", "the arrow"]), expected)
    check_slips(VectorsAnswer(right[0], unit="m"), {"Only one sign is wrong: $z$.": right[0] * [1, 1, -1]})


def test_the_slips_of_frames_break_the_rules():
    frames = assign_frames(rpr(), convention="standard").frames
    expected = {
        "Every pose is the inverse of the right one: {s} seen from the frame.": inverse(frames),
        "The frames are right, but their order is reversed.": frames[::-1],
    }
    check_slips(DHFramesAnswer(frames, chain=rpr(), convention="standard"), expected)


# --- what the student can check ---


def test_a_check_gives_what_the_own_numbers_give():
    R = exp(np.array([0.3, 0.4, 0.5]))
    one_sign, entry = R * [[1, -1, 1], [1, 1, 1], [1, 1, 1]], R.copy()
    entry[2, 2] = 2.0
    S = np.array([0, 0, 1, 2, 3, 0.0])
    arrow = VectorsAnswer(np.array([0.6, 0, 0.8]))
    cases = [
        (RotationAnswer(R), one_sign, f"columns 1 and 2 have the dot product {one_sign[:, 0] @ one_sign[:, 1]:.2g}."),
        (RotationAnswer(R), entry, "one of yours is 2."),
        (RotationAnswer(R), R * [1, 0.5, 1], "your column 2 has 0.5."),
        (RotationAnswer(R), -R, "yours is -1."),
        (RotationAnswer(R), exp(np.array([0, 0, 0.5])), "yours belongs to $\\theta$ = 28.65 degrees."),
        (PoseAnswer(turned(R)), turned(one_sign), f"dot product {one_sign[:, 0] @ one_sign[:, 1]:.2g}."),
        (ScrewsAnswer(S), S + np.array([0.5, 0, 0, 0, 0, 0]), "has the length 1; yours has 1.12."),
        (ScrewsAnswer(S), S + np.array([0, 0, 0, 0, 0, 0.5]), "your numbers give 0.5."),
        (arrow, 2 * arrow.value, "the length of yours is 2."),
    ]
    for answer, given, words in cases:
        [finding] = judge(Problem("", answer, []), given).findings
        assert finding.check.endswith(words), finding
        assert answer.check(answer.value, 0) == answer.check(np.round(answer.value, 3), 0) == ""


def test_one_wrong_sign_is_shown_by_a_check():
    S = np.array([0.6, 0, 0.8, 4, 0, -3])
    messages = {
        sign: judge(Problem("", ScrewsAnswer(S), []), S * sign).findings[0].text
        for sign in ((-1, 1, 1, 1, 1, 1), (1, 1, 1, 1, 1, -1))
    }
    assert all("0$; your numbers give" in text and "_" not in text for text in messages.values())


def test_a_copied_row_is_seen_where_the_right_rows_differ():
    S = np.array([[0, 0, 1, 0.3, -2, 0], [0, 1, 0, 3, 0, 4.0], [0, 1, 0, 3, 0, 4.0]])
    copied = judge(Problem("", ScrewsAnswer(S), []), [S[0], S[0], S[2]])
    assert [(finding.parts, finding.message) for finding in copied.findings] == [
        (["screw 2"], "It is the same as your screw 1, number for number.")
    ]
    both = judge(Problem("", ScrewsAnswer(S), []), [S[0], [1, 0, 0, 0, 9, 9], [1, 0, 0, 0, 9, 9]])
    assert not any("same as" in finding.message for finding in both.findings)


def test_a_wrong_part_is_told_nothing_of_the_right_one():
    for given, text in [
        (turned(np.eye(3)), IDENTITY),
        (turned(TURN[:3, :3], TURN[:3, :3].T @ [1, 2, 3]), OTHER_FRAME),
        (turned(TURN[:3, :3], (3, 1, 2)), "Your three coordinates are right, but not in the order $x$, $y$, $z$."),
    ]:
        [finding] = judge(Problem("", PoseAnswer(TURN), []), given).findings
        assert finding.message == text
