"""Follow a curve of solutions: the configurations that a linkage can reach by a motion with one degree of freedom.

The angle of a driver cannot be the parameter of the curve, because at a dead point the driver reverses while the linkage
goes on. The length along the curve can, because it always increases. So each step predicts a point ahead along the tangent,
and then corrects it within the hyperplane perpendicular to the tangent: pseudo-arclength continuation.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import START_TOL_FACTOR, Equations, is_nonzero, null_space, solve
from kinlib.rigid.angles import wrap_angle

MAX_BEND_RAD = 0.25
"""The largest angle between the tangents before and after a step; where the curve bends more, the step is halved."""

MAX_CORRECTION = 0.3
"""The largest distance between the predicted and the corrected point of a step, as a fraction of the step."""

MIN_STEP = 1e-5
"""The smallest step, as a fraction of the step asked for: if even this one finds no solution, the curve ends there."""

CROSSING_STEP = 1e-3
"""Two branches that pass each other within this fraction of the step asked for are taken to cross."""

POINT_TOL = 1e-9
"""Points of a curve nearer to each other than this are the same point."""

RETURN_TOL = 1e-6
"""If a curve passes its start nearer than this, it has returned to it; if not, it is another part of the curve."""

NO_MOTION = "Nothing can move: the linkage is a structure."
SEVERAL_MOTIONS = "Hold all degrees of freedom but one or, if curves cross here, start at another configuration of one."
"""Two reasons why a configuration has no single motion, and what to try."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of solutions, point by point.

    q         (m, n)  the points; an angle that makes more than one full turn is not wrapped
    tangents  (m, n)  unit vectors along the curve
    closed            whether the last point is the first one again (angles modulo 2 pi)
    ends              why the curve ends: (at its first point, at its last); "closed" twice for a closed curve
    residual          the largest norm of the residual at any point
    """

    q: Array
    tangents: Array
    closed: bool
    ends: tuple[str, str]
    residual: float

    @cached_property
    def length(self) -> Array:
        """The length of the curve up to each point, (m,), from 0 at the first; radians and metres have equal weight."""
        steps = np.linalg.norm(np.diff(self.q, axis=0), axis=1)
        return np.concatenate([[0.0], np.cumsum(steps)])

    def turning_points(self, i: int) -> NDArray[np.intp]:
        """Find the points at which coordinate i changes from increasing to decreasing or back: the dead points of a driver.

        Returns the index of the first point after each change. A closed curve may have a turning point at its first point
        too, which is also its last one and is counted once.
        """
        ahead = self.tangents[:, i] > 0
        before = np.concatenate([ahead[-2:-1] if self.closed else ahead[:1], ahead[:-1]])
        return np.flatnonzero((ahead != before)[: len(ahead) - self.closed])

    def interpolate(self, count: int) -> Array:
        """Interpolate points (count, n) at equal steps of length by cubic Hermite splines: near the curve, not exactly on it."""
        s = np.linspace(0, self.length[-1], count)
        k = np.clip(np.searchsorted(self.length, s, side="right") - 1, 0, len(self.q) - 2)
        h = (self.length[k + 1] - self.length[k])[:, None]
        u = (s[:, None] - self.length[k, None]) / h
        a, b = self.q[k], self.q[k + 1]
        start, end = h * self.tangents[k], h * self.tangents[k + 1]
        points: Array = (1 - u) ** 2 * ((1 + 2 * u) * a + u * start) + u**2 * ((3 - 2 * u) * b + (u - 1) * end)
        return points


@dataclass(frozen=True, eq=False)
class CurveTracer:
    """Follows a curve of solutions of a system of equations.

    equations  whose solutions form the curve
    tolerance  a point is a solution if the norm of its residual is at most this
    is_angle   (n,)    which coordinates are angles, and so the same again after 2 pi
    """

    equations: Equations
    tolerance: float
    is_angle: NDArray[np.bool_]

    def follow(self, start: Array, step: float, max_steps: int) -> Curve:
        """Follow the curve through start (n,) in both directions, until it closes or ends on either side.

        step       the longest step along the curve
        max_steps  in either direction; after them the curve is left unfinished, which its `ends` then say

        Raises ValueError if start is not a solution, and if the number of directions that lead away from it is not one.
        """
        residual = np.linalg.norm(self.equations(start[None])[0])
        if residual > START_TOL_FACTOR * self.tolerance:
            raise ValueError(
                f"A curve must start at a solution; the residual of this start is {residual:.2g}. "
                "Assemble the linkage first, and pass the q that you get."
            )
        found = solve(self.equations, start[None], self.tolerance)
        x, (directions, _) = found.x[0], null_space(found.jacobian[0])
        if directions.shape[1] != 1:
            raise ValueError(
                f"Exactly one direction must lead away from the start of a curve; got {directions.shape[1]}. "
                + (NO_MOTION if directions.shape[1] == 0 else SEVERAL_MOTIONS)
            )
        # Both signs of the tangent are right. Fix one, so that the same start gives the same curve on every machine.
        tangent = directions[:, 0]
        tangent *= np.sign(tangent[np.argmax(np.abs(tangent))])
        points, tangents, end = self._follow_one_way(x, tangent, step, max_steps)
        beginning = end
        if end != "closed":
            before, reverse, beginning = self._follow_one_way(x, -tangent, step, max_steps)
            points = np.concatenate([before[:0:-1], points])
            tangents = np.concatenate([-reverse[:0:-1], tangents])
        # Near a solution a step squares the error, so one more step for all points at once leaves only rounding errors.
        exact = solve(self.equations, points, tolerance=0.0, iterations=1)
        return Curve(exact.x, tangents, end == "closed", (beginning, end), float(exact.residual.max()))

    def resample(self, curve: Curve, count: int) -> Curve:
        """Return the same curve in `count` points at about equal steps of its length. A curve of one point stays as it is."""
        if len(curve.q) == 1:
            return curve
        near = solve(self.equations, curve.interpolate(count), self.tolerance)
        found = solve(self.equations, near.x, tolerance=0.0, iterations=1)
        _, values, Vt = np.linalg.svd(found.jacobian)
        in_null_space = np.ones(Vt.shape[:2])
        in_null_space[:, : values.shape[1]] = ~is_nonzero(values)
        # At a crossing the null space has several directions. Project the tangent of the given curve on it, which changes
        # little from point to point.
        s = np.linspace(0, curve.length[-1], count)
        nearby = np.stack([np.interp(s, curve.length, component) for component in curve.tangents.T], axis=1)
        components = (Vt @ nearby[..., None])[..., 0] * in_null_space
        tangents = (np.swapaxes(Vt, 1, 2) @ components[..., None])[..., 0]
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        return Curve(found.x, tangents, curve.closed, curve.ends, float(found.residual.max()))

    def _follow_one_way(self, x: Array, tangent: Array, step: float, max_steps: int) -> tuple[Array, Array, str]:
        """Follow the curve from x in the direction of the tangent: points (m, n), tangents (m, n), and why it ends."""
        points, tangents, h, curvature = [x], [tangent], step, np.zeros_like(x)
        basis, side = _side(self.equations(x[None])[1][0], tangent)
        end = f"{max_steps} point{'s' * (max_steps != 1)}"
        while len(points) <= max_steps:
            x, tangent = points[-1], tangents[-1]
            guess = x + h * tangent + h * h / 2 * curvature
            new, new_tangent, J = self._correct(guess, tangent, tangent)
            is_bent = new_tangent @ tangent < np.cos(MAX_BEND_RAD)
            is_lost = is_bent or np.linalg.norm(new - guess) > MAX_CORRECTION * h
            # The point may lie on another branch that passes close by, where the side of the tangent is the opposite one.
            is_other_branch = not is_lost and _orientation(basis, J, new_tangent) * side < 0
            if (is_lost and h > MIN_STEP * step) or (is_other_branch and h > CROSSING_STEP * step):
                h /= 2
                continue
            if is_lost:
                end = "lost: no configuration closes further on"
                break
            if (start := self._return_to_start(points[0], tangents[0], x, tangent, new)) is not None:
                return np.array([*points, start]), np.array([*tangents, tangents[0]]), "closed"
            curvature = (new_tangent - tangent) / np.linalg.norm(new - x)
            # At a crossing, where J has a lower rank, the side stays that of the point before.
            next_basis, next_side = _side(J, new_tangent)
            if next_basis.shape[1] == basis.shape[1]:
                basis, side = next_basis, next_side
            points.append(new)
            tangents.append(new_tangent)
            h = min(1.5 * h, step)
        return np.array(points), np.array(tangents), end

    def _correct(self, guess: Array, normal: Array, tangent: Array) -> tuple[Array, Array, Array]:
        """Find where the curve meets the hyperplane through guess with a normal: the point, its tangent, the Jacobian there.

        tangent  of the point before; the new one points to the same side. If no point is found, the new tangent is 0.
        """

        def equations(x: Array) -> tuple[Array, Array]:
            r, J = self.equations(x)
            normals = np.broadcast_to(normal, (len(x), 1, len(normal)))
            return np.concatenate([r, (x - guess) @ normal[:, None]], axis=1), np.concatenate([J, normals], axis=1)

        found = solve(equations, guess[None], self.tolerance, iterations=10)
        J = found.jacobian[0, :-1]
        if found.residual[0] > self.tolerance:
            return guess, np.zeros_like(guess), J
        # At a crossing the null space has several directions: take the one that continues the tangent.
        directions, _ = null_space(J)
        new_tangent = directions @ (directions.T @ tangent)
        length = np.linalg.norm(new_tangent)
        return found.x[0], new_tangent / length if length else new_tangent, J

    def _return_to_start(self, start: Array, direction: Array, x: Array, tangent: Array, new: Array) -> Array | None:
        """The start of the curve, its angles counted on from x, if the step from x to new passes through it in its direction."""
        step = new - x
        length = np.linalg.norm(step)
        to_start = start - x
        to_start = np.where(self.is_angle, wrap_angle(to_start), to_start)
        along = to_start @ step / length
        across = np.linalg.norm(to_start - along * step / length)
        passes = (
            POINT_TOL < along <= length + POINT_TOL
            and across <= MAX_BEND_RAD * length / 2
            and direction @ step > np.cos(MAX_BEND_RAD) * length
        )
        if not passes:
            return None
        # Another part of the curve may pass as near. So find where this part meets the hyperplane through the start.
        unwrapped: Array = x + to_start
        guess = x + along * tangent
        guess += direction * (direction @ (unwrapped - guess))
        point, new_tangent, _ = self._correct(guess, direction, tangent)
        return unwrapped if new_tangent.any() and np.linalg.norm(point - unwrapped) < RETURN_TOL else None


def _side(J: Array, tangent: Array) -> tuple[Array, float]:
    """A basis (e, k) of the column space of J at a point of a curve, and on which side of it the tangent points, +1 or -1.

    Along one branch the side does not change. If J has a lower rank than n - 1, no side is known, and it is 0.
    """
    U, s, _ = np.linalg.svd(J, full_matrices=False)
    basis = U[:, is_nonzero(s)]
    return basis, _orientation(basis, J, tangent) if basis.shape[1] == len(tangent) - 1 else 0.0


def _orientation(basis: Array, J: Array, tangent: Array) -> float:
    """The sign of the determinant of the equations in the basis, with the tangent as last row."""
    return float(np.sign(np.linalg.det(np.vstack([basis.T @ J, tangent]))))
