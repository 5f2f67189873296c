"""The lab in the browser: a sheet is opened from its page, answered, checked, kept and taken away, and nothing that fails is silent.

One notebook here; `tests/browser/every_notebook_in_the_browser.py` runs them all.
"""

import json
import re
from contextlib import contextmanager

import numpy as np
import pytest
from browser import browsers, watched
from built_site import ROOT, build_site, served
from lab_page import LOOK, cell, run, visit, wait_for, write
from playwright.sync_api import expect

SHEET = "exercises/03_poe_space/03_poe_space.ipynb"

IMPATIENT = """const patient = setTimeout;
setTimeout = (act, wait, ...more) => patient(act, window.impatient && wait === 60000 ? 1000 : wait, ...more)"""
"""A minute that passes in a second, once somebody is impatient."""

FULL = "() => { IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); }; }"

KEPT = """async () => {
    const asked = (request) => new Promise((done, failed) => { request.onsuccess = () => done(request.result); request.onerror = failed; });
    const name = (await indexedDB.databases()).map(({ name }) => name).find((name) => name.startsWith('JupyterLite Storage'));
    const store = (await asked(indexedDB.open(name))).transaction('files').objectStore('files');
    return JSON.stringify(await asked(store.getAll()));
}"""
"""What the browser has stored of notebooks."""


@pytest.fixture(scope="module")
def address():
    folder = build_site()
    if not (folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be fetched.")
    with served(folder) as address:
        yield address


@pytest.fixture(scope="module")
def start():
    with browsers() as start:
        yield start


def test_a_sheet_is_opened_answered_checked_kept_and_handed_in(start, address, tmp_path):
    """One student's evening, in one window: Python takes a while to come, so it comes once."""
    with watched(start(), viewport={"width": 1200, "height": 1000}) as page:
        page.set_default_timeout(LOOK)
        page.add_init_script(IMPATIENT)
        page.goto(f"{address}/sheets/03_poe_space.html")
        page.get_by_role("link", name="Run in the browser").click()
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=LOOK)
        run(page, cell(page, "open_sheet"))
        assert "8 problems, 24 points" in cell(page, "open_sheet").inner_text()

        answer_and_check(page)
        move_a_slider(page)
        hand_in(page, tmp_path)
        break_python(page)

        # what was typed last is kept without anybody having saved it, and what was solved is known on the pages
        write(page, cell(page, "screw_3 ="), "screw_3 = 'typed last'")
        wait_for(page, lambda: "typed last" in page.evaluate(KEPT), LOOK)
        visit(page, address, SHEET)
        expect(cell(page, "typed last")).to_be_visible()
        expect(cell(page, "screws_1 = np.array")).to_be_visible()
        page.goto(f"{address}/progress.html")
        expect(page.locator('tr[data-lecture="lectures/03_poe_space"] [data-solved]')).to_have_text("1 of 8")


@pytest.mark.parametrize("reason", ["full", "private"])
def test_a_browser_that_keeps_nothing_says_so_and_gives_the_file(start, address, tmp_path, reason):
    with failing(start(), address) as page:
        if reason == "private":
            page.add_init_script("IDBFactory.prototype.open = () => { throw new DOMException('no', 'SecurityError'); }")
        visit(page, address, SHEET)
        if reason == "full":
            write(page, cell(page, "screws_1 ="), "screws_1 = 'early words'")
            wait_for(page, lambda: "early words" in page.evaluate(KEPT), LOOK)
            page.evaluate(FULL)
        write(page, cell(page, "screws_1 ="), "screws_1 = 'not to be lost'")
        page.get_by_text("This browser cannot store your work").wait_for(timeout=LOOK)
        with page.expect_download() as taken:
            page.get_by_role("button", name="Download the notebook").click()
        taken.value.save_as(tmp_path / "sheet.ipynb")
        assert "not to be lost" in (tmp_path / "sheet.ipynb").read_text("utf-8")


def test_a_browser_without_webassembly_says_what_to_do(start, address):
    with failing(start(), address) as page:
        page.add_init_script("delete globalThis.WebAssembly")
        visit(page, address, SHEET)
        page.get_by_text("this browser has no WebAssembly").wait_for(timeout=LOOK)


@contextmanager
def failing(browser, address):
    """A page that may complain on its console: something is wrong with it on purpose."""
    context = browser.new_context(viewport={"width": 1200, "height": 1000})
    yield context.new_page()
    context.close()


def answer_and_check(page):
    """A wrong answer is explained, a right one is praised."""
    from kincourse import open_sheet

    right = open_sheet("03_poe_space", "your id").problem(1).answer.value
    for screws, told in ((-np.array(right), "Not yet"), (np.array(right), "Right")):
        write(page, cell(page, "screws_1 ="), f"screws_1 = np.array({screws.tolist()})")
        run(page, cell(page, "screws_1 ="))
        run(page, cell(page, "sheet.check(1"))
        expect(cell(page, "sheet.check(1").locator("[role=status]")).to_contain_text(told)


def move_a_slider(page):
    """A viewer in the lab: the key on its slider reaches Python, and comes back as a pose."""
    lines = "from kinlib.view import explore\nscrew_2 = explore(kl.robots.rpr())\nscrew_2"
    write(page, cell(page, "screw_2 ="), lines)
    viewer = cell(page, "screw_2 =")
    run(page, viewer)
    slider = viewer.locator("input[type=range]").first
    slider.wait_for(timeout=LOOK)
    slider.focus()
    page.keyboard.press("ArrowRight")
    wanted = float(slider.input_value())
    assert wanted != 0
    write(page, cell(page, "sheet.show(3)"), "print('heard', screw_2.q[0])")
    run(page, cell(page, "'heard'"))
    assert float(
        re.search(r"heard (\S+)", cell(page, "'heard'").locator(".jp-OutputArea").inner_text())[1]
    ) == pytest.approx(wanted)


def hand_in(page, folder):
    """The file that comes out is the sheet, with the answer, and with every mark by which it is graded."""
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
    """A cell that never ends: a message offers another Python, and what was typed outlives it."""
    page.evaluate("window.impatient = true")
    write(page, cell(page, "sheet.show(2)"), "while True: pass")
    run(page, cell(page, "while True"), done=False)
    page.get_by_text("has been running for 60 seconds").wait_for(timeout=LOOK)
    page.get_by_role("button", name="Restart Python").click()
    write(page, cell(page, "while True"), "print('back', 6 * 7)")
    run(page, cell(page, "'back'"))
    expect(cell(page, "'back'")).to_contain_text("back 42")
    expect(cell(page, "screws_1 = np.array")).to_be_visible()
    expect(page.get_by_text("has been running for")).to_have_count(0)
