"""Hypothesis strategies: rotation vectors, twists, poses, screws and chains, with critical angles drawn often.

No rotation is computed by kinlib. Poses are made from unit quaternions, so that a fault in exp cannot hide itself.
"""

from inspect import get_annotations, getmembers, isfunction

import numpy as np
from hypothesis import strategies as st
from outside.motions import pose

import kinlib as kl
from kinlib import robots

ROBOT_FUNCTIONS = [
    f for _, f in getmembers(robots, isfunction) if f is not robots.arm and get_annotations(f)["return"] == "Chain"
]
"""The functions of kinlib.robots that return a robot. A new one is tested as soon as it is added."""

ROBOTS = [family() for family in ROBOT_FUNCTIONS]
"""Every robot of kinlib.robots with its default lengths."""

CRITICAL_ANGLES_RAD = [0.0, 1e-12, 1e-7, 1e-1, 1.0, np.pi - 1e-7, np.pi - 1e-12, np.pi]
"""Angles near which formulas for rotations become singular or inaccurate: 0, almost 0, and half a turn."""


def angles(largest=np.pi):
    """Angles in [0, most]: half of them critical angles or close to one, the rest anywhere between."""
    beside = st.builds(
        lambda hard, off: min(abs(hard - off), largest), st.sampled_from(CRITICAL_ANGLES_RAD), st.floats(0, 1e-6)
    )
    return st.one_of(
        st.sampled_from([hard for hard in CRITICAL_ANGLES_RAD if hard <= largest]),
        beside,
        st.floats(0, largest),
        st.floats(0, largest),
    )


def directions():
    """Unit vectors: along the coordinate axes, and in any direction."""
    # Half of the smallest subnormal number is 0: such a direction is another one when it is scaled.
    anywhere = (
        st.tuples(*[st.floats(-1, 1, allow_subnormal=False)] * 3)
        .map(np.array)
        .filter(lambda u: np.linalg.norm(u) > 0.1)
    )
    axes = st.sampled_from([*np.eye(3), *-np.eye(3)])
    return st.one_of(axes, anywhere.map(lambda u: u / np.linalg.norm(u)))


def points(reach=1.0):
    return st.tuples(*[st.floats(-reach, reach)] * 3).map(np.array)


def rotation_vectors(largest=np.pi):
    return st.builds(lambda angle, u: angle * u, angles(largest), directions())


def twists(largest=np.pi):
    return st.builds(lambda omega, v: np.concatenate([omega, v]), rotation_vectors(largest), points())


def rotations():
    return st.builds(_rotation, angles(), directions())


def poses():
    return st.builds(pose, rotations(), points())


def screws():
    """Unit screw axes: revolute, prismatic (pitch inf) and helical."""
    pitches = st.one_of(st.just(0.0), st.just(np.inf), st.floats(-1, 1))
    return st.builds(kl.screw, directions(), points(), pitches)


def chains(max_joints=6):
    return st.builds(kl.Chain, st.lists(screws(), min_size=1, max_size=max_joints).map(np.array), poses())


@st.composite
def chains_with_values(draw, max_joints=6):
    """A chain and joint values for it, between -4 and 4 radians or metres."""
    chain = draw(chains(max_joints))
    return chain, np.array(draw(st.lists(st.floats(-4, 4), min_size=chain.n, max_size=chain.n)))


def configurations(chain, count):
    """Configurations (count, n) with values from -pi to pi radians or metres, the same ones every time."""
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
