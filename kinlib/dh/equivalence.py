"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The directions of the axes determine the rotations, one joint after the other: the next direction of a can be aligned with the
next one of b only by a rotation about the axis before, whose angle is the offset. If the two axes are parallel, the vector from
one to the other determines the angle instead. When all rotations are known, the positions are a linear problem. The result is
checked at random configurations, so a positive answer is never wrong; it includes X, Y, s and c, so it can be checked again.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from kinlib.arrays.batching import cross
from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    INTERMEDIATE_TOL_FACTOR,
    NEARLY_PARALLEL_RAD,
    SAME_DISTANCE_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import exp, hat, homogeneous, inverse, perpendicular
from kinlib.rigid.screw import line

CHECKED_CONFIGURATIONS = 16
"""Number of random configurations at which a result is checked."""


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
    a: Chain | DHTable, b: Chain | DHTable, *, tolerance: float = EQUIVALENCE_TOL, simplest: bool = True
) -> Equivalence:
    """Decide whether two descriptions have the same motions, up to base, tool, joint zero and joint sign.

    a, b are chains, or tables in either convention. The position of a prismatic axis has no effect, because it has no line.
    simplest  return the map with the shortest description, if there are several; False returns the first, which is faster

    Raises ValueError for a tolerance that is not positive.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> bool(equivalent(puma560(), assign_frames(puma560(), convention="standard").table))
    True
    """
    if not tolerance > 0:
        raise ValueError(f"tolerance must be a positive number, in metres and radians; got {tolerance!r}.")
    one, other = (arm.to_chain() if isinstance(arm, DHTable) else arm for arm in (a, b))
    if one.joint_types != other.joint_types:
        return Equivalence(
            False, reason=f"The joint types differ: {one.joint_types} in the first, {other.joint_types} in the second."
        )
    loose = INTERMEDIATE_TOL_FACTOR * tolerance
    if _differ_clearly(one, other, loose):
        return Equivalence(False, reason=_first_difference(one, other))
    results, closest = [], np.inf
    for match in _match_directions(one, other, loose):
        result = _match_positions(one, other, match, loose)
        closest = min(closest, result.difference)
        if result.difference <= tolerance:
            results.append(result)
            if not simplest:
                break
    if results:
        return min(results, key=lambda result: _description_length(result, tolerance))
    return Equivalence(False, difference=closest, reason=_first_difference(one, other))


@dataclass(frozen=True, eq=False)
class _Match:
    """A match of the directions of joints 0 to len(signs) - 1.

    base   the rotation from link 0 of a to link 0 of b, (3, 3)
    link   the same for the link after the last matched joint
    free   the joint whose rotation may still be chosen without changing the match; -1 for the base, None if there is none
    """

    base: Array
    link: Array
    signs: tuple[float, ...]
    offsets: Array
    free: int | None


def _match_directions(one: Chain, other: Chain, loose: float) -> Iterator[_Match]:
    """Yield all rotations of the joints of one for which its axes have the directions of the other's."""
    u, v = one.lines.axis, other.lines.axis
    for sign in (1.0, -1.0):
        R = _rotation_between(u[0], sign * v[0])
        first = 0 if one.joint_types[0] == "R" else -1
        yield from _extend(_Match(R, R, (sign,), np.zeros(one.n), first), one, other, loose)


def _extend(match: _Match, one: Chain, other: Chain, loose: float) -> Iterator[_Match]:
    """Yield all complete matches that begin with this one."""
    joint = len(match.signs)
    if joint == one.n:
        yield match
        return
    u, v = one.lines.axis, other.lines.axis
    axis, direction = match.signs[-1] * v[joint - 1], match.link @ u[joint]
    sine = np.linalg.norm(cross(axis, direction))
    is_revolute = one.joint_types[joint] == "R"
    for sign in (1.0, -1.0):
        target = sign * v[joint]
        if abs(axis @ (direction - target)) > loose:
            continue
        candidates = []
        if sine < NEARLY_PARALLEL_RAD + loose:
            # Parallel: the direction does not determine the rotation before, but the vector from axis to axis does.
            candidate = _align_parallel_axis(match, joint, axis, one, other) if is_revolute else match
            candidates.append(replace(candidate, free=joint if is_revolute else candidate.free))
        if sine > loose / 10:
            candidate = _rotate(match, axis, direction, target, other)
            candidates.append(replace(candidate, free=joint if is_revolute else None))
        for candidate in candidates:
            if np.linalg.norm(candidate.link @ u[joint] - target) <= loose:
                yield from _extend(replace(candidate, signs=(*match.signs, sign)), one, other, loose)


