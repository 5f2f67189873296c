"""Diagnosis: right tables are right, each slip is told with its place, and rounding is not called a mistake."""

from contextlib import suppress

import numpy as np
import pytest
from example_arms import arm
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib import DHTable, assign_frames, diagnose, equivalent
from kinlib.dh.explanation.rounding import rounding_effect, typed_half_units
from kinlib.dh.slips import CHOICES, changed_in, slips_in_places

PUMA = kl.robots.puma560()
STANDARD = assign_frames(PUMA, convention="standard").table


def published(*rows, **options):
    """A table from its printed rows: a, alpha in degrees, d, theta in degrees."""
    return DHTable(np.array(rows) * (1, np.pi / 180, 1, np.pi / 180), convention="standard", **options)


UR5 = published(
    *((0, 90, 0.089159, 0), (-0.425, 0, 0, 0), (-0.39225, 0, 0, 0)),
    *((0, 90, 0.10915, 0), (0, -90, 0.09465, 0), (0, 0, 0.0823, 0)),
)

ROWS = [[0.31, 0.7, 0.12, 0], [0.23, -1.1, 0.37, 0], [0.17, 0.9, 0, 0.4], [0.29, 0.6, 0.19, 0], [0.11, 0.5, 0.13, 0]]
ARM = DHTable(ROWS, convention="standard", joints="RRPRR")


def with_entries(table, *entries):
    rows = np.array(table.rows)
    for row, column, value in entries:
        rows[row - 1, ("a", "alpha", "d", "theta").index(column)] = value
    return table.changed(rows=rows)


def differ(one, two):
    q = np.random.default_rng(1).uniform(-3, 3, (5, one.n))
    return np.abs(one.fk(q) - two.fk(q)).max() > 1e-6


@pytest.mark.parametrize("table", [STANDARD, STANDARD.converted("modified")])
def test_a_right_table_is_right(table):
    found = diagnose(table, PUMA)
    assert (found.verdict, found.corrected, [*found.faults]) == ("right", table, [])
    assert str(found) == "This table describes the arm."
    assert diagnose(table.rows, kl.to_urdf(PUMA), convention=table.convention).verdict == "right"


def test_up_to_choices_the_difference_for_the_same_q_is_told_first_and_then_both_readings():
    assert str(diagnose(with_entries(UR5, (2, "a", 0.425)), UR5)).splitlines() == [
        "For the same q, the poses of the table and of the arm differ by up to 0.85 m and 0°, at 1000 random configurations.",
        "The table describes the arm, up to these choices:",
        "joint 2: add 180° to theta.",
        "joint 3: add 180° to theta.",
        "If q is meant to be the same: Row 2: a has the wrong sign.",
        'To count these as mistakes, pass fixed=["zeros"].',
    ]


def test_with_fixed_choices_these_are_the_corrections_with_their_numbers():
    moved = with_entries(UR5, (2, "theta", 0.5), (3, "theta", -0.25)).changed(
        tool=kl.exp([0, 0, 0, 0, 0, 0.1]), signs=[-1, 1, 1, 1, 1, 1]
    )
    found = diagnose(UR5, moved, CHOICES)
    assert not differ(found.corrected, moved)
    assert [fault.text for fault in found.faults] == [
        "joint 1: write -q in theta, because q counts in the opposite direction.",
        "joint 2: add 28.6479° to theta.",
        "joint 3: add -14.3239° to theta.",
        "The tool transform is missing: it should be translated by (0, 0, 0.1) m.",
    ]
    assert "choices that are fixed here" in str(found)


@pytest.mark.parametrize("right", [UR5, ARM, STANDARD.converted("modified")], ids=["UR5", "RRPRR", "PUMA"])
def test_slips_are_mended(right):
    """One in twelve of the slips in every place of a table: as a rule the numbers come back, and always the poses."""
    wrong = []
    for slip, places in slips_in_places(len(right.rows)):
        with suppress(ValueError):  # no table has an angle of many turns
            wrong.append(right.changed(rows=changed_in(places, slip.change)(right.rows)))
    wrong = [table for table in wrong if differ(table, right)][::12]
    found = [diagnose(table, right, CHOICES) for table in wrong]
    mended = [any(not differ(each.corrected, right) for each in one.explanations) for one in found]
    restored = [any(np.abs(e.corrected.rows - right.rows).max() < 1e-9 for e in one.explanations) for one in found]
    assert all(mended)
    assert sum(restored) >= 0.85 * len(wrong)


