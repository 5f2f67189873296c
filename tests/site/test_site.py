"""The course site builds without a warning, and in a real browser every page opens without errors, quickly and accessibly."""

import gzip
import json
import posixpath
import re
from functools import cache
from urllib.parse import unquote, urlsplit

import nbformat
import pytest
from accessibility import violations
from browser import contrast, watched
from built_site import DESKTOP, PHONE
from kinsite import cell_outputs, demonstration, execute
from kinsite.html_tree import inner_html, read_html
from lessons import plain_words
from playwright.sync_api import expect
from sphinxcontrib.katex import KaTeXError

from kincourse import find_question, find_sheet, open_sheet
from misstep.questions.item import LETTERS

MAX_PAGE_BYTES, MAX_LECTURE_BYTES = 200_000, 450_000
"""Limits for a page with all the files that it loads, compressed, without the viewer's bundle."""

COUNT_SHIFTS = """window.shifts = 0; new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) if (!entry.hadRecentInput) shifts += entry.value;
}).observe({ type: 'layout-shift', buffered: true });"""
"""Counts what moves while a page loads, as browsers measure it; 0.1 is good."""
OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
LECTURE, LONGEST_LECTURE, SHEET = (
    "lectures/00_start_here.html",
    "lectures/06_dh_modified.html",
    "sheets/08_closed_chains.html",
)
UPPER_PART_PX = 100  # below the bar of a phone, and the margin of a section


@pytest.fixture(scope="module")
def pages(site_folder):
    return sorted(
        path.relative_to(site_folder).as_posix()
        for path in site_folder.rglob("*.html")
        if not {"_static", "lab"} & set(path.relative_to(site_folder).parts)
    )


# --- every page ---


def test_lectures_and_sheets_open_without_errors_and_fit_on_a_phone(chromium_without_webgl, site_address, pages):
    """`watched` fails if a page has an error on its console or asks another host."""
    with watched(chromium_without_webgl, viewport=PHONE) as page:
        for name in (one for one in pages if one.startswith(("lectures/", "sheets/"))):
            assert page.goto(f"{site_address}/{name}").status == 200
            assert page.evaluate(OVERFLOW) <= 0, f"{name} is wider than a phone"


def test_a_link_to_a_section_leads_there(chromium_without_webgl, site_address):
    """Viewers above it change their height when they are drawn; it stays in place until the reader scrolls."""
    with watched(chromium_without_webgl, viewport=PHONE) as page:
        page.goto(f"{site_address}/{LONGEST_LECTURE}")
        section = page.locator("article h2[id]").nth(4).get_attribute("id")
        page.goto("about:blank")
        page.goto(f"{site_address}/{LONGEST_LECTURE}#{section}")
        top = f"document.getElementById('{section}').getBoundingClientRect().top"
        page.wait_for_load_state("networkidle")
        page.wait_for_function(f"{top} > -5 && {top} < {UPPER_PART_PX}")
        page.mouse.move(PHONE["width"] / 2, PHONE["height"] / 2)
        page.mouse.wheel(0, 2000)
        page.wait_for_function(f"{top} < -500")


def test_no_page_has_a_broken_link(site_folder, pages):
    assert len(pages) > 60
    broken = []
    for name in (one for one in pages if one != "404.html"):  # its links are absolute
        text = (site_folder / name).read_text("utf-8")
        links = map(urlsplit, re.findall(r'<(?:a|link|img|script)\b[^>]*?\b(?:href|src)="([^"]+)"', text))
        for link in (one for one in links if not one.scheme and not one.netloc):
            target = site_folder / (posixpath.join(posixpath.dirname(name), unquote(link.path)) if link.path else name)
            target = target / "index.html" if target.is_dir() else target
            section = unquote(link.fragment) if target.suffix == ".html" else ""
            if not target.exists() or (section and section not in anchors(target.resolve())):
                broken.append(f"{name}: {link.geturl()}")
    assert not broken, broken[:5]


@cache
def anchors(path):
    return set(re.findall(r'\bid="([^"]+)"', path.read_text("utf-8")))


