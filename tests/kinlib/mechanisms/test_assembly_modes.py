"""Assembly modes by the poses of the bodies that matter, how thoroughly they were sought, and those found along curves."""

import re

import numpy as np
import pytest
from scipy.optimize import root
from scipy.spatial.transform import Rotation

from kinlib import Joint, Mechanism, linkages, screw
from kinlib.mechanisms.closure import Closure, ModeSearch
from kinlib.mechanisms.joints import spherical
from kinlib.mechanisms.levenberg_marquardt import solve
from kinlib.mechanisms.mobility import on_planes

LEGS = dict.fromkeys((f"P{i}" for i in range(1, 7)), 0.0)
PRINTED_LENGTHS = [1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071]
"""Of the legs of Dietmaier's platform: Dietmaier (1998)."""
X, Y, Z = np.eye(3)


def feet_and_heads(linkage):
    return (np.array([joint.position for joint in linkage.joints if joint.name[0] == kind]) for kind in "US")


def leg_lengths(linkage, T):
    feet, heads = feet_and_heads(linkage)
    return np.linalg.norm(heads @ np.swapaxes(T[..., :3, :3], -1, -2) + T[..., None, :3, 3] - feet, axis=-1)


def poses_by_scipy(linkage, starts=150):
    """Poses of the plate in which the legs are as long as drawn: MINPACK on a rotation vector and a translation, at random."""
    feet, heads = feet_and_heads(linkage)
    drawn = np.sum((heads - feet) ** 2, axis=1)
    rng = np.random.default_rng(1)
    found = []
    for _ in range(starts):
        rotation = rng.uniform(-np.pi, np.pi, 3)
        end = root(
            lambda x: np.sum((Rotation.from_rotvec(x[:3]).apply(heads) + x[3:] - feet) ** 2, axis=1) - drawn,
            [*rotation, *rng.uniform(-1, 1, 3)],
            tol=1e-13,
        )
        if end.success and np.abs(end.fun).max() < 1e-12:
            pose = np.column_stack([Rotation.from_rotvec(end.x[:3]).as_matrix(), end.x[3:]])
            if all(np.abs(pose - other).max() > 1e-6 for other in found):
                found.append(pose)
    return np.array(found)


@pytest.mark.oracle("scipy", Mechanism.search_modes, Mechanism.assembly_modes, Closure.search_modes)
def test_the_plate_of_a_stewart_gough_platform_has_the_poses_that_scipy_finds():
    linkage = linkages.stewart_gough()
    search = linkage.search_modes(LEGS, bodies=("plate",))
    plate = linkage.poses(search.q)["plate"][:, :3]
    expected = poses_by_scipy(linkage)
    assert len(plate) == len(expected) == 8
    apart = np.abs(plate[:, None] - expected).max(axis=(2, 3))
    assert sorted(apart.argmin(axis=1)) == list(range(8))
    assert apart.min(axis=1).max() < 1e-8
    assert search.hits.min() >= 2
    assert (linkage.residual(search.q) ** 2).sum(axis=1).max() < 1e-24


@pytest.mark.oracle("printed: Dietmaier (1998)", linkages.dietmaier, Mechanism.search_modes)
def test_dietmaier_s_platform_has_40_modes():
    """More than 40 are impossible, and each of those found has legs of the printed lengths, so these are all."""
    linkage = linkages.dietmaier()
    np.testing.assert_allclose(leg_lengths(linkage, np.eye(4)), PRINTED_LENGTHS, atol=1e-14)
    search = linkage.search_modes(LEGS, bodies=("plate",), guesses=64, release="P2")
    plate = linkage.poses(search.q)["plate"]
    np.testing.assert_allclose(leg_lengths(linkage, plate), np.tile(PRINTED_LENGTHS, (40, 1)), atol=1e-12)
    apart = np.abs(plate[:, None] - plate).max(axis=(2, 3)) + 9 * np.eye(40)
    assert apart.min() > 0.1
    assert np.count_nonzero(search.hits) < 40


def rssr(ground, crank, coupler, rocker):
    """A spatial four-bar linkage with perpendicular axes of crank and rocker, and spherical joints at the ends of the coupler."""
    B, C = crank * X, ground + rocker * Y
    return Mechanism(
        [
            Joint("A", ("ground", "crank"), screw(Z)),
            Joint("D", ("ground", "rocker"), screw(X, ground)),
            Joint("B", ("crank", "coupler"), spherical(B)),
            Joint(
                "C",
                ("coupler", "rocker"),
                spherical(B + coupler * X),
                closing_offset=np.block([[np.eye(3), (B + coupler * X - C)[:, None]], [np.zeros((1, 3)), 1]]),
            ),
        ]
    )


@pytest.mark.parametrize("A", [0.3, 2.0])
def test_a_coupler_that_spins_does_not_matter_to_the_rocker(A):
    """|B - C| = coupler is u cos(D) + v sin(D) = w, with two solutions; the coupler spins between its spherical joints."""
    ground, crank, coupler, rocker = np.array([0.5, -1.0, 0.3]), 0.6, 1.5, 0.9
    linkage = rssr(ground, crank, coupler, rocker)
    with pytest.raises(ValueError, match=r"no degree of freedom may be left; 1 left"):
        linkage.assembly_modes(hold={"A": A})
    with pytest.raises(ValueError, match=r"no degree of freedom may be left; 1 left"):
        linkage.assembly_modes(bodies=("rocker",))
    modes = linkage.assembly_modes(hold={"A": A}, bodies=("rocker",))
    b = crank * np.array([np.cos(A), np.sin(A), 0]) - ground
    u, v, w = 2 * rocker * b[1], 2 * rocker * b[2], b @ b + rocker**2 - coupler**2
    D = np.arctan2(v, u) + np.array([-1, 1]) * np.arccos(w / np.hypot(u, v))
    np.testing.assert_allclose(np.sort(np.cos(modes[:, 1])), np.sort(np.cos(D)), atol=1e-9)
    np.testing.assert_allclose(np.sort(np.sin(modes[:, 1])), np.sort(np.sin(D)), atol=1e-9)


