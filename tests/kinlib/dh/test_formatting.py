"""Numbers, vectors, angles and DH tables as text."""

import numpy as np
import pytest
from hypothesis import given
from test_dh_table import tables

from kinlib import DHTable
from kinlib.arrays.formatting import format_degrees, format_number, format_vector
from kinlib.arrays.tolerances import TYPED_PI_ERROR
from kinlib.dh.formatting import format_rows, in_latex, markdown_table


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (1e-9, "0"),
        (-1e-17, "0"),
        (2e-9, "2e-09"),
        (-3.14159, "-3.142"),
        (7, "7"),
        (1e6, "1e+06"),
    ],
)
def test_a_number_has_four_digits_and_no_rounding_error(value, text):
    assert format_number(value) == text


def test_digits_and_the_size_of_nothing_can_be_chosen():
    assert format_number(1.23456, 3) == "1.23"
    assert format_number(4e-6, zero=TYPED_PI_ERROR) == "0"
    assert format_number(4e-5, zero=TYPED_PI_ERROR) == "4e-05"


def test_vectors_and_angles_are_made_of_such_numbers():
    assert format_vector([0.5, -1e-17, 3]) == format_vector(np.array([0.5, -0.0, 3])) == "(0.5, 0, 3)"
    assert [format_degrees(angle) for angle in (np.pi / 2, -np.pi / 3, 1e-12)] == ["90°", "-60°", "0"]


def test_a_table_is_written_with_its_variables_signs_and_fixed_rows():
    text = "a | alpha | d | theta\n0.4 | 90° | 0.1 | -q1 - 30°\n0.2 | 0 | 0 | 0\n0 | -90° | 0.5 - q2 | 180°"
    table = DHTable(text, convention="standard")
    expected = [["0.4", "90°", "0.1", "-q1 - 30°"], ["0.2", "0", "0", "0"], ["0", "-90°", "-q2 + 0.5", "180°"]]
    assert format_rows(table) == expected
    assert markdown_table(format_rows(table, length=lambda x: f"{x:.2f}", variable="q_{}".format)[:1]) == (
        "| i | a | alpha | d | theta |\n| --- | --- | --- | --- | --- |\n| 1 | 0.40 | 90° | 0.10 | -q_1 - 30° |"
    )


@given(tables())
def test_a_table_that_is_written_out_can_be_read_again(table):
    rows = format_rows(table, length="{!r}".format, angle="{!r}".format)
    back = DHTable(
        [dict(zip(("a", "alpha", "d", "theta"), row, strict=True)) for row in rows], convention=table.convention
    )
    assert back.joints == table.joints
    np.testing.assert_array_equal(back.signs, table.signs)
    np.testing.assert_allclose(back.rows, table.rows, rtol=1e-15, atol=0)


def test_a_heading_is_written_in_latex():
    assert [in_latex(heading) for heading in ("a_i", "alpha_{i-1}", "theta_i")] == ["a_i", r"\alpha_{i-1}", r"\theta_i"]
