"""The formulas of all lectures; tests/evidence/test_formulas.py takes two of the lectures in each run."""

from pathlib import Path

import pytest
from check_formulas import assert_formulas_are_asserted

LECTURES = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)
def test_no_formula_can_be_changed_without_failing_its_assertion(path):
    assert_formulas_are_asserted(path)
