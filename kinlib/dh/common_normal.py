"""Two joint axes and what lies between them: their common normal, in every case that two lines can be in.

The normal is where a DH frame gets its x. If the axes are skew there is one. If they meet it has no length, and its
direction is square to both. If they are parallel there are many, all alike; if they are one line, every direction will do.
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kinlib.arrays.validation import Array

Case = Literal["skew", "intersecting", "parallel", "anti-parallel", "coincident", "anti-coincident"]

MEETS = 1e-12
"""Axes nearer than this, in metres for an arm of some metres, meet; axes that differ by this, in radians, are parallel."""

NEARLY = 1e-5
"""Axes less apart than this, in radians, are nearly parallel: their normal runs away like 1 / angle."""


@dataclass(frozen=True, eq=False)
class Normal:
    """A common normal from one axis to the next: its unit direction x, its feet on both axes, and the case met.

    sine   of the angle between the axes; where it is not 0 and the case is parallel, the axes were taken as parallel
    """

    case: Case
    x: Array
    start: Array
    end: Array
    sine: float

    @property
    def nearly_parallel(self) -> bool:
        """Whether the axes are so close to parallel that DH is singular here, and yet are not parallel."""
        return MEETS < self.sine < NEARLY

    @property
    def free(self) -> bool:
        """Whether the normal may slide along the axes."""
        return self.case not in {"skew", "intersecting"}


def common_normal(
    axis: tuple[Array, Array], other: tuple[Array, Array], before: Array, *, slide: bool, parallel_below: float = MEETS
) -> Normal:
    """Find the common normal from one axis to another, each a unit direction and a point on it.

    before          the x of the frame before; where a sign or a direction is free, the normal stays close to it
    slide           parallel axes: True puts the normal at the other point, as the Chapter 4 review deck does
    parallel_below  axes less apart than this, in radians, are taken as parallel

    Source: EduFill module, steps III and IV; Chapter 4 review deck, step 3.

    >>> X, Y, Z = np.eye(3)
    >>> common_normal((Z, 0 * Z), (Y, 2 * X), X, slide=True).case
    'skew'
    """
    (z, origin), (other_z, other_point) = axis, other
    # The place nearest to the other joint is the best one to measure from: what lies between is short and square to z.
    near = origin + z * (z @ (other_point - origin))
    across = other_point - near
    both = _cross(z, other_z)
    sine = math.hypot(*both)
    if sine <= parallel_below:
        start = near if slide else origin
        return _parallel(z, before, across, start, opposite=bool(z @ other_z < 0), sine=sine)
    x = both / sine
    # How far along each axis to go until the connection is square to both.
    along = float(_cross(across, other_z) @ both) / sine**2
    other_along = float(_cross(across, z) @ both) / sine**2
    start, end = near + along * z, other_point + other_along * other_z
    length = float(across @ x)
    if abs(length) <= MEETS:
        return Normal("intersecting", -x if x @ before < -MEETS else x, start, end, sine)
    return Normal("skew", x if length > 0 else -x, start, end, sine)


def _parallel(z: Array, before: Array, across: Array, start: Array, *, opposite: bool, sine: float) -> Normal:
    distance = math.hypot(*across)
    if distance > MEETS:
        return Normal("anti-parallel" if opposite else "parallel", across / distance, start, start + across, sine)
    x = before - z * (z @ before)
    return Normal("anti-coincident" if opposite else "coincident", x / np.linalg.norm(x), start, start, sine)


def _cross(u: Array, v: Array) -> Array:
    """The vector product of two vectors, (3,). np.cross is made for batches, and for two takes thirty times as long."""
    (a, b, c), (x, y, z) = u.tolist(), v.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])
