"""Your robot: published tables as they were copied against files that packages ship, judged by forward kinematics of our own."""

import re
from pathlib import Path

import numpy as np
import pytest
from outside.motions import at, chain

import kinlib as kl
from kincourse.your_robot import KNOWN, examine, formats, practise
from kinlib.dh.read_table import read_table


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
    "UR5e": ("airo_models", "ur5e.urdf", "tool0", UR5E, "The base T_s0 is missing: it should be rotated by 180° about z."),
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
    assert words in " ".join(fault.text for each in found.explanations for fault in each.faults)
    if found.strict.verdict == "rounded":
        assert off < 1e-3
        assert "to the digits that are printed" in found.sentence
        return
    assert found.sentence.startswith("For the same q the tool differs by up to")
    assert off > 1e-3
    np.testing.assert_allclose(poses(found.corrected, q), right, atol=1e-3)
    assert found.wrong_rows or found.corrected.convention != found.table.convention or "table itself" in found.sentence
    for each in found.explanations:
        np.testing.assert_allclose(poses(each.corrected, q), right, atol=1e-3)


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


def test_limits_that_may_be_degrees_are_named():
    """A wrist of almost four turns and a joint without limits are not; nor is a rail of 90 metres."""
    limits = {"waist": (-170, 170), "wrist": (-12.5, 12.5), "flange": (-np.inf, np.inf), "rail": (0, 90)}
    arm = kl.Chain(kl.robots.rpr().screws[[0, 2, 2, 1]], np.eye(4), limits=[*limits.values()], joint_names=[*limits])
    assert examine(kl.to_urdf(arm)).notes[1:] == [
        "Joints whose limits are more than four turns apart, perhaps in degrees; a URDF has radians: waist."
    ]


