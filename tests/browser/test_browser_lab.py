"""The lab in the browser: a sheet is opened, answered, checked, stored and downloaded, and every failure shows a message.

This test uses one notebook; `tests/browser/every_notebook_in_the_browser.py` runs all of them.
"""

import contextlib
import json
import re
import threading
from functools import partial
from http.server import ThreadingHTTPServer
from urllib.parse import urlsplit

import numpy as np
import pytest
from browser import unwatched, watched
from built_site import ROOT
from lab_page import PAGE_TIMEOUT_MS, PYTHON_TIMEOUT_MS, cell, run, visit, wait_for, write
from lessons import words_of
from playwright.sync_api import expect
from serve import PageHandler

from kincourse import find_sheet

SHEET = "exercises/03_poe_space/03_poe_space.ipynb"
WINDOW = {"width": 1200, "height": 1000}
PHONE = {"width": 390, "height": 844}

SHORT_MINUTE = """const original = setTimeout;
setTimeout = (act, wait, ...more) => original(act, window.shortMinute && wait === 60000 ? 1000 : wait, ...more)"""
"""Makes a timer of one minute end after one second, as soon as window.shortMinute is set."""

STORAGE_FULL = (
    "() => { IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); }; }"
)

STORED_NOTEBOOKS = """async () => {
    const result = (request) => new Promise((done, fail) => { request.onsuccess = () => done(request.result); request.onerror = fail; });
    const name = (await indexedDB.databases()).map(({ name }) => name).find((name) => name.startsWith('JupyterLite Storage'));
    const store = (await result(indexedDB.open(name))).transaction('files').objectStore('files');
    return JSON.stringify(await result(store.getAll()));
}"""
"""Reads the notebooks that the browser has stored."""


@pytest.fixture(scope="module")
def lab_address(site_folder, site_address):
    """The address of the built site, which must contain the lab."""
    if not (site_folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be downloaded.")
    return site_address


@pytest.mark.nightly
def test_a_sheet_is_opened_answered_checked_stored_and_handed_in(chromium, lab_address, tmp_path):
    """The work of one student in one window, because Python takes long to start."""
    with watched(chromium, viewport=WINDOW) as page:
        page.set_default_timeout(PAGE_TIMEOUT_MS)
        page.add_init_script(SHORT_MINUTE)
        page.goto(f"{lab_address}/sheets/03_poe_space.html")
        page.get_by_role("link", name="Run in the browser").click()
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=PAGE_TIMEOUT_MS)
        run(page, cell(page, "open_sheet"))
        sheet = find_sheet("03_poe_space")
        assert f"{len(sheet.problems)} problems, {sheet.points} points" in cell(page, "open_sheet").inner_text()

        answer_and_check(page)
        explain_a_prediction(page)
        move_a_slider(page)
        hand_in(page, tmp_path)
        break_python(page)

        # the last change is stored without saving it, and the page of progress counts the solved problem
        write(page, cell(page, "screw_3 ="), "screw_3 = 'typed last'")
        wait_for(page, lambda: "typed last" in page.evaluate(STORED_NOTEBOOKS), PAGE_TIMEOUT_MS)
        visit(page, lab_address, SHEET)
        expect(cell(page, "typed last")).to_be_visible(timeout=PAGE_TIMEOUT_MS)
        expect(cell(page, "screws_1 = np.array")).to_be_visible()
        page.goto(f"{lab_address}/progress.html")
        expect(page.locator('tr[data-lecture="lectures/03_poe_space"] [data-solved]')).to_have_text(
            f"1 of {len(sheet.problems)}"
        )


SCROLLED_TO_THE_TOP = """section => {
    section.closest('.jp-WindowedPanel-outer').scrollTop = 0;
    return section.getBoundingClientRect().top;
}"""


