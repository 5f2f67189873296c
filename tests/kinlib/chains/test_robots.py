"""The robots of the documents: what a deck prints and is right comes out; notebooks/errata.ipynb proves what is wrong."""

import numpy as np
import pytest
from strategies import ROBOT_FUNCTIONS, ROBOTS, configurations

from kinlib import exp, robots, screw

PI = np.pi


def close(got, expected, atol=1e-13):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


# --- each is what it says ---

JOINT_TYPES = {
    "rpr": "RPR",
    "rppr": "RPPR",
    "rprr": "RPRR",
    "youbot": "RRRRR",
    "puma560": "RRRRRR",
    "ur5e": "RRRRRR",
    "panda": "RRRRRRR",
    "scara": "RRPR",
    "rpr_lecture7": "RPR",
    "plain_arm": "RRPR",
    "angled_arm": "RRPR",
    "mid_formula_arm": "RRRR",
    "hrr": "HRR",
}


def test_the_joint_types_are_those_of_the_documents():
    """A new robot is added to JOINT_TYPES, as it is read off the drawing of its document."""
    assert {family.__name__: family().joint_types for family in ROBOT_FUNCTIONS} == JOINT_TYPES


@pytest.mark.parametrize("family", ROBOT_FUNCTIONS, ids=lambda family: family.__name__)
def test_every_robot_knows_its_source_and_has_a_name_of_its_own(family):
    robot = family()
    assert len(robot.source.split()) > 2, "source names the document, with the page"
    assert [other.name for other in ROBOTS].count(robot.name) == 1


# --- against the tables, by roboticstoolbox ---


def modified(*rows):
    """RPRR, PUMA and the planar RPR: rows of (letter, alpha_{i-1}, a_{i-1}, d_i, theta_i), angles in degrees."""
    rtb = pytest.importorskip("roboticstoolbox")
    links = []
    for letter, alpha, a, d, theta in rows:
        common = {"alpha": np.radians(alpha), "a": a}
        if letter == "R":
            links.append(rtb.RevoluteMDH(d=d, offset=np.radians(theta), **common))
        else:
            links.append(rtb.PrismaticMDH(theta=np.radians(theta), offset=d, **common))
    return rtb.DHRobot(links)


def standard(*rows):
    """The youBot: rows of (offset, d, a, alpha), angles in degrees."""
    rtb = pytest.importorskip("roboticstoolbox")
    return rtb.DHRobot([rtb.RevoluteDH(offset=np.radians(o), d=d, a=a, alpha=np.radians(al)) for o, d, a, al in rows])


def along(x=0.0, z=0.0):
    return exp([0, 0, 0, x, 0, z])


L2, L4, L5 = 0.7, 0.25, 0.35
A2, A3, D3, D4 = 0.41, 0.03, 0.16, 0.44


PRINTED_TABLES = (
    (
        lambda: robots.rprr(L2, L4, L5),
        modified,
        [("R", 0, 0, 0, 0), ("P", -90, 0, 0, -90), ("R", -90, L2, 0, 0), ("R", 90, 0, 0, 0)],
        along(x=-L4, z=L5),  # row 5, which has no joint
    ),
    (
        lambda: robots.puma560(A2, A3, D3, D4),
        modified,
        [
            ("R", 0, 0, 0, 0),
            ("R", -90, 0, 0, 0),
            ("R", 0, A2, D3, 0),
            ("R", -90, A3, D4, 0),
            ("R", 90, 0, 0, 0),
            ("R", -90, 0, 0, 0),
        ],
        along(),
    ),
    (
        lambda: robots.rpr_lecture7(0.6),
        modified,
        [("R", 0, 0, 0, 0), ("P", 90, 0.6, 0, 0), ("R", -90, 0, 0, 0)],
        along(),
    ),
    (
        robots.youbot,
        standard,
        [(0, 0.147, 0.033, 90), (0, 0, 0.155, 0), (0, 0, 0.135, 0), (90, 0, 0, 90), (0, 0.2175, 0, 0)],
        along(),
    ),
)
"""Each robot with the convention, the rows and the tool of its document."""


def test_the_screws_move_as_the_printed_table_does():
    for make, convention, rows, tool in PRINTED_TABLES:
        robot, arm = make(), convention(*rows)
        for q in configurations(robot, 20):
            close(robot.fk(q), arm.fkine(q).A @ tool)


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
    tables[robots.panda].tool = along()  # theirs has a gripper; ours ends at the flange
    for make, table in tables.items():
        robot = make()
        for q in configurations(robot, 5):
            close(robot.fk(q), table.fkine(q).A)


# --- as they are drawn, step by step, by spatialmath ---


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


# --- EduFill: the youBot ---


def test_the_youbot_in_the_drawn_configuration_steps_up_by_its_third_link():
    """[0, 0, pi/2, -pi/2, -pi/4]: two lengths forward, one up, the last forward again, the gripper turned by 45 degrees."""
    T = robots.youbot().fk([0, 0, PI / 2, -PI / 2, -PI / 4])
    close(T[:3, 3], (0.033 + 0.155 + 0.2175, 0, 0.147 + 0.135))
    close(T[:3, 2], (1, 0, 0))
    close(T[:3, 0], np.array([0, 1, 1]) / np.sqrt(2))


# --- Forward kinematics II, example 1 ---

PRINTED_M1 = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0]])


def test_our_M_of_example_1_differs_from_the_printed_one_in_two_entries():
    assert np.argwhere(robots.rpr().home != PRINTED_M1).tolist() == [[2, 0], [3, 3]]


# --- Forward kinematics II, example 2 ---


def test_B1_and_B4_of_example_2_are_as_printed():
    w, q1, q4 = (0, 1, 0), (-2, -2, 0), (-2, 0, 0)
    for q in (q1, q4):
        np.testing.assert_array_equal(screw(w, q), [0, 1, 0, 0, 0, -2])
    close(robots.rppr().body_screws[[0, 3]], [[0, 1, 0, 0, 0, -2]] * 2, atol=1e-15)
    # The same points in {s}, by way of M: there the chain has its joints.
    M = robots.rppr().home
    np.testing.assert_array_equal(robots.rppr().joint_points[[0, 3]], [(M @ [*q, 1])[:3] for q in (q1, q4)])
