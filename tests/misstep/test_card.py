"""Cards with feedback: each tone can be read without colour, and no message can run code on the page."""

import numpy as np
import pytest

from misstep.display.card import TONES, Card


@pytest.mark.parametrize("tone", TONES)
def test_a_card_says_its_tone_without_colour(tone):
    card = Card(tone, "A title", ["A line."])
    assert TONES[tone][0] in card.html()
    assert TONES[tone][0] in card.text()
    assert 'role="status"' in card.html()


@pytest.mark.parametrize("tone", TONES)
def test_a_title_contrasts_with_its_background(tone):
    """Contrast by WCAG 2: at least 4.5."""

    def luminance(colour):
        shares = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
        return np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4) @ (0.2126, 0.7152, 0.0722)

    _, ink, paper = TONES[tone]
    assert (luminance(paper) + 0.05) / (luminance(ink) + 0.05) >= 4.5


def test_a_message_cannot_run_code_on_the_page():
    card = Card("wrong", "<b>", ["<script>alert(1)</script> and `<i>`", ("pre", "</pre><script>")])
    assert "<script>" not in card.html()
    assert "<i>" not in card.html()
    assert "<b>" not in card.html()


def test_code_and_formulas_reach_the_page():
    html = Card("note", "n", ["try `x.T`, for $a < b$"]).html()
    assert ">x.T</code>" in html
    assert "$a &lt; b$" in html


def test_an_unknown_tone_is_refused():
    with pytest.raises(ValueError, match=r"tone must be one of right.*'green'"):
        Card("green", "A title")
