"""Invariants of a mechanism: what no choice of base, tool, joint zero and joint sign can change.

For two neighbouring axes these are the angle between them and the length of their common normal; for an axis with a common
normal on either side, the distance between the two along the axis. If a joint changes its sign, its axis has the opposite
direction; then the cosine, the mutual moment of two axes and the distance along an axis change their signs. So two mechanisms
can only be equivalent if there are signs of the joints for which all invariants agree. They are found joint by joint, with two
states for each, for many mechanisms at once; no map between the mechanisms is needed.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import CLEARLY_NOT_PARALLEL_COS, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import Convention, dh_transform

Booleans = NDArray[np.bool_]


def joint_axes(rows: Array, *, convention: Convention, joints: str, signs: Array) -> tuple[Array, Array]:
    """Compute the joint axes of many tables at once, in frame 0 with every joint at 0.

    rows (..., m, 4), joints and signs with one entry for each row -> directions (..., n, 3) and a point on each axis (..., n, 3).

    >>> rows = np.array([[0.4, 0.0, 0.0, 0.0], [0.3, 0.0, 0.0, 0.0]])
    >>> joint_axes(rows, convention="standard", joints="RR", signs=np.ones(2))[1].tolist()
    [[0.0, 0.0, 0.0], [0.4, 0.0, 0.0]]
    """
    links = np.moveaxis(dh_transform(*np.moveaxis(rows, -1, 0), convention=convention), -3, 0)
    frames = [np.broadcast_to(np.eye(4), links.shape[1:])]
    for link in links:
        frames.append(frames[-1] @ link)
    # In the standard convention joint i moves about the z before its row, in the modified one about the z after it.
    first = 0 if convention == "standard" else 1
    moving = [row for row, letter in enumerate(joints) if letter != "F"]
    at_joints = np.stack([frames[row + first] for row in moving], axis=-3)
    return at_joints[..., :3, 2] * signs[moving, None], at_joints[..., :3, 3]


@dataclass(frozen=True, eq=False)
class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance         how far cosines may differ, and lengths on an arm of one metre
    signs_are_free    whether joints may have the opposite sign

    >>> from kinlib.chains.robots import puma560
    >>> arm = AxisInvariants(puma560(), 1e-7)
    >>> bool(arm.agree(arm.of(puma560().lines.axis, puma560().joint_points)))
    True
    """

    reference: Chain
    tolerance: float
    signs_are_free: bool = True

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of other mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        u, v = axis[..., :-1, :], axis[..., 1:, :]
        between = point[..., 1:, :] - point[..., :-1, :]
        across = np.cross(u, v)
        moment = np.sum(between * across, axis=-1)
        distance = np.linalg.norm(np.cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(np.sum(across**2, axis=-1), np.finfo(float).tiny)
        start = np.sum(np.cross(between, v) * across, axis=-1) / squared_sine
        end = np.sum(np.cross(between, u) * across, axis=-1) / squared_sine
        along = [
            np.sum(u[..., i + 1, :] * (point[..., j, :] - point[..., i + 1, :]), axis=-1)
            + start[..., j] * np.sum(u[..., i + 1, :] * u[..., j, :], axis=-1)
            - end[..., i]
            for i, j in self._runs
        ]
        triples = [(axis[..., k - 1, :], axis[..., k, :], axis[..., k + 1, :]) for k in self._prismatic]
        turned = [
            value
            for before, here, after in triples
            for value in (np.sum(before * after, axis=-1), np.sum(np.cross(before, here) * after, axis=-1))
        ]
        pairs = np.concatenate(
            [np.sum(u * v, axis=-1), moment[..., self._skew], distance[..., self._parallel]], axis=-1
        )
        return np.concatenate([pairs, *(np.asarray(value)[..., None] for value in along + turned)], axis=-1)

    def distances_along(self, values: Array) -> Iterator[tuple[range, float, float]]:
        """Yield the parallel joints between two common normals, and the distance of these in the reference and in values (k,)."""
        first = self.reference.n - 1 + len(self._skew) + len(self._parallel)
        for k, (i, j) in enumerate(self._runs, start=first):
            yield range(i + 1, j + 1), float(self._values[k]), float(values[k])

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs."""
        violated = np.abs(values - self._values) > self._tolerances
        if self.signs_are_free:
            violated &= np.abs(values + self._values) > self._tolerances
        return violated

    def agree(self, values: Array) -> Booleans:
        """Return for which mechanisms (...) all invariants (..., k) agree for one choice of the joint signs."""
        same = np.abs(values - self._values) <= self._tolerances
        if not self.signs_are_free:
            return same.all(axis=-1)
        opposite = np.abs(values + self._values) <= self._tolerances
        everything = np.ones(values.shape[:-1], bool)
        joints: dict[tuple[int, ...], list[Booleans]] = {}
        for k, key in enumerate(self._sign_of):
            keep, change = joints.setdefault(key, [everything.copy(), everything.copy()])
            keep &= same[..., k]
            change &= opposite[..., k] | (same[..., k] if not key else False)
        free = [everything, everything]
        # Which of the two signs of a joint can be reached from the joints before it.
        plus, minus = everything & joints.get((), free)[1], everything & joints.get((), free)[1]
        for joint in range(self.reference.n):
            if joint:
                keep, change = joints[joint - 1, joint]
                plus, minus = (plus & keep) | (minus & change), (plus & change) | (minus & keep)
            keep, change = joints.get((joint,), free)
            plus, minus = plus & keep, minus & change
        return plus | minus

    @cached_property
    def _sines(self) -> Array:
        axis = self.reference.lines.axis
        return np.linalg.norm(np.cross(axis[:-1], axis[1:]), axis=-1)

    @cached_property
    def _skew(self) -> list[int]:
        """The pairs of revolute axes that are clearly not parallel, so that their common normal is well defined."""
        axis = self.reference.lines.axis
        clear = np.abs(np.sum(axis[:-1] * axis[1:], axis=-1)) < CLEARLY_NOT_PARALLEL_COS
        return [k for k in range(self.reference.n - 1) if clear[k] and "P" not in self.reference.joint_types[k : k + 2]]

    @cached_property
    def _parallel(self) -> list[int]:
        """The pairs of parallel revolute axes. The distance of nearly parallel ones depends on the last digits."""
        types = self.reference.joint_types
        return [k for k, sine in enumerate(self._sines) if sine < SAME_DISTANCE_RAD and "P" not in types[k : k + 2]]

    @cached_property
    def _runs(self) -> list[tuple[int, int]]:
        """The pairs i < j between which all axes are parallel: the two normals are a fixed distance apart along these axes.

        A helical joint changes this distance with its zero.
        """
        between = [(i, j, range(i + 1, j)) for i in self._skew for j in self._skew if i < j]
        return [
            (i, j)
            for i, j, pairs in between
            if set(pairs) <= set(self._parallel) and "H" not in self.reference.joint_types[i + 1 : j + 1]
        ]

    @cached_property
    def _prismatic(self) -> list[int]:
        """The prismatic joints between two others, about which the neighbours cannot be rotated."""
        return [k for k in range(1, self.reference.n - 1) if self.reference.joint_types[k] == "P"]

    @cached_property
    def _sign_of(self) -> list[tuple[int, ...]]:
        """The joints whose signs decide the sign of an invariant; empty where only its absolute value is compared."""
        return [
            *((k, k + 1) for k in range(self.reference.n - 1)),
            *((k, k + 1) for k in self._skew),
            *(() for _ in self._parallel),
            *((i + 1,) for i, _ in self._runs),
            *(() for _ in self._prismatic for _ in range(2)),
        ]

    @cached_property
    def _tolerances(self) -> Array:
        length = self.tolerance * (1 + float(np.ptp(self.reference.joint_points, axis=0).max()))
        pairs = [self.tolerance] * (self.reference.n - 1) + [length] * (len(self._skew) + len(self._parallel))
        along = [length / min(self._sines[i], self._sines[j]) ** 2 for i, j in self._runs]
        return np.array([*pairs, *along, *[self.tolerance] * (2 * len(self._prismatic))])

    @cached_property
    def _values(self) -> Array:
        return self.of(self.reference.lines.axis, self.reference.joint_points)
