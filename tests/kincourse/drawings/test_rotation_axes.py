"""The axes of three rotations: each is carried by the rotations before it, and the text says where two are collinear."""

import numpy as np

from kincourse.lecture_06b_puma.drawings import rotation_axes
from kinlib.rigid.lie import exp

UNITS = dict(zip("xyz", np.eye(3), strict=True))


def test_a_change_of_one_angle_rotates_about_its_axis():
    angles, step = np.array([0.4, -0.7, 1.1]), 1e-6

    def rotation(order, angles):
        return np.linalg.multi_dot([exp(angle * UNITS[letter]) for letter, angle in zip(order, angles, strict=True)])

    for order in ("zyz", "yzy", "zyx", "xyz"):
        for k, axis in enumerate(rotation_axes(order, angles)):
            moved = rotation(order, angles + step * np.eye(3)[k])
            assert np.allclose(moved, exp(step * axis) @ rotation(order, angles), atol=1e-10)
