"""exp and log: against 40 digits, against libraries we did not write, and against the axioms that make them what they are."""

import itertools

import modern_robotics as mr
import mpmath_oracle
import numpy as np
import pytest
import pytransform3d.transformations as pt
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from strategies import directions, points, poses, rotation_vectors, rotations, twists

from kinlib import adjoint, exp, hat, inverse, log, vee
from kinlib.rigid.lie import homogeneous, perpendicular

EXACT = 1e-13
"""The promise of the library. Entries are of size 1 to 4, so this is some hundred roundings; the worst seen is ten."""

SMALL = [0.0] + [10.0**-k for k in range(12, 0, -1)]
NEAR_PI = [np.pi - 10.0**-k for k in (*range(1, 13), 15)]
ANGLES = [*SMALL, 1.0, 2.0, *NEAR_PI, np.pi]

_rng = np.random.default_rng(4)
DIRECTIONS = np.concatenate(
    [
        np.eye(3),
        -np.eye(3),
        # Rounded to unit length, so that two components tie or vanish: where an argmax could waver.
        np.array([(1, 1, 0), (1, -1, 0), (0, 1, 1), (-1, 0, 1), (1, 1, 1), (-1, -1, -1), (1, 1e-9, 0), (1e-9, -1, 1)]),
        _rng.normal(size=(10, 3)),
    ]
)
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=-1, keepdims=True)


def twists_of_angle(angle):
    """One twist a direction, with a v of size about 1 that is neither along omega nor square to it."""
    v = np.random.default_rng(5).normal(size=DIRECTIONS.shape)
    return np.concatenate([angle * DIRECTIONS, v / np.linalg.norm(v, axis=-1, keepdims=True)], axis=-1)


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


# --- against 40 digits ---


@pytest.mark.oracle("mpmath", exp, log)
@pytest.mark.parametrize("angle", ANGLES)
def test_exp_and_log_are_right_to_1e_13_at_every_angle(angle):
    x = twists_of_angle(angle)
    T = np.array([mpmath_oracle.exp(row) for row in x])
    close(exp(x), T)
    close(exp(x[:, :3]), T[:, :3, :3])
    if angle < np.pi:
        close(log(T), x)
        close(log(T[:, :3, :3]), x[:, :3])
    else:
        # Half a turn: omega and -omega both lead there, each with its own v.
        for back, pose in zip(log(T), T, strict=True):
            close(mpmath_oracle.exp(back), pose)
        omega = log(T[:, :3, :3])
        close(np.minimum(np.abs(omega - x[:, :3]).max(-1), np.abs(omega + x[:, :3]).max(-1)), 0)


@pytest.mark.parametrize("angle", [3.2, 2 * np.pi - 1e-9, 2 * np.pi, 2 * np.pi + 1e-9, 10.0, 50.0, 100.0])
def test_exp_is_right_to_1e_13_beyond_half_a_turn(angle):
    x = twists_of_angle(angle)
    close(exp(x), [mpmath_oracle.exp(row) for row in x])


@pytest.mark.parametrize("size", [5e-324, 1e-310, 1e-200, 1e-160, 2.0**-511, 2.0**-510, 1e-154, 1e-100, 1e-16, 1e-9])
def test_tiny_turns_are_neither_lost_nor_nan(size):
    """Where theta^2 underflows, exp still knows omega, and log returns it to the last digit that a denormal has."""
    x = np.concatenate([size * DIRECTIONS, np.ones_like(DIRECTIONS)], axis=-1)
    close(exp(x), np.eye(4) + hat(x), atol=4e-16 + 2 * size)
    np.testing.assert_allclose(log(exp(x))[:, :3], x[:, :3], rtol=1e-15, atol=1e-323)


@pytest.mark.parametrize("size", [5e-324, 1e-200, 1e-100, 1e-16])
def test_tiny_twists_come_back_from_log_of_exp(size):
    x = size * np.array([1.0, -2.0, 3.0, 2.0, 1.0, -1.0])
    np.testing.assert_allclose(log(exp(x)), x, rtol=1e-15, atol=1e-323)


