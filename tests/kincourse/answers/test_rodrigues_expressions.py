"""Exponentials in solutions: they are those of kinlib, for axes of any length, and so is each change that keeps them."""

import numpy as np
import pytest

from kincourse.expressions.rodrigues import angle_symbol, position_exp, rotation_exp
from kinlib.rigid.lie import exp
from misstep.mutants.expression import given
from misstep.mutants.mutants import mutate, mutations


@pytest.fixture(params=[1.0, 0.5, 3.0])
def parts(request):
    random = np.random.default_rng(5)
    omega = random.normal(size=3)
    return request.param * omega / np.linalg.norm(omega), random.normal(size=3), 0.7


def test_the_exponential_is_that_of_kinlib(parts):
    omega, v, theta = parts
    expected = exp(np.concatenate([omega, v]) * theta)
    assert np.allclose(rotation_exp(omega, theta).value, expected[:3, :3])
    assert np.allclose(position_exp(omega, v, theta).value, expected[:3, 3])


def test_every_change_of_an_exponential_is_wrong(parts):
    omega, v, theta = given("\\omega", parts[0]), given("v", parts[1]), angle_symbol(parts[2])
    for right in (rotation_exp(omega, theta), position_exp(omega, v, theta)):
        for mutation in mutations(right):
            wrong = mutate(right, mutation.replaced, {})
            assert not np.allclose(wrong.value, right.value), mutation.slip.did
