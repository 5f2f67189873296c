"""Open chains: n screw axes and a home pose say everything about where the tool goes.

The same motion is written in three forms, which differ in where the home pose M stands:

    space form   T(q) = e^[S1]q1 ... e^[Sn]qn M
    body form    T(q) = M e^[B1]q1 ... e^[Bn]qn,        B_i = Ad(M^-1) S_i
    mid form     T(q) = e^[S1]q1 ... e^[Sk]qk M e^[Bk+1]qk+1 ... e^[Bn]qn
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib import check
from kinlib.check import Array
from kinlib.lie import adjoint, exp, inverse
from kinlib.screw import Line, axes, is_prismatic, line
from kinlib.straight_line import StraightLine, write_out
from kinlib.sweep import cross, sweep


@dataclass(frozen=True, eq=False)
class Chain:
    """An open chain of revolute, prismatic and helical joints.

    screws   (n, 6)  screw axes S_1 ... S_n in the fixed frame {s}, read at home
    home     (4, 4)  M = T_sb at q = 0
    points   (n, 3)  where on its axis each joint is drawn, at home; `joint_points` fills in what is not given
    name, source     what it is called, and which document it comes from
    limits   (n, 2)  the least and the greatest value of each joint, infinite where it has none; None: no joint has any
    joint_names      what its document calls each joint, n words, or none at all

    Raises ValueError for anything that is not a chain: no joints, screws in columns, axes that are not of unit size, a
    home that is not rigid, a point off its axis, a lower limit above the upper one.
    Source: Modern Robotics, 4.1; Chapter 4 review deck.

    >>> from kinlib.screw import screw
    >>> arm = Chain(np.array([screw((0, 0, 1)), screw((0, 0, 1), point=(1, 0, 0))]), home=exp([0, 0, 0, 2, 0, 0]))
    >>> arm.fk([np.pi / 2, 0])[:3, 3].round(6) + 0.0      # an outstretched arm of two metres, turned left
    array([0., 2., 0.])
    """

    screws: Array = field(repr=False)
    home: Array = field(repr=False)
    points: Array | None = field(default=None, repr=False)
    name: str = "arm"
    source: str = ""
    limits: Array | None = field(default=None, repr=False)
    joint_names: tuple[str, ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        screws = check.array(self.screws, "screws")
        if screws.ndim != 2 or len(screws) == 0:
            raise ValueError(f"screws should have shape (n, 6), one row a joint; got {screws.shape}.")
        home = check.poses(self.home, "home")
        if home.ndim != 2:
            raise ValueError(f"home should be one pose, (4, 4); got {home.shape}. A chain has one home.")
        self._keep("screws", axes(screws, "screws"))
        self._keep("home", home)
        if self.points is not None:
            self._keep("points", _points_on(self.screws, self.points))
        if self.limits is not None:
            self._keep("limits", _limits(self.limits, len(screws)))
        if self.joint_names and len(self.joint_names) != len(screws):
            raise ValueError(f"joint_names should hold {len(screws)} names, one a joint; got {len(self.joint_names)}.")

    def _keep(self, name: str, values: Array) -> None:
        object.__setattr__(self, name, check.frozen(values))

    @property
    def n(self) -> int:
        """The number of joints."""
        return len(self.screws)

    @cached_property
    def lines(self) -> Line:
        """The joint axes as geometry: directions (n, 3), the points nearest the origin (n, 3), pitches (n,).

        >>> from kinlib.robots import rpr
        >>> rpr().lines.pitch
        array([ 0., inf,  0.])
        """
        return line(self.screws)

    @cached_property
    def letters(self) -> str:
        """The joints from base to tool, one letter each: R revolute, P prismatic, H helical.

        >>> from kinlib.robots import rpr
        >>> rpr().letters
        'RPR'
        """
        pitch = self.lines.pitch
        return "".join("P" if h == np.inf else "H" if abs(h) > check.UNIT else "R" for h in pitch)

    @cached_property
    def joint_points(self) -> Array:
        """A point (n, 3) on every joint axis at home: as given, or else the one nearest the joint before it."""
        if self.points is not None:
            return self.points
        chosen = [np.zeros(3)]
        for axis, foot, pitch in zip(*self.lines, strict=True):
            # A prismatic axis is a free vector: any point serves, so the joint stays where the last one was.
            chosen.append(chosen[-1] if pitch == np.inf else foot + axis * (axis @ chosen[-1]))
        return check.frozen(chosen[1:])

    @cached_property
    def body_screws(self) -> Array:
        """The same axes read in the tool frame {b} at home, (n, 6):  B_i = Ad(M^-1) S_i.

        Source: Modern Robotics, 4.1.3; Chapter 4 review deck, the last line of its derivation.

        >>> from kinlib.robots import rppr
        >>> rppr().body_screws[0].round(6) + 0.0          # B_1 as the UIUC deck prints it
        array([ 0.,  1.,  0.,  0.,  0., -2.])
        """
        return check.frozen(self.screws @ adjoint(inverse(self.home)).T)

    def fk(self, q: ArrayLike) -> Array:
        """Where the tool is: T(q) = e^[S1]q1 ... e^[Sn]qn M, the space form.

        q (..., n) in radians and metres -> T_sb (..., 4, 4). Any number of configurations is one computation.

        Raises ValueError for joint values of another size, and for NaN.
        Source: Modern Robotics, (4.14).

        >>> from kinlib.robots import rprr
        >>> rprr().fk(np.zeros((1000, 4))).shape
        (1000, 4, 4)
        """
        if self._is_one_configuration(q):
            return np.array(self._tool_program.run(*q.ravel().tolist())).reshape(*q.shape[:-1], 4, 4)
        return sweep(self._tool, self._joint_values(q), (self.n,), (4, 4))

    def fk_body(self, q: ArrayLike) -> Array:
        """Where the tool is, by the body form: T(q) = M e^[B1]q1 ... e^[Bn]qn.

        q (..., n) -> (..., 4, 4), equal to fk(q).

        Raises ValueError for joint values of another size, and for NaN.
        Source: Modern Robotics, (4.16); Chapter 4 review deck.

        >>> from kinlib.robots import rppr
        >>> np.allclose(rppr().fk_body([1, 2, 3, 4]), rppr().fk([1, 2, 3, 4]), atol=1e-13)
        True
        """
        return self.fk_mid(q, 0)

    def fk_mid(self, q: ArrayLike, k: int) -> Array:
        """Where the tool is, with M after the first k joints: e^[S1]q1 ... e^[Sk]qk M e^[Bk+1]qk+1 ... e^[Bn]qn.

        q (..., n) -> (..., 4, 4), equal to fk(q) for every k from 0, the body form, to n, the space form.

        Raises ValueError for joint values of another size, for NaN, and for a k outside 0 ... n.
        Source: Chapter 4 review deck, "PoE with a Mid-Formula Matrix".

        >>> from kinlib.robots import youbot
        >>> np.allclose(youbot().fk_mid([1, 2, 3, 4, 5], 2), youbot().fk([1, 2, 3, 4, 5]), atol=1e-13)
        True
        """
        q = self._joint_values(q)
        if k not in range(self.n + 1):
            raise ValueError(f"k counts the joints to the left of M, 0 to {self.n}; got {k!r}.")
        before = exp(self.screws[:k] * q[..., :k, None])
        after = exp(self.body_screws[k:] * q[..., k:, None])
        factors = [*np.moveaxis(before, -3, 0), self.home, *np.moveaxis(after, -3, 0)]
        return reduce(np.matmul, factors)

    def link_poses(self, q: ArrayLike) -> Array:
        """Where every link is: frame i rides on link i, and stands at joint i parallel to {s} when q = 0.

        q (..., n) -> (..., n, 4, 4):  T_i(q) = e^[S1]q1 ... e^[Si]qi M_i, with M_i the shift to joint_points[i].

        Raises ValueError for joint values of another size, and for NaN.
        Source: Modern Robotics, 4.1.2 (the links of figure 4.2), with frames of our choice.

        >>> from kinlib.robots import youbot
        >>> youbot().link_poses(np.zeros(5))[3, :3, 3]       # joint 4 of the youBot at home
        array([0.323, 0.   , 0.147])
        """
        return sweep(self._links, self._joint_values(q), (self.n,), (self.n, 4, 4))

    def jacobian(self, q: ArrayLike) -> Array:
        """How the tool moves for each joint's unit of speed, as twists in {s}: the space Jacobian.

        q (..., n) -> (..., 6, n). Column i is joint i's screw axis where the joints before it have carried it:
        J_i = Ad(e^[S1]q1 ... e^[Si-1]qi-1) S_i.

        Raises ValueError for joint values of another size, and for NaN.
        Source: Modern Robotics, (5.11).

        >>> from kinlib.robots import rpr
        >>> bool((rpr().jacobian([0, 0, 0]) == rpr().screws.T).all())      # at home nothing has been carried yet
        True
        """
        if self._is_one_configuration(q):
            return np.array(self._jacobian_program.run(*q.ravel().tolist())).reshape(*q.shape[:-1], 6, self.n)
        return sweep(self._carried_screws, self._joint_values(q), (self.n,), (6, self.n))

    def body_jacobian(self, q: ArrayLike) -> Array:
        """The same as twists in {b}: the body Jacobian, J_b = Ad(T^-1) J_s.

        q (..., n) -> (..., 6, n).

        Raises ValueError for joint values of another size, and for NaN.
        Source: Modern Robotics, (5.22).

        >>> from kinlib.robots import rpr
        >>> np.allclose(rpr().body_jacobian([0, 0, 0]), rpr().body_screws.T)
        True
        """
        return adjoint(inverse(self.fk(q))) @ self.jacobian(q)

    def _joint_values(self, q: ArrayLike) -> Array:
        q = check.array(q, "q")
        if q.shape[-1:] != (self.n,):
            fits = q.ndim > 1 and q.shape[-2] == self.n
            cause = "Joints stand in the last dimension: try q.T" if fits else "Each joint has a value of its own"
            raise ValueError(
                f"{self.name} has {self.n} joints ({self.letters}), so q should have shape (..., {self.n}); "
                f"got {q.shape}. {cause}."
            )
        check.turn(np.abs(q * self._turns_and_slides[0]))
        return q

    @cached_property
    def _turns_and_slides(self) -> tuple[Array, Array]:
        """What one unit of each joint does: radians about its own z, and metres along it."""
        prismatic = is_prismatic(self.screws)
        return np.where(prismatic, 0.0, 1.0), np.where(prismatic, 1.0, self.lines.pitch)

    @cached_property
    def _joint_frames(self) -> Array:
        """A frame J_i on each joint at home, (n, 4, 4), with its z along the axis."""
        J = np.zeros((self.n, 4, 4))
        J[:, :3, 2] = self.lines.axis
        # Any x square to z will do; crossing z with the coordinate axis farthest from it loses no digits.
        farthest = np.eye(3)[np.argmin(np.abs(J[:, :3, 2]), axis=-1)]
        J[:, :3, 0] = np.cross(farthest, J[:, :3, 2])
        J[:, :3, 0] /= np.linalg.norm(J[:, :3, 0], axis=-1, keepdims=True)
        J[:, :3, 1] = np.cross(J[:, :3, 2], J[:, :3, 0])
        J[:, :3, 3] = self.joint_points
        J[:, 3, 3] = 1.0
        return J

    @cached_property
    def _steps(self) -> Array:
        """The constant steps J_1, J_1^-1 J_2, ..., J_n^-1 M from one joint frame to the next, (n + 1, 4, 4)."""
        stations = np.concatenate([np.eye(4)[None], self._joint_frames, self.home[None]])
        steps: Array = inverse(stations[:-1]) @ stations[1:]
        return steps

    def _is_one_configuration(self, q: ArrayLike) -> TypeGuard[Array]:
        """Whether q is a single configuration, and needs no further check. Any other q takes the way of the batches."""
        return (
            isinstance(q, np.ndarray)
            and q.size == self.n
            and q.shape[-1:] == (self.n,)
            and q.dtype.kind in "iuf"
            # The sum is NaN or infinite if any of the values is, and then this is false.
            and sum(map(abs, q.ravel().tolist())) <= check.TURN
        )

    @cached_property
    def _tool_program(self) -> StraightLine:
        return write_out(lambda q: self._tool(q[:, None])[..., 0].T, self.n)

    @cached_property
    def _jacobian_program(self) -> StraightLine:
        return write_out(lambda q: self._carried_screws(q[:, None])[..., 0].T, self.n)

    # What follows is written for `sweep`, which lays m configurations out as (n, m), and for `write_out`, which gives the
    # names of one. A frame is its columns x, y, z, p, shape (4, 3, m).

    def _tool(self, q: NDArray[Any]) -> NDArray[Any]:
        """The tool's poses by their columns, (4, 4, m)."""
        *_, tool = self._walk(q)
        return _closed(tool)

    def _links(self, q: Array) -> Array:
        """The link frames by their columns, (4, 4, n, m)."""
        frames = zip(self._walk(q), self._joint_frames, strict=False)
        return np.stack([_closed(_moved(frame, inverse(_turned(J)))) for frame, J in frames], axis=2)

    def _carried_screws(self, q: NDArray[Any]) -> NDArray[Any]:
        """The columns of the space Jacobian, (n, 6, m)."""
        J = np.zeros((self.n, 6, q.shape[1]), dtype=q.dtype)
        for twist, turn, slide, (_, _, z, p) in zip(J, *self._turns_and_slides, self._walk(q), strict=False):
            if turn:
                twist[:3], twist[3:] = z, cross(p, z)
            if slide:
                twist[3:] += slide * z
        return J

    def _walk(self, q: NDArray[Any]) -> Iterator[NDArray[Any]]:
        """Carry a frame along the arm: yield each joint's frame, then the tool's.

        In its own frame J a joint turns about z, and e^[S]q = J Z(q) J^-1. The constants between two joints merge:
        T(q) = J_1 Z(q_1) (J_1^-1 J_2) Z(q_2) ... Z(q_n) (J_n^-1 M). That is the space form, with one product a joint
        where it has two.
        """
        cos, sin, slide = self._joint_motions(q)
        slides = self._turns_and_slides[1] != 0
        frame = np.array(np.broadcast_to(self._steps[0, :3].T[..., None], (4, 3, q.shape[1])), dtype=q.dtype)
        for i in range(self.n):
            x, y, z, p = frame
            frame[0], frame[1] = cos[i] * x + sin[i] * y, cos[i] * y - sin[i] * x
            if slides[i]:
                p += slide[i] * z
            yield frame
            frame = _moved(frame, self._steps[i + 1])
        yield frame

    def _joint_motions(self, q: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """The cosine and the sine of every joint's turn, and its slide, (n, m) each."""
        turns, slides = (unit[:, None] for unit in self._turns_and_slides)
        if q.dtype == object:  # names, which know a cosine and a sine, and no other function
            cos, sin, turning = np.ones_like(q), np.zeros_like(q), turns[:, 0] != 0
            cos[turning], sin[turning] = np.cos(q[turning]), np.sin(q[turning])
            return cos, sin, slides * q
        # One tangent of the half angle gives both cosine and sine, to the last digit, in half the time of the two.
        t = np.tan(turns * q / 2)
        share = 1 / (1 + t * t)
        return (1 - t * t) * share, 2 * t * share, slides * q


def _moved(frame: NDArray[Any], step: Array) -> NDArray[Any]:
    """Multiply frames (4, 3, m) by one pose from the right: the new columns are sums of the old ones."""
    columns: NDArray[Any] = step.T @ frame.reshape(4, -1)
    return columns.reshape(frame.shape)


def _turned(T: Array) -> Array:
    """The rotation of a pose, as a pose that stays where it is."""
    R = T.copy()
    R[..., :3, 3] = 0.0
    return R


def _closed(frame: NDArray[Any]) -> NDArray[Any]:
    """Frames (4, 3, m) with the last row of their poses, (4, 4, m)."""
    X = np.zeros((4, 4, frame.shape[-1]), dtype=frame.dtype)
    X[:, :3] = frame
    X[3, 3] = 1.0
    return X


def _limits(limits: ArrayLike, n: int) -> Array:
    limits = check.real(limits, "limits")
    if limits.shape != (n, 2):
        raise ValueError(f"limits should have one row (least, greatest) a joint, ({n}, 2); got {limits.shape}.")
    # Written so that NaN, which is neither above nor below, is refused too.
    ordered = limits[:, 0] <= limits[:, 1]
    if not ordered.all():
        joint = int(np.argmin(ordered))
        raise ValueError(
            f"The limits of joint {joint + 1} should be (least, greatest); got {limits[joint].tolist()}. Are they exchanged?"
        )
    return limits


def _points_on(screws: Array, points: ArrayLike) -> Array:
    points = check.vectors(points, "points", 3)
    if points.shape != (len(screws), 3):
        raise ValueError(f"points should have one row a joint, ({len(screws)}, 3); got {points.shape}.")
    axis, foot, _ = line(screws)
    off = np.linalg.norm(np.cross(points - foot, axis), axis=-1)
    off[is_prismatic(screws)] = 0.0
    worst = int(np.argmax(off))
    if off[worst] > check.UNIT * (1 + np.abs(points).max()):
        raise ValueError(
            f"The point of joint {worst + 1} lies {off[worst]:.3g} m off its axis. Is it the point of another joint, or is v = w x q?"
        )
    return points
