"""Maps between two chains that move alike: the poses X and Y, the signs s and the offsets c with T_b(q) = X T_a(s q + c) Y.

The directions of the axes determine the rotations, one joint after the other: the next direction of a can be aligned with the
next one of b only by a rotation about the axis before, whose angle is the offset. If the two axes are parallel, the vector from
one to the other determines the angle instead. The positions are a linear problem. At right angles both signs of a joint are
possible; but the rest of the arm can distinguish two maps of the joints up to a revolute one only by the sign of that joint,
because a rotation about it is an offset. So few of them are kept, and the time grows in proportion to the number of joints, not
like 2^n. At the end each map is improved by the poses themselves, which are more accurate than nearly parallel axes.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from kinlib.arrays.tolerances import NEARLY_PARALLEL_RAD, RELOCATE_PRISMATIC_RAD, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.rigid.lie import adjoint, cross, exp, hat, homogeneous, inverse, perpendicular, vee

CHECKED_CONFIGURATIONS = 16
"""Number of random configurations at which two chains are compared."""

IMPROVED_ABOVE, IMPROVING_STEPS, LARGEST_STEP = 1e-12, 6, 1e3
"""A map whose poses differ by more than the first is improved, in so many steps, none longer than the last."""


@dataclass(frozen=True, eq=False)
class JointMap:
    """A map from a chain a to a chain b: T_b(q) = X T_a(s q + c) Y, approximately.

    base, tool, signs, offsets   X (4, 4), Y (4, 4), s (n,) and c (n,)
    difference                   the largest difference in an entry of a pose, over random configurations
    """

    base: Array
    tool: Array
    signs: Array
    offsets: Array
    difference: float = np.inf

    def poses(self, one: Chain, q: Array) -> Array:
        """Compute X T_a(s q + c) Y, for q (..., n)."""
        T: Array = self.base @ one.fk(self.signs * q + self.offsets) @ self.tool
        return T


def identity_map(one: Chain, other: Chain) -> JointMap:
    """Return the map that changes nothing, with the difference of the poses as they are."""
    return _measured(JointMap(np.eye(4), np.eye(4), np.ones(one.n), np.zeros(one.n)), one, other)


def joint_maps(one: Chain, other: Chain, fixed: frozenset[str], loose: float) -> list[JointMap]:
    """Find the maps from one chain to another with the same joint types, those whose axes agree to within `loose`.

    fixed  what may not differ, of "base", "tool", "zeros" and "signs"
    loose  in metres and radians. The difference of the poses that remains can be larger or smaller
    """
    matcher = _Matcher(one, other, fixed, loose)
    return [matcher.completed(match) for match in matcher.matches()]


def _measured(found: JointMap, one: Chain, other: Chain) -> JointMap:
    q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
    return replace(found, difference=largest_difference(other.fk(q), found.poses(one, q)))


def _improved(found: JointMap, one: Chain, other: Chain, fixed: frozenset[str]) -> JointMap:
    """Improve a map by Gauss-Newton steps on the poses themselves, for all configurations at once.

    The direction of a nearly parallel axis hardly changes the poses, so the least squares have a small singular value there, and
    several bounds for it are tried.
    """
    q = random_configurations(one.n, CHECKED_CONFIGURATIONS)
    target = other.fk(q)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    for _ in range(IMPROVING_STEPS):
        if found.difference <= IMPROVED_ABOVE:
            break
        error, J = linearized(found.base, one, found.signs * q + found.offsets, found.tool, target)
        best = found
        for bound in (1e-14, 1e-10, 1e-6):
            step = np.linalg.lstsq(J * is_free, -error, rcond=bound)[0] * is_free
            if np.abs(step).max() <= LARGEST_STEP:
                best = min(best, _moved(found, step, one, other), key=lambda each: each.difference)
            if best.difference <= IMPROVED_ABOVE:
                return best
        if best.difference >= found.difference:
            break
        found = best
    return found


def linearized(X: Array, chain: Chain, values: Array, Y: Array, target: Array) -> tuple[Array, Array]:
    """Compute the errors (6 N,) of the poses X T(values) Y, and their Jacobian (6 N, 6 + n + 6).

    values (N, n), target (N, 4, 4). The error is the small twist of target^-1 X T Y; with M = X T Y and the body Jacobian J of the
    chain, it changes by Ad(M^-1) dX + Ad(Y^-1) J dvalues + dY.
    """
    M = X @ chain.fk(values) @ Y
    by_values = adjoint(inverse(Y)) @ chain.body_jacobian(values)
    J = np.concatenate([adjoint(inverse(M)), by_values, np.broadcast_to(np.eye(6), (len(values), 6, 6))], axis=-1)
    return _pose_error(target, M).ravel(), J.reshape(-1, J.shape[-1])


def _moved(found: JointMap, step: Array, one: Chain, other: Chain) -> JointMap:
    X, Y, offsets = exp(step[:6]) @ found.base, found.tool @ exp(step[-6:]), found.offsets + step[6:-6]
    return _measured(replace(found, base=X, tool=Y, offsets=offsets), one, other)


def _pose_error(target: Array, M: Array) -> Array:
    """Compute the twists (N, 6), for small errors, that lead from poses to others: target exp(error) = M, (N, 4, 4) each."""
    E = inverse(target) @ M
    R, p = E[..., :3, :3], E[..., :3, 3]
    return np.concatenate([vee((R - np.swapaxes(R, -1, -2)) / 2), p], axis=-1)


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
    """The search for maps from one chain to another: joint after joint, with few partial matches at a time."""

    one: Chain
    other: Chain
    fixed: frozenset[str]
    loose: float

    def matches(self) -> list[_Match]:
        """Find maps of all joints. Where the rest of the chain cannot tell two partial maps apart, one of them is kept."""
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

    def _with_tool(self, match: _Match) -> Iterator[_Match]:
        """Yield the match if the last link can be brought to where it is in the other mechanism, tool by tool."""
        target = self.other.home @ inverse(self.one.home)
        across = perpendicular(self.one.lines.axis[-1])
        axis = match.signs[-1] * self.other.lines.axis[-1]
        match = self._rotated(match, axis, match.link @ across, target[:3, :3] @ across)
        if np.abs(match.link - target[:3, :3]).max() <= self.loose:
            yield from self._translated(match, np.eye(3), target[:3, 3] - match.position)

    def _pruned(self, matches: list[_Match]) -> list[_Match]:
        """Of the matches that only a rotation about the last joint distinguishes, keep those with the fewest differences.

        The offset of that joint makes up for the rotation. Of the others, one is kept for each sign of the first and the last joint.
        """
        kept: dict[object, _Match] = {}
        for number, match in enumerate(matches):
            key: object = number
            if match.free == len(match.signs) - 1:
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

    def completed(self, match: _Match) -> JointMap:
        """Find the translations of base and tool and the zeros of the prismatic joints, which are a linear problem: one step."""
        one, fixed = self.one, self.fixed
        X, Y, offsets = homogeneous(match.base, np.zeros(3)), np.eye(4), match.offsets
        if "tool" not in fixed:
            Y = inverse(X @ one.fk(offsets)) @ self.other.home
        found = _improved(
            _measured(JointMap(X, Y, np.array(match.signs), offsets), one, self.other), one, self.other, fixed
        )
        X, Y, offsets = found.base, found.tool, found.offsets.copy()
        # A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of
        # joint n. The offsets are chosen such that base and tool are as near the identity as possible.
        if not fixed & {"base", "zeros"}:
            shift = _shift_to_identity(X, one.screws[0])
            X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
        if not fixed & {"tool", "zeros"}:
            shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
            Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
        return _measured(JointMap(X, Y, found.signs, offsets), one, self.other)


def _shift_to_identity(T: Array, S: Array) -> float:
    """Compute the q for which T e^[S]q is as near the identity as possible."""
    R, omega = T[:3, :3], S[:3]
    if not omega.any():
        return float(-(R @ S[3:]) @ T[:3, 3])
    # The trace of R e^[omega]q is a cosine in q, with its maximum at this q.
    even, odd = np.trace(R) - omega @ R @ omega, np.trace(R @ hat(omega))
    return float(np.arctan2(odd, even)) if np.hypot(odd, even) > NEARLY_PARALLEL_RAD else 0.0


def _rotation_between(u: Array, v: Array) -> Array:
    """Compute a rotation that takes the unit vector u to the unit vector v."""
    across = cross(u, v)
    sine = float(np.linalg.norm(across))
    if sine < 1e-9:
        # For opposite vectors, every axis perpendicular to u is possible.
        across, sine = perpendicular(u), 0.0
    return exp(across / np.linalg.norm(across) * np.arctan2(sine, u @ v))