def test_log_of_an_exact_half_turn_has_angle_pi_and_the_positive_axis():
    """R = 2 a a^T - I in exact arithmetic, for axes whose matrix is exact in doubles."""
    for axis in [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.8, 0), (0, -0.6, 0.8), (-2 / 3, 2 / 3, 1 / 3), (-1, 0, 0)]:
        a = np.array(axis, dtype=float)
        omega = log(2 * np.outer(a, a) - np.eye(3))
        close(np.linalg.norm(omega), np.pi, atol=1e-15)
        assert omega[np.argmax(np.abs(omega))] > 0
        close(np.abs(omega @ a), np.pi)


@pytest.mark.parametrize(("first", "second"), [(0, 1), (0, 2), (1, 2)])
def test_of_two_largest_components_of_an_exact_half_turn_the_first_is_positive(first, second):
    R = -np.eye(3)
    R[[first, second], [first, second]], R[[first, second], [second, first]] = 0, -1
    omega = np.zeros(3)
    omega[first], omega[second] = np.pi / np.sqrt(2), -np.pi / np.sqrt(2)
    close(log(R), omega, atol=1e-15)


def test_log_of_a_half_turn_about_z_is_pi_along_z():
    assert log(np.diag([-1.0, -1.0, 1.0])).tolist() == [0, 0, np.pi]


def test_log_of_the_identity_is_zero_exactly():
    assert log(np.eye(4)).tolist() == [0] * 6


def test_a_pure_translation_is_its_own_log_exactly():
    assert log(exp([0, 0, 0, 1, -2, 3])).tolist() == [0, 0, 0, 1, -2, 3]


# --- against libraries that we did not write ---


@pytest.mark.oracle("scipy", exp)
@given(rotation_vectors())
def test_exp_agrees_with_scipy(omega):
    close(exp(omega), Rotation.from_rotvec(omega).as_matrix())


@pytest.mark.oracle("scipy", log)
@given(rotation_vectors(largest=3.0))
def test_log_agrees_with_scipy(omega):
    """Up to 3 rad: closer to pi the two may choose opposite axes, and the 40-digit test above decides."""
    R = Rotation.from_rotvec(omega).as_matrix()
    close(log(R), Rotation.from_matrix(R).as_rotvec())


@pytest.mark.oracle("modern_robotics", hat, vee)
@given(twists())
def test_hat_and_vee_agree_with_modern_robotics(x):
    close(hat(x), mr.VecTose3(x), atol=0)
    close(hat(x[:3]), mr.VecToso3(x[:3]), atol=0)
    close(vee(hat(x)), mr.se3ToVec(mr.VecTose3(x)), atol=0)


@pytest.mark.oracle("modern_robotics", inverse, adjoint)
@given(poses())
def test_inverse_and_adjoint_agree_with_modern_robotics(T):
    close(inverse(T), mr.TransInv(T))
    close(adjoint(T), mr.Adjoint(T))


@pytest.mark.oracle("modern_robotics", exp, log)
@pytest.mark.parametrize("angle", [0.01, 0.5, 1.0, 2.0, 3.0])
def test_exp_and_log_agree_with_modern_robotics_between_0_and_pi(angle):
    """Its formulas divide by theta, theta^2 and sin(theta): at 0.01 rad it has lost four digits of sixteen, hence 1e-11."""
    for x in twists_of_angle(angle):
        T = exp(x)
        close(T, mr.MatrixExp6(mr.VecTose3(x)), atol=1e-11)
        close(log(T), mr.se3ToVec(mr.MatrixLog6(T)), atol=1e-11)


@pytest.mark.oracle("pinocchio", exp, log)
def test_exp_and_log_agree_with_pinocchio():
    """Pinocchio stacks (v, omega)."""
    pin = pytest.importorskip("pinocchio", reason="no pinocchio here (the wheel `pin` does not exist for Windows)")
    for x in np.concatenate([twists_of_angle(angle) for angle in (0.0, 1e-12, 1e-3, 1.0, 3.0)]):
        T = exp(x)
        flipped = np.concatenate([x[3:], x[:3]])
        close(T, pin.exp6(flipped).homogeneous)
        close(T[:3, :3], pin.exp3(x[:3]))
        close(log(T), np.roll(pin.log6(T).vector, 3))
        close(log(T[:3, :3]), pin.log3(T[:3, :3]))


