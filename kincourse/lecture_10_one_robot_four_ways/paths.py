"""Joint paths of the project: one writes on the table, one hits it, one leaves the joint limits, and one stays above it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from misstep.sampling import Sampler

STEPS = 25
"""The number of configurations of a path."""

STROKE_M, HOVER_M, DIP_M = 0.14, 0.02, 0.03
"""The length of the line that is written, and how far the other paths are above the table and below it."""

CONTACT_M = 1e-3
"""A pen this near to the table touches it."""

BEYOND = 0.12
"""How far the path that leaves the limits does so, in radians and metres."""

EFFECTS = {
    "writes": "puts the pen on the paper",
    "hits": "drives the pen into the table",
    "leaves": "leaves the joint limits",
    "hovers": "stays above the table",
}


@dataclass(frozen=True, eq=False)
class JointPath:
    """A path of the joints, (STEPS, n), what it does, one of EFFECTS, and the height of the table in {s}."""

    q: Array
    effect: str
    table_m: float


def draw_paths(chain: Chain, limits: Array, sampler: Sampler) -> dict[str, JointPath]:
    """Draw one path of each effect, named A to D in a random order.

    >>> from kincourse.lecture_10_one_robot_four_ways.arms import draw_machine
    >>> machine, sampler = draw_machine("ada"), Sampler("ada", "10.paths")
    >>> sorted(path.effect for path in draw_paths(machine.chain, machine.limits, sampler).values())
    ['hits', 'hovers', 'leaves', 'writes']
    """
    paths = None
    while paths is None:
        paths = _try(chain, limits, sampler)
    return {name: paths[effect] for name, effect in zip("ABCD", sampler.shuffled(list(EFFECTS)), strict=True)}


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
    angle = np.radians(sampler.integer(0, 11) * 30)
    along = np.array([np.cos(angle), np.sin(angle), 0.0])
    share = np.linspace(0, 1, STEPS)[:, None]
    dip = np.sin(np.pi * share) * (0, 0, 1)
    line = tip + STROKE_M * share * along
    found = {
        "writes": _follow(chain, q, line),
        "hovers": _follow(chain, q, line[::-1] + np.array([0, 0, HOVER_M])),
        "hits": _follow(chain, q, tip - STROKE_M * share * along - DIP_M * dip),
        "leaves": _leave(chain, limits, sampler, tip[2]),
    }
    paths = {
        effect: JointPath(path.round(4), effect, float(tip[2])) for effect, path in found.items() if path is not None
    }
    if len(paths) < len(EFFECTS) or any(effect_of(chain, path) != effect for effect, path in paths.items()):
        return None
    return paths


def _within(limits: Array, sampler: Sampler, margin: float) -> Array:
    low, high = limits.T
    shares = np.array([margin + (1 - 2 * margin) * sampler.integer(0, 100) / 100 for _ in low])
    return np.asarray(low + shares * (high - low))


def _follow(chain: Chain, start: Array, points: Array) -> Array | None:
    """Follow points with the tool by damped least squares, from the configuration `start`; None if it cannot."""
    q, path = start.copy(), []
    for point in points:
        for _ in range(60):
            error = point - chain.fk(q)[:3, 3]
            if np.linalg.norm(error) < 1e-6:
                break
            J = _position_jacobian(chain, q)
            q += J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(3), error)
        else:
            return None
        path.append(q.copy())
    found = np.array(path)
    smooth = np.abs(np.diff(found, axis=0)).max() < 0.2
    return found if smooth and chain.within_limits(found).all() else None


def _position_jacobian(chain: Chain, q: Array) -> Array:
    """The velocity of the tool's origin for each joint, (3, n): omega x p + v."""
    J, p = chain.jacobian(q), chain.fk(q)[:3, 3]
    velocity: Array = np.cross(J[:3].T, p).T + J[3:]
    return velocity


def _leave(chain: Chain, limits: Array, sampler: Sampler, table_m: float) -> Array | None:
    """Move one joint beyond a limit, while the pen stays above the table."""
    start = _within(limits, sampler, 0.15)
    for joint, side in _shuffled_pairs(chain.n, sampler):
        end = start.copy()
        end[joint] = limits[joint, side] + (BEYOND if side else -BEYOND)
        path = start + np.linspace(0, 1, STEPS)[:, None] * (end - start)
        if chain.fk(path)[:, 2, 3].min() > table_m + 0.01:
            return path
    return None


def _shuffled_pairs(n: int, sampler: Sampler) -> Iterator[tuple[int, int]]:
    yield from sampler.shuffled([(joint, side) for joint in range(n) for side in (0, 1)])
