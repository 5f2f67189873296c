"""What a drawing of a lecture cannot show is refused with what must hold."""

import numpy as np
import pytest

from kincourse.lecture_01_frames.drawings import draw_rotation, draw_three_readings
from kincourse.lecture_02_matrix_exponential.drawings import draw_motions, draw_twist_matrix
from kincourse.lecture_04_poe_body.drawings import draw_adjoint_steps
from kincourse.lecture_04b_velocity.drawings import draw_tool_velocities
from kincourse.lecture_08_closed_chains.drawings.torus import draw_torus
from kincourse.lecture_09_urdf.drawings import draw_urdf_joint
from kinlib.chains.robots import X, Y, Z, pose, youbot
from kinlib.view import slide_frames

LIFTED = pose((X, Y, Z), (0, 0, 1))


@pytest.mark.parametrize(
    ("draw", "says"),
    [
        (lambda: draw_three_readings(LIFTED, [1, 0, 0]), "rotation about z"),
        (lambda: draw_rotation(3, 20), "0, 1 or 2, for x, y or z; got 3"),
        (lambda: draw_motions(np.eye(4), {}), "motions must contain 1 to 4 twists"),
        (lambda: draw_twist_matrix([1, 2, 3]), "S must have shape"),
        (lambda: draw_adjoint_steps([0, 0, 0.5, 0.9, 0.3, 0], LIFTED), "x-y plane"),
        (lambda: draw_tool_velocities(youbot(), [0, 0]), "q"),
        (lambda: draw_torus(dict.fromkeys("abcd", np.zeros((2, 2))), xlabel="A", ylabel="D"), "at most 3 .* got 4"),
        (lambda: draw_urdf_joint(np.eye(4), (0, 0, 2), 0.6), r"must be a unit vector; got \(0, 0, 2\), of length 2"),
        (lambda: slide_frames(lambda _: {"s": np.eye(4)}, "value", []), "at least one value; got none"),
    ],
)
def test_what_cannot_be_drawn_is_refused(draw, says):
    with pytest.raises(ValueError, match=says):
        draw()
