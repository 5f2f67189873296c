"""Your robot: published tables as they were copied against files that packages ship, judged by forward kinematics of our own."""

from pathlib import Path

import numpy as np
import pytest
from outside.motions import at, chain

import kinlib as kl
from kincourse.your_robot import KNOWN, examine, formats, practise


def poses(table, q):
    """Forward kinematics that shares no code with kinlib."""
    angles = np.zeros((len(q), len(table.joints)))
    angles[:, [letter == "R" for letter in table.joints]] = q
    rows = (at(table.rows, "R" * len(table.joints), table.signs * row) for row in angles)
    return np.array([table.base @ chain(row, table.convention) @ table.tool for row in rows])


def shipped(package, name):
    """The path of a URDF file in a package."""
    folder = Path(pytest.importorskip(package).__file__).parent
    return str(next(folder.rglob(name)))


def page(*lengths):
    """A table as the page of Universal Robots has it."""
    d1, a2, a3, d4, d5, d6 = lengths
    rows = [(0, d1, "π/2"), (a2, 0, 0), (a3, 0, 0), (0, d4, "π/2"), (0, d5, "-π/2"), (0, d6, 0)]
    cells = [f"Joint {i}\t0\t{a}\t{d}\t{alpha}\tLink {i}\t2.5" for i, (a, d, alpha) in enumerate(rows, start=1)]
    return "\n".join(["Kinematics\ttheta [rad]\ta [m]\td [m]\talpha [rad]\tDynamics\tMass [kg]", *cells])


UR5E = page(0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996)
KR16 = "Achse;theta (°);d (mm);a (mm);alpha (°)\n1;0;675;260;90\n2;90;0;680;0\n3;0;0;-35;90\n4;0;670;0;-90\n5;0;0;0;90\n6;180;158;0;0"
IIWA = r"$i$ & $\alpha_i$ & $a_i$ & $d_i$ & $\theta_i$ \\ \hline" + "\n".join(
    rf"{i} & ${alpha}^\circ$ & 0 & {d} & $\theta_{i}$ \\"
    for i, (alpha, d) in enumerate(
        [(-90, 0.36), (90, 0), (90, 0.42), (-90, 0), (-90, 0.4), (90, 0), (0, 0.126)], start=1
    )
)
MILLIMETRES = (
    "theta,d,a,alpha\n0,89.159,0,1.5708\n0,0,-425,0\n0,0,-392.25,0\n0,109.15,0,1.5708\n0,94.65,0,-1.5708\n0,82.3,0,0"
)
PAIRS = {
    "UR5e": ("airo_models", "ur5e.urdf", "tool0", UR5E, "joint 1: add 180° to theta"),
    "KR16": ("rtbdata", "kr16_2.urdf", "", KR16, "joint 2: write -q in theta"),
    "iiwa 7 for 14": ("rtbdata", "lbr_iiwa_14_r820.urdf", "", IIWA.replace("0.36", "0.34").replace("0.42", "0.40"),
                      "Row 3: d should be 0.42; the table has 0.4."),
    "UR5 in millimetres": ("", "UR5", "", MILLIMETRES, ""),
    "UR5e for UR5": ("", "UR5", "", UR5E, "Row 1: d should be 0.089159; the table has 0.1625."),
    "Panda as standard": ("", "Panda", "", str(KNOWN["Panda"][0]).replace("_{i-1}", ""), "The table is in the modified convention"),
    "two wrong entries": ("", "UR5e", "", UR5E.replace("0.1333", "0.1233").replace("-0.3922", "-0.3722"),
                          "Row 4: d should be 0.1333; the table has 0.1233."),
}  # fmt: skip


@pytest.mark.parametrize("pair", PAIRS.values(), ids=PAIRS)
def test_what_is_said_of_a_published_table_is_true(pair):
    package, file, tip, text, words = pair
    found = examine(shipped(package, file) if package else file, text, tip=tip, convention="standard")
    q = np.random.default_rng(0).uniform(-3, 3, (50, found.arm.n))
    right, off = found.arm.fk(q), np.abs(poses(found.table, q) - found.arm.fk(q)).max()
    assert words in " ".join(found.readings)
    if found.strict.verdict == "rounded":
        assert off < 1e-3
        assert "to the digits that are printed" in found.sentence
        return
    assert found.sentence.startswith("For the same q the tool differs by up to")
    assert off > 1e-3
    np.testing.assert_allclose(poses(found.corrected, q), right, atol=1e-3)
    assert found.wrong_rows or found.corrected.convention != found.table.convention
    assert found.copies()["text"] == str(found.corrected)


def test_one_of_the_two_is_enough_and_what_cannot_be_compared_is_said():
    alone = examine(kl.to_urdf(kl.robots.puma560()))
    assert alone.corrected.joints == "RRRRRR"
    assert "The reason for each frame" in alone._repr_html_()
    assert examine(table=UR5E, convention="standard").sentence == "table: 6 joints."
    assert "so they cannot be compared" in examine("Panda", UR5E, convention="standard").sentence
    assert examine().sentence == "Give a URDF file, a table, or both."


