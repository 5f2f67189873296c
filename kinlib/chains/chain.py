"""Open chains: n screw axes and a home pose determine the pose of the tool at every configuration.

The same motion can be written in three forms, which differ in the position of the home pose M: the space form `Chain.fk`, the body
form `Chain.fk_body` and the mid form `Chain.fk_mid`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import accumulate

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.formatting import aligned_table, format_matrix, format_vector, html_table
from kinlib.arrays.validation import Array, JointValues, TakesLimitedValues
from kinlib.rigid.lie import adjoint, compose, exponentials, homogeneous, inverse, moved_screw
from kinlib.rigid.screw import Line, axes, is_prismatic, line

SCREW_HEADINGS = ["i", "joint", "omega", "v"]


@dataclass(frozen=True, eq=False, repr=False)
class Chain(TakesLimitedValues, validation.ReadOnly):
    """An open chain of revolute, prismatic and helical joints.

    screws   (n, 6)  screw axes S_1 ... S_n in the fixed frame {s}, at home
    home     (4, 4)  M = T_sb at q = 0
    points   (n, 3)  the point on its axis where each joint is drawn, at home; optional, see `joint_points`
    name, source     the name of the robot, and the document it is taken from
    limits   (n, 2)  the lower and the upper limit of each joint, infinite where it has none; None: no joint has limits
    joint_names      the n names of the joints in that document; optional

    Raises ValueError if there are no joints, if the screws are in columns or not normalized, if home is not rigid, if a point
    is not on its axis, or if a lower limit is above the upper one. Methods do for joint values of another size, for NaN, and for a
    missing or an unknown name.
    Source: Modern Robotics, 4.1; Chapter 4 review.

    >>> arm = Chain(np.array([kl.screw((0, 0, 1)), kl.screw((0, 0, 1), point=(1, 0, 0))]), home=kl.exp([0, 0, 0, 2, 0, 0]))
    >>> arm.fk([np.pi / 2, 0])[:3, 3].round(6) + 0.0      # an outstretched arm of two metres, rotated to the left
    array([0., 2., 0.])
    """

    screws: Array
    home: Array
    points: Array | None = None
    name: str = "arm"
    source: str = ""
    limits: Array | None = None
    joint_names: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        screws = axes(self.screws, "screws")
        if screws.ndim != 2 or len(screws) == 0:
            raise ValueError(f"screws must have shape (n, 6), one row per joint; got {screws.shape}.")
        self._set("screws", screws)
        self._set("home", validation.single_pose(self.home, "home"))
        if self.points is not None:
            self._set("points", _validate_points(self.screws, self.points))
        if self.limits is not None:
            self._set("limits", validation.joint_limits(self.limits, len(screws)))
        object.__setattr__(self, "joint_names", tuple(self.joint_names))
        if not all(isinstance(text, str) for text in (self.name, self.source, *self.joint_names)):
            raise ValueError(f"The names of an arm and its joints must be text; got {self.name!r}, {self.joint_names}.")
        if self.joint_names and len(set(self.joint_names)) != len(screws):
            raise ValueError(f"joint_names must have {len(screws)} different names; got {self.joint_names}.")

    def _set(self, name: str, values: Array) -> None:
        object.__setattr__(self, name, validation.read_only_copy(values))

    def __repr__(self) -> str:
        return f"Chain({self.name!r}, {self.n} joints: {self.joint_types})"

    def __str__(self) -> str:
        """Write the screw axes and the home pose."""
        title, rows, home = self._printed()
        return "\n".join([title, aligned_table([SCREW_HEADINGS, *rows]), home])

    def _repr_html_(self) -> str:
        title, rows, home = self._printed()
        return f"{html_table(f'{title}: screw axes in {{s}}, at home', SCREW_HEADINGS, rows)}<p>{home}</p>"

    def _printed(self) -> tuple[str, list[list[str]], str]:
        """The title, the rows of the screw axes, and the home pose, as text."""
        axes = enumerate(zip(self.joint_types, self.screws, strict=True), start=1)
        rows = [[str(i), letter, format_vector(S[:3]), format_vector(S[3:])] for i, (letter, S) in axes]
        title = f"{self.name}, {self.n} joint{'s'[: self.n != 1]} ({self.joint_types})"
        return title, rows, f"M = {format_matrix(self.home)}"

    @property
    def n(self) -> int:
        """The number of joints."""
        return len(self.screws)

    @cached_property
    def lines(self) -> Line:
        """The joint axes as geometry: directions (n, 3), the points nearest the origin (n, 3), pitches (n,).

        >>> kl.robots.rpr().lines.pitch
        array([ 0., inf,  0.])
        """
        return Line(*map(validation.read_only_copy, line(self.screws)))

    @cached_property
    def joint_types(self) -> str:
        """The types of the joints from base to tool, one letter each: R revolute, P prismatic, H helical.

        >>> kl.robots.rpr().joint_types
        'RPR'
        """
        _, point, pitch = self.lines
        # omega . v has the rounding errors of v, which grow with the distance of the axis.
        rounding = 8 * np.finfo(float).eps * np.linalg.norm(point, axis=-1)
        is_helical = np.abs(pitch) > np.maximum(tolerances.UNIT_LENGTH_TOL, rounding)
        return "".join(np.where(pitch == np.inf, "P", np.where(is_helical, "H", "R")))

    @cached_property
    def joint_points(self) -> Array:
        """A point (n, 3) on every joint axis at home: the given one, or else the one nearest to the previous joint's point."""
        if self.points is not None:
            return self.points
        chosen = [np.zeros(3)]
        for axis, foot, pitch in zip(*self.lines, strict=True):
            # The axis of a prismatic joint is a free vector, so it can be drawn at the previous joint's point.
            chosen.append(chosen[-1] if pitch == np.inf else foot + axis * (axis @ chosen[-1]))
        return validation.read_only_copy(chosen[1:])

    @cached_property
    def body_screws(self) -> Array:
        """The same axes in the tool frame {b} at home, (n, 6):  B_i = Ad(M^-1) S_i.

        Source: Modern Robotics, 4.1.3; Chapter 4 review, the last line of its derivation.

        >>> kl.robots.rppr().body_screws[0].round(6) + 0.0          # B_1 as Forward kinematics II prints it
        array([ 0.,  1.,  0.,  0.,  0., -2.])
        """
        return validation.read_only_copy(self.screws @ adjoint(inverse(self.home)).T)

    def fk(self, q: JointValues) -> Array:
        """Compute the pose of the tool by the space form: T(q) = e^[S1]q1 ... e^[Sn]qn M.

        q (..., n) in radians and metres, or a mapping from the name of each joint to its value -> T_sb (..., 4, 4).
        Source: Modern Robotics, (4.14).

        >>> kl.robots.rprr().fk(np.zeros((1000, 4))).shape
        (1000, 4, 4)
        """
        motions = exponentials(self.screws, self.in_order(q))  # e^[S1]q1, ..., e^[Sn]qn
        return reduce(compose, [*motions, self.home])

    def fk_body(self, q: JointValues) -> Array:
        """Compute the pose of the tool by the body form: T(q) = M e^[B1]q1 ... e^[Bn]qn.

        q (..., n) -> (..., 4, 4), equal to fk(q).
        Source: Modern Robotics, (4.16); Chapter 4 review.

        >>> np.allclose(kl.robots.rppr().fk_body([1, 2, 3, 4]), kl.robots.rppr().fk([1, 2, 3, 4]), atol=1e-13)
        True
        """
        motions = exponentials(self.body_screws, self.in_order(q))  # e^[B1]q1, ..., e^[Bn]qn
        return reduce(compose, [self.home, *motions])

    def fk_mid(self, q: JointValues, k: int) -> Array:
        """Compute the pose of the tool with M after the first k joints: e^[S1]q1 ... e^[Sk]qk M e^[Bk+1]qk+1 ... e^[Bn]qn.

        q (..., n) -> (..., 4, 4), equal to fk(q) for every k from 0, the body form, to n, the space form.

        Raises ValueError for a k outside 0 ... n.
        Source: Chapter 4 review, "PoE with a Mid-Formula Matrix".

        >>> np.allclose(kl.robots.youbot().fk_mid([1, 2, 3, 4, 5], 2), kl.robots.youbot().fk([1, 2, 3, 4, 5]), atol=1e-13)
        True
        """
        q = self.in_order(q)
        if k not in range(self.n + 1):
            raise ValueError(f"k must be a whole number from 0 to {self.n}, of joints to the left of M; got {k!r}.")
        before = exponentials(self.screws[:k], q[..., :k])  # e^[S1]q1, ..., e^[Sk]qk
        after = exponentials(self.body_screws[k:], q[..., k:])  # e^[Bk+1]qk+1, ..., e^[Bn]qn
        return reduce(compose, [*before, self.home, *after])

    def link_poses(self, q: JointValues) -> Array:
        """Compute the pose of every link: frame i is attached to link i; at q = 0 it is at joint i and parallel to {s}.

        q (..., n) -> (..., n, 4, 4):  T_i(q) = e^[S1]q1 ... e^[Si]qi M_i, with M_i the translation to joint_points[i].

        These are not the link frames of a URDF file, which may be rotated; those are `Tree.poses`.
        Source: Modern Robotics, 4.1.2 (the links of figure 4.2), with frames of our choice.

        >>> kl.robots.youbot().link_poses(np.zeros(5))[3, :3, 3]       # joint 4 of the youBot at home
        array([0.323, 0.   , 0.147])
        """
        motions = exponentials(self.screws, self.in_order(q))
        at_joints = homogeneous(np.eye(3), self.joint_points)  # M_1, ..., M_n
        products = accumulate(motions, compose)  # e^[S1]q1 ... e^[Si]qi
        return np.stack([compose(T, M) for T, M in zip(products, at_joints, strict=True)], axis=-3)

    def jacobian(self, q: JointValues) -> Array:
        """Compute the space Jacobian: column i is the twist of the tool, in {s}, at unit speed of joint i.

        q (..., n) -> (..., 6, n). Column i is the screw axis of joint i, moved by the joints before it:
        J_i = Ad(e^[S1]q1 ... e^[Si-1]qi-1) S_i. Its v is the velocity of the point that is at the origin of {s}; the origin of the
        tool has the velocity fk(q)[..., :3, :3] @ body_jacobian(q)[..., 3:, :] @ qdot, in {s}.
        Source: Modern Robotics, (5.11).

        >>> bool((kl.robots.rpr().jacobian([0, 0, 0]) == kl.robots.rpr().screws.T).all())      # at home no axis has moved yet
        True
        """
        motions = exponentials(self.screws, self.in_order(q))
        identity = np.broadcast_to(np.eye(4), motions[0].shape)
        before = accumulate(motions[:-1], compose, initial=identity)  # e^[S1]q1 ... e^[Si-1]qi-1
        columns = [moved_screw(T, S) for T, S in zip(before, self.screws, strict=True)]
        return np.stack(columns, axis=-1)

    def body_jacobian(self, q: JointValues) -> Array:
        """Compute the body Jacobian, the same twists in {b}: J_b = Ad(T^-1) J_s.

        q (..., n) -> (..., 6, n). Column i is the screw axis of joint i in {b}, moved back by the joints after it:
        J_bi = Ad(e^-[Bn]qn ... e^-[Bi+1]qi+1) B_i.
        Source: Modern Robotics, (5.18) and (5.22).

        >>> np.allclose(kl.robots.rpr().body_jacobian([0, 0, 0]), kl.robots.rpr().body_screws.T)
        True
        """
        motions = exponentials(self.body_screws, -self.in_order(q))[::-1]  # e^-[Bn]qn, ..., e^-[B1]q1
        identity = np.broadcast_to(np.eye(4), motions[0].shape)
        after = accumulate(motions[:-1], compose, initial=identity)  # e^-[Bn]qn ... e^-[Bi+1]qi+1
        columns = [moved_screw(T, B) for T, B in zip(after, self.body_screws[::-1], strict=True)]
        return np.stack(columns[::-1], axis=-1)