def _align_parallel_axis(match: _Match, joint: int, axis: Array, one: Chain, other: Chain) -> _Match:
    """Rotate the free joint such that the next parallel axis is on the correct side of it."""
    free = match.free
    if free is None or free < 0:
        return match
    offset = match.link @ (one.joint_points[joint] - one.joint_points[free])
    target = other.joint_points[joint] - other.joint_points[free]
    return _rotate(match, axis, offset, target, other)


def _rotate(match: _Match, axis: Array, vector: Array, target: Array, other: Chain) -> _Match:
    """Rotate everything after the free joint about an axis, such that the vector is in one half plane with the target."""
    if match.free is None:
        return match
    angle = np.arctan2(axis @ cross(vector, target), vector @ target - (axis @ vector) * (axis @ target))
    R = exp(angle * axis)
    if match.free == -1:
        return replace(match, base=R @ match.base, link=R @ match.link)
    offsets = match.offsets.copy()
    free_axis = match.signs[match.free] * other.lines.axis[match.free]
    offsets[match.free] += angle * np.sign(free_axis @ axis)
    return replace(match, link=R @ match.link, offsets=offsets)


def _match_positions(one: Chain, other: Chain, match: _Match, loose: float) -> Equivalence:
    """Solve for the translation of the base and the zeros of the prismatic joints, a linear problem, and check the whole map."""
    # Two configurations are a batch. For a single one the chain would generate a program, which does not pay off for one use.
    moved, target = line(one.jacobian(np.stack([match.offsets, match.offsets]))[0].T), other.lines
    prismatic = [joint for joint, joint_type in enumerate(one.joint_types) if joint_type == "P"]
    rows, sides = [np.zeros((0, 3 + len(prismatic)))], [np.zeros(0)]
    for joint in range(one.n):
        if joint not in prismatic:
            translations = [match.base @ moved.axis[i] * (i < joint) for i in prismatic]
            # A translation of an axis along itself has no effect.
            across = np.eye(3) - np.outer(target.axis[joint], target.axis[joint])
            rows.append(across @ np.column_stack([np.eye(3), *translations]))
            sides.append(across @ (target.point[joint] - match.base @ moved.point[joint]))
    matrix, side = np.concatenate(rows), np.concatenate(sides)
    solution = np.linalg.lstsq(matrix, side, rcond=1e-9)[0]
    residual = float(np.abs(matrix @ solution - side).max(initial=0))
    if residual > loose:
        return Equivalence(False, difference=residual)
    X = homogeneous(match.base, solution[:3])
    signs, offsets = np.array(match.signs), match.offsets.copy()
    offsets[prismatic] = solution[3:]
    # A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of
    # joint n. The offsets are chosen such that base and tool are as near the identity as possible.
    shift = _shift_to_identity(X, one.screws[0])
    X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
    Y = inverse(X @ one.fk(np.stack([offsets, offsets]))[0]) @ other.home
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


def _differ_clearly(one: Chain, other: Chain, loose: float) -> bool:
    """Whether two neighbouring axes have another angle or another distance: then a search for a map is pointless."""
    for i in range(one.n - 1):
        pairs = [(lines.axis[i : i + 2], lines.point[i : i + 2]) for lines in (one.lines, other.lines)]
        cosines = [abs(float(axes[0] @ axes[1])) for axes, _ in pairs]
        if abs(cosines[0] - cosines[1]) > loose:
            return True
        # The distance of nearly parallel axes depends on the last digits, and a prismatic axis has none.
        is_reliable = "P" not in one.joint_types[i : i + 2] and (
            cosines[0] < CLEARLY_NOT_PARALLEL_COS
            or all(np.linalg.norm(cross(*axes)) < SAME_DISTANCE_RAD for axes, _ in pairs)
        )
        difference = abs(_distance(*pairs[0]) - _distance(*pairs[1]))
        if is_reliable and difference > loose / (1 - CLEARLY_NOT_PARALLEL_COS):
            return True
    return False


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