@pytest.mark.oracle("pytransform3d", exp, adjoint)
def test_exp_and_adjoint_agree_with_pytransform3d():
    pt = pytest.importorskip("pytransform3d.transformations")
    for x in np.concatenate([twists_of_angle(angle) for angle in (0.0, 0.5, 1.0, 3.0)]):
        close(exp(x), pt.transform_from_exponential_coordinates(x))
        close(adjoint(exp(x)), pt.adjoint_from_transform(exp(x)))


# --- what makes them what they are ---


@pytest.mark.oracle("numpy", hat)
def test_hat_is_the_cross_product():
    for u, v in itertools.product(DIRECTIONS, repeat=2):
        close(hat(u) @ v, np.cross(u, v), atol=1e-15)


@given(twists())
def test_vee_undoes_hat_to_the_bit(x):
    np.testing.assert_array_equal(vee(hat(x)), x)
    np.testing.assert_array_equal(vee(hat(x[:3])), x[:3])


@given(twists(largest=np.pi - 1e-6))
def test_log_undoes_exp(x):
    close(log(exp(x)), x)
    close(log(exp(x[:3])), x[:3])


@given(poses())
def test_exp_undoes_log(T):
    close(exp(log(T)), T)
    close(exp(log(T[:3, :3])), T[:3, :3])


@given(poses())
def test_the_angle_of_a_log_lies_between_0_and_pi(T):
    assert np.linalg.norm(log(T)[:3]) <= np.pi + 1e-15


@given(twists(largest=100.0))
def test_exp_stays_in_the_group(x):
    T = exp(x)
    close(T[:3, :3].T @ T[:3, :3], np.eye(3))
    close(np.linalg.det(T[:3, :3]), 1)
    assert T[3].tolist() == [0, 0, 0, 1]


@given(poses(), poses(), poses())
def test_poses_form_a_group(A, B, C):
    close((A @ B) @ C, A @ (B @ C))
    close(A @ inverse(A), np.eye(4))
    close(inverse(A) @ A, np.eye(4))
    close(inverse(A @ B), inverse(B) @ inverse(A))
    close(inverse(inverse(A)), A)
    close(exp(log(A @ B)), A @ B)


@given(rotations())
def test_the_inverse_of_a_rotation_is_its_transpose(R):
    np.testing.assert_array_equal(inverse(R), R.T)


@given(twists())
def test_turns_about_one_axis_add_up(x):
    """exp(s x) exp(t x) = exp((s + t) x): the one-parameter subgroup."""
    close(exp(0.3 * x) @ exp(0.7 * x), exp(x))
    close(exp(-x), inverse(exp(x)))


def test_exp_starts_at_the_identity_with_velocity_x():
    x = np.array([0.3, -0.2, 0.5, 1.0, 2.0, -1.0])
    assert exp(0 * x).tolist() == np.eye(4).tolist()
    h = 1e-5
    close((exp(h * x) - exp(-h * x)) / (2 * h), hat(x), atol=1e-9)  # h^2 |x|^3 / 6


@given(poses(), poses())
def test_adjoint_is_a_homomorphism(A, B):
    close(adjoint(A @ B), adjoint(A) @ adjoint(B))
    close(adjoint(inverse(A)) @ adjoint(A), np.eye(6))
    np.testing.assert_array_equal(adjoint(A[:3, :3]), A[:3, :3])


@given(poses(), twists())
def test_adjoint_carries_twists_as_conjugation_carries_their_matrices(T, x):
    close(hat(adjoint(T) @ x), T @ hat(x) @ inverse(T))
    close(exp(adjoint(T) @ x), T @ exp(x) @ inverse(T))