def random_configurations(n: int, count: int) -> Array:
    """Draw configurations for comparing two descriptions of an arm, the same ones every time.

    n joints -> (count, n): each value between -pi and pi, in radians or metres.

    >>> random_configurations(2, 3).shape
    (3, 2)
    """
    return np.random.default_rng(0).uniform(-np.pi, np.pi, (count, n))


def largest_difference(poses: Array, others: Array) -> float:
    """Compute the largest difference between corresponding entries of two arrays of poses (..., 4, 4).

    >>> largest_difference(np.eye(4), kl.exp([0, 0, 0, 0.5, 0, -2]))
    2.0
    """
    return float(np.abs(poses - others).max())


def _validate_points(screws: Array, points: ArrayLike) -> Array:
    points = validation.vectors(points, "points", 3)
    if points.shape != (len(screws), 3):
        raise ValueError(f"points must have one row per joint, shape ({len(screws)}, 3); got {points.shape}.")
    axis, foot, _ = line(screws)
    distance = np.linalg.norm(np.cross(points - foot, axis), axis=-1)
    distance[is_prismatic(screws)] = 0.0
    worst = int(np.argmax(distance))
    if distance[worst] > tolerances.UNIT_LENGTH_TOL * (1 + np.abs(points).max()):
        raise ValueError(
            f"The point of joint {worst + 1} must lie on its axis; it is {distance[worst]:.3g} m away. "
            "Is it the point of another joint, or did you write v = w x q instead of v = -w x q?"
        )
    return points
