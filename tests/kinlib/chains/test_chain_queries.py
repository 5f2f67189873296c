"""What a chain can be asked beside its poses: limits, names; and how it is stored."""

import json

import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st
from strategies import chains_with_values, rotations

import kinlib as kl
from kinlib import Chain, nearest_rotation


def close(got, expected, atol=1e-12):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


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


@given(rotations(), st.integers(1, 4))
def test_the_nearest_rotation_is_that_of_the_polar_decomposition(R, digits):
    rounded = np.round(R, digits)
    close(nearest_rotation(rounded), scipy.linalg.polar(rounded)[0])
    kl.inverse(nearest_rotation(rounded))  # it is a rotation now
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rounded, (1, 2, 3)
    close(nearest_rotation(pose)[:3, :3], nearest_rotation(rounded))
    close(nearest_rotation(pose)[:3, 3], (1, 2, 3), 0)


@pytest.mark.parametrize(
    ("X", "words"),
    [
        (np.zeros((3, 3)), "differs by 1"),
        (np.diag([1, 1, -1]), "a reflection"),
        (np.eye(2), "must have shape"),
        (2 * np.eye(3), "differs by 1"),
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 1]], "last row"),
    ],
)
def test_what_is_no_rounded_rotation_is_refused(X, words):
    with pytest.raises(ValueError, match=words):
        nearest_rotation(X)
