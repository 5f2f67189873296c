"""What the property tests draw: rotation vectors, twists, poses, screws and chains, with the hard angles drawn often.

Nothing here asks kinlib for a rotation. Poses are made from unit quaternions, so that a fault in exp cannot hide itself.
"""

from inspect import get_annotations, getmembers, isfunction

import numpy as np
from hypothesis import strategies as st

import kinlib as kl
from kinlib import robots

FAMILIES = [
    f for _, f in getmembers(robots, isfunction) if f is not robots.arm and get_annotations(f)["return"] is kl.Chain
]
"""The functions that make the robots of the course; one that is added is tested from then on."""

ROBOTS = [family() for family in FAMILIES]
"""Every robot of the course with its default lengths."""

HARD = [0.0, 1e-12, 1e-7, 1e-1, 1.0, np.pi - 1e-7, np.pi - 1e-12, np.pi]
"""Where the formulas for rotations change their nature: no turn, hardly any, half a turn."""


def angles(most=np.pi):
    """Angles in [0, most]: one in two a hard one or close beside it, the rest anywhere between."""
    beside = st.builds(lambda hard, off: min(abs(hard - off), most), st.sampled_from(HARD), st.floats(0, 1e-6))
    return st.one_of(
        st.sampled_from([hard for hard in HARD if hard <= most]), beside, st.floats(0, most), st.floats(0, most)
    )


def directions():
    """Unit vectors: along the axes, and anywhere."""
    anywhere = st.tuples(*[st.floats(-1, 1)] * 3).map(np.array).filter(lambda u: np.linalg.norm(u) > 0.1)
    axes = st.sampled_from([*np.eye(3), *-np.eye(3)])
    return st.one_of(axes, anywhere.map(lambda u: u / np.linalg.norm(u)))


def points(reach=1.0):
    return st.tuples(*[st.floats(-reach, reach)] * 3).map(np.array)


def rotation_vectors(most=np.pi):
    return st.builds(lambda angle, u: angle * u, angles(most), directions())


def twists(most=np.pi):
    return st.builds(lambda omega, v: np.concatenate([omega, v]), rotation_vectors(most), points())


def rotations():
    return st.builds(_rotation, angles(), directions())


def poses():
    return st.builds(_pose, rotations(), points())


def screws():
    """Unit screw axes: revolute, prismatic (pitch inf) and helical."""
    pitches = st.one_of(st.just(0.0), st.just(np.inf), st.floats(-1, 1))
    return st.builds(kl.screw, directions(), points(), pitches)


def chains(most=6):
    return st.builds(kl.Chain, st.lists(screws(), min_size=1, max_size=most).map(np.array), poses())


@st.composite
def moved_chains(draw, most=6):
    """A chain and joint values for it, of a few turns and a few metres."""
    chain = draw(chains(most))
    return chain, np.array(draw(st.lists(st.floats(-4, 4), min_size=chain.n, max_size=chain.n)))


def configurations(chain, count):
    """Joint values (count, n) from -pi to pi radians and metres, the same each time."""
    return np.random.default_rng(7).uniform(-np.pi, np.pi, (count, chain.n))


def _rotation(angle, axis):
    w, (x, y, z) = np.cos(angle / 2), np.sin(angle / 2) * axis
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )


def _pose(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T
