"""The DH problems of sheets 05 to 07: every legal answer is right, and no slip of one entry has full marks."""

from itertools import product

import numpy as np
import pytest

from kincourse import find_sheet
from kinlib.chains.chain import random_configurations
from misstep.judge import judge

STUDENTS = [f"s{i}" for i in range(3)]
WHOLE_TABLES = {
    **{f"05.{k}": ("05_dh_standard", k) for k in (3,)},
    **{f"07.{k}": ("07_frame_assignment", k) for k in (3, 4, 6)},
}
DRAWN_ROWS = {"05.8": ("05_dh_standard", 8), "06.8": ("06_dh_modified", 8), "10.6": ("10_one_robot_four_ways", 6)}
CONVERSIONS = {f"06.{k}": ("06_dh_modified", k) for k in (3,)}

each_table = pytest.mark.parametrize("place", WHOLE_TABLES.values(), ids=WHOLE_TABLES)
each_rows = pytest.mark.parametrize("place", DRAWN_ROWS.values(), ids=DRAWN_ROWS)
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


def moves_alike(one, other):
    q = random_configurations(one.n, 8)
    return np.abs(one.fk(q) - other.fk(q)).max() < 1e-9


@each_table
def test_one_flipped_sign_costs_the_points_and_is_named(place):
    for problem in variants(place):
        ours = problem.answer.value
        for row, column in zip(*np.nonzero(np.abs(ours.rows) > 1e-9), strict=True):
            rows = np.array(ours.rows)
            rows[row, column] *= -1
            if moves_alike(ours.changed(rows=rows), ours):
                assert np.isclose(np.abs(rows[row, column]), np.pi)
                continue
            judgement = judge(problem, ours.changed(rows=rows))
            assert judgement.fraction < 1
            assert judgement.mistakes
            text = f"{judgement.findings[0].parts}: {judgement.findings[0].message}"
            assert f"ow {row + 1}" in text or "very " in text or "sign" in text, text


@each_table
def test_every_legal_table_is_right_and_its_difference_is_said(place):
    for problem in variants(place):
        ours = problem.answer.value
        assert problem.answer.remark(ours) == ""
        legal = {
            "x": ours.changed(rows=reversed_x(ours.rows, ours.convention, [1])),
            "x twice": ours.changed(rows=reversed_x(ours.rows, ours.convention, [1, 2])),
        }
        for name, table in legal.items():
            assert moves_alike(table, ours), name
            for given in (table, table.rows.tolist() if ours.joints == "R" * ours.n else table):
                assert judge(problem, given).state == "right"
        assert (
            problem.answer.remark(legal["x"]) == "It differs from ours where the rules leave a choice: x_1 is reversed."
        )
        assert "x_1 is reversed; x_2 is reversed." in problem.answer.remark(legal["x twice"])
        turns = np.where(np.arange(4) % 2, 2 * np.pi, 0)
        assert judge(problem, ours.changed(rows=ours.rows + turns)).state == "right"
        assert judge(problem, ours.changed(rows=ours.rows - turns)).state == "right"


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


@each_rows
def test_a_wrong_number_costs_one_row(place):
    for problem in variants(place):
        right = problem.answer.value
        assert judge(problem, right.ravel().tolist()).state == "right"
        for i, k in np.ndindex(right.shape):
            wrong = right.copy()
            wrong[i, k] += 0.3
            judgement = judge(problem, wrong)
            assert judgement.right_parts == [f"row {j + 1}" for j in range(len(right)) if j != i]
