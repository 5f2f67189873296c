"""The blank steps of lecture 06b: a link transform of the PUMA 560, and the angles of its wrist."""

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.links import link
from kincourse.expressions.wrist import wrist_angles, wrist_rotation
from kincourse.problem import ArmSampler, Problem, problem
from misstep.answers.number import Equivalent
from misstep.display.text import matrix

RIGHT_ANGLE_RAD = np.pi / 2
ANGLES_RAD = np.arctan2([0.8, 0.6, -0.96], [0.6, 0.8, 0.28])
"""The angles of step 06b.b, whose sines and cosines have two decimals, so that the rotation has few."""


@problem("06b.a", "A link transform of the PUMA", points=1, lecture="06_dh_modified#The general matrix")
def puma_row_4(_draw: ArmSampler) -> Problem:
    T_34 = link([0.0203, -RIGHT_ANGLE_RAD, 0.4318, np.radians(30)], "modified", 4)
    return Problem(
        statement="Row 4 of the PUMA's table has $a_3 = 0.0203$ m, $\\alpha_3 = -90°$, $d_4 = 0.4318$ m and $\\theta_4 = 30°$. Give "
        "${}^3T_4$.",
        answer=PoseAnswer(T_34),
    )


@problem("06b.b", "The angles of a wrist", points=1, lecture="06b_puma#Angles from a rotation")
def angles_of_the_wrist(_draw: ArmSampler) -> Problem:
    R_36 = wrist_rotation(ANGLES_RAD)
    angles = wrist_angles("{}^3R_6", R_36)
    return Problem(
        statement=f"The wrist of the PUMA is to have ${{}}^3R_6 = {matrix(R_36)}$. Give $(\\theta_4, \\theta_5, \\theta_6)$ in radians. "
        "Both solutions are right.",
        given={"rotation": R_36},
        answer=Equivalent(angles, meaning=wrist_rotation),
        invisible=["sum twice"],  # it differs at the singular configuration only
    )
