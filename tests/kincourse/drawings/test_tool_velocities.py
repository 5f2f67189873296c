"""The velocities that the joints give to the end-effector, against finite differences, and the lost direction."""

import numpy as np

from kincourse.lecture_04b_velocity.drawings import draw_tool_velocities, tool_velocities
from kinlib.chains.robots import puma560, rpr, youbot

BENT = np.radians([20, 60, -60, -40, 10])


def test_the_velocities_are_those_of_the_moving_tool():
    for chain in (youbot(), rpr(), puma560()):
        q, step = np.random.default_rng(1).uniform(-1, 1, chain.n), 1e-6
        moved = [(chain.fk(q + step * e)[:3, 3] - chain.fk(q - step * e)[:3, 3]) / (2 * step) for e in np.eye(chain.n)]
        assert np.allclose(tool_velocities(chain, q), moved, atol=1e-8)


def test_a_stretched_arm_loses_the_direction_of_its_arm():
    stretched, bent = draw_tool_velocities(youbot(), np.zeros(5)), draw_tool_velocities(youbot(), BENT)
    assert stretched.alt.endswith("No joint rates move it along (1, 0, 0).")
    assert "no motion" in stretched.svg
    assert bent.alt.endswith("Joint rates move it in every direction.")
    assert "no motion" not in bent.svg
    labels = [f"joint {i}" in bent.svg for i in range(1, 6)]
    assert labels == [True, True, True, True, False], "the last joint does not move the tool"
