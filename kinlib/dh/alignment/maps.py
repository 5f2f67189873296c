"""Maps between two descriptions of a mechanism: from the axes the signs and the zeros, from least squares the rest.

The invariants of the axes decide the signs. Frames along the common normals then give the offsets: in each chain, the angle about axis k
from the normal before it to the normal after it; c_k is the difference. What remains, base, tool and the zeros of prismatic joints, is
linear, so a least-squares step on the poses finds it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.alignment.invariants import AxisInvariants, Booleans
from kinlib.rigid.angles import wrap_angle
from kinlib.rigid.lie import adjoint, cross, exp, hat, homogeneous, inverse, perpendicular, vee

COMPARED_CONFIGURATIONS = 16
"""At how many random configurations chains are compared."""

SEARCHED_AS_PARALLEL_RAD, PARALLEL_COS, MAX_ROTATION_OF_FIXED = 2e-5, 1 - 1e-9, 0.1
"""Axes at a smaller angle are searched as parallel ones; a joint that is fixed may be off by so many radians before the search."""

MAX_MAPS, EXACT, MAX_STEPS, LARGEST_STEP = 4, 1e-12, 6, 1e3
"""How many maps are compared; and a map whose poses differ by more is improved, in so many steps, none longer than the last."""


@dataclass(frozen=True, eq=False, repr=False)
class Map:
    """A map from a chain a to a chain b, X T_a(s q + c) Y, and the largest difference of its poses from T_b(q); inf if unknown."""

    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    base: Array = field(default_factory=lambda: np.eye(4))
    tool: Array = field(default_factory=lambda: np.eye(4))
    difference: float = np.inf

    def poses(self, one: Chain, q: Array) -> Array:
        """Compute X T_a(s q + c) Y, for q (..., n)."""
        return np.asarray(self.base @ one.fk(self.signs * q + self.offsets) @ self.tool)


def same_q(one: Chain, other: Chain) -> Map:
    """Return the identity, with the difference of the poses for the same q."""
    return _measured(Map(np.ones(one.n), np.zeros(one.n)), one, other)


def nearest_maps(one: Chain, other: Chain, fixed: frozenset[str], loose: float, tolerance: float = 0.0) -> list[Map]:
    """Find maps from one chain to another with the same joint types whose axes agree to within `loose`, in metres and radians.

    Those that change the fewest joints come first; after one to within the tolerance, no map with two changes more is sought.
    """
    found, most = list[Map](), 2 * one.n
    for signs, offsets, R in _starts(one, other, fixed, loose):
        changes = int(np.sum(signs < 0) + np.sum(np.abs(offsets) > SAME_DISTANCE_RAD))
        if changes > most:
            break
        found += _completed(Map(signs, offsets, homogeneous(R, np.zeros(3))), one, other, fixed)
        if found[-1].difference <= tolerance:
            most = min(most, changes + 2)  # base and tool may take up two changes
    return found


def _starts(one: Chain, other: Chain, fixed: frozenset[str], loose: float) -> Iterator[tuple[Array, Array, Array]]:
    """Yield signs (n,), offsets (n,) and the rotation of the base for all signs that the axes admit, the fewest changes first."""
    invariants = AxisInvariants(other, 100 * loose)
    u, v, letters = one.lines.axis, other.lines.axis, one.joint_types
    s = invariants.sign_patterns(invariants.of(u, one.joint_points))
    s = s[(s > 0).all(axis=1)] if "signs" in fixed else s
    for end, joint, R, Q in (("base", 0, np.eye(3), np.eye(3)), ("tool", -1, one.home[:3, :3], other.home[:3, :3])):
        if end in fixed:
            s = s[np.linalg.norm(s[:, [joint]] * (u[joint] @ R) - v[joint] @ Q, axis=1) <= 100 * loose]
    x, y, source, is_cross = _normals(one, other, fixed, 10 * loose)
    flips = np.where(is_cross, np.pad(s[:, :-1] * s[:, 1:], ((0, 0), (1, 1)), constant_values=1.0), 1.0)[:, source]
    offsets = s * _angles(v, y) - _angles(u, x) - np.pi * (flips[:, :-1] != flips[:, 1:])
    offsets = np.asarray(wrap_angle(offsets))
    possible = np.ones(len(s), bool)
    for k in range(len(letters) - 1, -1, -1):
        if letters[k] == "P" or "zeros" in fixed:
            # What a prismatic joint cannot rotate, the joint before it does, if its axis is parallel.
            if letters[k] == "P" and k and abs(cosine := u[k - 1] @ u[k]) > PARALLEL_COS:
                offsets[:, k - 1] = wrap_angle(offsets[:, k - 1] + np.sign(cosine) * offsets[:, k])
            else:
                possible &= np.abs(offsets[:, k]) < MAX_ROTATION_OF_FIXED
            offsets[:, k] = 0.0
    zeros = (np.abs(offsets) > max(loose, SAME_DISTANCE_RAD)).sum(axis=1)
    for k in [k for k in np.lexsort((zeros, (s < 0).sum(axis=1) + zeros)) if possible[k]][:MAX_MAPS]:
        theirs, ours = _frame(v[0], y[0]), _frame(s[k, 0] * u[0], flips[k, 0] * x[0])
        yield s[k], offsets[k], np.eye(3) if "base" in fixed else theirs @ ours.T


def _normals(
    one: Chain, other: Chain, fixed: frozenset[str], near: float
) -> tuple[Array, Array, NDArray[np.int_], Booleans]:
    """Choose directions before, between and after the axes of two chains, (n + 1, 3) each, that correspond to each other.

    Between two axes it is their common normal. Where that is free, the direction is the one before, or the first that is not free;
    at an end that is fixed it is a direction of {s} or of {b}. Returns them with the index that each was taken from, and whether it
    is a cross product, which has the opposite direction if one of the axes has.
    """
    n, arms = one.n, (one, other)
    x, source = np.zeros((2, n + 1, 3)), np.full(n + 1, -1)
    is_cross: Booleans = np.zeros(n + 1, bool)
    if "base" in fixed:
        x[:, 0], source[0] = perpendicular(one.lines.axis[0]), 0
    if "tool" in fixed:
        across = perpendicular(one.lines.axis[-1] @ one.home[:3, :3])
        x[:, n], source[n] = [arm.home[:3, :3] @ across for arm in arms], n
    anchor = 0 if one.joint_types[0] != "P" else None  # the last line that is parallel to the axis
    for k in range(1, n):
        is_line = one.joint_types[k] != "P"
        both = np.array([cross(arm.lines.axis[k - 1], arm.lines.axis[k]) for arm in arms])
        is_cross[k] = np.linalg.norm(both, axis=1).min() > SEARCHED_AS_PARALLEL_RAD
        if not is_cross[k]:
            is_known = is_line and anchor is not None
            between = [arm.joint_points[k] - arm.joint_points[anchor or 0] for arm in arms]
            axes = [arm.lines.axis[k] for arm in arms]
            both = np.array([cross(axis, cross(p, axis)) for axis, p in zip(axes, between, strict=True)]) * is_known
        length = np.linalg.norm(both, axis=1, keepdims=True)
        if is_cross[k] or length.min() > near:
            x[:, k], source[k] = both / length, k
        anchor = k if is_line else None if is_cross[k] else anchor
    known = np.flatnonzero(source >= 0)
    if not known.size:
        x[:, 0], known = [perpendicular(arm.lines.axis[0]) for arm in arms], np.array([0])
    source = known[np.maximum(np.searchsorted(known, np.arange(n + 1), side="right") - 1, 0)]
    return x[0, source], x[1, source], source, is_cross


def _angles(axis: Array, x: Array) -> Array:
    """Compute the angle about each axis (n, 3) from the direction before it to the one after it, of (n + 1, 3) -> (n,)."""
    before, after = x[:-1], x[1:]
    return np.asarray(np.arctan2(np.sum(axis * cross(before, after), axis=1), np.sum(before * after, axis=1)))


def _frame(z: Array, x: Array) -> Array:
    """Compute the axes of a frame with this z and an x near the given one."""
    y = cross(z, x) / np.linalg.norm(cross(z, x))
    return np.transpose([cross(y, z), y, z])


def _completed(start: Map, one: Chain, other: Chain, fixed: frozenset[str]) -> list[Map]:
    """Find the translations of base and tool and the zeros of the prismatic joints.

    A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of joint n.
    So there is another map whose base and tool are as near the identity as possible.
    """
    Y = np.eye(4) if "tool" in fixed else inverse(start.base @ one.fk(start.offsets)) @ other.home
    found = _improved(_measured(replace(start, tool=Y), one, other), one, other, fixed)
    X, Y, offsets = found.base, found.tool, found.offsets.copy()
    if not fixed & {"base", "zeros"}:
        shift = _shift_to_identity(X, one.screws[0])
        X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
    if not fixed & {"tool", "zeros"}:
        shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
        Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
    shifted = _measured(replace(found, base=X, tool=Y, offsets=offsets), one, other)
    return [found] if "zeros" in fixed else [shifted, found]


def _measured(found: Map, one: Chain, other: Chain) -> Map:
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    return replace(found, difference=largest_difference(other.fk(q), found.poses(one, q)))


def _improved(found: Map, one: Chain, other: Chain, fixed: frozenset[str]) -> Map:
    """Improve a map by least-squares steps on the poses themselves, for all configurations at once."""
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    target = other.fk(q)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    # The zero of the first joint is a motion of the base, and that of the last one a motion of the tool.
    is_free[6] &= "base" in fixed
    is_free[-7] &= "tool" in fixed
    # Translations first: for them the problem is linear, and where rotations are redundant they would share the error.
    slides = [letter == "P" for letter in one.joint_types]
    translates = np.array([*[False] * 3, *[True] * 3, *slides, *[False] * 3, *[True] * 3])
    for free in (is_free & translates, *[is_free] * MAX_STEPS):
        if found.difference <= EXACT:
            break
        error, J = linearized(found.base, one, found.signs * q + found.offsets, found.tool, target)
        step = np.linalg.lstsq(J * free, -error, rcond=1e-10)[0] * free
        if np.abs(step).max() > LARGEST_STEP:
            break
        X, Y = exp(step[:6]) @ found.base, found.tool @ exp(step[-6:])
        moved = _measured(replace(found, base=X, tool=Y, offsets=found.offsets + step[6:-6]), one, other)
        if moved.difference < found.difference:
            found = moved
        elif free is is_free:
            break
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
