"""Roll, pitch and yaw as URDF defines them: rotations about the *fixed* axes x, y and z, in this order."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp, homogeneous


def origin(xyz: ArrayLike = (0.0, 0.0, 0.0), rpy: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
    """Write the pose of <origin xyz=... rpy=.../> in a URDF: a frame that is first rotated and then translated.

    (3,) metres and (3,) radians -> (4, 4):  p = xyz, R = Rz(yaw) Ry(pitch) Rx(roll).
    The first rotation is the rightmost factor, because all rotations are about the axes of the fixed frame.

    Source: the URDF specification, "joint": "fixed axis roll, pitch and yaw angles in radians".

    >>> origin(rpy=(np.pi / 2, 0, np.pi / 2))[:3, 2].round(6) + 0.0      # roll takes z to -y, and yaw takes that to x
    array([1., 0., 0.])
    """
    named = (("xyz", xyz), ("rpy", rpy))
    xyz, (roll, pitch, yaw) = (validation.single(validation.vectors(x, name, 3), name) for name, x in named)
    return homogeneous(exp([0, 0, yaw]) @ exp([0, pitch, 0]) @ exp([roll, 0, 0]), xyz)


def roll_pitch_yaw(R: ArrayLike) -> Array:
    """Find roll, pitch and yaw of a rotation: the inverse of the rpy of `origin`.

    (3, 3) -> (3,) radians, with pitch in [-pi/2, pi/2]. At a pitch of +-pi/2 roll and yaw rotate about the same line, so only
    their sum or their difference is determined: the result is one of the solutions.

    Source: the first column of R gives the yaw, and Rz(-yaw) R = Ry(pitch) Rx(roll) gives pitch and roll at every angle.

    >>> roll_pitch_yaw(origin(rpy=(0.1, 0.2, 0.3))[:3, :3]).round(12)
    array([0.1, 0.2, 0.3])
    """
    R = validation.rotations_or_poses(R, "R")
    if R.shape != (3, 3):
        raise ValueError(f"R must have shape (3, 3); got {R.shape}. Pass one rotation at a time.")
    yaw = np.arctan2(R[1, 0], R[0, 0])
    pitch_and_roll = exp([0, 0, -yaw]) @ R
    roll = np.arctan2(-pitch_and_roll[1, 2], pitch_and_roll[1, 1])
    pitch = np.arctan2(-pitch_and_roll[2, 0], pitch_and_roll[0, 0])
    return np.array([roll, pitch, yaw])
