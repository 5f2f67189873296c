"""What is refused at the edge, and what the refusal says: what was expected, what came, what is likely wrong."""

from fractions import Fraction

import modern_robotics as mr
import mpmath
import numpy as np
import pytest
import pytransform3d.rotations as pr
import pytransform3d.transformations as pt
import sympy
from hypothesis import given
from hypothesis import strategies as st
from strategies import directions, poses, rotations

from kinlib.arrays import tolerances, validation
from kinlib.arrays.batching import CHUNK_COLUMNS
from kinlib.rigid.lie import log

TURNED = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])


def pose(R, p=(1, 2, 3)):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


@pytest.mark.parametrize(
    "x",
    [
        "a pose",
        ["1", "2", "3"],
        ["one", 2, 3],
        None,
        [None, 1, 2],
        ...,
        [1j, 0, 0],
        [sympy.Symbol("q1"), 0, 0],
        [sympy.I, 0, 0],
        [[1, 2, 3], [1, 2]],
        {"x": 1},
        [10**400, 0, 0],
        np.array(["2020-01-01"] * 3, dtype="datetime64[D]"),
        print,
    ],
    ids=repr,
)
def test_what_is_no_array_of_numbers_is_refused_by_name(x):
    with pytest.raises(
        ValueError, match=r"point must be an array of real numbers; got \w+ .*Does it contain None, a symbol, a str"
    ):
        validation.vectors(x, "point", 3)


def test_the_cause_of_a_refusal_names_the_kind_of_number():
    with pytest.raises(ValueError, match="array of real numbers") as refusal:
        validation.array([1j], "q")
    assert str(refusal.value.__cause__) == "complex128 is not a real number type"


@pytest.mark.parametrize(
    "read",
    [
        validation.array,
        validation.real_array,
        lambda x, name: validation.vectors(x, name, 3),
        validation.unit_vectors,
        validation.matrices_3x3_or_4x4,
        validation.rotations_or_poses,
        validation.poses,
    ],
)
def test_whoever_reads_what_is_no_array_says_its_name(read):
    with pytest.raises(ValueError, match=r"^elbow must be an array of real numbers; got NoneType None"):
        read(None, "elbow")


def test_a_long_value_is_named_and_not_recited():
    with pytest.raises(ValueError, match="got list") as refusal:
        validation.array(["x" * 10_000] * 1000, "q")
    assert len(str(refusal.value)) < 400


@pytest.mark.parametrize(
    "x", [[1, 2, 3], (1, 2, 3), range(1, 4), np.array([1, 2, 3], dtype=np.uint8), [sympy.Integer(1), Fraction(2), 3.0]]
)
def test_whatever_holds_real_numbers_is_read(x):
    assert validation.array(x, "x").tolist() == [1, 2, 3]


@pytest.mark.oracle("fractions", validation.array, validation.real_array, validation.vectors, validation.read_only_copy)
@given(st.lists(st.tuples(st.integers(), st.integers(1, 10**20)), min_size=3, max_size=3))
def test_a_fraction_is_read_as_the_double_nearest_to_it(pairs):
    fractions = [Fraction(*pair) for pair in pairs]
    expected = [p / q for p, q in pairs]  # Python divides whole numbers to the nearest double
    for read in (validation.array, validation.real_array, lambda x, name: validation.vectors(x, name, 3)):
        assert read(fractions, "x").tolist() == expected
    assert validation.read_only_copy(fractions).tolist() == expected


@pytest.mark.oracle("text: written out in the test", validation.describe)
def test_what_came_is_said_in_a_few_words():
    assert validation.describe(range(3)) == "range range(0, 3)"
    assert validation.describe("q" * 99) == f"str {('q' * 12 + '...' + 'q' * 13)!r}"


def test_a_million_numbers_are_read_where_they_lie():
    """A copy of a long batch costs as much as its poses."""
    x = np.ones((1000, 4, 4))
    assert validation.array(x, "x") is x
    assert validation.rotations_or_poses(np.broadcast_to(np.eye(4), x.shape), "x").shape == x.shape


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_nan_and_infinity_are_refused_with_their_place(bad):
    with pytest.raises(
        ValueError,
        match=r"q contains NaN or infinity at index \[1, 0\]; every entry must be finite\. Was there a division",
    ):
        validation.array([[0, 1], [bad, 3]], "q")
    with pytest.raises(ValueError, match=r"q contains NaN or infinity; every"):
        validation.array(bad, "q")


def test_vectors_in_columns_are_refused_with_the_remedy():
    with pytest.raises(ValueError, match=r"axes must have shape \(\.\.\., 3\); got \(3, 5\)\..*try axes\.T"):
        validation.vectors(np.zeros((3, 5)), "axes", 3)


@pytest.mark.parametrize("x", [0.0, [], [1, 2], np.zeros((5, 4))])
def test_vectors_of_another_size_are_refused(x):
    with pytest.raises(ValueError, match=r"axes must have shape \(\.\.\., 3\); got .* One vector has 3 components"):
        validation.vectors(x, "axes", 3)