@pytest.mark.parametrize("shape", [(), (0,), (1,), (5,), (2, 3), (2, 0, 3), (2, 1, 2), (20,), (20, 20)])
@pytest.mark.parametrize("size", [3, 6])
def test_a_batch_is_its_elements_one_at_a_time(shape, size):
    """The hard angles are side by side in one batch, so that no element affects another."""
    hard = np.concatenate([twists_of_angle(angle) for angle in (np.pi, 0.0, 1e-12, 1.0, 3.1, 1e-200)])
    x = np.resize(np.random.default_rng(0).permutation(hard), (*shape, 6))[..., :size]
    X = exp(x)
    for f, argument, example in [
        (hat, x, hard[0, :size]),
        (exp, x, hard[0, :size]),
        (vee, hat(x), np.zeros((size // 3 + 2,) * 2)),
        *((f, X, np.eye(size // 3 + 2)) for f in (log, inverse, adjoint)),
    ]:
        batch = f(argument)
        assert batch.shape == (*shape, *f(example).shape)
        for index in np.ndindex(shape):
            close(batch[index], f(argument[index]), atol=2e-15)


@pytest.mark.parametrize("size", [3, 4])
def test_every_half_turn_in_a_long_batch_has_the_logarithm_that_it_has_alone(size):
    """Rotations by exactly pi about axes with equal and zero components, where a tie decides the sign of the axis."""
    axes = np.array([a for a in itertools.product([-1.0, 0.0, 1.0], repeat=3) if any(a)])
    X = np.tile(np.eye(size), (len(axes), 1, 1))
    X[:, :3, :3] = 2 * axes[:, :, None] * axes[:, None] / (axes**2).sum(axis=1)[:, None, None] - np.eye(3)
    assert len(X) > 20
    np.testing.assert_array_equal(log(X), [log(one) for one in X])


def test_arguments_are_read_and_not_written():
    for f, argument in [
        (exp, np.ones(3)),
        (log, np.eye(4)),
        (inverse, np.eye(3)),
        (adjoint, np.eye(3)),
        (hat, np.ones(6)),
    ]:
        before = argument.copy()
        f(argument)[...] = 7
        np.testing.assert_array_equal(argument, before)


def test_integers_and_lists_are_welcome():
    close(exp([0, 0, 0, 1, 2, 3])[:3, 3], [1, 2, 3], atol=0)
    close(hat(np.array([1, 2, 3], dtype=np.int8)), hat([1.0, 2.0, 3.0]), atol=0)


# --- what is refused ---


@pytest.mark.parametrize("f", [hat, exp])
def test_a_column_of_twists_is_refused_with_the_remedy(f):
    with pytest.raises(ValueError, match=r"\(\.\.\., 3\) or a twist \(\.\.\., 6\); got shape \(6, 2\).*Try x\.T"):
        f(np.zeros((6, 2)))


@pytest.mark.parametrize(("f", "name", "shape"), [(hat, "x", 3), (exp, "x", 6), (vee, "X", (3, 3)), (log, "X", (3, 3))])
def test_what_is_no_number_is_refused_by_its_name(f, name, shape):
    with pytest.raises(ValueError, match=f"^{name} contains NaN or infinity at index"):
        f(np.full(shape, np.nan))


@pytest.mark.parametrize("f", [log, inverse, adjoint])
@pytest.mark.parametrize("size", [3, 4])
def test_what_is_no_motion_is_refused_by_its_name(f, size):
    with pytest.raises(ValueError, match=r"^X is not rigid"):
        f(np.diag([2, 2, 2, 1])[:size, :size])


@pytest.mark.parametrize("f", [hat, exp])
def test_a_column_of_rotation_vectors_is_refused_with_the_remedy(f):
    with pytest.raises(ValueError, match=r"got shape \(3, 5\).*Try x\.T"):
        f(np.zeros((3, 5)))


@pytest.mark.parametrize("f", [hat, exp])
@pytest.mark.parametrize("x", [1.0, [], [1, 2], np.zeros((3, 4))[0], np.zeros((2, 7))])
def test_a_vector_of_another_size_is_refused(f, x):
    with pytest.raises(ValueError, match=r"x must be a rotation vector .* got shape .*six numbers"):
        f(x)


def test_vee_refuses_a_rotation_and_a_pose_and_says_log():
    with pytest.raises(ValueError, match=r"skew-symmetric.*Is X a rotation\? Then take its log first"):
        vee(np.eye(3))
    with pytest.raises(ValueError, match=r"last row of an se\(3\) matrix must be zero.*Is X a pose\? Then take"):
        vee(exp([0, 0, 0, 1, 2, 3]) - np.diag([1, 1, 1, 0]))
    with pytest.raises(ValueError, match=r"\(\.\.\., 3, 3\) or \(\.\.\., 4, 4\); got \(6,\)"):
        vee(np.zeros(6))


@pytest.mark.parametrize("place", [np.s_[0, 1], np.s_[1, 1], np.s_[3, 2], np.s_[3, 3]])
def test_vee_takes_what_single_precision_rounded_and_no_more(place):
    """A sum of two entries, and each of the last row, may stray from 0 by 1e-6."""
    for size, passes in ((0.4e-6, True), (1.5e-6, False)):
        X = hat([0.1, 0.2, 0.3, 1, 2, 3])
        X[place] += size
        if passes:
            close(vee(X), [0.1, 0.2, 0.3, 1, 2, 3], atol=size)
        else:
            with pytest.raises(ValueError, match="Then take its log first"):
                vee(X)


def test_vee_judges_each_matrix_of_a_batch_by_its_own_size():
    """Beside a huge neighbour a wrong matrix stays wrong; beside huge entries a rounding error stays a rounding error."""
    huge = hat([1e9, 0, 0]) + np.diag([0, 0, 1e-7])
    assert vee(huge)[0] == 1e9
    with pytest.raises(ValueError, match="skew"):
        vee([huge, 100 * np.eye(3)])


@pytest.mark.parametrize("size", [2e8, 1e200])
def test_a_turn_without_a_direction_is_refused(size):
    with pytest.raises(ValueError, match=r"rotation angle must be at most 1e\+08 rad.*Did a computation diverge"):
        exp([size, 0, 0])


@pytest.mark.parametrize("f", [log, inverse, adjoint])
def test_what_is_not_a_motion_is_refused(f):
    with pytest.raises(ValueError, match=r"not rigid: R\^T R differs from the identity by 3.*rounded.*unit length"):
        f(2 * np.eye(3))
    with pytest.raises(ValueError, match="reflection"):
        f(np.diag([1, 1, -1, 1]))
    with pytest.raises(ValueError, match=r"^X must be a rotation \(\.\.\., 3, 3\) or a pose .*; got shape \(6,\)"):
        f(np.zeros(6))


@pytest.mark.parametrize("function", [exp, log, inverse, adjoint, hat, vee], ids=lambda function: function.__name__)
@pytest.mark.parametrize("size", [3, 6], ids=["turns", "motions"])
def test_what_comes_back_is_the_callers_own(function, size):
    """Whoever writes to a result must not change what it was made from."""
    x = np.linspace(0.1, 0.6, size)
    given = {exp: x, hat: x, vee: hat(x)}.get(function, exp(x))
    before = given.copy()
    function(given)[...] = 7
    np.testing.assert_array_equal(given, before)


# --- helpers: poses from their parts, and perpendicular directions ---


@pytest.mark.oracle("pytransform3d", homogeneous)
@given(rotations(), points())
def test_a_pose_is_its_rotation_and_its_position(R, p):
    close(homogeneous(R, p), pt.transform_from(R, p), atol=0)


def test_poses_broadcast():
    R, p = np.stack([np.eye(3), exp([0, 0, 1.0])]), np.arange(12.0).reshape(2, 2, 3)
    T = homogeneous(R, p[:, :1])
    assert T.shape == (2, 2, 4, 4)
    close(T[1, 0], homogeneous(R[0], p[1, 0]), atol=0)


@pytest.mark.oracle("axiom: a unit vector of which the scalar product with the axis is 0", perpendicular)
@given(directions(), st.floats(1e-3, 1e3))
def test_a_perpendicular_is_a_unit_vector_at_right_angles_to_the_axis(axis, length):
    x = perpendicular(length * axis)
    close(x @ axis, 0, atol=1e-15)
    close(x @ x, 1, atol=1e-15)
    close(perpendicular(np.stack([axis, -axis]))[0], x)
