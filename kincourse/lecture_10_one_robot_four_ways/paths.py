"""Joint paths of the project: one writes on the table, one hits it, one leaves the joint limits, and one stays above it."""

from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from misstep.sampling import Sampler

STEPS = 25
"""The number of configurations of a path."""

SHARES = np.linspace(0, 1, STEPS)[:, None]

STROKE_M = 0.14
"""The length of the line that is written, and of those above the table and into it."""

HOVER_MM, DIP_MM = (6, 25), (12, 35)
"""How far these two are above the table and below it, from and to."""

CONTACT_M = 1e-3
"""A pen this near to the table touches it."""

BEYOND = (0.03, 0.3)
"""How far the path that leaves the limits does so, from and to, in radians and metres; its pen writes all the while."""

TRIES, MAX_ITERATIONS = 20, 20
"""How often a path that leaves the limits is drawn for one table, and how many steps lead to a point of a path."""

EFFECTS = ("writes", "hits", "leaves", "hovers")
"""What a path does: it puts the pen on the paper, drives it into the table, leaves the joint limits, or stays above the table."""


@dataclass(frozen=True, eq=False)
class JointPath:
    """A path of the joints, (STEPS, n), and the height of the table in {s}."""

    q: Array
    table_m: float


def draw_paths(chain: Chain, limits: Array, sampler: Sampler) -> dict[str, JointPath]:
    """Draw one path of each effect, named A to D in a random order."""
    paths = None
    while paths is None:
        paths = _try(chain, limits, sampler)
    return {name: paths[effect] for name, effect in zip("ABCD", sampler.shuffled(EFFECTS), strict=True)}


def effect_of(chain: Chain, path: JointPath) -> str:
    """Say what a path does, from the forward kinematics of a chain with limits.

    Where several are true, leaving the limits is first: such a path cannot be driven at all.
    """
    if not chain.within_limits(path.q).all():
        return "leaves"
    heights = chain.fk(path.q)[:, 2, 3] - path.table_m
    if heights.min() < -CONTACT_M:
        return "hits"
    return "writes" if heights.max() < CONTACT_M else "hovers"


def _try(chain: Chain, limits: Array, sampler: Sampler) -> dict[str, JointPath] | None:
    """Draw a configuration, and follow four lines from it; None if one of them cannot be followed."""
    q = _within(limits, sampler, 0.25)
    tip = chain.fk(q)[:3, 3]
    along = _drawn_line(sampler)
    hover, dip = (sampler.integer(*heights) / 1000 for heights in (HOVER_MM, DIP_MM))
    below = dip * np.sin(np.pi * SHARES) * (0, 0, 1)
    found = {
        "writes": _follow(chain, q, tip + along),
        "hovers": _follow(chain, q, tip + along[::-1] + np.array([0, 0, hover])),
        "hits": _follow(chain, q, tip - along - below),
    }
    if any(path is None for path in found.values()):
        return None
    tries = (_leave(chain, limits, sampler, tip[2]) for _ in range(TRIES))
    found["leaves"] = next((path for path in tries if path is not None), None)
    paths = {effect: JointPath(path.round(4), float(tip[2])) for effect, path in found.items() if path is not None}
    if len(paths) < len(EFFECTS) or any(effect_of(chain, path) != effect for effect, path in paths.items()):
        return None
    return paths


def _drawn_line(sampler: Sampler) -> Array:
    """The points of a line in the plane of the table, (STEPS, 3), from 0 on."""
    angle = np.radians(sampler.integer(0, 11) * 30)
    return STROKE_M * SHARES * (np.cos(angle), np.sin(angle), 0.0)


def _within(limits: Array, sampler: Sampler, margin: float) -> Array:
    low, high = limits.T
    shares = np.array([margin + (1 - 2 * margin) * sampler.integer(0, 100) / 100 for _ in low])
    return np.asarray(low + shares * (high - low))


def _follow(chain: Chain, start: Array, points: Array) -> Array | None:
    """Follow points with the tool by damped least squares, from the configuration `start`; None if it cannot, or jumps."""
    q, path = start.copy(), []
    for point in points:
        for _ in range(MAX_ITERATIONS):
            tip, twists = chain.fk(q)[:3, 3], chain.jacobian(q)
            error = point - tip
            if np.linalg.norm(error) < 1e-6:
                break
            J = np.cross(twists[:3].T, tip).T + twists[3:]  # the velocity of the tip for each joint, v + omega x p
            q += J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(3), error)
        else:
            return None
        path.append(q.copy())
    found = np.array(path)
    return found if np.abs(np.diff(found, axis=0)).max() < 0.2 else None


def _leave(chain: Chain, limits: Array, sampler: Sampler, table_m: float) -> Array | None:
    """Write a line on the table on which a joint leaves its limits: from the height of the pen alone it looks right."""
    start = _within(limits, sampler, 0.15)
    joint, side = sampler.integer(0, chain.n - 1), sampler.integer(0, 1)
    start[joint] = limits[joint, side]
    x, y, _ = chain.fk(start)[:3, 3]
    path = _follow(chain, start, np.array([x, y, table_m]) + _drawn_line(sampler))
    if path is None:
        return None
    low, high = limits.T
    outside = float(np.maximum(low - path, path - high).max())
    return path if BEYOND[0] < outside < BEYOND[1] else None
