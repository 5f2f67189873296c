"""Closed chains: bodies and joints in loops, where no joint moves without the others.

Cut a loop open at one joint and it is an open chain. What closes it is one sentence: its tool must come back to where the
chain began. So a loop is written as a `Chain`, and its equation as fk(q) = I:

    e^[S1]q1 ... e^[Sk]qk  =  e^[S1']q1' ... e^[Sm']qm'           two branches that meet
    e^[S1]q1 ... e^[Sk]qk  e^[-Sm']qm' ... e^[-S1']q1'  =  I      the same, walked all the way round

Six equations for each loop, in as many unknowns as its joints have freedoms: the "mess of nonlinear, trigonometric
equations" of the UIUC deck. The Jacobian of the left side is the one that open chains have had all along.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.mechanisms.closure import Assembly, Closure
from kinlib.mechanisms.continuation import Curve
from kinlib.mechanisms.joints import Joint, Passage, Walk, as_chain, cycles, in_series, walks
from kinlib.mechanisms.levenberg_marquardt import ROUGH, null_space
from kinlib.mechanisms.mobility import Mobility, finite_freedoms, group_dimension
from kinlib.rigid.lie import inverse, log
from kinlib.rigid.screw import line
from kinlib.rigid.se3_jacobians import log_jacobian

CLOSED = 1e-13
"""A linkage is closed where the logarithms of its closure poses, each read about the middle of its loop, are shorter than
this, all together; with d metres from the origin to its farthest joint, than 1 + d times this: so much more is rounded off."""


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A linkage: bodies joined so that there is at least one loop.

    joints        in the order of their values in q; the drawing from which they are read has q = 0
    ground        the body that stands still; by default the first body of the first joint
    name, source  what it is called, and which document it comes from

    Raises ValueError for joints that leave a body unattached, for two of one name, and where there is no loop.
    Source: Modern Robotics, chapters 2 and 7; the UIUC deck's (3.81).

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> linkage = four_bar(ground=0.4, crank=0.1, coupler=0.35, rocker=0.3)
    >>> posture = linkage.assemble([0, 0.5, 1, 0.5], hold={"A": np.pi / 2})
    >>> posture.converged, linkage.mobility(posture.q).finite
    (True, 1)
    """

    joints: Sequence[Joint]
    ground: str = ""
    name: str = "linkage"
    source: str = ""

    def __post_init__(self) -> None:
        if not self.joints:
            raise ValueError("A mechanism has at least one joint; got none.")
        object.__setattr__(self, "joints", tuple(self.joints))
        object.__setattr__(self, "ground", self.ground or self.joints[0].bodies[0])
        names = [joint.name for joint in self.joints]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"Every joint has a name of its own; {', '.join(twice)} came more than once.")
        bodies = {body for joint in self.joints for body in joint.bodies}
        if self.ground not in bodies:
            raise ValueError(
                f"The ground should be one of the bodies {', '.join(sorted(bodies))}; got {self.ground!r}."
            )
        if lost := sorted(bodies - set(self._walks)):
            raise ValueError(f"No joints lead from {self.ground} to {', '.join(lost)}. Is a joint missing?")
        if not self.loops:
            raise ValueError(
                f"{self.name} has no loop: its {len(names)} joints form a tree. Use kl.Chain for an open chain."
            )

    @classmethod
    def from_chain(cls, chain: Chain) -> Self:
        """Bend an open chain round until its tool meets its base: the loop e^[S1]q1 ... e^[Sn]qn M = I.

        Raises ValueError for a chain of one joint, which has no body to move.

        >>> from kinlib.chains.robots import puma560
        >>> Mechanism.from_chain(puma560()).kutzbach()
        0
        """
        bodies = ["ground", *(f"link {i}" for i in range(1, chain.n)), "ground"]
        joints = in_series(chain, bodies, [f"joint {i}" for i in range(1, chain.n + 1)], chain.home)
        return cls(joints, "ground", chain.name, chain.source)

    @classmethod
    def from_branches(cls, *branches: Chain, name: str = "linkage", source: str = "") -> Self:
        """Join open chains from one ground by their tools: T_1(q_1) = T_2(q_2) = ..., the form of (3.81).

        The values of q are those of the first branch, then those of the second, and so on.

        Raises ValueError for fewer than two branches.
        Source: the UIUC deck's (3.81), from LaValle, Planning Algorithms, section 3.4.

        >>> from kinlib.chains.robots import rpr
        >>> Mechanism.from_branches(rpr(), rpr()).n
        6
        """
        if len(branches) < 2:
            raise ValueError(f"Branches meet, so there are at least two; got {len(branches)}.")
        joints = []
        for b, branch in enumerate(branches, start=1):
            bodies = ["ground", *(f"link {b}.{i}" for i in range(1, branch.n)), "end"]
            # The last body of every branch is that of the first, drawn where this branch's home would have it.
            gap = branch.home @ inverse(branches[0].home)
            joints += in_series(branch, bodies, [f"joint {b}.{i}" for i in range(1, branch.n + 1)], gap)
        return cls(joints, "ground", name, source)

    @property
    def n(self) -> int:
        """The number of joint values: the freedoms of all joints together."""
        return sum(joint.freedoms for joint in self.joints)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What each joint value is called: as its joint, or name.1, name.2, ... for a joint of several freedoms."""
        return tuple(
            joint.name if joint.freedoms == 1 else f"{joint.name}.{k + 1}"
            for joint in self.joints
            for k in range(joint.freedoms)
        )

    @property
    def bodies(self) -> tuple[str, ...]:
        """Every body, the ground first, then as the joints lead away from it."""
        return tuple(self._walks)

    @cached_property
    def loops(self) -> tuple[Walk, ...]:
        """The independent loops, each as the open chain that must come back: chain.fk(q[..., columns]) = I."""
        rounds = cycles(self.joints, self._walks)
        return tuple(as_chain(self.joints, walk, f"loop {i}") for i, walk in enumerate(rounds, start=1))

    def residual(self, q: ArrayLike) -> Array:
        """What is left over in each loop: the logarithm of its closure pose, 0 where it closes.

        q (..., n) -> (..., 6 l) for l loops, one twist (omega, v) after the other.

        Raises ValueError for joint values of another size, and for NaN.

        >>> from kinlib.mechanisms.linkages import bennett
        >>> linkage = bennett()
        >>> bool(np.linalg.norm(linkage.residual(linkage.assemble([1, 2, 1, 2]).q)) < 1e-12)
        True
        """
        q = self._values(q)
        return np.concatenate([log(loop.chain.fk(q[..., loop.columns])) for loop in self.loops], axis=-1)

    def jacobian(self, q: ArrayLike) -> Array:
        """How the residual changes with each joint value: for each loop, log_jacobian(r) J_s, J_s that of its chain.

        q (..., n) -> (..., 6 l, n). Where a loop is closed, r = 0, and its part is the space Jacobian itself.

        Raises ValueError for joint values of another size, and for NaN.

        >>> from kinlib.mechanisms.linkages import bennett
        >>> bennett().jacobian([1, 2, 1, 2]).shape
        (6, 4)
        """
        q = self._values(q)
        return self._linearized(q.reshape(-1, self.n))[1].reshape(*q.shape[:-1], -1, self.n)

    def poses(self, q: ArrayLike) -> dict[str, Array]:
        """How far every body has moved from where it is drawn, (..., 4, 4) each: along the shortest walk to it.

        Raises ValueError for joint values of another size, and for NaN.

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> four_bar(4, 1, 3.5, 3).poses([np.pi, 0, 0, 0])["crank"][:2, :2].round(6) + 0.0
        array([[-1.,  0.],
               [ 0., -1.]])
        """
        q = self._values(q)
        still = np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))
        return {self.ground: still} | {body: walk.chain.fk(q[..., walk.columns]) for body, walk in self._ways.items()}

    def assemble(self, guess: ArrayLike, hold: Mapping[str, float] | None = None) -> Assembly:
        """Close the linkage near a guess (n,), some joint values held where they should be.

        It never comes back without a word: where no posture near the guess closes, it says so, and how large a gap is left.

        Raises ValueError for a guess of another size, for NaN, and for a held value that no joint has.

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> four_bar(4, 1, 1, 1).assemble([0.5, 0.5, 2, 0]).converged        # the three short links do not reach
        False
        """
        return self._closure(guess, hold).assemble()

    def assembly_modes(self, hold: Mapping[str, float] | None = None) -> Array:
        """Find every way of assembling the linkage with some joint values held: postures (m, n), each once.

        A search from random guesses, the same ones at every call, until it brings nothing new: it may miss a mode that
        few guesses lead to. Two postures are one mode if all bodies stand alike.

        Raises ValueError where what is held leaves the linkage free to move: then the modes are curves.

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> len(four_bar(4, 1, 3.5, 3).assembly_modes(hold={"A": 1.0}))
        2
        """
        return self._closure(np.zeros(self.n), hold).modes(lambda q: np.stack(list(self.poses(q).values()), axis=1))

    def trace(
        self,
        start: ArrayLike,
        hold: Mapping[str, float] | None = None,
        step: float = 0.2,
        points: int | None = None,
        most: int = 5000,
    ) -> Curve:
        """Follow the motion from a posture (n,) both ways, through dead points, until it comes round or meets a limit.

        step    the longest step along the curve, radians and metres together
        points  how many postures come back, at about equal steps; None: as many as were needed
        most    after so many steps either way the curve is left unfinished, and says so

        Raises ValueError for a start that does not close, where the linkage has not exactly one freedom there, and for a
        step or a number of points that makes no curve.
        Source: pseudo-arclength continuation, as in Allgower and Georg, Numerical Continuation Methods (1990).

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> linkage = four_bar(0.4, 0.1, 0.35, 0.3)
        >>> curve = linkage.trace(linkage.assembly_modes(hold={"A": 1.0})[0])
        >>> curve.closed, curve.residual < 1e-12
        (True, True)
        """
        if not (np.isfinite(step) and step > 0):
            raise ValueError(f"step should be a length along the curve, above 0; got {step!r}.")
        if most < 1 or (points is not None and points < 2):
            raise ValueError(f"A curve has two points at least, and one step; got points={points!r}, most={most!r}.")
        return self._closure(start, hold).trace(step, points, most)

    def mobility(self, q: ArrayLike) -> Mobility:
        """Say how many freedoms the linkage has in a posture (n,): counted, felt there, and had.

        Raises ValueError for a posture that does not close.

        >>> from kinlib.mechanisms.linkages import bennett
        >>> linkage = bennett()
        >>> mobility = linkage.mobility(linkage.assemble([1, 2, 1, 2]).q)
        >>> mobility.kutzbach, mobility.finite
        (-2, 1)
        """
        closure = self._closure(q, None)
        r, J = closure.equations(closure.posture[None])
        if (left := np.linalg.norm(r)) > ROUGH * closure.closed:
            raise ValueError(
                f"This posture does not close: {left:.2g} is left over. Assemble it first, and pass on its q."
            )
        directions, singular_values = null_space(J[0])
        finite = finite_freedoms(closure.equations, closure.posture, directions, closure.closed)
        return Mobility(self.kutzbach(), directions.shape[1], finite, singular_values, directions)

    def kutzbach(self, dimension: int | None = None) -> int:
        """Count the freedoms: those of all joints, less d for each loop, if all equations are independent.

        d = `dimension`, the same for all loops: 6 in space, 3 in a plane or about a point. By default each loop is given
        the dimension of the group that its joints generate. With N bodies, J joints and f_i freedoms there are
        J - N + 1 loops, and d(N - 1 - J) + sum f_i is the same number.

        Source: Modern Robotics, (2.4), Gruebler's formula.

        >>> from kinlib.mechanisms.linkages import bennett, four_bar
        >>> four_bar(4, 1, 3.5, 3).kutzbach(), bennett().kutzbach()
        (1, -2)
        """
        return self.n - sum(dimension or group_dimension(loop.chain.screws @ loop.to_middle.T) for loop in self.loops)

    def joint_points(self, q: ArrayLike) -> Array:
        """Where every joint is, (..., j, 3), as its first body carries it.

        Raises ValueError for joint values of another size, and for NaN.

        >>> from kinlib.mechanisms.linkages import four_bar
        >>> four_bar(4, 1, 3.5, 3).joint_points([np.pi / 2, 0, 0, 0])[1].round(6) + 0.0      # B, at the end of the crank
        array([0., 1., 0.])
        """
        poses = self.poses(q)
        points = [(poses[joint.bodies[0]] @ np.append(joint.place, 1.0))[..., :3] for joint in self.joints]
        return np.stack(points, axis=-2)

    @cached_property
    def limits(self) -> Array:
        """The least and the greatest of every joint value, (n, 2), infinite where there is none."""
        return validation.frozen(np.concatenate([joint.range for joint in self.joints]))

    @cached_property
    def _walks(self) -> dict[str, list[Passage]]:
        return walks(self.joints, self.ground)

    @cached_property
    def _ways(self) -> dict[str, Walk]:
        """The walk from the ground to every body that moves, as an open chain."""
        return {body: as_chain(self.joints, walk, body) for body, walk in self._walks.items() if walk}

    def _values(self, q: ArrayLike) -> Array:
        q = validation.array(q, "q")
        if q.shape[-1:] != (self.n,):
            raise ValueError(
                f"{self.name} has {self.n} joint values ({', '.join(self.names)}), so q should have shape (..., {self.n}); "
                f"got {q.shape}."
            )
        return q

    def _linearized(self, q: Array) -> tuple[Array, Array]:
        """The residual (m, 6 l) and its Jacobian (m, 6 l, n) for m postures (m, n)."""
        r = np.empty((len(q), 6 * len(self.loops)))
        J = np.zeros((*r.shape, self.n))
        for i, loop in enumerate(self.loops):
            rows, angles = slice(6 * i, 6 * i + 6), q[:, loop.columns]
            r[:, rows] = log(loop.chain.fk(angles))
            J[:, rows, loop.columns] = log_jacobian(r[:, rows]) @ loop.chain.jacobian(angles)
        return r, J

    def _about_the_middle(self, q: Array) -> tuple[Array, Array]:
        """The same, with every loop read about the point in its middle: as good near the origin as a mile away."""
        r, J = self._linearized(q)
        for i, loop in enumerate(self.loops):
            rows = slice(6 * i, 6 * i + 6)
            r[:, rows] = r[:, rows] @ loop.to_middle.T
            J[:, rows] = loop.to_middle @ J[:, rows]
        return r, J

    def _closure(self, posture: ArrayLike, hold: Mapping[str, float] | None) -> Closure:
        """The closure equations from a posture, without the joint values that are held."""
        posture = self._values(posture).copy()
        if posture.ndim != 1:
            raise ValueError(f"One posture, please, of shape ({self.n},); got {posture.shape}.")
        for name, value in (hold or {}).items():
            if name not in self.names:
                raise ValueError(f"{self.name} has no joint value {name!r} to hold; it has {', '.join(self.names)}.")
            if np.ndim(value):
                raise ValueError(f"{name} is held at one value; got {validation.brief(value)}.")
            posture[self.names.index(name)] = validation.array(value, name)
        free = np.array([i for i, name in enumerate(self.names) if name not in (hold or {})], dtype=np.intp)
        if not len(free):
            raise ValueError("Every joint value is held, and nothing is left to be found.")
        pitch = np.abs(np.concatenate([line(joint.screws).pitch for joint in self.joints]))
        turns = pitch <= validation.UNIT
        size = max(loop.size for loop in self.loops)
        farthest = max(float(np.linalg.norm(loop.middle)) for loop in self.loops) + size
        # A slide may have to go twice as far as the linkage is long, and a thread as many turns as this takes.
        reach = np.where(turns, np.pi, 2 * size / np.clip(pitch, validation.UNIT, 1))
        closed = CLOSED * (1 + farthest)
        return Closure(self._about_the_middle, posture, free, self.names, turns, self.limits, reach, closed)
