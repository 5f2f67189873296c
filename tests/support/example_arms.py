"""Random arms for frame assignment: neighbouring axes in all relative positions of two lines, and prismatic joints."""

import numpy as np

import kinlib as kl

AXIS_CASES = ("skew", "intersecting", "parallel", "antiparallel", "coincident", "anti-coincident")
NEARLY_PARALLEL = "nearly parallel"

NEARLY_PARALLEL_ANGLES_RAD = (1e-16, 1e-13, 1e-11, 1e-10, 1e-9, 3e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3)
"""Angles between nearly parallel axes: from below double precision through the singular range of DH to 0.06 degrees."""


def normalized(v):
    return v / np.linalg.norm(v)


def arm(rng, n, cases=AXIS_CASES, angle=None, slides=0.25):
    """Draw an arm of n joints, and the case of each pair of neighbouring axes from `cases`.

    angle   the angle between nearly parallel axes in radians; if it is given, that case is drawn too
    slides  the probability of a prismatic joint

    Links are at most half a metre long, so that the longest arm reaches about four metres, with which errors grow.
    """
    cases = (*cases, NEARLY_PARALLEL) if angle is not None else cases
    z, point = normalized(rng.normal(size=3)), rng.uniform(-1, 1, 3)
    screws, points, pair_cases = [], [], []
    for joint in range(n):
        if joint:
            pair_cases.append(cases[rng.integers(len(cases))])
            z, point = _next_axis(rng, pair_cases[-1], z, point, angle)
        screws.append(kl.screw(z, point, np.inf if rng.random() < slides else 0.0))
        points.append(point)
    home = kl.exp(np.concatenate([rng.normal(size=3), np.zeros(3)]))
    home[:3, 3] = point + rng.uniform(-0.3, 0.3, 3)
    return kl.Chain(np.array(screws), home, np.array(points)), pair_cases


def _next_axis(rng, case, z, point, angle):
    """Draw an axis, as direction and point, in a relative position to the one before it."""
    off = rng.uniform(-0.3, 0.3, 3)
    if case == "skew":
        return normalized(rng.normal(size=3)), point + off
    if case == "intersecting":
        other = normalized(rng.normal(size=3))
        place = point + z * rng.uniform(-0.3, 0.3)
        # In half of the cases the joint is at the intersection.
        return other, place + other * rng.uniform(-0.3, 0.3) * (rng.random() < 0.5)
    if case == NEARLY_PARALLEL:
        leaning = normalized(z + angle * normalized(np.cross(z, rng.normal(size=3))))
        return leaning * rng.choice([-1, 1]), point + off
    sign = -1 if case.startswith("anti") else 1
    return sign * z, point + (z * rng.uniform(-0.5, 0.5) if case.endswith("coincident") else off)


def configurations(rng, chain, count=50, reach=1.0):
    """Draw configurations (count, n): joint values up to half a turn, or up to `reach` metres."""
    q = rng.uniform(-1, 1, (count, chain.n))
    return q * np.where(np.array(list(chain.joint_types)) == "P", reach, np.pi)


def with_other_choices(rng, chain):
    """The same mechanism with other choices of everything that a DH table leaves free: directions of x and z, origins along
    parallel axes, zero configuration, places of prismatic joints, base and tool."""
    table = kl.assign_frames(chain, convention="modified").table
    a, alpha, d, theta = table.rows.T.copy()
    for i in range(1, table.n):
        if rng.random() < 0.5:  # x_{i-1} reversed
            a[i], alpha[i] = -a[i], -alpha[i]
            theta[i - 1], theta[i] = theta[i - 1] + np.pi, theta[i] - np.pi
        if alpha[i] == 0:
            shift = rng.normal()
            d[i - 1], d[i] = d[i - 1] + shift, d[i] - shift
    turns = np.array(list(table.joints)) == "R"
    theta[turns] += rng.normal(size=turns.sum())
    d[~turns] += rng.normal(size=(~turns).sum())
    base, tool = (kl.exp(rng.normal(size=6)) for _ in range(2))
    rows = np.column_stack([a, alpha, d, theta])
    moved = kl.DHTable(rows, convention="modified", joints=table.joints, base=base, tool=tool).to_chain()
    signs = rng.choice([-1.0, 1.0], size=(table.n, 1))
    return kl.Chain(signs * moved.screws, moved.home)
