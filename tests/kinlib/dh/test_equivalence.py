"""One mechanism or two: yes for every legal re-choice, no for every entry that matters, and always with the proof."""

import numpy as np
import pytest
from example_arms import arm, reduced_count, with_other_choices
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib import DHTable, assign_frames, equivalent
from kinlib.chains.joint_maps import _Matcher


@pytest.mark.parametrize("seed", range(8))
def test_every_legal_rechoice_is_the_same_mechanism(seed):
    rng = np.random.default_rng(seed)
    for _ in range(reduced_count(40)):
        chain, cases = arm(rng, int(rng.integers(1, 9)))
        assert equivalent(chain, with_other_choices(rng, chain)), (chain.joint_types, cases)


@pytest.mark.parametrize("seed", range(6))
def test_a_yes_is_always_right(seed):
    """Any entry, changed by any amount: if the answer is yes, the map shows it; if no, the poses differ by more."""
    rng = np.random.default_rng(200 + seed)
    for _ in range(reduced_count(30)):
        chain, _ = arm(rng, int(rng.integers(2, 7)))
        table = assign_frames(chain, convention="modified").table
        rows = table.rows.copy()
        rows[rng.integers(table.n), rng.integers(4)] += 10 ** rng.uniform(-5.9, -1)
        other = table.changed(rows=rows)
        found = equivalent(chain, other)
        assert found.difference <= 1e-8 if found else found.difference > 1e-8


@pytest.mark.parametrize("column", range(4))
@pytest.mark.parametrize("delta", [1e-9, 3e-9])
def test_what_differs_by_less_than_the_tolerance_is_the_same(column, delta):
    rows = np.array([[0.3, 0.7, 0.2, 0], [0.25, -1.1, 0.35, 0], [0.4, 0.9, 0.15, 0], [0.2, 0.5, 0.3, 0]])
    table = DHTable(rows, convention="standard")
    rows[1, column] += delta
    assert equivalent(table, table.changed(rows=rows))


def test_prismatic_axes_are_free_vectors():
    here = kl.robots.rpr_lecture7()
    points = here.joint_points + np.array([[0, 0, 0], [5, 5, 5], [0, 0, 0]])
    there = kl.Chain(here.screws, here.home, points)
    for convention in ("standard", "modified"):
        tables = [assign_frames(arm, convention=convention).table for arm in (here, there)]
        assert np.abs(tables[0].rows - tables[1].rows).max() > 1
        assert equivalent(*tables)


def test_a_mirrored_arm_is_another_mechanism():
    """A mirror keeps angles and lengths, and turns the hand: no motion of base and tool undoes it."""
    table = DHTable([[0.3, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0], [0.4, 0.9, 0.15, 0]], convention="standard")
    mirrored = table.changed(rows=table.rows * (1, -1, 1, -1))
    found = equivalent(table, mirrored)
    assert not found
    assert found.reason.startswith("Each pair of neighbouring axes agrees, but no rotation of the joints")
    assert 0.01 < found.difference < 10


def test_what_differs_first_is_said():
    right = DHTable([[0.3, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0]], convention="standard")
    angle = DHTable([[0.3, 0.5, 0.2, 0], [0.25, 1.1, 0.35, 0]], convention="standard")
    length = DHTable([[0.5, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0]], convention="standard")
    later = DHTable([[0.3, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0], [0, 0, 0, 0]], convention="standard")
    beyond = DHTable([[0.3, 0.7, 0.2, 0], [0.5, 1.1, 0.35, 0], [0, 0, 0, 0]], convention="standard")
    little = DHTable([[0.3, 0.705, 0.2, 0], [0.25, 1.1, 0.35, 0]], convention="standard")
    for one, other in [(right, angle), (right, length), (later, beyond), (kl.robots.rpr(), kl.robots.rppr())]:
        assert equivalent(one, other).verdict == "different"
    angles = "Axes 1 and 2 make an angle of {} degrees in the first, and of {} degrees in the second."
    distances = "Axes {} and {} are {} m apart in the first, and {} m in the second."
    assert (
        equivalent(right, little).reason == f"{angles.format(40.11, 40.39)} With tolerance=0.005 the two are the same."
    )
    assert equivalent(later, beyond).reason == distances.format(2, 3, 0.25, 0.5)
    assert equivalent(right, angle).reason == angles.format(40.11, 28.65)
    assert equivalent(right, length).reason == distances.format(1, 2, 0.3, 0.5)
    types = "The joint types differ: RPR in the first, RPPR in the second."
    assert equivalent(kl.robots.rpr(), kl.robots.rppr()).reason == types