@pytest.mark.parametrize(
    ("wrong", "text"),
    [
        (with_entries(ARM, (2, "alpha", 1.1)), "Row 2: alpha has the wrong sign."),
        (with_entries(ARM, (1, "a", 0.12), (1, "d", 0.31)), "Row 1: a and d are swapped."),
        (with_entries(ARM, (2, "a", 0.3)), "Row 2: a should be 0.23; the table has 0.3."),
        (ARM.changed(joints="RRRRR"), "Row 3: the joint variable belongs in d, because this joint is prismatic."),
        (ARM.changed(convention="modified"), "The table is in the standard convention, but was read as modified."),
        (ARM.changed(rows=ARM.rows * (1000, 1, 1000, 1)), "The lengths are in millimetres, but were read as metres."),
    ],
)
def test_a_mistake_is_told_with_its_place(wrong, text):
    found = diagnose(wrong, ARM, in_pairs=False)
    assert any(fault.text.startswith(text) for each in found.explanations for fault in each.faults)
    assert equivalent(found.corrected, ARM)


def test_two_mistakes_together_are_both_named():
    found = diagnose(with_entries(UR5, (2, "a", -0.43), (4, "d", 0.1)), UR5, CHOICES)
    assert str(found).splitlines() == [
        "The table agrees with the arm after these changes:",
        "Row 2: a should be -0.425; the table has -0.43.",
        "Row 4: d should be 0.10915; the table has 0.1.",
    ]


def test_what_nothing_explains_is_told_row_by_row_the_largest_difference_first():
    ur5e = published(
        *((0, 90, 0.1625, 0), (-0.425, 0, 0, 0), (-0.3922, 0, 0, 0)),
        *((0, 90, 0.1333, 0), (0, -90, 0.0997, 0), (0, 0, 0.0996, 0)),
    )
    found = diagnose(ur5e, UR5, CHOICES)
    lines = str(found).splitlines()
    assert lines[0].startswith("No known mistake was found that explains this table.")
    assert [line.partition(";")[0] for line in lines[2:]] == [
        "Row 1: d should be 0.089159",
        "Row 4: d should be 0.10915",
        "Row 6: d should be 0.0823",
        "Row 5: d should be 0.09465",
    ]
    np.testing.assert_allclose(found.corrected.fk(np.ones(6)), UR5.fk(np.ones(6)), atol=1e-4)


def test_what_cannot_be_compared_is_refused():
    for arguments, words in [
        ((STANDARD, kl.robots.youbot()), r"The table must have the joints of the arm, RRRRR; it has RRRRRR"),
        ((PUMA, STANDARD), "table must be a DHTable"),
        ((STANDARD, STANDARD.rows), "reference must be a Ch"),
    ]:
        with pytest.raises(ValueError, match=words):
            diagnose(*arguments)
    helical = kl.Chain([kl.screw((0, 0, 1), (0, 0, 0), 0.1), kl.screw((0, 1, 0), (1, 0, 0))], np.eye(4))
    found = diagnose(DHTable([[1, 0.5, 0, 0], [0.3, 0.2, 0.1, 0]], convention="standard"), helical)
    assert found.difference == "The joint types differ: RR in the table, HR in the arm."


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_no_assigned_table_is_accused_at_any_angle_and_with_any_number_of_digits(convention):
    rng = np.random.default_rng(29)
    for angle in np.concatenate([[0.0], np.logspace(-14, -2, 9)]):
        cases = {"cases": ()} if rng.random() < 0.5 else {}
        chain = arm(rng, int(rng.integers(2, 8)), angle=angle, slides=rng.choice([0, 0.25]), **cases)[0]
        table = assign_frames(chain, convention=convention).table
        assert equivalent(table, chain).verdict != "different", angle
        for decimals, fixed in ((rng.integers(0, 13), ()), (16, CHOICES)):
            found = diagnose(table.changed(rows=table.rows.round(decimals)), chain, fixed)
            assert found.verdict != "wrong", (angle, decimals, str(found))


@given(st.integers(0, 2**32 - 1), st.integers(1, 6))
def test_rounding_changes_poses_by_no_more_than_its_bound(seed, decimals):
    rng = np.random.default_rng(seed)
    exact = assign_frames(arm(rng, int(rng.integers(1, 8)))[0], convention="standard").table
    table = exact.changed(rows=exact.rows.round(decimals))
    half, _ = typed_half_units(table.rows)
    assert (np.abs(table.rows - exact.rows) <= half * (1 + 1e-9)).all()
    q = rng.uniform(-np.pi, np.pi, (20, exact.n))
    assert np.abs(table.fk(q) - exact.fk(q)).max() <= rounding_effect(table, half) + 1e-12


TYPED_PI = np.where(np.abs(UR5.rows * (0, 1, 0, 1)) > 0, np.sign(UR5.rows) * 1.5708, UR5.rows)


