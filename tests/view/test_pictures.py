"""Every drawing is legible on light and on dark pages."""

import numpy as np
from legible import assert_legible
from urdf_files import TWO_FINGERS

import kinlib as kl
from kincourse.dimensions import DrawnAxis, draw_dimensions
from kincourse.lecture_06_dh_modified.drawings import play_walk
from kinlib import view
from kinlib.view.figures.frames import draw_assignment, draw_table

PUMA, YOUBOT, RPPR = kl.robots.puma560(), kl.robots.youbot(), kl.robots.rppr()
ASSIGNED = kl.assign_frames(PUMA, convention="standard")
FRAMES = {"s": np.eye(4), "b": kl.exp([0.4, -0.3, 0.8, 3, -2, 1.5])}
ROW, WALK = [0.8, 0.6, 0.6, 1.4], [[0.6, -0.9, 0.4, 0.3], [0.5, 1.6, 0.4, 0.0]]
FOUR_BAR, SLIDER = kl.linkages.four_bar(4, 1, 3.5, 3), kl.linkages.slider_crank(1, 3, 0.2)
CLOSED = FOUR_BAR.assembly_modes(hold={"A": 1.0})
BRACKET = kl.DHTable(
    [[0, 0, 0, 0], [1, 2, 3, 1], [0, 0, 0.5, 0]], convention="modified", joints="RPF", base=FRAMES["b"]
)
TURNTABLE = kl.robots.arm([((0, 0, 1), (0, 0, 0))], kl.robots.pose(np.eye(3), (1, 0, 0)), "turntable", "a test")
HAND = kl.Tree.from_urdf(TWO_FINGERS)
SHOW = ["axes", "home axes", "body axes", "base", "tool", "links"]
Z, X = (0, 0, 1), (1, 0, 0)
MACHINE = np.array([(0, 0, 0), (0, 0, 0.6), (0.5, 0, 0.6), (0.5, 0.3, 0.6), (0.5, 0.3, 0.2)])
MACHINE_AXES = [
    DrawnAxis("1", np.array(Z), MACHINE[0]),
    DrawnAxis("2", np.array((0, 1, 0)), MACHINE[2]),
    DrawnAxis("3", np.array((0, 0, -1)), MACHINE[3], slides=True),
]
MACHINE_MARKS = {"A": MACHINE[2], "B": MACHINE[3], "T": MACHINE[4]}


def at_stop(player, stop):
    player.at = stop
    return player


PICTURES = {
    "arm": lambda: view.draw_arm(PUMA, np.full(6, 0.3), ghost=np.zeros(6), show=SHOW),
    "arm with frames": lambda: view.draw_arm(YOUBOT, frames={"2": FRAMES["b"]}, view="front"),
    "joints": lambda: view.draw_joints(RPPR, tool=True),
    "helical joints": lambda: view.draw_joints(kl.robots.hrr()),
    "frames": lambda: view.draw_frames(FRAMES, numbers=True),
    "row": lambda: at_stop(view.play_row(ROW, convention="standard"), 4).picture(),
    "row, motion by motion": lambda: at_stop(view.play_row(ROW), 2).picture(),
    "factors": lambda: at_stop(play_walk(WALK), 3).picture(),
    "table": lambda: draw_table(ASSIGNED.table, np.full(6, 0.3), numbers=True),
    "table with a fixed row": lambda: draw_table(BRACKET, [0.3, 0.4]),
    "assignment of one joint": lambda: draw_assignment(kl.assign_frames(TURNTABLE, convention="modified")),
    "assignment, a normal": lambda: draw_assignment(ASSIGNED, 3),
    "assignment, a row": lambda: draw_assignment(ASSIGNED, 24),
    "assignment": lambda: draw_assignment(ASSIGNED),
    "four-bar": lambda: view.draw_linkage(FOUR_BAR, [1, 0.3, 2, 0], ghost=CLOSED[1]),
    "open slider-crank": lambda: view.draw_linkage(SLIDER, [0.5, 0.2, 3, 0]),
    "hexapod": lambda: view.draw_linkage(kl.linkages.stewart_gough(), np.zeros(36)),
    "gripper": lambda: view.draw_arm(HAND, [0.1, 0.02]),
    "machine": lambda: draw_dimensions(MACHINE, MACHINE_AXES, MACHINE_MARKS, arrows={"x1": ((0.5, 0, 0.6), X)}),
}


def test_every_drawing_is_legible_on_light_and_on_dark_pages():
    assert_legible(PICTURES)
