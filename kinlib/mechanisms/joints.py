"""Bodies and the joints between them: any walk over joints, forwards or back, is an open chain.

A joint passed forwards is a factor e^[S]q. Passed backwards it is e^[-S]q, the same joint with its axis turned round. The
drawing of a body may have to be moved before it meets its neighbour, by a constant pose; constants move to the right end
of the product, G e^[S]q = e^[Ad(G) S]q G, and become the home pose of the chain.
"""

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import adjoint, exp, inverse
from kinlib.rigid.screw import axes, is_prismatic, line, screw

PARALLEL = 1e-2
"""Axes that lie closer to parallel than the root of this, in radians, have no middle along them, only across."""


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between two bodies, read off a drawing of the linkage like the joints of an open chain.

    name     what it is called; the freedoms of a composite joint are called name.1, name.2, ...
    bodies   the two that it joins: the second moves by e^[S]q relative to the first
    screws   (6,) or (k, 6)  one screw axis, or the k of a composite joint in turn, the one at the first body first
    gap      (4, 4)  where the drawing of the second body must go before the two meet in this joint: the identity, unless
             the linkage is drawn open
    limits   (2,) or (k, 2)  the least and the greatest value, infinite by default
    point    (3,)  where it is drawn, on the first body; `place` fills in what is not given

    Raises ValueError for a joint of a body with itself, and for what is no screw axis, no pose, no limits.

    >>> from kinlib.rigid.screw import screw
    >>> Joint("elbow", ("upper arm", "forearm"), screw((0, 0, 1), (1, 0, 0))).freedoms
    1
    """

    name: str
    bodies: tuple[str, str]
    screws: Array = field(repr=False)
    gap: Array = field(default_factory=lambda: np.eye(4), repr=False)
    limits: Array | None = field(default=None, repr=False)
    point: Array | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        bodies = list(self.bodies)
        if len(bodies) != 2 or bodies[0] == bodies[1]:
            raise ValueError(
                f"Joint {self.name} should join two different bodies; got {validation.brief(self.bodies)}."
            )
        screws = np.atleast_2d(axes(self.screws, f"screws of {self.name}"))
        # A chain refuses whatever is wrong with gap or limits, in words that fit here as well.
        chain = Chain(screws, self.gap, limits=None if self.limits is None else np.atleast_2d(self.limits))
        keep = {"screws": screws, "gap": chain.home}
        if chain.limits is not None:
            keep["limits"] = chain.limits
        if self.point is not None:
            keep["point"] = validation.vectors(self.point, f"point of {self.name}", 3)
        for name, values in keep.items():
            object.__setattr__(self, name, validation.frozen(values))

    @property
    def place(self) -> Array:
        """Where it is drawn, (3,): the point given, or that of its first axis nearest the origin."""
        return line(self.screws[0]).point if self.point is None else self.point

    @property
    def range(self) -> Array:
        """The least and the greatest of its values, (k, 2), infinite where none was given."""
        return np.tile([-np.inf, np.inf], (self.freedoms, 1)) if self.limits is None else self.limits

    @property
    def freedoms(self) -> int:
        """The number of its joint values."""
        return len(self.screws)


def universal(first: ArrayLike, second: ArrayLike, point: ArrayLike) -> Array:
    """The two screw axes (2, 6) of a universal joint: two turns about axes that meet in a point.

    >>> universal((1, 0, 0), (0, 1, 0), (0, 0, 0)).shape
    (2, 6)
    """
    return np.stack([screw(first, point), screw(second, point)])


def spherical(point: ArrayLike) -> Array:
    """The three screw axes (3, 6) of a spherical joint: turns about x, then y, then z through its centre.

    Three angles cannot name all rotations without a flaw: where the second is a right angle, the first and the third
    turn alike, and the Jacobian loses a rank that the joint itself does not lose.

    >>> spherical((0, 0, 1)).shape
    (3, 6)
    """
    return screw(np.eye(3), point)


def cylindrical(axis: ArrayLike, point: ArrayLike) -> Array:
    """The two screw axes (2, 6) of a cylindrical joint: a slide along a line, then a turn about it.

    >>> cylindrical((0, 0, 1), (0, 0, 0))
    array([[0., 0., 0., 0., 0., 1.],
           [0., 0., 1., 0., 0., 0.]])
    """
    return screw(axis, point, [np.inf, 0.0])


def in_series(chain: Chain, bodies: Sequence[str], names: Sequence[str], gap: Array) -> list[Joint]:
    """Write the joints of an open chain one by one, between n + 1 bodies; the last one may leave a gap.

    names  of the joints, unless the chain knows its own

    >>> from kinlib.chains.robots import rpr
    >>> [joint.name for joint in in_series(rpr(), ["ground", "a", "b", "c"], ["1", "2", "3"], np.eye(4))]
    ['1', '2', '3']
    """
    names = chain.joint_names or names
    limits = [None] * chain.n if chain.limits is None else chain.limits
    gaps = [np.eye(4)] * (chain.n - 1) + [gap]
    parts = zip(names, pairwise(bodies), chain.screws, gaps, limits, chain.joint_points, strict=True)
    return [Joint(*of_joint) for of_joint in parts]


Passage = tuple[int, bool]
"""A joint, by its place in the list, and whether it is passed forwards, from its first body to its second."""


def walks(joints: Sequence[Joint], ground: str) -> dict[str, list[Passage]]:
    """The shortest walk from the ground to every body that can be reached, as passages.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> walks(four_bar(4, 1, 3.5, 3).joints, "ground")["coupler"]       # over A to the crank, then over B
    [(0, True), (1, True)]
    """
    reached: dict[str, list[Passage]] = {ground: []}
    waiting = deque([ground])
    while waiting:
        here = waiting.popleft()
        for i, joint in enumerate(joints):
            for forwards, (a, b) in ((True, joint.bodies), (False, joint.bodies[::-1])):
                if a == here and b not in reached:
                    reached[b] = [*reached[a], (i, forwards)]
                    waiting.append(b)
    return reached


def cycles(joints: Sequence[Joint], reached: dict[str, list[Passage]]) -> list[list[Passage]]:
    """One loop for each joint that no walk needs: out to it, over it, and back another way.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> joints = four_bar(4, 1, 3.5, 3).joints                          # A, B, then D, C on the other side
    >>> cycles(joints, walks(joints, "ground"))
    [[(2, True), (3, True), (1, False), (0, False)]]
    """
    used = {i for walk in reached.values() for i, _ in walk}
    loops = []
    for i in sorted(set(range(len(joints))) - used):
        out, back = (reached[body] for body in joints[i].bodies)
        # What both ways share would be walked there and back again.
        shared = next((k for k, (p, q) in enumerate(zip(out, back, strict=False)) if p != q), min(len(out), len(back)))
        home = [(k, not forwards) for k, forwards in reversed(back[shared:])]
        loops.append([*out[shared:], (i, True), *home])
    return loops


@dataclass(frozen=True, eq=False)
class Walk:
    """A walk over joints, as the open chain that it is: chain.fk(q[..., columns]) is where it leads."""

    chain: Chain
    columns: NDArray[np.intp]

    @cached_property
    def middle(self) -> Array:
        """The point (3,) nearest to all axes that turn: the least squares of the distances, and nearest the origin.

        Seen from far away all axes look alike, and a Jacobian's small singular values drown in its large ones; seen from
        here they differ as much as they can.

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> four_bar(4, 1, 3.5, 3).loops[0].middle      # drawn open: D, C, B and A at x = 4, 7, 3.5 and 2.5
        array([4.25, 0.  , 0.  ])
        """
        axis, point, _ = (part[~is_prismatic(self.chain.screws)] for part in self.chain.lines)
        # Across an axis a distance counts, along it it does not: I - a a^T leaves what lies across.
        across = np.eye(3) - axis[:, :, None] * axis[:, None, :]
        # Axes that are nearly parallel meet far away, and nothing is gained by going there.
        near: Array = np.linalg.pinv(across.sum(axis=0), rcond=PARALLEL, hermitian=True) @ point.sum(axis=0)
        return near

    @cached_property
    def to_middle(self) -> Array:
        """The matrix (6, 6) that reads twists about the middle."""
        return adjoint(exp([0, 0, 0, *-self.middle]))

    @cached_property
    def size(self) -> float:
        """How far its axes are from its middle, and its end from its beginning, in metres: the longest of these ways."""
        there, back = exp([0, 0, 0, *-self.middle]), exp([0, 0, 0, *self.middle])
        centred = Chain(self.chain.screws @ self.to_middle.T, there @ self.chain.home @ back)
        return float(np.linalg.norm(np.vstack([centred.lines.point, centred.home[:3, 3]]), axis=1).max())


def as_chain(joints: Sequence[Joint], passages: Iterable[Passage], name: str) -> Walk:
    """Write a walk as an open chain, with the columns of q that its joints read.

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> as_chain(four_bar(4, 1, 3.5, 3).joints, [(0, True), (1, True)], "coupler").chain.joint_types
    'RR'
    """
    first = np.cumsum([0, *(joint.freedoms for joint in joints)])
    screws, columns, so_far = [], [], np.eye(4)
    for i, forwards in passages:
        joint, at = joints[i], np.arange(first[i], first[i + 1])
        if forwards:
            screws.append(joint.screws @ adjoint(so_far).T)
            columns.append(at)
            so_far = so_far @ joint.gap
        else:
            so_far = so_far @ inverse(joint.gap)
            screws.append(-joint.screws[::-1] @ adjoint(so_far).T)
            columns.append(at[::-1])
    return Walk(Chain(np.concatenate(screws), so_far, name=name), np.concatenate(columns))
