"""The formulas in SymPy: against Modern Robotics, against SymPy's own mechanics, and short."""

from functools import reduce

import modern_robotics as mr
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from strategies import ROBOTS, configurations, twists
from sympy.physics.vector import Point, ReferenceFrame

import kinlib as kl
from kinlib import symbolic
from kinlib.symbolic.formulas import joints

AGREES = 1e-12
"""Both sides carry some hundred roundings: the numeric one its own, the symbolic one those of evaluating it."""

robots = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)
q, q_1, q_2 = sp.symbols("q q_1 q_2", real=True)
a_2, a_3, d_3, d_4 = sp.symbols("a_2 a_3 d_3 d_4", positive=True)


def numbers(matrix, **values):
    named = {symbol: values[symbol.name] for symbol in matrix.free_symbols}
    return np.array(matrix.subs(named).evalf(20), dtype=float)


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


def test_puma_with_symbolic_lengths_agrees_with_sympy_mechanics():
    world = frame = ReferenceFrame("s")
    links = []
    for symbol, z, y in zip(joints(6), (1, 0, 0, -1, 0, -1), (0, 1, 1, 0, 1, 0), strict=True):
        frame = frame.orientnew(f"after_{symbol}", "Axis", (symbol, y * frame.y + z * frame.z))
        links.append(frame)
    base = Point("base")
    elbow = base.locatenew("elbow", a_2 * links[1].x + d_3 * links[1].y)
    wrist = elbow.locatenew("wrist", a_3 * links[2].x - d_4 * links[2].z)
    tool = frame.orientnew("tool", "Axis", (sp.pi, frame.x))
    values = dict(zip([*joints(6), a_2, a_3, d_3, d_4], np.linspace(-2, 2.3, 10), strict=True))
    oracle = world.dcm(tool).row_join(wrist.pos_from(base).to_matrix(world)).subs(values)
    factors = [symbolic.exp(S * q) for S, q in zip(puma(), joints(6), strict=True)]
    home = sp.diag(1, -1, -1, 1) + sp.Matrix([[0, 0, 0, e] for e in (a_2 + a_3, d_3, -d_4, 0)])
    close(
        np.array(reduce(sp.Matrix.multiply, [*factors, home]).subs(values), dtype=float)[:3],
        np.array(oracle, dtype=float),
    )


def puma():
    """PUMA 560 as kl.robots draws it, with a letter for each length."""
    elbow, wrist = (a_2, d_3, 0), (a_2 + a_3, d_3, -d_4)
    lines = [((0, 0, 1), (0, 0, 0)), ((0, 1, 0), (0, 0, 0)), ((0, 1, 0), elbow)]
    lines += [((0, 0, -1), wrist), ((0, 1, 0), wrist), ((0, 0, -1), wrist)]
    return [symbolic.screw(*line) for line in lines]


def test_parallel_joints_give_sums_and_antiparallel_joints_differences_of_angles():
    assert {angle.args[0] for angle in symbolic.fk(kl.robots.youbot())[:3, 3].atoms(sp.cos, sp.sin)} == {
        joints(1)[0],
        joints(2)[1],
        sum(joints(3)[1:]),
        sum(joints(4)[1:]),
    }
    antiparallel = kl.Chain([kl.screw((0, 0, 1)), kl.screw((0, 0, -1), (1, 0, 0))], np.eye(4))
    assert symbolic.fk(antiparallel)[0, 0] == sp.cos(q_1 - q_2)