def test_an_axis_that_is_not_unit_is_refused_with_its_length():
    with pytest.raises(ValueError, match=r"axis must be a unit vector; its length is 1\.414213562\..*Divide it"):
        validation.unit_vectors([[0, 0, 1], [1, 1, 0]], "axis")
    with pytest.raises(ValueError, match=r"its length is 0\. The zero vector has no direction"):
        validation.unit_vectors([0, 0, 0], "axis")


@pytest.mark.oracle("pytransform3d", validation.unit_vectors)
@given(directions())
def test_a_direction_comes_back_at_the_length_that_pytransform3d_gives_it(u):
    close = np.testing.assert_allclose
    close(validation.unit_vectors(u * (1 + 5e-10), "axis"), pr.norm_vector(u), rtol=0, atol=1e-15)


def test_an_axis_printed_with_nine_digits_passes_and_becomes_unit():
    printed = np.array([0.577350269] * 3)
    assert abs(np.linalg.norm(validation.unit_vectors(printed, "axis")) - 1) < 1e-15
    with pytest.raises(ValueError, match=r"its length is 0\.99999953"):
        validation.unit_vectors(printed.round(6), "axis")


@given(poses(), rotations())
def test_every_pose_and_rotation_passes_unchanged(T, R):
    np.testing.assert_array_equal(validation.rotations_or_poses(T, "X"), T)
    np.testing.assert_array_equal(validation.rotations_or_poses(R, "X"), R)
    np.testing.assert_array_equal(validation.poses([T, T], "X"), [T, T])


NOISE = st.one_of(st.floats(0, 1e-8), st.floats(1e-2, 1.0))
"""Where two libraries agree, whatever their tolerances: rounding, or a hundredth and more."""


@pytest.mark.oracle("modern_robotics", validation.rotations_or_poses, validation.matrices_3x3_or_4x4, validation.poses)
@given(poses(), NOISE, st.integers(0, 99))
def test_what_modern_robotics_calls_rigid_passes_and_nothing_else_does(T, size, seed):
    X = T.copy()
    X[:3, :3] += size * np.random.default_rng(seed).choice([-1, 1], (3, 3))
    for read, Y, is_rigid in (
        (validation.rotations_or_poses, X[:3, :3], mr.TestIfSO3),
        (validation.poses, X, mr.TestIfSE3),
    ):
        if is_rigid(Y):
            np.testing.assert_array_equal(read(Y, "X"), Y)
            np.testing.assert_array_equal(validation.matrices_3x3_or_4x4(Y, "X"), Y)
        else:
            with pytest.raises(ValueError, match=r"not rigid|reflection"):
                read(Y, "X")


@pytest.mark.oracle("pytransform3d", validation.split_into_rigid_chunks)
@given(st.lists(poses(), min_size=1, max_size=4), NOISE, st.integers(0, 99))
def test_pieces_are_rigid_where_pytransform3d_finds_their_matrices_so(batch, size, seed):
    X = np.array(batch)
    X[-1, :3, :3] += size * np.random.default_rng(seed).choice([-1, 1], (3, 3))
    try:
        expected = np.array([pt.check_transform(T) for T in X]).T
    except ValueError:
        with pytest.raises(ValueError, match=r"not rigid|reflection"):
            list(validation.split_into_rigid_chunks(X, (4, 4)))
    else:
        ((_, found),) = validation.split_into_rigid_chunks(X, (4, 4))
        np.testing.assert_array_equal(found, expected)


FAULTS = {
    "NaN in the rotation": (np.s_[1, 2], np.nan, r"X contains NaN or infinity at index \[1, 2, 1, 2\]"),
    "infinity in the translation": (np.s_[0, 3], np.inf, r"X contains NaN or infinity at index \[1, 2, 0, 3\]"),
    "a last row": (np.s_[3, 0], 2e-6, r"X is not a pose at index \[1, 2\]: .*0 0 0 1; got \[2\.e-06 "),
    "a last entry": (np.s_[3, 3], 0.0, r"X is not a pose at index \[1, 2\]: .*0 0 0 1; got \[0\. 0\. 0\. 0\.\]"),
    "no rotation": (np.s_[0, 0], 1.1, r"X is not rigid at index \[1, 2\]: R\^T R differs from the identity by 0\.21\."),
    "a reflection": (np.s_[2, 2], -1.0, r"X is a reflection at index \[1, 2\] \(det R = -1\)"),
}


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("read", [lambda X: validation.rotations_or_poses(X, "X"), log], ids=["rigid", "log"])
def test_the_first_faulty_pose_of_many_is_named_by_its_index(fault, read):
    place, value, said = FAULTS[fault]
    X = np.tile(np.eye(4), (3, CHUNK_COLUMNS, 1, 1))
    X[1, 2][place] = X[2, 9][place] = value
    with pytest.raises(ValueError, match=f"^{said}"):
        read(X)


