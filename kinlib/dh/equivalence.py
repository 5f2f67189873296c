"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The directions of the axes determine the rotations, one joint after the other: the next direction of a can be aligned with the
next one of b only by a rotation about the axis before, whose angle is the offset. If the two axes are parallel, the vector from
one to the other determines the angle instead. The positions are a linear problem. At right angles both signs of a joint are
possible; but the rest of the arm can distinguish two maps of the joints up to a revolute one only by the sign of that joint,
because a rotation about it is an offset. So few of them are kept, and the time grows in proportion to the number of joints, not
like 2^n. The result is checked at random configurations, so a positive answer is never wrong; it includes X, Y, s and c, so it
can be checked again.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    INTERMEDIATE_TOL_FACTOR,
    NEARLY_PARALLEL_RAD,
    RELOCATE_PRISMATIC_RAD,
    SAME_DISTANCE_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.invariants import AxisInvariants
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import cross, exp, hat, homogeneous, inverse, perpendicular
from kinlib.rigid.screw import line

CHECKED_CONFIGURATIONS = 16
"""Number of random configurations at which a result is checked."""

CHOICES = ("base", "tool", "zeros", "signs")
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint."""


@dataclass(frozen=True, eq=False)
class Equivalence:
    """The result, usable as True or False, with the map between the mechanisms or the reason why there is none.

    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry of a pose, over random configurations; inf if no map was found
    reason                       why the mechanisms are not equivalent, in words
    """

    same: bool
    base: Array = field(default_factory=lambda: np.eye(4), repr=False)
    tool: Array = field(default_factory=lambda: np.eye(4), repr=False)
    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    difference: float = np.inf
    reason: str = ""

    def __bool__(self) -> bool:
        return self.same


def equivalent(
    a: Chain | DHTable,
    b: Chain | DHTable,
    *,
    fixed: Collection[str] = (),
    tolerance: float = EQUIVALENCE_TOL,
    simplest: bool = True,
) -> Equivalence:
    """Decide whether two descriptions have the same motions, up to base, tool, joint zero and joint sign.

    a, b are chains, or tables in either convention. The position of a prismatic axis has no effect, because it has no line.
    fixed     what may not differ: any of "base", "tool", "zeros" and "signs"
    simplest  return the map with the shortest description, if there are several; False returns the first, which is faster

    Raises ValueError for a tolerance that is not positive, and for a name in fixed that is none of the four.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> bool(equivalent(puma560(), assign_frames(puma560(), convention="standard").table))
    True
    """
    if not tolerance > 0:
        raise ValueError(f"tolerance must be a positive number, in metres and radians; got {tolerance!r}.")
    if isinstance(fixed, str) or not set(fixed) <= set(CHOICES):
        raise ValueError(f"fixed must be a collection of names from {', '.join(CHOICES)}; got {fixed!r:.80}.")
    one, other = (arm.to_chain() if isinstance(arm, DHTable) else arm for arm in (a, b))
    if one.joint_types != other.joint_types:
        return Equivalence(
            False, reason=f"The joint types differ: {one.joint_types} in the first, {other.joint_types} in the second."
        )
    loose = INTERMEDIATE_TOL_FACTOR * tolerance
    invariants = AxisInvariants(other, loose / (1 - CLEARLY_NOT_PARALLEL_COS))
    if invariants.violated(invariants.of(one.lines.axis, one.joint_points)).any():
        return Equivalence(False, reason=_first_difference(one, other))
    matcher = _Matcher(one, other, frozenset(fixed), loose, simplest)
    results: list[Equivalence] = []
    for match in matcher.matches():
        results.append(matcher.complete(match))
        if not simplest and results[-1].difference <= tolerance:
            break
    closest = min([*matcher.residuals, *(result.difference for result in results)], default=np.inf)
    results = [result for result in results if result.difference <= tolerance]
    if results:
        return min(results, key=lambda result: _description_length(result, tolerance))
    return Equivalence(False, difference=closest, reason=_first_difference(one, other))


@dataclass(frozen=True, eq=False)
class _Match:
    """A map of the joints 0 to len(signs) - 1 of one mechanism onto those of another, up to the translations that are still free.

    base     the rotation from link 0 of a to link 0 of b, (3, 3)
    link     the same for the link after the last matched joint, and position, (3,), its translation
    span     an orthonormal basis (3, r) of the translations that may be added to it
    offsets  of the joints that rotate
    free     the joint whose rotation may still be chosen without changing the match; -1 for the base, None if there is none
    anchor   the last joint whose line is matched, None if there is none
    """

    base: Array
    link: Array
    position: Array
    span: Array
    signs: tuple[float, ...]
    offsets: Array
    free: int | None
    anchor: int | None = None


@dataclass(frozen=True, eq=False)
class _Matcher:
    """The search for maps from one mechanism to another: joint after joint, with few partial matches at a time.

    residuals   of the positions, for each match that was given up because of them
    """

    one: Chain
    other: Chain
    fixed: frozenset[str]
    loose: float
    simplest: bool
    residuals: list[float] = field(default_factory=list)

    def matches(self) -> list[_Match]:
        """Find maps of all joints. Where the rest of the mechanism cannot tell two partial maps apart, one of them is kept."""
        matches = list(self._starts())
        for joint in range(1, self.one.n):
            matches = self._pruned([longer for match in matches for longer in self._extended(match, joint)])
        if "tool" in self.fixed:
            matches = [final for match in matches for final in self._with_tool(match)]
        return matches

    def _starts(self) -> Iterator[_Match]:
        u, v = self.one.lines.axis[0], self.other.lines.axis[0]
        for sign in self._signs:
            if "base" in self.fixed:
                start = _Match(np.eye(3), np.eye(3), np.zeros(3), np.zeros((3, 0)), (), np.zeros(self.one.n), None)
            else:
                R = _rotation_between(u, sign * v)
                start = _Match(R, R, np.zeros(3), np.eye(3), (), np.zeros(self.one.n), -1)
            yield from self._seated(start, 0, sign)

    @property
    def _signs(self) -> tuple[float, ...]:
        return (1.0,) if "signs" in self.fixed else (1.0, -1.0)

    def _extended(self, match: _Match, joint: int) -> Iterator[_Match]:
        """Yield the matches of one joint more."""
        u, v = self.one.lines.axis, self.other.lines.axis
        axis, direction = match.signs[-1] * v[joint - 1], match.link @ u[joint]
        sine = np.linalg.norm(cross(axis, direction))
        for sign in self._signs:
            target = sign * v[joint]
            if abs(axis @ (direction - target)) > self.loose:
                continue
            if sine < NEARLY_PARALLEL_RAD + self.loose:
                # Parallel: the direction does not determine the rotation before, but the vector from axis to axis does.
                is_line = self.one.joint_types[joint] == "R"
                yield from self._seated(
                    self._align_parallel_axis(match, joint, axis) if is_line else match, joint, sign
                )
            if sine > self.loose / 10:
                yield from self._seated(replace(self._rotated(match, axis, direction, target), free=None), joint, sign)

    def _seated(self, match: _Match, joint: int, sign: float) -> Iterator[_Match]:
        """Yield the match with this joint, if its direction agrees and the free translations can bring its line to the other's."""
        joint_type, axis = self.one.joint_types[joint], self.other.lines.axis[joint]
        zero_is_free = "zeros" not in self.fixed
        if np.linalg.norm(match.link @ self.one.lines.axis[joint] - sign * axis) > self.loose:
            return
        match = replace(match, signs=(*match.signs, sign))
        if joint_type == "P":
            rest = axis - match.span @ (match.span.T @ axis)
            length = np.linalg.norm(rest)
            if zero_is_free and length > SAME_DISTANCE_RAD:
                match = replace(match, span=np.column_stack([match.span, rest / length]))
            yield match
            return
        point = match.link @ self.one.joint_points[joint] + match.position
        across = np.eye(3) - np.outer(axis, axis)
        free = joint if zero_is_free and joint_type == "R" else match.free
        yield from self._translated(
            replace(match, free=free, anchor=joint), across, self.other.joint_points[joint] - point
        )

    def _translated(self, match: _Match, across: Array, missing: Array) -> Iterator[_Match]:
        """Yield the match with a free translation for which across @ (translation - missing) = 0, if there is one."""
        U, sizes, Vt = np.linalg.svd(across @ match.span)
        rank = int(np.sum(sizes > SAME_DISTANCE_RAD))
        translation = match.span @ Vt[:rank].T @ ((U.T @ across @ missing)[:rank] / sizes[:rank])
        residual = float(np.abs(across @ (translation - missing)).max())
        if residual <= self.loose:
            # Between nearly parallel lines the translation depends on the last digits, so later joints may still change it.
            known = int(np.sum(sizes > RELOCATE_PRISMATIC_RAD))
            yield replace(match, position=match.position + translation, span=match.span @ Vt[known:].T)
        else:
            self.residuals.append(residual)

    def _with_tool(self, match: _Match) -> Iterator[_Match]:
        """Yield the match if the last link can be brought to where it is in the other mechanism, tool by tool."""
        target = self.other.home @ inverse(self.one.home)
        across = perpendicular(self.one.lines.axis[-1])
        axis = match.signs[-1] * self.other.lines.axis[-1]
        match = self._rotated(match, axis, match.link @ across, target[:3, :3] @ across)
        if np.abs(match.link - target[:3, :3]).max() <= self.loose:
            yield from self._translated(match, np.eye(3), target[:3, 3] - match.position)

    def _pruned(self, matches: list[_Match]) -> list[_Match]:
        """Keep one of the matches that only a rotation about the last joint distinguishes, because its offset makes up for it.

        For the simplest map, one is kept for each such rotation and each sign of joint 1, that with the fewest differences.
        """
        kept: dict[object, _Match] = {}
        for number, match in enumerate(matches):
            joint = len(match.signs) - 1
            key: object = number
            if match.free == joint:
                key = match.signs[-1]
                if self.simplest:
                    key = (match.signs[0], match.signs[-1], (match.link.round(4) + 0.0).tobytes())
            if key not in kept or self._differences(match) < self._differences(kept[key]):
                kept[key] = match
        return list(kept.values())

    def _differences(self, match: _Match) -> int:
        return int(np.sum(np.array(match.signs) < 0) + np.sum(np.abs(match.offsets) > self.loose))

    def _align_parallel_axis(self, match: _Match, joint: int, axis: Array) -> _Match:
        """Rotate the free joint such that the next parallel axis is on the correct side of it."""
        if match.free is None or match.anchor is None:
            return match
        offset = match.link @ (self.one.joint_points[joint] - self.one.joint_points[match.anchor])
        target = self.other.joint_points[joint] - self.other.joint_points[match.anchor]
        return self._rotated(match, axis, offset, target)

    def _rotated(self, match: _Match, axis: Array, vector: Array, target: Array) -> _Match:
        """Rotate everything after the free joint about its axis, such that the vector is in one half plane with the target."""
        free = match.free
        if free is None:
            return match
        angle = np.arctan2(axis @ cross(vector, target), vector @ target - (axis @ vector) * (axis @ target))
        R = exp(angle * axis)
        # If no line is matched, every translation is free, and it does not matter where the axis is.
        point = np.zeros(3) if match.anchor is None else self.other.joint_points[match.anchor]
        position = R @ (match.position - point) + point
        match = replace(match, link=R @ match.link, position=position, span=R @ match.span)
        if free == -1:
            return replace(match, base=R @ match.base)
        offsets = match.offsets.copy()
        free_axis = match.signs[free] * self.other.lines.axis[free]
        offsets[free] += angle * np.sign(free_axis @ axis)
        return replace(match, offsets=offsets)

    def complete(self, match: _Match) -> Equivalence:
        """Solve for the translation of the base and the zeros of the prismatic joints, a linear problem, and check the whole map."""
        one, other, fixed = self.one, self.other, self.fixed
        # Two configurations are a batch. For a single one the chain would generate a program, which does not pay off for one use.
        at_offsets = np.stack([match.offsets, match.offsets])
        moved, target = line(one.jacobian(at_offsets)[0].T), other.lines
        prismatic = [joint for joint, joint_type in enumerate(one.joint_types) if joint_type == "P"]
        unknown = np.concatenate([np.full(3, "base" not in fixed), np.full(len(prismatic), "zeros" not in fixed)])
        rows, sides = [np.zeros((0, len(unknown)))], [np.zeros(0)]
        for joint in range(one.n):
            if joint not in prismatic:
                translations = [match.base @ moved.axis[i] * (i < joint) for i in prismatic]
                # A translation of an axis along itself has no effect.
                across = np.eye(3) - np.outer(target.axis[joint], target.axis[joint])
                rows.append(across @ np.column_stack([np.eye(3), *translations]))
                sides.append(across @ (target.point[joint] - match.base @ moved.point[joint]))
        if "tool" in fixed:
            rows.append(np.column_stack([np.eye(3), *(match.base @ moved.axis[i] for i in prismatic)]))
            sides.append(other.home[:3, 3] - match.base @ one.fk(at_offsets)[0, :3, 3])
        matrix, side = np.concatenate(rows) * unknown, np.concatenate(sides)
        solution = np.linalg.lstsq(matrix, side, rcond=1e-9)[0] * unknown
        residual = float(np.abs(matrix @ solution - side).max(initial=0))
        if residual > self.loose:
            return Equivalence(False, difference=residual)
        X, Y = homogeneous(match.base, solution[:3]), np.eye(4)
        signs, offsets = np.array(match.signs), match.offsets.copy()
        offsets[prismatic] = solution[3:]
        # A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of
        # joint n. The offsets are chosen such that base and tool are as near the identity as possible.
        if not fixed & {"base", "zeros"}:
            shift = _shift_to_identity(X, one.screws[0])
            X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
        if "tool" not in fixed:
            Y = inverse(X @ one.fk(np.stack([offsets, offsets]))[0]) @ other.home
        if not fixed & {"tool", "zeros"}:
            shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
            Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
        q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
        difference = largest_difference(other.fk(q), X @ one.fk(signs * q + offsets) @ Y)
        return Equivalence(True, X, Y, signs, offsets, difference)


