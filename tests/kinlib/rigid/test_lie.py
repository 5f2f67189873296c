"""exp, log and their relatives, and screw axes: against 40 digits, against libraries that we did not write, and what is refused."""

import modern_robotics as mr
import mpmath_oracle
import numpy as np
import pytest
import pytransform3d.transformations as pt
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st
from strategies import directions, points, poses, rotations, screws, twists

from kinlib import adjoint, exp, hat, inverse, line, log, nearest_rotation, screw, vee

EXACT = 1e-13
"""The promise of the library. Entries are of size 1 to 4, so this is some hundred roundings; the worst seen is ten."""

SMALL = [0.0] + [10.0**-k for k in (12, 7, 5, 4, 3, 2, 1)]
NEAR_PI = [np.pi - 10.0**-k for k in (1, 3, 6, 9, 12, 15)]
ANGLES = [*SMALL, 1.0, 2.0, *NEAR_PI, np.pi, 3.2, 2 * np.pi, 100.0]

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
    """One twist a direction, with a v of size about 1 that is neither parallel nor perpendicular to omega."""
    v = np.random.default_rng(5).normal(size=DIRECTIONS.shape)
    return np.concatenate([angle * DIRECTIONS, v / np.linalg.norm(v, axis=-1, keepdims=True)], axis=-1)


def close(got, expected, atol=EXACT):
    np.testing.assert_allclose(got, expected, rtol=0, atol=atol)


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
        # Half a turn and more: another twist leads there, too; at half a turn it is that of -omega, with its own v.
        for back, pose in zip(log(T), T, strict=True):
            close(mpmath_oracle.exp(back), pose)
    if angle == np.pi:
        omega = log(T[:, :3, :3])
        close(np.minimum(np.abs(omega - x[:, :3]).max(-1), np.abs(omega + x[:, :3]).max(-1)), 0)


def test_log_of_an_exact_half_turn_has_angle_pi_and_the_positive_axis():
    """R = 2 a a^T - I in exact arithmetic, for axes whose matrix is exact in doubles."""
    for axis in [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.8, 0), (0, -0.6, 0.8), (-2 / 3, 2 / 3, 1 / 3), (-1, 0, 0)]:
        a = np.array(axis, dtype=float)
        omega = log(2 * np.outer(a, a) - np.eye(3))
        close(np.linalg.norm(omega), np.pi, atol=1e-15)
        assert omega[np.argmax(np.abs(omega))] > 0
        close(np.abs(omega @ a), np.pi)


@given(twists())
def test_hat_and_vee_agree_with_modern_robotics(x):
    close(hat(x), mr.VecTose3(x), atol=0)
    close(hat(x[:3]), mr.VecToso3(x[:3]), atol=0)
    close(vee(hat(x)), mr.se3ToVec(mr.VecTose3(x)), atol=0)


@given(poses())
def test_inverse_and_adjoint_agree_with_modern_robotics(T):
    close(inverse(T), mr.TransInv(T))
    close(adjoint(T), mr.Adjoint(T))


@given(points(), directions(), st.floats(-1, 1))
def test_a_screw_agrees_with_modern_robotics(point, axis, pitch):
    close(screw(axis, point, pitch), mr.ScrewToAxis(point, axis, pitch))
    close(screw(axis, point), mr.ScrewToAxis(point, axis, 0))


@given(screws())
def test_a_line_is_the_one_of_pytransform3d(S):
    point, axis, pitch = pt.screw_parameters_from_screw_axis(S)
    for got, expected in zip(line(S), (axis, point, pitch), strict=True):
        close(got, expected)


@pytest.mark.parametrize("shape", [(0,), (1,), (2, 0, 3), (3, 4)])
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


NO_VECTOR = r"x must be a rotation vector .* or a twist \(\.\.\., 6\); got shape "
REFUSED = [
    (np.zeros((6, 2)), rf"{NO_VECTOR}.*Try x\.T", (hat, exp)),
    (np.full(6, np.nan), r"^x contains NaN or infinity at index \[0\]", (hat, exp)),
    (np.zeros(6), r"^X must .*\(\.\.\., 3, 3\) or .*\(\.\.\., 4, 4\); got .*\(6,\)", (vee, log, inverse, adjoint)),
    (
        2 * np.eye(3),
        r"^X is not rigid: R\^T R differs from the identity by 3.*rounded.*unit length",
        (log, inverse, adjoint),
    ),
    (np.diag([1, 1, -1, 1]), "^X is a reflection", (log, inverse, adjoint)),
    (np.diag([1, 1, -1]), "almost a right-handed rotation", (nearest_rotation,)),
    (np.zeros((3, 3)), "differs by 1", (nearest_rotation,)),
    *(
        (X, r"X must be skew-symmetric.*Is X a rotation or a pose\? Then take", (vee,))
        for X in (np.eye(3), np.diag([0, 0, 0, 1]))
    ),
    ([1e200, 0, 0], r"rotation angle must be at most 1e\+08 rad.*Did a computation diverge", (exp,)),
]


@pytest.mark.parametrize(("argument", "message", "functions"), REFUSED)
def test_an_invalid_argument_is_refused_with_the_remedy(argument, message, functions):
    for function in functions:
        with pytest.raises(ValueError, match=message):
            function(argument)


@given(rotations(), st.integers(1, 4))
def test_the_nearest_rotation_is_that_of_the_polar_decomposition(R, digits):
    rounded = np.round(R, digits)
    close(nearest_rotation(rounded), scipy.linalg.polar(rounded)[0])
    inverse(nearest_rotation(rounded))  # it is a rotation now
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rounded, (1, 2, 3)
    close(nearest_rotation(pose)[:3, :3], nearest_rotation(rounded))
    close(nearest_rotation(pose)[:3, 3], (1, 2, 3), 0)
