"""Numbers of a student's own: the same ones every time, others for the neighbour.

A variant is drawn from the student, the problem and nothing else, on every machine and for years to come. Of Python's
generator only `random()` promises that, so everything here is built on it.
"""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose
from kinlib.view.drawing.canvas import view_axes
from misstep.sampling import Sampler

MIN_JOINT_DISTANCE_M = 1.2
"""How far apart two joints of a drawn arm stand on the sheet, in metres of the arm."""

MIN_DROP_LINE_DISTANCE_M = 0.4
"""How far apart the lines stand that drop from them to the floor, so that each height is read at its own line."""

MIN_POINT_DISTANCE_M = 1.0
"""How far apart the points of a drawing stand on the sheet, in metres, for marks on both to be told apart."""

AXIS_DIRECTIONS = (X, Y, Z, -X, -Y, -Z)


def are_distinguishable(places: Sequence[Array]) -> bool:
    """Whether a drawing shows these points apart from each other; one point alone is no drawing yet.

    >>> are_distinguishable([np.zeros(3), 3 * X]), are_distinguishable([np.zeros(3), 0.1 * X])
    (True, False)
    """
    _, sheet = view_axes("default")
    far = [np.linalg.norm(sheet @ (one - other)) for k, one in enumerate(places) for other in places[:k]]
    return bool(far and min(far) > MIN_POINT_DISTANCE_M)


class ArmSampler(Sampler):
    """A sampler that also draws points, frames and arms.

    >>> ArmSampler("ada", "03.1").arm("RPR").n
    3
    """

    def point(self, reach: int) -> Array:
        """A point with whole coordinates, none of them zero and no two of equal size: no sign or swap can hide."""
        sizes = self.shuffled(range(1, reach + 1))[:3]
        return np.array([self.choice((-1, 1)) * size for size in sizes], dtype=float)

    def axes(self) -> tuple[Array, Array, Array]:
        """The axes x, y, z of a frame, each along one of {s}."""
        x = self.choice(AXIS_DIRECTIONS)
        z = self.choice([axis for axis in AXIS_DIRECTIONS if not axis @ x])
        return x, np.cross(z, x), z

    def arm(self, letters: str, reach: int = 4) -> Chain:
        """An arm with axes along x, y, z and joints at whole coordinates, as one draws it on squared paper.

        letters such as "RPR" name the joints from base to tool. Neighbouring axes are never parallel, and no joint hides
        another in the drawing.
        """
        joints: list[tuple[Array, Array, float]] = []
        for letter in letters:
            free = [axis for axis in AXIS_DIRECTIONS if not joints or not axis @ joints[-1][0]]
            point = self._point_in_sight([place for _, place, _ in joints], reach)
            joints.append((self.choice(free), point, SLIDE if letter == "P" else 0.0))
        home = pose(self.axes(), self.point(reach))
        return arm(joints, home, "your arm", "drawn for you")

    def _point_in_sight(self, others: Sequence[Array], reach: int) -> Array:
        """A point that the drawing shows apart from others and from the origin, on a drop line of its own."""
        _, sheet = view_axes("default")
        while True:
            point = self.point(reach)
            apart = [sheet @ (point - other) for other in [np.zeros(3), *others]]
            if all(
                np.linalg.norm(step) > MIN_JOINT_DISTANCE_M and abs(step[0]) > MIN_DROP_LINE_DISTANCE_M
                for step in apart
            ):
                return point