@pytest.mark.nightly
def test_a_click_on_the_section_to_reread_opens_the_lecture_there(chromium, lab_address):
    with watched(chromium, viewport=WINDOW) as page:
        visit(page, lab_address, SHEET)
        run(page, cell(page, "open_sheet"))
        write(page, cell(page, "screws_1 ="), "screws_1 = np.eye(2)")
        run(page, cell(page, "screws_1 ="))
        run(page, cell(page, "sheet.check(1"))
        link = cell(page, "sheet.check(1").get_by_role("link", name="of lecture 03, Product of exponentials")
        heading = re.search("“(.*)”", link.inner_text())[1]
        with page.expect_popup() as opened:
            link.click()
        section = opened.value.locator("h2", has_text=heading)
        expect(section).to_be_in_viewport(timeout=PAGE_TIMEOUT_MS)
        # on a slow machine, cells that are drawn late move the section out of sight
        assert section.evaluate(SCROLLED_TO_THE_TOP) > WINDOW["height"]
        expect(section).to_be_in_viewport()
        opened.value.keyboard.press("Escape")  # the reader takes over
        assert section.evaluate(SCROLLED_TO_THE_TOP) > WINDOW["height"]
        opened.value.wait_for_timeout(1500)
        expect(section).not_to_be_in_viewport()


@pytest.mark.parametrize("reason", ["full", "private"])
def test_a_browser_that_cannot_store_work_shows_a_message_and_offers_the_download(
    chromium, lab_address, tmp_path, reason
):
    with unwatched(chromium, viewport=WINDOW) as page:
        page.add_init_script("delete globalThis.WebAssembly")  # the lab says so; and no Python has to start
        if reason == "private":
            page.add_init_script("IDBFactory.prototype.open = () => { throw new DOMException('no', 'SecurityError'); }")
        visit(page, lab_address, SHEET)
        page.get_by_text("this browser has no WebAssembly").wait_for(timeout=PAGE_TIMEOUT_MS)
        expect(page).to_have_title(re.compile("^Sheet 03: "))
        if reason == "full":
            write(page, cell(page, "screws_1 ="), "screws_1 = 'early words'")
            wait_for(page, lambda: "early words" in page.evaluate(STORED_NOTEBOOKS), PAGE_TIMEOUT_MS)
            page.evaluate(STORAGE_FULL)
        write(page, cell(page, "screws_1 ="), "screws_1 = 'not to be lost'")
        page.get_by_text("This browser cannot store your work").wait_for(timeout=PAGE_TIMEOUT_MS)
        with page.expect_download() as taken:
            page.get_by_role("button", name="Download the notebook").click()
        taken.value.save_as(tmp_path / "sheet.ipynb")
        assert "not to be lost" in (tmp_path / "sheet.ipynb").read_text("utf-8")


class HoldingHandler(PageHandler):
    """Serves the site, but holds back JupyterLab and Python itself until they are released."""

    def __init__(self, held, *arguments, **settings):
        self.held = held
        super().__init__(*arguments, **settings)

    def do_GET(self):
        if event := self.held.get(urlsplit(self.path).path.rpartition("/")[2]):
            event.wait(2 * PAGE_TIMEOUT_MS / 1000)
        with contextlib.suppress(ConnectionError):  # the page was closed
            super().do_GET()


