"""Code generation: a program computes the same numbers as its formula, and nothing that is known beforehand."""

import pickle
import re

import numpy as np
import pytest
import sympy
from hypothesis import given
from strategies import ROBOTS, chains_with_values

from kinlib.arrays.codegen import FEW_ELEMENTS, Tracer, columnwise_program, few_elements, trace_to_python

each_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


def generated_lines(formula, n=2):
    """The lines of the generated program, without the first and the last."""
    return [line.strip() for line in trace_to_python(formula, n).source.splitlines()[1:-1]]


def test_what_is_known_beforehand_is_not_computed():
    for formula in (
        lambda q: q + 0,
        lambda q: 0 + q,
        lambda q: q - 0,
        lambda q: 1 * q,
        lambda q: q * 0,
        lambda q: np.zeros((2, 2)) @ q + np.eye(2) @ q,
    ):
        assert generated_lines(formula) == []


@pytest.mark.oracle("text: written out in the test", Tracer.cos, Tracer.sin, Tracer.tan, Tracer.sqrt, Tracer.arctan2)
def test_a_function_is_recorded_by_name():
    for f in (np.cos, np.sin, np.tan, np.sqrt):
        assert f(Tracer("q1", {})).lines == {f"{f.__name__}(q1)": "v1"}
    assert np.arctan2(Tracer("q1", {}), Tracer("q2", {})).lines == {"arctan2(q1, q2)": "v1"}


def test_a_product_with_minus_one_is_a_negation():
    assert generated_lines(lambda q: np.array([-1 * q[0], q[0] * -1.0, -q[0]])) == ["v1 = -q1"]
    assert generated_lines(lambda q: -2 * q[0]) == ["v1 = -2.0 * q1"]


def test_a_repeated_expression_is_computed_once():
    assert generated_lines(lambda q: np.cos(q[0]) * q[1] + np.cos(q[0]) * q[1]) == [
        "v1 = cos(q1)",
        "v2 = q2 * v1",
        "v3 = v2 + v2",
    ]


def test_each_operation_computes_its_value():
    operations = trace_to_python(
        lambda q: np.array(
            [
                q[0] + q[1],
                q[0] + 4.0,
                4.0 + q[0],
                q[0] - q[1],
                q[0] - 4.0,
                4.0 - q[0],
                0 - q[0],
                q[0] * q[1],
                -1 * q[0],
                4.0 * q[0],
                q[0] * 4.0,
                -q[0],
                q[0] / q[1],
                q[0] / 4.0,
                4.0 / q[0],
                np.sqrt(q[0]),
                np.tan(q[0]),
                np.arctan2(q[0], q[1]),
            ]
        ),
        2,
    )
    expected = (5.0, 6.0, 6.0, -1.0, -2.0, 2.0, -2.0, 6.0, -2.0, 8.0, 8.0, -2.0)
    functions = (2 / 3, 0.5, 2.0, 2**0.5, np.tan(2.0), np.arctan2(2.0, 3.0))
    assert operations.run(2.0, 3.0) == expected + functions
    assert {type(value) for value in operations.run(2.0, 3.0)} == {float}


@pytest.mark.oracle("sympy", trace_to_python)
def test_a_program_computes_what_sympy_computes():
    """The same formula of SymPy's matrices and symbols, its values taken with 30 digits."""

    def formula(q):
        turn = np.array([[np.cos(q[0]), -np.sin(q[0])], [np.sin(q[0]), np.cos(q[0])]])
        return turn @ np.array([[q[1]], [0.25]]) - turn.T @ np.array([[3.0], [q[1] * q[1]]])

    a, b = sympy.symbols("a b")
    turn = sympy.Matrix([[sympy.cos(a), -sympy.sin(a)], [sympy.sin(a), sympy.cos(a)]])
    exact = (turn * sympy.Matrix([b, 0.25]) - turn.T * sympy.Matrix([3, b * b])).evalf(30, subs={a: 0.7, b: -1.9})
    np.testing.assert_allclose(
        trace_to_python(formula, 2).run(0.7, -1.9), np.array(exact, dtype=float)[:, 0], rtol=1e-14
    )


@pytest.mark.oracle("numpy", few_elements)
def test_a_program_of_a_formula_for_columns_computes_each_element():
    def formula(X):
        return X.swapaxes(0, 1) * X[0, 0] + 1

    x = np.random.default_rng(0).normal(size=(FEW_ELEMENTS, 2, 3))
    elements = few_elements(x, 6)
    np.testing.assert_array_equal(elements, x.reshape(-1, 6))
    results = np.reshape([columnwise_program(formula, (2, 3))(*entries) for entries in elements], (-1, 3, 2))
    np.testing.assert_array_equal(results, np.swapaxes(x, 1, 2) * x[:, :1, :1] + 1)


@pytest.mark.parametrize("entry", [np.nan, np.inf, -np.inf, 1.1e8])
def test_many_elements_and_those_that_could_overflow_are_left_to_arrays(entry):
    assert few_elements(np.ones((FEW_ELEMENTS + 1, 2)), 2) == []
    assert few_elements(np.zeros((0, 2)), 2) == []
    assert few_elements(np.array([[1.0, 2.0], [3.0, entry]]), 2) == []


def test_a_program_can_be_pickled():
    program = trace_to_python(lambda q: np.array([2.5 * q[0], 1.0]), 1)
    assert pickle.loads(pickle.dumps(program)).run(3.0) == program.run(3.0) == (7.5, 1.0)


# --- the programs of arms ---


@given(chains_with_values())
def test_a_single_configuration_equals_that_of_a_batch(drawn):
    chain, q = drawn
    reach = 1 + np.abs(chain.screws[:, 3:]).max() + np.abs(chain.home[:3, 3]).max() + np.abs(q).max()
    for method in (chain.fk, chain.jacobian):
        np.testing.assert_allclose(method(q), method(np.stack([q, q]))[0], rtol=0, atol=1e-14 * reach * chain.n)


@each_robot
def test_no_program_multiplies_by_0_or_1(robot):
    robot.fk(np.zeros(robot.n))
    source = robot._fast.programs["fk"][0].source
    assert " 0.0 *" not in source
    assert " 1.0 *" not in source
    assert "+ 0.0" not in source
    assert source.count("cos(") == sum(letter != "P" for letter in robot.joint_types)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e9])
def test_a_single_configuration_is_refused_with_the_message_of_a_batch(value):
    robot = ROBOTS[0]
    q = np.zeros(robot.n)
    q[0] = value
    for method in (robot.fk, robot.jacobian):
        with pytest.raises(
            ValueError, match=r"q contains NaN or infinity at index|A rotation angle must be at most 1e.*got 1e"
        ) as one:
            method(q)
        with pytest.raises(ValueError, match=re.escape(str(one.value))):
            method(q.tolist())


@pytest.mark.parametrize("kind", [np.int64, np.float32, np.uint8, np.float64])
def test_integers_and_single_precision_are_accepted(kind):
    robot = ROBOTS[0]
    q = np.arange(robot.n)
    np.testing.assert_allclose(robot.fk(q.astype(kind)), robot.fk(q.tolist()), rtol=0, atol=1e-14)
