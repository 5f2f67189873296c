"""The common normal of two joint axes, in each of the six ways in which two lines in space can be related.

The common normal determines the x axis of a DH frame. Skew axes have exactly one. If the axes intersect, its length is zero and
its direction is perpendicular to both. Parallel axes have infinitely many, with one direction and one length. If the axes are
the same line, every perpendicular direction is possible.
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kinlib.arrays.tolerances import INTERSECTION_TOL_M, NEARLY_PARALLEL_RAD, PARALLEL_TOL_RAD
from kinlib.arrays.validation import Array
from kinlib.rigid.lie import cross

Case = Literal["skew", "intersecting", "parallel", "antiparallel", "coincident", "anti-coincident"]


@dataclass(frozen=True, eq=False)
class CommonNormal:
    """A common normal from one axis to the next: the case, its unit direction x, and its feet on both axes.

    sine   of the angle between the axes; if it is not 0 and the case is parallel, the axes were treated as parallel
    """

    case: Case
    x: Array
    start: Array
    end: Array
    sine: float

    @property
    def is_nearly_parallel(self) -> bool:
        """Whether the axes are so close to parallel that DH is ill-conditioned, without being parallel."""
        return PARALLEL_TOL_RAD < self.sine < NEARLY_PARALLEL_RAD

    @property
    def is_unique(self) -> bool:
        """Whether the axes determine the position of the normal; parallel axes have a common normal at every point."""
        return self.case in {"skew", "intersecting"}


def common_normal(
    axis: tuple[Array, Array],
    other: tuple[Array, Array],
    previous_x: Array,
    *,
    at_other_point: bool,
    parallel_below: float = PARALLEL_TOL_RAD,
) -> CommonNormal:
    """Compute the common normal from one axis to another, each given by a unit direction and a point on it.

    previous_x      the x of the previous frame; where the sign or the direction is free, the normal is chosen close to it
    at_other_point  for parallel axes: whether the normal goes through the point of the other axis, as the Chapter 4 review
                    has it, or else through that of the first
    parallel_below  axes at a smaller angle than this, in radians, are treated as parallel

    Source: EduFill manipulation module, steps III and IV; Chapter 4 review, step 3.
    """
    (z, origin), (other_z, other_point) = axis, other
    # Measuring from the foot nearest the other joint is the most accurate: the vector between is short and perpendicular to z.
    near = origin + z * (z @ (other_point - origin))
    across = other_point - near
    both = cross(z, other_z - z * np.sign(z @ other_z))  # of nearly parallel axes the difference has all its digits
    sine = math.hypot(*both)
    if sine <= parallel_below:
        start = near if at_other_point else origin
        distance, opposite = math.hypot(*across), z @ other_z < 0
        if distance > INTERSECTION_TOL_M:
            case: Case = "antiparallel" if opposite else "parallel"
            return CommonNormal(case, across / distance, start, start + across, sine)
        x = frame_axes(previous_x, z)[:, 0]
        return CommonNormal("anti-coincident" if opposite else "coincident", x, start, start, sine)
    x = both / sine
    # The distances along both axes to the points between which the connection is perpendicular to both.
    along = float(cross(across, other_z) @ both) / sine**2
    other_along = float(cross(across, z) @ both) / sine**2
    start, end = near + along * z, other_point + other_along * other_z
    length = float(across @ x)
    if abs(length) <= INTERSECTION_TOL_M:
        return CommonNormal("intersecting", -x if x @ previous_x < -PARALLEL_TOL_RAD else x, start, end, sine)
    return CommonNormal("skew", x if length > 0 else -x, start, end, sine)


def frame_axes(x: Array, z: Array) -> Array:
    """Compute the rotations (..., 3, 3) of frames with these z (..., 3), unit vectors, and with x as near as possible.

    >>> frame_axes(np.array([2.0, 0, 1]), np.array([0, 0, 1.0]))[:, 0]
    array([1., 0., 0.])
    """
    y = cross(z, x)
    y /= np.linalg.norm(y, axis=-1, keepdims=True)
    return np.stack(np.broadcast_arrays(cross(y, z), y, z), axis=-1)