@pytest.mark.parametrize(
    ("joints", "reason"), [("RRP", "Axes 1 and 2 are 0.3 m"), ("RPR", "Axes 2 and 3 make an angle")]
)
def test_where_a_slide_stands_is_no_difference(joints, reason):
    rows = np.array([[0.3, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0], [0.4, 0.9, 0.15, 0]])
    changed = rows + np.array([[0.2, 0, 0, 0], [0, 0.1, 0, 0], [0, 0, 0, 0]])
    one, other = (DHTable(table, convention="standard", joints=joints) for table in (rows, changed))
    for end in (np.eye(4), kl.exp([0.3, 0, 0, 1, 2, 3])):
        assert equivalent(one, other.changed(base=end)).reason.startswith(reason)


def test_a_base_moved_along_a_first_slide_is_another_zero():
    arm = DHTable([[0, 0.7, 0, 0], [0.25, 1.1, 0.35, 0], [0.4, 0, 0.15, 0]], convention="standard", joints="PRR")
    found = equivalent(arm, arm.changed(base=kl.exp([0, 0, 0, 0, 0, 0.6])))
    np.testing.assert_allclose(found.offsets, [0.6, 0, 0], atol=1e-12)
    np.testing.assert_allclose([found.base, found.tool], [np.eye(4)] * 2, atol=1e-12)


@pytest.mark.parametrize("joints", ["RRR", "RRP"])
def test_a_tool_moved_along_a_last_joint_is_another_zero(joints):
    arm = DHTable([[0.3, 0.7, 0.2, 0], [0.25, 1.1, 0.35, 0], [0, 0, 0, 0]], convention="standard", joints=joints)
    found = equivalent(arm, arm.changed(tool=kl.exp([0, 0, 0.6, 0, 0, 0] if joints == "RRR" else [0, 0, 0, 0, 0, 0.6])))
    np.testing.assert_allclose(found.offsets, [0, 0, 0.6], atol=1e-12)
    np.testing.assert_allclose([found.base, found.tool], [np.eye(4)] * 2, atol=1e-12)


def test_a_joint_that_counts_the_other_way_is_no_arm_turned_over():
    """Turned over at both ends it would move alike as well, and take more words."""
    arm = kl.Chain([kl.screw((0, 0, 1), (0, 0, 0))], kl.exp([0.4, 0, 0, 0.3, 0, 0]))
    found = equivalent(arm, kl.Chain(-arm.screws, arm.home))
    assert (found.signs.tolist(), found.offsets.tolist()) == ([-1], [0])
    np.testing.assert_allclose([found.base, found.tool], [np.eye(4)] * 2, atol=1e-12)


@pytest.mark.parametrize("family", [kl.robots.youbot, kl.robots.puma560])
def test_the_simplest_map_is_given(family):
    """Of a wrist too, which may turn over: q4 + pi, -q5, q6 + pi is another way to say the same."""
    chain = family()
    found = equivalent(chain, chain)
    assert found.signs.tolist() == [1] * chain.n
    np.testing.assert_allclose(found.offsets, 0, atol=1e-12)
    np.testing.assert_allclose([found.base, found.tool], [np.eye(4)] * 2, atol=1e-12)


def test_a_tolerance_that_is_none_is_refused():
    with pytest.raises(ValueError, match="tolerance must be a positive number"):
        equivalent(kl.robots.rpr(), kl.robots.rpr(), tolerance=0)