def test_the_fingers_of_a_gripper_are_left_out_and_the_chain_is_named():
    fingers = "".join(
        f'<link name="{one}"/><joint name="{one}_joint" type="prismatic"><parent link="tool"/><child link="{one}"/>'
        f'<limit lower="0" upper="0.04" effort="1" velocity="1"/>{mimic}</joint></robot>'
        for one, mimic in (("left", ""), ("right", '<mimic joint="left_joint"/>'))
    ).replace("</robot>", "", 1)
    panda = kl.to_urdf(KNOWN["Panda"][0].to_chain().changed(name="panda")).replace("</robot>", fingers)
    alone = examine(panda)
    assert alone.sentence == "panda: 7 joints."
    assert "if yours is one of them: left (8 joints), right (8 joints)." in alone._repr_html_()
    assert kl.load_urdf(panda).n == 7


def test_a_slip_and_another_base_are_one_reading_and_other_zeros_the_other():
    rows = KNOWN["UR5"][0].rows * np.where(np.arange(24).reshape(6, 4) == 13, -1, 1)
    rotated = KNOWN["UR5"][0].changed(base=np.diag([-1.0, -1, 1, 1]))
    found = examine(kl.to_urdf(rotated.to_chain()), kl.DHTable(rows, convention="standard"))
    assert found.readings[0] == "If only the base and the tool may differ: Row 4: alpha has the wrong sign."
    html = found._repr_html_()
    assert (
        html.index("<strong>Either: ")
        < html.index("<strong>Or: ")
        < html.index("The corrected table has the first reading")
    )
    q = np.random.default_rng(0).uniform(-3, 3, (50, 6))
    np.testing.assert_allclose(found.corrected.fk(q), found.arm.fk(q), atol=1e-9)
    assert "e-1" not in found.copies()["Python"]


def test_one_story_is_told_once_and_rounding_leaves_no_noise_in_the_corrected_table():
    turned = KNOWN["UR5"][0].changed(base=np.diag([-1.0, -1, 1, 1]))
    found = examine(turned, page(0.08916, -0.425, -0.3922, 0.1091, 0.09465, 0.0823))  # four digits, as a toolbox prints
    assert found.readings == [
        "The table describes the same arm with other choices:\njoint 1: add 180° to theta (or rotate the base by as much about axis 1)."
    ]
    assert found.corrected.rows[:, 3].tolist() == [np.pi, 0, 0, 0, 0, 0]
    assert [found.wrong_rows, examine(turned, UR5E).wrong_rows] == [[0], [3, 4]]


def test_what_is_given_is_escaped_and_what_cannot_be_read_is_said():
    for arm, table in (("<script>alert(1)</script>", ""), ("UR5", "<script>alert(1)</script>"), ("no such arm", "")):
        found = examine(arm, table)
        assert found.unread
        assert "<script>" not in found._repr_html_()
    sheet = practise(kl.robots.rpr().changed(name="<script>alert(1)</script> $x$"), "ada")
    statements = [sheet.problem(k).statement for k in range(1, 7)]
    assert any("scriptalert(1)script x" in text for text in statements)
    assert not any("<script>" in text for text in statements)


def test_a_copied_table_is_the_table_in_the_robotics_toolbox_and_in_python():
    rtb = pytest.importorskip("roboticstoolbox")
    for name, (table, _) in KNOWN.items():
        texts = formats(table)
        again = eval(texts["Python"], {"kl": kl})
        q = np.random.default_rng(1).uniform(-1, 1, table.n)
        np.testing.assert_allclose(again.fk(q), table.fk(q), atol=1e-9, err_msg=name)
        if "F" not in table.joints and np.array_equal(table.tool, np.eye(4)) and np.array_equal(table.base, np.eye(4)):
            theirs = eval(texts["Robotics Toolbox"], vars(rtb))
            np.testing.assert_allclose(theirs.fkine(q).A, table.fk(q), atol=1e-9, err_msg=name)


def test_the_frames_of_the_arm_are_beside_those_of_a_wrong_row_and_named_with_a_prime():
    wrong = KNOWN["UR5e"][0].changed(rows=KNOWN["UR5e"][0].rows * np.where(np.arange(24).reshape(6, 4) == 13, -1, 1))
    picture = examine("UR5e", wrong).picture()
    assert picture.shown == ["axes", "frame 3", "frame 4", "frame 4'"]
    frames = picture.scene["arms"][0]["frames"]
    assert [name for name, (frame,) in frames.items() if frame["grey"]] == ["frame 4'", "frame 5'", "frame 6'"]
    right, arm = frames["frame 4'"][0]["pose"], examine("UR5e").arm
    z = np.reshape(right, (4, 4))[:3, 2]
    # on the next joint axis, as the wrong one is, but along it
    assert np.abs(np.cross(z, arm.lines.axis[4])).max() < 1e-9
    assert z @ arm.lines.axis[4] > 0


def test_the_picture_shows_what_the_links_of_the_file_show():
    """From a base in the middle of the file, with the links that hang below joints that are not on the way."""
    picture = examine(shipped("airo_models", "ur5e.urdf"), base="shoulder_link", tip="wrist_1_link").picture()
    assert picture.notes == []
    [arm] = picture.scene["arms"]
    named = [[mesh["name"].removeprefix("visual/") for mesh in body] for body in arm["meshes"]]
    assert named == [["shoulder.obj"], ["upperarm.obj"], ["forearm.obj"], ["wrist1.obj", "wrist2.obj", "wrist3.obj"]]
    assert np.reshape(arm["meshes"][0][0]["pose"], (4, 4)) == pytest.approx(np.diag([-1, -1, 1, 1]))


def test_the_picture_opens_within_the_limits_of_the_joints():
    arm = kl.robots.rpr().changed(limits=[[0.5, 1.5], [-1, 1], [-3, -1]])
    assert examine(kl.to_urdf(arm)).picture().q == [1, 0, -2]
