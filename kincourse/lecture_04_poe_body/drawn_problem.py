"""A problem of sheet 04 that starts from a dimensioned drawing: the body screws of a wrist with offsets."""

import numpy as np

from kincourse.answers.screws import ScrewsAnswer
from kincourse.expressions.screws import joint_screws
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import is_readable, lengths, read_point
from kinlib.chains.robots import X, Y, Z
from kinlib.view.drawing.dimensions import DrawnAxis, draw_dimensions
from misstep.problem import Problem


@problem("04.12", "A wrist with offsets", points=4, lecture="04_poe_body#A second method")
def wrist(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7, 0.04, 0.3)
        fourth, fifth, sixth = np.array([-a - b - c, d, e + f]), np.array([-a - b, d - g, e]), np.array([-a, -g, -f])
        points = np.array([fourth, fifth, sixth])
        if is_readable(points):
            break
    axes = np.array([sampler.choice((-1, 1)) * axis for axis in (Z, Y, X)])
    read = [read_point(f"P_{i}", p, w) for i, p, w in zip((4, 5, 6), points, axes, strict=True)]
    B = joint_screws(axes, read, np.zeros(3), numbers=(4, 5, 6))
    drawn = [DrawnAxis(str(i), w, p) for i, w, p in zip((4, 5, 6), axes, points, strict=True)]
    marks = dict(zip(("P4", "P5", "P6"), points, strict=True))
    return Problem(
        statement="The drawing shows the wrist of an arm, at home, in millimetres. All of it is measured from the frame {b} of the tool, "
        "whose $x$ is to the right, whose $y$ is up in the top view, and whose $z$ is up in the front view. Give the body screws $B_4$, "
        "$B_5$ and $B_6$, as rows, in metres.",
        figure=lambda: draw_dimensions([*points, (0, 0, 0)], drawn, marks, origin="{b}"),
        answer=ScrewsAnswer(B.value, names=["screw 4", "screw 5", "screw 6"]),
        solution=B,
        invisible={"another point"},
        advice={"sign of a coordinate": "The wrist is behind the tool, so most coordinates in {b} are negative."},
    )
