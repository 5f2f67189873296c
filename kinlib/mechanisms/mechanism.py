"""Closed chains: bodies and joints in loops, where no joint moves without the others.

If a loop is cut open at one joint, it is an open chain. The loop is closed if the end of this chain comes back to its
beginning. So a loop is written as a `Chain`, and its closure equation as fk(q) = I:

    e^[S1]q1 ... e^[Sk]qk  =  e^[S1']q1' ... e^[Sm']qm'           two branches that meet
    e^[S1]q1 ... e^[Sk]qk  e^[-Sm']qm' ... e^[-S1']q1'  =  I      the same equation, once around the loop

These are six nonlinear equations for each loop, in as many unknowns as its joints have degrees of freedom.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays import tolerances, validation
from kinlib.arrays.formatting import aligned_table, format_vector, html_table
from kinlib.arrays.validation import Array, JointValues, TakesJointValues
from kinlib.chains.chain import Chain
from kinlib.mechanisms.continuation import Curve, trace_curve
from kinlib.mechanisms.joints import Joint
from kinlib.mechanisms.levenberg_marquardt import Equations, null_space, solve, validate_solution
from kinlib.mechanisms.mobility import Mobility, finite_mobility, group_dimension, search_modes
from kinlib.mechanisms.paths import JointPath, fundamental_cycles, joints_of_chain, reach, spanning_tree
from kinlib.rigid.lie import inverse, left_jacobian_inverse, log
from kinlib.rigid.screw import line


class Assembly(NamedTuple):
    """The configuration (n,) that an attempt to close a linkage reached, the norm of its residual, and whether it is closed."""

    q: Array
    residual: float
    converged: bool


@dataclass(frozen=True, eq=False)
class Mechanism(TakesJointValues):
    """A linkage: bodies joined so that there is at least one loop.

    joints        in the order of their values in q; q = 0 is the drawing from which they are read
    ground        the body that does not move; by default the first body of the first joint
    name, source  the name of the linkage, and the document that it is taken from

    Wherever a configuration q is an argument, it may also be a mapping from each of `names` to its value. Every method raises
    ValueError if q has another size or contains NaN.

    Raises ValueError for anything but joints, if a body is not connected to the ground, if two joints have the same name, and if
    there is no loop.
    Source: Modern Robotics, chapters 2 and 7; Forward kinematics II, (3.81), from LaValle, Planning Algorithms, section 3.4.

    >>> linkage = kl.linkages.four_bar(ground=0.4, crank=0.1, coupler=0.35, rocker=0.3)
    >>> assembly = linkage.assemble([0, 0.5, 1, 0.5], hold={"A": np.pi / 2})
    >>> assembly.converged, linkage.mobility(assembly.q).finite
    (True, 1)
    """

    joints: Sequence[Joint]
    ground: str = ""
    name: str = "linkage"
    source: str = ""

    def __post_init__(self) -> None:
        for joint in self.joints:
            validation.instance(joint, "each of joints", Joint)
        if not self.joints:
            raise ValueError("A mechanism must have at least one joint; got none. Pass a sequence of kl.Joint.")
        object.__setattr__(self, "joints", tuple(self.joints))
        object.__setattr__(self, "ground", self.ground or self.joints[0].bodies[0])
        names = [joint.name for joint in self.joints]
        if duplicates := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"The names of the joints must be different; got {', '.join(duplicates)} more than once.")
        bodies = {body for joint in self.joints for body in joint.bodies}
        if unconnected := sorted(bodies - {*self.paths}):
            raise ValueError(f"Joints must lead from {self.ground} to every body; not to {', '.join(unconnected)}.")
        if not self.loops:
            raise ValueError(f"A mechanism must have a loop; the joints of {self.name} form a tree. Use kl.Chain.")

    def __repr__(self) -> str:
        return f"Mechanism({self._title})"

    def __str__(self) -> str:
        """Write the joints: their values in q, the bodies that they join, and their screw axes."""
        return f"{self._title}\n{aligned_table(self._joint_table())}"

    def _repr_html_(self) -> str:
        heads, *rows = self._joint_table()
        return html_table(self._title, heads, rows)

    @property
    def _title(self) -> str:
        count = len(self.loops)
        return f"{self.name}, {len(self.joints)} joints, {count} loop{'s'[: count != 1]}, ground: {self.ground}"

    def _joint_table(self) -> list[list[str]]:
        bodies = [" - ".join(joint.bodies) for joint in self.joints for _ in joint.screws]
        columns = zip(self.names, bodies, self.screws, strict=True)
        rows = ([name, joined, format_vector(S[:3]), format_vector(S[3:])] for name, joined, S in columns)
        return [["joint", "bodies", "omega", "v"], *rows]

    @classmethod
    def from_chain(cls, chain: Chain) -> Self:
        """Close an open chain by fixing its end-effector to its base: the loop e^[S1]q1 ... e^[Sn]qn M = I.

        A closed chain has no limits. Raises ValueError for a chain of one joint, because both its bodies would be the ground.

        >>> Mechanism.from_chain(kl.robots.puma560()).kutzbach()
        0
        """
        validation.instance(chain, "chain", Chain)
        return cls(joints_of_chain(chain, "", "ground", chain.home), "ground", chain.name, chain.source)

    @classmethod
    def from_branches(cls, *branches: Chain, name: str = "linkage", source: str = "") -> Self:
        """Join the end-effectors of open chains that begin at one ground: T_1(q_1) = T_2(q_2) = ..., the form of (3.81).

        The values of q are those of the first branch, then those of the second, and so on.

        >>> Mechanism.from_branches(kl.robots.rpr(), kl.robots.rpr()).n
        6
        """
        joints = []
        for b, branch in enumerate(branches, start=1):
            validation.instance(branch, f"branch {b}", Chain)
            # All branches end in one body, which is drawn as in the home configuration of the first branch.
            joints += joints_of_chain(branch, f"{b}.", "end", branch.home @ inverse(branches[0].home))
        return cls(joints, "ground", name, source)

    @property
    def n(self) -> int:
        """The number of joint values: the sum of the degrees of freedom of all joints."""
        return len(self.screws)

    @cached_property
    def screws(self) -> Array:
        """The screw axis (n, 6) of each joint value."""
        return np.concatenate([joint.screws for joint in self.joints])

    @cached_property
    def is_angle(self) -> NDArray[np.bool_]:
        """Which joint values are angles (n,), those of revolute joints, and so the same again after 2 pi."""
        return np.asarray(np.abs(line(self.screws).pitch) <= tolerances.UNIT_LENGTH_TOL)

    @property
    def names(self) -> tuple[str, ...]:
        """The name of each joint value: that of its joint, or name.1, name.2, ... if the joint has several degrees of freedom."""
        numbered = ((joint, f".{k}" if joint.dof > 1 else "") for joint in self.joints for k in range(1, joint.dof + 1))
        return tuple(joint.name + number for joint, number in numbered)

    _value_names = names

    @property
    def bodies(self) -> tuple[str, ...]:
        """Every body, the ground first, then by the number of joints between it and the ground."""
        return tuple(self.paths)

    @cached_property
    def paths(self) -> dict[str, JointPath]:
        """The shortest path over joints from the ground to every body, as an open chain; that to the ground itself is empty."""
        return spanning_tree(self.joints, self.ground)

    @cached_property
    def loops(self) -> tuple[JointPath, ...]:
        """The independent loops, each as the open chain that must come back to its beginning: chain.fk(q[..., columns]) = I."""
        return tuple(fundamental_cycles(self.joints, self.paths))

    def residual(self, q: JointValues) -> Array:
        """Compute the closure error of each loop: the logarithm of the pose at its end, 0 if the loop is closed.

        q (..., n) -> (..., 6 l) for l loops, one twist (omega, v) after the other.

        >>> linkage = kl.linkages.bennett()
        >>> bool(np.linalg.norm(linkage.residual(linkage.assemble([1, 2, 1, 2]).q)) < 1e-12)
        True
        """
        return self._linearized(self.in_order(q), [loop.chain for loop in self.loops])[0]

    def jacobian(self, q: JointValues) -> Array:
        """Compute the derivative of the residual r: for each loop left_jacobian_inverse(r) J_s, with J_s that of its chain.

        q (..., n) -> (..., 6 l, n). If a loop is closed, then r = 0 and its rows are the space Jacobian J_s itself.

        >>> kl.linkages.bennett().jacobian([1, 2, 1, 2]).shape
        (6, 4)
        """
        return self._linearized(self.in_order(q), [loop.chain for loop in self.loops])[1]

    def poses(self, q: JointValues) -> dict[str, Array]:
        """Compute the displacement of every body from where it is drawn, along the shortest path over joints to it.

        q (..., n) -> (..., 4, 4) for each body. If a loop is not closed, another path would give another displacement.

        >>> kl.linkages.four_bar(4, 1, 3.5, 3).poses([np.pi, 0, 0, 0])["crank"][:2, :2].round(6) + 0.0
        array([[-1.,  0.],
               [ 0., -1.]])
        """
        q = self.in_order(q)
        moved = {body: path.chain.fk(q[..., path.columns]) for body, path in self.paths.items() if path.steps}
        return {self.ground: np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))} | moved

    def assemble(self, guess: JointValues, hold: Mapping[str, float] | None = None) -> Assembly:
        """Close the linkage near a guess (n,), while some joint values are held.

        hold  the names of joint values (see `names`), and the values at which they are held

        If no configuration near the guess closes, `converged` of the result is False, and its residual, in metres and radians
        together, is the smallest nearby. Try another guess then, because this one may be singular, or `assembly_modes`.

        Raises ValueError if a held name is not that of a joint value.

        >>> kl.linkages.four_bar(4, 1, 1, 1).assemble([0.5, 0.5, 2, 0]).converged        # the three short links do not reach
        False
        """
        equations, start, held, free = self._closure(guess, hold, "guess")
        found = solve(equations, start[None])
        q, residual = held + free @ found.x[0], float(found.residual[0])
        return Assembly(validation.read_only_copy(q), residual, residual <= equations.tolerance)

    def assembly_modes(self, hold: Mapping[str, float] | None = None) -> Array:
        """Find the ways of assembling the linkage while some joint values are held: configurations (m, n), each once.

        If none closes, the array is empty, (0, n). Two configurations are the same mode if all bodies have the same poses. The
        search begins at random guesses, the same ones at every call: modes to which few guesses lead may be missing.

        Raises ValueError if the bodies can still move with these values held, because then the modes form curves.

        >>> len(kl.linkages.four_bar(4, 1, 3.5, 3).assembly_modes(hold={"A": 1.0}))
        2
        """
        equations, _, held, free = self._closure(np.zeros(self.n), hold)
        # A prismatic joint may have to travel twice the size of the linkage, and a helical joint as many turns as this takes.
        pitch = np.clip(np.abs(line(self.screws).pitch), tolerances.UNIT_LENGTH_TOL, 1)
        search_range = np.where(self.is_angle, np.pi, 2 * max(reach(loop.centred) for loop in self.loops) / pitch)

        def poses(x: Array) -> Array:
            return np.stack(list(self.poses(held + x @ free.T).values()), axis=1)

        return held + search_modes(equations, search_range @ free, poses) @ free.T

    def trace(self, start: JointValues, hold: Mapping[str, float] | None = None, points: int | None = None) -> Curve:
        """Follow the motion from a configuration (n,) in both directions, through dead points, until it closes or ends.

        points  the number of configurations to return, at about equal steps; None: as many as the tracing needed

        A curve ends where no configuration closes further on, or after 5000 steps. It goes straight on where it crosses another
        curve, for example where a parallelogram lies flat.

        Raises ValueError if the start does not close, or the linkage does not have exactly one degree of freedom there.

        >>> linkage = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
        >>> curve = linkage.trace(linkage.assembly_modes(hold={"A": 1.0})[0])
        >>> curve.closed, bool(np.abs(linkage.residual(curve.q)).max() < 1e-12)
        (True, True)
        """
        if points is not None and points < 2:
            raise ValueError(f"A curve must have at least two points; got points={points!r}.")
        equations, x, held, free = self._closure(start, hold, "start")
        curve = trace_curve(equations, x, points)
        return curve._replace(q=held + curve.q @ free.T)

    def mobility(self, q: JointValues) -> Mobility:
        """Find the mobility at a configuration (n,): by counting, to first order there, and by finite motions.

        Raises ValueError if the configuration does not close.

        >>> linkage = kl.linkages.bennett()
        >>> mobility = linkage.mobility(linkage.assemble([1, 2, 1, 2]).q)
        >>> mobility.kutzbach, mobility.finite
        (-2, 1)
        """
        equations, start, *_ = self._closure(q, None)
        solution, J = validate_solution(equations, start)
        directions, singular_values = null_space(J)
        finite = finite_mobility(equations, solution, directions)
        return Mobility(self.kutzbach(), directions.shape[1], finite, singular_values, directions)

    def kutzbach(self) -> int:
        """Count degrees of freedom by the Gruebler-Kutzbach formula: those of all joints, minus d equations for each loop.

        d is the dimension of the group that the joints of a loop generate: 6 in space, 3 in a plane or about a point. With N bodies
        and J joints, and one d for all loops, this is d(N - 1 - J) + sum f_i: the mobility, if all equations are independent.

        Source: Modern Robotics, (2.4), Gruebler's formula.

        >>> kl.linkages.four_bar(4, 1, 3.5, 3).kutzbach(), kl.linkages.bennett().kutzbach()
        (1, -2)
        """
        return self.n - sum(group_dimension(loop.centred.screws) for loop in self.loops)

    def _linearized(self, q: Array, chains: Sequence[Chain]) -> tuple[Array, Array]:
        """The residual (..., 6 l) of the loops, written as these chains, and its Jacobian (..., 6 l, n)."""
        r = np.empty((*q.shape[:-1], 6 * len(chains)))
        J = np.zeros((*r.shape, self.n))
        for i, (chain, loop) in enumerate(zip(chains, self.loops, strict=True)):
            rows, q_loop = slice(6 * i, 6 * i + 6), q[..., loop.columns]
            r[..., rows] = log(chain.fk(q_loop))
            J[..., rows, loop.columns] = left_jacobian_inverse(r[..., rows]) @ chain.jacobian(q_loop)
        return r, J

    def _closure(
        self, configuration: JointValues, hold: Mapping[str, float] | None, argument: str = "q"
    ) -> tuple[Equations, Array, Array, Array]:
        """The closure equations in the k joint values x that are not held, and x, held and free with q = held + free x.

        x (k,) is the configuration q, from which a search begins; held (n,) and free (n, k).
        """
        q = validation.single(self.in_order(configuration, argument), argument).copy()
        validation.instance({} if hold is None else hold, "hold", Mapping)
        for name, value in (hold or {}).items():
            if name not in self.names:
                raise ValueError(f"A held name must be one of {', '.join(self.names)}; got {name!r}.")
            q[self.names.index(name)] = validation.array(value, name)
        is_free = np.array([name not in (hold or {}) for name in self.names])
        if not is_free.any():
            raise ValueError("At least one joint value must not be held; all are held. Leave one out of hold.")
        held, free = np.where(is_free, 0.0, q), np.eye(self.n)[:, is_free]
        # About the centre of each loop, so that the accuracy does not depend on where the origin is.
        centred = [loop.centred for loop in self.loops]

        def linearize(x: Array) -> tuple[Array, Array]:
            r, J = self._linearized(held + x @ free.T, centred)
            return r, J @ free

        tolerance = 1e-13 * (
            1 + max(reach(loop.chain) for loop in self.loops)
        )  # rounding errors grow with the distance
        return Equations(linearize, tolerance, self.is_angle[is_free]), q[is_free], held, free
