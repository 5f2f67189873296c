"""The players and the placing of frames, in Python: the data for the page, its traits, and how frames are checked."""

from functools import partial

import numpy as np
import pytest
from answered import Answered

import kinlib as kl
from kincourse import open_sheet
from kincourse.lecture_06_dh_modified.drawings import play_walk
from kinlib.view import assign, drive, explore, play_assignment, play_row, slide_frames
from kinlib.view.figures.arm import frame_text
from kinlib.view.viewer.place_frames import frame_candidates

ARMS = [kl.robots.rpr(), kl.robots.puma560()]
CONVENTIONS = ["standard", "modified"]
ROW = [0.8, 0.6, 0.6, 1.4]
WALK = [[0.6, -0.9, 0.4, 0.3], [0.5, 1.6, 0.4, 0.0]]

each_arm = pytest.mark.parametrize("chain", ARMS, ids=lambda chain: chain.name)
each_convention = pytest.mark.parametrize("convention", CONVENTIONS)


# --- the assignment player ---


def frames_of(stop):
    return {part["sub"]: part for part in stop["parts"] if part["kind"] == "frame"}


def test_a_step_adds_to_the_drawing_and_marks_what_it_is_about():
    stops = play_assignment(kl.robots.youbot(), convention="standard").stops
    assert [frames_of(stop).get("1", {}).get("letters") for stop in stops[2:7]] == [None, "Oz", "Oxz", "Oxyz", "Oxz"]
    normals = [[part["name"] for part in stop["parts"] if part["name"].startswith("normal")] for stop in stops[1:5]]
    assert normals == [[], ["normal 1–2"], [], ["normal 1–2"]]
    assert stops[3]["marked"] == "O"
    assert frames_of(stops[3])["1"]["pose"][3::4] == [0.033, 0, 0.147, 1]


def test_rows_that_the_reader_is_to_find_are_not_on_the_page():
    shown = play_assignment(kl.robots.youbot(), convention="standard", rows=1).mode["variants"]["standard"]
    assert f", step 1 of {len(shown['stops'])}. " in shown["stops"][0]["alt"]
    assert len(shown["table"]["rows"]) == 1
    assert [stop["row"] for stop in shown["stops"]] == [None] * 19 + [1]


def test_without_webgl_the_page_asks_python_for_drawings():
    arm = explore(kl.robots.rpr())
    arm.q = [0.1, 0, 0]
    assert arm.drawing == ""
    arm.flat = True
    assert "q = (0.1, 0, 0)" in arm.drawing
    arm.q = [0.2, 0, 0]
    assert "q = (0.2, 0, 0)" in arm.drawing


def test_a_viewer_stays_covered_until_the_prediction_is_committed():
    linkage = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
    closed = linkage.assembly_modes(hold={"A": 1.0})[0]
    for make in (
        partial(explore, kl.robots.rpr()),
        partial(play_assignment, kl.robots.rpr(), convention="standard"),
        partial(play_row, ROW),
        partial(play_walk, WALK),
        partial(slide_frames, lambda _: {"s": np.eye(4)}, "x", [0]),
        partial(drive, linkage, closed, curves=[[closed]]),
    ):
        player = make(after=(question := Answered()))
        assert player.covered
        assert "<img" not in player.html()
        question.committed = True
        assert not player.covered
        assert "<img" in player.html()
        assert not make(after=question).covered


# --- the row player ---


def test_the_text_alternative_says_where_the_motions_have_moved_the_frame():
    row, walk = play_row(ROW, convention="modified"), play_walk(WALK)
    row.at, walk.at = 2, 4
    T, tip = kl.dh_transform(0.8, 0.6, 0, 0, convention="modified"), kl.DHTable(WALK, convention="standard").fk([0, 0])
    assert f"modified convention, is{frame_text(('', T))[8:]}" in row.alt
    assert f"4 of 4 done. The moving frame is{frame_text(('', tip))[8:]}" in walk.alt
    row.at = 2.5
    assert row.alt.startswith("On the way to the next stop. Motions that move a frame: 2 of 4 done.")


# --- frames by hand ---


def placed(chain, convention, frames):
    hand = assign(chain, convention)
    hand.frames = frames
    return hand


@each_arm
@each_convention
def test_the_candidates_contain_a_right_assignment(chain, convention):
    """Each axis, origin and x of the library's own assignment is among the candidates, or lies on an axis."""
    offered = frame_candidates(chain)
    for T in kl.assign_frames(chain, convention=convention).frames:
        near = [
            np.linalg.norm(s * np.array(z["along"]) - T[:3, 2])
            for z in [*offered["axes"], offered["tool"]]
            for s in (1, -1)
        ]
        assert min(near) < 1e-9
        lines = [np.linalg.norm(np.cross(T[:3, 3] - axis["point"], axis["along"])) for axis in offered["axes"]]
        points = [np.linalg.norm(np.array(point["at"]) - T[:3, 3]) for point in offered["points"]]
        assert min(*lines, *points) < 1e-9
        assert min(np.linalg.norm(np.array(x["along"]) - T[:3, 0]) for x in offered["x"]) < 1e-9


def test_the_page_does_not_receive_the_answer():
    arm = assign(kl.robots.puma560(), "standard").scene["arms"][0]
    assert set(arm["frames"]) == {"base", "tool"}


@each_arm
@each_convention
def test_a_right_assignment_is_accepted_and_its_table_describes_the_arm(chain, convention):
    hand = placed(chain, convention, kl.assign_frames(chain, convention=convention).frames)
    assert hand.breaches == []
    assert kl.equivalent(hand.table, chain)
    hand.asked += 1
    assert hand.verdict["asked"] == 1
    assert hand.verdict["breaches"] == []
    assert len(hand.verdict["table"]) == chain.n
    assert hand.verdict["off"] < 1e-9


@each_convention
def test_an_opposite_z_is_right_and_negates_its_joint_variable(convention):
    """Every z and every x is negated by half a turn about y: the rules hold, and the table describes the arm with -q."""
    chain = kl.robots.puma560()
    frames = kl.assign_frames(chain, convention=convention).frames @ np.diag([-1, 1, -1, 1])
    hand = placed(chain, convention, frames)
    hand.asked = 1
    assert hand.verdict["breaches"] == []
    assert all("−q" in row[3] for row in hand.verdict["table"])
    assert hand.verdict["off"] < 1e-12


@each_convention
def test_incomplete_frames_are_not_checked_and_do_not_affect_others(convention):
    chain = kl.robots.youbot()
    for missing in (0, 1, 3, 5):
        frames = kl.assign_frames(chain, convention=convention).frames.copy()
        frames[missing, :3, 0] = np.nan
        assert placed(chain, convention, frames).breaches == []
        frames[4, :3, 0] *= -1  # no longer right-handed
        assert {breach.frame for breach in placed(chain, convention, frames).breaches} == {4}


def test_a_sheet_names_the_frames_that_are_not_placed():
    sheet = open_sheet("07_frame_assignment", "ada")
    chain = sheet.problem(2).shown["arm"]
    frames = kl.assign_frames(chain, convention="standard").frames.copy()
    frames[[0, 3], :3, 0] = np.nan
    pasted = [... if i in (0, 3) else T for i, T in enumerate(frames)]
    for answer in (frames, pasted, placed(chain, "standard", frames).frames):
        verdict = sheet.check(2, answer)
        assert verdict.judgement.fraction == 0
        assert "0, 3. If you placed them by hand, press Copy" in repr(verdict)
