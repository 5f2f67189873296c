"""Lectures, sheets and viewers in JupyterLab: links to a section, explanations that wait, and Python behind a viewer."""

import contextlib
import re
import shutil

import nbformat
import numpy as np
from browser import ROOT, TIMEOUT_MS, jupyterlab, run_cell, watched
from lessons import words_of

import kinlib as kl
from kincourse import find_question

SHEET = "exercises/01_frames/01_frames.ipynb"
KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
CELLS = """
import kinlib as kl
from kincourse import ask, attempt, explain, open_sheet
from kinlib.view import assign, explore, play_assignment
display(ask("00/joint-3"), explain("00/joint-3"))
---
explain("03/climb")
---
changes = []
arm = explore(kl.robots.youbot())
arm.observe(lambda change: changes.append(change.new), 'q')
arm
---
arm.q = [0.1, 0.2, 0.3, 0.4, 0.5]
---
print('heard', len(heard := [*changes]), 'last', [round(x, 3) for x in heard[-1]])
---
robot = open_sheet('07_frame_assignment', 'ada').problem(2).shown["arm"]
hand = assign(robot, 'standard')
hand
---
row_3 = ...
attempt('07.a', row_3)
---
wrong = kl.assign_frames(robot, convention='standard').frames.copy()
wrong[1, :3, 3] += wrong[1, :3, 0]
hand.frames = wrong
---
print([(b.frame, b.rule) for b in hand.breaches])
---
player = play_assignment(robot, convention='standard')
player
---
print(int(player.at))"""
ASKED, EXPLAINED, ARM, MOVED, HEARD, HAND, BLANK, WRONG, BREACHES, PLAYER, STEP = range(11)
"""The cells."""
SIZE = {"width": 1200, "height": 900}
HEADING_TOP = """() => {
    const shown = [...document.querySelectorAll('.jp-NotebookPanel:not(.lm-mod-hidden) h2')];
    const heading = shown.find((one) => one.textContent.startsWith('The inverse'));
    return heading && heading.getBoundingClientRect().top; }"""
THEMES = "@jupyterlab/apputils-extension/themes.jupyterlab-settings"


def test_a_notebook_of_each_kind_in_one_lab(chromium_without_webgl, tmp_path):
    """One visit with one kernel for the notebook of all viewers and another for the sheet, because JupyterLab takes long to start."""
    shutil.copytree(ROOT / "notebooks", tmp_path / "notebooks")
    shutil.copytree(ROOT / "exercises" / "01_frames", tmp_path / "exercises" / "01_frames")
    sheet = tmp_path / SHEET
    sheet.write_text(sheet.read_text("utf-8").replace("back_5 = ...", "back_5 = np.eye(4)"), "utf-8")
    cells = [nbformat.v4.new_code_cell(source.strip()) for source in CELLS.split("---\n")]
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL}), tmp_path / "all.ipynb")
    themes = tmp_path / "config" / "lab" / "user-settings" / THEMES
    themes.parent.mkdir(parents=True)
    themes.write_text('{"theme": "JupyterLab Dark"}', "utf-8")
    with jupyterlab(tmp_path) as address, watched(chromium_without_webgl, viewport=SIZE) as page:
        for _ in range(1200):
            with contextlib.suppress(Exception):
                page.request.get(f"{address}/api", timeout=TIMEOUT_MS)
                break
            page.wait_for_timeout(500)
        opened(page, address, "all.ipynb")
        an_explanation_opens_with_the_answer_or_when_it_is_asked_for(page)
        python_and_the_page_are_synchronized_without_echoes(page)
        a_viewer_follows_the_theme_of_the_lab(page)
        placed_frames_stay_when_a_blank_is_checked_and_the_cell_runs_again(page)
        python_checks_placed_frames(page)
        a_player_handles_arrow_keys(page)
        opened(page, address, SHEET)
        one_click_on_the_section_to_reread_arrives_there(page)


def opened(page, address, path):
    page.goto(f"{address}/lab/tree/{path}?reset", timeout=TIMEOUT_MS)
    page.locator(".jp-Notebook .jp-Cell").first.wait_for(timeout=TIMEOUT_MS)
    page.get_by_text("| Idle").first.wait_for(timeout=TIMEOUT_MS)


def cell(page, which):
    return page.locator(".jp-CodeCell").nth(which)


def run(page, which, selector):
    """Run a cell, and wait for a part of its output."""
    run_cell(page, which)
    shown = cell(page, which).locator(selector).first
    shown.wait_for(timeout=TIMEOUT_MS)
    return shown


def until_printed(page, which, end):
    """Run a cell until its output has this end: the page sends a value only when the kernel has answered the one before."""
    for _ in range(600):
        if (text := run(page, which, ".jp-OutputArea-output").inner_text().strip()).endswith(end):
            return text
        page.wait_for_timeout(500)
    raise AssertionError(f"{text} does not end in {end}")


