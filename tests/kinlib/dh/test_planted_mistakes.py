"""How well `kl.diagnose` mends published tables with planted mistakes; evidence/checks/planted_mistakes.py plants all of them."""

from collections import Counter

from planted_mistakes import measure


def test_planted_mistakes_are_mended_and_no_wrong_table_is_called_right_without_a_word():
    tallies, _ = measure(pairs=46, seed=3, every=23)
    for number, tally in tallies.items():
        counts = sum(tally.values(), Counter())
        assert counts["planted"] >= 2 * number
        assert counts["mended"] >= 0.8 * counts["planted"], tally
        assert counts["same poses"] >= 0.9 * counts["planted"], tally
        assert counts["called right"] == counts["unsaid"] == 0
