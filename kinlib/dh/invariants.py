"""Invariants of a mechanism: what no choice of base, tool, joint zero and joint sign can change.

Two neighbouring axes u, v have the cosine u . v; two that are lines have the mutual moment, the distance along u x v, or, if they are
parallel, their distance; and an axis with a common normal on either side has the distance between these two along the axis. If a
joint changes its sign, its axis has the opposite direction, and then these numbers change their signs: the cosine and the moment
with the sign of either axis, the distance along an axis with the sign of that axis. Two mechanisms can only be equivalent if some
signs of the joints make all invariants agree.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import CLEARLY_NOT_PARALLEL_COS, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import cross

Booleans = NDArray[np.bool_]

MAX_JOINTS = 9
"""Of so many joints all signs are tried, and of more joints at most two with the sign -1."""


@dataclass(frozen=True, eq=False)
class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance   how far cosines may differ, and lengths on an arm of one metre
    """

    reference: Chain
    tolerance: float

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        u, v, between = axis[..., :-1, :], axis[..., 1:, :], np.diff(point, axis=-2)
        across = cross(u, v)
        moment, distance = _dot(between, across), np.linalg.norm(cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(_dot(across, across), np.finfo(float).tiny)
        start, end = _dot(cross(between, v), across) / squared_sine, _dot(cross(between, u), across) / squared_sine
        i, j = np.array(self._runs, dtype=int).reshape(-1, 2).T
        foot = point[..., j, :] + start[..., j, None] * axis[..., j, :] - point[..., i + 1, :]
        along = _dot(axis[..., i + 1, :], foot) - end[..., i]
        parts = [_dot(u, v), moment[..., self._skew], distance[..., self._parallel], along]
        return np.concatenate(parts, axis=-1)

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs."""
        violated: Booleans = np.abs(np.abs(values) - np.abs(self._values)) > self._tolerances
        return violated

    def agree(self, values: Array, signs_are_fixed: bool = False) -> Booleans:
        """Return for which mechanisms (N,) all invariants (N, k) agree for one choice of the joint signs."""
        if signs_are_fixed:
            return np.asarray(np.all(np.abs(values - self._values) <= self._tolerances, axis=-1))
        possible = np.all(~self.violated(values), axis=-1)
        return np.array([each and len(self.sign_patterns(own)) > 0 for each, own in zip(possible, values, strict=True)])

    def sign_patterns(self, values: Array) -> Array:
        """Return all signs of the joints (P, n) for which all invariants (k,) agree, those with the fewest -1 first."""
        agree = np.abs(self._factors * values - self._values) <= self._tolerances
        return self._patterns[agree.all(axis=1)]

    @cached_property
    def _patterns(self) -> Array:
        n = self.reference.n
        flips = [flip for count in range(n + 1 if n <= MAX_JOINTS else 3) for flip in combinations(range(n), count)]
        return np.array([[-1.0 if joint in flip else 1.0 for joint in range(n)] for flip in flips])

    @cached_property
    def _factors(self) -> Array:
        """The sign of each invariant for each pattern (P, k); distances of parallel lines have none."""
        s = self._patterns
        pairs, along = s[:, :-1] * s[:, 1:], s[:, [i + 1 for i, _ in self._runs]]
        return np.hstack([pairs, pairs[:, self._skew], np.ones((len(s), len(self._parallel))), along])

    @cached_property
    def _sines(self) -> Array:
        axis = self.reference.lines.axis
        sines: Array = np.linalg.norm(cross(axis[:-1], axis[1:]), axis=-1)
        return sines

    def _pairs_of_lines(self, has_angle: Booleans) -> list[int]:
        """The pairs (k, k + 1) of axes at some angles, without those of a prismatic joint, which has no line."""
        types = self.reference.joint_types
        return [k for k in np.flatnonzero(has_angle).tolist() if "P" not in types[k : k + 2]]

    @cached_property
    def _skew(self) -> list[int]:
        return self._pairs_of_lines(self._sines > np.sqrt(1 - CLEARLY_NOT_PARALLEL_COS**2))

    @cached_property
    def _parallel(self) -> list[int]:
        """The pairs of parallel lines. The distance of nearly parallel ones depends on the last digits."""
        return self._pairs_of_lines(self._sines < SAME_DISTANCE_RAD)

    @cached_property
    def _runs(self) -> list[tuple[int, int]]:
        """The pairs i < j between which all lines are parallel: the two normals are a fixed distance apart along these lines.

        A helical joint changes this distance with its zero.
        """
        runs = []
        for i, j in combinations(self._skew, 2):
            if {*range(i + 1, j)} <= {*self._parallel} and {*self.reference.joint_types[i + 1 : j + 1]} == {"R"}:
                runs.append((i, j))
        return runs

    @cached_property
    def _tolerances(self) -> Array:
        length = self.tolerance * (1 + float(np.ptp(self.reference.joint_points, axis=0).max()))
        along = [length / min(self._sines[i], self._sines[j]) ** 2 for i, j in self._runs]
        return np.array([self.tolerance] * len(self._sines) + [length] * len(self._skew + self._parallel) + along)

    @cached_property
    def _values(self) -> Array:
        return self.of(self.reference.lines.axis, self.reference.joint_points)


def _dot(u: Array, v: Array) -> Array:
    products: Array = np.sum(u * v, axis=-1)
    return products
