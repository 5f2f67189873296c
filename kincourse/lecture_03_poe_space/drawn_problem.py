"""A problem of sheet 03 that starts from a dimensioned drawing: the screw axes of a palletizer."""

import numpy as np

from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.screws import joint_screws
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import is_readable, lengths, read_point
from kinlib.chains.robots import Y, Z
from kinlib.view.drawing.dimensions import DrawnAxis, draw_dimensions
from misstep.problem import Problem


@problem("03.12", "A palletizer", points=4, lecture="03_poe_space#Screw axes from a drawing")
def palletizer(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g, h = lengths(sampler, 8)
        foot = np.array([a, b, 0.0])
        shoulder = foot + np.array([c, -d, 0.3 + e])
        elbow = shoulder + np.array([f, 0.0, g])
        wrist = elbow + np.array([0.3 + h, a - b, -e])
        points = np.array([shoulder, elbow, wrist])
        if is_readable(points):
            break
    side = sampler.choice((-1, 1)) * Y
    axes = np.array([side, side * sampler.choice((-1, 1)), -Z])
    read = [
        read_point(f"P_{i}", p, axes[k], [*points[:k], *points[k + 1 :]])
        for k, (i, p) in enumerate(zip((2, 3, 4), points, strict=True))
    ]
    S = joint_screws(axes, read, np.zeros(3), numbers=(2, 3, 4))
    drawn = [
        DrawnAxis("1", Z, foot),
        *(DrawnAxis(str(i), w, p) for i, w, p in zip((2, 3, 4), axes, points, strict=True)),
    ]
    marks = dict(zip(("P2", "P3", "P4"), points, strict=True))
    return Problem(
        statement="The drawing shows a palletizer, with four revolute joints, in millimetres. Give the screw axes $S_2$, $S_3$ and $S_4$ "
        "in {s}, as rows, in metres. An axis that points towards you is a ring with a dot, one that points away a ring with a cross.",
        figure=lambda: draw_dimensions([foot, np.array([foot[0], foot[1], shoulder[2]]), *points], drawn, marks),
        answer=ScrewsAnswer(S.value, names=["screw 2", "screw 3", "screw 4"]),
        solution=S,
        invisible={"another point"},
    )
