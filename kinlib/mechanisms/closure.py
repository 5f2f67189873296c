"""Close a linkage: from a guess, in all its assembly modes, and along its motion.

Some joint values may be held, for example the angle of a driver; the equations are then solved for the other values. The
results are configurations with all joint values, also those that are held.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays.validation import Array
from kinlib.mechanisms.continuation import Curve, CurveTracer
from kinlib.mechanisms.levenberg_marquardt import Equations, null_space, solve
from kinlib.mechanisms.mobility import finite_mobility, on_planes
from kinlib.rigid.angles import wrap_angle

GUESSES_PER_ROUND = 64
"""The number of random configurations from which each round of the search for assembly modes starts."""

MAX_STEPS_PER_GUESS = 40
"""A guess that has not closed after so many steps is given up, because others lead to the same mode sooner."""

MIN_IDLE_ROUNDS, MAX_IDLE_ROUNDS = 3, 30
"""The search for assembly modes ends after so many rounds in a row without a new mode: after the smaller number if every mode has
been found at least twice, because then it is likely that none is missing (Good, 1953), and otherwise after the larger number."""

MODE_TOL = 1e-5
"""Two configurations are different assembly modes if an entry of the pose of some body differs by more than this. At a dead
point two modes become one, and there the search finds it only to the square root of the residual, about 1e-6."""

MODE_CURVE_STEP, MODE_CURVE_MAX_STEPS, SAMPLES_PER_STEP = 0.2, 5000, 8
"""How curves are followed from mode to mode, and at how many points of each step a passage through the held value is sought."""

MOVES_TOL = 1e-6
"""A body moves with a joint velocity of length 1 if its pose changes at more than this rate, which central differences with
steps of the next number find to about 1e-10."""

DIFFERENCE_STEP = 1e-5

LIMIT_TOL = 1e-6
"""A value violates its limits only if it is beyond them by more than this, because limits are printed with few digits."""


@dataclass(frozen=True, eq=False)
class Assembly:
    """The result of an attempt to close a linkage.

    q           (n,)  the configuration reached
    residual    the norm of its residual, radians and metres together
    iterations  the number of steps taken
    converged   whether the linkage is closed in it
    message     the same in words, or why it is not closed
    """

    q: Array
    residual: float
    iterations: int
    converged: bool
    message: str


@dataclass(eq=False)
class _Mode:
    """A configuration (n,), the poses of the bodies in it, and how many guesses led to it."""

    q: Array
    pose: Array
    hits: int = 0


@dataclass(frozen=True, eq=False)
class ModeSearch:
    """The assembly modes that a search from random guesses found, and how thoroughly it has searched.

    q          (m, n)  one configuration of each mode
    hits       (m,)    how many guesses led to it
    guesses            the number of guesses; the others did not close, or only beyond the limits
    since_new          how many guesses have closed since the round that found the last new mode
    curves             how many curves were followed, on which one held value changes: these modes have no hits if no guess
                       led to them

    The search proves that the modes it found exist, and never that there are no others. If the missing modes together
    attract a share p of the guesses that close, then `since_new` guesses all miss them with probability (1 - p)^since_new.
    So with 95 % confidence p is at most 3 / since_new. Modes that were hit once or twice are a sign that others are missing.
    Source of the confidence: Hanley and Lippman-Hand, If nothing goes wrong, is everything all right?, JAMA 249 (1983).

    >>> from kinlib.mechanisms.linkages import four_bar
    >>> print(four_bar(4, 1, 3.5, 3).search_modes(hold={"A": 1.0}))
    2 assembly modes. 256 of 256 guesses closed, the last 192 of them in modes that were known: with 95 % confidence ...
    """

    q: Array
    hits: NDArray[np.intp]
    guesses: int
    since_new: int
    curves: int = 0

    def __str__(self) -> str:
        """Describe the search in words."""
        if not len(self.q):
            return f"No assembly mode: none of {self.guesses} guesses closed within the limits."
        text = (
            f"{len(self.q)} assembly mode{'s' * (len(self.q) != 1)}. {self.hits.sum()} of {self.guesses} guesses closed, "
            f"the last {self.since_new} of them in modes that were known"
        )
        if self.since_new:
            text += f": with 95 % confidence at most {min(300 / self.since_new, 100):.2g} % of them would lead to missing modes"
        if self.curves:
            text += (
                f". {np.count_nonzero(self.hits == 0)} of the modes were found only by following {self.curves} curves"
            )
        return text + "."


@dataclass(frozen=True, eq=False)
class Closure:
    """The closure equations of a linkage, to be solved for the joint values that are not held.

    equations             of all n joint values
    configuration  (n,)   the held values, and a guess or a start for the others
    free           (k,)   the indices of the values that are not held
    names                 of the joint values
    is_angle       (n,)   which values are angles, and so the same again after 2 pi
    limits         (n, 2) the lower and the upper limit of each value, infinite where there is none
    search_range   (n,)   the values are sought in [-search_range, search_range], or within the limits where these are narrower
    tolerance             the linkage is closed if the norm of the residual is at most this

    >>> def circle(x):  # x^2 + y^2 = 1, and its derivative
    ...     return (x**2).sum(-1, keepdims=True) - 1, 2 * x[:, None]
    >>> square = np.array([[-2.0, 2.0]] * 2)
    >>> held = Closure(circle, np.array([0.5, 0.0]), np.array([0]), "xy", np.zeros(2, bool), square, np.ones(2), 1e-9)
    >>> held.assemble().q.round(9)
    array([1., 0.])
    >>> held.search_modes(poses=lambda q: q).q.round(9)
    array([[-1.,  0.],
           [ 1.,  0.]])
    >>> free = replace(held, configuration=np.array([1.0, 0.0]), free=np.array([0, 1]))
    >>> free.branch_directions(0.1).round(9) + 0.0
    array([[0., 1.]])
    >>> free.trace(0.1, points=8, max_steps=100).ends
    ('closed', 'closed')
    """

    equations: Equations
    configuration: Array
    free: NDArray[np.intp]
    names: Sequence[str]
    is_angle: NDArray[np.bool_]
    limits: Array
    search_range: Array
    tolerance: float

    def assemble(self) -> Assembly:
        """Close the linkage near the configuration, or come as near to a closed one as possible."""
        found = solve(self._free_equations, self.configuration[None, self.free], self.tolerance)
        q, residual = self._with_held_values(found.x)[0], float(found.residual[0])
        if self._names_beyond_limits(q):
            q = self._wrapped(q[None])[0]
        steps = f"after {found.iterations} step{'s' * (found.iterations != 1)}"
        if residual > self.tolerance:
            message = (
                f"Not closed {steps}: the residual is {residual:.2g}, in metres and radians together, and no small change "
                "of the joint values decreases it. Check that the links are long enough to meet, or try another guess."
            )
        elif names := self._names_beyond_limits(q):
            message = f"Closed to {residual:.1g} {steps}, but beyond the limits of {', '.join(names)}."
        else:
            message = f"Closed to {residual:.1g} {steps}."
        return Assembly(q, residual, found.iterations, residual <= self.tolerance, message)

    def search_modes(
        self, poses: Callable[[Array], Array], guesses: int | None = None, release: int | None = None
    ) -> ModeSearch:
        """Search for all configurations that close: from random guesses, and then along curves, if a held value is released.

        poses    of the bodies in configurations (m, n), first dimension m: equal in two configurations of one mode
        guesses  their number, rounded up to whole rounds of 64; None: until nothing new is found
        release  the index of a held value: where it returns to its value on the curve on which it changes, there is a mode

        Raises ValueError if in a configuration that closes the bodies can still move, and if the released value does not
        give exactly one degree of freedom.
        """
        # The guesses are random but the result must not be: every call draws the same ones.
        rng = np.random.default_rng(0)
        lower, upper = self._search_interval[:, self.free]
        modes: list[_Mode] = []
        rounds = idle_rounds = since_new = 0
        while self._continues(rounds, idle_rounds, [mode.hits for mode in modes], guesses):
            known = len(modes)
            hit = self._recorded(rng.uniform(lower, upper, (GUESSES_PER_ROUND, len(self.free))), poses, modes)
            for k in hit:
                modes[k].hits += 1
            rounds += 1
            idle_rounds, since_new = (idle_rounds + 1, since_new + len(hit)) if len(modes) == known else (0, 0)
        curves = 0 if release is None else self._follow_curves(release, poses, modes)
        modes.sort(key=lambda mode: list(mode.q))
        q = np.array([mode.q for mode in modes]).reshape(-1, len(self.configuration))
        hits = np.array([mode.hits for mode in modes], dtype=np.intp)
        return ModeSearch(q, hits, rounds * GUESSES_PER_ROUND, since_new, curves)

    def _recorded(self, guesses: Array, poses: Callable[[Array], Array], modes: list["_Mode"]) -> list[int]:
        """Close the linkage near guesses (m, k), and add the modes that are new: the index of the mode of each that closes."""
        found = solve(self._free_equations, guesses, self.tolerance, MAX_STEPS_PER_GUESS)
        # Near a solution a step squares the error, so one more step leaves only rounding errors.
        closed = found.x[found.residual <= self.tolerance]
        exact = solve(self._free_equations, closed, tolerance=0.0, iterations=1)
        candidates = self._wrapped(self._with_held_values(exact.x))
        recorded = []
        for q, pose, J in zip(candidates, poses(candidates), exact.jacobian, strict=True):
            if self._names_beyond_limits(q):
                continue
            same = (k for k, mode in enumerate(modes) if np.abs(pose - mode.pose).max() <= MODE_TOL)
            if (k := next(same, len(modes))) == len(modes):
                if mobility := self._mobility(q, J, poses):
                    raise ValueError(
                        "Assembly modes are single configurations, so no degree of freedom may be left; "
                        f"{mobility} left. Hold as many joint values as the linkage has degrees of freedom."
                    )
                modes.append(_Mode(q, pose))
            recorded.append(k)
        return recorded

    def _follow_curves(self, release: int, poses: Callable[[Array], Array], modes: list["_Mode"]) -> int:
        """Add the modes on the curves through those that are known, on which one held value changes: the number of curves."""
        held = self.configuration[release]
        free = np.sort(np.append(self.free, release))
        on_curves: set[int] = set()
        curves = 0
        # The list grows while it is read: a new mode may be on another curve, because only the poses of some bodies count.
        for k, mode in enumerate(modes):
            if k in on_curves:
                continue
            curve = replace(self, configuration=mode.q, free=free).trace(MODE_CURVE_STEP, None, MODE_CURVE_MAX_STEPS)
            q = curve.interpolate(SAMPLES_PER_STEP * len(curve.q)) if len(curve.q) > 1 else curve.q
            # The mode at which a closed curve begins has neighbours on both sides.
            q = np.concatenate([q, q[1 : 1 + curve.closed]])
            excess = wrap_angle(q[:, release] - held) if self.is_angle[release] else q[:, release] - held
            (at,) = np.nonzero((excess[:-1] * excess[1:] <= 0) & (np.abs(np.diff(excess)) < np.pi))
            share = excess[at] / np.where(excess[at] == excess[at + 1], 1.0, excess[at] - excess[at + 1])
            passages = q[at] + share[:, None] * (q[at + 1] - q[at])
            on_curves |= {k, *self._recorded(passages[:, self.free], poses, modes)}
            # Between two points it may also pass the held value twice: guesses on both sides of where it is nearest to it.
            size = np.abs(excess)
            (before,) = np.nonzero((size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]))
            self._recorded(np.concatenate([q[before], q[before + 2]])[:, self.free], poses, modes)
            curves += 1
        return curves

    @staticmethod
    def _continues(rounds: int, idle_rounds: int, hits: list[int], guesses: int | None) -> bool:
        """Whether the search for modes needs another round."""
        if guesses is not None:
            return rounds * GUESSES_PER_ROUND < guesses
        return idle_rounds < (MAX_IDLE_ROUNDS if 1 in hits else MIN_IDLE_ROUNDS)

    def _mobility(self, q: Array, J: Array, poses: Callable[[Array], Array]) -> int:
        """The number of degrees of freedom with which the bodies move at a configuration (n,), J (e, k) of the free values.

        A leg that spins between two spherical joints is no degree of freedom of the bodies if it is not one of them.
        """
        directions, _ = null_space(J)
        if not directions.shape[1]:
            return 0
        h = DIFFERENCE_STEP * self._with_zeros(directions.T)
        rates = (poses(q + h) - poses(q - h)).reshape(len(h), -1) / (2 * DIFFERENCE_STEP)
        U, sizes, _ = np.linalg.svd(rates)
        moves = np.count_nonzero(sizes > MOVES_TOL)
        moving, passive = directions @ U[:, :moves], directions @ U[:, moves:]
        x = q[self.free]
        with_legs_fixed = on_planes(self._free_equations, x, passive, np.zeros(passive.shape[1]))
        return finite_mobility(with_legs_fixed, x, moving, self.tolerance)

    def trace(self, step: float, points: int | None, max_steps: int, direction: Array | None = None) -> Curve:
        """Follow the motion from the configuration in both directions; points: at equal steps, if a number is given.

        direction  (n,) of the motion, if several lead away; its entries for held values do not count

        Raises ValueError if the configuration does not close or is beyond a limit, if without a direction not exactly one
        motion leads away from it, and if with a direction none is the nearest.
        """
        if names := self._names_beyond_limits(self.configuration):
            raise ValueError(
                f"The start must be within the limits; it is beyond those of {', '.join(names)}. Start from another q."
            )
        start = self.configuration[self.free]
        curve = self._tracer.follow(start, step, max_steps, None if direction is None else direction[self.free])
        if points is not None:
            curve = self._tracer.resample(curve, points)
        return replace(curve, q=self._with_held_values(curve.q), tangents=self._with_zeros(curve.tangents))

    def branch_directions(self, step: float) -> Array:
        """Find the unit tangents (b, n) of the motions that lead away from the configuration, each within a step.

        Raises ValueError if the configuration does not close, and if the tangents form a continuum.
        """
        return self._with_zeros(self._tracer.leaving(self.configuration[self.free], step)[1])

    @property
    def _tracer(self) -> CurveTracer:
        """What follows the curves of the free values."""
        free_names = [self.names[i] for i in self.free]
        return CurveTracer(
            self._free_equations, self.tolerance, free_names, self.is_angle[self.free], self.limits[self.free]
        )

    def _with_zeros(self, rates: Array) -> Array:
        """Rates (m, n) of all values from those of the free values (m, k): held values do not change."""
        full = np.zeros((len(rates), len(self.configuration)))
        full[:, self.free] = rates
        return full

    def _free_equations(self, x: Array) -> tuple[Array, Array]:
        """The equations as functions of the free values (m, k) alone."""
        r, J = self.equations(self._with_held_values(x))
        return r, J[..., self.free]

    def _with_held_values(self, x: Array) -> Array:
        """Configurations (m, n) from free values (m, k)."""
        q = np.tile(self.configuration, (len(x), 1))
        q[:, self.free] = x
        return q

    @cached_property
    def _search_interval(self) -> Array:
        """The lower and upper ends (2, n) of the intervals that are searched: within the limits, and one turn of an angle."""
        lower, upper = self.limits.T
        lower = np.maximum(lower, np.minimum(-self.search_range, upper - 2 * self.search_range))
        return np.stack([lower, np.minimum(upper, lower + 2 * self.search_range)])

    def _wrapped(self, q: Array) -> Array:
        """The same configurations (m, n), every free angle wrapped to the turn that begins at its lower limit, or at -pi."""
        lower = self._search_interval[0] - LIMIT_TOL
        is_free = np.isin(np.arange(len(self.configuration)), self.free)
        return np.where(is_free & self.is_angle, (q - lower) % (2 * np.pi) + lower, q)

    def _names_beyond_limits(self, q: Array) -> list[str]:
        """The names of the values of a configuration (n,) that are beyond their limits."""
        is_beyond = (q < self.limits[:, 0] - LIMIT_TOL) | (q > self.limits[:, 1] + LIMIT_TOL)
        return [name for name, beyond in zip(self.names, is_beyond, strict=True) if beyond]
