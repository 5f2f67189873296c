"""Text alternatives are true: what they say of axes and positions is what the Jacobian and fk say of that configuration."""

import re

import numpy as np
import pytest
from strategies import ROBOTS

import kinlib as kl
from kinlib.view import draw_arm, draw_joints, explore

each_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


def configurations(robot):
    """Return home, and random configurations."""
    return [np.zeros(robot.n), *np.random.default_rng(5).uniform(-2.5, 2.5, (2, robot.n))]


def numbers(text):
    return np.array([float(x) for x in re.findall(r"-?[\d.]+(?:e[+-]?\d+)?", text)])


def direction(text):
    """Read "x", "-z" or "(0.6, 0, 0.8)"."""
    if text.startswith("("):
        return numbers(text)
    return np.eye(3)["xyz".index(text[-1])] * (-1 if text.startswith("-") else 1)


def near(said, true):
    """Whether numbers with three significant digits are right."""
    return bool((np.abs(said - true) <= 0.0051 * np.abs(true) + 2e-5).all())


JOINT = re.compile(r"[Jj]oint (\d) (revolute|prismatic|helical) along (-?[xyz]|\([^)]*\)) at (\([^)]*\))")


def assert_is_true(text, robot, q):
    """Compare a text with the Jacobian and the pose, neither of which it is made from."""
    J = robot.jacobian(q)
    joints = JOINT.findall(text)
    assert len(joints) == robot.n
    for number, kind, along, at in joints:
        omega, v = J[:3, int(number) - 1], J[3:, int(number) - 1]
        said, point = direction(along), numbers(at)
        if kind == "prismatic":
            assert near(said, v / np.linalg.norm(v)), (number, along, v)
            continue
        assert near(said, omega), (number, along, omega)
        # The point is on the axis: the part of v perpendicular to omega is -omega x p.
        across = v - omega * (omega @ v)
        assert np.abs(across + np.cross(omega, point)).max() < 0.006 * max(1, np.abs(point).max()), (number, at)
    assert near(numbers(re.search(r"end-effector is at (\([^)]*\))", text)[1]), robot.fk(q)[:3, 3])
    home = re.search(r", at home\.", text)
    assert bool(home) == (not q.any())
    if not home:
        assert near(numbers(re.search(r"at q = (\([^)]*\))", text)[1]), q)


@each_robot
def test_the_text_of_a_drawing_and_of_a_viewer_is_true_in_every_configuration(robot):
    viewer, texts = explore(robot), set()
    for q in configurations(robot):
        texts.add(text := draw_arm(robot, q).alt)
        assert_is_true(text, robot, q)
        viewer.q = q
        assert viewer.alt == text
    assert len(texts) == 3
    assert_is_true(draw_joints(robot).alt, robot, np.zeros(robot.n))


def test_what_is_drawn_in_grey_is_said():
    robot, q = kl.robots.rpr(), np.array([0.3, 0.5, -0.2])
    alt = draw_arm(robot, q, ghost=np.zeros(3), show=["home axes"]).alt
    assert "In grey, the axes at home: -y, z, -y." in alt
    assert alt.endswith("In grey, the arm at home, its end-effector at (0, 0, 1) m.")
    assert "In grey" not in draw_arm(robot, q).alt


# --- frames on the links ---


def test_frames_on_the_links_move_with_the_links_and_are_described():
    robot, q = kl.robots.puma560(), np.linspace(0.2, 0.8, 6)
    frames = {str(i): T for i, T in enumerate([np.eye(4), *robot.link_poses(q), robot.fk(q)])}
    viewer = explore(robot, start=q, frames=frames)
    assert viewer.shown == ["axes", "frame 0"]
    viewer.shown = ["axes", "frame 3", "frame 6", "frame 7"]
    viewer.q = other = -q
    links = robot.link_poses(other)
    for i, T in ((3, links[2]), (6, links[5]), (7, robot.fk(other))):  # the last one is fixed to the last link
        said = re.search(rf"Frame \{{{i}\}} at (\([^)]*\)), x along ([^,(]+|\([^)]*\)), y", viewer.alt)
        assert near(numbers(said[1]), T[:3, 3])
        assert near(direction(said[2]), T[:3, 0])
    assert "Frame {0}" not in viewer.alt