@pytest.mark.parametrize(("links", "curves"), [((4, 1, 3.5, 3), 2), ((4, 2, 2.5, 3), 1)])
def test_the_modes_of_a_non_grashof_linkage_are_on_one_curve(links, curves):
    search = linkages.four_bar(*links).search_modes({"A": 1.0}, release="A")
    assert (len(search.q), search.curves) == (2, curves)


# --- equations whose solutions are known ---


def circle_about_1(x):
    return ((x - [1, 0]) ** 2).sum(1, keepdims=True) - 1, 2 * (x - [1, 0])[:, None]


def closure_of(equations, held, search_range):
    """Two unknowns, of which the second one is held."""
    return Closure(
        *(equations, np.array([0.0, held]), np.array([0]), "xy", np.zeros(2, bool)),
        *(np.tile([-np.inf, np.inf], (2, 1)), np.full(2, search_range), 1e-13),
    )


def test_a_mode_that_no_guess_leads_to_is_found_along_the_curve():
    near = closure_of(circle_about_1, 0.5, search_range=0.2)
    (found,) = near.search_modes(poses=lambda q: q).q
    np.testing.assert_allclose(found, [1 - np.sqrt(0.75), 0.5], atol=1e-12)
    search = near.search_modes(poses=lambda q: q, release=1)
    np.testing.assert_allclose(search.q, [found, [1 + np.sqrt(0.75), 0.5]], atol=1e-12)
    assert search.hits[1] == 0 < search.hits[0]
    assert search.curves == 1


@pytest.mark.parametrize("held", [0.999, 1 - 1e-7])
def test_two_modes_within_one_step_of_a_curve_are_both_found(held):
    near = closure_of(circle_about_1, held, search_range=0.99)
    x = np.sqrt(1 - held**2)
    search = near.search_modes(poses=lambda q: q, guesses=64, release=1)
    np.testing.assert_allclose(search.q[:, 0], [1 - x, 1 + x], atol=1e-8)


@pytest.mark.parametrize(("once", "rounds"), [(1, 31), (2, 4)])
def test_the_search_goes_on_while_a_mode_has_been_found_only_once(once, rounds):
    calls = []

    def poses(q):
        """Another body is elsewhere in the first configurations, but not in those that follow."""
        calls.append(len(q))
        return (np.arange(len(q)) < once).astype(float)[:, None] * (len(calls) == 1)

    line = closure_of(lambda x: (x[:, :1] - 0.25, np.tile([[1.0, 0.0]], (len(x), 1, 1))), 0.0, 0.5)
    search = line.search_modes(poses)
    assert len(calls) == rounds
    assert sorted(search.hits) == [once, 64 * rounds - once]
    assert (search.guesses, search.since_new) == (64 * rounds, 64 * (rounds - 1))


@pytest.mark.parametrize(("guesses", "rounds"), [(1, 1), (64, 1), (65, 2), (640, 10)])
def test_as_many_guesses_are_made_as_asked_for(guesses, rounds):
    search = linkages.four_bar(4, 1, 3.5, 3).search_modes({"A": 1.0}, guesses=guesses)
    assert search.guesses == 64 * rounds
    assert search.hits.sum() <= 64 * rounds


@pytest.mark.oracle("text: written out in the test", ModeSearch.__str__)
def test_a_search_describes_itself():
    q = np.zeros((2, 3))
    assert str(ModeSearch(q, np.array([5, 7]), 64, 6)) == (
        "2 assembly modes. 12 of 64 guesses closed, the last 6 of them in modes that were known: "
        "with 95 % confidence at most 50 % of them would lead to missing modes."
    )
    assert str(ModeSearch(q[:1], np.array([2]), 64, 0)) == (
        "1 assembly mode. 2 of 64 guesses closed, the last 0 of them in modes that were known."
    )
    assert str(ModeSearch(q, np.array([5, 0]), 64, 0, curves=3)).endswith(
        "known. 1 of the modes were found only by following 3 curves."
    )
    assert str(ModeSearch(q[:0], np.array([], int), 192, 0)) == (
        "No assembly mode: none of 192 guesses closed within the limits."
    )


@pytest.mark.oracle("axiom: the points of a unit circle", on_planes)
def test_planes_are_added_to_equations():
    above = on_planes(circle_about_1, np.array([1.0, 0.0]), np.array([[1.0], [0.0]]), np.array([0.6]))
    np.testing.assert_allclose(solve(above, np.array([[1.5, 2.0]]), 1e-13).x, [[1.6, 0.8]], atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"bodies": ("plate",)}, "bodies must be names of some of the bodies ground, crank, rocker, coupler; got"),
        ({"bodies": "coupler"}, "got str 'coupler'. Pass a sequence, for example ('coupler',)."),
        ({"bodies": ()}, "bodies must be names of some"),
        ({"guesses": 0}, "guesses must be at least 1; got 0. Try 1000."),
        ({"release": "B"}, "release must be the name of a held value, A; got 'B'."),
    ],
)
def test_invalid_arguments_are_refused(arguments, message):
    with pytest.raises(ValueError, match=re.escape(message)):
        linkages.four_bar(4, 1, 3.5, 3).assembly_modes({"A": 1.0}, **arguments)
