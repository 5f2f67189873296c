"""Fast kinematics: the same numbers as the equations of `Chain`, for one configuration or many, on any chain."""

import inspect
import pickle

import modern_robotics as mr
import numpy as np
import pytest
from hypothesis import given
from strategies import ROBOTS, chains_with_values, configurations

from kinlib import Chain, exp, robots, screw
from kinlib.chains.fast_kinematics import FEW_CONFIGURATIONS, FastKinematics

EQUATIONS = [Chain.fk, Chain.link_poses, Chain.jacobian, Chain.body_jacobian]
each_equation = pytest.mark.parametrize("method", EQUATIONS, ids=lambda method: method.__name__)


def close(got, expected, atol):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def allowed(chain, q):
    """1e-14 for each joint of an arm of one metre, and in proportion to its size."""
    reach = 1 + np.abs(chain.screws[:, 3:]).max() + np.abs(chain.home[:3, 3]).max()
    return 1e-14 * chain.n * reach * (1 + np.abs(q).max()) ** 2


@each_equation
@given(chains_with_values())
def test_a_single_configuration_agrees_with_the_equation(method, drawn):
    chain, q = drawn
    close(method(chain, q), method.__wrapped__(chain, q), allowed(chain, q))
    assert method.__name__ in chain._fast.programs


@each_equation
@given(chains_with_values())
def test_a_batch_agrees_with_the_equation(method, drawn):
    chain, q = drawn
    few = np.stack([q, -q, q / 3, 0 * q]).reshape(2, 2, chain.n)
    many = np.repeat(few, FEW_CONFIGURATIONS, axis=0)
    for batch, is_program in ((many, False), (few, True)):
        close(method(chain, batch), method.__wrapped__(chain, batch), allowed(chain, q))
        assert (method.__name__ in chain._fast.programs) is is_program


@each_equation
@pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)
def test_every_robot_agrees_with_the_equation(method, robot):
    q = configurations(robot, 50)
    close(method(robot, q), method.__wrapped__(robot, q), allowed(robot, q))
    for row in q[:3]:
        close(method(robot, row), method.__wrapped__(robot, row), allowed(robot, row))


@each_equation
def test_the_source_of_each_method_is_the_equation(method):
    source = inspect.getsource(method)
    assert ("exp(S_i * q_i)" in source) or ("adjoint(inverse(self.fk(q))) @ self.jacobian(q)" in source)
    assert "_fast" not in source


@pytest.mark.parametrize("shape", [(), (0,), (1,), (3,), (2, 0, 3)])
@each_equation
def test_the_equations_accept_the_same_shapes(method, shape):
    robot = robots.hrr()
    q = np.zeros((*shape, robot.n))
    assert method.__wrapped__(robot, q).shape == method(robot, q).shape


@pytest.mark.oracle("modern_robotics", FastKinematics.run_program, FastKinematics.run_batch)
@pytest.mark.parametrize("robot", ROBOTS, ids=lambda robot: robot.name)
def test_programs_and_batches_agree_with_modern_robotics(robot):
    fast = FastKinematics(robot.screws, robot.home, robot.joint_points)
    q = configurations(robot, 3)
    body = [mr.JacobianBody(robot.body_screws.T, row) for row in q]
    poses = mr_poses(robot, q)
    jacobians = [mr.JacobianSpace(robot.screws.T, row) for row in q]
    close(fast.run_batch("fk", q), poses, 1e-12)
    close([fast.run_program("fk", row) for row in q], poses, 1e-12)
    close(fast.run_batch("jacobian", q), jacobians, 1e-12)
    close([fast.run_program("jacobian", row) for row in q], jacobians, 1e-12)
    close(fast.run_batch("body_jacobian", q), body, 1e-12)
    close(fast.run_program("body_jacobian", q), body, 1e-12)


