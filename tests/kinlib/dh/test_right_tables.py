"""Right tables are never accused: not where axes are nearly parallel, and not of what the rounding of their numbers explains."""

import numpy as np
import pytest
from example_arms import arm, configurations, reduced_count
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib import DHTable, assign_frames, diagnose, equivalent
from kinlib.chains.joint_maps import identity_map, joint_maps, linearized
from kinlib.dh.equivalence import derived_accuracy
from kinlib.dh.printed_digits import judge_rounding, rounding_effect, typed_half_units

CONVENTIONS = ("standard", "modified")
ANGLES_RAD = np.concatenate([[0.0], np.logspace(-14, -2, reduced_count(24 * 12) + 1)])


def drawn_arm(rng, angle):
    """An arm with nearly parallel axes: all of them, or some among the other cases."""
    cases = {"cases": ()} if rng.random() < 0.5 else {}
    return arm(rng, int(rng.integers(2, 8)), angle=angle, slides=rng.choice([0, 0.25]), **cases)[0]


def rounded(table, decimals):
    return table.changed(rows=table.rows.round(decimals))


@pytest.mark.oracle("axiom: the table of an arm is right", assign_frames)
@pytest.mark.parametrize("convention", CONVENTIONS)
def test_no_assigned_table_is_accused_at_any_angle_and_with_any_number_of_digits(convention):
    rng = np.random.default_rng(29)
    for angle in ANGLES_RAD:
        chain = drawn_arm(rng, angle)
        found = assign_frames(chain, convention=convention)
        q = configurations(rng, chain)
        assert np.abs(found.table.fk(q) - chain.fk(q)).max() < 1e-6
        assert equivalent(found.table, chain).verdict != "different", angle
        for decimals in (rng.integers(0, 13), 16):
            diagnosis = diagnose(rounded(found.table, decimals), chain)
            assert diagnosis.verdict != "wrong", (angle, decimals, str(diagnosis))


@given(st.integers(0, 2**32 - 1), st.sampled_from(CONVENTIONS), st.floats(-14, -2), st.integers(0, 12))
def test_a_rounded_table_is_not_accused(seed, convention, power, decimals):
    chain = drawn_arm(np.random.default_rng(seed), 10.0**power)
    table = rounded(assign_frames(chain, convention=convention).table, decimals)
    found = diagnose(table, chain)
    assert found.verdict != "wrong", str(found)
    if found.verdict == "rounded":
        assert found.rounding.nearest.difference <= max(found.rounding.effect, 1e-8)


@given(st.integers(0, 2**32 - 1), st.integers(1, 6))
def test_rounding_changes_poses_by_no_more_than_its_bound(seed, decimals):
    rng = np.random.default_rng(seed)
    chain = arm(rng, int(rng.integers(1, 8)))[0]
    exact = assign_frames(chain, convention="standard").table
    table = rounded(exact, decimals)
    half, _ = typed_half_units(table.rows)
    assert (np.abs(table.rows - exact.rows) <= half * (1 + 1e-9)).all()
    q = configurations(rng, chain, reach=np.pi)
    assert np.abs(table.fk(q) - exact.fk(q)).max() <= rounding_effect(table, half) + 1e-12


@pytest.mark.parametrize("angle", [1e-8, 1e-6, 1e-4])
def test_other_choices_of_a_nearly_parallel_arm_are_not_called_different(angle):
    """Base, tool and zeros are moved, so that the poses agree only under a map that has to be found."""
    rng = np.random.default_rng(3)
    for _ in range(reduced_count(20)):
        chain = drawn_arm(rng, angle)
        base, tool, zeros = kl.exp(rng.normal(size=6)), kl.exp(rng.normal(size=6)), rng.uniform(-1, 1, chain.n)
        moved = kl.Chain((kl.adjoint(base) @ chain.jacobian(zeros)).T, base @ chain.fk(zeros) @ tool)
        assert equivalent(chain, moved).verdict != "different"


def test_wrong_tables_of_few_digits_are_still_accused():
    right = DHTable(
        [[4, np.pi / 2, 1, 0], [3, np.pi / 2, 0, 0], [2, -np.pi / 2, 2, 0], [1, 0, 0, 0]], convention="standard"
    )
    for place, value, text in (((1, 0), 2, "a should be 3"), ((2, 2), 1, "d should be 2"), ((0, 0), -4, "wrong sign")):
        rows = np.array(right.rows)
        rows[place] = value
        found = diagnose(right.changed(rows=rows), right, ("base", "tool", "zeros", "signs"))
        assert found.verdict == "wrong"
        assert text in str(found)