def _shift_to_identity(T: Array, S: Array) -> float:
    """Compute the q for which T e^[S]q is as near the identity as possible."""
    R, omega = T[:3, :3], S[:3]
    if not omega.any():
        return float(-(R @ S[3:]) @ T[:3, 3])
    # The trace of R e^[omega]q is a cosine in q, with its maximum at this q.
    even, odd = np.trace(R) - omega @ R @ omega, np.trace(R @ hat(omega))
    return float(np.arctan2(odd, even)) if np.hypot(odd, even) > NEARLY_PARALLEL_RAD else 0.0


def _description_length(result: Equivalence, tolerance: float) -> tuple[int, float]:
    """Count the differences that a map consists of (signs, zeros, base, tool), and how far base and tool are from identity."""
    distances = [float(np.abs(T - np.eye(4)).sum()) for T in (result.base, result.tool)]
    joints = np.sum(result.signs < 0) + np.sum(np.abs(result.offsets) > tolerance)
    return int(joints + sum(distance > tolerance for distance in distances)), sum(distances)


def _first_difference(one: Chain, other: Chain) -> str:
    """Describe the first pair of neighbouring axes whose angle or distance differs, because a person would check that first."""
    here, there = one.lines, other.lines
    for i in range(one.n - 1):
        # Acute angles, because each axis may have the opposite direction.
        angles = [_acute_degrees(lines.axis[i], lines.axis[i + 1]) for lines in (here, there)]
        if abs(angles[0] - angles[1]) > 1e-3:
            return (
                f"Axes {i + 1} and {i + 2} make an angle of {angles[0]:.4g} degrees in the first, "
                f"and of {angles[1]:.4g} degrees in the second."
            )
        if "P" not in one.joint_types[i : i + 2]:
            distances = [_distance(lines.axis[i : i + 2], lines.point[i : i + 2]) for lines in (here, there)]
            if abs(distances[0] - distances[1]) > EQUIVALENCE_TOL:
                return (
                    f"Axes {i + 1} and {i + 2} are {distances[0]:.4g} m apart in the first, "
                    f"and {distances[1]:.4g} m in the second."
                )
    return "Each pair of neighbouring axes agrees, but no rotation of the joints aligns all of them at once."


def _acute_degrees(u: Array, v: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(cross(u, v)), abs(u @ v))))


def _distance(axes: Array, points: Array) -> float:
    normal, between = cross(*axes), points[1] - points[0]
    sine = float(np.linalg.norm(normal))
    if sine > NEARLY_PARALLEL_RAD:
        return float(abs(between @ normal)) / sine
    return float(np.linalg.norm(cross(between, axes[0])))


def _rotation_between(u: Array, v: Array) -> Array:
    """Compute a rotation that takes the unit vector u to the unit vector v."""
    across = cross(u, v)
    sine = float(np.linalg.norm(across))
    if sine < 1e-9:
        # For opposite vectors, every axis perpendicular to u is possible.
        across, sine = perpendicular(u), 0.0
    return exp(across / np.linalg.norm(across) * np.arctan2(sine, u @ v))
