"""Linkages of four bars by compass and ruler: where two circles meet, and nothing that is solved step by step.

A method of its own beside kinlib.mechanisms.mechanism: what a sheet calls right does not come from the solver that a student may use.
"""

from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.rigid.angles import wrap_angle

COINCIDENCE_TOL_M = 1e-6
"""Two pins nearer than this, in metres, stand on each other."""


class FourBar(NamedTuple):
    """The lengths of a four-bar linkage, in metres. A stands at the origin and D on the x axis, at the ground's length."""

    ground: float
    crank: float
    coupler: float
    rocker: float

    @property
    def grashof_excess(self) -> float:
        """Shortest and longest less the other two: below 0 by Grashof's condition, 0 at a change point.

        >>> round(FourBar(0.4, 0.1, 0.35, 0.3).grashof_excess, 2)
        -0.15
        """
        ordered = sorted(self)
        return ordered[0] + ordered[3] - ordered[1] - ordered[2]

    def pin_positions(self, A: float) -> tuple[Array, Array, Array]:
        """Where B and D are, (2,), and the two places (2, 2) where C can be: left of the arrow from B to D, and right of it.

        Raises ValueError where the coupler and the rocker do not reach each other.

        >>> B, D, C = FourBar(4, 3, 4, 3).pin_positions(np.pi / 2)
        >>> B.round(3) + 0.0, C.round(3) + 0.0
        (array([0., 3.]), array([[ 4.  ,  3.  ],
               [ 1.12, -0.84]]))
        """
        B, D = self.crank * np.array([np.cos(A), np.sin(A)]), np.array([self.ground, 0.0])
        line = D - B
        distance = float(np.linalg.norm(line))
        if distance < COINCIDENCE_TOL_M:
            raise ValueError(f"B stands on D, and the circles about them have no two places in common: {self}.")
        along = (distance**2 + self.coupler**2 - self.rocker**2) / (2 * distance)
        if self.coupler < abs(along):
            raise ValueError(
                f"From B to D it is {distance:.4g} m: circles of {self.coupler} and {self.rocker} m do not meet."
            )
        along_line, left = line / distance, np.array([-line[1], line[0]]) / distance
        height = np.sqrt(self.coupler**2 - along**2)
        return B, D, np.array([B + along * along_line + height * left, B + along * along_line - height * left])

    def assembly_modes(self, A: float) -> Array:
        """Both assembly modes at a crank angle as joint values A, B, D, C of kinlib.mechanisms.linkages.four_bar, (2, 4).

        The angles lie between -pi and pi; the first mode has C left of the arrow from B to D.

        >>> FourBar(4, 3, 4, 3).assembly_modes(np.pi / 2)[0].round(4)
        array([ 1.5708, -1.5708,  1.5708, -1.5708])
        """
        B, D, C = self.pin_positions(A)
        coupler, rocker = (np.arctan2(*(C - foot).T[::-1]) for foot in (B, D))
        q = np.stack([np.full(2, A), coupler - A, rocker, coupler - rocker], axis=1)
        return wrap_angle(q)

    def dead_point(self) -> float:
        """The greatest crank angle, in radians, at which coupler and rocker still reach: they lie in one line there.

        Raises ValueError for a crank that turns right round, or that is held back by a folded coupler instead.

        >>> round(float(np.degrees(FourBar(0.5, 0.3, 0.3, 0.3).dead_point())), 2)
        93.82
        """
        cos_crank_angle = self.cos_crank_angle(self.coupler + self.rocker)
        if not -1 < cos_crank_angle < 1:
            raise ValueError(f"This crank is not held back by a stretched coupler and rocker: {self}.")
        return float(np.arccos(cos_crank_angle))

    def cos_crank_angle(self, distance: float) -> float:
        """The cosine of the crank's angle where D is far from B, by the law of cosines.

        >>> FourBar(3, 4, 1, 1).cos_crank_angle(5)
        0.0
        """
        return (self.ground**2 + self.crank**2 - distance**2) / (2 * self.ground * self.crank)


def slider_position(crank: float, rod: float, offset: float, A: float, side: int = 1) -> float:
    """Where the slider of a slider-crank is along x, on the far side of B (side 1) or on the near one (side -1).

    >>> slider_position(3, 5, 0, np.pi / 2)
    4.0
    """
    return float(crank * np.cos(A) + side * np.sqrt(rod**2 - (offset - crank * np.sin(A)) ** 2))
