"""A problem of sheet 06 that starts from a dimensioned drawing: the table of a telescope mount."""

from functools import partial

import numpy as np

from kincourse.answers.dh_row import DHRowsAnswer
from kincourse.problem import problem
from kincourse.sampling.arms import ArmSampler
from kincourse.sampling.drawn_machines import draw_table_frames, is_readable, lengths, table_frames, table_mistakes
from kincourse.text.joint_table import MARKS_BY_ROW
from kinlib.chains.robots import X, Y, Z, pose
from kinlib.dh.table import DHTable
from misstep.problem import Problem

QUARTER = np.pi / 2


@problem(
    "06.11", "A telescope mount from its drawing", points=4, lecture="06_dh_modified#Frame labelling in eight steps"
)
def telescope_mount(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7)
        first, second = (sampler.choice((-QUARTER, QUARTER)) for _ in range(2))
        rows = [(0, 0, a, 0), (b, first, c, sampler.choice((0, QUARTER))), (d, second, e, QUARTER)]
        table = DHTable(rows, convention="modified", joints="RRR", base=pose((X, Y, Z), (f, g, 0)))
        if is_readable(table_frames(table)[:, :3, 3]):
            break
    return Problem(
        statement="The drawing shows the mount of a telescope at home, in millimetres, with modified frames: joint 1 "
        "is the azimuth, joint 2 the altitude, joint 3 rotates the camera. The origin of frame $i$ is D$i$, $z_i$ is the axis of joint "
        "$i$, and the arrow is $x_i$; $z_0$ is along $z_1$. Give the three rows $a_{i-1}, \\alpha_{i-1}, d_i, \\theta_i$ at home, in "
        f"metres and radians. {MARKS_BY_ROW}",
        figure=partial(draw_table_frames, table),
        answer=DHRowsAnswer(table.rows),
        mistakes=table_mistakes(table),
    ).without_duplicates()
