"""Equivalence: the same mechanism for every legal choice, another one for every change that counts, and invariants that agree."""

from itertools import product

import numpy as np
import pytest
from example_arms import arm, with_other_choices
from hypothesis import given, settings
from hypothesis import strategies as st

import kinlib as kl
from kinlib import DHTable, equivalent
from kinlib.dh.alignment import AxisInvariants
from kinlib.dh.slips import CHOICES

SEEDS = st.integers(0, 2**32 - 1)


@given(SEEDS, st.integers(1, 9), st.sampled_from([0.0, 0.3]))
def test_every_other_choice_is_the_same_mechanism_with_a_map_that_holds(seed, n, slides):
    rng = np.random.default_rng(seed)
    chain, cases = arm(rng, n, slides=slides)
    other = with_other_choices(rng, chain)
    invariants = AxisInvariants(chain, 1e-7)
    assert invariants.agree(invariants.of(other.lines.axis, other.joint_points)[None]).all(), cases
    found = equivalent(chain, other)
    assert found, (chain.joint_types, cases)
    q = rng.uniform(-2, 2, (5, n))
    np.testing.assert_allclose(
        other.fk(q), found.base @ chain.fk(found.signs * q + found.offsets) @ found.tool, atol=2e-8
    )


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
    """Published arms have right angles and equal lengths, where signs of different entries compensate for each other."""
    rng = np.random.default_rng(seed)
    lengths, offsets = rng.choice([0, 0.3, -0.3], n), rng.choice([0, 0.2, -0.2], n)
    rows = np.column_stack([lengths, rng.choice([np.pi / 2, -np.pi / 2, 1.0], n), offsets, np.zeros(n)])
    changed = rows * np.where(rng.random(rows.shape) < 0.4, -1, 1)
    numbers = np.concatenate([changed[:-1, 0], np.cos(changed[:-1, 1]), np.sin(changed[:-1, 1]), changed[1:-1, 2]])
    expected = any(np.abs(numbers - legal).max() < 1e-9 for legal in all_tables(rows))
    one, other = (DHTable(table, convention="standard") for table in (rows, changed))
    assert bool(equivalent(one, other)) == expected


@given(SEEDS, st.integers(3, 7), st.sampled_from(["a", "alpha", "d"]))
def test_a_changed_number_is_another_mechanism(seed, n, column):
    rng = np.random.default_rng(seed)
    rows = rng.uniform(0.2, 1.2, (n, 4))
    changed = rows.copy()
    changed[rng.integers(1, n - 1), ("a", "alpha", "d").index(column)] += 0.05
    one, other = (DHTable(table, convention="standard") for table in (rows, changed))
    found = equivalent(one, other)
    assert found.verdict == "different"
    assert found.reason


def test_the_largest_difference_is_told_with_digits_that_show_it():
    rows = np.array([[0.3, 0.7, 0.1, 0], [0.25, 1.1, 0.2, 0], [0.2, 0, 0.3, 0]])
    for place, off, words in (
        ((0, 0), 0.00007, "Axes 1 and 2 are 0.3 m apart in the first, and 0.30007 m in the second."),
        ((1, 1), 0.1, "Axes 2 and 3 make an angle of 63.03 degrees in the first, and of 68.75 degrees in the second."),
    ):
        changed = rows.copy()
        changed[place] += off
        changed[0, 0] += 1e-6
        one, other = (DHTable(table, convention="standard") for table in (rows, changed))
        assert equivalent(one, other).reason.startswith(words[:40])
    assert equivalent(kl.robots.rpr(), kl.robots.rppr()).reason.startswith("The joint types differ: RPR in the first")


def with_choices(rng, chain, free):
    """The same arm with other choices of these kinds, and no others."""
    offsets = rng.uniform(-1, 1, chain.n) if "zeros" in free else np.zeros(chain.n)
    signs = rng.choice([-1, 1], chain.n) if "signs" in free else np.ones(chain.n)
    if "signs" in free:
        signs[rng.integers(chain.n)] = -1
    base, tool = (kl.exp(rng.normal(size=6)) if name in free else np.eye(4) for name in ("base", "tool"))
    screws = (kl.adjoint(base) @ chain.jacobian(offsets)).T * signs[:, None]
    return kl.Chain(screws, base @ chain.fk(offsets) @ tool)


@pytest.mark.parametrize("free", [set(), *({name} for name in CHOICES), {"base", "zeros"}, {"tool", "signs"}])
@settings(max_examples=8)
@given(seed=SEEDS, n=st.integers(1, 8), slides=st.sampled_from([0.0, 0.3]))
def test_what_is_fixed_does_not_differ_in_the_map(free, seed, n, slides):
    rng = np.random.default_rng(seed)
    chain, cases = arm(rng, n, slides=slides)
    other, fixed = with_choices(rng, chain, free), {*CHOICES} - free
    found = equivalent(chain, other, fixed=fixed)
    assert found, (chain.joint_types, cases)
    for name, T in (("base", found.base), ("tool", found.tool)):
        assert name not in fixed or (np.eye(4) == T).all()
    assert "zeros" not in fixed or not found.offsets.any()
    assert "signs" not in fixed or (found.signs == 1).all()


@pytest.mark.parametrize("name", CHOICES)
@settings(max_examples=8)
@given(seed=SEEDS, n=st.integers(3, 7))
def test_what_is_fixed_and_differs_is_another_arm(name, seed, n):
    """The axes are skew, so that no other choice compensates for it."""
    rng = np.random.default_rng(seed)
    chain, _ = arm(rng, n, cases=["skew"], slides=0)
    other = with_choices(rng, chain, {name})
    assert not equivalent(chain, other, fixed=[name])


def test_a_map_is_rigid_however_large_the_tolerance():
    arm = kl.robots.puma560()
    for seed in range(20):
        moved = arm.changed(home=arm.home @ kl.exp(np.random.default_rng(seed).normal(size=6)))
        kl.inverse(
            equivalent(arm, moved, fixed=["base", "zeros", "signs"], tolerance=0.8).tool
        )  # refuses what is no pose


def test_what_is_undecided_is_neither_true_nor_false():
    chain = arm(np.random.default_rng(3), 4, cases=(), angle=3e-8, slides=0)[0]
    table = kl.assign_frames(chain, convention="standard").table
    found = equivalent(table, chain, tolerance=1e-13)
    assert found.verdict == "undecided"
    assert "nearly parallel" in found.reason
    with pytest.raises(ValueError, match=r"must be decided to be used as True or False\. The poses differ by"):
        bool(found)


@pytest.mark.parametrize("seed", [11, 12, 21, 22])
def test_signs_of_a_wrist_are_found_whatever_the_zeros(seed):
    """The Stanford arm: axes at right angles that intersect leave many choices of the signs."""
    rows = [(0, -90, 0.412, 0), (0, 90, 0.154, 0), (0, 0, 0, -90), (0, -90, 0, 0), (0, 90, 0, 0), (0, 0, 0.263, 0)]
    table = DHTable(np.array(rows) * (1, np.pi / 180, 1, np.pi / 180), convention="standard", joints="RRPRRR")
    other = with_choices(np.random.default_rng(seed), table.to_chain(), {"base", "zeros", "signs"})
    assert equivalent(table, other, fixed=["tool"])
