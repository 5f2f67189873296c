"""Follow a curve of solutions: the configurations that a linkage can reach by a motion with one degree of freedom.

The angle of a driver cannot be the parameter of the curve, because at a dead point the driver reverses while the linkage
goes on. The length along the curve can, because it always increases. So each step predicts a point ahead along the tangent,
and then corrects it within the hyperplane perpendicular to the tangent: pseudo-arclength continuation.

Source: Allgower and Georg, Numerical Continuation Methods (1990).
"""

from typing import NamedTuple

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.mechanisms.levenberg_marquardt import Equations, null_space, on_planes, polish, solve, validate_solution
from kinlib.rigid.lie import wrap_angle

MAX_STEPS, MAX_STEP = 5000, 0.2
"""The largest number of steps in either direction, and the longest step, radians and metres together."""

MAX_BEND_RAD, MAX_CORRECTION = 0.25, 0.3
"""The largest angle between the tangents before and after a step, and the largest correction as a fraction of the step: where the
curve bends more, the step is halved."""

POINT_TOL = 1e-9
"""Points nearer to each other than this are the same."""


class Curve(NamedTuple):
    """A curve of solutions, point by point.

    q       (m, n)  the points; an angle that makes more than one full turn is not wrapped
    closed          whether the last point is the first one again (angles modulo 2 pi)
    """

    q: Array
    closed: bool


def trace_curve(equations: Equations, start: Array, count: int | None = None, step: float = MAX_STEP) -> Curve:
    """Follow the curve of solutions through start (n,) in both directions, until it closes or ends on either side.

    count  of points to return, at about equal steps; None: as many as the tracing needed

    Raises ValueError if start is not a solution, and if the number of directions that lead away from it is not one.
    """
    start, J = validate_solution(equations, start)
    directions, _ = null_space(J)
    if (free := directions.shape[1]) != 1:
        remedy = "Nothing can move: the linkage is a structure."
        if free:
            remedy = "Hold all degrees of freedom but one or, if curves cross here, start at another configuration."
        raise ValueError(f"Exactly one direction must lead away from the start of a curve; got {free}. {remedy}")
    # Both signs of the tangent are right. Fix one, so that the same start gives the same curve on every machine.
    tangent = directions[:, 0] * np.sign(directions[np.argmax(np.abs(directions[:, 0])), 0])
    q, closed = _follow_one_way(equations, start, tangent, J, step)
    if not closed:
        before, _ = _follow_one_way(equations, start, -tangent, J, step)
        q = np.concatenate([before[:0:-1], q])
    if count is not None and len(q) > 1:
        length = np.cumsum([0.0, *np.linalg.norm(np.diff(q, axis=0), axis=1)])
        at = np.linspace(0, length[-1], count)
        q = solve(equations, np.stack([np.interp(at, length, values) for values in q.T], axis=1)).x
    return Curve(polish(equations, q).x, closed)


def _follow_one_way(equations: Equations, start: Array, direction: Array, J: Array, step: float) -> tuple[Array, bool]:
    """Follow the curve from a point in the direction of its tangent: the points, and whether the last one is the start again."""
    points, h, x, tangent = [start], step, start, direction
    while len(points) <= MAX_STEPS:
        guess = x + h * tangent
        new, new_tangent, new_J = _correct(equations, guess, tangent)
        is_lost = new_tangent @ tangent < np.cos(MAX_BEND_RAD) or np.linalg.norm(new - guess) > MAX_CORRECTION * h
        if is_lost and h <= 1e-5 * step:
            break
        # Two branches that pass each other within a thousandth of a step are taken to cross.
        if is_lost or (h > 1e-3 * step and not _same_branch(J, tangent, new_J, new_tangent)):
            h /= 2
            continue
        # The start, its angles counted on from x. If this step passes the plane across it, the curve may have closed.
        gap = np.where(equations.is_angle, wrap_angle(start - x), start - x)
        passed, along = gap @ direction, (new - x) @ direction
        if POINT_TOL < passed <= along + POINT_TOL and along > np.cos(MAX_BEND_RAD) * np.linalg.norm(new - x):
            point, _, _ = _correct(equations, x + passed / along * (new - x), direction)
            if np.linalg.norm(point - x - gap) < 1e-6:
                return np.array([*points, x + gap]), True
        points.append(new)
        x, tangent, J, h = new, new_tangent, new_J, min(1.5 * h, step)
    return np.array(points), False


def _correct(equations: Equations, guess: Array, normal: Array) -> tuple[Array, Array, Array]:
    """Find where the curve meets the hyperplane through guess with a normal: the point, its tangent, the Jacobian there.

    The tangent points to the side of the normal. If no point is found, it is 0.
    """
    with_plane = on_planes(equations, guess, normal[:, None], np.zeros(1))
    found = solve(with_plane, guess[None], iterations=10)
    J = found.jacobian[0, :-1]
    # At a crossing the null space has several directions: take the one that continues the normal.
    directions, _ = null_space(J)
    tangent = directions @ (directions.T @ normal) * (found.residual[0] <= equations.tolerance)
    return found.x[0], tangent / max(float(np.linalg.norm(tangent)), 1e-300), J


def _same_branch(J: Array, tangent: Array, new_J: Array, new_tangent: Array) -> bool:
    """Whether a point lies on the branch of the one before, and not on one that passes close by: there a sign differs.

    The sign is that of the determinant of the equations with the tangent as last row, in a basis of their n - 1 dimensions.
    """
    U = np.linalg.svd(J)[0][:, : len(tangent) - 1]
    before, after = (np.linalg.det(np.vstack([U.T @ A, t])) for A, t in ((J, tangent), (new_J, new_tangent)))
    return bool(before * after >= 0)
