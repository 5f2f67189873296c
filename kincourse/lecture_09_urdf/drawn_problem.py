"""A problem of sheet 09 that starts from a dimensioned drawing: the origins of a gantry in its file."""

import numpy as np

from kincourse.answers.point import VectorsAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import is_readable, lengths, misread
from kinlib.chains.robots import X, Y, Z
from kinlib.view.drawing.dimensions import DrawnAxis, draw_dimensions
from misstep.mistakes import mistake
from misstep.problem import Problem


@problem("09.12", "The file of a gantry", points=4, lecture="09_urdf#From the file to screws")
def gantry(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        bridge = np.array([a, b, 0.8 + c])
        trolley = bridge + np.array([d, -e, f])
        ram = trolley + np.array([-g, h, -c])
        tool = ram + np.array([e, -a, -0.2 - g])
        points = np.array([bridge, trolley, ram, tool])
        if is_readable(points) and tool[2] > 0.1:
            break
    steps = np.diff(np.array([np.zeros(3), *points]), axis=0)
    axes = [sampler.choice((-1, 1)) * axis for axis in (X, Y, Z)]
    drawn = [DrawnAxis(str(i), w, p, slides=True) for i, w, p in zip((1, 2, 3), axes, points, strict=False)]
    wrong = [
        ("in the base", points, "Every xyz is in the frame of the base. In a file it is in the frame of the parent."),
        (
            "opposite direction",
            -steps,
            "Every xyz leads from the child to its parent. It leads from the parent to the child.",
        ),
        ("steps shifted", np.roll(steps, -1, axis=0), "Each row has the step of the next joint."),
        *(
            (name, np.diff(np.array([np.zeros(3), *value]), axis=0), text)
            for name, value, text in misread(points)
            if name in {"views swapped", "depth reversed"}
        ),
    ]
    return Problem(
        statement="The drawing shows a gantry at home, in millimetres: three prismatic joints, with their frames at F1, F2 and F3, "
        "and the tool at T. All frames are parallel to {s}, which is the root of the file. Give the `xyz` of the origins of joints 1 to 3 "
        "and of the fixed joint to the tool, as rows, in metres.",
        figure=lambda: draw_dimensions(
            [bridge * (1, 1, 0), *points], drawn, dict(zip(("F1", "F2", "F3", "T"), points, strict=True))
        ),
        answer=VectorsAnswer(steps, unit="m", names=["joint 1", "joint 2", "joint 3", "the tool"]),
        mistakes=[mistake(name, value, text, spoils=name == "in the base") for name, value, text in wrong],
    ).without_duplicates()