TURNED = KNOWN["UR5"][0].changed(
    base=np.diag([-1.0, -1, 1, 1]), tool=np.array([[0.0, -1, 0, 0], [0, 0, -1, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
)
BASE_AND_TOOL = ["The base T_s0 is missing: it should be rotated by 180° about z.",
                 "The tool transform is missing: it should be rotated by 120° about (0.5774, -0.5774, 0.5774)."]  # fmt: skip


def negated(row, column):
    """The rows of the UR5 with a wrong sign, the rows counted from 1."""
    return KNOWN["UR5"][0].rows * np.where(np.arange(24).reshape(6, 4) == 4 * (row - 1) + column, -1, 1)


def told(found):
    """The texts of each explanation."""
    return [[fault.text for fault in each.faults] for each in found.explanations]


def test_a_slip_another_base_and_another_tool_are_one_explanation_and_other_zeros_the_other():
    found = examine(kl.to_urdf(TURNED.to_chain()), kl.DHTable(negated(4, 1), convention="standard"))
    assert told(found)[0] == ["Row 4: alpha has the wrong sign.", *BASE_AND_TOOL]
    assert "explanations fit, and the first is a mistake in row 4, with the base and tool" in found.sentence
    tables = [each.corrected for each in found.explanations]
    assert len({str(table) for table in tables}) == len(tables) > 1
    html, q = found._repr_html_(), np.random.default_rng(0).uniform(-3, 3, (50, 6))
    assert html.index("Explanation 1.") < html.index("Explanation 2.") < html.index("<p>base = [[-1, 0, 0, 0]")
    for table in tables:
        np.testing.assert_allclose(table.fk(q), found.arm.fk(q), atol=1e-7)
    assert "e-" not in "".join(found.copies().values())


def test_a_right_table_is_called_right_in_the_sentence_that_says_how_far_the_tool_is_off():
    arm, table = kl.to_urdf(TURNED.to_chain()), KNOWN["UR5"][0]
    for given, end in (
        (table, "and only because of base and tool: the table itself is right."),
        (table.changed(rows=table.rows + np.eye(6, 4) * [0, 0, 0, np.pi / 2]), "apart from them the table is right."),
    ):
        found = examine(arm, given)
        assert found.sentence.startswith("For the same q the tool differs by up to 1.")
        assert found.sentence.endswith(end)
    assert told(examine(arm, table)) == [BASE_AND_TOOL]
    assert "The table with the base and the tool of the arm as CSV" in examine(arm, table)._repr_html_()


def test_typed_right_angles_are_right_angles_and_rounding_leaves_no_noise_in_the_corrected_table():
    turned = KNOWN["UR5"][0].changed(base=np.diag([-1.0, -1, 1, 1]))
    found = examine(turned, page(0.08916, -0.425, -0.3922, 0.1091, 0.09465, 0.0823))  # four digits, as a toolbox prints
    assert told(found)[0] == BASE_AND_TOOL[:1]
    assert found.corrected.rows[:, 3].tolist() == [0, 0, 0, 0, 0, 0]
    assert [found.wrong_rows, examine(turned, UR5E).wrong_rows] == [[], [3, 4]]
    for typed in ("1.5708", "1.571"):
        found = examine(
            kl.to_urdf(TURNED.to_chain()),
            page(0.089159, 0.425, -0.39225, 0.10915, 0.09465, 0.0823).replace("π/2", typed),
        )
        assert np.abs(found.corrected.rows[:, 1]).tolist() == [np.pi / 2, 0, 0, np.pi / 2, np.pi / 2, 0]
        assert found.wrong_rows == [1]
        assert "e-" not in "".join(found.copies().values())


def test_the_numbers_that_are_shown_of_a_urdf_give_the_accuracy_that_is_claimed():
    found = examine(kl.to_urdf(TURNED.to_chain()))
    shown = found._repr_html_().replace("<sub>i-1</sub>", "_{i-1}").replace("<sub>i</sub>", "_i")
    modified = kl.assign_frames(found.arm, convention="modified", snap=True).table
    assert "0.089159]" in shown.split("modified convention")[1].split("All digits")[0].split("Screw")[0]
    off, angle = map(float, re.findall(r"at most (\S+) m and (\S+)°", shown)[1])
    q = np.random.default_rng(0).uniform(-3, 3, (50, 6))
    assert np.abs(modified.fk(q) - found.arm.fk(q)).max() <= 2 * max(off, np.radians(angle)) + 1e-12


def test_a_mistake_beside_the_choices_that_are_enough_is_no_explanation():
    table = KNOWN["IRB 140"][0]
    found = examine(table.changed(base=TURNED.base, tool=TURNED.tool), table)
    assert [[fault.name for fault in each.faults] for each in found.explanations] == [["wrong base", "wrong tool"]]


def test_a_file_in_millimetres_is_named_and_no_fit_leaves_the_range_of_a_table():
    table, arm = KNOWN["UR5e"][0], KNOWN["UR5e"][0].to_chain()
    large = kl.Chain(arm.screws * ([1] * 3 + [1000] * 3), arm.home * ([[1, 1, 1, 1000]] * 3 + [[1] * 4]))
    said = "The lengths are a thousandth of those of the arm. Is the arm in millimetres?"
    assert told(examine(large, table)) == [[said]]
    assert examine(large, table.changed(rows=table.rows.round(3))).sentence.startswith(
        "For the same q the tool differs"
    )


def test_a_base_has_the_digits_to_which_it_was_found():
    in_millimetres = KNOWN["UR5"][0].changed(rows=KNOWN["UR5"][0].rows.round(3))
    found = examine(KNOWN["UR5"][0].changed(base=kl.exp([0, 0, 0, 0.0558, 0, 0])), in_millimetres)
    assert "translated by (0.056, 0, 0) m" in told(found)[0][0]


def test_whose_rows_are_copied_is_said_and_the_source_is_no_assumption():
    html = examine("UR5", UR5E.rsplit("\n", 1)[0], convention="standard")._repr_html_()
    assert "The table of the arm, not yours, as text" in html
    assert "<p>The arm:</p><ul><li>Source: Universal Robots" in html


def test_what_is_given_is_escaped_and_what_cannot_be_read_is_said():
    for arm, table in (("<script>alert(1)</script>", ""), ("UR5", "<script>alert(1)</script>"), ("no such arm", "")):
        found = examine(arm, table)
        assert found.unread
        assert "<script>" not in found._repr_html_()
    sheet = practise(kl.robots.rpr().changed(name="<script>alert(1)</script> $x$"), "ada")
    statements = [sheet.problem(k).statement for k in range(1, 7)]
    assert any("scriptalert(1)script x" in text for text in statements)
    assert not any("<script>" in text for text in statements)


def test_every_copy_of_a_table_has_its_base_tool_convention_and_units():
    """Those that are code run; all but the last are read back."""
    rtb = pytest.importorskip("roboticstoolbox")
    turned, shift = np.diag([-1.0, -1, 1, 1]), kl.exp([0, 0, 0, 0.1, 0, 0.2])
    for name, (plain, _) in KNOWN.items():
        q = np.random.default_rng(1).uniform(-1, 1, plain.n)
        for table in (plain, plain.changed(base=turned @ shift, tool=shift @ turned, signs=-plain.signs)):
            texts, code, robot = formats(table), {}, {}
            exec(texts["Python"], code)
            exec(texts["Robotics Toolbox"], robot)
            assert isinstance(robot["robot"], rtb.DHRobot)
            joints = {"text": table.joints, "CSV": "", "LaTeX": "", "Python": ""}
            again = [read_table(texts[kind], joints=letters).table for kind, letters in joints.items()]
            for each in (robot["robot"].fkine(q).A, *(one.fk(q) for one in (code["table"], *again))):
                np.testing.assert_allclose(each, table.fk(q), atol=1e-9, err_msg=name)
            ends = [name for name in ("base", "tool") if not np.allclose(getattr(table, name), np.eye(4))]
            for kind, text in texts.items():
                assert re.search(r"lengths in m, angles in (degrees|radians)", text), kind
                assert f"{table.convention} convention" in text or f"convention='{table.convention}'" in text, kind
                assert all(f"{name} = [[" in text or f"{name}=" in text for name in ends) or "new frames" in text, kind


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
