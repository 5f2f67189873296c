"""Cells that run on the page of a lecture: one visit with the real Python, and messages with a worker that only pretends."""

import re

import nbformat
import pytest
from accessibility import violations
from browser import unwatched, watched
from built_site import ROOT
from lab_page import PYTHON_TIMEOUT_MS
from playwright.sync_api import expect

LECTURE = "lectures/00_start_here.html"
CELLS = nbformat.read(ROOT / "notebooks" / "00_start_here.ipynb", as_version=4).cells
CODES = [cell.source for cell in CELLS if cell.cell_type == "code"]
BLANK = next(number for number, code in enumerate(CODES, 1) if "position = ..." in code)
"""The number of the cell with the blank step."""
PHONE = {"width": 390, "height": 844}


@pytest.fixture(scope="module")
def lecture(site_folder, site_address):
    """The address of a lecture whose cells can run."""
    if not (site_folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be downloaded.")
    return f"{site_address}/{LECTURE}"


def cell(page, text):
    return page.locator("div.cell").filter(has=page.locator(".cell_input", has_text=text)).first


def press(which, name):
    which.get_by_role("button", name=name, exact=False).first.click()


def agree(page, which):
    """Press Run for the first time, and agree to what is loaded."""
    press(which, "Run")
    page.get_by_role("button", name="Load Python and run").click()


def ended(which, text="Done."):
    expect(which.locator(".kinlib-live-note")).to_have_text(text, timeout=PYTHON_TIMEOUT_MS)


def write(which, text):
    if not which.locator("textarea").count():
        press(which, "Edit")
    which.locator("textarea").fill(text)


def test_a_reader_runs_changes_and_stops_the_cells_of_a_lecture(chromium_without_webgl, lecture):
    """One visit, because Python takes long to start."""
    with watched(chromium_without_webgl, viewport=PHONE) as page:
        page.goto(lecture)
        runs_the_cells_above_first(page)
        shows_an_error_with_its_line(page)
        links_to_the_section_to_reread(page)
        answers_a_blank_step(page)
        assert violations(page, within="div.cell:has(.kinlib-live-code, .kinlib-live-error)") == []
        stops_a_cell_that_never_ends(page)
        page.reload()
        typed = page.get_by_role("textbox", name="Code of cell")
        assert [area.input_value() for area in typed.all()] == ["1 +", "while True: pass"]
        page.get_by_role("button", name=f"Reset cell {BLANK}").click()
        page.reload()
        assert [area.input_value() for area in typed.all()] == ["1 +"]


def runs_the_cells_above_first(page):
    """Python loads after the reader has agreed; the result of the page stays until the new one is there."""
    pose = cell(page, "print(arm.home")
    before = pose.locator(".cell_output").inner_text()
    assert "RRRRR" in before
    agree(page, pose)
    expect(pose.get_by_text("Python is loading")).to_be_visible()
    assert pose.locator(".cell_output").inner_text() == before
    ended(pose)
    assert pose.locator(".cell_output").inner_text().split() == before.split()
    for above in ("draw_parts(arm)", "draw_home(arm)", 'ask("00/joint-3")'):
        ended(cell(page, above))
    assert cell(page, "draw_parts(arm)").get_by_role("img").count() == 1
    question = cell(page, 'ask("00/joint-3")')
    question.get_by_role("button", name="A", exact=False).first.click()
    expect(question.get_by_text(re.compile(r"A is (not correct|correct)"))).to_be_visible()


def shows_an_error_with_its_line(page):
    pose = cell(page, "print(arm.home")
    write(pose, "print('before')\narm.fk([1, 2])")
    pose.locator("textarea").press("Control+Enter")
    ended(pose, "Ended with an error.")
    output = pose.locator(".cell_output")
    expect(output.locator(".stream")).to_have_text("before\n")
    expect(output.locator(".kinlib-live-error p")).to_have_text("✗ ValueError in line 2 of this cell")
    expect(output).to_contain_text("q must have shape (..., 5)")
    write(pose, "from sympy import symbols\nsymbols('x') ** 2")
    pose.locator("textarea").press("Control+Enter")
    ended(pose)
    expect(output.locator(".katex")).to_have_count(1)
    write(pose, "from IPython.display import Markdown\nMarkdown('Where $x$, there $y$ is.')")
    pose.locator("textarea").press("Control+Enter")
    ended(pose)
    expect(output.locator(".together")).to_have_text(re.compile(r"x,$"))
    write(pose, "1 +")
    pose.locator("textarea").press("Control+Enter")
    ended(pose, "Ended with an error.")
    expect(output.locator(".kinlib-live-error p")).to_have_text("✗ SyntaxError in line 1 of this cell")


def links_to_the_section_to_reread(page):
    wrong = cell(page, "position = [")
    press(wrong, "Run")
    ended(wrong)
    link = wrong.get_by_role("link", name="Re-read: section “A wrong answer, on purpose” of lecture 00, Start here.")
    expect(link).to_have_attribute("href", "../lectures/00_start_here.html#a-wrong-answer-on-purpose")


def answers_a_blank_step(page):
    """The card of a blank step in the lecture judges what the reader typed; Shift+Enter goes on to the next cell."""
    blank = cell(page, "position = ...")
    write(blank, 'position = [0.5405, 0, 0.147]\nattempt("00.a", position)')
    blank = page.locator("div.cell", has=page.get_by_role("textbox", name=f"Code of cell {BLANK}"))
    blank.locator("textarea").press("Shift+Enter")
    ended(blank)
    expect(blank.locator(".cell_output")).to_contain_text("Right")
    expect(page.get_by_role("button", name=f"Run cell {BLANK + 1}")).to_be_focused()


def stops_a_cell_that_never_ends(page):
    endless = page.locator("div.cell", has=page.get_by_role("textbox", name=f"Code of cell {BLANK}"))
    write(endless, "while True: pass")
    press(endless, "Run")
    ended(endless, "Running.")
    press(endless, "Stop")
    expect(endless.locator(".kinlib-live-note")).to_contain_text("All variables are lost")
    expect(endless.get_by_role("button", name=f"Run cell {BLANK}")).to_have_text("Run")


def test_nothing_is_loaded_by_touching_scrolling_or_answering_until_the_reader_agrees(
    chromium_without_webgl, site_address, lecture
):
    """A finger moves over a thing of each kind, and every question is answered. Then Run says what it will load."""
    with watched(chromium_without_webgl, viewport=PHONE, has_touch=True) as page:
        asked = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"{site_address}/lectures/03_poe_space.html")
        touch = page.context.new_cdp_session(page)
        for kind in ("[data-kinlib-viewer]", "figure", "[data-kinlib-film]", ".misstep-question", ".stream", "pre"):
            figure = page.locator(f"article div.cell {kind}").first
            figure.scroll_into_view_if_needed()
            box = figure.bounding_box()
            for event, y in (("touchStart", 0.5), ("touchMove", 0.3), ("touchEnd", 0.3)):
                point = {"x": box["x"] + 40, "y": box["y"] + y * min(box["height"], 300)}
                points = [] if event == "touchEnd" else [point]
                touch.send("Input.dispatchTouchEvent", {"type": event, "touchPoints": points})
        questions = page.locator(".misstep-question")
        for question in questions.all():
            question.locator(".kinlib-choice").first.tap()
        assert page.locator(".misstep-question[data-committed]").count() == questions.count() > 5
        run = cell(page, "plain_arm()").get_by_role("button", name="Run")
        run.tap()
        expect(page.get_by_role("group", name="Load Python?")).to_contain_text(
            re.compile(r"loads Python: \d+ MB, once")
        )
        page.get_by_role("button", name="Not now").tap()
        expect(run).to_be_focused()
        assert not [url for url in asked if "/lab/" in url]


