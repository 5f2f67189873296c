"""Chains: agreement of the three forms, and with 40 digits, Modern Robotics and Pinocchio; batches, Jacobians, names, errors."""

import json

import modern_robotics as mr
import mpmath_oracle
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import chains_with_values

from kinlib import Chain, robots, screw

EXACT = 1e-13


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def allowed(chain, q):
    """1e-13 for an arm of up to 10 m, and in proportion beyond: an error in an angle grows with the arm that it turns."""
    shifts = np.linalg.norm(chain.screws[:, 3:], axis=-1) * (1 + np.abs(q)).max()
    return EXACT * max(1, (shifts.sum() + np.linalg.norm(chain.home[:3, 3])) / 10)


@given(chains_with_values())
def test_all_forms_are_the_product_to_40_digits_on_any_chain(drawn):
    chain, q = drawn
    T = mpmath_oracle.fk(chain, q)
    for form in (chain.fk(q), chain.fk_body(q), *(chain.fk_mid(q, k) for k in range(chain.n + 1))):
        close(form, T, allowed(chain, q))


def pinocchio_model(pin, chain):
    """Pinocchio's model with one joint a screw, built from nothing but the screws."""
    model = pin.Model()
    parent, at = 0, np.zeros(3)
    for i, S in enumerate(chain.screws):
        omega, v = S[:3], S[3:]
        point = np.cross(omega, v)  # on the axis, nearest the origin; zero for a slide
        if not omega.any():
            joint = pin.JointModelPrismaticUnaligned(v)
        elif abs(omega @ v) > 1e-15:
            joint = pin.JointModelHelicalUnaligned(omega, omega @ v)
        else:
            joint = pin.JointModelRevoluteUnaligned(omega)
        parent = model.addJoint(parent, joint, pin.SE3(np.eye(3), point - at), f"joint {i + 1}")
        at = point
    return model


@given(chains_with_values())
def test_links_stand_where_pinocchio_has_its_joints(drawn):
    """Pinocchio's joint frames start at the points nearest the origin, ours at joint_points: both are parallel to {s}."""
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    chain, q = drawn
    model = pinocchio_model(pin, chain)
    data = model.createData()
    pin.forwardKinematics(model, data, q)
    for S, point, link, placed in zip(
        chain.screws, chain.joint_points, chain.link_poses(q), list(data.oMi)[1:], strict=True
    ):
        start = np.cross(S[:3], S[3:])
        close(link, (placed * pin.SE3(np.eye(3), point - start)).homogeneous, allowed(chain, q))


@given(chains_with_values())
def test_jacobians_agree_with_modern_robotics(drawn):
    chain, q = drawn
    q = np.where(np.abs(q) < 1e-5, 0, q)  # modern_robotics takes turns below 1e-6 for none
    close(chain.jacobian(q), mr.JacobianSpace(chain.screws.T, q), allowed(chain, q))
    close(chain.body_jacobian(q), mr.JacobianBody(chain.body_screws.T, q), allowed(chain, q))


@pytest.mark.parametrize("shape", [(0,), (1,), (2, 0, 3), (2, 3)])
def test_a_batch_is_its_configurations_one_at_a_time(shape):
    robot = robots.hrr()
    for method in ("fk", "fk_body", "link_poses", "jacobian", "body_jacobian"):
        q = np.random.default_rng(1).uniform(-3, 3, (*shape, robot.n))
        f = getattr(robot, method)
        batch = f(q)
        assert batch.shape == (*shape, *f(np.zeros(robot.n)).shape)
        for index in np.ndindex(shape):
            close(batch[index], f(q[index]), atol=1e-14)


def test_what_is_no_chain_and_no_k_is_refused():
    screws, zero, rpr = robots.youbot().screws, np.eye(4), robots.rpr()
    two = [screw((0, 0, 1)), screw((0, 0, 1), (1, 0, 0))]
    for make, message in [
        (lambda: Chain(screws.T, zero), r"screws must have shape \(\.\.\., 6\); got \(6, 5\).*try screws\.T"),
        (lambda: Chain(screws * 2, zero), r"In screws\[0\] the length of omega is 2\. .*divide all six numbers"),
        (lambda: Chain(two, zero, np.zeros((2, 3))), r"joint 2 must lie on its axis; it is 1 m away\. Is it .*another"),
        (
            lambda: rpr.changed(limits=[[-1, 1], [1, -1], [0, 1]]),
            r"limits of joint 2 .*\[1.0, -1.0\]. Are they swapped",
        ),
        (lambda: rpr.changed(joint_names=("shoulder", "elbow")), "3 different names; got "),
        *(
            (lambda k=k: rpr.fk_mid(np.zeros(3), k), "k must be a whole number from 0 to 3, .*; got ")
            for k in (-1, 4, 1.5)
        ),
    ]:
        with pytest.raises(ValueError, match=message):
            make()


@pytest.mark.parametrize(
    ("q", "message"),
    [
        ([1, 2, 3, 4], r"youBot has 5 joint values, so q must have shape \(\.\.\., 5\); got \(4,\)"),
        (np.zeros((5, 100)), r"got \(5, 100\)\. Joints go in the last dimension: try q\.T"),
        ([0, 0, 1e9, 0, 0], r"A rotation angle must be at most 1e\+08 rad.*got 1e\+09 rad"),
    ],
)
def test_invalid_joint_values_are_refused_by_every_method(q, message):
    arm = robots.youbot()
    for method in (arm.fk, arm.fk_body, arm.link_poses, arm.jacobian, arm.body_jacobian, arm.within_limits):
        with pytest.raises(ValueError, match=message):
            method(q)


@given(chains_with_values(), st.integers(0, 100))
def test_random_configurations_are_within_the_limits_and_limits_can_be_asked(drawn, seed):
    chain, q = drawn
    rng = np.random.default_rng(seed)
    limits = np.sort(rng.normal(size=(chain.n, 2)), axis=1)
    limits[rng.random((chain.n, 2)) < 0.3] = np.inf
    limits[:, 0] = np.where(np.isinf(limits[:, 0]), -np.inf, limits[:, 0])
    limited = Chain(chain.screws, chain.home, limits=limits)
    assert limited.within_limits(limited.random_configurations(20, seed)).all()
    expected = [lower <= x <= upper for x, (lower, upper) in zip(q, limits, strict=True)]
    assert limited.within_limits(q) == all(expected)
    assert chain.within_limits(q)


@given(chains_with_values())
def test_a_chain_is_stored_as_json_and_read_back(drawn):
    chain, _ = drawn
    limits = np.tile([-1.0, np.inf], (chain.n, 1))
    names = tuple(f"joint {i}" for i in range(chain.n))
    one = Chain(chain.screws, chain.home, chain.joint_points, "an arm", "a test", limits, names)
    assert one.to_dict()["screws"] == chain.screws.tolist()
    again = Chain.from_dict(json.loads(json.dumps(one.to_dict(), allow_nan=False)))
    for name in ("screws", "home", "points", "limits"):
        assert np.array_equal(getattr(one, name), getattr(again, name))
    assert (again.name, again.source, again.joint_names) == ("an arm", "a test", names)
