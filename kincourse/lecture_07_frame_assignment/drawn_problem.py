"""A problem of sheet 07 that starts from a dimensioned drawing: where the frames of a leg have their origins."""

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import is_readable, lengths, misread
from kinlib.chains.robots import X, Y, Z
from kinlib.view.drawing.dimensions import DrawnAxis, draw_dimensions
from misstep.mistakes import mistake
from misstep.problem import Problem


@problem("07.9", "The leg of a walking machine", points=4, lecture="07_frame_assignment#The algorithm")
def leg(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        hip = np.array([a, b, 0.9 + h])
        roll = hip + np.array([c, -d, -e])
        knee = roll + np.array([f, a, -g])
        if is_readable([hip, roll, knee]) and knee[2] > 0.1:
            break
    axes = [sampler.choice((-1, 1)) * axis for axis in (Z, X, Y)]
    origins = np.array([(hip[0], roll[1], roll[2]), (knee[0], roll[1], knee[2])])
    drawn = [DrawnAxis(str(i), w, p) for i, w, p in zip((1, 2, 3), axes, (hip, roll, knee), strict=True)]
    first_feet = np.array([(hip[0], hip[1], roll[2]), (knee[0], roll[1], roll[2])])
    wrong = [
        (
            "the other foot",
            first_feet,
            "Your points are the feet of the common normals on the first of the two axes. O_i is the foot on axis i + 1.",
        ),
        (
            "marks for feet",
            np.array([roll, knee]),
            "Your points are the marks of joints 2 and 3. An origin is where the common normal meets the axis.",
        ),
        (
            "marks for feet",
            np.array([hip, roll]),
            "Your points are the marks of joints 1 and 2, and not the feet of the normals.",
        ),
        ("origins swapped", origins[::-1], "The two origins are swapped: O_1 is on axis 2, O_2 on axis 3."),
    ]
    return Problem(
        statement="The drawing shows the leg of a walking machine at home, in millimetres: joint 1 is the yaw of the hip, 2 its roll, "
        "and 3 the knee, all of them revolute. Where are the origins $O_1$ and $O_2$ of the frames of the standard convention? Give "
        "their coordinates in {s}, in metres, as rows.",
        figure=lambda: draw_dimensions(
            [hip, (hip[0], hip[1], roll[2]), roll, knee, knee * (1, 1, 0)], drawn, {"P1": hip, "P2": roll, "P3": knee}
        ),
        answer=VectorsAnswer(origins, unit="m", names=["O_1", "O_2"]),
        mistakes=[mistake(name, value, text) for name, value, text in (*wrong, *misread(origins))],
    ).without_duplicates()
