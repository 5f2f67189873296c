"""Numbers, vectors, angles and DH tables as text."""

import numpy as np
from hypothesis import given
from test_dh_table import tables

from kinlib import DHTable
from kinlib.dh.formatting import format_rows, markdown_table


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
