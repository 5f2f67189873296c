"""The link on a card in JupyterLab: a click opens the lecture, and in an open lecture it scrolls to the section."""

import contextlib
import shutil

import pytest
from browser import ROOT, jupyterlab, run_cell, watched

SHEET = "exercises/01_frames/01_frames.ipynb"

SIZE = {"width": 1200, "height": 900}
HEADING_TOP = """() => {
    const shown = [...document.querySelectorAll('.jp-NotebookPanel:not(.lm-mod-hidden) h2')];
    const heading = shown.find((one) => one.textContent.startsWith('The inverse'));
    return heading && heading.getBoundingClientRect().top; }"""


@pytest.fixture
def sheet_page(chromium_without_webgl, tmp_path):
    """Open a sheet beside the lectures, as in the repository."""
    shutil.copytree(ROOT / "notebooks", tmp_path / "notebooks")
    shutil.copytree(ROOT / "exercises" / "01_frames", tmp_path / "exercises" / "01_frames")
    sheet = tmp_path / SHEET
    sheet.write_text(sheet.read_text("utf-8").replace("back_5 = ...", "back_5 = np.eye(4)"), "utf-8")
    with jupyterlab(tmp_path) as address, watched(chromium_without_webgl, viewport=SIZE) as page:
        for _ in range(120):
            with contextlib.suppress(Exception):
                page.request.get(f"{address}/api", timeout=1000)
                break
            page.wait_for_timeout(500)
        page.goto(f"{address}/lab/tree/{SHEET}?reset", timeout=60_000)
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=60_000)
        page.get_by_text("| Idle").first.wait_for(timeout=60_000)
        yield page


def test_the_section_to_reread_is_one_click_away(sheet_page):
    page = sheet_page
    run_cell(page, 0)
    page.get_by_text("9 problems, 19 points").wait_for(timeout=60_000)
    for source in ("given = sheet.given(5)", "sheet.check(5"):
        cell = page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=source)).first
        cell.locator(".jp-InputArea-editor").click()
        page.keyboard.press("Control+Enter")
    link = page.get_by_role("link", name="Re-read: lecture 01_frames, section “The inverse”.")
    link.wait_for(timeout=60_000)
    assert page.locator(".jp-CodeCell [role=status] a").count() == 1
    link.click()
    page.wait_for_url("**/lab/tree/notebooks/01_frames.ipynb", timeout=60_000)
    page.locator(".jp-NotebookPanel:not(.lm-mod-hidden) h1", has_text="Frames").wait_for()
    # JupyterLab scrolls to a section only in a notebook that has been drawn, and drawing takes a while
    for _ in range(10):
        page.wait_for_timeout(2000)
        if 0 < (page.evaluate(HEADING_TOP) or 0) < SIZE["height"]:
            break
        page.locator(".lm-TabBar-tab", has_text="01_frames.ipynb").first.click()
        link.click()
    assert 0 < page.evaluate(HEADING_TOP) < SIZE["height"]
