"""The assertion of each numbered formula fails when the formula is changed, and the tool that checks it finds weak assertions."""

from pathlib import Path

import nbformat
import pytest
from check_formulas import Lecture, assert_formulas_are_asserted, check
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


@pytest.mark.parametrize("lecture", ["03_poe_space", "05_dh_standard"])
def test_no_formula_can_be_changed_without_failing_its_assertion(lecture):
    """Every night, evidence/test_all_formulas.py changes those of all lectures, which takes minutes."""
    assert_formulas_are_asserted(NOTEBOOKS / f"{lecture}.ipynb")


def lecture(tmp_path, *cells, formula="$$a = b + c \\tag{1}$$"):
    path = tmp_path / "lecture.ipynb"
    nbformat.write(new_notebook(cells=[new_markdown_cell(formula), *map(new_code_cell, cells)]), path)
    return path


def unnoticed(path):
    return {(change.before, change.after) for change in check(path)[1]}


def test_an_assertion_that_always_holds_states_no_formula(tmp_path):
    assert check(lecture(tmp_path, "assert True  # (1)")) == ({"1": 0}, [])


def test_changes_that_a_weak_assertion_does_not_notice_are_reported(tmp_path):
    assert unnoticed(lecture(tmp_path, "b, c = 2, 3", "a = b + c\nassert a == b + c  # (1)")) == set()
    assert unnoticed(lecture(tmp_path, "b, c = 2, 0", "a = 2\nassert a == b + c  # (1)")) == {("b + c", "b - c")}


def test_a_formula_is_changed_in_functions_and_in_earlier_cells_too(tmp_path):
    path = lecture(
        tmp_path, "import numpy as np", "def f(x):\n    return np.sin(x)", "assert f(0.5) == np.sin(0.5)  # (1)"
    )
    changes = {(change.before, change.after) for change in Lecture(path).changes()}
    assert ("np.sin(x)", "np.cos(x)") in changes
    assert not unnoticed(path)


def test_the_case_in_which_a_formula_is_tried_is_not_changed(tmp_path):
    path = lecture(tmp_path, "p = 3\nq = 2 * p + 1", "assert (q + 1) ** 2 == q**2 + 2 * q + 1  # (1)")
    assert "2 * p" not in {change.before for change in Lecture(path).changes()}
    assert not unnoticed(path)


def test_a_change_that_never_ends_is_noticed(tmp_path, monkeypatch):
    monkeypatch.setattr("check_formulas.TIME_LIMIT_S", 0.2)
    loop = "x = 0\nwhile x < 3 - 1 * one:\n    x = x + one\nassert x == 2  # (1)"
    assert not unnoticed(lecture(tmp_path, "one = 1", loop))