def test_every_page_has_its_metadata(site_folder, pages):
    """A title and a description of its own, a language, one main heading, an icon, an image for shared links."""
    titles = {}
    for name in pages:
        text = (site_folder / name).read_text("utf-8")
        assert text.count("<h1") == 1, f"{name} has {text.count('<h1')} main headings"
        for part in ('<html class="no-js" lang="en"', 'icon" href=', 'name="viewport"'):
            assert part in text, f"{name} lacks {part}"
        assert "noindex" not in text, f"search engines would ignore {name}"
        for part in ('name="description"', 'property="og:image"'):
            assert part in text or name in ("404.html", "search.html"), f"{name} lacks {part}"
        titles.setdefault(re.search(r"<title>(.*?)</title>", text)[1], []).append(name)
    assert not {title: names for title, names in titles.items() if len(names) > 1}
    front = (site_folder / "index.html").read_text("utf-8")
    course = re.search(r'<script type="application/ld\+json">(.*?)</script>', front, re.DOTALL)[1]
    assert json.loads(course)["@type"] == "Course"
    assert "Sitemap: http" in (site_folder / "robots.txt").read_text("utf-8")


def test_no_page_is_too_large(site_folder, pages):
    """The compressed sizes of a page and of every file that it loads at once are added, without a browser."""
    too_large = {}
    for name in pages:
        text = (site_folder / name).read_text("utf-8")
        eager = re.sub(r'<img [^>]*loading="lazy"[^>]*>', "", text)
        paths = set(re.findall(r'(?:src|href)="([^"#?]+\.(?:css|js|svg|png))(?:\?[^"]*)?"', eager))
        base = site_folder if name == "404.html" else (site_folder / name).parent  # 404.html has absolute links
        files = {(base / path.lstrip("/")).resolve() for path in paths if "//" not in path}
        fonts = ("Main-Regular", "Size1-Regular", "Size2-Regular", *["Math-Italic"] * ("katex" in text))
        files |= {site_folder / "_static/katex/fonts" / f"KaTeX_{font}.woff2" for font in fonts}
        size = sum(compressed_size(path) for path in {site_folder / name, *files} if path.name != "viewer.js")
        if size > (MAX_LECTURE_BYTES if name.startswith("lectures/") else MAX_PAGE_BYTES):
            too_large[name] = size
    assert not too_large


@cache
def compressed_size(path):
    data = path.read_bytes()
    return len(data) if path.suffix in (".woff2", ".png") else len(gzip.compress(data, 6))


# --- how pages are used ---

ASKED, PREDICTED = "00/home-of-another", "00/joint-3"
QUESTION, PREDICTION = find_question(ASKED), find_question(PREDICTED)


def asked(page, name):
    return page.locator(f'[data-misstep-question="{name}"]')


def wrong_index(item):
    """The index of the first wrong option, as the page shows them."""
    return next(k for k, option in enumerate(item.options) if not option.right)


def test_a_lecture_is_read_with_its_questions_and_prediction_and_has_no_violation(chromium_without_webgl, site_address):
    """What axe finds in the light and in the dark theme is a violation; sheets, the search and an arm have theirs elsewhere."""
    with watched(chromium_without_webgl, viewport=DESKTOP) as page:
        page.goto(f"{site_address}/{LECTURE}")
        the_first_tab_skips_the_navigation(page)
        wrong, reply = wrong_index(QUESTION), asked(page, ASKED).locator(".kinlib-reply")
        choices = asked(page, ASKED).locator(".kinlib-choice")
        choices.nth(wrong).click()
        text = plain_words(QUESTION.options[QUESTION.right].text)
        for said in (f"{LETTERS[wrong]} is not correct", plain_words(QUESTION.options[wrong].why)):
            expect(reply).to_contain_text(said)
        expect(reply).to_contain_text(f"The correct answer is {LETTERS[QUESTION.right]}: {text}")
        choices.nth(QUESTION.right).dispatch_event("click")
        expect(reply).to_contain_text(f"{LETTERS[wrong]} is not correct")
        wrong = wrong_index(PREDICTION)
        why = plain_words(PREDICTION.options[wrong].why)
        covered = page.locator(f'[data-kinlib-after="{PREDICTED}"]')
        explanation = page.locator(f'[data-misstep-explain="{PREDICTED}"]')
        covered.evaluate("arm => arm.scrollIntoView()")
        expect(covered.locator(".kv-cover")).to_be_visible()
        expect(explanation.get_by_text(why)).to_be_hidden()
        asked(page, PREDICTED).locator(".kinlib-choice").nth(wrong).press("Enter")
        expect(covered.locator(".kv-cover")).to_be_hidden()
        expect(explanation).to_contain_text(f"{LETTERS[wrong]} is not correct")
        expect(explanation).to_contain_text(why)
        expect(asked(page, PREDICTED)).not_to_contain_text(why)
        page.reload()
        expect(explanation).to_contain_text(f"{LETTERS[wrong]} is not correct")
        covered.evaluate("arm => arm.scrollIntoView()")
        covered.locator(".kv").wait_for()
        expect(covered.locator(".kv-cover")).to_be_hidden()
        assert violations(page) == []
        assert page.evaluate(OVERFLOW) <= 0, "the page is wider than the window"
        paper_is_white_with_all_pictures_and_no_controls(page)


