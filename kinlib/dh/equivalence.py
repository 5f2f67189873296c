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

import math
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Literal

import numpy as np

from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    INTERMEDIATE_TOL_FACTOR,
    NEARLY_PARALLEL_RAD,
    PARALLEL_TOL_RAD,
    RELOCATE_PRISMATIC_RAD,
    ROUNDING_ERROR,
    SAME_DISTANCE_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.invariants import AxisInvariants
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import adjoint, cross, exp, hat, homogeneous, inverse, perpendicular, vee
from kinlib.rigid.screw import line

CHECKED_CONFIGURATIONS = 16
"""Number of random configurations at which a result is checked."""

POLISHED_ABOVE = 1e-3
"""If poses are known only to this fraction of the tolerance, a map is improved by the poses before it is judged."""

POLISHED_BELOW, LARGEST_STEP = 1e-12, 1e3

POLISHING_STEPS = 6

LOOSENED = (1, 100, 10_000)
"""How many times the usual bound the intermediate results of a search may be off, if axes are nearly parallel; tried in turn."""

EPS = float(np.finfo(float).eps)

CHOICES = ("base", "tool", "zeros", "signs")
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint."""


Verdict = Literal["same", "different", "undecided"]


@dataclass(frozen=True, eq=False)
class Equivalence:
    """The answer, with the map between the mechanisms or the reason why there is none.

    verdict                      "same"; "different"; or "undecided", if the poses differ by more than the tolerance, but by no
                                 more than a right description may, because axes are nearly parallel
    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry of a pose, over random configurations; inf if no map was found
    accuracy                     how far the poses of a right description may be off
    reason                       unless they are the same: what differs, and the tolerance with which the answer would be "same"

    bool() of it is True or False, and for "undecided" a ValueError, because both would be wrong.
    """

    verdict: Verdict
    base: Array = field(default_factory=lambda: np.eye(4), repr=False)
    tool: Array = field(default_factory=lambda: np.eye(4), repr=False)
    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    difference: float = np.inf
    accuracy: float = 0.0
    explain: Callable[[], str] = field(default=str, repr=False)

    def __bool__(self) -> bool:
        """Whether the two are the same.

        Raises ValueError if that is undecided.
        """
        if self.verdict == "undecided":
            raise ValueError(f"The comparison must be decided to be used as True or False. {self.reason}")
        return self.verdict == "same"

    @cached_property
    def reason(self) -> str:
        """Why the verdict is not "same"; computed when it is read, because that takes longer than the verdict."""
        return self.explain()


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

    The motions decide: first the poses as they are, then those under each map that the axes admit. If axes of the arm are nearly
    parallel, a table that was derived from them has lost digits; what differs by no more than that is "undecided".

    Raises ValueError for a tolerance that is not positive, and for a name in fixed that is none of the four.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> equivalent(puma560(), assign_frames(puma560(), convention="standard").table).verdict
    'same'
    """
    if not tolerance > 0:
        raise ValueError(f"tolerance must be a positive number, in metres and radians; got {tolerance!r}.")
    if isinstance(fixed, str) or not set(fixed) <= set(CHOICES):
        raise ValueError(f"fixed must be a collection of names from {', '.join(CHOICES)}; got {fixed!r:.80}.")
    one, other = (arm.to_chain() if isinstance(arm, DHTable) else arm for arm in (a, b))
    if one.joint_types != other.joint_types:
        types = f"The joint types differ: {one.joint_types} in the first, {other.joint_types} in the second."
        return Equivalence("different", explain=lambda: types)
    q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
    as_they_are = Equivalence(
        "same", signs=np.ones(one.n), offsets=np.zeros(one.n), difference=largest_difference(a.fk(q), b.fk(q))
    )
    if as_they_are.difference <= tolerance:
        return as_they_are
    # Tables are derived from arms: how nearly parallel the axes of the arm are decides how accurate a table of it can be.
    chains = [arm for arm in (a, b) if isinstance(arm, Chain)] or [one, other]
    accuracy = max(map(derived_accuracy, chains))
    is_ill_conditioned = accuracy > POLISHED_ABOVE * tolerance
    loose = INTERMEDIATE_TOL_FACTOR * max(tolerance, accuracy)
    results, residuals = [as_they_are], [as_they_are.difference]
    is_proved = _has_other_invariants(one, other, loose)
    for factor in () if is_proved else LOOSENED if is_ill_conditioned else LOOSENED[:1]:
        matcher = _Matcher(one, other, frozenset(fixed), factor * loose, simplest)
        for found in matcher.maps(is_polished=is_ill_conditioned):
            results.append(found)
            if not simplest and found.difference <= tolerance:
                break
        residuals += matcher.residuals
        if any(found.difference <= tolerance for found in results):
            break
    if same := [found for found in results if found.difference <= tolerance]:
        return replace(min(same, key=lambda found: _description_length(found, tolerance)), accuracy=accuracy)
    closest = min(results, key=lambda found: found.difference)
    difference = min([closest.difference, *residuals])
    is_proved |= (
        not is_ill_conditioned
        or set(fixed) == set(CHOICES)
        or bool(_first_difference(one, other, tolerance + accuracy))
    )
    if closest.difference <= accuracy or not is_proved:
        why = partial(_why_undecided, one, difference, accuracy)
        return replace(closest, verdict="undecided", accuracy=accuracy, explain=why)
    why = partial(_why_different, one, other, frozenset(fixed), tolerance)
    return Equivalence("different", difference=difference, accuracy=accuracy, explain=why)


