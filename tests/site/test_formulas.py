"""Formulas of the pages: a link leads to its section below many of them, and a formula with an error fails the build."""

import pytest
from browser import watched
from built_site import PHONE
from kinsite import cell_outputs
from kinsite.html_tree import inner_html, read_html

LONGEST_LECTURE = "lectures/06_dh_modified.html"
UPPER_PART_PX = 100  # below the bar of a phone, and the margin of a section


def test_a_link_to_a_section_leads_there(chromium, site_address):
    """Viewers above it change their height when they are drawn; it stays in place until the reader scrolls."""
    with watched(chromium, viewport=PHONE) as page:
        page.goto(f"{site_address}/{LONGEST_LECTURE}")
        section = page.locator("article h2[id]").nth(4).get_attribute("id")
        page.goto("about:blank")
        page.goto(f"{site_address}/{LONGEST_LECTURE}#{section}")
        top = f"document.getElementById('{section}').getBoundingClientRect().top"
        page.wait_for_function(f"{top} > -5 && {top} < {UPPER_PART_PX}")
        page.wait_for_timeout(800)
        assert -5 < page.evaluate(top) < UPPER_PART_PX
        page.mouse.move(PHONE["width"] / 2, PHONE["height"] / 2)
        page.mouse.wheel(0, 2000)
        page.wait_for_function(f"{top} < -500")


def test_a_formula_with_an_error_raises():
    from sphinxcontrib.katex import KaTeXError

    page = read_html("<p>a $x^2$ <b>b</b> $y$, $z$</p>")
    cell_outputs.typeset_formulas(page)
    assert inner_html(page).count('class="katex"') == 3
    assert "$" not in inner_html(page)
    with pytest.raises(KaTeXError, match=r"[Uu]ndefined"):
        cell_outputs.typeset_formulas(read_html(r"<p>$\nosuchthing$</p>"))
