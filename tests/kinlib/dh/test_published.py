"""Tables that makers publish, against the URDF files that go about: the confusions that people write to forums about.

The numbers are facts, with their sources. UR5: Universal Robots, "DH parameters for calculations of kinematics and
dynamics", and the joints of ur_description's ur5 URDF. Panda: Franka Emika, "Robot and interface specifications", and the
joints of franka_description's panda URDF. The URDF texts below are ours and hold the joints only.
"""

import numpy as np
import pytest

import kinlib as kl
from kinlib import DHTable, diagnose, equivalent

pin = pytest.importorskip("pinocchio", reason="Pinocchio reads the URDF files")

UR5_TABLE = """
    i | a        | alpha | d        | theta
    1 | 0        | 90°   | 0.089159 | q1
    2 | -0.425   | 0     | 0        | q2
    3 | -0.39225 | 0     | 0        | q3
    4 | 0        | 90°   | 0.10915  | q4
    5 | 0        | -90°  | 0.09465  | q5
    6 | 0        | 0     | 0.0823   | q6
"""
UR5_JOINTS = [
    ((0, 0, 0.089159), (0, 0, 0), (0, 0, 1)),
    ((0, 0.13585, 0), (0, np.pi / 2, 0), (0, 1, 0)),
    ((0, -0.1197, 0.425), (0, 0, 0), (0, 1, 0)),
    ((0, 0, 0.39225), (0, np.pi / 2, 0), (0, 1, 0)),
    ((0, 0.093, 0), (0, 0, 0), (0, 0, 1)),
    ((0, 0, 0.09465), (0, 0, 0), (0, 1, 0)),
]
PANDA_TABLE = """
    i | a_{i-1} | alpha_{i-1} | d_i   | theta_i
    1 | 0       | 0           | 0.333 | q1
    2 | 0       | -90°        | 0     | q2
    3 | 0       | 90°         | 0.316 | q3
    4 | 0.0825  | 90°         | 0     | q4
    5 | -0.0825 | -90°        | 0.384 | q5
    6 | 0       | 90°         | 0     | q6
    7 | 0.088   | 90°         | 0     | q7
"""
PANDA_JOINTS = [
    ((0, 0, 0.333), (0, 0, 0), (0, 0, 1)),
    ((0, 0, 0), (-np.pi / 2, 0, 0), (0, 0, 1)),
    ((0, -0.316, 0), (np.pi / 2, 0, 0), (0, 0, 1)),
    ((0.0825, 0, 0), (np.pi / 2, 0, 0), (0, 0, 1)),
    ((-0.0825, 0.384, 0), (-np.pi / 2, 0, 0), (0, 0, 1)),
    ((0, 0, 0), (np.pi / 2, 0, 0), (0, 0, 1)),
    ((0.088, 0, 0), (np.pi / 2, 0, 0), (0, 0, 1)),
]


def urdf(joints):
    """A URDF that holds joints and nothing else: (xyz, rpy, axis), one after the other."""

    def spaced(values):
        return " ".join(repr(float(value)) for value in values)

    links = "".join(f'<link name="link{i}"/>' for i in range(len(joints) + 1))
    chained = "".join(
        f'<joint name="joint{i}" type="continuous"><parent link="link{i}"/><child link="link{i + 1}"/>'
        f'<origin xyz="{spaced(xyz)}" rpy="{spaced(rpy)}"/><axis xyz="{spaced(axis)}"/></joint>'
        for i, (xyz, rpy, axis) in enumerate(joints)
    )
    return f'<robot name="arm">{links}{chained}</robot>'


def from_pinocchio(joints):
    """The chain that Pinocchio makes of the file: its screws are the columns of its own Jacobian at home."""
    model = pin.buildModelFromXML(urdf(joints))
    data = model.createData()
    q = pin.neutral(model)
    pin.computeJointJacobians(model, data, q)
    pin.framesForwardKinematics(model, data, q)
    # Pinocchio writes (v, omega).
    screws = np.roll(data.J.T, 3, axis=1)
    return kl.Chain(screws, data.oMf[model.nframes - 1].homogeneous), model


def poses(model, angles):
    data = model.createData()
    found = []
    for row in angles:
        # A continuous joint of Pinocchio is a point of the circle.
        q = np.column_stack([np.cos(row), np.sin(row)]).ravel()
        pin.framesForwardKinematics(model, data, q)
        found.append(data.oMf[model.nframes - 1].homogeneous)
    return np.array(found)


UR5 = DHTable(UR5_TABLE, convention="standard", name="UR5")
PANDA = DHTable(PANDA_TABLE, convention="modified", name="Panda")


@pytest.mark.parametrize(("table", "joints"), [(UR5, UR5_JOINTS), (PANDA, PANDA_JOINTS)], ids=["UR5", "Panda"])
def test_the_maker_s_table_is_the_urdf_up_to_base_tool_and_zero(table, joints):
    chain, model = from_pinocchio(joints)
    q = np.random.default_rng(0).uniform(-3, 3, (20, chain.n))
    np.testing.assert_allclose(chain.fk(q), poses(model, q), rtol=0, atol=1e-9)
    found = equivalent(table, chain)
    assert found
    mapped = found.base @ table.fk(found.signs * q + found.offsets) @ found.tool
    np.testing.assert_allclose(mapped, poses(model, q), rtol=0, atol=1e-9)
    same = found.poses(table.to_chain(), q)
    np.testing.assert_allclose(same, poses(model, q), rtol=0, atol=1e-9)


def test_the_ur5_s_half_turn_is_told():
    """Its URDF has the base rotated by half a turn, which is the same as another zero of joint 1."""
    chain, _ = from_pinocchio(UR5_JOINTS)
    said = str(diagnose(UR5, chain)).splitlines()
    assert said[0].startswith("For the same q, the poses of the table and of the arm differ by up to ")
    assert said[2] == "joint 1: add 180° to theta (or rotate the base by as much about axis 1)."
    assert said[3].startswith("The tool transform is missing: it should be rotated by 90° about x, translated by")
    assert len(said) == 5


def test_the_panda_s_table_read_in_the_wrong_convention_is_recognised():
    """It is printed in the modified convention, without saying so in most copies."""
    chain, _ = from_pinocchio(PANDA_JOINTS)
    (fault,) = diagnose(PANDA.changed(convention="standard"), chain).faults
    assert fault.text == "The table is in the modified convention, but was read as standard."


def test_puma_560_is_the_robotics_toolbox_s_puma_560():
    rtb = pytest.importorskip("roboticstoolbox")
    links = rtb.models.DH.Puma560().links
    theirs = DHTable([[link.a, link.alpha, link.d, link.theta] for link in links], convention="standard")
    assert equivalent(theirs, kl.robots.puma560())
    assert equivalent(theirs, kl.assign_frames(kl.robots.puma560(), convention="modified").table)