def _has_other_invariants(one: Chain, other: Chain, loose: float) -> bool:
    """Whether an angle or a length that no choice can change differs."""
    invariants = AxisInvariants(other, loose / (1 - CLEARLY_NOT_PARALLEL_COS))
    # The frames of nearly parallel axes are far away, so the points that are compared are those next to the tool.
    points = one.joint_points + one.lines.axis * np.sum(
        one.lines.axis * (one.home[:3, 3] - one.joint_points), axis=1, keepdims=True
    )
    return bool(invariants.violated(invariants.of(one.lines.axis, points)).any())


def rough_maps(one: Chain, other: Chain, fixed: frozenset[str], loose: float) -> list[Equivalence]:
    """Return maps from one mechanism to another whose axes agree only roughly, to within `loose` metres and radians.

    >>> from kinlib.chains.robots import puma560
    >>> min(found.difference for found in rough_maps(puma560(), puma560(), frozenset(), 0.1)) < 1e-9
    True
    """
    return [*_Matcher(one, other, fixed, loose, simplest=True).maps(is_polished=True)]


def derived_accuracy(arm: Chain) -> float:
    """Estimate how accurate the poses of a description are that was derived from the axes of an arm, in metres and radians.

        4 reach sum_i min(s_i, 4 eps / s_i) + 16 eps size

    s_i is the sine of the angle between axes i and i+1. A description of two nearly parallel axes either takes them as parallel,
    which is wrong by s, or takes their common normal, whose direction has lost 1 / s of its digits. The factors were measured
    with tables of `assign_frames`.

    >>> from kinlib.chains.robots import puma560
    >>> derived_accuracy(puma560()) < 1e-13
    True
    """
    axis, tool = arm.lines.axis, arm.home[:3, 3]
    sines = np.linalg.norm(np.cross(axis[:-1], axis[1:]), axis=1)
    reach = 1 + np.linalg.norm(np.cross(tool - arm.lines.point, axis), axis=1).max()
    lost = np.minimum(sines, 4 * EPS / np.maximum(sines, EPS)).sum()
    return float(4 * reach * lost + 16 * EPS * max(np.abs(arm.joint_points).max(), reach))