def test_the_rounding_of_the_numbers_is_said_with_what_it_explains():
    right = DHTable([[0.4318, 0.7, 0.1501, 0], [0.0203, -1.1, 0.4312, 0], [0.25, 0, 0, 0]], convention="standard")
    found = diagnose(rounded(right, 2), right)
    assert found.verdict == "rounded"
    assert found.corrected is found.table
    assert str(found).startswith(
        "This table describes the arm to within the rounding of its numbers (lengths to 0.01 m, angles to 0.1 rad); its poses"
    )
    judged = judge_rounding(rounded(right, 2), right.to_chain(), ())
    assert judged.verdict == "explains"
    assert judged.limit.startswith(
        "The rounding of its numbers (lengths to 0.01 m, angles to 0.1 rad) explains a difference"
    )
    beyond = right.changed(rows=right.rows + np.array([[2e-4, 0, 0, 0], [0] * 4, [0] * 4]))
    assert diagnose(beyond, right).verdict == "wrong"


# --- three answers, and what they say ---


def test_what_is_undecided_is_neither_true_nor_false():
    chain = arm(np.random.default_rng(3), 4, cases=(), angle=3e-8, slides=0)[0]
    table = assign_frames(chain, convention="standard").table
    found = equivalent(table, chain, tolerance=1e-12)
    assert found.verdict == "undecided"
    assert found.difference <= found.accuracy == derived_accuracy(chain) < 1e-5
    assert "nearly parallel" in found.reason
    offered = float(found.reason.partition("tolerance=")[2].split()[0])
    assert equivalent(table, chain, tolerance=offered).verdict == "same"
    with pytest.raises(ValueError, match=r"must be decided to be used as True or False\. The poses differ by"):
        bool(found)


@pytest.mark.parametrize(("typed_pi", "digits"), [(3.1416, 5), (3.14159, 6), (3.141593, 7)])
def test_the_texts_of_different_numbers_differ_and_the_offered_tolerance_works(typed_pi, digits):
    """The data of files have pi with a few digits: axes are 7e-6 rad from parallel, and 0.407 m apart as in the table."""
    rows = [[0.3, 0.5, 0.1, 0], [0.407, np.pi, 0.2, 0], [0.25, 0.9, 0.35, 0], [0.2, 0, 0, 0]]
    hand = DHTable(rows, convention="standard")
    rows[1][1] = typed_pi
    file = DHTable(rows, convention="standard", base=kl.exp([0.3, 0, 0, 1, 0, 0])).to_chain()
    found = equivalent(hand, file)
    assert found.verdict == "different", digits
    first, second = (part.split(" degrees")[0] for part in found.reason.split(" of ")[1:3])
    assert first != second
    offered = float(found.reason.partition("tolerance=")[2].split()[0])
    assert offered < 1e-4
    assert equivalent(hand, file, tolerance=offered).verdict == "same"
    assert diagnose(hand, file).verdict in {"right", "rounded"}


@pytest.mark.oracle(
    "axiom: a small error is linear in the steps, and a map leads from one arm to the other",
    linearized,
    joint_maps,
    identity_map,
)
def test_errors_are_linear_and_maps_lead_to_the_other_arm():
    rng = np.random.default_rng(0)
    chain = arm(rng, 5, cases=("skew",), slides=0)[0]
    X, Y, q, step = kl.exp(rng.normal(size=6)), kl.exp(rng.normal(size=6)), rng.normal(size=(7, 5)), rng.normal(size=17)
    target, small = X @ chain.fk(q) @ Y, 1e-6 * step
    error, J = linearized(X, chain, q, Y, target)
    np.testing.assert_allclose(error, 0, atol=1e-12)
    moved = linearized(kl.exp(small[:6]) @ X, chain, q + small[6:-6], Y @ kl.exp(small[-6:]), target)[0]
    np.testing.assert_allclose(1e6 * moved, J @ step, atol=1e-3)
    assert identity_map(chain, chain).difference == 0
    assert min(found.difference for found in joint_maps(chain, chain, frozenset(), 0.1)) < 1e-9
