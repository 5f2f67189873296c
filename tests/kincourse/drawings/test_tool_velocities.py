"""The velocities that the joints give to the end-effector, against finite differences, and the lost direction."""

import numpy as np

from kincourse.lecture_04b_velocity.drawings import tool_velocities
from kinlib.chains.robots import puma560, rpr, youbot


def test_the_velocities_are_those_of_the_moving_tool():
    for chain in (youbot(), rpr(), puma560()):
        q, step = np.random.default_rng(1).uniform(-1, 1, chain.n), 1e-6
        moved = [(chain.fk(q + step * e)[:3, 3] - chain.fk(q - step * e)[:3, 3]) / (2 * step) for e in np.eye(chain.n)]
        assert np.allclose(tool_velocities(chain, q), moved, atol=1e-8)
