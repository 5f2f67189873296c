"""How well `kl.diagnose` mends published tables with planted mistakes: every 23rd in each run, every one each night."""

import pytest
from planted_mistakes import measure


@pytest.mark.parametrize("every", [23, pytest.param(1, marks=pytest.mark.nightly)])
def test_planted_mistakes_are_mended_and_no_wrong_table_is_called_right_without_a_word(every):
    for number, counts in measure(pairs=46 if every > 1 else 30, seed=3, every=every).items():
        assert counts["planted"] >= 2 * number
        assert counts["mended"] >= 0.8 * counts["planted"], counts
        assert counts["same poses"] >= 0.9 * counts["planted"], counts
        assert counts["called right"] == counts["unsaid"] == 0, counts
