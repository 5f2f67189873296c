"""The course site builds without a warning, and in a real browser every page opens without errors, quickly and accessibly."""

import gzip
import posixpath
import re
from functools import cache
from urllib.parse import unquote, urlsplit

import pytest
from accessibility import violations
from browser import unwatched, watched
from built_site import DESKTOP, PHONE
from kinsite import execute
from lessons import plain_words

from kincourse import COURSE, find_question
from misstep.questions.item import LETTERS

MAX_PAGE_BYTES, MAX_LECTURE_BYTES = 200_000, 450_000
"""Limits for a page with all the files that it loads, compressed, without the viewer's bundle."""

KINDS = {
    "front": "index.html",
    "lecture": "lectures/03_poe_space.html",
    "sheet": "sheets/03_poe_space.html",
    "gallery": "robots/index.html",
    "arm": "robots/puma560.html",
    "mistakes": "mistakes/03_poe_space.html",
    "reference": "reference/kinlib.chains.chain.html",
    "progress": "progress.html",
    "search": "search.html?q=screw",
    "missing": "404.html",
}


COUNT_SHIFTS = """window.shifts = 0; new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) if (!entry.hadRecentInput) shifts += entry.value;
}).observe({ type: 'layout-shift', buffered: true });"""
LECTURE_03 = KINDS["lecture"]
OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


@pytest.fixture
def page(chromium):
    with watched(chromium, viewport=DESKTOP) as page:
        yield page


@pytest.fixture(scope="module")
def pages(site_folder):
    return sorted(
        path.relative_to(site_folder).as_posix()
        for path in site_folder.rglob("*.html")
        if not {"_static", "lab"} & set(path.relative_to(site_folder).parts)
    )


# --- every page ---


def test_lectures_and_sheets_open_without_errors_and_fit_on_a_phone(chromium_without_webgl, site_address, pages):
    """`watched` fails if a page has an error on its console or asks another host; of other pages, axe opens one of each kind."""
    with watched(chromium_without_webgl, viewport=PHONE) as page:
        for name in (one for one in pages if one.startswith(("lectures/", "sheets/"))):
            assert page.goto(f"{site_address}/{name}", wait_until="domcontentloaded").status == 200
            page.wait_for_load_state("load")
            assert page.evaluate(OVERFLOW) <= 0, f"{name} is wider than a phone"


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


# --- accessibility of each kind of page ---


@pytest.mark.parametrize("kind", KINDS)
def test_axe_finds_no_violation_in_light_and_dark_mode(chromium, chromium_without_webgl, site_address, kind):
    """One viewer that draws is enough: many take long without a graphics card."""
    open_page = unwatched if kind == "missing" else watched  # the browser reports a missing page as an error
    browser = chromium if kind == "arm" else chromium_without_webgl
    with open_page(browser, viewport=DESKTOP) as page:
        page.goto(f"{site_address}/{KINDS[kind]}")
        assert violations(page) == []
        assert page.evaluate(OVERFLOW) <= 0, "the page is wider than the window"


# --- questions, sliders and progress ---

RECALL = '[data-misstep-question="03/recall-2"]'
ORDER = '[data-misstep-question="03/order"]'
RECALL_ITEM, ORDER_ITEM = find_question("03/recall-2"), find_question("03/order")


def wrong_index(item):
    """The index of the first wrong option, as the page shows them."""
    return next(k for k, option in enumerate(item.options) if not option.right)


def test_a_question_explains_the_first_choice_and_ignores_later_ones(page, site_address):
    page.goto(f"{site_address}/{LECTURE_03}")
    wrong, right = wrong_index(RECALL_ITEM), RECALL_ITEM.right
    page.locator(f"{RECALL} .kinlib-choice").nth(wrong).click()
    reply = page.locator(f"{RECALL} .kinlib-reply")
    assert f"{LETTERS[wrong]} is not correct" in reply.inner_text()
    assert plain_words(RECALL_ITEM.options[wrong].why) in reply.inner_text()
    text = plain_words(RECALL_ITEM.options[right].text)
    assert f"The correct answer is {LETTERS[right]}: {text}" in reply.inner_text()
    page.locator(f"{RECALL} .kinlib-choice").nth(right).dispatch_event("click")
    assert f"{LETTERS[wrong]} is not correct" in reply.inner_text()


def test_a_prediction_uncovers_the_arm_and_the_explanation(page, site_address):
    """Both are covered before the prediction, and after it both are shown, also after the page is loaded again."""
    page.goto(f"{site_address}/{LECTURE_03}")
    covered = page.locator('[data-kinlib-after="03/order"]')
    explanation = page.locator('[data-misstep-explain="03/order"]')
    covered.scroll_into_view_if_needed()
    covered.locator(".kv-cover").wait_for()
    wrong = wrong_index(ORDER_ITEM)
    why = plain_words(ORDER_ITEM.options[wrong].why)
    assert not explanation.get_by_text(why).is_visible()
    page.locator(f"{ORDER} .kinlib-choice").nth(wrong).focus()
    page.keyboard.press("Enter")
    covered.locator(".kv-canvas").wait_for(state="visible")
    assert f"{LETTERS[wrong]} is not correct" in explanation.inner_text()
    assert why in explanation.inner_text()
    assert why not in page.locator(ORDER).inner_text()
    page.reload()
    covered.scroll_into_view_if_needed()
    covered.locator(".kv-canvas").wait_for(state="visible")
    assert f"{LETTERS[wrong]} is not correct" in page.locator('[data-misstep-explain="03/order"]').inner_text()