def paper_is_white_with_all_pictures_and_no_controls(page):
    page.emulate_media(media="print", color_scheme="dark")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.wait_for_function("[...document.querySelectorAll('article img')].every((image) => image.complete)")
    controls = ".skip-to-content, details.hide > summary, .kinlib-button, .kv :is(button, .kv-side)"
    assert page.locator(controls).evaluate_all("all => all.filter((one) => one.checkVisibility()).length") == 0
    ink = page.locator(".misstep-question").first.evaluate("question => getComputedStyle(question).color")
    assert contrast(ink, "#ffffff") > 4.5


def the_first_tab_skips_the_navigation(page):
    """And wherever the keyboard leads, the focus is visible."""
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to content"
    page.wait_for_function("document.activeElement.getBoundingClientRect().top >= 0")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('article, [role=main]') !== null")
    for _ in range(12):
        style, width = page.evaluate(
            "(s => [s.outlineStyle, parseFloat(s.outlineWidth)])(getComputedStyle(document.activeElement))"
        )
        assert style != "none", page.evaluate("document.activeElement.outerHTML")
        assert width >= 2
        page.keyboard.press("Tab")


def test_progress_is_shown_saved_deleted_and_loaded_again(chromium_without_webgl, site_address, tmp_path):
    count = len(find_sheet("03_poe_space").problems)
    with watched(chromium_without_webgl, viewport=DESKTOP) as page:
        page.goto(f"{site_address}/lectures/03_poe_space.html")
        asked(page, "03/recall-2").locator(".kinlib-choice").nth(find_question("03/recall-2").right).click()
        page.get_by_role("button", name="Mark this lecture as read").click()
        page.goto(f"{site_address}/progress.html")
        row = page.locator('tr[data-lecture="lectures/03_poe_space"]')
        cells = ["✓ read", re.compile(r"^1 of \d+$"), "1", f"0 of {count}"]
        assert_cells(row, cells)
        with page.expect_download() as saved:
            page.get_by_role("button", name="Save a copy").click()
        copy = tmp_path / "copy.json"
        saved.value.save_as(copy)
        page.on("dialog", lambda dialog: dialog.accept())
        page.evaluate("localStorage.setItem('kinlib-live:/sheets/03_poe_space.html', '{}')")
        page.get_by_role("button", name="Delete everything").click()
        assert page.evaluate("Object.keys(localStorage)") == []
        assert_cells(row, ["not yet", re.compile("^0 of"), "0", f"0 of {count}"])
        page.locator("input[type=file]").set_input_files(copy)
        page.get_by_text("Loaded, and added").wait_for()
        assert_cells(row, cells)
        (tmp_path / "other.json").write_text("[1, 2]")
        page.locator("input[type=file]").set_input_files(tmp_path / "other.json")
        page.get_by_text("This file is not a copy of your progress").wait_for()
        assert_cells(row, cells)


def assert_cells(row, expected):
    for cell, text in zip(row.locator("td").all(), expected, strict=True):
        expect(cell).to_have_text(text)


FULL = "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }"
REFUSED = (
    "Object.defineProperty(window, 'localStorage', { configurable: true, get() { throw new DOMException('no'); } })"
)


def test_without_storage_a_page_still_works_and_a_message_is_in_sight(chromium_without_webgl, site_address):
    """If the storage is full the answer to a sheet says so, and in a private window a question."""

    def assert_message(page):
        expect(page.get_by_text("stores nothing for this page")).to_be_in_viewport(ratio=1)

    with watched(chromium_without_webgl) as page:
        page.goto(f"{site_address}/{SHEET}")
        page.evaluate(f"void ({FULL})")
        page.locator(".kinlib-cell-answer-1 textarea").fill("x = 1")
        assert_message(page)
        page.add_init_script(REFUSED)
        page.goto(f"{site_address}/{LECTURE}")
        asked(page, ASKED).locator(".kinlib-choice").nth(QUESTION.right).click()
        reply = asked(page, ASKED).locator(".kinlib-reply")
        expect(reply).to_contain_text(f"{LETTERS[QUESTION.right]} is correct")
        assert_message(page)