@pytest.mark.parametrize(("apart", "is_searched"), [(2.0 + 1e-6, True), (8.3, False)])
def test_parallel_axes_that_are_clearly_farther_apart_need_no_search(apart, is_searched, monkeypatch):
    """Fuzzing found tables that took seconds to explain: each mistake was tried in every rotation of five joints."""
    searches = []
    matches = _Matcher.matches
    monkeypatch.setattr(_Matcher, "matches", lambda self: searches.append(self) or matches(self))
    rows = np.array([[0, np.pi / 2, 0, 0], [2.0, 0, 0, 0], [0, np.pi / 2, 0, 0], [0, np.pi / 2, 0.5, 0], [1, 0, 0, 0]])
    other = rows.copy()
    other[1, 0] = apart
    one, two = (DHTable(each, convention="standard", joints="RRRRR") for each in (rows, other))
    assert not equivalent(one, two)
    assert bool(searches) == is_searched


# --- choices that are fixed ---

CHOICES = ("base", "tool", "zeros", "signs")


def with_choices(rng, chain, free):
    """The same arm with other choices of these kinds, and no others."""
    offsets = rng.uniform(-1, 1, chain.n) if "zeros" in free else np.zeros(chain.n)
    signs = rng.choice([-1, 1], chain.n) if "signs" in free else np.ones(chain.n)
    if "signs" in free:
        signs[rng.integers(chain.n)] = -1
    base, tool = (kl.exp(rng.normal(size=6)) if name in free else np.eye(4) for name in ("base", "tool"))
    screws = (kl.adjoint(base) @ chain.jacobian(offsets)).T * signs[:, None]
    return kl.Chain(screws, base @ chain.fk(offsets) @ tool)


@pytest.mark.parametrize(
    "free", [set(), *({name} for name in CHOICES), {"base", "zeros"}, {"tool", "signs"}, {*CHOICES}]
)
@given(seed=st.integers(0, 2**32 - 1), n=st.integers(1, 8), slides=st.sampled_from([0.0, 0.3]))
def test_what_is_fixed_does_not_differ_in_the_map(free, seed, n, slides):
    rng = np.random.default_rng(seed)
    chain, cases = arm(rng, n, slides=slides)
    other, fixed = with_choices(rng, chain, free), {*CHOICES} - free
    found = equivalent(chain, other, fixed=fixed)
    assert found, (chain.joint_types, cases)
    q = rng.uniform(-2, 2, (5, n))
    np.testing.assert_allclose(
        other.fk(q), found.base @ chain.fk(found.signs * q + found.offsets) @ found.tool, atol=2e-8
    )
    for name, T in (("base", found.base), ("tool", found.tool)):
        assert name not in fixed or (np.eye(4) == T).all()
    assert "zeros" not in fixed or not found.offsets.any()
    assert "signs" not in fixed or (found.signs == 1).all()


@pytest.mark.parametrize("name", CHOICES)
@given(seed=st.integers(0, 2**32 - 1), n=st.integers(3, 7))
def test_what_is_fixed_and_differs_is_another_arm(name, seed, n):
    """The axes are skew, so that no other choice makes up for it."""
    rng = np.random.default_rng(seed)
    chain, _ = arm(rng, n, cases=["skew"], slides=0)
    other = with_choices(rng, chain, {name})
    assert equivalent(chain, other)
    assert not equivalent(chain, other, fixed=[name])
    assert equivalent(chain, other, fixed=[kind for kind in CHOICES if kind != name])


@pytest.mark.parametrize("fixed", ["base", ["zero"], [1]])
def test_a_choice_that_there_is_not_is_refused(fixed):
    with pytest.raises(ValueError, match="fixed must be a collection of names from base, tool, zeros, signs; got"):
        equivalent(kl.robots.rpr(), kl.robots.rpr(), fixed=fixed)


@pytest.mark.parametrize("n", [10, 20, 40])
def test_right_angles_at_every_joint_do_not_double_the_work(n, monkeypatch):
    """Both signs of each joint are possible there: trying all of them would take 2^n steps."""
    steps = []
    extended = _Matcher._extended
    monkeypatch.setattr(_Matcher, "_extended", lambda *given: steps.append(given) or extended(*given))
    rows = [[0, (-1) ** k * np.pi / 2, 0.1 * (k % 2) * (k + 1), 0] for k in range(n)]
    chain = DHTable(rows, convention="standard").to_chain()
    other = with_other_choices(np.random.default_rng(n), chain)
    assert equivalent(chain, other)
    assert 0 < len(steps) <= 16 * n
