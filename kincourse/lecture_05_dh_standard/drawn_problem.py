"""A problem of sheet 05 that starts from a dimensioned drawing: the table of a SCARA."""

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


@problem("05.9", "A SCARA from its drawing", points=4, lecture="05_dh_standard#Reading a table off a drawing")
def scara(sampler: ArmSampler) -> Problem:
    while True:
        a, b, c, d, e, f, g = lengths(sampler, 7)
        turn = sampler.choice((-QUARTER, QUARTER))
        rows = [(a, 0, b, turn), (c, np.pi, d, -turn), (0, 0, e, sampler.choice((QUARTER, -QUARTER)))]
        table = DHTable(rows, convention="standard", joints="RRP", base=pose((X, Y, Z), (f, g, 0)))
        if is_readable(table_frames(table)[:, :3, 3]):
            break
    return Problem(
        statement="The drawing shows a SCARA with joints RRP at home, in millimetres, with its standard frames: "
        "the origin of frame $i$ is D$i$, $z_i$ is the axis of joint $i + 1$, the arrow is $x_i$, and $z_3$ is along $z_2$. Give "
        f"the three rows $a, \\alpha, d, \\theta$ at home, in metres and radians. {MARKS_BY_ROW}",
        figure=partial(draw_table_frames, table),
        answer=DHRowsAnswer(table.rows),
        mistakes=table_mistakes(table),
    ).without_duplicates()
