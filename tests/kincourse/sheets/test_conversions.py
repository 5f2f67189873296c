"""The conversion of sheet 06: rows with other directions of x are right, and a slip beside them costs its row only."""

from itertools import product

import numpy as np

from kincourse import find_sheet
from misstep.judge import judge

PROBLEM = find_sheet("06_dh_modified").problems[2].variant("s0")


def reversed_x(rows, frames):
    """Modified rows with the x axes of some frames reversed."""
    rows = np.array(rows)
    for i in frames:
        rows[i, :2] *= -1
        rows[[i - 1, i], 3] += np.pi, -np.pi
    return rows


def test_rows_with_other_directions_of_x_are_right_and_a_slip_costs_its_row_only():
    ours = PROBLEM.answer.value.rows
    for chosen in product((False, True), repeat=3):
        rows = reversed_x(ours, [i for i, reverse in zip((1, 2, 3), chosen, strict=True) if reverse])
        assert judge(PROBLEM, rows).state == "right"
    for row in range(4):
        rows = reversed_x(ours, [2])
        rows[row, 2] *= -1
        judgement = judge(PROBLEM, rows)
        assert judgement.fraction == 0.75
        assert [list(finding.parts) for finding in judgement.findings] == [[f"row {row + 1}"]]
    for end in (0, 3):
        rows = ours + 0.0
        rows[end, 3] += np.pi  # x_0 or x_4: the first and the last frame are given
        assert judge(PROBLEM, rows).fraction == 0.75
