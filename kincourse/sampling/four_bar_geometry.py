"""Four-bar linkages in closed form, by the intersection of circles.

This is a second method, independent of the iterative solver in `kinlib.mechanisms`, because a student may use that solver.
"""

from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.angles import wrap_angle

COINCIDENCE_TOL_M = 1e-6
"""Two pins at a smaller distance, in metres, coincide."""


class FourBar(NamedTuple):
    """The lengths of a four-bar linkage, in metres. Pin A is at the origin, and pin D on the x axis at x = ground."""

    ground: float
    crank: float
    coupler: float
    rocker: float

    @property
    def grashof_excess(self) -> float:
        """Shortest plus longest length less the other two: negative if Grashof's condition holds, 0 at a change point."""
        ordered = sorted(self)
        return ordered[0] + ordered[3] - ordered[1] - ordered[2]

    def pin_positions(self, A: float) -> tuple[Array, Array, Array]:
        """The positions of B and D, each (2,), and the two possible positions of C, (2, 2), at the crank angle A in radians.

        The first C lies to the left of the arrow from B to D, the second one to its right.

        Raises ValueError if coupler and rocker do not reach each other, or if B coincides with D.
        """
        B, D = self.crank * np.array([np.cos(A), np.sin(A)]), np.array([self.ground, 0.0])
        line = D - B
        distance = float(np.linalg.norm(line))
        if distance < COINCIDENCE_TOL_M:
            raise ValueError(
                f"B must not coincide with D, because the circles about them then have the same centre; got {self}, "
                f"A = {A:.4g}."
            )
        along = (distance**2 + self.coupler**2 - self.rocker**2) / (2 * distance)
        if self.coupler < abs(along):
            raise ValueError(
                f"B and D are {distance:.4g} m apart: circles with radii {self.coupler} and {self.rocker} m do not meet."
            )
        along_line, left = line / distance, np.array([-line[1], line[0]]) / distance
        height = np.sqrt(self.coupler**2 - along**2)
        return B, D, np.array([B + along * along_line + height * left, B + along * along_line - height * left])

    def assembly_modes(self, A: float) -> Array:
        """Both assembly modes at a crank angle, as joint values A, B, D, C of `kinlib.linkages.four_bar`, (2, 4) in radians.

        The angles lie in (-pi, pi]; in the first mode C lies to the left of the arrow from B to D.

        Raises ValueError as `pin_positions` does.
        """
        B, D, C = self.pin_positions(A)
        coupler, rocker = (np.arctan2(*(C - foot).T[::-1]) for foot in (B, D))
        q = np.stack([np.full(2, A), coupler - A, rocker, coupler - rocker], axis=1)
        return wrap_angle(q)

    def cos_crank_angle(self, distance: float) -> float:
        """The cosine of the crank angle at which B and D are `distance` metres apart, by the law of cosines."""
        return (self.ground**2 + self.crank**2 - distance**2) / (2 * self.ground * self.crank)