def _polished(found: Equivalence, one: Chain, other: Chain, fixed: frozenset[str]) -> Equivalence:
    """Improve a map by Gauss-Newton steps on the poses themselves, for all configurations at once.

    The error of a pose is the twist of T_b^-1 X T_a(s q + c) Y. It changes by Ad(M^-1) dX + Ad(Y^-1) J dc + dY, where
    M = X T_a Y and J is the body Jacobian of a. The direction of a nearly parallel axis hardly changes the poses, so the least
    squares have a small singular value there, and several bounds for it are tried.
    """
    q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
    target = other.fk(q)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    for _ in range(POLISHING_STEPS):
        if found.difference <= POLISHED_BELOW:
            break
        values = found.signs * q + found.offsets
        M = found.base @ one.fk(values) @ found.tool
        error = pose_error(target, M)
        zeros = adjoint(inverse(found.tool)) @ one.body_jacobian(values)
        tool = np.broadcast_to(np.eye(6), (len(q), 6, 6))
        J = np.concatenate([adjoint(inverse(M)), zeros, tool], axis=-1).reshape(-1, 12 + one.n) * is_free
        steps = [np.linalg.lstsq(J, -error.ravel(), rcond=bound)[0] * is_free for bound in (1e-14, 1e-10, 1e-6)]
        tried = [_moved(found, step, one, target, q) for step in steps]
        best = min(tried, key=lambda each: each.difference)
        if best.difference >= found.difference:
            break
        found = best
    return found


def pose_error(target: Array, M: Array) -> Array:
    """Compute the twists (N, 6), for small errors, that lead from poses to others: target exp(error) = M, (N, 4, 4) each.

    >>> pose_error(np.eye(4), exp([0, 0, 1e-3, 0, 0, 0.5])).round(6)
    array([0.   , 0.   , 0.001, 0.   , 0.   , 0.5  ])
    """
    E = inverse(target) @ M
    R, p = E[..., :3, :3], E[..., :3, 3]
    return np.concatenate([vee((R - np.swapaxes(R, -1, -2)) / 2), p], axis=-1)


def _moved(found: Equivalence, step: Array, one: Chain, target: Array, q: Array) -> Equivalence:
    if np.abs(step).max() > LARGEST_STEP:
        return found
    X, Y, offsets = exp(step[:6]) @ found.base, found.tool @ exp(step[-6:]), found.offsets + step[6:-6]
    difference = largest_difference(target, X @ one.fk(found.signs * q + offsets) @ Y)
    return replace(found, base=X, tool=Y, offsets=offsets, difference=difference)


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

    def maps(self, *, is_polished: bool) -> Iterator[Equivalence]:
        """Yield the maps that the axes admit, each with the difference of the poses that remains."""
        for match in self.matches():
            if found := self.complete(match):
                yield _polished(found, self.one, self.other, self.fixed) if is_polished else found

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

    def complete(self, match: _Match) -> Equivalence | None:
        """Solve for the translation of the base and the zeros of the prismatic joints, a linear problem, and check the whole map."""
        one, other, fixed = self.one, self.other, self.fixed
        moved, target = line(one.jacobian(match.offsets).T), other.lines
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
            sides.append(other.home[:3, 3] - match.base @ one.fk(match.offsets)[:3, 3])
        matrix, side = np.concatenate(rows) * unknown, np.concatenate(sides)
        solution = np.linalg.lstsq(matrix, side, rcond=1e-9)[0] * unknown
        residual = float(np.abs(matrix @ solution - side).max(initial=0))
        if residual > self.loose:
            self.residuals.append(residual)
            return None
        X, Y = homogeneous(match.base, solution[:3]), np.eye(4)
        signs, offsets = np.array(match.signs), match.offsets.copy()
        offsets[prismatic] = solution[3:]
        # A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of
        # joint n. The offsets are chosen such that base and tool are as near the identity as possible.
        if not fixed & {"base", "zeros"}:
            shift = _shift_to_identity(X, one.screws[0])
            X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
        if "tool" not in fixed:
            Y = inverse(X @ one.fk(offsets)) @ other.home
        if not fixed & {"tool", "zeros"}:
            shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
            Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
        q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
        difference = largest_difference(other.fk(q), X @ one.fk(signs * q + offsets) @ Y)
        return Equivalence("same", X, Y, signs, offsets, difference)


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