def test_a_pose_in_single_precision_passes():
    validation.poses(pose(TURNED @ [[0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]]).astype(np.float32), "home")


@pytest.mark.parametrize("x", [0.0, np.eye(2), np.zeros(16), np.zeros((3, 4)), np.zeros((4, 4, 1))])
def test_a_matrix_of_another_shape_is_refused(x):
    with pytest.raises(ValueError, match=r"home must be a rotation \(\.\.\., 3, 3\) or a pose .*; got shape"):
        validation.rotations_or_poses(x, "home")


def test_a_transposed_pose_is_refused_with_the_remedy_and_its_own_row():
    with pytest.raises(ValueError, match=r"home is not a pose.*0 0 0 1; got \[1\. 2\. 3\. 1\.\]\. .*Try the transpose"):
        validation.rotations_or_poses([np.eye(4), pose(TURNED).T], "home")


def test_rounded_entries_are_refused_with_their_defect():
    c, s = np.cos(0.7).round(4), np.sin(0.7).round(4)
    with pytest.raises(ValueError, match=r"R\^T R differs from the identity by \d\.?\d?e-05\. Were its entries"):
        validation.rotations_or_poses([[c, -s, 0], [s, c, 0], [0, 0, 1]], "R")


@pytest.mark.parametrize("R", [np.zeros((3, 3)), 2 * np.eye(3), [[1, 1, 0], [0, 1, 0], [0, 0, 1]]])
def test_what_does_not_keep_lengths_is_refused(R):
    with pytest.raises(ValueError, match=r"home is not rigid: R\^T R differs from the identity by [13]\."):
        validation.rotations_or_poses(R, "home")


@pytest.mark.parametrize(("scale", "defect"), [(100, "1e.04"), (-1e6, "1e.12"), (1e200, "1e.300"), (-1e200, "1e.300")])
def test_how_far_a_block_is_from_rigid_is_told_as_it_is_up_to_1e300(scale, defect):
    with pytest.raises(ValueError, match=rf"R\^T R differs from the identity by {defect}\. "):
        validation.rotations_or_poses(scale * np.eye(3), "R")


@pytest.mark.parametrize("sign", [1, -1])
def test_entries_whose_squares_overflow_are_refused_like_any_other(sign):
    """Their R^T R holds infinity minus infinity, and NaN is not greater than any tolerance."""
    huge = 1e200 * np.array([[1, -sign, 0], [sign, 1, 0], [0, 0, 1]])
    with pytest.raises(ValueError, match="not rigid"):
        validation.rotations_or_poses(huge, "R")


def test_a_reflection_is_refused_by_its_name():
    with pytest.raises(ValueError, match=r"reflection \(det R = -1\).*Are two axes swapped"):
        validation.rotations_or_poses(TURNED[:, [1, 0, 2]], "R")


def test_a_rotation_is_no_pose():
    for R in (np.eye(3), np.tile(np.eye(3), (2, 4, 1, 1))):
        with pytest.raises(ValueError, match=r"home must be a pose \(\.\.\., 4, 4\); got a rotation.*its origin"):
            validation.poses(R, "home")


def test_what_is_frozen_is_a_copy_that_nobody_can_write_to():
    x = np.array([1.0, 2.0])
    copy = validation.read_only_copy(x)
    with pytest.raises(ValueError, match="read-only"):
        copy[0] = 7
    x[:] = 7
    assert copy.tolist() == [1, 2]


def test_one_bad_matrix_spoils_the_batch():
    with pytest.raises(
        ValueError, match=r"R is not rigid at index \[1, 4\]: R\^T R differs from the identity by 0\.21\."
    ):
        validation.rotations_or_poses(np.stack([np.eye(3)] * 9 + [1.1 * np.eye(3)]).reshape(2, 5, 3, 3), "R")


def test_an_empty_batch_passes():
    assert validation.rotations_or_poses(np.zeros((0, 4, 4)), "X").shape == (0, 4, 4)
    assert validation.unit_vectors(np.zeros((0, 3)), "axis").shape == (0, 3)


@pytest.mark.oracle("mpmath", validation.rotation_angles)
def test_at_the_longest_turn_the_last_digit_moves_the_result_by_1e_8():
    longest = validation.rotation_angles(np.array([tolerances.MAX_ROTATION_RAD]))[0]
    beside = np.nextafter(longest, np.inf)
    moved = mpmath.sqrt(2 - 2 * mpmath.cos(mpmath.mpf(float(beside)) - mpmath.mpf(1e8)))
    assert float(moved) == beside - longest == pytest.approx(1.5e-8, rel=0.01)
    assert longest == mpmath.mpf(1e8)


def test_a_turn_of_a_hundred_million_radians_is_refused():
    assert validation.rotation_angles(np.array([1e8])) == 1e8
    with pytest.raises(
        ValueError, match=r"A rotation angle must be at most 1e\+08 rad.*got 2e\+08 rad.*Did a computation diverge"
    ):
        validation.rotation_angles(np.array([1.0, 2e8]))
