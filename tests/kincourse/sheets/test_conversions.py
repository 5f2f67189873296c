"""The conversions of sheet 06: rows with other directions of x are right, and a slip beside them costs its row only."""

from itertools import product

import numpy as np
import pytest

from kincourse import find_sheet
from misstep.judge import judge

STUDENTS = ["s0"]
CONVERSIONS = {f"06.{k}": ("06_dh_modified", k) for k in (3,)}

each_conversion = pytest.mark.parametrize("place", CONVERSIONS.values(), ids=CONVERSIONS)


def variants(place):
    sheet, k = place
    return [find_sheet(sheet).problems[k - 1].variant(student) for student in STUDENTS]


def reversed_x(rows, convention, frames):
    """The rows with the x axes of some frames reversed."""
    rows = np.array(rows)
    for i in frames:
        own, before, behind = (i, i - 1, i) if convention == "modified" else (i - 1, i - 1, i)
        rows[own, :2] *= -1
        rows[before, 3] += np.pi
        rows[behind, 3] -= np.pi
    return rows


@each_conversion
def test_rows_with_other_directions_of_x_are_right(place):
    for problem in variants(place):
        ours, convention = problem.answer.value, problem.answer.convention
        for chosen in product((False, True), repeat=3):
            rows = reversed_x(ours, convention, [i for i, reverse in zip((1, 2, 3), chosen, strict=True) if reverse])
            assert judge(problem, rows).state == "right"


@each_conversion
def test_a_slip_beside_another_direction_of_x_costs_its_row_only(place):
    for problem in variants(place):
        ours, convention = problem.answer.value, problem.answer.convention
        for row in range(4):
            rows = reversed_x(ours, convention, [2])
            rows[row, 2] *= -1
            judgement = judge(problem, rows)
            assert judgement.fraction == 0.75
            assert [list(finding.parts) for finding in judgement.findings] == [[f"row {row + 1}"]]
        for row, column in zip(*np.nonzero(ours), strict=True):
            slips = ours.copy()
            slips[row, column] *= -1
            assert judge(problem, slips).fraction == 0.75
        for end in (0, 3):
            rows = ours + 0.0
            rows[end, 3] += np.pi  # x_0 or x_4: the first and the last frame are given
            assert judge(problem, rows).fraction == 0.75


def test_a_prismatic_axis_of_a_conversion_may_lie_elsewhere():
    """A prismatic axis has no line: with z_2 moved along x_1, the rows are others, and the poses are the same."""
    rows = np.array([[0, 0, 0.2, 0.3], [0.3, 0.5, 0.4, 0.0], [0.1, 0.4, 0.5, 0], [0.2, 0.6, 0.1, 0.2]])
    moved = rows + np.outer((0, 1, -1, 0), (0.25, 0, 0, 0))
    answer = type(variants(CONVERSIONS["06.3"])[0].answer)(rows, convention="modified", joints="RPRR", unconverted=rows)
    assert answer.agrees(moved, rows) == [True] * 4
    assert answer.agrees(moved + np.array((0, 0, 0.01, 0)), rows) != [True] * 4