def _why_undecided(arm: Chain, difference: float, accuracy: float) -> str:
    axis = arm.lines.axis
    sines = np.linalg.norm(np.cross(axis[:-1], axis[1:]), axis=1)
    pair = int(np.argmax(np.minimum(sines, 4 * EPS / np.maximum(sines, EPS))))
    cause = "the coordinates are large"
    if sines[pair] > PARALLEL_TOL_RAD:
        cause = f"axes {pair + 1} and {pair + 2} are nearly parallel, {sines[pair]:.1e} rad apart"
    if difference > accuracy:
        return (
            f"Each map that was found leaves a difference of {difference:.1e} or more, but a better one is not excluded, because "
            f"{cause}."
        )
    return (
        f"The poses differ by {difference:.1e}, and those of a right description may be off by {accuracy:.1e}, because {cause}. "
        f"With tolerance={_rounded_up(difference):g} the two are the same."
    )


def _why_different(one: Chain, other: Chain, fixed: frozenset[str], tolerance: float) -> str:
    """Describe the first difference, and offer the tolerance with which the two would be the same, if there is a small one."""
    reason = _first_difference(one, other, tolerance) or (
        "Each pair of neighbouring axes agrees, but no rotation of the joints aligns all of them at once."
    )
    for power in range(math.ceil(np.log10(tolerance) + 1e-9), -1):
        found = equivalent(one, other, fixed=fixed, tolerance=10.0**power, simplest=False)
        if found.verdict == "same":
            offered = min(_rounded_up(found.difference), 10.0**power)
            return f"{reason} With tolerance={offered:g} the two are the same."
    return reason


def _rounded_up(value: float) -> float:
    """Round a positive number up to one digit more than it needs, so that it is a tolerance with which the value passes."""
    unit = 10.0 ** math.floor(math.log10(value))
    return float(f"{(math.floor(value / unit) + 1) * unit:.0e}")


def _first_difference(one: Chain, other: Chain, tolerance: float) -> str:
    """Describe the first pair of neighbouring axes whose angle or distance differs, which a person would check first; "" if none."""
    here, there = one.lines, other.lines
    for i in range(one.n - 1):
        # Acute angles, because each axis may have the opposite direction.
        angles = [acute_angle(lines.axis[i], lines.axis[i + 1]) for lines in (here, there)]
        if abs(angles[0] - angles[1]) > tolerance:
            first, second = format_different(*np.degrees(angles))
            return f"Axes {i + 1} and {i + 2} make an angle of {first} degrees in the first, and of {second} degrees in the second."
        if "P" not in one.joint_types[i : i + 2]:
            distances = [axis_distance(lines.axis[i : i + 2], lines.point[i : i + 2]) for lines in (here, there)]
            size = 1 + max(np.abs(lines.point[i : i + 2]).max() for lines in (here, there))
            if abs(distances[0] - distances[1]) > tolerance + 16 * EPS * size / max(
                np.sin(angles[0]), PARALLEL_TOL_RAD
            ):
                first, second = format_different(*distances)
                return f"Axes {i + 1} and {i + 2} are {first} m apart in the first, and {second} m in the second."
    return ""


def format_different(one: float, other: float) -> tuple[str, str]:
    """Write two numbers with four digits, or with as many more as show that they differ.

    >>> format_different(0.4318, 0.5), format_different(0.407, 0.40700001)
    (('0.4318', '0.5'), ('0.407', '0.40700001'))
    """
    one, other = (0.0 if abs(number) < ROUNDING_ERROR * abs(one - other) else number for number in (one, other))
    texts = [(f"{one:.{digits}g}", f"{other:.{digits}g}") for digits in range(4, 18)]
    return next((pair for pair in texts if pair[0] != pair[1]), texts[0])


def acute_angle(u: Array, v: Array) -> float:
    """Compute the acute angle between two directions, in radians.

    >>> round(acute_angle(np.array([1, 0, 0]), np.array([-1, 1, 0])), 4)
    0.7854
    """
    return float(np.arctan2(np.linalg.norm(cross(u, v)), abs(u @ v)))


def axis_distance(axes: Array, points: Array) -> float:
    """Compute the length of the common normal of two axes, directions (2, 3) and a point on each (2, 3).

    >>> axis_distance(np.array([[1, 0, 0], [0, 1, 0]]), np.array([[5, 0, 0], [0, 7, 2]]))
    2.0
    """
    normal, between = cross(*axes), points[1] - points[0]
    sine = float(np.linalg.norm(normal))
    if sine > PARALLEL_TOL_RAD:
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
