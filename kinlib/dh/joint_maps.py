"""Maps between two chains that move alike: poses X and Y, signs s and offsets c with T_b(q) = X T_a(s q + c) Y.

The invariants of the axes decide the signs. Then the directions determine the rotations, one joint after the other: the next axis
of a can be brought to the next one of b only by a rotation about the axis before, whose angle is the offset; if the two axes are
parallel, the vector from one to the other determines it. What remains is the least-squares problem of the poses themselves, which
is linear in the translations: one step solves it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from kinlib.arrays.tolerances import SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.invariants import AxisInvariants
from kinlib.rigid.lie import adjoint, cross, exp, hat, homogeneous, inverse, perpendicular, vee

CHOICES = ("base", "tool", "zeros", "signs")
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint."""

COMPARED_CONFIGURATIONS = 16
"""Number of random configurations at which two chains are compared."""

SEARCHED_AS_PARALLEL_RAD = 2e-5
"""Axes at a smaller angle are searched as parallel ones."""

SINGULAR_RTOL = 1e-10
"""Singular values of the least squares that are smaller, relative to the largest, are 0."""

MAX_CHOSEN_SLIDES = 4
"""Of how many prismatic joints both signs are tried."""

EXACT, IMPROVING_STEPS, LARGEST_STEP = 1e-12, 6, 1e3
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


def joint_maps(
    one: Chain, other: Chain, fixed: frozenset[str], loose: float, *, tolerance: float = 0.0
) -> list[JointMap]:
    """Find maps from one chain to another with the same joint types, those whose axes agree to within `loose`.

    fixed  what may not differ, of `CHOICES`
    loose  in metres and radians. The difference of the poses that remains can be larger or smaller
    tolerance  where the poses differ by no more, maps that change more joints are not sought
    """
    found: dict[bytes, JointMap] = {}
    for zeros_are_fixed in {"zeros" in fixed, True}:
        for signs in _sign_choices(one, other, fixed, loose, zeros_are_fixed):
            start = _aligned(one, other, signs, fixed, zeros_are_fixed, max(loose, SEARCHED_AS_PARALLEL_RAD))
            if start:
                numbers = np.concatenate([start.signs, start.offsets, start.base.ravel()])
                found.setdefault((numbers.round(6) + 0.0).tobytes(), start)
    completed: list[JointMap] = []
    fewest = one.n * 2
    for start in sorted(found.values(), key=_changed_joints):
        if _changed_joints(start) > fewest:
            break
        completed.append(_completed(start, one, other, fixed))
        if completed[-1].difference <= tolerance:
            fewest = min(fewest, _changed_joints(start) + 2)  # base and tool may take up two changes
    return completed


def _changed_joints(start: JointMap) -> int:
    return int(np.sum(start.signs < 0) + np.sum(np.abs(start.offsets) > SAME_DISTANCE_RAD))


def _sign_choices(
    one: Chain, other: Chain, fixed: frozenset[str], loose: float, zeros_are_fixed: bool
) -> Iterator[Array]:
    """Yield signs (n,) of the joints, 0 where the directions of the axes will decide them."""
    n = one.n
    if "signs" in fixed:
        yield np.ones(n)
    elif zeros_are_fixed:
        # The base maps all axes at once; it is determined by the first axis and the first one that is not parallel to it.
        u = one.lines.axis
        second = next((k for k in range(1, n) if np.linalg.norm(cross(u[0], u[k])) > SEARCHED_AS_PARALLEL_RAD), 0)
        for ends in product((1.0, -1.0), repeat=2 if second else 1):
            signs = np.zeros(n)
            signs[[0, second][: len(ends)]] = ends
            yield signs
    else:
        invariants = AxisInvariants(other, 100 * loose)
        slides = [k for k, letter in enumerate(one.joint_types) if letter == "P"][:MAX_CHOSEN_SLIDES]
        # The frames of nearly parallel axes are far away, so the points that are compared are those next to the tool.
        axis, points = one.lines.axis, one.joint_points
        near = points + axis * np.sum(axis * (one.home[:3, 3] - points), axis=1, keepdims=True)
        for of_lines in invariants.sign_choices(invariants.of(axis, near)):
            for chosen in product((1.0, -1.0), repeat=len(slides)):
                signs = of_lines.copy()
                signs[slides] = chosen
                yield signs


