"""Random points, frames and arms: the same ones every time for a student and a problem, and different ones for others.

They are drawn with `misstep.sampling.Sampler`, which depends on the student and the problem only, on every machine.
"""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose
from kinlib.view.drawing.canvas import view_axes
from misstep.sampling import Sampler

MIN_JOINT_DISTANCE_M = 1.2
"""The minimum distance of two joints of an arm in its drawing, in metres at the scale of the arm."""

MIN_DROP_LINE_DISTANCE_M = 0.4
"""The minimum distance of the lines that drop from the joints to the floor, so that each height is read at its own line."""

MIN_POINT_DISTANCE_M = 1.0
"""The minimum distance of two points in a drawing, in metres at its scale, at which their labels can be told apart."""

MIN_TRANSPOSE_DIFFERENCE = 0.1
"""The minimum difference of the components of R d and R^T d at which a rotation is not taken for its transpose."""

AXIS_DIRECTIONS = (X, Y, Z, -X, -Y, -Z)

PLAIN_ANGLES_DEG = (20, 25, 30, 35, 40, 50, 55, 60, 65, 70)
"""Angles that are easy to read and to type, without 45 degrees, at which sine and cosine are equal."""


def are_distinguishable(places: Sequence[Array], distance: float = MIN_POINT_DISTANCE_M) -> bool:
    """Whether a drawing shows points (k, 3) at this distance from each other; False for fewer than two points."""
    _, sheet = view_axes("default")
    far = [np.linalg.norm(sheet @ (one - other)) for k, one in enumerate(places) for other in places[:k]]
    return bool(far and min(far) > distance)


def shows_transposes(robot: Chain) -> bool:
    """Whether the rotation R of the home pose takes every joint axis to a direction far from that to which R^T takes it.

    So a transpose in place of R changes the directions of all axes. No R = R^T does.
    """
    R = robot.home[:3, :3]
    return bool(np.abs(robot.lines.axis @ (R - R.T)).max(axis=-1).min() > MIN_TRANSPOSE_DIFFERENCE)


class ArmSampler(Sampler):
    """A sampler that also draws points, frames and arms."""

    def __init__(self, student: str, problem: str, attempt: int = 0) -> None:
        super().__init__(student, problem, attempt)
        self.student = student
        """Whose numbers are drawn: what several problems share is drawn from this alone."""

    def of_problem(self, number: str) -> "ArmSampler":
        """Return the sampler of another problem for the same student, so that several problems can share a robot."""
        return ArmSampler(self.student, number)

    def point(self, reach: int) -> Array:
        """Draw a point (3,) with integer coordinates up to `reach` in size, none of them zero and no two of equal size.

        So every flipped sign and every swap changes the point.
        """
        sizes = self.shuffled(range(1, reach + 1))[:3]
        return np.array([self.choice((-1, 1)) * size for size in sizes], dtype=float)

    def axes(self) -> tuple[Array, Array, Array]:
        """Draw the axes x, y, z of a right-handed frame, each parallel to an axis of {s}."""
        x = self.choice(AXIS_DIRECTIONS)
        z = self.choice([axis for axis in AXIS_DIRECTIONS if not axis @ x])
        return x, np.cross(z, x), z

    def arm(self, joint_types: str, reach: int = 4) -> Chain:
        """Draw an arm with joint axes along x, y or z and joints at points with integer coordinates.

        joint_types  one letter per joint from base to tool, R or P: "RPR"
        reach        the largest coordinate of a joint, in metres

        Neighbouring axes are never parallel, and no joint covers another one in the drawing.
        """
        joints: list[tuple[Array, Array, float]] = []
        for letter in joint_types:
            free = [axis for axis in AXIS_DIRECTIONS if not joints or not axis @ joints[-1][0]]
            point = self._point_in_sight([place for _, place, _ in joints], reach)
            joints.append((self.choice(free), point, SLIDE if letter == "P" else 0.0))
        home = pose(self.axes(), self.point(reach))
        return arm(joints, home, "your arm", "drawn for you")

    def _point_in_sight(self, others: Sequence[Array], reach: int) -> Array:
        """Draw a point that the drawing shows apart from others and from the origin, with a drop line of its own."""
        _, sheet = view_axes("default")
        while True:
            point = self.point(reach)
            apart = [sheet @ (point - other) for other in [np.zeros(3), *others]]
            if all(
                np.linalg.norm(step) > MIN_JOINT_DISTANCE_M and abs(step[0]) > MIN_DROP_LINE_DISTANCE_M
                for step in apart
            ):
                return point