def an_explanation_opens_with_the_answer_or_when_it_is_asked_for(page):
    asked, other = "00/joint-3", "03/climb"
    waits = ":text('You have not committed to an answer yet')"
    for which in (ASKED, EXPLAINED):
        run(page, which, waits)
    notebook = page.locator(".jp-Notebook")
    assert not [name for name in (asked, other) if words_of(name) in notebook.text_content()]
    right = find_question(asked).right
    row = cell(page, ASKED).locator(".misstep-option-row").nth(int(right == 0))
    row.scroll_into_view_if_needed()
    row.click(position={"x": row.bounding_box()["width"] - 9, "y": 9})  # far from the button
    cell(page, ASKED).get_by_text(words_of(asked)).wait_for()
    # inner_text leaves out a cell that is not drawn
    assert f"but {'ABCDEF'[right]} is right" in cell(page, ASKED).text_content()
    assert words_of(other) not in notebook.text_content()
    cell(page, EXPLAINED).get_by_role("button", name="Show anyway").click()
    cell(page, EXPLAINED).get_by_text(words_of(other)).wait_for()
    assert "Shown without a prediction" in cell(page, EXPLAINED).text_content()


def python_and_the_page_are_synchronized_without_echoes(page):
    model = "document.querySelector('.kv').viewer.model"
    run(page, ARM, "input[type=range]")
    page.evaluate(f"window.changes = 0; {model}.on('change:q', () => {{ window.changes += 1; }})")
    run_cell(page, MOVED)
    page.wait_for_function(f"{model}.get('q')[4] === 0.5", timeout=TIMEOUT_MS)
    pose = page.evaluate("document.querySelector('.kv').viewer.stage.tree.pose()")
    np.testing.assert_allclose(pose, kl.robots.youbot().fk([0.1, 0.2, 0.3, 0.4, 0.5]), atol=1e-12)
    cell(page, ARM).locator("input[type=range]").nth(1).focus()
    for _ in range(5):  # the lab would use the arrow keys itself if the slider did not handle them
        page.keyboard.press("ArrowRight")
    # While the kernel is busy with a value, the page waits; then it sends only the last of the values since.
    wanted = str([0.1, round(0.2 + 5 * np.pi / 180, 3), 0.3, 0.4, 0.5])
    assert 2 <= int(until_printed(page, HEARD, f" last {wanted}").split()[1]) <= 6
    assert page.evaluate("window.changes") == 6, "no echo has arrived"


def a_viewer_follows_the_theme_of_the_lab(page):
    assert page.locator(".kv").get_attribute("data-theme") == "dark"
    page.get_by_role("menuitem", name="Settings").click()
    page.get_by_text("Theme", exact=True).hover()
    page.get_by_text("JupyterLab Light", exact=True).click()
    page.locator(".kv[data-theme=light]").wait_for()


def placed_frames_stay_when_a_blank_is_checked_and_the_cell_runs_again(page):
    run(page, HAND, ".kv-assign")
    chosen = cell(page, HAND).get_by_label("Direction of z 0", exact=True)
    chosen.focus()
    page.keyboard.press("ArrowDown")
    name = chosen.input_value()
    assert name
    run(page, BLANK, ":text('Nothing here yet')")
    assert chosen.input_value() == name
    old = chosen.element_handle()
    run_cell(page, HAND)
    page.wait_for_function("select => !select.isConnected", arg=old, timeout=TIMEOUT_MS)
    chosen.wait_for(timeout=TIMEOUT_MS)
    assert chosen.input_value() == name


def python_checks_placed_frames(page):
    hand = cell(page, HAND)
    check = hand.get_by_role("button", name="Check the rules")
    check.click()
    hand.get_by_text("Not complete yet: frame 0, frame 1, frame 2, frame 3.").wait_for()
    run_cell(page, WRONG)
    hand.get_by_role("button", name="Frame 3, placed").wait_for()
    check.click()
    hand.get_by_role("button", name="Frame 1, breaks a rule").wait_for()
    assert until_printed(page, BREACHES, "]").startswith("[(1, 'origin on axis')")


def a_player_handles_arrow_keys(page):
    run(page, PLAYER, ".kv").get_by_role("button", name="Next step").click()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    cell(page, PLAYER).get_by_text(re.compile("^step 4 of")).wait_for()
    until_printed(page, STEP, "3")


def one_click_on_the_section_to_reread_arrives_there(page):
    for source in ("open_sheet", "given = sheet.given(5)", "sheet.check(5"):
        page.locator(".jp-CodeCell", has=page.locator(".cm-content", has_text=source)).first.locator(
            ".jp-InputArea-editor"
        ).click()
        page.keyboard.press("Control+Enter")
    link = page.get_by_role("link", name="Re-read: section “The inverse” of lecture 01.")
    link.wait_for(timeout=TIMEOUT_MS)
    assert page.locator(".jp-CodeCell [role=status] a").count() == 1
    link.click()
    page.wait_for_url("**/lab/tree/notebooks/01_frames.ipynb", timeout=TIMEOUT_MS)
    page.wait_for_function(
        f"(() => {{ const top = ({HEADING_TOP})(); return 0 < top && top < innerHeight; }})()", timeout=TIMEOUT_MS
    )
