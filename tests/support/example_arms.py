"""Arms for frame assignment: neighbouring axes in every case that two lines can be in, mixed with slides."""

import hypothesis
import numpy as np

import kinlib as kl

CASES = ("skew", "intersecting", "parallel", "anti-parallel", "coincident", "anti-coincident")
NEARLY = "nearly parallel"

ANGLES = (*(10.0**-k for k in range(16, 2, -1)), 3e-9, 3e-8)
"""How far off parallel, in radians: from less than a double can hold, past the singular range, to a tenth of a degree."""


def few(count):
    """Return the number of arms, or a tenth of it under `nox -s mutation`, which draws them again for each mutant."""
    return count if hypothesis.settings.get_current_profile_name() != "mutation" else max(count // 10, 5)


def unit(v):
    return v / np.linalg.norm(v)


def arm(rng, n, cases=CASES, angle=None, slides=0.25):
    """An arm of n joints, and the case of each pair of neighbours, drawn from `cases`.

    angle   how far apart axes are that are nearly parallel; given, that case is drawn too
    slides  the share of prismatic joints

    Links are up to half a metre long, so that the longest arm reaches some four metres: errors in metres grow with it.
    """
    cases = (*cases, NEARLY) if angle is not None else cases
    z, point = unit(rng.normal(size=3)), rng.uniform(-1, 1, 3)
    screws, points, met = [], [], []
    for joint in range(n):
        if joint:
            met.append(cases[rng.integers(len(cases))])
            z, point = _next(rng, met[-1], z, point, angle)
        screws.append(kl.screw(z, point, np.inf if rng.random() < slides else 0.0))
        points.append(point)
    home = kl.exp(np.concatenate([rng.normal(size=3), np.zeros(3)]))
    home[:3, 3] = point + rng.uniform(-0.3, 0.3, 3)
    return kl.Chain(np.array(screws), home, np.array(points)), met


def _next(rng, case, z, point, angle):
    """An axis that lies to the one before as the case says."""
    off = rng.uniform(-0.3, 0.3, 3)
    if case == "skew":
        return unit(rng.normal(size=3)), point + off
    if case == "intersecting":
        other = unit(rng.normal(size=3))
        place = point + z * rng.uniform(-0.3, 0.3)
        return other, place + other * rng.uniform(-0.3, 0.3) * (rng.random() < 0.5)  # every other joint at the crossing
    if case == NEARLY:
        leaning = unit(z + angle * unit(np.cross(z, rng.normal(size=3))))
        return leaning * rng.choice([-1, 1]), point + off
    sign = -1 if case.startswith("anti") else 1
    return sign * z, point + (z * rng.uniform(-0.5, 0.5) if case.endswith("coincident") else off)


def configurations(rng, chain, count=50, reach=1.0):
    """Joint values (count, n): up to half a turn, up to `reach` metres."""
    q = rng.uniform(-1, 1, (count, chain.n))
    return q * np.where(np.array(list(chain.joint_types)) == "P", reach, np.pi)


def rechosen(rng, chain):
    """The same arm with all that a DH table leaves free chosen anew: x and z turned round, origins slid along parallel
    axes, zeros shifted, slides moved aside, another base and another tool."""
    table = kl.assign_frames(chain, convention="modified").table
    a, alpha, d, theta = table.rows.T.copy()
    for i in range(1, table.n):
        if rng.random() < 0.5:  # x_{i-1} turned round
            a[i], alpha[i] = -a[i], -alpha[i]
            theta[i - 1], theta[i] = theta[i - 1] + np.pi, theta[i] - np.pi
        if alpha[i] == 0:
            slid = rng.normal()
            d[i - 1], d[i] = d[i - 1] + slid, d[i] - slid
    turns = np.array(list(table.joints)) == "R"
    theta[turns] += rng.normal(size=turns.sum())
    d[~turns] += rng.normal(size=(~turns).sum())
    base, tool = (kl.exp(rng.normal(size=6)) for _ in range(2))
    rows = np.column_stack([a, alpha, d, theta])
    moved = kl.DHTable(rows, convention="modified", joints=table.joints, base=base, tool=tool).to_chain()
    signs = rng.choice([-1.0, 1.0], size=(table.n, 1))
    return kl.Chain(signs * moved.screws, moved.home)
