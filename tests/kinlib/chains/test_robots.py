"""The robots of the documents: what a deck prints and is right comes out; notebooks/errata.ipynb proves what is wrong."""

import numpy as np
import pytest
from strategies import ROBOT_FUNCTIONS, ROBOTS, configurations

from kinlib import robots

PI = np.pi


def close(got, expected, atol=1e-13):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


@pytest.mark.parametrize("family", ROBOT_FUNCTIONS, ids=lambda family: family.__name__)
def test_every_robot_knows_its_source_and_has_a_name_of_its_own(family):
    robot = family()
    assert len(robot.source.split()) > 2, "source names the document, with the page"
    assert [other.name for other in ROBOTS].count(robot.name) == 1


def standard(*rows):
    """Rows of (offset, d, a, alpha), angles in degrees."""
    rtb = pytest.importorskip("roboticstoolbox")
    return rtb.DHRobot([rtb.RevoluteDH(offset=np.radians(o), d=d, a=a, alpha=np.radians(al)) for o, d, a, al in rows])


def test_the_arms_of_makers_move_as_their_tables_do():
    rtb = pytest.importorskip("roboticstoolbox")
    turns, lengths, offsets = (
        (90, 0, 0, 90, -90, 0),
        (0, -0.425, -0.3922, 0, 0, 0),
        (0.1625, 0, 0, 0.1333, 0.0997, 0.0996),
    )
    tables = {
        robots.ur5e: standard(*((0, d, a, alpha) for d, a, alpha in zip(offsets, lengths, turns, strict=True))),
        robots.panda: rtb.models.DH.Panda(),
        robots.scara: rtb.models.DH.Cobra600(),
    }
    tables[robots.panda].tool = np.eye(4)  # theirs has a gripper; ours ends at the flange
    for make, table in tables.items():
        robot = make()
        for q in configurations(robot, 5):
            close(robot.fk(q), table.fkine(q).A)


def drawn_robots():
    """Each robot, and how one walks from its base to its tool: turns and steps as the drawing has them."""
    from spatialmath import SE3

    turn = {"x": SE3.Rx, "y": SE3.Ry, "z": SE3.Rz}

    def walk(*steps):
        """Letter and angle, or a step along x, y, z."""
        made = SE3()
        for step in steps:
            made = made * (turn[step[0]](step[1]) if isinstance(step[0], str) else SE3(*step))
        return made.A

    yield (
        robots.plain_arm(0.4, 0.5, 0.3),
        lambda q: walk(("z", q[0]), (0, 0, 0.4), ("y", -q[1]), (0.5 + q[2], 0, 0), ("x", q[3]), (0.3, 0, 0)),
    )
    yield (
        robots.angled_arm(0.7, 0.4, 0.5, 0.3),
        lambda q: walk(
            *(("z", q[0]), (0, 0, 0.4), ("y", 0.7), ("z", q[1]), (0, 0, 0.5 + q[2]), ("y", q[3] - 0.7), (0.3, 0, 0))
        ),
    )
    yield (
        robots.mid_formula_arm(0.6, 0.4, 0.2),
        lambda q: walk(
            *(("z", q[0]), (0, 0, 0.4), ("y", q[1]), (0.6, 0, 0), ("x", q[2]), ("y", q[3]), (0.2, 0, 0), ("y", PI / 2))
        ),
    )
    yield (
        robots.hrr(0.1, 0.5, 0.3),
        lambda q: walk(("z", q[0]), (0.5, 0, 0.1 * q[0]), ("z", q[1]), (0.3, 0, 0), ("z", q[2])),
    )


def test_a_robot_moves_as_spatialmath_walks_through_its_drawing():
    pytest.importorskip("spatialmath")
    for robot, walked in drawn_robots():
        for q in configurations(robot, 5):
            close(robot.fk(q), walked(q))
