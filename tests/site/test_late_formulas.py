"""Formulas of the pages: drawn when the reader comes near, readable before that, complete in print, and well placed."""

import pytest
from browser import watched
from built_site import DESKTOP, PHONE
from kinsite import cell_outputs, late_formulas
from kinsite.html_tree import inner_html, read_html

LECTURE_03 = "lectures/03_poe_space.html"
LONGEST_LECTURE = "lectures/06_dh_modified.html"
UPPER_PART_PX = 100  # below the bar of a phone, and the margin of a section
WAITING = "document.querySelectorAll('kinlib-formula').length"
WAITING_IN_SIGHT = """[...document.querySelectorAll('kinlib-formula')].filter((formula) => {
  const { top, bottom } = formula.getBoundingClientRect();
  return formula.checkVisibility() && bottom > 0 && top < innerHeight;
}).length"""
UNFOLDED_WIDTHS = """[...document.querySelectorAll('.katex-mathml:has(+ kinlib-formula)')]
  .filter((formula) => !formula.closest('details:not([open])')).map((formula) => formula.offsetWidth)"""


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport=DESKTOP) as page:
        yield page


def test_a_long_lecture_opens_with_less_than_three_quarters_of_what_is_printed(page, site_address):
    page.goto(f"{site_address}/{LONGEST_LECTURE}")
    at_first = page.locator("*").count()
    assert page.evaluate(WAITING) > 60
    page.pdf()
    assert page.evaluate(WAITING) == 0
    assert at_first < 0.75 * page.locator("*").count()


def test_every_formula_in_sight_is_drawn(page, site_address):
    page.goto(f"{site_address}/{LONGEST_LECTURE}")
    page.mouse.move(DESKTOP["width"] / 2, DESKTOP["height"] / 2)
    position = -1
    while (now := page.evaluate("scrollY")) != position:
        position = now
        assert page.evaluate(WAITING_IN_SIGHT) == 0
        page.mouse.wheel(0, 700)
        page.wait_for_timeout(60)
    assert page.evaluate(WAITING_IN_SIGHT) == 0


def test_without_scripts_each_formula_is_shown_as_mathml(chromium, site_address, site_folder):
    html = (site_folder / LECTURE_03).read_text("utf-8")
    with watched(chromium, java_script_enabled=False) as page:
        page.goto(f"{site_address}/{LECTURE_03}")
        formulas = page.locator(".katex-mathml:has(+ kinlib-formula)")
        assert formulas.count() == html.count(late_formulas.BEGIN)
        widths = page.evaluate(UNFOLDED_WIDTHS)
    assert len(widths) > 60
    assert min(widths) > 3


@pytest.mark.parametrize(
    ("size", "arrives"), [(PHONE, "by the address"), (DESKTOP, "by a click")], ids=["phone", "desktop"]
)
def test_a_link_to_a_section_leads_there(page, site_address, size, arrives):
    """Formulas and viewers above it change their height when they are drawn; it stays in place until the reader scrolls."""
    page.set_viewport_size(size)
    page.goto(f"{site_address}/{LONGEST_LECTURE}")
    section = page.locator("article > section > section[id]").nth(7).get_attribute("id")
    if arrives == "by a click":
        page.evaluate("(id) => { location.hash = id; }", section)
    else:
        page.goto("about:blank")
        page.goto(f"{site_address}/{LONGEST_LECTURE}#{section}")
    top = f"document.getElementById('{section}').getBoundingClientRect().top"
    page.wait_for_function(f"{top} > -5 && {top} < {UPPER_PART_PX}")
    page.wait_for_timeout(800)
    assert -5 < page.evaluate(top) < UPPER_PART_PX
    assert page.evaluate(WAITING) == 0
    page.mouse.wheel(0, 2000)
    page.wait_for_function(f"{top} < -1500")
    page.wait_for_timeout(800)
    assert page.evaluate(top) < -1500


def test_a_formula_with_an_error_raises():
    from sphinxcontrib.katex import KaTeXError

    page = read_html("<p>a $x^2$ <b>b</b> $y$, $z$</p>")
    cell_outputs.typeset_formulas(page)
    assert inner_html(page).count('class="katex"') == 3
    assert "$" not in inner_html(page)
    with pytest.raises(KaTeXError, match=r"[Uu]ndefined"):
        cell_outputs.typeset_formulas(read_html(r"<p>$\nosuchthing$</p>"))
