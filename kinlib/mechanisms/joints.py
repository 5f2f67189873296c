"""Joints of linkages: between two bodies, with one screw axis or several."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.screw import axes, line, screw


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between two bodies, read from a drawing of the linkage like the joints of an open chain.

    name            of the joint; the values of a joint with k > 1 degrees of freedom are called name.1, ..., name.k
    bodies          the two bodies that it joins: the second one moves by e^[S]q relative to the first one
    screws          (6,) or (k, 6)  one screw axis, or the k of a composite joint in order, from the first body on
    closing_offset  (4, 4)  the pose by which the drawing of the second body must be moved for the two bodies to meet in this
                    joint: the identity (the default), unless the linkage is drawn open
    point           (3,)  where the joint is drawn, on the first body; by default the point of its first axis nearest to the origin

    Raises ValueError if a joint joins a body to itself.

    >>> Joint("elbow", ("upper arm", "forearm"), kl.screw((0, 0, 1), (1, 0, 0))).dof
    1
    """

    name: str
    bodies: tuple[str, str]
    screws: Array = field(repr=False)
    closing_offset: Array = field(default_factory=lambda: np.eye(4), repr=False)
    point: Array = field(default_factory=lambda: np.empty(0), repr=False)

    def __post_init__(self) -> None:
        bodies = list(self.bodies)
        if len(bodies) != 2 or bodies[0] == bodies[1]:
            given = validation.describe(self.bodies)
            raise ValueError(f"Joint {self.name} must join two different bodies; got {given}. Pass the names of both.")
        screws = np.atleast_2d(axes(self.screws, f"screws of {self.name}"))
        # Chain validates the offset, and its message is right for a joint as well.
        home = Chain(screws, self.closing_offset).home
        drawn = self.point if np.size(self.point) else line(screws[0]).point
        point = validation.vectors(drawn, f"point of {self.name}", 3)
        for name, values in (("screws", screws), ("closing_offset", home), ("point", point)):
            object.__setattr__(self, name, validation.read_only_copy(values))

    @property
    def dof(self) -> int:
        """The number k of its degrees of freedom, which is the number of its joint values."""
        return len(self.screws)


def universal(first: ArrayLike, second: ArrayLike, point: ArrayLike) -> Array:
    """Return the two screw axes (2, 6) of a universal joint: rotations about two axes that intersect in a point.

    first, second (3,) the unit directions of the axes, point (3,) in metres.

    >>> universal((1, 0, 0), (0, 1, 0), (0, 0, 0)).shape
    (2, 6)
    """
    return np.stack([screw(first, point), screw(second, point)])


def spherical(point: ArrayLike) -> Array:
    """Return the three screw axes (3, 6) of a spherical joint: rotations about x, then y, then z through its centre.

    Three angles cannot parametrize all rotations without a singularity: if the second angle is a right angle, then the first
    and the third rotate about the same line, and the Jacobian loses a rank that the joint itself does not lose.

    >>> spherical((0, 0, 1)).shape
    (3, 6)
    """
    return screw(np.eye(3), point)
