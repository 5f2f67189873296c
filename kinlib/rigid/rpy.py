"""Roll, pitch and yaw as URDF means them: turns about the *fixed* x, y and z, in this order."""

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import exp, homogeneous


def origin(xyz: ArrayLike = (0.0, 0.0, 0.0), rpy: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
    """Write the pose that <origin xyz=... rpy=.../> means: a frame that was turned, and then shifted.

    (3,) metres and (3,) radians -> (4, 4):  p = xyz, R = Rz(yaw) Ry(pitch) Rx(roll).
    The turn that comes first stands to the right, because all axes are those of the frame that stays.

    Raises ValueError for other sizes, and for NaN.
    Source: the URDF specification, "joint": "fixed axis roll, pitch and yaw angles in radians".

    >>> origin(rpy=(np.pi / 2, 0, np.pi / 2))[:3, 2].round(6) + 0.0      # z rolls to -y, and yaws on to x
    array([1., 0., 0.])
    """
    roll, pitch, yaw = _three(rpy, "rpy")
    return homogeneous(exp([0, 0, yaw]) @ exp([0, pitch, 0]) @ exp([roll, 0, 0]), _three(xyz, "xyz"))


def roll_pitch_yaw(R: ArrayLike) -> Array:
    """Read roll, pitch and yaw off a rotation: the inverse of origin's rpy.

    (3, 3) -> (3,) radians, with pitch in [-pi/2, pi/2]. At a pitch of a quarter turn roll and yaw turn about the same
    line, and only their sum or difference has a meaning: any yaw serves, with the roll that goes with it.

    Raises ValueError for a matrix that is not a rotation.
    Source: the first column tells the yaw; undone, it leaves Ry(pitch) Rx(roll), which has no bad angle.

    >>> roll_pitch_yaw(origin(rpy=(0.1, 0.2, 0.3))[:3, :3]).round(12)
    array([0.1, 0.2, 0.3])
    """
    R = validation.rotations_or_poses(R, "R")
    if R.shape != (3, 3):
        raise ValueError(f"R should be one rotation, (3, 3); got {R.shape}.")
    yaw = np.arctan2(R[1, 0], R[0, 0])
    rest = exp([0, 0, -yaw]) @ R
    return np.array([np.arctan2(-rest[1, 2], rest[1, 1]), np.arctan2(-rest[2, 0], rest[0, 0]), yaw])


def _three(x: ArrayLike, name: str) -> Array:
    values = validation.vectors(x, name, 3)
    if values.ndim != 1:
        raise ValueError(f"{name} should be three numbers; got shape {values.shape}.")
    return values
