"""Sheet 09 computes its answers from the origins of joints; Pinocchio, whose parser is that of ROS, must agree on every file."""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from urdf_files import poses_by_pinocchio

from kincourse import open_sheet
from kincourse.lecture_09_urdf.files import ARM, FOUR_BAR
from kinlib import load_urdf
from kinlib.rigid.rpy import origin

ROOT = Path(__file__).parents[3]
LECTURE = json.loads((ROOT / "notebooks" / "09_urdf.ipynb").read_text("utf-8"))["cells"]
SPINDLE = re.search(
    "<robot name=.spindle.*?</robot>", "\n".join("".join(cell["source"]) for cell in LECTURE), re.DOTALL
)[0]
STUDENTS = ["student 0", "student 1"]
POSITION_ATOL_M = 1e-4
"""The sheet prints a right angle as 1.5708, with an error of 4e-6 rad, and its arms are about ten metres long."""


def agree(one, other):
    np.testing.assert_allclose(one, other, rtol=0, atol=POSITION_ATOL_M)


def facts(sheet, k):
    """What a student knows of problem k: what is given, and what stands in the statement."""
    problem = sheet.problem(k)
    return SimpleNamespace(**problem.given, **problem.shown)


@pytest.mark.parametrize("student", STUDENTS)
def test_pinocchio_reads_every_file_of_the_sheet_and_gives_its_answers(student):
    pin = pytest.importorskip("pinocchio")
    sheet = open_sheet("09_urdf", student)
    answer = {k: sheet.problem(k).answer.value for k in range(1, 9)}
    for k in (2, 3, 4, 5, 8):
        assert len(pin.buildModelFromXML(facts(sheet, k).urdf).names) > 2
    names = ["joint_1", "joint_2", "joint_3"]
    [hand] = poses_by_pinocchio(facts(sheet, 3).urdf, "base", "hand", names, np.zeros((1, 3)))
    agree(hand[:3, 3], answer[3])
    [hand] = poses_by_pinocchio(facts(sheet, 5).urdf, "base", "hand", names[:2], np.zeros((1, 2)))
    agree(hand, answer[5])
    given = facts(sheet, 7)
    model = pin.buildModelFromXML(given.urdf, mimic=True)
    data = model.createData()
    pin.framesForwardKinematics(model, data, np.array([given.q]))
    agree(data.oMf[model.getFrameId("tool")].translation, answer[7])
    printed = re.search("```xml\n(.*?)\n```", sheet.problem(1).statement, re.DOTALL)[1]
    xyz, rpy = (" ".join(map(str, row)) for row in answer[6])
    written = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 0 1"/>'
    for element, pose in ((printed, answer[1]), (written, origin(*answer[6]))):
        joint = f'<joint name="j" type="continuous"><parent link="a"/><child link="b"/>{element}</joint>'
        model = pin.buildModelFromXML(f'<robot name="r"><link name="a"/><link name="b"/>{joint}</robot>')
        agree(model.jointPlacements[1].homogeneous, pose)


# --- what readers do with a file ---


def by_pinocchio(text, _path):
    import pinocchio

    return list(pinocchio.buildModelFromXML(text).names)[1:]


def by_pytransform3d(text, _path):
    from pytransform3d.urdf import UrdfTransformManager

    manager = UrdfTransformManager()
    manager.load_urdf(text)
    names = re.findall(r'<joint name="(\w+)"', text)
    for name in names:
        manager.get_joint_limits(name)  # KeyError if it does not know the joint
    return names


def by_roboticstoolbox(text, path):
    from roboticstoolbox import Robot

    path.write_text(text, "utf-8")
    links = Robot.URDF(str(path)).links
    pattern = r'<joint name="(\w+)".*?<parent link="(\w+)"/> <child link="(\w+)"'
    names = {(parent, child): name for name, parent, child in re.findall(pattern, text, re.DOTALL)}
    return [names[link.parent.name, link.name] for link in links if link.isjoint]


READERS = {
    "kinlib": lambda text, _: load_urdf(text).joint_names,
    "pinocchio": by_pinocchio,
    "pytransform3d": by_pytransform3d,
    "roboticstoolbox": by_roboticstoolbox,
}


def tilt_with(old, new):
    """The file of the camera with a change in its second joint."""
    pan, tilt = ARM.split('  <joint name="tilt"')
    return f'{pan}  <joint name="tilt"{tilt.replace(old, new)}'


FILES = {
    "no change": ARM,
    "limit without effort and velocity": tilt_with(' effort="10" velocity="1"', ""),
    "child that is not a link": tilt_with('child link="camera"', 'child link="Camera"'),
    "link that no joint holds": ARM.replace('<link name="camera"/>', '<link name="camera"/> <link name="lens"/>'),
    "roll of -90, in degrees": tilt_with("-1.5708", "-90"),
    "lower and upper swapped": tilt_with('lower="-1" upper="1"', 'lower="1" upper="-1"'),
    "axis of length 0": tilt_with('axis xyz="0 0 1"', 'axis xyz="0 0 0"'),
    "axis of length 2": tilt_with('axis xyz="0 0 1"', 'axis xyz="0 0 2"'),
    "axis in the frame of the base": tilt_with('axis xyz="0 0 1"', 'axis xyz="0 1 0"'),
    "tilt mimics pan": tilt_with("/> </joint>", '/> <mimic joint="pan"/> </joint>'),
    "second parent: a four-bar": FOUR_BAR,
}
TABLE = [
    [cell.strip() for cell in line.strip("|\n").split("|")]
    for cell in LECTURE
    for line in cell["source"]
    if line.startswith("| ") and line[2:].partition(" |")[0] in FILES
]


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("reader", READERS)
def test_a_reader_does_what_the_table_of_the_lecture_says(reader, tmp_path):
    """Each has exceptions of its own."""
    if reader != "kinlib":
        pytest.importorskip(reader)
    assert [label for label, *_ in TABLE] == list(FILES)
    for label, *recorded in TABLE:
        try:
            said = f"reads {', '.join(READERS[reader](FILES[label], tmp_path / 'robot.urdf'))}"
        except Exception:
            said = "refuses"
        assert said == recorded[list(READERS).index(reader)], label


def test_what_the_lecture_says_of_pinocchio_is_so():
    pin = pytest.importorskip("pinocchio")
    model = pin.buildModelFromXML(FILES["axis of length 0"])
    data = model.createData()
    pin.framesForwardKinematics(model, data, np.array([0.0, 0.7]))
    R = data.oMf[model.getFrameId("camera")].rotation
    assert abs(np.linalg.det(R) - 1) > 0.1, "an axis of length 0 leads to a pose that is no rotation"
    moving = [pin.buildModelFromXML(SPINDLE, mimic=asked).nv for asked in (False, True)]
    assert moving == [2, 1], "a mimic joint moves by itself unless asked otherwise"


def test_the_joint_c_of_the_four_bar_has_no_influence_on_the_rocker_of_pytransform3d():
    urdf = pytest.importorskip("pytransform3d.urdf")
    manager = urdf.UrdfTransformManager()
    manager.load_urdf(FOUR_BAR)
    before = manager.get_transform("rocker", "ground")
    manager.set_joint("C", 0.5)
    np.testing.assert_array_equal(manager.get_transform("rocker", "ground"), before)
    manager.set_joint("D", 0.5)
    assert np.abs(manager.get_transform("rocker", "ground") - before).max() > 0.1
