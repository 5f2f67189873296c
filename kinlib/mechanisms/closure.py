"""Closing a linkage: from a guess, in every way there is, and all along its motion.

Some joint values may be held where they should be, a driver's angle for instance; the equations are then solved for the
others. What comes back are whole postures again, held values and all.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.mechanisms.continuation import Curve, Path
from kinlib.mechanisms.levenberg_marquardt import Equations, null_space, solve
from kinlib.mechanisms.mobility import finite_freedoms

GUESSES = 64
"""Random postures from which assembly modes are sought at a time."""

STEPS = 40
"""A guess that has not closed by then is given up: others lead to the same mode sooner."""

ROUNDS = 3
"""The search for assembly modes is over when so many rounds in a row bring no new one."""

APART = 1e-5
"""Two assembly modes differ where some body stands elsewhere by this, in an entry of its pose. At a dead point two of them
become one, and there the search knows it to the square root of the residual, 1e-6 or so."""

SLACK = 1e-6
"""A value is beyond its limits if it is so by more than this: limits are printed with few digits."""


@dataclass(frozen=True, eq=False)
class Assembly:
    """What became of an attempt to close a linkage.

    q           (n,)  the posture reached
    residual    the norm of what is left over in it
    iterations  steps taken
    converged   whether it is closed
    message     the same in words, or why not
    """

    q: Array
    residual: float
    iterations: int
    converged: bool
    message: str


@dataclass(frozen=True, eq=False)
class Closure:
    """The closure equations of a linkage, in the joint values that are left free.

    equations        of all n joint values
    posture  (n,)    the held values, and a guess or a start for the others
    free     (k,)    which values are free
    names            what each value is called
    turns    (n,)    which values are angles, the same again after 2 pi
    limits   (n, 2)  least and greatest value, infinite where there is none
    reach    (n,)    how far from 0 the values are sought, where no limits are nearer
    closed           the norm of the residual below which it is closed

    >>> def circle(x):  # x^2 + y^2 = 1, and its derivative
    ...     return (x**2).sum(-1, keepdims=True) - 1, 2 * x[:, None]
    >>> square = np.array([[-2.0, 2.0]] * 2)
    >>> held = Closure(circle, np.array([0.5, 0.0]), np.array([0]), "xy", np.zeros(2, bool), square, np.ones(2), 1e-9)
    >>> held.assemble().q.round(9)
    array([1., 0.])
    >>> held.modes(stand=lambda q: q).round(9)
    array([[-1.,  0.],
           [ 1.,  0.]])
    >>> free = replace(held, posture=np.array([1.0, 0.0]), free=np.array([0, 1]))
    >>> free.trace(0.1, points=8, most=100).ends
    ('closed', 'closed')
    """

    equations: Equations
    posture: Array
    free: NDArray[np.intp]
    names: Sequence[str]
    turns: NDArray[np.bool_]
    limits: Array
    reach: Array
    closed: float

    def assemble(self) -> Assembly:
        """Close the linkage near the posture, or come as near as it goes."""
        found = solve(self._reduced, self.posture[None, self.free], self.closed)
        q, residual = self._whole(found.x)[0], float(found.residual[0])
        if self._beyond(q):
            q = self._counted(q[None])[0]
        steps = f"after {found.iterations} step{'s' * (found.iterations != 1)}"
        if residual > self.closed:
            message = (
                f"Not closed {steps}: a gap of {residual:.2g}, in metres and radians together, is left, and no small change "
                "makes it smaller. Are the links too short to meet? Or does another guess lead further?"
            )
        elif beyond := self._beyond(q):
            message = f"Closed to {residual:.1g} {steps}, but beyond the limits of {', '.join(beyond)}."
        else:
            message = f"Closed to {residual:.1g} {steps}."
        return Assembly(q, residual, found.iterations, residual <= self.closed, message)

    def modes(self, stand: Callable[[Array], Array]) -> Array:
        """Every posture (m, n) that closes: a search from random guesses, until it brings nothing new.

        stand  says where the bodies stand in postures (m, n), first dimension m: what two must have alike to be one mode

        Raises ValueError where a posture that closes is free to move.
        """
        # The guesses are random, and the answer must not be: every call draws the same ones.
        rng = np.random.default_rng(0)
        least, most = self._window[:, self.free]
        modes: list[Array] = []
        poses: list[Array] = []
        barren = 0
        while barren < ROUNDS:
            found = solve(self._reduced, rng.uniform(least, most, (GUESSES, len(self.free))), self.closed, STEPS)
            barren += 1
            # Near a solution a step squares the error: one more leaves rounding alone.
            exact = solve(self._reduced, found.x[found.residual <= self.closed], closed=0.0, iterations=1)
            postures = self._counted(self._whole(exact.x))
            for q, stands, J in zip(postures, stand(postures), exact.jacobian, strict=True):
                if self._beyond(q) or any(np.abs(stands - others).max() <= APART for others in poses):
                    continue
                directions, _ = null_space(J)
                if directions.shape[1] and finite_freedoms(self._reduced, q[self.free], directions, self.closed):
                    raise ValueError(
                        f"{directions.shape[1]} freedoms are left, so the modes are curves and not postures. "
                        "Hold as many joint values as the linkage has freedoms."
                    )
                modes.append(q)
                poses.append(stands)
                barren = 0
        return np.array(sorted(modes, key=list)).reshape(-1, len(self.posture))

    def trace(self, step: float, points: int | None, most: int) -> Curve:
        """Follow the motion from the posture both ways, and lay points at equal steps along it where so many are asked for.

        Raises ValueError for a posture that does not close, or is beyond a limit, or from which not one motion leads away.
        """
        if beyond := self._beyond(self.posture):
            raise ValueError(f"The start is beyond the limits of {', '.join(beyond)}.")
        names = [self.names[i] for i in self.free]
        path = Path(self._reduced, self.closed, names, self.turns[self.free], self.limits[self.free])
        curve = path.follow(self.posture[self.free], step, most)
        if points is not None:
            curve = path.laid_out(curve, points)
        tangents = np.zeros((len(curve.q), len(self.posture)))
        tangents[:, self.free] = curve.tangents
        return replace(curve, q=self._whole(curve.q), tangents=tangents)

    def _reduced(self, x: Array) -> tuple[Array, Array]:
        r, J = self.equations(self._whole(x))
        return r, J[..., self.free]

    def _whole(self, x: Array) -> Array:
        q = np.tile(self.posture, (len(x), 1))
        q[:, self.free] = x
        return q

    @cached_property
    def _window(self) -> Array:
        """The least and the greatest values (2, n) among which a search makes sense: within limits, one turn of an angle."""
        least, most = self.limits.T
        least = np.maximum(least, np.minimum(-self.reach, most - 2 * self.reach))
        return np.stack([least, np.minimum(most, least + 2 * self.reach)])

    def _counted(self, q: Array) -> Array:
        """The same postures (m, n), with every free angle counted from the least value that its limits allow, or from -pi."""
        least = self._window[0] - SLACK
        free = np.isin(np.arange(len(self.posture)), self.free)
        return np.where(free & self.turns, (q - least) % (2 * np.pi) + least, q)

    def _beyond(self, q: Array) -> list[str]:
        """The names of the values that are beyond their limits."""
        beyond = (q < self.limits[:, 0] - SLACK) | (q > self.limits[:, 1] + SLACK)
        return [name for name, outside in zip(self.names, beyond, strict=True) if outside]
