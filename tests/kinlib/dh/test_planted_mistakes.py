"""How well `kl.diagnose` mends published tables with one planted mistake; tests/support/planted_mistakes.py prints all of them."""

from collections import Counter

import pytest
from planted_mistakes import TABLES, measure


@pytest.mark.parametrize("name", TABLES)
def test_planted_mistakes_are_mended_and_no_wrong_table_is_called_right(name):
    tally, slowest, misses = measure(seed=3, names=[name], every=9)
    counts = sum(tally.values(), Counter())
    assert counts["visible"] >= 5
    assert counts["mended"] >= 0.85 * counts["visible"], misses
    assert counts["strictly visible"] > counts["visible"]
    assert counts["wrong called right"] == 0
    assert slowest <= 2
