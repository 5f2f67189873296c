"""How two descriptions of a mechanism are aligned: the invariants of their axes decide the signs, and least squares the rest.

Two neighbouring axes u, v have the cosine u . v; two that are lines have the mutual moment, the distance along u x v, or, if they are
parallel, their distance; and an axis with a common normal on either side has the distance between these two along the axis. If a joint
changes its sign, its axis has the opposite direction: the cosine and the moment change their signs with that of either axis, the
distance along an axis with that of the axis.

The offsets follow from the directions. Between each axis and the next there is a direction x as in a DH table: the cross product of the
axes, which changes its sign with that of either, or the way from an axis to a parallel one. With the angle theta_k about axis k from
the x before it to the x after it, theta_k(b) + q = s (theta_k(a) + s q + c), plus half a turn if one of the two x changes its sign.
What remains, base, tool and the zeros of prismatic joints, is linear, so a least-squares step on the poses finds it.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import PARALLEL_TOL_RAD, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.common_normal import frame_axes
from kinlib.dh.slips import CHOICES
from kinlib.rigid.lie import adjoint, cross, exp, homogeneous, inverse, perpendicular, vee, wrap_angle

Booleans = NDArray[np.bool_]


def neighbours(chain: Chain) -> tuple[Array, Array]:
    """Compute the acute angle between each axis and the next, and the length of their normal, (n - 1,) each."""
    u, v, between = chain.lines.axis[:-1], chain.lines.axis[1:], np.diff(chain.joint_points, axis=0)
    normal = cross(u, v)
    sine = np.linalg.norm(normal, axis=-1)
    along_normal = np.abs(np.vecdot(between, normal)) / np.maximum(sine, PARALLEL_TOL_RAD)
    distance = np.where(sine <= PARALLEL_TOL_RAD, np.linalg.norm(cross(between, u), axis=-1), along_normal)
    return np.arctan2(sine, np.abs(np.vecdot(u, v))), distance


class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance  how far cosines may differ, and lengths on an arm of one metre
    """

    def __init__(self, reference: Chain, tolerance: float) -> None:
        types, n, sines = reference.joint_types, reference.n, np.sin(neighbours(reference)[0])
        has_lines = np.array(["P" not in types[k : k + 2] for k in range(n - 1)], dtype=bool)
        is_skew = has_lines & (sines > 0.14)
        # The distance of nearly parallel lines depends on the last digits.
        is_parallel = has_lines & (sines < max(SAME_DISTANCE_RAD, min(0.01 * tolerance, 1e-4)))
        # Between two normals all lines are parallel. A helical joint changes the distance of the normals with its zero.
        pairs = combinations(np.flatnonzero(is_skew).tolist(), 2)
        runs = [(i, j) for i, j in pairs if is_parallel[i + 1 : j].all() and {*types[i + 1 : j + 1]} == {"R"}]
        self._runs = np.array(runs, dtype=int).reshape(-1, 2).T
        length = tolerance * (1 + float(np.ptp(reference.joint_points, axis=0).max()))
        moments, distances = (np.where(is_there, length, np.inf) for is_there in (is_skew, is_parallel))
        along = length / sines[self._runs].min(axis=0, initial=1.0) ** 2
        self._tolerances = np.concatenate([np.full(n - 1, tolerance), moments, distances, along])
        # Of more than nine joints at most two may have the sign -1.
        flips = [flip for count in range(n + 1 if n <= 9 else 3) for flip in combinations(range(n), count)]
        self._patterns = s = np.array([[-1.0 if k in flip else 1.0 for k in range(n)] for flip in flips])
        of_pairs = s[:, :-1] * s[:, 1:]
        self._factors = np.hstack([of_pairs, of_pairs, of_pairs**2, s[:, self._runs[0] + 1]])  # a distance has no sign
        self._values = self.of(reference.lines.axis, reference.joint_points)

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        u, v, between = axis[..., :-1, :], axis[..., 1:, :], np.diff(point, axis=-2)
        across = cross(u, v)
        moment, distance = np.vecdot(between, across), np.linalg.norm(cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(np.vecdot(across, across), np.finfo(float).tiny)
        start, end = (
            np.vecdot(cross(between, v), across) / squared_sine,
            np.vecdot(cross(between, u), across) / squared_sine,
        )
        i, j = self._runs
        foot = point[..., j, :] + start[..., j, None] * axis[..., j, :] - point[..., i + 1, :]
        along = np.vecdot(axis[..., i + 1, :], foot) - end[..., i]
        return np.concatenate([np.vecdot(u, v), moment, distance, along], axis=-1)

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs."""
        violated: Booleans = np.abs(np.abs(values) - np.abs(self._values)) > self._tolerances
        return violated

    def agree(self, values: Array, signs_are_fixed: bool = False) -> Booleans:
        """Return for which mechanisms (N,) all invariants (N, k) agree; each for some choice of signs, unless these are fixed."""
        off = np.abs(values - self._values) > self._tolerances if signs_are_fixed else self.violated(values)
        return np.asarray(~off.any(axis=-1))

    def sign_patterns(self, values: Array) -> tuple[Array, Array]:
        """Return all signs of the joints (P, n) for which all invariants (k,) agree, and how far they do, at most 1 (P,)."""
        off = (np.abs(self._factors * values - self._values) / self._tolerances).max(axis=1, initial=0.0)
        return self._patterns[off <= 1], off[off <= 1]


COMPARED_CONFIGURATIONS, MAX_STARTS = 16, 8
"""At how many random configurations chains are compared, and with how many choices of the signs a search for maps begins."""

SEARCHED_AS_PARALLEL_RAD = 2e-5
"""Axes at a smaller angle are searched as parallel ones."""


@dataclass(frozen=True, eq=False, repr=False)
class Map:
    """A map from a chain a to a chain b, X T_a(s q + c) Y, and the largest difference of its poses from T_b(q); inf if there is none."""

    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    base: Array = field(default_factory=lambda: np.eye(4))
    tool: Array = field(default_factory=lambda: np.eye(4))
    difference: float = np.inf


def nearest_maps(one: Chain, other: Chain, fixed: frozenset[str], tolerance: float, loose: float) -> list[Map]:
    """Find maps from one chain to another with the same joint types whose axes agree to within `loose`, in metres and radians.

    The first map changes nothing. Unless that is enough, to within the tolerance, the search for others begins with the choices of the
    signs with which the axes agree best and the fewest choices change.
    """
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    target = other.fk(q)
    found = [Map(np.ones(one.n), np.zeros(one.n), difference=largest_difference(target, one.fk(q)))]
    if found[0].difference <= tolerance or fixed >= {*CHOICES}:
        return found
    invariants = AxisInvariants(other, 100 * loose)
    s, off = invariants.sign_patterns(invariants.of(one.lines.axis, one.joint_points))
    offsets, R = _rotated(one, other, s, fixed, loose / 2)
    is_constant = np.array([letter == "P" or "zeros" in fixed for letter in one.joint_types])
    admitted: Booleans = np.asarray((np.abs(offsets[:, is_constant]) < 0.1).all(axis=1))
    admitted &= (s > 0).all(axis=1) | ("signs" not in fixed)
    for end, joint, A, B in (("base", 0, np.eye(3), np.eye(3)), ("tool", -1, one.home[:3, :3], other.home[:3, :3])):
        if end in fixed:
            off_axis = s[:, [joint]] * (one.lines.axis[joint] @ A) - other.lines.axis[joint] @ B
            admitted &= np.linalg.norm(off_axis, axis=1) <= 100 * loose
    offsets[:, is_constant] = 0.0
    zeros = (np.abs(offsets) > max(loose, SAME_DISTANCE_RAD)).sum(axis=1)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    # The zero of the first joint is a motion of the base, and that of the last one a motion of the tool.
    is_free[6] &= "base" in fixed
    is_free[-7] &= "tool" in fixed
    for k in [k for k in np.lexsort((zeros, (s < 0).sum(axis=1) + zeros, off > 0.01)) if admitted[k]][:MAX_STARTS]:
        X = homogeneous(R[k], np.zeros(3))
        Y = np.eye(4) if "tool" in fixed else inverse(X @ one.fk(offsets[k])) @ other.home
        starts = [fitted(one, s[k] * q + offsets[k], X, Y, target, lambda _: is_free, steps) for steps in (0, 7)]
        maps = (Map(s[k], offsets[k] + change, X, Y, difference) for X, change, Y, difference in starts)
        found.append(min(maps, key=lambda each: each.difference))
        if len(found) > 4 and min(each.difference for each in found[1:]) <= loose:  # of several, one is described best
            break
    return found


def _rotated(one: Chain, other: Chain, s: Array, fixed: frozenset[str], near: float) -> tuple[Array, Array]:
    """Compute the offsets (P, n) and the rotation of the base (P, 3, 3) with which all directions agree, for signs s (P, n)."""
    z, points = np.array([one.lines.axis, other.lines.axis]), np.array([one.joint_points, other.joint_points])
    joints, plus = list[int](), np.ones(len(s))
    for k, letter in enumerate(one.joint_types):
        is_parallel = bool(joints) and not _are_skew(z[:, joints[-1:]], z[:, [k]])
        if is_parallel and one.joint_types[joints[-1]] == "P":  # it does not rotate, so the other one says as much
            joints[-1] = k
        elif not (is_parallel and letter == "P"):
            joints.append(k)
    # The directions x, (2, 3) each, and their signs (P,): before the first axis, between each axis and the next, after the last.
    in_tool = perpendicular(z[1, joints[-1]] @ other.home[:3, :3])
    of_tool = np.array([arm.home[:3, :3] @ in_tool for arm in (one, other)])
    of_base = np.tile(perpendicular(z[1, joints[0]]), (2, 1))
    xs = [(of_base, plus) if "base" in fixed else None]
    for i, j in pairwise(joints):
        u, v, way = z[:, i], z[:, j], points[:, j] - points[:, i]
        across = cross(cross(u, way), u)
        is_apart = bool((np.linalg.norm(across, axis=1) > near).all())
        xs.append((cross(u, v), s[:, i] * s[:, j]) if _are_skew(u, v) else (across, plus) if is_apart else None)
    xs.append((of_tool, plus) if "tool" in fixed else None)
    # Where there is none, the joints after it do not rotate, and at the end those before it.
    known = [each for each in xs if each] or [(of_base, plus)]
    filled = [next((each for each in xs[k:] if each), known[-1]) for k in range(len(xs))]
    x, e = np.stack([each[0] for each in filled], axis=1), np.stack([each[1] for each in filled], axis=1)
    u, sign = z[:, joints], s[:, joints]
    before, after = x[:, :-1], x[:, 1:]
    cosine = np.vecdot(before, after) - np.vecdot(before, u) * np.vecdot(after, u)
    theta = np.arctan2(np.vecdot(cross(before, after), u), cosine)
    offsets = np.zeros(s.shape)
    offsets[:, joints] = wrap_angle(sign * theta[1] - theta[0] + np.pi * (e[:, :-1] != e[:, 1:]))
    R = frame_axes(x[1, 0], u[1, 0]) @ np.swapaxes(frame_axes(e[:, :1] * x[0, 0], sign[:, :1] * u[0, 0]), -1, -2)
    return offsets, np.tile(np.eye(3), (len(s), 1, 1)) if "base" in fixed else R


def _are_skew(u: Array, v: Array) -> bool:
    """Whether the axes u, v (2, 3) of both chains are so far from parallel that their cross products have digits."""
    return bool((np.linalg.norm(cross(u, v), axis=-1) > SEARCHED_AS_PARALLEL_RAD).all())


def fitted(  # noqa: PLR0917
    chain: Chain, values: Array, X: Array, Y: Array, target: Array, scale: Callable[[Array], Array], steps: int
) -> tuple[Array, Array, Array, float]:
    """Fit the poses X T(values + change) Y to a target by least-squares steps: X, change (n,), Y and the largest difference left.

    values (N, n), target (N, 4, 4). The scale (6 + n + 6,) of X, the changes and Y, of the changes so far: 0 is fixed, large is cheap.
    The error is the small twist of target^-1 X T Y; with M = X T Y and the body Jacobian J of the chain, it changes by
    Ad(M^-1) dX + Ad(Y^-1) J dvalues + dY.
    """
    change = np.zeros(chain.n)
    M = X @ chain.fk(values) @ Y
    for _ in range(steps):
        E = inverse(target) @ M
        R = E[..., :3, :3]
        error = np.concatenate([vee((R - np.swapaxes(R, -1, -2)) / 2), E[..., :3, 3]], axis=-1).ravel()
        by_values = adjoint(inverse(Y)) @ chain.body_jacobian(values + change)
        by_tool = np.broadcast_to(np.eye(6), (len(values), 6, 6))
        J = np.concatenate([adjoint(inverse(M)), by_values, by_tool], axis=-1).reshape(error.size, -1)
        weights = scale(change)
        step = np.linalg.lstsq(J * weights, J[:, 6:-6] @ change - error, rcond=1e-10)[0] * weights
        is_done = np.abs(step - np.pad(change, 6)).max() < 1e-13
        if is_done or not np.abs(step).max() < 1e3:  # or it diverges
            break
        X, Y, change = exp(step[:6]) @ X, Y @ exp(step[-6:]), step[6:-6]
        M = X @ chain.fk(values + change) @ Y
    return X, change, Y, largest_difference(target, M)