def test_without_javascript_every_explanation_and_every_card_of_the_home_page_can_be_opened(
    chromium_without_webgl, site_address
):
    with watched(chromium_without_webgl, java_script_enabled=False) as page:
        page.goto(f"{site_address}/{LECTURE}")
        expect(page.locator(".kinlib-ran")).to_contain_text("has been run for you")
        shown = asked(page, ASKED).locator(".misstep-option").all()
        for option, one in zip(QUESTION.options, shown, strict=True):
            why = one.get_by_text(plain_words(option.why))
            expect(why).to_be_hidden()
            one.locator("summary").click()
            expect(why).to_be_visible()
        page.locator(f'[data-misstep-explain="{PREDICTED}"] summary').click()
        expect(page.get_by_text(plain_words(PREDICTION.options[1].why))).to_be_visible()
        page.goto(f"{site_address}/")
        sheet = open_sheet(demonstration.SHEET, demonstration.STUDENT)
        messages = {one.name: one.message for one in sheet.problem(demonstration.PROBLEM).known_mistakes}
        answers = page.locator(".kinlib-answers details").all()
        for answer, (code, mistake) in zip(answers, demonstration.ATTEMPTS, strict=True):
            if answer.get_attribute("open") is None:
                answer.locator("summary").click()
            expect(answer).to_contain_text(code)
            said = messages[mistake].partition(". ")[2].partition("$")[0] if mistake else "2 of 2 points"
            expect(answer).to_contain_text(said)
            assert page.locator(".kinlib-answers details[open]").count() == 1


def test_an_address_with_joint_values_opens_the_arm_in_this_configuration(chromium, site_address):
    read = "document.querySelector('.kv')?.viewer.model.get('q')"
    with watched(chromium, viewport=PHONE) as page:
        page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        page.add_init_script(COUNT_SHIFTS)
        page.goto(f"{site_address}/robots/youbot.html#q=0.1,0.2,-0.3,0.4,0.5")
        page.wait_for_function(read)
        assert page.evaluate(read) == [0.1, 0.2, -0.3, 0.4, 0.5]
        page.wait_for_load_state("networkidle")
        assert page.evaluate("shifts") < 0.1, "the height of the viewer is kept free"
        page.evaluate("location.hash = '#q=1,1,1,1,1'")
        page.wait_for_function(f"{read}[0] === 1")
        page.evaluate("location.hash = '#q=1,2'")
        assert page.evaluate(read) == [1, 1, 1, 1, 1], "too few values change nothing"
        page.get_by_role("button", name="Copy a link to this configuration").click()
        page.get_by_role("button", name="Copied").wait_for()
        assert page.evaluate("navigator.clipboard.readText()") == f"{site_address}/robots/youbot.html#q=1,1,1,1,1"
        assert violations(page) == []


# --- content of the pages ---


def test_the_pages_of_sheets_contain_no_answers(site_folder):
    """The pages show the released sheets, whose answer cells are blank, and nothing from solutions/."""
    for path in sorted((site_folder / "sheets").glob("[0-9]*.html")):
        text = re.sub(r"<[^>]+>", "", path.read_text("utf-8"))
        answers = re.findall(r"^\s*\w+_\d+ = (.*)$", text, re.MULTILINE)
        assert "BEGIN SOLUTION" not in text
        assert answers.count("...") >= 7, (path.name, answers)


def test_a_notebook_that_raises_fails_the_build_by_name(tmp_path, monkeypatch):
    monkeypatch.setattr(execute, "ROOT", tmp_path)
    path = tmp_path / "notebooks" / "broken.ipynb"
    path.parent.mkdir()
    nbformat.write(nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("1 / 0")]), path)
    with pytest.raises(execute.NotebookError, match=r"(?s)broken\.ipynb.*ZeroDivisionError"):
        execute.execute(path, tmp_path)


def test_a_formula_with_an_error_raises():
    page = read_html("<p>a $x^2$ <b>b</b> $y$, $z$</p>")
    cell_outputs.typeset_formulas(page)
    assert inner_html(page).count('class="katex"') == 3
    assert "$" not in inner_html(page)
    with pytest.raises(KaTeXError, match=r"[Uu]ndefined"):
        cell_outputs.typeset_formulas(read_html(r"<p>$\nosuchthing$</p>"))
