"""Input validation: what is refused, and the message: what must hold, what was given, and the likely cause."""

import modern_robotics as mr
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from strategies import poses

import kinlib as kl
from kinlib.arrays import validation

C, S = np.cos(0.7).round(4), np.sin(0.7).round(4)
PRINTED_AXIS = np.array([0.577350269] * 3).round(6)
NO_NUMBERS = r"x must be an array of real numbers; got \w+ .*Does it contain None, a symbol, a str"
REFUSED = [
    *(
        (validation.vectors, x, NO_NUMBERS)
        for x in (["1", "2", "3"], None, [1j, 0, 0], [sympy.Symbol("q1"), 0, 0], [10**400, 0, 0])
    ),
    *(
        (validation.array, [[0, 1], [bad, 3]], r"x contains NaN or infinity at index \[1, 0\]\. Was there a div")
        for bad in (np.nan, -np.inf)
    ),
    (validation.vectors, np.zeros((3, 5)), r"got \(3, 5\)\. Components go in the last dimension: try x\.T"),
    *(
        (validation.vectors, x, r"must have shape \(\.\.\., 3\); got .* One vector has 3 components")
        for x in (0.0, [], np.zeros((5, 4)))
    ),
    (
        validation.unit_vectors,
        [[0, 0, 1], [1, 1, 0]],
        r"x must be a unit vector; its length is 1\.414213562\. Divide it",
    ),
    (validation.unit_vectors, [0, 0, 0], r"its length is 0\. The zero vector has no direction"),
    (validation.unit_vectors, PRINTED_AXIS, r"its length is 0\.99999953"),
    *(
        (validation.rotations_or_poses, x, message)
        for x, message in (
            (np.zeros((3, 4)), r"x must be a rotation \(\.\.\., 3, 3\) or a pose .*; got shape"),
            (kl.inverse(kl.exp([0, 0, 0, 1, 2, 3])).T, r"x is not a pose.*0 0 0 1; got \[-1\. -2\. -3\."),
            (
                [[C, -S, 0], [S, C, 0], [0, 0, 1]],
                r"R\^T R differs from the identity by \d\.?\d?e-05\. Were its entries",
            ),
            (np.eye(3)[:, [1, 0, 2]], r"reflection \(det R = -1\).*Are two axes swapped"),
            (np.stack([np.eye(3), 1.1 * np.eye(3)]), r"x is not rigid at index \[1\]: .* by 0\.21\."),
        )
    ),
]


@pytest.mark.parametrize(("read", "x", "message"), REFUSED)
def test_what_is_no_array_no_vector_no_direction_and_not_rigid_is_refused_with_the_reason(read, x, message):
    with pytest.raises(ValueError, match=message):
        read(x, "x", *([3] if read is validation.vectors else []))


NOISE = st.one_of(st.floats(0, 1e-8), st.floats(1e-2, 1.0))
"""Noise on which two libraries agree, whatever their tolerances: rounding errors, or a hundredth and more."""


@given(poses(), NOISE, st.integers(0, 99))
def test_a_matrix_is_accepted_if_and_only_if_modern_robotics_accepts_it(T, size, seed):
    X = T.copy()
    X[:3, :3] += size * np.random.default_rng(seed).choice([-1, 1], (3, 3))
    for read, Y, is_rigid in (
        (validation.rotations_or_poses, X[:3, :3], mr.TestIfSO3),
        (validation.poses, X, mr.TestIfSE3),
    ):
        if is_rigid(Y):
            np.testing.assert_array_equal(read(Y, "X"), Y)
        else:
            with pytest.raises(ValueError, match=r"not rigid|reflection"):
                read(Y, "X")
