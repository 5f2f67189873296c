"""The robots of the course, as data: the joints of each robot, its home pose, and the document it is taken from.

An arm is written in the way its drawing is read: for each joint a direction, a point on the axis and a pitch. Lengths are in
metres. Where a document gives symbols instead of numbers, the lengths are arguments with defaults of realistic proportions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid import lie
from kinlib.rigid.screw import screw

__all__ = [
    "angled_arm", "arm", "hrr", "mid_formula_arm", "panda", "plain_arm", "pose", "puma560", "rppr", "rpr",
    "rpr_lecture7", "rprr", "scara", "ur5e", "youbot",
]  # fmt: skip
"""The functions, without X, Y, Z and SLIDE, so that `help` does not print what NumPy says about arrays."""

X, Y, Z = np.eye(3)
SLIDE = np.inf


def arm(joints: Sequence[tuple[Any, ...]], home: Array, name: str = "arm", source: str = "") -> Chain:
    """Construct a chain from joints (axis, point) or (axis, point, pitch), as read from a drawing of the home configuration.

    home (4, 4), see `pose`; name and source as in Chain.

    >>> arm([(Z, (0, 0, 0)), (X, (0, 0, 1), SLIDE)], pose(np.eye(3), (1, 0, 1)), "crane").joint_types
    'RP'
    """
    points = np.array([joint[1] for joint in joints], dtype=float)
    pitches = [joint[2] if len(joint) > 2 else 0.0 for joint in joints]
    return Chain(screw([joint[0] for joint in joints], points, pitches), home, points, name, source)


def pose(axes: ArrayLike, origin: ArrayLike) -> Array:
    """Construct the pose of a frame from its axes x, y, z and its origin.

    axes (3, 3) with x, y, z as rows, origin (3,) in metres -> (4, 4), with the axes as the columns of its rotation. If you have
    the rotation matrix instead, use `kinlib.rigid.lie.homogeneous`.

    Raises ValueError for axes that are not perpendicular to each other, of unit length and right-handed.

    >>> pose((X, Z, -Y), (1, 2, 3))[:3, 1]        # y
    array([0., 0., 1.])
    """
    axes, origin = validation.vectors(axes, "axes", 3), validation.vectors(origin, "origin", 3)
    return lie.homogeneous(validation.rotations_or_poses(axes.T, "axes"), origin)


def rpr() -> Chain:
    """The first example of "Forward kinematics II": a revolute, a prismatic and a revolute joint in one vertical plane.

    The joints are as printed. The printed M is not a pose: its third row is 0 0 0 1, and its last row 0 0 0 0. The first two
    rows determine one rotation, with the third row 1 0 0; the origin and the last row follow. So M is reconstructed by
    changing two entries.

    >>> rpr().screws[0] + 0.0
    array([ 0., -1.,  0.,  0.,  0.,  4.])
    """
    joints = [(-Y, (-4, -2, 0)), (Z, (-4, -2, 0), SLIDE), (-Y, (0, -4, 0))]
    return arm(joints, pose((Z, X, Y), (0, 0, 1)), "RPR", "Forward kinematics II, example 1; M reconstructed")


def rppr() -> Chain:
    """The body-form example of "Forward kinematics II": a revolute, two prismatic and a revolute joint.

    M, joint 1 and joint 4 are as printed, there in the body frame. The directions of the two prismatic joints are missing (the
    source shows zeros); they are reconstructed along the body's y, towards joint 4, and along its z.

    >>> rppr().body_screws[3].round(6) + 0.0
    array([ 0.,  1.,  0.,  0.,  0., -2.])
    """
    joints = [(X, (0, 2, 0)), (X, (0, 2, 0), SLIDE), (Z, (2, 2, 0), SLIDE), (X, (2, 2, 0))]
    source = "Forward kinematics II, body-form example; the slides are reconstructed"
    return arm(joints, pose((-Y, X, Z), (2, 0, 0)), "RPPR", source)


def rprr(l2: float = 0.5, l4: float = 0.2, l5: float = 0.3) -> Chain:
    """The RPRR arm of "DH example with n = 5", with a fixed tool as its fifth frame.

    The source gives symbols only. Its table has joint 3 at height l2, and the tool l5 further out and l4 further down.

    >>> rprr(l2=0.5, l4=0.2, l5=0.3).home[:3, 3]
    array([0. , 0.3, 0.3])
    """
    joints = [(Z, (0, 0, 0)), (Y, (0, 0, 0), SLIDE), (X, (0, 0, l2)), (Y, (0, 0, l2))]
    return arm(joints, pose((Z, X, Y), (0, l5, l2 - l4)), "RPRR", "DH example with n = 5")


def youbot() -> Chain:
    """The arm of the KUKA youBot, from the EduFill manipulation module's table, straight and horizontal when all values are zero.

    >>> youbot().home[:3, 3]
    array([0.5405, 0.    , 0.147 ])
    """
    parallel = [(-Y, (x, 0, 0.147)) for x in (0.033, 0.188, 0.323)]
    joints = [(Z, (0, 0, 0)), *parallel, (X, (0.323, 0, 0.147))]
    return arm(joints, pose((Z, -Y, X), (0.5405, 0, 0.147)), "youBot", "EduFill manipulation module, lecture 1")


def puma560(a2: float = 0.4318, a3: float = 0.0203, d3: float = 0.15005, d4: float = 0.4318) -> Chain:
    """The PUMA 560 of "Kinematics under DH", in its zero configuration, with {s} where the first two axes meet.

    The source gives symbols only; the default lengths are those of Corke and Armstrong-Helouvry (1994).

    >>> puma560().joint_types
    'RRRRRR'
    """
    elbow, wrist = (a2, d3, 0), (a2 + a3, d3, -d4)
    joints = [(Z, (0, 0, 0)), (Y, (0, 0, 0)), (Y, elbow), (-Z, wrist), (Y, wrist), (-Z, wrist)]
    return arm(joints, pose((X, -Y, -Z), wrist), "PUMA 560", "Kinematics under DH; lengths from Corke (1994)")


def ur5e() -> Chain:
    """The UR5e, a collaborative arm with three parallel axes: the maker's table, in its zero configuration.

    >>> ur5e().home[:3, 3].round(4)
    array([-0.8172, -0.2329,  0.0628])
    """
    side, wrist = -0.1333, (-0.8172, -0.1333, 0.0628)
    parallel = [(-Y, (x, side, 0.1625)) for x in (0, -0.425, -0.8172)]
    joints = [(Z, (0, 0, 0)), *parallel, (-Z, wrist), (-Y, wrist)]
    source = 'Universal Robots, "DH parameters for calculations of kinematics and dynamics"'
    return arm(joints, pose((X, Z, -Y), (-0.8172, -0.2329, 0.0628)), "UR5e", source)


def panda() -> Chain:
    """The Panda, an arm with seven joints, up to its flange: the maker's modified table, in its zero configuration.

    >>> panda().home[:3, 3].round(4)
    array([0.088, 0.   , 0.926])
    """
    shoulder, elbow, wrist, flange = (0, 0, 0.333), (0.0825, 0, 0.649), (0, 0, 1.033), (0.088, 0, 1.033)
    upper = [(Z, (0, 0, 0)), (Y, shoulder), (Z, shoulder), (-Y, elbow)]
    joints = [*upper, (Z, wrist), (-Y, wrist), (-Z, flange)]
    source = 'Franka Emika, "Robot and interface specifications"'
    return arm(joints, pose((X, -Y, -Z), (0.088, 0, 0.926)), "Panda", source)


def scara() -> Chain:
    """The Adept Cobra 600, a SCARA: two parallel joints move it over a table, a prismatic joint lowers the tool, a last one turns it.

    >>> scara().joint_types
    'RRPR'
    """
    tool = (0.6, 0, 0.387)
    joints = [(Z, (0, 0, 0)), (Z, (0.325, 0, 0.387)), (-Z, tool, SLIDE), (-Z, tool)]
    source = "Adept Cobra 600, as in the Robotics Toolbox for Python (Corke)"
    return arm(joints, pose((X, -Y, -Z), tool), "SCARA", source)


def rpr_lecture7(a1: float = 0.4) -> Chain:
    """The RPR arm at the end of "Kinematics under DH", which moves in the plane of x and y.

    >>> rpr_lecture7(a1=0.4).fk([0, 0.1, 0])[:3, 3] + 0.0
    array([ 0.4, -0.1,  0. ])
    """
    joints = [(Z, (0, 0, 0)), (-Y, (a1, 0, 0), SLIDE), (Z, (a1, 0, 0))]
    return arm(joints, pose((X, Y, Z), (a1, 0, 0)), "planar RPR", "Kinematics under DH")


def plain_arm(column: float = 0.4, upper: float = 0.5, fore: float = 0.3) -> Chain:
    """A family for plain exercises, with every axis along x, y or z: a turret, a shoulder, a telescope and a wrist.

    >>> plain_arm().joint_types
    'RRPR'
    """
    shoulder, wrist = (0, 0, column), (upper, 0, column)
    joints = [(Z, (0, 0, 0)), (-Y, shoulder), (X, shoulder, SLIDE), (X, wrist)]
    home = pose((X, Y, Z), (upper + fore, 0, column))
    return arm(joints, home, "plain arm", "Chapter 4 review: family of exercises 4.7 to 4.9")


def angled_arm(tilt: float = np.pi / 4, column: float = 0.4, upper: float = 0.5, fore: float = 0.3) -> Chain:
    """A family with angled joints: the second joint leans from z towards x by tilt radians, the third translates along it.

    >>> angled_arm().joint_types
    'RRPR'
    """
    lean = np.cos(tilt) * Z + np.sin(tilt) * X
    shoulder = np.array((0, 0, column))
    elbow = shoulder + upper * lean
    joints = [(Z, (0, 0, 0)), (lean, shoulder), (lean, elbow, SLIDE), (Y, elbow)]
    home = pose((X, Y, Z), elbow + fore * X)
    return arm(joints, home, "angled arm", "Chapter 4 review: family of exercises 4.11 to 4.13")


def mid_formula_arm(reach: float = 0.6, lift: float = 0.4, tool: float = 0.2) -> Chain:
    """A family for the mid-formula form: two joints easy to read from the base, two easy to read from the tool.

    >>> mid_formula_arm().joint_types
    'RRRR'
    """
    wrist = (reach, 0, lift)
    joints = [(Z, (0, 0, 0)), (Y, (0, 0, lift)), (X, wrist), (Y, wrist)]
    home = pose((-Z, Y, X), (reach + tool, 0, lift))
    return arm(joints, home, "mid-formula arm", "Chapter 4 review: family of exercises 4.17 and 4.20")


def hrr(pitch: float = 0.1, first: float = 0.5, second: float = 0.3) -> Chain:
    """A family with a helical joint of the given pitch, in metres per radian, before two revolute joints with parallel axes.

    >>> hrr().joint_types
    'HRR'
    """
    joints = [(Z, (0, 0, 0), pitch), (Z, (first, 0, 0)), (Z, (first + second, 0, 0))]
    home = pose((X, Y, Z), (first + second, 0, 0))
    return arm(joints, home, "HRR arm", "a helical joint, in the manner of the families of the Chapter 4 review")
