"""Figures, plots and sliders of pictures: each has a true text alternative, labels are legible, and wrong arguments are refused."""

import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from legible import overlapping_labels
from strategies import ROBOTS

import kinlib as kl
from kincourse.lecture_04_poe_body.drawings.mid_formula import draw_mid_formula
from kinlib.view import Picture, draw_arm, draw_joints, drive, explore, slide
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.figures.frames import draw_assignment, draw_table

ROOT = Path(__file__).parents[3]
RPR = kl.robots.rpr()
FOUR_BAR = kl.linkages.four_bar(0.4, 0.1, 0.35, 0.3)
CLOSED = FOUR_BAR.assembly_modes(hold={"A": 1.0})[0]

each_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


# --- drawings ---


@each_robot
def test_no_label_in_a_drawing_of_an_arm_covers_another_or_leaves_the_sheet(robot):
    q = np.linspace(-0.9, 0.7, robot.n)
    pictures = [draw_arm(robot), draw_arm(robot, q), draw_joints(robot), draw_mid_formula(robot, robot.n // 2)]
    if "H" not in robot.joint_types:
        for convention in ("standard", "modified"):
            assignment = kl.assign_frames(robot, convention=convention)
            pictures += [draw_table(assignment.table), draw_assignment(assignment)]
    assert [overlapping_labels(picture) for picture in pictures] == [[] for _ in pictures]


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_the_arm_stays_in_view_if_a_common_normal_is_far_away(convention):
    angle = 1e-6
    joints = [((0, 0, 1), (0, 0, 0)), ((0, np.sin(angle), np.cos(angle)), (0.5, 0, 0.1)), ((1, 0, 0), (0.9, 0, 0.3))]
    chain = kl.robots.arm(joints, kl.robots.pose(np.eye(3), (1, 0, 0.3)), "leaning arm", "a test")
    found = kl.assign_frames(chain, convention=convention)
    for k in [*range(len(found.steps)), None]:
        numbers = [abs(float(x)) for x in re.findall(r'[xy]\d?="(-?[\d.]+)"', draw_assignment(found, k).svg)]
        assert max(numbers) < 1000


def test_the_drawings_of_a_slider_are_cropped_alike():
    around = [(-9, -9, 0), (9, 9, 9)]
    box = slide(lambda angle: draw_arm(RPR, [angle, 0, 0], around=around), "angle", [0.0, 0.5, 1.0])
    assert len({re.search(r"viewBox=\"([^\"]+)", frame)[1] for frame in box.frames}) == 1


def test_labels_are_escaped_for_the_browser():
    canvas = Canvas([(0, 0, 0), (1, 1, 1)])
    canvas.label((0, 0, 0), "<script>&", "black")
    canvas.label((1, 1, 1), r"$\theta_{12}$", "black")
    said = ["".join(text.itertext()) for text in ET.fromstring(canvas.picture("Two labels, no more." * 2).svg).iter()]
    assert "<script>&" in said
    assert "θ12" in said


def test_what_cannot_be_drawn_is_refused():
    for draw, says in [
        (lambda: explore(RPR, joints=[4]), "RPR has joints 1 to 3; got 4"),
        (lambda: draw_arm(RPR, show=["wheels"]), r"show may contain axes, .*; got 'wheels'"),
        (lambda: draw_arm(RPR, view="behind"), r"view must be one of default, front.*'behind'"),
        (lambda: Picture("<svg/>", "arm"), r"at least 20 characters; got 'arm'.*cannot see it"),
        (lambda: slide(lambda _: None, "nothing", []), "at least one value"),
        (lambda: kl.show([1, 2]), r"show takes a Chain, .*got list \[1, 2\]"),
        (
            lambda: kl.show(draw_arm(RPR), [0, 0, 0]),
            "q must be given with a robot only; got it with a Picture",
        ),
        (lambda: drive(FOUR_BAR, CLOSED, across=("A", "E")), "four-bar has joint values A, B, D, C; got 'E'"),
        (lambda: explore(RPR, frames={"elbow": np.eye(4)}), "number of their link, .*; got 'elbow'"),
    ]:
        with pytest.raises(ValueError, match=says):
            draw()


def test_an_arm_is_drawn_without_importing_matplotlib():
    """The import takes a second in the lab and three in the browser, and only plots need it."""
    script = "import sys; from kinlib.view import draw_arm; from kinlib.chains.robots import rpr; draw_arm(rpr()); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, cwd=ROOT)
    assert not {"matplotlib", "ipywidgets"} & set(done.stdout.split())