@pytest.mark.nightly
def test_the_lab_shows_progress_from_the_start_and_works_again_without_a_network(chromium, lab_address, site_folder):
    held = {"bundle.js": threading.Event(), "pyodide.asm.wasm": threading.Event()}
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(HoldingHandler, held, directory=str(site_folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with unwatched(chromium, viewport=PHONE) as page:
        sheet = f"http://127.0.0.1:{server.server_address[1]}/sheets/03_poe_space.html"
        page.goto(sheet)
        page.wait_for_function("navigator.serviceWorker.controller")
        page.goto(
            f"http://127.0.0.1:{server.server_address[1]}/lab/notebooks/index.html?path={SHEET}", wait_until="commit"
        )
        page.frame_locator(".kinlib-preview iframe").get_by_role("heading", name="Problem 2").wait_for()
        status = page.locator(".kinlib-python")
        expect(status).to_contain_text(re.compile(r"Python is loading.* \d+ of \d+ MB"))
        held["bundle.js"].set()
        expect(status).to_contain_text("No data has arrived for 20 seconds.", timeout=PAGE_TIMEOUT_MS)
        expect(page.get_by_role("button", name="Download")).to_be_in_viewport()
        expect(page.locator('[data-command="notebook:run-cell-and-select-next"]')).to_be_in_viewport()  # no Shift key
        expect(page.get_by_text("Not Trusted")).to_have_count(0)
        held["pyodide.asm.wasm"].set()
        write(page, cell(page, "screws_1 ="), "screws_1 = 'typed before Python was there'")
        wait_for(page, lambda: "typed before" in page.evaluate(STORED_NOTEBOOKS), PAGE_TIMEOUT_MS)
        page.locator(".kinlib-python[data-stored]").wait_for(state="attached", timeout=PYTHON_TIMEOUT_MS)

        server.shutdown()
        server.server_close()
        page.reload()
        cell(page, "typed before").wait_for(timeout=PAGE_TIMEOUT_MS)
        expect(status).to_contain_text("Python is starting", timeout=PAGE_TIMEOUT_MS)  # no file is missing
        page.goto(sheet)
        page.get_by_role("heading", name="Problem 2").wait_for()
        assert (
            page.evaluate("navigator.serviceWorker.getRegistrations().then((all) => all.length)") > 2
        )  # and the lab's


def answer_and_check(page):
    """A right and a wrong answer are recognised."""
    from kincourse import open_sheet

    right = open_sheet("03_poe_space", "your id").problem(1).answer.value
    for screws, title in ((-np.array(right), "Not yet"), (np.array(right), "Right")):
        write(page, cell(page, "screws_1 ="), f"screws_1 = np.array({screws.tolist()})")
        run(page, cell(page, "screws_1 ="))
        run(page, cell(page, "sheet.check(1"))
        expect(cell(page, "sheet.check(1").locator("[role=status]")).to_contain_text(title)


def explain_a_prediction(page):
    """The explanation of a prediction opens with the answer."""
    name = "00/joint-3"
    question = cell(page, "screw_2 =")
    write(page, question, f"from kincourse import ask, explain\nscrew_2 = display(ask('{name}'), explain('{name}'))")
    run(page, question)
    question.get_by_text("You have not committed to an answer yet").wait_for(timeout=PAGE_TIMEOUT_MS)
    assert words_of(name) not in question.text_content()
    question.get_by_role("button", name="A", exact=True).click()
    question.get_by_text(words_of(name)).wait_for(timeout=PAGE_TIMEOUT_MS)


def move_a_slider(page):
    """A viewer in the lab: a key pressed on its slider changes the joint value in Python."""
    lines = "from kinlib.view import explore\nscrew_2 = explore(kl.robots.rpr())\nscrew_2"
    write(page, cell(page, "screw_2 ="), lines)
    viewer = cell(page, "screw_2 =")
    run(page, viewer)
    slider = viewer.locator("input[type=range]").first
    slider.wait_for(timeout=PAGE_TIMEOUT_MS)
    slider.focus()
    page.keyboard.press("ArrowRight")
    expected = float(slider.input_value())
    assert expected != 0
    write(page, cell(page, "sheet.show(3)"), "print('q =', screw_2.q[0])")
    printed = cell(page, "'q ='")
    run(page, printed)
    value = re.search(r"q = (\S+)", printed.locator(".jp-OutputArea").inner_text())[1]
    assert float(value) == pytest.approx(expected)


def hand_in(page, folder):
    """The downloaded file is the sheet with the answer, and with all ids and metadata by which it is graded."""
    with page.expect_download() as taken:
        page.get_by_role("button", name="Download").click()
    assert taken.value.suggested_filename == "03_poe_space.ipynb"
    taken.value.save_as(folder / "sheet.ipynb")
    mine = json.loads((folder / "sheet.ipynb").read_text("utf-8"))["cells"]
    theirs = json.loads((ROOT / SHEET).read_text("utf-8"))["cells"]
    assert [(one["id"], one["metadata"].get("nbgrader")) for one in mine] == [
        (one["id"], one["metadata"].get("nbgrader")) for one in theirs
    ]
    assert "screws_1 = np.array" in "".join(mine[4]["source"])


def break_python(page):
    """For a cell that never ends, a message offers to restart Python, and what was typed is kept."""
    page.evaluate("window.shortMinute = true")
    write(page, cell(page, "sheet.show(2)"), "while True: pass")
    run(page, cell(page, "while True"), done=False)
    page.get_by_text("has been running for 60 seconds").wait_for(timeout=PAGE_TIMEOUT_MS)
    page.get_by_role("button", name="Restart Python").click()
    write(page, cell(page, "while True"), "print('back', 6 * 7)")
    run(page, cell(page, "'back'"))
    expect(cell(page, "'back'")).to_contain_text("back 42")
    expect(cell(page, "screws_1 = np.array")).to_be_visible()
    expect(page.get_by_text("has been running for")).to_have_count(0)