def _aligned(  # noqa: PLR0917
    one: Chain,
    other: Chain,
    signs: Array,
    fixed: frozenset[str],
    zeros_are_fixed: bool,
    loose: float,
) -> JointMap | None:
    """Rotate one axis after the other to where it is in the other chain; None if a direction does not agree."""
    u, v, p, to = one.lines.axis, other.lines.axis, one.joint_points, other.joint_points
    signs, offsets, base = signs.copy(), np.zeros(one.n), np.eye(3)
    # Something can still be rotated about the axis: the base (-1) or a joint, through the line with the number `anchor`.
    free, axis, anchor = None, v[0], None
    if "base" not in fixed:
        signs[0] = signs[0] or 1.0
        free, axis = -1, signs[0] * v[0]
        base = _rotation_between(u[0], axis)
    R = base.copy()

    def rotate(vector: Array, target: Array) -> None:
        """Rotate what is free such that the vector is in one half plane with the target."""
        nonlocal R, base
        angle = np.arctan2(axis @ cross(vector, target), vector @ target - (axis @ vector) * (axis @ target))
        Q = exp(angle * axis)
        R = Q @ R
        if free == -1:
            base = Q @ base
        else:
            offsets[free] += angle

    for k, letter in enumerate(one.joint_types):
        if free is not None:
            is_parallel = np.linalg.norm(cross(R @ u[k], axis)) <= SEARCHED_AS_PARALLEL_RAD
            if not is_parallel:
                signs[k] = signs[k] or 1.0
                rotate(R @ u[k], signs[k] * v[k])
                free = None
            elif letter != "P" and anchor is not None:
                between, target = (R @ (p[k] - p[anchor])), to[k] - to[anchor]
                across = between - axis * (axis @ between)
                if np.linalg.norm(across) > 10 * loose:
                    rotate(between, target)
                    free = None
        signs[k] = signs[k] or (1.0 if v[k] @ R @ u[k] >= 0 else -1.0)
        if np.linalg.norm(R @ u[k] - signs[k] * v[k]) > loose:
            return None
        if letter != "P" and not zeros_are_fixed:
            free, axis, anchor = k, signs[k] * v[k], k
        elif letter != "P" and free == -1 and anchor is None:
            anchor = k
    if "tool" in fixed and free is not None:
        across = perpendicular(u[-1])
        rotate(R @ across, other.home[:3, :3] @ one.home[:3, :3].T @ across)
    return JointMap(homogeneous(base, np.zeros(3)), np.eye(4), signs, offsets)


def _completed(start: JointMap, one: Chain, other: Chain, fixed: frozenset[str]) -> JointMap:
    """Find the translations of base and tool and the zeros of the prismatic joints."""
    Y = np.eye(4) if "tool" in fixed else inverse(start.base @ one.fk(start.offsets)) @ other.home
    found = _improved(_measured(replace(start, tool=Y), one, other), one, other, fixed)
    X, Y, offsets = found.base, found.tool, found.offsets.copy()
    # A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of
    # joint n. The offsets are chosen such that base and tool are as near the identity as possible.
    if not fixed & {"base", "zeros"}:
        shift = _shift_to_identity(X, one.screws[0])
        X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
    if not fixed & {"tool", "zeros"}:
        shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
        Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
    return _measured(JointMap(X, Y, found.signs, offsets), one, other)


def _measured(found: JointMap, one: Chain, other: Chain) -> JointMap:
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    return replace(found, difference=largest_difference(other.fk(q), found.poses(one, q)))


def _improved(found: JointMap, one: Chain, other: Chain, fixed: frozenset[str]) -> JointMap:
    """Improve a map by least-squares steps on the poses themselves, for all configurations at once.

    The direction of a nearly parallel axis hardly changes the poses, so the least squares have a small singular value there.
    """
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    target = other.fk(q)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    for _ in range(IMPROVING_STEPS):
        if found.difference <= EXACT:
            break
        error, J = linearized(found.base, one, found.signs * q + found.offsets, found.tool, target)
        step = np.linalg.lstsq(J * is_free, -error, rcond=SINGULAR_RTOL)[0] * is_free
        if np.abs(step).max() > LARGEST_STEP:
            break
        X, Y = exp(step[:6]) @ found.base, found.tool @ exp(step[-6:])
        moved = _measured(replace(found, base=X, tool=Y, offsets=found.offsets + step[6:-6]), one, other)
        if moved.difference >= found.difference:
            break
        found = moved
    return found


def linearized(X: Array, chain: Chain, values: Array, Y: Array, target: Array) -> tuple[Array, Array]:
    """Compute the errors (6 N,) of the poses X T(values) Y, and their Jacobian (6 N, 6 + n + 6).

    values (N, n), target (N, 4, 4). The error is the small twist of target^-1 X T Y; with M = X T Y and the body Jacobian J of the
    chain, it changes by Ad(M^-1) dX + Ad(Y^-1) J dvalues + dY.
    """
    M = X @ chain.fk(values) @ Y
    E = inverse(target) @ M
    R = E[..., :3, :3]
    error = np.concatenate([vee((R - np.swapaxes(R, -1, -2)) / 2), E[..., :3, 3]], axis=-1)
    by_values = adjoint(inverse(Y)) @ chain.body_jacobian(values)
    J = np.concatenate([adjoint(inverse(M)), by_values, np.broadcast_to(np.eye(6), (len(values), 6, 6))], axis=-1)
    return error.ravel(), J.reshape(-1, J.shape[-1])


def _shift_to_identity(T: Array, S: Array) -> float:
    """Compute the q for which T e^[S]q is as near the identity as possible."""
    R, omega = T[:3, :3], S[:3]
    if not omega.any():
        return float(-(R @ S[3:]) @ T[:3, 3])
    # The trace of R e^[omega]q is a cosine in q, with its maximum at this q.
    even, odd = np.trace(R) - omega @ R @ omega, np.trace(R @ hat(omega))
    return float(np.arctan2(odd, even)) if np.hypot(odd, even) > SEARCHED_AS_PARALLEL_RAD else 0.0


def _rotation_between(u: Array, v: Array) -> Array:
    """Compute a rotation that takes the unit vector u to the unit vector v."""
    across = cross(u, v)
    sine = float(np.linalg.norm(across))
    if sine < SAME_DISTANCE_RAD:
        # For opposite vectors, every axis perpendicular to u is possible.
        across, sine = perpendicular(u), 0.0
    return exp(across / np.linalg.norm(across) * np.arctan2(sine, u @ v))
