"""Every drawing of the lectures is legible on light and on dark pages."""

import numpy as np
from legible import assert_legible

import kinlib as kl
from kincourse.axis_relations import draw_axis_relation
from kincourse.lecture_00_start_here.drawings import draw_parts
from kincourse.lecture_01_frames.drawings import draw_rotation, draw_three_readings
from kincourse.lecture_02_matrix_exponential.drawings import draw_motions, draw_point_velocity, draw_series
from kincourse.lecture_03_poe_space.drawings import draw_lettered_joints
from kincourse.lecture_04_poe_body.drawings import draw_adjoint_steps
from kincourse.lecture_04_poe_body.drawings.mid_formula import draw_mid_formula
from kincourse.lecture_04b_velocity.drawings import draw_tool_velocities
from kincourse.lecture_05_dh_standard.drawings import draw_last_frame
from kincourse.lecture_06b_puma.drawings import draw_rotation_axes
from kincourse.lecture_07_frame_assignment.drawings import draw_nearly_parallel_axes
from kincourse.lecture_09_urdf.drawings import draw_urdf_joint, draw_urdf_tree
from kincourse.lecture_09_urdf.files import ARM, FOUR_BAR
from kincourse.lecture_10_one_robot_four_ways.drawings import draw_two_arms

YOUBOT, PUMA = kl.robots.youbot(), kl.robots.puma560()
BENT = np.radians([20, 60, -60, -40, 10])
(X, _, Z), O = np.eye(3), np.zeros(3)
SCREW = kl.robots.rpr().screws[0]
M = np.block([[kl.exp([0, 0, 0.5]), np.array([[2], [0.6], [0]])], [0, 0, 0, 1]])

PICTURES = {
    "parts": lambda: draw_parts(YOUBOT),
    "three readings": lambda: draw_three_readings(M, [0.5, 0.25, 0]),
    "rotation": lambda: draw_rotation(1, -70),
    "series": lambda: draw_series(SCREW, 2.0, (0, 0, 1), 5),
    "motions": lambda: draw_motions(np.eye(4), {"screw": [0, 0, 2, 1, 0, 0.3], "slide": [0, 0, 0, 0, 1, 0.5]}),
    "velocity": lambda: draw_point_velocity((0, 0.3, 1), (1, 2, 0.5)),
    "moment": lambda: draw_point_velocity((0, 0.3, 1), (1, 2, 0.5), moment=True),
    "lettered arm": lambda: draw_lettered_joints(kl.robots.plain_arm(), ["", "L_1", "", "L_2", "L_3"]),
    "adjoint": lambda: draw_adjoint_steps([0, 0, 0.5, 0.9, 0.3, 0], M),
    "mid-formula": lambda: draw_mid_formula(kl.robots.mid_formula_arm(), 2),
    "mid-formula, all from {b}": lambda: draw_mid_formula(kl.robots.rppr(), 0),
    "velocities": lambda: draw_tool_velocities(YOUBOT, BENT),
    "lost direction": lambda: draw_tool_velocities(YOUBOT, np.zeros(5)),
    "last frame": lambda: draw_last_frame("P", d=0.9, a=0.3),
    "skew axes": lambda: draw_axis_relation((Z, O), ((0, 0.6, 0.8), X)),
    "parallel axes": lambda: draw_axis_relation((Z, O), (Z, X)),
    "moving normal": lambda: draw_axis_relation((Z, O), ((0, 0.2, 0.98), (0.5, 0.4, 0.5)), film=True),
    "rotation axes": lambda: draw_rotation_axes("zyz", [0.3, 0.7, 0.2], ("4", "5", "6")),
    "nearly parallel axes": lambda: draw_nearly_parallel_axes(30),
    "joint of a URDF": lambda: draw_urdf_joint(M, (0, 0.6, 0.8), 0.6, ("post", "rod")),
    "tree of a URDF": lambda: draw_urdf_tree(ARM, ("mast", "camera")),
    "loop in a URDF": lambda: draw_urdf_tree(FOUR_BAR),
    "two arms": lambda: draw_two_arms(PUMA, PUMA, np.full(6, 0.3), np.full(6, -0.3), width=0.8, base=M),
}


def test_every_drawing_of_the_lectures_is_legible_on_light_and_on_dark_pages():
    assert_legible(PICTURES)
