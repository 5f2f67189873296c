"""Whole URDF files: the poses of all links, mimic joints, a floating base, and chains between any two links."""

from xml.etree import ElementTree as ET

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import poses as any_pose
from urdf_files import TWO_FINGERS, link_poses_by_pinocchio, poses_by_pinocchio, trees

import kinlib as kl
from kinlib import Tree

CLOSE = 1e-9


def values_in_file(text, independent):
    """The value of each joint of a file that moves, from those of the independent ones: straight from the XML."""
    found = dict(independent)
    joints = [joint for joint in ET.fromstring(text).findall("joint") if joint.get("type") != "fixed"]
    mimic = {joint.get("name"): joint.find("mimic").attrib for joint in joints if joint.find("mimic") is not None}

    def value(name):
        if name not in mimic:
            return found[name]
        says = mimic[name]
        return float(says.get("multiplier", 1)) * value(says["joint"]) + float(says.get("offset", 0))

    return {joint.get("name"): value(joint.get("name")) for joint in joints}


def moving_values(tree, q):
    """The values of all joints that move, from those of the independent ones."""
    by_name = dict(zip(tree.joint_names, q.T, strict=True))
    values = [k * by_name[driver] + c for driver, k, c in tree.couplings.values()]
    return np.reshape(values, (-1, len(q))).T


def assert_equal_poses(ours, theirs):
    assert set(ours) == set(theirs)
    for link, T in ours.items():
        np.testing.assert_allclose(T, theirs[link], rtol=0, atol=CLOSE, err_msg=link)


@given(trees(mimic=True), st.integers(0, 2**32 - 1))
def test_every_link_of_any_tree_moves_as_pinocchio_says(drawn, seed):
    text, *_ = drawn
    tree = Tree.from_urdf(text)
    q = np.random.default_rng(seed).uniform(-3, 3, (3, tree.n))
    values, moving = moving_values(tree, q), [*tree.couplings]
    said = [values_in_file(text, dict(zip(tree.joint_names, row, strict=True))) for row in q]
    np.testing.assert_allclose(values, [[row[name] for name in moving] for row in said], atol=1e-14)
    assert_equal_poses(tree.poses(q), link_poses_by_pinocchio(text, moving, values))


@given(trees(mimic=True))
def test_a_chain_between_any_two_links_agrees_with_pinocchio(drawn):
    text, base, tip = drawn
    tree = Tree.from_urdf(text)
    q = np.random.default_rng(1).uniform(-3, 3, (3, tree.n))
    values, moving = moving_values(tree, q), [*tree.couplings]
    expected = poses_by_pinocchio(text, base, tip, moving, values)
    try:
        chain = kl.load_urdf(text, base, tip)
    except ValueError as error:
        if "a joint must move between" not in str(error) and "of a chain must move independently" not in str(error):
            raise
        return
    columns = [tree.joint_names.index(name) for name in chain.joint_names]
    np.testing.assert_allclose(chain.fk(q[:, columns]), expected, rtol=0, atol=CLOSE)


def test_joint_values_may_be_given_by_name_some_of_them_for_a_whole_batch():
    tree = Tree.from_urdf(TWO_FINGERS)
    turns = np.linspace(-1, 1, 3)
    q = np.stack([turns, np.full(3, 0.02)], axis=-1)
    np.testing.assert_equal(tree.poses({"open": 0.02, "turn": turns}), tree.poses(q))


def test_a_chain_over_a_mimic_joint_is_refused_with_the_joint_and_its_line():
    with pytest.raises(ValueError, match=r"Line 7, .*joint follow mimics joint open, multiplied by -2"):
        Tree.from_urdf(TWO_FINGERS).chain("palm", "pad")


ROVER = """<robot name="rover"> <link name="world"/> <link name="body"/> <link name="raft"/> <link name="mast"/>
  <joint name="float" type="floating"> <parent link="world"/> <child link="body"/> <origin xyz="0 0 1"/> </joint>
  <joint name="skid" type="planar"> <parent link="body"/> <child link="raft"/> <axis xyz="0 0 1"/> <origin xyz="1 0 0"/> </joint>
  <joint name="pan" type="continuous"> <parent link="raft"/> <child link="mast"/> <axis xyz="0 0 1"/> </joint>
</robot>"""


@given(any_pose(), st.floats(-3, 3), st.floats(-3, 3), st.floats(-3, 3))
def test_planar_and_floating_joints_take_a_pose_as_in_pinocchio(T, x, y, angle):
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    model = pin.buildModelFromXML(ROVER)
    data = model.createData()
    c, s = np.cos(angle), np.sin(angle)
    pin.framesForwardKinematics(model, data, np.array([*pin.SE3ToXYZQUAT(pin.SE3(T)), x, y, c, s, c, s]))
    slid = np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]])
    found = Tree.from_urdf(ROVER).poses([angle], joint_poses={"float": T, "skid": slid})
    for link, pose in found.items():
        np.testing.assert_allclose(pose, data.oMf[model.getFrameId(link, pin.FrameType.BODY)].homogeneous, atol=1e-9)
