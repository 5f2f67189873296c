"""Cards with feedback: each tone can be read without colour, and no message can run code on the page."""

import re
from fractions import Fraction

import numpy as np
import pytest
from browser import contrast
from hypothesis import given
from hypothesis import strategies as st

from misstep.display.card import PAPER_SHARE, TITLE_SHARE, TONES, Card, Link
from misstep.display.lecture_address import ENVIRONMENT_VARIABLE, lecture_address
from misstep.display.markdown import markdown_html
from misstep.display.text import points


def test_a_card_says_its_tone_without_colour():
    for tone in TONES:
        card = Card(tone, "A title", ["A line."])
        assert TONES[tone][0] in card.html()
        assert TONES[tone][0] in card.text()
        assert 'role="status"' in card.html()


@pytest.mark.parametrize(("theme_paper", "theme_ink"), [("#ffffff", "#212121"), ("#111111", "#ffffff")])
@pytest.mark.parametrize("tone", TONES)
def test_a_title_contrasts_with_its_background(tone, theme_paper, theme_ink):
    """Contrast by WCAG 2: at least 4.5, in JupyterLab's light and dark themes."""

    def mixed(share, other):
        """The colour that color-mix gives."""
        colours = np.array([[int(one[k : k + 2], 16) for k in (1, 3, 5)] for one in (TONES[tone][1], other)])
        return f"rgb{(np.array([share, 100 - share]) / 100 @ colours).tolist()}"

    assert contrast(mixed(TITLE_SHARE, theme_ink), mixed(PAPER_SHARE, theme_paper)) >= 4.5


def test_a_message_cannot_run_code_on_the_page():
    attack = '<script>alert(1)</script> [a](b"onclick="c)'
    body = [f"{attack}, try `x.T`, for $a < b$", ("pre", f"</pre>{attack}"), ("markdown", attack)]
    html = Card("wrong", "<b>", body).html()
    assert "<script" not in html
    assert '"onclick' not in html
    assert "<b>" not in html
    assert ">x.T</code>" in html
    assert "$a &lt; b$" in html


def test_only_a_link_can_be_followed():
    address = 'https://example.org/lectures/01.html#"a"'
    card = Card(
        "wrong", "t", ["[a](https://b.c) <a href='https://b.c'>", Link("Re-read <this>", address), Link("plain")]
    )
    followed = re.findall(r'<a href="([^"]*)"[^>]*>([^<]*)</a>', card.html())
    assert followed == [("https://example.org/lectures/01.html#&quot;a&quot;", "Re-read &lt;this&gt;")]
    assert card.html().count("<a ") == 1
    assert card.text().splitlines()[2:] == ["  Re-read <this>", "  plain"]


def test_a_lecture_is_found_beside_the_sheet_and_above_it(tmp_path, monkeypatch):
    for folder in ("notebooks", "exercises/01_frames", "deep/er/than/that"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "notebooks" / "01_frames.ipynb").touch()
    (tmp_path / "exercises" / "01_frames" / "01_frames.ipynb").touch()  # a sheet has the name of its lecture
    page = "https://a.b/lectures/01_frames.html#the-inverse"
    found = {
        ".": "notebooks/01_frames.ipynb#The-inverse",
        "notebooks": "../notebooks/01_frames.ipynb#The-inverse",
        "exercises/01_frames": "../../notebooks/01_frames.ipynb#The-inverse",
        "deep/er/than/that": page,
    }
    for folder, address in found.items():
        monkeypatch.chdir(tmp_path / folder)
        assert lecture_address("01_frames#The inverse", "https://a.b/") == address
    assert not lecture_address("01_frames#The inverse")
    monkeypatch.setenv(ENVIRONMENT_VARIABLE, "1")  # where a page of the site runs the code
    assert lecture_address("01_frames#The inverse", "https://a.b/") == "../notebooks/01_frames.ipynb#The-inverse"


@given(st.integers(0, 3), st.integers(1, 12), st.data())
def test_points_are_written_as_a_person_writes_them(whole, below, data):
    above = data.draw(st.integers(0, below - 1))
    text = points(sum([1 / below] * above, start=float(whole)))
    assert sum(map(Fraction, text.split())) == whole + Fraction(above, below)
    assert "." not in text


def test_paragraphs_and_lists():
    text = "One\nline.\n\nTwo:\n- a\n  b\n\n- c\n\n1. d\n2. e\n\nThree."
    assert markdown_html(text) == (
        "<p>One line.</p><p>Two:</p><ul><li>a b</li><li>c</li></ul><ol><li>d</li><li>e</li></ol><p>Three.</p>"
    )


def test_marks_count_only_outside_of_code_and_formulas():
    html = markdown_html("**Both** *of $a_*b*c$* and `*x*`: 2 * 3 < 7.")
    assert html.startswith("<p><strong>Both</strong> <em>of $a_*b*c$</em> and <code")
    assert html.endswith(">*x*</code>: 2 * 3 &lt; 7.</p>")


def test_a_formula_is_kept_on_one_line():
    """The site reads the formulas of a page line by line, and a line of a formula may begin like an item."""
    text = "So\n\n$$a\n\n- b \\\\ c & d \\tag{1}$$\n\nholds."
    assert markdown_html(text) == r"<p>So</p><p>$$a - b \\ c &amp; d \tag{1}$$</p><p>holds.</p>"


def test_a_link_leads_to_a_notebook_or_a_site():
    html = markdown_html("[Lecture $n$](02_exp.ipynb#The-log), [book](https://a.b/?c=1&d)")
    assert '<a href="02_exp.ipynb#The-log" ' in html
    assert ">Lecture $n$</a>" in html
    assert 'href="https://a.b/?c=1&amp;d"' in html
