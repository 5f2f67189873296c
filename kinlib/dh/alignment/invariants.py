"""The invariants of neighbouring joint axes, which decide the signs of the joints and refute most other mechanisms.

Two neighbouring axes u, v have the cosine u . v; two that are lines have the mutual moment, the distance along u x v, or, if they are
parallel, their distance; and an axis with a common normal on either side has the distance between these two along the axis. If a joint
changes its sign, its axis has the opposite direction: the cosine and the moment change their signs with that of either axis, the
distance along an axis with that of the axis.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.tolerances import CLEARLY_NOT_PARALLEL_COS, PARALLEL_TOL_RAD, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import cross

Booleans = NDArray[np.bool_]


def neighbours(chain: Chain) -> tuple[Array, Array, Array]:
    """Compute the sine of the angle between each axis and the next, the acute angle, and the length of their normal, (n - 1,) each."""
    u, v, between = chain.lines.axis[:-1], chain.lines.axis[1:], np.diff(chain.joint_points, axis=0)
    normal = cross(u, v)
    sine = np.linalg.norm(normal, axis=-1)
    along_normal = np.abs(_dot(between, normal)) / np.maximum(sine, PARALLEL_TOL_RAD)
    distance = np.where(sine <= PARALLEL_TOL_RAD, np.linalg.norm(cross(between, u), axis=-1), along_normal)
    return sine, np.arctan2(sine, np.abs(_dot(u, v))), distance


class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance   how far cosines may differ, and lengths on an arm of one metre
    """

    def __init__(self, reference: Chain, tolerance: float) -> None:
        types, n, sines = reference.joint_types, reference.n, neighbours(reference)[0]
        has_lines = np.array(["P" not in types[k : k + 2] for k in range(n - 1)], dtype=bool)
        self._skew = np.flatnonzero(has_lines & (sines > np.sqrt(1 - CLEARLY_NOT_PARALLEL_COS**2)))
        # The distance of nearly parallel lines depends on the last digits.
        self._parallel = np.flatnonzero(has_lines & (sines < SAME_DISTANCE_RAD))
        # Between two normals all lines are parallel. A helical joint changes the distance of the normals with its zero.
        parallel, pairs = {*self._parallel.tolist()}, combinations(self._skew.tolist(), 2)
        runs = [(i, j) for i, j in pairs if {*range(i + 1, j)} <= parallel and {*types[i + 1 : j + 1]} == {"R"}]
        self._runs = np.array(runs, dtype=int).reshape(-1, 2).T
        length = tolerance * (1 + float(np.ptp(reference.joint_points, axis=0).max()))
        lengths = np.full(len(self._skew) + len(self._parallel), length)
        along = length / sines[self._runs].min(axis=0, initial=1.0) ** 2
        self._tolerances = np.concatenate([np.full(n - 1, tolerance), lengths, along])
        # Of more than nine joints at most two may have the sign -1.
        flips = [flip for count in range(n + 1 if n <= 9 else 3) for flip in combinations(range(n), count)]
        self._patterns = s = np.array([np.where(np.isin(np.arange(n), flip), -1.0, 1.0) for flip in flips])
        of_pairs = s[:, :-1] * s[:, 1:]
        no_sign = np.ones((len(s), len(self._parallel)))
        self._factors = np.hstack([of_pairs, of_pairs[:, self._skew], no_sign, s[:, self._runs[0] + 1]])
        self._values = self.of(reference.lines.axis, reference.joint_points)

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        u, v, between = axis[..., :-1, :], axis[..., 1:, :], np.diff(point, axis=-2)
        across = cross(u, v)
        moment, distance = _dot(between, across), np.linalg.norm(cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(_dot(across, across), np.finfo(float).tiny)
        start, end = _dot(cross(between, v), across) / squared_sine, _dot(cross(between, u), across) / squared_sine
        i, j = self._runs
        foot = point[..., j, :] + start[..., j, None] * axis[..., j, :] - point[..., i + 1, :]
        along = _dot(axis[..., i + 1, :], foot) - end[..., i]
        return np.concatenate([_dot(u, v), moment[..., self._skew], distance[..., self._parallel], along], axis=-1)

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


def _dot(u: Array, v: Array) -> Array:
    products: Array = np.sum(u * v, axis=-1)
    return products
