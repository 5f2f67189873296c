"""Follow a curve of solutions: where a linkage can go, one posture after the other.

A driver's angle is no good parameter for the curve: at a dead point the driver turns back and the linkage goes on. The
length along the curve is one, for it never turns back. So each step goes ahead along the tangent, and then back to the
curve within the plane across it: pseudo-arclength continuation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinlib.check import Array
from kinlib.gauss_newton import Equations, null_space, seen, solve

BEND = 0.25
"""A step may turn the tangent by this, in radians; a sharper bend is taken in smaller steps, and no branch is jumped."""

STRAY = 0.3
"""How far the curve may lie from where the tangent led, in parts of the step."""

SHORTEST = 1e-5
"""In parts of the step asked for: where even this one leads nowhere, the curve is said to end."""

SAME = 1e-9
"""Points of a curve nearer than this are one point."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of solutions, point by point.

    q         (m, n)  the points; where a turn goes round more than once, its angle goes on counting
    tangents  (m, n)  unit directions along the curve
    closed            whether the last point is the first one again (turns modulo 2 pi)
    ends              why it ends where it does: (at its first point, at its last); twice "closed" for a closed one
    residual          the largest norm of what is left over at any point
    """

    q: Array
    tangents: Array
    closed: bool
    ends: tuple[str, str]
    residual: float

    @cached_property
    def length(self) -> Array:
        """The length of the curve up to each point, (m,), from 0 at the first; radians and metres count alike."""
        steps = np.linalg.norm(np.diff(self.q, axis=0), axis=1)
        return np.concatenate([[0.0], np.cumsum(steps)])

    def turning_points(self, i: int) -> NDArray[np.intp]:
        """The points before which coordinate i went one way and after which it goes the other: dead points of a driver."""
        ahead = self.tangents[:, i] > 0
        return np.flatnonzero(ahead[1:] != ahead[:-1]) + 1

    def between(self, count: int) -> Array:
        """Points (count, n) at equal steps of length, by cubics between the points: near the curve, not yet on it."""
        s = np.linspace(0, self.length[-1], count)
        k = np.clip(np.searchsorted(self.length, s, side="right") - 1, 0, len(self.q) - 2)
        h = (self.length[k + 1] - self.length[k])[:, None]
        u = (s[:, None] - self.length[k, None]) / h
        a, b = self.q[k], self.q[k + 1]
        start, end = h * self.tangents[k], h * self.tangents[k + 1]
        points: Array = (1 - u) ** 2 * ((1 + 2 * u) * a + u * start) + u**2 * ((3 - 2 * u) * b + (u - 1) * end)
        return points


@dataclass(frozen=True, eq=False)
class Path:
    """What a curve is followed by: the equations, when they count as solved, and what is known of the coordinates.

    names   what each coordinate is called, for the words about where a curve ends
    turns   (n,)    which coordinates are angles, the same again after 2 pi
    limits  (n, 2)  least and greatest value of each, infinite where there is none
    """

    equations: Equations
    closed: float
    names: Sequence[str]
    turns: NDArray[np.bool_]
    limits: Array

    def follow(self, start: Array, step: float, most: int) -> Curve:
        """Follow the curve through start both ways, until it closes, or meets a limit at either end.

        Raises ValueError where start is no solution, or where not exactly one direction leads away from it.
        """
        found = solve(self.equations, start[None], self.closed)
        if found.residual[0] > self.closed:
            raise ValueError(
                f"A curve starts at a solution; here {found.residual[0]:.2g} is left over. Assemble first."
            )
        directions, _ = null_space(found.jacobian[0])
        if directions.shape[1] != 1:
            cause = (
                "Nothing moves: it is a structure"
                if directions.shape[1] == 0
                else "Hold all but one of the freedoms, or, where two curves cross, start beside the crossing"
            )
            raise ValueError(f"{directions.shape[1]} directions lead away from here, and a curve has one. {cause}.")
        x, tangent = found.x[0], directions[:, 0]
        # A tangent has two signs, and either would do: the same start should give the same curve on every machine.
        tangent *= np.sign(tangent[np.argmax(np.abs(tangent))])
        points, tangents, end = self._half(x, tangent, step, most)
        beginning = end
        if end != "closed":
            before, reverse, beginning = self._half(x, -tangent, step, most)
            points = np.concatenate([before[:0:-1], points])
            tangents = np.concatenate([-reverse[:0:-1], tangents])
        # Near a solution a step squares the error: one more for all points at once leaves rounding alone.
        exact = solve(self.equations, points, closed=0.0, iterations=1)
        return Curve(exact.x, tangents, end == "closed", (beginning, end), float(exact.residual.max()))

    def laid_out(self, curve: Curve, count: int) -> Curve:
        """The same curve in count points, at about equal steps of its length, all found at once."""
        near = solve(self.equations, curve.between(count), self.closed)
        found = solve(self.equations, near.x, closed=0.0, iterations=1)
        _, s, Vt = np.linalg.svd(found.jacobian)
        missed = np.ones(Vt.shape[:2])
        missed[:, : s.shape[1]] = ~seen(s)
        # Of the directions that are open, the one in which the points follow each other.
        onward = (Vt @ np.gradient(found.x, axis=0)[..., None])[..., 0] * missed
        tangents = (np.swapaxes(Vt, 1, 2) @ onward[..., None])[..., 0]
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        return Curve(found.x, tangents, curve.closed, curve.ends, float(found.residual.max()))

    def _half(self, x: Array, tangent: Array, step: float, most: int) -> tuple[Array, Array, str]:
        """The curve from x, one way only: points, tangents, and why it ends."""
        points, tangents, h = [x], [tangent], step
        bend = np.zeros_like(x)
        end = f"{most} points"
        while len(points) <= most:
            x, tangent = points[-1], tangents[-1]
            guess = x + h * tangent + h * h / 2 * bend
            new, ahead = self._back_to_the_curve(guess, tangent, tangent)
            lost = ahead @ tangent < np.cos(BEND) or np.linalg.norm(new - guess) > STRAY * h
            if lost and h > SHORTEST * step:
                h /= 2
                continue
            if lost:
                end = "lost: no posture closes further on"
                break
            if (back := self._home(points[0], tangents[0], x, new)) is not None:
                return np.array([*points, back]), np.array([*tangents, tangents[0]]), "closed"
            beyond = (new < self.limits[:, 0] - SAME) | (new > self.limits[:, 1] + SAME)
            if beyond.any():
                stop, ahead, end = self._at_the_limit(x, tangent, new)
                if np.linalg.norm(stop - x) > SAME:
                    points.append(stop)
                    tangents.append(ahead)
                break
            bend = (ahead - tangent) / np.linalg.norm(new - x)
            points.append(new)
            tangents.append(ahead)
            h = min(1.5 * h, step)
        return np.array(points), np.array(tangents), end

    def _back_to_the_curve(self, guess: Array, across: Array, tangent: Array) -> tuple[Array, Array]:
        """The point where the curve meets the plane through guess across a direction, and the tangent there.

        Where none is found, the tangent is 0.
        """

        def equations(x: Array) -> tuple[Array, Array]:
            r, J = self.equations(x)
            slices = np.broadcast_to(across, (len(x), 1, len(across)))
            return np.concatenate([r, (x - guess) @ across[:, None]], axis=1), np.concatenate([J, slices], axis=1)

        found = solve(equations, guess[None], self.closed, iterations=10)
        if found.residual[0] > self.closed:
            return guess, np.zeros_like(guess)
        # Of the directions that are open, at a crossing more than one, the one that goes straight on.
        directions, _ = null_space(found.jacobian[0, :-1])
        ahead = directions @ (directions.T @ tangent)
        length = np.linalg.norm(ahead)
        return found.x[0], ahead / length if length else ahead

    def _home(self, start: Array, direction: Array, x: Array, new: Array) -> Array | None:
        """The start of the curve, counted on from x, if the step from x to new goes through it in its direction."""
        way = new - x
        length = np.linalg.norm(way)
        to_start = start - x
        to_start = np.where(self.turns, (to_start + np.pi) % (2 * np.pi) - np.pi, to_start)
        along = to_start @ way / length
        aside = np.linalg.norm(to_start - along * way / length)
        passes = (
            SAME < along <= length + SAME and aside <= BEND * length / 2 and direction @ way > np.cos(BEND) * length
        )
        back: Array = x + to_start
        return back if passes else None

    def _at_the_limit(self, x: Array, tangent: Array, new: Array) -> tuple[Array, Array, str]:
        """The point between x and new at which the first limit is met."""
        limit = np.where(new > x, self.limits[:, 1], self.limits[:, 0])
        with np.errstate(divide="ignore", invalid="ignore"):
            part = np.where(new == x, np.inf, (limit - x) / (new - x))
        i = int(np.argmin(np.where(part < 0, np.inf, part)))
        guess = x + np.clip(part[i], 0, 1) * (new - x)
        guess[i] = limit[i]
        point, ahead = self._back_to_the_curve(guess, np.eye(len(x))[i], tangent)
        return point, ahead, f"limit of {self.names[i]}"
