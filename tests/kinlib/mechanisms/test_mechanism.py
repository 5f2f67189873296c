"""Closed chains: residuals and Jacobians against 40 digits and Pinocchio, one mechanism in many descriptions, what is refused."""

from functools import reduce

import modern_robotics as mr
import mpmath_oracle
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from strategies import points

from kinlib import Mechanism, exp, linkages, screw
from kinlib.mechanisms.joints import Joint, spherical, universal

EXACT = 1e-12
X, Y, Z = np.eye(3)
SLIDE = np.inf


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


def jack(pitch=0.01):
    """A screw jack: a screw rotates in the ground, and a nut that cannot rotate moves along it."""
    return Mechanism(
        [
            Joint("crank", ("ground", "spindle"), screw(Z)),
            Joint("thread", ("spindle", "nut"), screw(Z, pitch=pitch)),
            Joint("rise", ("ground", "nut"), screw(Z, pitch=SLIDE)),
        ],
        name="jack",
    )


LINKAGES = [linkages.four_bar(0.4, 0.1, 0.35, 0.3), linkages.slider_crank(1, 3, 0.2), jack(0.3), linkages.sarrus()]
FOUR_BAR = linkages.four_bar(4, 1, 3.5, 3)
each_linkage = pytest.mark.parametrize("linkage", LINKAGES, ids=lambda linkage: linkage.name)


def open_configurations(linkage, count=3):
    """Random configurations that are far from closed."""
    return np.random.default_rng(6).uniform(-1.2, 1.2, (count, linkage.n))


@each_linkage
def test_the_residual_is_the_logarithm_of_the_pose_around_each_loop(linkage):
    for q in open_configurations(linkage):
        twists = np.split(linkage.residual(q), len(linkage.loops))
        for loop, twist in zip(linkage.loops, twists, strict=True):
            close(mpmath_oracle.exp(twist), mpmath_oracle.fk(loop.chain, q[loop.columns]))


@each_linkage
def test_the_jacobian_is_the_difference_of_residuals_with_40_digits(linkage):
    for q in open_configurations(linkage, 1):
        parts = np.split(linkage.jacobian(q), len(linkage.loops))
        for loop, part in zip(linkage.loops, parts, strict=True):
            others = np.setdiff1d(np.arange(linkage.n), loop.columns)
            close(part[:, loop.columns], mpmath_oracle.residual_jacobian(loop.chain, q[loop.columns]))
            assert not part[:, others].any()


def displacement(joint, q):
    """The displacement of the second body of a joint relative to its first, by the exponentials of Modern Robotics."""
    factors = [mr.MatrixExp6(mr.VecTose3(S * value)) for S, value in zip(joint.screws, q, strict=True)]
    return reduce(np.matmul, [*factors, joint.closing_offset])


@each_linkage
def test_every_joint_of_a_closed_linkage_joins_its_bodies_and_every_loop_closes_by_modern_robotics(linkage):
    linkage = Mechanism(linkage.joints, linkage.ground, linkage.name)  # with nothing cached
    q = linkage.assemble(0.3 * open_configurations(linkage, 1)[0]).q
    values = np.split(q, np.cumsum([joint.dof for joint in linkage.joints])[:-1])
    found = linkage.poses(q)
    assert (
        sorted(found) == sorted(linkage.bodies) == sorted({body for joint in linkage.joints for body in joint.bodies})
    )
    close(found[linkage.ground], np.eye(4))
    for joint, value in zip(linkage.joints, values, strict=True):
        first, second = (found[body] for body in joint.bodies)
        close(second, first @ displacement(joint, value), atol=1e-10)
    assert len(linkage.loops) == len(linkage.joints) - len(linkage.bodies) + 1
    for loop in linkage.loops:
        close(mr.FKinSpace(loop.chain.home, loop.chain.screws.T, q[loop.columns]), np.eye(4), atol=1e-10)


@given(st.tuples(*[st.floats(-3, 3)] * 3), points())
def test_spherical_and_universal_joints_agree_with_scipy_s_angles(angles, centre):
    """Turns about x, y and z, each carried by those before it: intrinsic angles, capital letters to SciPy."""
    for screws, letters in (
        (spherical(centre), "XYZ"),
        (universal(X, Y, centre), "XY"),
        (universal(Z, X, centre), "ZX"),
    ):
        T = reduce(np.matmul, [exp(S * angle) for S, angle in zip(screws, angles, strict=False)])
        close(T[:3, :3], Rotation.from_euler(letters, angles[: len(letters)]).as_matrix())
        close(T @ [*centre, 1], [*centre, 1])


def test_assemble_finds_the_configuration_that_scipy_finds():
    rng = np.random.default_rng(3)
    for linkage, hold in (
        (linkages.four_bar(0.4, 0.1, 0.35, 0.3), {"A": 1.0}),
        (linkages.bennett(), {"joint 1": 1.0}),
        (linkages.five_bar(1, (1, 1), (1, 1)), {"A": 2.0, "D": 1.0}),
    ):
        mode = linkage.assembly_modes(hold=hold)[0]
        free = [i for i, name in enumerate(linkage.names) if name not in hold]
        guess = mode + 0.05 * rng.normal(size=linkage.n) * np.isin(np.arange(linkage.n), free)
        found = linkage.assemble(guess, hold=hold)

        def left(x, linkage=linkage, guess=guess, free=free):
            q = guess.copy()
            q[free] = x
            return linkage.residual(q)

        oracle = least_squares(left, guess[free], xtol=1e-15, ftol=1e-15, gtol=1e-15)
        assert found.converged
        close(found.q[free], oracle.x, atol=1e-9)
        close(found.q, mode, atol=1e-11)


def test_if_links_cannot_meet_there_is_no_assembly_mode():
    assert len(linkages.four_bar(4, 1, 1, 1).assembly_modes(hold={"A": 0.0})) == 0


def bars(*bodies):
    return [Joint(f"J{i}", pair, screw(Z, i * X)) for i, pair in enumerate(bodies)]


def test_invalid_mechanisms_and_arguments_are_refused():
    zero = np.zeros(4)
    for ask, message in [
        (lambda: Mechanism(bars("ab", "bc")), r"must have a loop; the joints of linkage form a tree\. Use kl\.Chain"),
        (lambda: Mechanism(bars("ab", "ab", "cd")), r"must lead from a to every body; not to c, d"),
        (lambda: Mechanism(bars("ab", "ab")[:1] * 2), r"names of the joints must be different; got J0 more than once"),
        (lambda: Joint("J", ("a", "a"), screw(Z)), r"Joint J must join two different bodies; got tuple \('a', 'a'\)"),
        (lambda: FOUR_BAR.assemble(zero, hold={"E": 1}), r"must be one of A, B, D, C; got 'E'"),
        (lambda: FOUR_BAR.assemble(zero, hold=dict.fromkeys("ABCD", 0)), r"must not be held; all are held\."),
        (FOUR_BAR.assembly_modes, r"No degree of freedom may be left; got 1"),
        (lambda: FOUR_BAR.mobility(zero), r"must be closed here; the residual is 2\.5\. Assemble it first"),
    ]:
        with pytest.raises(ValueError, match=message):
            ask()
