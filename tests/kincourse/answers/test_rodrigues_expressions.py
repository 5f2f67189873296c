"""Exponentials in solutions: they are those of kinlib, for axes of any length, and so is each change that keeps them."""

import numpy as np
import pytest

from kincourse.expressions.rodrigues import angle_symbol, position_exp, rotation_exp, truncated
from kinlib.rigid.lie import exp, hat
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
            wrong = mutate(right, mutation.replaced)
            assert not np.allclose(wrong.value, right.value), mutation.slip.did


def test_a_series_cut_short_has_the_number_of_terms_that_its_text_says(parts):
    omega, _, theta = parts
    right = rotation_exp(given("\\omega", omega), given("q", theta))
    for terms, count in {2: "two", 3: "three", 4: "four"}.items():
        [cut] = [one for one in mutations(right) if one.slip.did == f"stop the series after {count} terms"]
        assert np.allclose(mutate(right, cut.replaced).value, truncated(hat(omega) * theta, terms))
