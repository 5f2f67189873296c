"""Arms of five and six joints whose lengths are letters, as in the exercises of a textbook."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kincourse.sampling.arms import ArmSampler, are_distinguishable
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.robots import SLIDE, X, Y, Z, arm, pose

SHAPES = {
    "RRRRR": ("zyyxz", "yzzxxz"),
    "RPRRR": ("zxyxy", "xzxxzx"),
    "PRRRR": ("yzxxz", "zxzyyz"),
    "RRRPR": ("zzyzx", "yxxzyz"),
    "RRPRRR": ("zyzxzx", "xzyxxzx"),
    "RRRRPR": ("zxxzyx", "xzyyzyz"),
}
"""By the types of the joints: the axis of each joint, and the direction of each link, from {s} to joint 1 and on to the tool.

No two neighbouring joints commute, no axis passes through the origin of {s}, and each link is perpendicular to an axis beyond
it. So every mistake can be seen.
"""

LENGTHS_M = (1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2)
"""The lengths in a drawing, one for each letter. Formulas must hold for all lengths."""

MIN_LINK_M = 0.7
"""The minimum distance of two joints in the drawing, in metres at its scale."""


@dataclass(frozen=True, eq=False)
class LetteredArm:
    """An arm whose links are parallel to the axes of {s}.

    joint_types  one letter per joint: "RRPRR"
    axes         (n, 3) the direction of each joint
    links        (n + 1, 3) the direction of each link, from {s} to joint 1, from joint to joint, and to the tool
    tool         (3, 3) the axes x, y, z of the tool, in rows
    lengths      (n + 1,) the lengths of the links in the drawing
    """

    joint_types: str
    axes: Array
    links: Array
    tool: Array
    lengths: Array

    @property
    def letters(self) -> list[str]:
        """The names of the lengths: "L_1", "L_2" and so on."""
        return [f"L_{i}" for i in range(1, len(self.links) + 1)]

    @cached_property
    def chain(self) -> Chain:
        """The arm with the lengths of the drawing."""
        return self.with_lengths(self.lengths)

    def with_lengths(self, lengths: Array) -> Chain:
        """Return the arm with other lengths (n + 1,)."""
        points = np.cumsum(np.asarray(lengths)[:, None] * self.links, axis=0)
        pitches = [SLIDE if letter == "P" else 0.0 for letter in self.joint_types]
        joints = list(zip(self.axes, points[:-1], pitches, strict=True))
        return arm(joints, pose(self.tool, points[-1]), "your arm", "drawn for you")


def draw_lettered_arm(sampler: ArmSampler) -> LetteredArm:
    """Draw one of the shapes, rotated about z, with signs of its joint axes and with a tool frame for which R is not R^T.

    No joint covers another one in the drawing.
    """
    types = sampler.choice(sorted(SHAPES))
    quarter = sampler.choice([np.array([x, np.cross(Z, x), Z]) for x in (X, Y, -X, -Y)])
    axes, links = (np.array([quarter["xyz".index(letter)] for letter in letters]) for letters in SHAPES[types])
    signs = np.array([sampler.choice((-1.0, 1.0)) for _ in types])
    tool = np.array(sampler.axes())
    while np.allclose(tool, tool.T):
        tool = np.array(sampler.axes())
    while True:
        lengths = np.array(sampler.shuffled(LENGTHS_M)[: len(links)])
        robot = LetteredArm(types, signs[:, None] * axes, links, tool, lengths)
        if are_distinguishable([np.zeros(3), *robot.chain.joint_points, robot.chain.home[:3, 3]], MIN_LINK_M):
            return robot
