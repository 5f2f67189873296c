"""Invariants of mechanisms: the same for every legal choice, different where the mechanism differs."""

from itertools import product

import numpy as np
import pytest
from example_arms import arm, with_other_choices
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib.dh.invariants import AxisInvariants

SEEDS = st.integers(0, 2**32 - 1)


@pytest.mark.oracle("axiom: no choice of frames changes an invariant", AxisInvariants.violated, AxisInvariants.agree)
@given(SEEDS, st.integers(1, 10), st.sampled_from([0.0, 0.3, 0.7]))
def test_other_choices_violate_no_invariant(seed, n, slides):
    rng = np.random.default_rng(seed)
    chain, cases = arm(rng, n, slides=slides)
    other = with_other_choices(rng, chain)
    invariants = AxisInvariants(chain, 1e-7)
    values = invariants.of(other.lines.axis, other.joint_points)
    assert not invariants.violated(values).any(), cases
    assert invariants.agree(values), cases


def all_tables(rows):
    """Every table of an arm with no parallel neighbours: each z and each x between two joints may have the other direction.

    rows (n, 4), standard. z_k has the sign s, x_k the sign x: a_k x, (alpha_k + pi if s changes) x, and d_k s.
    """
    n = len(rows)
    for s in product([1, -1], repeat=n):
        for x in product([1, -1], repeat=n - 1):
            a, alpha = rows[:-1, 0] * x, (rows[:-1, 1] + np.pi * (np.array(s[:-1]) != s[1:])) * x
            yield np.concatenate([a, np.cos(alpha), np.sin(alpha), (rows[:, 2] * s)[1:-1]])


@given(SEEDS, st.integers(2, 5))
def test_of_arms_with_right_angles_all_signs_are_found_that_trying_them_finds(seed, n):
    """The published arms have right angles and small whole ratios, where signs of different entries make up for each other."""
    rng = np.random.default_rng(seed)
    rows = np.column_stack(
        [
            rng.choice([0, 0.3, -0.3], n),
            rng.choice([np.pi / 2, -np.pi / 2, 1.0], n),
            rng.choice([0, 0.2, -0.2], n),
            np.zeros(n),
        ]
    )
    changed = rows * np.where(rng.random(rows.shape) < 0.4, -1, 1)
    numbers = np.concatenate([changed[:-1, 0], np.cos(changed[:-1, 1]), np.sin(changed[:-1, 1]), changed[1:-1, 2]])
    expected = any(np.abs(numbers - legal).max() < 1e-9 for legal in all_tables(rows))
    one, other = (kl.DHTable(table, convention="standard") for table in (rows, changed))
    assert bool(kl.equivalent(one, other)) == expected
    chain = other.to_chain()
    invariants = AxisInvariants(one.to_chain(), 1e-7)
    assert invariants.agree(invariants.of(chain.lines.axis, chain.joint_points)) == expected