FEW_ARRAYS = {
    "one configuration": np.array([1.0, 2, 3]),
    "a batch of one": np.array([[1.0, 2, 3]]),
    "integers": np.array([1, 2, 3], dtype=np.int8),
    "unsigned integers": np.array([1, 2, 3], dtype=np.uint8),
    "a batch of two": np.array([[1.0, 2, 3]] * 2),
    "as many as are few": np.ones((2, FEW_CONFIGURATIONS // 2, 3)),
    "an empty batch": np.empty((0, 3)),
}
OTHER = {
    "a list": [1.0, 2, 3],
    "Boolean values": np.array([True, False, True]),
    "objects": np.array([1.0, 2, 3], dtype=object),
    "a long batch": np.ones((FEW_CONFIGURATIONS + 1, 3)),
}
INVALID = {
    "too few values": np.array([1.0, 2]),
    "a column": np.array([[1.0], [2], [3]]),
    "NaN": np.array([1.0, np.nan, 3]),
    "NaN in a batch of two": np.array([[1.0, 2, 3], [np.nan, 2, 3]]),
    "a rotation too large": np.array([1e9, 0, 0]),
    "complex numbers": np.array([1, 2, 3j]),
}


@pytest.mark.oracle("text: written out in the test", FastKinematics.are_few_configurations)
@pytest.mark.parametrize("q", [*FEW_ARRAYS.values(), *OTHER.values()], ids=[*FEW_ARRAYS, *OTHER])
def test_few_configurations_are_distinguished_from_what_must_be_validated(q):
    assert robots.rpr()._fast.are_few_configurations(q) is any(q is one for one in FEW_ARRAYS.values())


@pytest.mark.oracle("text: written out in the test", FastKinematics.run)
@pytest.mark.parametrize("count", [1, FEW_CONFIGURATIONS, FEW_CONFIGURATIONS + 1])
def test_a_program_is_generated_for_few_configurations_only(count):
    """Generating it takes as long as a thousand configurations of a batch."""
    robot = robots.rpr()
    q = configurations(robot, count)
    close(robot.fk(q), mr_poses(robot, q), 1e-13)
    assert set(robot._fast.programs) == ({"fk"} if count <= FEW_CONFIGURATIONS else set())


@pytest.mark.parametrize("name", ["fk", "link_poses", "jacobian", "body_jacobian"])
def test_arrays_compute_fewer_configurations_already_if_the_program_is_long(name, monkeypatch):
    long = Chain(screw(np.eye(3)[[2, 0, 1, 2]] @ exp([0.3, 0.5, 0.7]), np.eye(4)[:, 1:]), np.eye(4))
    called = []
    monkeypatch.setattr(FastKinematics, "run_batch", lambda *_: called.append("batch"))
    monkeypatch.setattr(FastKinematics, "run_program", lambda *_: called.append("program"))
    for count in range(1, FEW_CONFIGURATIONS + 2):
        long._fast.run(name, configurations(long, count))
    few = called.count("program")
    assert 1 < few <= FEW_CONFIGURATIONS
    assert called == ["program"] * few + ["batch"] * (FEW_CONFIGURATIONS + 1 - few)


def mr_poses(robot, q):
    return [mr.FKinSpace(robot.home, robot.screws.T, row) for row in q]


@pytest.mark.parametrize("q", INVALID.values(), ids=INVALID)
def test_an_invalid_configuration_is_not_passed_to_a_program(q):
    assert robots.rpr()._fast.are_few_configurations(q) is False


def test_a_name_without_a_formula_is_refused():
    with pytest.raises(ValueError, match="There is no fast implementation of 'fk_body'"):
        robots.rpr()._fast.run_batch("fk_body", np.zeros(3))


def test_a_chain_with_programs_can_be_pickled_and_generates_them_anew():
    robot = robots.youbot()
    q = configurations(robot, 1)[0]
    T = robot.fk(q)
    again = pickle.loads(pickle.dumps(robot))
    assert "_fast" not in vars(again)
    close(again.fk(q), T, 0)
