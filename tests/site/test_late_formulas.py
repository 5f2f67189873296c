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
DRAW_ALL = "dispatchEvent(new Event('beforeprint'))"
UNFOLDED_WIDTHS = """[...document.querySelectorAll('.katex-mathml:has(+ kinlib-formula)')]
  .filter((formula) => !formula.closest('details:not([open])')).map((formula) => formula.offsetWidth)"""


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport=DESKTOP) as page:
        yield page


def test_a_long_lecture_opens_with_less_than_three_quarters_of_what_is_printed(page, site_address):
    page.goto(f"{site_address}/{LONGEST_LECTURE}")
    at_first = page.locator("*").count()
    assert page.evaluate(WAITING) > 100
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


def test_a_formula_in_a_folded_explanation_is_drawn_when_it_opens(page, site_address):
    page.goto(f"{site_address}/{LECTURE_03}")
    formula = page.locator("details:not([open]):has(kinlib-formula)").last
    formula.scroll_into_view_if_needed()
    before = page.evaluate(WAITING)
    formula.evaluate("(details) => { details.open = true; }")
    page.wait_for_function(f"{WAITING} < {before}")
    page.wait_for_function(f"{WAITING_IN_SIGHT} === 0")


def test_without_scripts_each_formula_is_shown_as_mathml(chromium, site_address, site_folder):
    html = (site_folder / LECTURE_03).read_text("utf-8")
    with watched(chromium, java_script_enabled=False) as page:
        page.goto(f"{site_address}/{LECTURE_03}")
        formulas = page.locator(".katex-mathml:has(+ kinlib-formula)")
        assert formulas.count() == html.count(late_formulas.BEGIN)
        widths = page.evaluate(UNFOLDED_WIDTHS)
    assert len(widths) > 100
    assert min(widths) > 3


def test_the_first_screen_is_complete_without_scripts(chromium, site_folder, site_address):
    """On the pages that have least text before their first formula that waits."""
    texts = {path: path.read_text("utf-8") for path in site_folder.rglob("*.html")}
    before = {
        path: html.index(late_formulas.BEGIN) - html.index("<article")
        for path, html in texts.items()
        if late_formulas.BEGIN in html
    }
    assert len(before) > 20
    with watched(chromium, viewport={"width": 1920, "height": 1200}, java_script_enabled=False) as page:
        for path in sorted(before, key=before.get)[:8]:
            page.goto(f"{site_address}/{path.relative_to(site_folder).as_posix()}")
            assert page.evaluate(WAITING_IN_SIGHT) == 0, path


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


def test_a_comma_stays_on_the_line_of_its_formula(page, site_address):
    """If a line ends with a formula, a browser would put the comma at the start of the next line."""
    page.set_viewport_size(PHONE)
    page.goto(f"{site_address}/mistakes/03_poe_space.html")
    page.evaluate(DRAW_ALL)
    assert page.locator(".together").count() > 20
    tops = page.evaluate(
        """[...document.querySelectorAll('.together')].map((held) => {
            const range = document.createRange();
            range.selectNodeContents(held.lastChild);
            return range.getBoundingClientRect().top - held.querySelector('.katex-html').getBoundingClientRect().bottom; })"""
    )
    assert max(tops) < 0


@pytest.mark.parametrize("size", [PHONE, DESKTOP], ids=["phone", "desktop"])
def test_the_number_of_a_formula_follows_its_end(page, site_address, size):
    """On a phone a long formula extends beyond the edge of the page, where its number would overlap it."""
    page.set_viewport_size(size)
    page.goto(f"{site_address}/{LECTURE_03}")
    page.evaluate(DRAW_ALL)
    gaps = page.evaluate(
        """[...document.querySelectorAll('.katex-display:has(.tag)')].map((shown) => {
            const ends = [...shown.querySelectorAll('.base')].map((part) => part.getBoundingClientRect().right);
            return shown.querySelector('.tag').getBoundingClientRect().left - Math.max(...ends); })"""
    )
    assert len(gaps) > 3
    assert min(gaps) > 5


def test_a_formula_with_an_error_raises():
    from sphinxcontrib.katex import KaTeXError

    page = read_html("<p>a $x^2$ <b>b</b> $y$, $z$</p>")
    cell_outputs.typeset_formulas(page)
    assert inner_html(page).count('class="katex"') == 3
    assert "$" not in inner_html(page)
    with pytest.raises(KaTeXError, match=r"[Uu]ndefined"):
        cell_outputs.typeset_formulas(read_html(r"<p>$\nosuchthing$</p>"))
