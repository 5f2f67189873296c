"""Straight-line programs: the same numbers as the formula that wrote them, and nothing in them that was known before."""

import pickle
import re

import numpy as np
import pytest
import sympy
from hypothesis import given
from strategies import ROBOTS, chains_with_values

from kinlib import robots
from kinlib.arrays.codegen import Tracer, trace_to_python

each_robot = pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)


def written(formula, n=2):
    """The program's lines, without its first and its last."""
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
        assert written(formula) == []


@pytest.mark.oracle("text: written out in the test", Tracer.cos, Tracer.sin)
def test_a_cosine_and_a_sine_are_noted_by_their_names():
    assert [f(Tracer("q1", {})).lines for f in (np.cos, np.sin)] == [{"cos(q1)": "v1"}, {"sin(q1)": "v1"}]


def test_minus_one_times_a_number_is_written_as_its_negative():
    assert written(lambda q: np.array([-1 * q[0], q[0] * -1.0, -q[0]])) == ["v1 = -q1"]
    assert written(lambda q: -2 * q[0]) == ["v1 = -2.0 * q1"]


def test_what_was_computed_once_is_not_computed_again():
    assert written(lambda q: np.cos(q[0]) * q[1] + np.cos(q[0]) * q[1]) == [
        "v1 = cos(q1)",
        "v2 = q2 * v1",
        "v3 = v2 + v2",
    ]


def test_each_operation_does_what_it_says():
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
            ]
        ),
        2,
    )
    assert operations.run(2.0, 3.0) == (5.0, 6.0, 6.0, -1.0, -2.0, 2.0, -2.0, 6.0, -2.0, 8.0, 8.0, -2.0)


@pytest.mark.oracle("sympy", trace_to_python)
def test_a_program_says_what_sympy_says():
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


def test_a_program_survives_a_journey_to_another_process():
    program = trace_to_python(lambda q: np.array([2.5 * q[0], 1.0]), 1)
    assert pickle.loads(pickle.dumps(program)).run(3.0) == program.run(3.0) == (7.5, 1.0)


# --- the programs of arms ---


@given(chains_with_values())
def test_a_single_configuration_is_where_the_batch_has_it(drawn):
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
def test_a_single_configuration_is_refused_in_the_words_of_a_batch(value):
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


@pytest.mark.parametrize(
    ("q", "is_written_out"),
    [
        pytest.param(np.array([1.0, 2, 3]), True, id="one configuration"),
        pytest.param(np.array([[1.0, 2, 3]]), True, id="a batch of one"),
        pytest.param(np.array([1, 2, 3], dtype=np.int8), True, id="integers"),
        pytest.param(np.array([1, 2, 3], dtype=np.uint8), True, id="unsigned integers"),
        pytest.param([1.0, 2, 3], False, id="a list"),
        pytest.param(np.array([True, False, True]), False, id="bits"),
        pytest.param(np.array([1.0, 2, 3], dtype=object), False, id="objects"),
        pytest.param(np.array([[1.0, 2, 3]] * 2), False, id="a batch of two"),
        pytest.param(np.empty((0, 3)), False, id="a batch of none"),
    ],
)
def test_a_program_is_written_for_one_configuration_and_for_nothing_else(q, is_written_out):
    """Writing it takes as long as a thousand configurations of a batch."""
    chain = robots.rpr()
    chain.fk(q), chain.jacobian(q)
    assert set(chain._fast.programs) == ({"fk", "jacobian"} if is_written_out else set())


@pytest.mark.parametrize("kind", [np.int64, np.float32, np.uint8, np.float64])
def test_integers_and_single_precision_are_numbers_too(kind):
    robot = ROBOTS[0]
    q = np.arange(robot.n)
    np.testing.assert_allclose(robot.fk(q.astype(kind)), robot.fk(q.tolist()), rtol=0, atol=1e-14)


def test_a_chain_that_has_been_asked_can_still_be_pickled():
    robot = ROBOTS[0]
    q = np.full(robot.n, 0.3)
    T = robot.fk(q)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(robot)).fk(q), T)
