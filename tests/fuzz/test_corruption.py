"""The helpers of the fuzz targets: corruption changes only what it should, and an unexplained error is a fault."""

import pytest
from assertions import assert_explained
from corruption import LEAVES, change_json, change_text, random_sources
from hypothesis import given
from hypothesis import strategies as st

import kinlib as kl
from kinlib.arrays.validation import array


@pytest.mark.parametrize(
    "fault",
    [
        lambda: {}["q1"],
        lambda: float("q1"),
        lambda: array([["x"]], "\ud800"),
        lambda: array("x", "y" * 2000),
        lambda: kl.load_urdf.no_such_thing,
    ],
    ids=["not a ValueError", "raised elsewhere", "not printable", "too long", "missing attribute"],
)
def test_an_error_that_the_library_did_not_raise_on_purpose_is_a_fault(fault):
    with pytest.raises(Exception) as raised:  # noqa: PT011
        fault()
    with pytest.raises((AssertionError, UnicodeEncodeError)):
        assert_explained(raised.value)


def test_an_error_that_the_library_raises_on_purpose_is_explained():
    with pytest.raises(ValueError, match="at most a full turn") as raised:
        kl.DHTable([[0, 0, 0, 90]], convention="standard")
    assert_explained(raised.value)


@given(st.lists(random_sources(), max_size=3))
def test_no_changes_give_the_same_document_and_changes_never_modify_the_original(changes):
    text, data = "a | alpha", {"array": [1.0, 2.0], "shape": [2]}
    assert isinstance(change_text(text, changes, ["q1"]), str)
    change_json(data, changes, LEAVES)
    assert data == {"array": [1.0, 2.0], "shape": [2]} == change_json(data, [], LEAVES)
    assert change_text(text, []) == text
