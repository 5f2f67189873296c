"""Sheet 09 computes its answers from the origins of joints; Pinocchio, whose parser is that of ROS, must agree on every file."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
from urdf_files import poses_by_pinocchio

from kincourse import open_sheet
from kinlib import load_urdf
from kinlib.rigid.rpy import origin

STUDENTS = [f"student {i}" for i in range(16)]
POSITION_ATOL_M = 1e-4
"""The sheet prints a right angle as 1.5708, with an error of 4e-6 rad, and its arms are about ten metres long."""


def agree(one, other, atol=POSITION_ATOL_M):
    np.testing.assert_allclose(one, other, rtol=0, atol=atol)


def facts(sheet, k):
    """What a student knows of problem k: what is given, and what stands in the statement."""
    problem = sheet.problem(k)
    return SimpleNamespace(**problem.given, **problem.shown)


@pytest.mark.parametrize("student", STUDENTS[:2])
def test_pinocchio_reads_every_file_of_the_sheet_and_gives_its_answers(student):
    pin = pytest.importorskip("pinocchio")
    sheet = open_sheet("09_urdf", student)
    answer = {k: sheet.problem(k).answer.value for k in range(1, 11)}
    for k in (2, 3, 4, 5, 7, 10):
        assert len(pin.buildModelFromXML(facts(sheet, k).urdf).names) > 2
    names = ["joint_1", "joint_2", "joint_3"]
    [hand] = poses_by_pinocchio(facts(sheet, 3).urdf, "base", "hand", names, np.zeros((1, 3)))
    agree(hand[:3, 3], answer[3])
    [hand] = poses_by_pinocchio(facts(sheet, 5).urdf, "base", "hand", names[:2], np.zeros((1, 2)))
    agree(hand, answer[5])
    given = facts(sheet, 9)
    model = pin.buildModelFromXML(given.urdf, mimic=True)
    data = model.createData()
    pin.framesForwardKinematics(model, data, np.array([given.q]))
    agree(data.oMf[model.getFrameId("tool")].translation, answer[9])
    assert pin.buildModelFromXML(joint_of(sheet.problem(1).statement)).nv == 1
    xyz, rpy = (" ".join(map(str, row)) for row in answer[8])
    agree(joint_pose(pin, f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 0 1"/>'), origin(*answer[8]), 1e-12)
    agree(joint_pose(pin, joint_of(sheet.problem(1).statement)), answer[1])


def joint_of(statement):
    """The elements of a joint that a statement prints."""
    element = re.search("```xml\n(.*?)\n```", statement, re.DOTALL)[1]
    return with_joint(element)


def with_joint(element):
    joint = f'<joint name="j" type="continuous"><parent link="a"/><child link="b"/>{element}</joint>'
    return f'<robot name="r"><link name="a"/><link name="b"/>{joint}</robot>'


def joint_pose(pin, text):
    model = pin.buildModelFromXML(text if "<robot" in text else with_joint(text))
    return model.jointPlacements[1].homogeneous


def test_every_fault_occurs_and_correcting_its_line_makes_the_file_valid():
    """The decoys, such as a zero axis of a fixed joint, are no faults, and what must stand there is what the answer says."""
    pinocchio, seen = pytest.importorskip("pinocchio"), set()
    for student in STUDENTS:
        sheet = open_sheet("09_urdf", student)
        text, line = facts(sheet, 6).urdf, int(sheet.problem(6).answer.value[0])
        lines = text.splitlines()
        faulty = lines[line - 1]
        seen.add(re.search(r"<(\w+)", faulty)[1])
        links, right = re.findall(r'<link name="(\w+)"', text), float(sheet.problem(6).answer.value[1])
        mended = re.sub(r'lower="(\S+)" upper="(\S+)"', rf'lower="{right:g}" upper="\1"', faulty)
        mended = mended.replace('"0 90 0"', f'"0 {right:.5g} 0"')
        if "<axis" in faulty:
            numbers = np.array(re.search(r'"(.*?)"', faulty)[1].split(), dtype=float)
            assert numbers[np.flatnonzero(numbers)[0]] == 2 * right
            mended = f'  <axis xyz="{" ".join(f"{x / 2:g}" for x in numbers)}"/>'
        text = "\n".join([*lines[: line - 1], mended, *lines[line:]])
        assert load_urdf(text, tip=links[-1]).n == 3
        assert len(list(pinocchio.buildModelFromXML(text).names)[1:]) == 3
        assert all(np.isclose(np.linalg.norm(axis), 1) for axis in axes_of_moving_joints(text))
    assert seen == {"limit", "axis", "origin"}


def axes_of_moving_joints(text):
    """The axes as they are in the file, before a reader makes them unit vectors."""
    joints = [joint for joint in re.findall(r"<joint.*?</joint>", text, re.DOTALL) if 'type="fixed"' not in joint]
    found = [re.search(r'<axis xyz="([^"]*)"', joint) for joint in joints]
    return [np.array(axis[1].split(), dtype=float) for axis in found if axis]
