"""No public function of kinlib without a witness, and no witness that is not asked."""

import os
from types import SimpleNamespace

import doubts
import modern_robotics as mr
import numpy as np
import oracles
import pytest
from hypothesis import given
from strategies import poses

from kinlib import Chain, adjoint, exp, inverse

TABLE = oracles.table()
KINDS = ("printed", "axiom", "text")


def test_every_public_function_has_a_witness():
    silent = [name for name, heard in TABLE.items() if not heard]
    assert not silent, "compare each with somebody else's, and say so: @pytest.mark.oracle(...); see tests/oracles.py"


def test_every_witness_speaks_of_a_public_function():
    assert set(TABLE) == set(oracles.public())


@pytest.mark.parametrize("oracle", sorted({witness.oracle for heard in TABLE.values() for witness in heard}))
def test_an_oracle_is_a_package_that_its_tests_import_or_what_it_is_instead_is_said(oracle):
    kind, colon, words = oracle.partition(": ")
    if colon:
        assert kind in KINDS
        assert len(words) > 8
        return
    pytest.importorskip(oracle)
    assert oracle != "kinlib"
    helpers = "".join(path.read_text("utf-8") for path in oracles.TESTS.glob("*.py") if path.stem[:5] != "test_")
    for file in {
        witness.test.partition("::")[0] for heard in TABLE.values() for witness in heard if witness.oracle == oracle
    }:
        text = (oracles.TESTS / file).read_text("utf-8") + helpers
        assert f"import {oracle}" in text or f"from {oracle}" in text or f'importorskip("{oracle}' in text


# --- doubts: a sham is found out ---


@given(poses())
def honest(T):
    np.testing.assert_allclose(adjoint(T), mr.Adjoint(T), atol=1e-12)


@given(poses())
def alone(T):
    np.testing.assert_allclose(adjoint(inverse(T)) @ adjoint(T), np.eye(6), atol=1e-12)


@given(poses())
def idle(T):
    adjoint(T)
    np.testing.assert_allclose(mr.Adjoint(T), mr.Adjoint(T))


@given(poses())
def blunt(T):
    np.testing.assert_allclose(adjoint(T), mr.Adjoint(T), atol=1e-3)


def borrowed():
    """Both sides come from the function itself."""
    np.testing.assert_allclose(exp([0, 0, 1.0]), exp([0, 0, 1.0]) + mr.Adjoint(np.eye(4))[0, 1])


def as_test(function, *about):
    mark = pytest.mark.oracle("modern_robotics", *about).mark
    return SimpleNamespace(name=function.__name__, obj=function, runtest=function, iter_markers=lambda _: [mark])


forks = pytest.mark.skipif(not hasattr(os, "fork"), reason="a doubt is raised in a fork")


@forks
def test_an_honest_witness_is_believed():
    doubts.doubt(as_test(honest, adjoint))


@forks
@pytest.mark.parametrize(
    ("sham", "about", "why"),
    [
        (alone, adjoint, "passes without modern_robotics"),
        (idle, adjoint, "no difference when kinlib.lie.adjoint errs"),
        (blunt, adjoint, "no difference when kinlib.lie.adjoint errs"),
        (borrowed, exp, "no difference when kinlib.lie.exp errs"),
        (honest, Chain.fk, "no difference when kinlib.chain.Chain.fk errs"),
    ],
)
def test_a_sham_is_found_out(sham, about, why):
    with pytest.raises(pytest.fail.Exception, match=why):
        doubts.doubt(as_test(sham, about))