def test_rounded_numbers_are_right_to_their_digits_and_a_mistake_is_found_through_them():
    assert diagnose(UR5.changed(rows=TYPED_PI), UR5, CHOICES).verdict == "rounded"
    assert diagnose(UR5, UR5.changed(rows=TYPED_PI).to_chain(), CHOICES).verdict == "rounded"
    four = UR5.changed(rows=UR5.rows.round(4))
    assert str(diagnose(four, UR5)).startswith(
        "This table describes the arm to the digits that are printed (lengths to 0.0001 m); their poses differ by"
    )
    assert "Row 5: d should be 0.09465; the table has 0.098." in str(diagnose(with_entries(four, (5, "d", 0.098)), UR5))
    three = UR5.changed(rows=np.where(np.arange(4) % 2, UR5.rows, UR5.rows.round(3)))
    found = diagnose(with_entries(three, (4, "d", 0.112)), three, CHOICES)  # less than all rounding together
    assert str(found) == "Row 4: d should be 0.109; the table has 0.112."
    noise = np.random.default_rng(0).normal(size=(6, 4)) * 2e-5
    found = diagnose(with_entries(UR5, (5, "d", 0.11465)), UR5.changed(rows=UR5.rows + noise), CHOICES)
    assert (found.faults[0].row, found.faults[0].column) == (5, "d")


@pytest.mark.parametrize(("printed", "true"), [((1, 2), (1, 3)), ((0.3, 0.2), (0.3, 0.3)), ((0.4, 0.2), (0.5, 0.2))])
def test_few_digits_are_no_excuse_for_a_number_that_does_not_round_to_them(printed, true):
    """The sum of all rounding would allow these differences; no number within half of its last digit does."""
    table, arm = (published(*((length, 0, 0, 0) for length in lengths)) for lengths in (printed, true))
    assert [fault.name for fault in diagnose(table, arm, fixed=CHOICES).faults] == ["wrong number"]


def test_pi_with_three_digits_is_a_right_angle_and_no_mistake():
    base = np.diag([1.0, -1, -1, 1])
    typed = UR5.changed(rows=np.round(UR5.rows * 100) / 100 * [0, 1, 0, 1] + UR5.rows * [1, 0, 1, 0])
    up_to_its_base = diagnose(typed, UR5.changed(base=base), fixed=CHOICES)
    assert "The base T_s0 is missing: it should be rotated by 180° about x." in str(up_to_its_base).splitlines()
    assert str(up_to_its_base).endswith("were taken as multiples of 45 degrees.")
    wrong = diagnose(with_entries(typed, (5, "alpha", 1.57)), UR5, fixed=CHOICES)
    assert [fault.text for fault in wrong.faults] == ["Row 5: alpha has the wrong sign."]
    np.testing.assert_allclose(wrong.corrected.rows, UR5.rows, atol=1e-12)


def test_lengths_that_were_converted_from_millimetres_keep_their_digits():
    assert "lengths to 0.0001 m" in typed_half_units(np.array([[251.5, 0, 40.3, 0]]) * 1e-3)[1]


@pytest.mark.parametrize("reversed_joints", [(), (0, 3, 5), (1, 2), (0, 1, 2, 3, 4, 5)])
def test_millimetres_are_only_rounded_whatever_the_signs_and_zeros(reversed_joints):
    rows = np.where(np.arange(4) % 2, UR5.rows, UR5.rows.round(3)) + np.outer([0, 1, -1, 0, 1, 0], [0, 0, 0, np.pi / 2])
    table = UR5.changed(rows=rows, signs=np.where(np.isin(np.arange(6), reversed_joints), -1, 1))
    assert diagnose(table, UR5.changed(base=kl.exp([0, 0, 1.0, 0.2, 0, 0]))).verdict == "rounded"


def test_noise_of_the_arm_is_no_second_mistake():
    right = UR5.changed(rows=np.where(np.arange(4) % 2, UR5.rows, UR5.rows.round(4)))
    found = diagnose(right.changed(rows=right.rows[:, [2, 1, 0, 3]]), with_entries(right, (3, "a", -0.392208)), CHOICES)
    assert [fault.name for fault in found.faults] == ["a and d swapped"]


def test_the_table_of_another_robot_is_not_called_rounded():
    other = DHTable([[0.2, 0.4, 0.3, 0], [0.7, 0, 0.1, 0], [0.1, 0.6, 0.1, 0], [0.1, 1, 0.5, 0], [0.01, 2, 0.3, 0], [0.2, 0.5, 0.1, 0]],
                    convention="standard")  # fmt: skip
    assert str(diagnose(other, UR5)).startswith("No known mistake was found that explains this table.")


def test_a_length_that_no_fit_resolves_is_no_error():
    """The common normals of nearly parallel axes have such lengths, and others are mistyped."""
    first, second = kl.screw([0, 0, 1], [0, 0, 0]), kl.screw([0, 1, 0], [0.7, 0.1, 0.5])
    between = kl.screw([1e-10, 0, 1], [0.4, 0.3, 0.2])
    arm = kl.Chain(np.array([first, between, second]), np.eye(4))
    table = assign_frames(arm, convention="standard").table
    assert np.abs(table.rows).max() > 1e9
    assert diagnose(with_entries(table, (3, "a", 0.5)), arm).verdict == "undecided"
    for other in ((), ((1, "a", 0.3), (4, "alpha", 0.7))):
        assert diagnose(with_entries(STANDARD, (2, "d", 4e9), *other), PUMA, fixed=CHOICES).verdict == "wrong"