def test_two_tabs_of_a_sheet_keep_what_is_typed_in_both(chromium_without_webgl, site_address, lecture):
    typed = {".kinlib-cell-answer-1 textarea": "screws_1 = 1", ".kinlib-cell-answer-2 textarea": "screw_2 = 2"}
    with watched(chromium_without_webgl) as page:
        tabs = [page, page.context.new_page()]
        for tab in tabs:
            tab.goto(f"{site_address}/sheets/03_poe_space.html")
        for tab, (field, text) in zip(tabs, typed.items(), strict=True):
            tab.locator(field).fill(text)
        for _ in range(2):
            for field, text in typed.items():
                expect(page.locator(field)).to_have_value(text)
            page.reload()


def test_the_page_says_how_much_is_loaded_and_when_nothing_arrives(chromium_without_webgl, lecture):
    with watched(chromium_without_webgl, service_workers="block") as page:
        page.clock.install()
        page.route("**/live/worker.js", lambda route: route.fulfill(
            content_type="text/javascript",
            body="postMessage({ kind: 'bytes', received: 12.9e6, total: 37.2e6 });",
        ))  # fmt: skip
        page.goto(lecture)
        agree(page, cell(page, "print(arm.home"))
        expect(page.locator(".kinlib-live-status")).to_have_text("Python is loading 12 of 38 MB")
        assert float(page.locator(".kinlib-live-status progress").get_attribute("value")) == pytest.approx(12.9 / 37.2)
        page.clock.run_for(20_000)
        expect(page.locator(".kinlib-live-status")).to_contain_text("No data has arrived for 20 seconds.")


def test_the_page_says_why_python_could_not_start_and_tries_again(chromium_without_webgl, lecture):
    with unwatched(chromium_without_webgl, service_workers="block") as page:
        page.route("**/live/load.json", lambda route: route.abort())
        page.goto(lecture)
        first = cell(page, "print(arm.home")
        agree(page, first)
        ended(first, "Python could not start.")
        expect(page.locator(".kinlib-live-status")).to_contain_text("Check the connection, then press Run again.")
        page.unroute("**/live/load.json")  # otherwise it would fail again before this can be read
        press(first, "Run")
        expect(first.locator(".kinlib-live-note")).to_contain_text("Waiting for Python.")


def test_without_a_lab_the_page_says_that_the_code_has_been_run(chromium_without_webgl, lecture):
    with watched(chromium_without_webgl, service_workers="block") as page:
        page.route("**/live.js", lambda route: route.fulfill(content_type="text/javascript", body=""))
        page.goto(lecture)
        expect(page.locator(".kinlib-ran")).to_contain_text("has been run for you")
        expect(page.get_by_role("button", name="Run cell 1")).to_have_count(0)
