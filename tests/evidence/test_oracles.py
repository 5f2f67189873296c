"""Every public function of kinlib has an oracle, and the oracle check detects comparisons that prove nothing."""

import os
import re
from types import SimpleNamespace

import check_oracles
import modern_robotics as mr
import numpy as np
import oracle_table
import pytest
from hypothesis import given
from strategies import poses

from kinlib import Chain, adjoint, exp, inverse

TABLE = oracle_table.table()
COMPARISONS = [comparison for comparisons in TABLE.values() for comparison in comparisons]
KINDS = ("printed", "axiom", "text")


def test_every_public_function_has_an_oracle():
    missing = [name for name, comparisons in TABLE.items() if not comparisons]
    assert not missing, "mark a test of each with @pytest.mark.oracle(...): see evidence/checks/oracle_table.py"


def test_an_oracle_is_an_imported_package_or_a_description():
    helpers = "".join(path.read_text("utf-8") for path in oracle_table.TESTS.rglob("*.py") if path.stem[:5] != "test_")
    for oracle in {comparison.oracle for comparison in COMPARISONS}:
        kind, colon, words = oracle.partition(": ")
        if colon:
            assert kind in KINDS
            assert len(words) > 8
            continue
        assert oracle != "kinlib"
        for file in {comparison.test.partition("::")[0] for comparison in COMPARISONS if comparison.oracle == oracle}:
            text = (oracle_table.TESTS / file).read_text("utf-8") + helpers
            assert re.search(rf'(import|from) {oracle}\b|importorskip\("{oracle}\b', text), file


# --- the check detects comparisons that prove nothing ---


@given(poses())
def compares(T):
    np.testing.assert_allclose(adjoint(T), mr.Adjoint(T), atol=1e-12)


@given(poses())
def ignores_the_oracle(T):
    np.testing.assert_allclose(adjoint(inverse(T)) @ adjoint(T), np.eye(6), atol=1e-12)


@given(poses())
def ignores_the_function(T):
    adjoint(T)
    np.testing.assert_allclose(mr.Adjoint(T), mr.Adjoint(T))


@given(poses())
def tolerates_too_much(T):
    np.testing.assert_allclose(adjoint(T), mr.Adjoint(T), atol=1e-3)


def computes_both_sides_itself():
    """Both sides come from the function under test."""
    np.testing.assert_allclose(exp([0, 0, 1.0]), exp([0, 0, 1.0]) + mr.Adjoint(np.eye(4))[0, 1])


def as_test(function, *about):
    mark = pytest.mark.oracle("modern_robotics", *about).mark
    return SimpleNamespace(name=function.__name__, obj=function, runtest=function, iter_markers=lambda _: [mark])


@pytest.mark.skipif(not hasattr(os, "fork"), reason="each check runs in a fork, which Windows does not have")
def test_a_comparison_that_proves_nothing_fails_and_a_real_one_passes():
    check_oracles.check(as_test(compares, adjoint))
    for comparison, function, reason in [
        (ignores_the_oracle, adjoint, "passes without modern_robotics"),
        (ignores_the_function, adjoint, "no difference when kinlib.rigid.lie.adjoint is wrong"),
        (tolerates_too_much, adjoint, "no difference when kinlib.rigid.lie.adjoint is wrong"),
        (computes_both_sides_itself, exp, "no difference when kinlib.rigid.lie.exp is wrong"),
        (compares, Chain.fk, "no difference when kinlib.chains.chain.Chain.fk is wrong"),
    ]:
        with pytest.raises(pytest.fail.Exception, match=reason):
            check_oracles.check(as_test(comparison, function))
