"""Invariants of a mechanism: what no choice of base, tool, joint zero and joint sign can change.

For two neighbouring axes of rotation these are the angle between them and the length of their common normal; for an axis with a
common normal on either side, the distance between the two along the axis. If a joint changes its sign, its axis has the opposite
direction; then the cosine, the mutual moment of two axes and the distance along an axis change their signs. So two mechanisms
can only be equivalent if there are signs of the joints for which all invariants agree. They are found joint by joint, with two
states for each, for many mechanisms at once; no map between the mechanisms is needed.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.tolerances import CLEARLY_NOT_PARALLEL_COS, PARALLEL_TOL_RAD, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import cross
from kinlib.rigid.screw import Line

Booleans = NDArray[np.bool_]
Integers = NDArray[np.int_]


@dataclass(frozen=True, eq=False)
class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance   how far cosines may differ, and lengths on an arm of one metre
    signs_fixed whether the joint signs are fixed
    """

    reference: Chain
    tolerance: float
    signs_fixed: bool = False

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of other mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        axis, point = (np.moveaxis(vectors, (-1, -2), (0, 1)) for vectors in (axis, point))
        u, v = axis[:, self._lines[:-1]], axis[:, self._lines[1:]]
        between = point[:, self._lines[1:]] - point[:, self._lines[:-1]]
        across = _cross(u, v)
        moment = _dot(between, across)
        distance = np.sqrt(np.sum(_cross(between, u) ** 2, axis=0))
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(_dot(across, across), np.finfo(float).tiny)
        start, end = _dot(_cross(between, v), across) / squared_sine, _dot(_cross(between, u), across) / squared_sine
        along = [
            _dot(u[:, i + 1], point[:, self._lines[j]] - point[:, self._lines[i + 1]] + start[j] * u[:, j]) - end[i]
            for i, j in self._runs
        ]
        values: list[ArrayLike] = [_dot(u, v), moment[self._skew], distance[self._parallel], along]
        return np.moveaxis(np.concatenate([np.reshape(value, (-1, *axis.shape[2:])) for value in values]), 0, -1)

    def distances_along(self, values: Array) -> Iterator[tuple[Integers, float, float]]:
        """Yield the parallel joints between two common normals, and the distance of these in the reference and in values (k,)."""
        first = len(self._sines) + len(self._skew) + len(self._parallel)
        for k, (i, j) in enumerate(self._runs, start=first):
            yield self._lines[i + 1 : j + 1], float(self._values[k]), float(values[k])

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs."""
        violated = np.abs(values - self._values) > self._tolerances
        if not self.signs_fixed:
            violated &= np.abs(values + self._values) > self._tolerances
        return violated

    def agree(self, values: Array) -> Booleans:
        """Return for which mechanisms (...) all invariants (..., k) agree for one choice of the joint signs."""
        same = np.abs(values - self._values) <= self._tolerances
        if self.signs_fixed:
            return _all(same)
        opposite = np.abs(values + self._values) <= self._tolerances
        possible = _all(~self.violated(values))
        # Which of the two signs of a line can be reached from the lines before it.
        plus, minus = possible, possible
        for line in range(len(self._lines)):
            if line:
                pair = [k for k, lines in enumerate(self._sign_of) if lines == (line - 1, line)]
                keep, change = _all(same[..., pair]), _all(opposite[..., pair])
                plus, minus = (plus & keep) | (minus & change), (plus & change) | (minus & keep)
            own = [k for k, lines in enumerate(self._sign_of) if lines == (line,)]
            plus, minus = plus & _all(same[..., own]), minus & _all(opposite[..., own])
        return plus | minus

    @cached_property
    def _lines(self) -> Integers:
        """The joints whose axes are lines; a prismatic joint has only a direction."""
        return np.array([k for k, letter in enumerate(self.reference.joint_types) if letter != "P"], dtype=int)

    @cached_property
    def _sines(self) -> Array:
        axis = self.reference.lines.axis[self._lines]
        sines: Array = np.linalg.norm(cross(axis[:-1], axis[1:]), axis=-1)
        return sines

    @cached_property
    def _adjacent(self) -> list[int]:
        """The pairs of lines of neighbouring joints: a prismatic joint between two lines may change their distance."""
        return np.flatnonzero(np.diff(self._lines) == 1).tolist()

    @cached_property
    def _skew(self) -> list[int]:
        """The adjacent pairs of lines that are clearly not parallel."""
        return [k for k in self._adjacent if self._sines[k] > np.sqrt(1 - CLEARLY_NOT_PARALLEL_COS**2)]

    @cached_property
    def _parallel(self) -> list[int]:
        """The adjacent pairs of parallel lines. The distance of nearly parallel ones depends on the last digits."""
        return [k for k in self._adjacent if self._sines[k] < SAME_DISTANCE_RAD]

    @cached_property
    def _runs(self) -> list[tuple[int, int]]:
        """The pairs i < j between which all lines are parallel: the two normals are a fixed distance apart along these lines.

        A helical joint changes this distance with its zero.
        """
        types = self.reference.joint_types
        return [
            (i, j)
            for i, j in combinations(self._skew, 2)
            if set(range(i + 1, j)) <= set(self._parallel)
            and set(types[self._lines[i + 1] : self._lines[j] + 1]) == {"R"}
        ]

    @cached_property
    def _sign_of(self) -> list[tuple[int, ...]]:
        """The lines whose signs decide the sign of an invariant; the first ones only, as the others are compared without sign."""
        pairs = [*range(len(self._sines)), *self._skew]
        return [*((k, k + 1) for k in pairs), *(() for _ in self._parallel), *((i + 1,) for i, _ in self._runs)]

    @cached_property
    def _tolerances(self) -> Array:
        length = self.tolerance * (1 + float(np.ptp(self.reference.joint_points, axis=0).max()))
        along = [length / min(self._sines[i], self._sines[j]) ** 2 for i, j in self._runs]
        counted = [
            (self.tolerance, len(self._sines)),
            (length, len(self._skew) + len(self._parallel)),
            *((tolerance, 1) for tolerance in along),
        ]
        return np.repeat([tolerance for tolerance, _ in counted], [count for _, count in counted])

    @cached_property
    def _values(self) -> Array:
        return self.of(self.reference.lines.axis, self.reference.joint_points)


class Neighbours(NamedTuple):
    """How each axis of an arm lies to the next one, (n - 1,) each: the sine of the angle between them, the acute angle in radians,
    and the length of their common normal in metres.
    """

    sine: Array
    angle: Array
    distance: Array


def neighbours(lines: Line) -> Neighbours:
    """Compute the angles and the distances of neighbouring axes.

    >>> from kinlib.chains.robots import youbot
    >>> neighbours(youbot().lines).distance
    array([0.033, 0.155, 0.135, 0.   ])
    """
    u, v, between = lines.axis[:-1], lines.axis[1:], np.diff(lines.point, axis=0)
    normal = cross(u, v)
    sine = np.linalg.norm(normal, axis=-1)
    is_parallel = sine <= PARALLEL_TOL_RAD
    along_normal = np.abs(np.sum(between * normal, axis=-1)) / np.where(is_parallel, 1.0, sine)
    distance = np.where(is_parallel, np.linalg.norm(cross(between, u), axis=-1), along_normal)
    return Neighbours(sine, np.arctan2(sine, np.abs(np.sum(u * v, axis=-1))), distance)


def _all(values: Booleans) -> Booleans:
    result: Booleans = np.logical_and.reduce(values, axis=-1)
    return result


def _cross(u: Array, v: Array) -> Array:
    return cross(u.T, v.T).T


def _dot(u: Array, v: Array) -> Array:
    products: Array = np.sum(u * v, axis=0)
    return products