def test_progress_is_shown_saved_deleted_and_loaded_again(page, site_address, tmp_path):
    page.goto(f"{site_address}/{LECTURE_03}")
    page.locator(f"{RECALL} .kinlib-choice").nth(RECALL_ITEM.right).click()
    page.get_by_role("button", name="Mark this lecture as read").click()
    page.goto(f"{site_address}/progress.html")
    row = page.locator('tr[data-lecture="lectures/03_poe_space"]')
    count = len(COURSE.find_sheet("03_poe_space").problems)
    cells = ["✓ read", re.compile(r"^1 of \d+$"), "1", f"0 of {count}"]
    assert_cells(row, cells)
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save a copy").click()
    copy = tmp_path / "copy.json"
    saved.value.save_as(copy)
    page.on("dialog", lambda dialog: dialog.accept())
    page.get_by_role("button", name="Delete everything").click()
    assert_cells(row, ["not yet", re.compile(r"^0 of"), "0", f"0 of {count}"])
    page.locator("input[type=file]").set_input_files(copy)
    page.get_by_text("Loaded, and added").wait_for()
    assert_cells(row, cells)
    (tmp_path / "other.json").write_text("[1, 2]")
    page.locator("input[type=file]").set_input_files(tmp_path / "other.json")
    page.get_by_text("This file is not a copy of your progress").wait_for()
    assert_cells(row, cells)


def assert_cells(row, expected):
    from playwright.sync_api import expect

    for cell, text in zip(row.locator("td").all(), expected, strict=True):
        expect(cell).to_have_text(text)


WITHOUT_STORAGE = {
    "full": "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }",
    "refused": "Object.defineProperty(window, 'localStorage', { configurable: true, get() { throw new DOMException('no'); } })",
}


@pytest.mark.parametrize("reason", WITHOUT_STORAGE)
def test_without_storage_a_page_still_works_and_a_message_is_in_sight(chromium, site_address, reason):
    """In a private window, or if the storage is full, both a question and the answer to a sheet say so."""

    def assert_message(page):
        notice = page.get_by_text("stores nothing for this page").bounding_box()
        assert 0 < notice["y"] < page.viewport_size["height"] - notice["height"]

    with watched(chromium) as page:
        page.add_init_script(WITHOUT_STORAGE[reason])
        page.goto(f"{site_address}/{LECTURE_03}")
        page.locator(f"{RECALL} .kinlib-choice").nth(RECALL_ITEM.right).click()
        assert f"{LETTERS[RECALL_ITEM.right]} is correct" in page.locator(f"{RECALL} .kinlib-reply").inner_text()
        assert_message(page)
        page.goto(f"{site_address}/{KINDS['sheet']}")
        page.locator(".kinlib-cell-answer-1 textarea").fill("screws_1 = 1")
        assert_message(page)


@pytest.mark.parametrize(("name", "size"), [("robots/youbot.html", PHONE), ("lectures/09_urdf.html", DESKTOP)])
def test_a_page_keeps_the_room_that_its_scripts_will_need(chromium_without_webgl, site_address, name, size):
    """What moves while a page loads, as browsers measure it; 0.1 is good. Before a viewer starts, its height is kept free."""
    with watched(chromium_without_webgl, viewport=size) as page:
        page.add_init_script(COUNT_SHIFTS)
        page.goto(f"{site_address}/{name}")
        page.locator(".kv, .kinlib-choice").first.wait_for()
        page.wait_for_load_state("networkidle")
        assert page.evaluate("shifts") < 0.1


def test_without_javascript_every_explanation_can_be_opened(chromium, site_address):
    with watched(chromium, java_script_enabled=False) as page:
        page.goto(f"{site_address}/{LECTURE_03}")
        for option, shown in zip(RECALL_ITEM.options, page.locator(f"{RECALL} .misstep-option").all(), strict=True):
            why = shown.get_by_text(plain_words(option.why))
            assert not why.is_visible()
            shown.locator("summary").click()
            assert why.is_visible()
        page.locator('[data-misstep-explain="03/order"] summary').click()
        assert page.get_by_text(plain_words(ORDER_ITEM.options[1].why)).is_visible()


def test_the_keyboard_focus_is_visible_and_the_first_tab_skips_the_navigation(page, site_address):
    page.goto(f"{site_address}/{LECTURE_03}")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to content"
    page.wait_for_function("document.activeElement.getBoundingClientRect().top >= 0")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('article, [role=main]') !== null")
    for _ in range(12):
        outline = page.evaluate(
            "(s => [s.outlineStyle, parseFloat(s.outlineWidth)])(getComputedStyle(document.activeElement))"
        )
        assert outline[0] != "none", page.evaluate("document.activeElement.outerHTML")
        assert outline[1] >= 2
        page.keyboard.press("Tab")


# --- content of the pages ---


def test_the_pages_of_sheets_contain_no_answers(site_folder):
    """The pages show the released sheets, whose answer cells are blank, and nothing from solutions/."""
    for path in sorted((site_folder / "sheets").glob("[0-9]*.html")):
        text = re.sub(r"<[^>]+>", "", path.read_text("utf-8"))
        answers = re.findall(r"^\s*\w+_\d+ = (.*)$", text, re.MULTILINE)
        assert "BEGIN SOLUTION" not in text
        assert answers.count("...") >= 7, (path.name, answers)


@pytest.mark.parametrize(
    ("source", "message"), [("1 / 0", "ZeroDivisionError"), ("import warnings\nwarnings.warn('old')", "old")]
)
def test_a_notebook_that_raises_or_warns_fails_the_build_by_name(tmp_path, monkeypatch, source, message):
    import nbformat

    monkeypatch.setattr(execute, "ROOT", tmp_path)
    path = tmp_path / "notebooks" / "broken.ipynb"
    path.parent.mkdir()
    nbformat.write(nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source)]), path)
    with pytest.raises(execute.NotebookError, match=rf"(?s)broken\.ipynb.*{message}"):
        execute.execute(path, tmp_path)
