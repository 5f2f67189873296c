"""The robots of the documents: what a deck prints and is right comes out; notebooks/errata.ipynb proves what is wrong."""

import numpy as np
import pytest
from strategies import ROBOT_FUNCTIONS, ROBOTS, configurations

from kinlib import DHTable, assign_frames, equivalent, robots


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
            np.testing.assert_allclose(robot.fk(q), table.fkine(q).A, rtol=0, atol=1e-13)


def test_puma_560_is_that_of_the_robotics_toolbox_up_to_the_choices_of_its_frames():
    links = pytest.importorskip("roboticstoolbox").models.DH.Puma560().links
    theirs = DHTable([[link.a, link.alpha, link.d, link.theta] for link in links], convention="standard")
    assert equivalent(theirs, robots.puma560())
    assert equivalent(theirs, assign_frames(robots.puma560(), convention="modified").table)
