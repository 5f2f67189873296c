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

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import ROUGH, Equations, null_space, seen, solve
from kinlib.rigid.angles import wrap_angle

BEND = 0.25
"""A step may turn the tangent by this, in radians; a sharper bend is taken in smaller steps."""

STRAY = 0.3
"""How far the curve may lie from where the tangent led, in parts of the step."""

SHORTEST = 1e-5
"""In parts of the step asked for: where even this one leads nowhere, the curve is said to end."""

CROSSING = 1e-3
"""In parts of the step asked for: two branches that pass each other nearer than this are taken to cross."""

SAME = 1e-9
"""Points of a curve nearer than this are one point."""

STRAND = 1e-6
"""A curve that passes its start nearer than this has come back to it, and does not run beside itself."""


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
        """The points before which coordinate i went one way and after which it goes the other: dead points of a driver.

        A closed curve may turn at its first point too, which is its last one.
        """
        ahead = self.tangents[:, i] > 0
        before = np.concatenate([ahead[-2:-1] if self.closed else ahead[:1], ahead[:-1]])
        return np.flatnonzero((ahead != before)[: len(ahead) - self.closed])

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
        left = np.linalg.norm(self.equations(start[None])[0])
        if left > ROUGH * self.closed:
            raise ValueError(f"A curve starts at a solution; here {left:.2g} is left over. Assemble first.")
        found = solve(self.equations, start[None], self.closed)
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
        """The same curve in count points, at about equal steps of its length, all found at once; one point stays one."""
        if len(curve.q) == 1:
            return curve
        near = solve(self.equations, curve.between(count), self.closed)
        found = solve(self.equations, near.x, closed=0.0, iterations=1)
        _, values, Vt = np.linalg.svd(found.jacobian)
        missed = np.ones(Vt.shape[:2])
        missed[:, : values.shape[1]] = ~seen(values)
        # Of the directions that are open, the one in which the curve went by: its tangents turn little from point to point.
        s = np.linspace(0, curve.length[-1], count)
        nearby = np.stack([np.interp(s, curve.length, component) for component in curve.tangents.T], axis=1)
        onward = (Vt @ nearby[..., None])[..., 0] * missed
        tangents = (np.swapaxes(Vt, 1, 2) @ onward[..., None])[..., 0]
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        return Curve(found.x, tangents, curve.closed, curve.ends, float(found.residual.max()))

    def _half(self, x: Array, tangent: Array, step: float, most: int) -> tuple[Array, Array, str]:
        """The curve from x, one way only: points, tangents, and why it ends."""
        points, tangents, h = [x], [tangent], step
        bend = np.zeros_like(x)
        basis, side = _side(self.equations(x[None])[1][0], tangent, (np.empty(0), 0.0))
        end = f"{most} point{'s' * (most != 1)}"
        while len(points) <= most:
            x, tangent = points[-1], tangents[-1]
            guess = x + h * tangent + h * h / 2 * bend
            new, ahead, J = self._back_to_the_curve(guess, tangent, tangent)
            lost = ahead @ tangent < np.cos(BEND) or np.linalg.norm(new - guess) > STRAY * h
            # Straight on may be another branch, that passes close by: there the equations lie on the tangent's other side.
            other = not lost and _orientation(basis, J, ahead) * side < 0
            if (lost and h > SHORTEST * step) or (other and h > CROSSING * step):
                h /= 2
                continue
            if lost:
                end = "lost: no posture closes further on"
                break
            if (back := self._home(points[0], tangents[0], x, tangent, new)) is not None:
                return np.array([*points, back]), np.array([*tangents, tangents[0]]), "closed"
            if (met := self._limit(x, tangent, new, ahead)) is not None:
                stop, ahead, i = met
                if np.linalg.norm(stop - x) > SAME:
                    points.append(stop)
                    tangents.append(ahead)
                end = f"limit of {self.names[i]}"
                break
            bend = (ahead - tangent) / np.linalg.norm(new - x)
            basis, side = _side(J, ahead, (basis, side))
            points.append(new)
            tangents.append(ahead)
            h = min(1.5 * h, step)
        return np.array(points), np.array(tangents), end

    def _back_to_the_curve(self, guess: Array, across: Array, tangent: Array) -> tuple[Array, Array, Array]:
        """The point where the curve meets the plane through guess across a direction, the tangent there, the Jacobian.

        Where none is found, the tangent is 0.
        """

        def equations(x: Array) -> tuple[Array, Array]:
            r, J = self.equations(x)
            slices = np.broadcast_to(across, (len(x), 1, len(across)))
            return np.concatenate([r, (x - guess) @ across[:, None]], axis=1), np.concatenate([J, slices], axis=1)

        found = solve(equations, guess[None], self.closed, iterations=10)
        J = found.jacobian[0, :-1]
        if found.residual[0] > self.closed:
            return guess, np.zeros_like(guess), J
        # Of the directions that are open, at a crossing more than one, the one that goes straight on.
        directions, _ = null_space(J)
        ahead = directions @ (directions.T @ tangent)
        length = np.linalg.norm(ahead)
        return found.x[0], ahead / length if length else ahead, J

    def _home(self, start: Array, direction: Array, x: Array, tangent: Array, new: Array) -> Array | None:
        """The start of the curve, counted on from x, if the step from x to new goes through it in its direction."""
        way = new - x
        length = np.linalg.norm(way)
        to_start = start - x
        to_start = np.where(self.turns, wrap_angle(to_start), to_start)
        along = to_start @ way / length
        aside = np.linalg.norm(to_start - along * way / length)
        passes = (
            SAME < along <= length + SAME and aside <= BEND * length / 2 and direction @ way > np.cos(BEND) * length
        )
        if not passes:
            return None
        # Another strand of the curve may pass as near: where does this one cut the plane in which the start lies?
        back: Array = x + to_start
        guess = x + along * tangent
        guess += direction * (direction @ (back - guess))
        here, ahead, _ = self._back_to_the_curve(guess, direction, tangent)
        return back if ahead.any() and np.linalg.norm(here - back) < STRAND else None

    def _limit(self, x: Array, tangent: Array, new: Array, ahead: Array) -> tuple[Array, Array, int] | None:
        """Where the curve from x to new meets its first limit, the tangent there, and the coordinate that meets it.

        Within one step a curve may pass a limit and be back. Nearly it is a cubic, and a cubic never leaves the hull of its
        four control points: for most steps that is all that has to be known.
        """
        if np.isinf(self.limits).all():
            return None
        way = new - x
        length = np.linalg.norm(way)
        start, end = length * tangent, length * ahead
        cubic = np.array([x, start, 3 * way - 2 * start - end, start + end - 2 * way])
        hull = np.array([x + start / 3, new - end / 3, new])
        beyond = np.stack([hull < self.limits[:, 0] - SAME, hull > self.limits[:, 1] + SAME], axis=-1)
        met = []
        for i, side in np.argwhere(beyond.any(axis=0)):
            # A coefficient that moves nothing by SAME would, in front, make the roots of the others run away.
            over = ((2 * side - 1) * (np.polynomial.Polynomial(cubic[:, i]) - self.limits[i, side]) - SAME).trim(SAME)
            roots = over.roots()
            inside = roots.real[(np.abs(roots.imag) < SAME) & (roots.real > 0) & (roots.real <= 1)]
            out = [u for u in [0.0, *inside] if over.deriv()(u) > 0 and (u > 0 or over(u) > 0)]
            if not out and beyond[-1, i, side]:
                out = [1.0]
            met += [(u, i, side) for u in out]
        for u, i, side in sorted(met):
            guess = u ** np.arange(4) @ cubic
            guess[i] = self.limits[i, side]
            stop, onward, _ = self._back_to_the_curve(guess, np.eye(len(x))[i], tangent)
            if onward.any() and np.linalg.norm(stop - x) <= length:
                return stop, onward, int(i)
        return (x, tangent, int(min(met)[1])) if beyond[-1].any() else None


def _side(J: Array, tangent: Array, before: tuple[Array, float]) -> tuple[Array, float]:
    """What the equations say at a point of a curve, as a basis (e, n - 1), and on which side of it the tangent points.

    On one branch the side stays. At a crossing, where the basis is smaller, it is that of the point before.
    """
    U, s, _ = np.linalg.svd(J, full_matrices=False)
    basis = U[:, seen(s)]
    return (basis, _orientation(basis, J, tangent)) if basis.shape[1] == len(tangent) - 1 else before


def _orientation(basis: Array, J: Array, tangent: Array) -> float:
    return float(np.sign(np.linalg.det(np.vstack([basis.T @ J, tangent]))))
