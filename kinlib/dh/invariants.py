"""Invariants of a mechanism: what no choice of base, tool, joint zero and joint sign can change.

Two neighbouring axes of rotation u, v have the cosine u . v and the mutual moment, the distance along u x v; parallel axes have
their distance instead; and an axis with a common normal on either side has the distance between these two along the axis. If a
joint changes its sign, its axis has the opposite direction, and then these numbers change their signs: the cosine and the moment
with the sign of either axis, the distance along an axis with the sign of that axis. Two mechanisms can only be equivalent if some
signs of the joints make all invariants agree.

For example, two arms whose cosines are (0.5, 0) and (-0.5, 0) agree if joint 1 has the opposite sign, or joints 2 and 3 have.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, pairwise, product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays.tolerances import CLEARLY_NOT_PARALLEL_COS, SAME_DISTANCE_RAD
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import cross

Booleans = NDArray[np.bool_]

MAX_LINES = 10
"""Of so many axes all signs are tried."""


@dataclass(frozen=True, eq=False)
class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    tolerance   how far cosines may differ, and lengths on an arm of one metre
    """

    reference: Chain
    tolerance: float

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of other mechanisms, directions and points of their axes (..., n, 3) each -> (..., k)."""
        u, v = axis[..., self.lines[:-1], :], axis[..., self.lines[1:], :]
        between = point[..., self.lines[1:], :] - point[..., self.lines[:-1], :]
        across = cross(u, v)
        cosine, moment = _dot(u, v), _dot(between, across)
        distance = np.linalg.norm(cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(_dot(across, across), np.finfo(float).tiny)
        start, end = _dot(cross(between, v), across) / squared_sine, _dot(cross(between, u), across) / squared_sine
        along: list[ArrayLike] = []
        for i, j in self._runs:
            own, to = axis[..., self.lines[i + 1], :], point[..., self.lines[j], :] - point[..., self.lines[i + 1], :]
            along.append((_dot(own, to + start[..., [j]] * u[..., j, :]) - end[..., i])[..., None])
        return np.concatenate([cosine, moment[..., self._skew], distance[..., self._parallel], *along], axis=-1)

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs."""
        same, opposite = self._compared(values)
        return ~(same | opposite)

    def agree(self, values: Array, signs_are_fixed: bool = False) -> Booleans:
        """Return for which mechanisms (...) all invariants (..., k) agree for one choice of the joint signs."""
        same, opposite = self._compared(values)
        if signs_are_fixed:
            return _all(same)
        possible = _all(same | opposite)
        plus = minus = possible  # whether each of the two signs of a line can be reached from the lines before it
        for line in range(len(self.lines)):
            if line:
                pair = self._with_sign_of((line - 1, line))
                keep, change = _all(same[..., pair]), _all(opposite[..., pair])
                plus, minus = (plus & keep) | (minus & change), (plus & change) | (minus & keep)
            own = self._with_sign_of((line,))
            plus, minus = plus & _all(same[..., own]), minus & _all(opposite[..., own])
        return plus | minus

    def sign_choices(self, values: Array) -> list[Array]:
        """Return signs (n,) of the joints for which all invariants (k,) agree: for each first and last one, those with fewest -1.

        A prismatic joint, whose axis is no line, has the sign 1. Of more than MAX_LINES lines, those with at most two -1 are tried.
        """
        count = len(self.lines)
        if count <= MAX_LINES:
            patterns = np.array([*product((1.0, -1.0), repeat=count)]).reshape(2**count, count)
        else:
            flips = [(), *((i,) for i in range(count)), *combinations(range(count), 2)]
            patterns = np.array([[-1.0 if i in flip else 1.0 for i in range(count)] for flip in flips])
        factors = np.array([patterns[:, list(own)].prod(axis=1) for own in self._sign_of]).reshape(-1, len(patterns)).T
        off = np.abs(factors * values - self._values)
        chosen: dict[object, Array] = {}
        for pattern in sorted(patterns[(off <= self._tolerances).all(axis=1)], key=lambda signs: -signs.sum()):
            signs = np.ones(self.reference.n)
            signs[self.lines] = pattern
            chosen.setdefault((*pattern[:1], *pattern[-1:]), signs)
        return [*chosen.values()]

    def _compared(self, values: Array) -> tuple[Booleans, Booleans]:
        """Return which invariants are the same, and which are with the opposite sign."""
        return np.abs(values - self._values) <= self._tolerances, np.abs(values + self._values) <= self._tolerances

    def _with_sign_of(self, lines: tuple[int, ...]) -> list[int]:
        """The invariants that change their signs with these lines."""
        return [k for k, own in enumerate(self._sign_of) if own == lines]

    @cached_property
    def lines(self) -> NDArray[np.int_]:
        """The joints whose axes are lines; a prismatic joint has only a direction."""
        return np.array([k for k, letter in enumerate(self.reference.joint_types) if letter != "P"], dtype=int)

    @cached_property
    def _sines(self) -> Array:
        axis = self.reference.lines.axis[self.lines]
        sines: Array = np.linalg.norm(cross(axis[:-1], axis[1:]), axis=-1)
        return sines

    @cached_property
    def _skew(self) -> list[int]:
        """The pairs of lines of neighbouring joints that are clearly not parallel: a prismatic joint between may move them."""
        clear = np.sqrt(1 - CLEARLY_NOT_PARALLEL_COS**2)
        return [k for k, (i, j) in enumerate(pairwise(self.lines)) if j == i + 1 and self._sines[k] > clear]

    @cached_property
    def _parallel(self) -> list[int]:
        """The pairs of parallel lines of neighbouring joints. The distance of nearly parallel ones depends on the last digits."""
        return [k for k, (i, j) in enumerate(pairwise(self.lines)) if j == i + 1 and self._sines[k] < SAME_DISTANCE_RAD]

    @cached_property
    def _runs(self) -> list[tuple[int, int]]:
        """The pairs i < j between which all lines are parallel: the two normals are a fixed distance apart along these lines.

        A helical joint changes this distance with its zero.
        """
        types = np.array([*self.reference.joint_types])
        return [
            (i, j)
            for i, j in combinations(self._skew, 2)
            if {*range(i + 1, j)} <= {*self._parallel} and (types[self.lines[i + 1] : self.lines[j] + 1] == "R").all()
        ]

    @cached_property
    def _sign_of(self) -> list[tuple[int, ...]]:
        """The lines whose signs decide the sign of each invariant; distances of parallel lines have none."""
        pairs = [*range(len(self._sines)), *self._skew]
        return [*((k, k + 1) for k in pairs), *(() for _ in self._parallel), *((i + 1,) for i, _ in self._runs)]

    @cached_property
    def _tolerances(self) -> Array:
        length = self.tolerance * (1 + float(np.ptp(self.reference.joint_points, axis=0).max()))
        along = [length / min(self._sines[i], self._sines[j]) ** 2 for i, j in self._runs]
        return np.array(
            [self.tolerance] * len(self._sines) + [length] * (len(self._skew) + len(self._parallel)) + along
        )

    @cached_property
    def _values(self) -> Array:
        return self.of(self.reference.lines.axis, self.reference.joint_points)


def _dot(u: Array, v: Array) -> Array:
    products: Array = np.sum(u * v, axis=-1)
    return products


def _all(values: Booleans) -> Booleans:
    result: Booleans = np.logical_and.reduce(values, axis=-1)
    return result
