"""The formulas in SymPy: against Modern Robotics, and short."""

import modern_robotics as mr
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from strategies import ROBOTS, configurations, twists

import kinlib as kl
from kinlib import symbolic
from kinlib.symbolic.formulas import joints

AGREES = 1e-12
"""Both sides carry some hundred roundings: the numeric one its own, the symbolic one those of evaluating it."""

robots = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


def numbers(matrix):
    return np.array(matrix.evalf(20), dtype=float)


def at(matrix, values):
    return np.array(matrix.subs(dict(zip(joints(len(values)), values, strict=True))).evalf(20), dtype=float)


def close(got, expected, atol=AGREES):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


@robots
def test_every_robot_of_the_course_moves_as_its_numbers_do(robot):
    forms, (values,) = [symbolic.fk(robot)], configurations(robot, 1)
    if "H" not in robot.joint_types:
        table = kl.assign_frames(robot, convention=("standard", "modified")[robot.n % 2]).table
        rows = [[*symbolic.exact(row)] for row in table.rows]
        for q_i, row, letter in zip(joints(robot.n), rows, table.joints, strict=True):
            row[3 if letter == "R" else 2] += q_i
        forms.append(
            symbolic.exact(table.base) * symbolic.table_fk(rows, table.convention) * symbolic.exact(table.tool)
        )
    for form in forms:
        assert not form.atoms(sp.Float)
        close(at(form, values), mr.FKinBody(robot.home, robot.body_screws.T, values), 1e-11)


@settings(max_examples=15, deadline=None)
@given(twists())
def test_exp_is_that_of_modern_robotics(x):
    if np.linalg.norm(x[:3]) > 1e-5:  # it takes smaller turns for none
        close(numbers(symbolic.exp(x)), mr.MatrixExp6(mr.VecTose3(x)), 1e-11)
        close(numbers(symbolic.exp(x[:3])), mr.MatrixExp3(mr.VecToso3(x[:3])), 1e-11)


def test_a_screw_is_that_of_modern_robotics():
    a, d = sp.symbols("a d")
    S = symbolic.screw((0, sp.Rational(3, 5), sp.Rational(4, 5)), (a, d, 0), sp.Rational(1, 10)).subs({a: 0.4, d: 0.15})
    close(numbers(S)[:, 0], mr.ScrewToAxis([0.4, 0.15, 0], [0, 0.6, 0.8], 0.1))


def test_antiparallel_joints_give_differences_of_angles():
    antiparallel = kl.Chain([kl.screw((0, 0, 1)), kl.screw((0, 0, -1), (1, 0, 0))], np.eye(4))
    q_1, q_2 = joints(2)
    assert symbolic.fk(antiparallel)[0, 0] == sp.cos(q_1 - q_2)
