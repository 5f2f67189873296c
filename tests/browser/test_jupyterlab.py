"""Lectures, sheets and viewers in JupyterLab: links to a section, explanations that wait, and Python behind a viewer."""

import contextlib
import shutil

import nbformat
import numpy as np
import pytest
from browser import ROOT, TIMEOUT_MS, jupyterlab, pose, run_cell, watched
from lessons import words_of

import kinlib as kl
from kincourse import find_question

SHEET = "exercises/01_frames/01_frames.ipynb"
KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
PLACING = [
    nbformat.v4.new_code_cell(
        "from kinlib import view\nfrom kinlib.chains.robots import rpr\n\nby_hand = view.assign(rpr(), 'standard')\nby_hand"
    ),
    nbformat.v4.new_code_cell("from kincourse import attempt\n\nrow_3 = ...\nattempt('07.a', row_3)"),
]
PREDICTIONS = """
from kincourse import ask, explain
display(ask("00/joint-3"), explain("00/joint-3"))
---
ask("03/climb")
---
explain("03/climb")"""
VIEWER = """
import kinlib as kl
from kinlib.view import explore
changes = []
arm = explore(kl.robots.youbot())
arm.observe(lambda change: changes.append(change.new), 'q')
arm
---
arm.q = [0.1, 0.2, 0.3, 0.4, 0.5]
---
print('heard', len(changes), 'last', [round(x, 3) for x in arm.q])"""
BY_HAND = """
import kinlib as kl
from kincourse import open_sheet
from kinlib.view import assign, play_assignment
sheet = open_sheet('07_frame_assignment', 'ada')
robot = sheet.problem(2).shown["arm"]
hand = assign(robot, 'standard')
hand
---
right = kl.assign_frames(robot, convention='standard').frames.copy()
wrong = right.copy()
wrong[1, :3, 3] += right[1, :3, 0]
hand.frames = wrong
---
print([(b.frame, b.rule) for b in hand.breaches])
---
hand.frames = right
verdict = sheet.check(2, hand.frames)
print(verdict.judgement.state, bool(kl.equivalent(hand.table, robot)))
---
player = play_assignment(robot, convention='standard')
player
---
print(int(player.at))"""


def cells_of(script):
    return [nbformat.v4.new_code_cell(source.strip()) for source in script.split("---\n")]


SIZE = {"width": 1200, "height": 900}
HEADING_TOP = """() => {
    const shown = [...document.querySelectorAll('.jp-NotebookPanel:not(.lm-mod-hidden) h2')];
    const heading = shown.find((one) => one.textContent.startsWith('The inverse'));
    return heading && heading.getBoundingClientRect().top; }"""
THEMES = "@jupyterlab/apputils-extension/themes.jupyterlab-settings"


@pytest.fixture(scope="module")
def lab(chromium_without_webgl, tmp_path_factory):
    """Serve lectures and a sheet in JupyterLab, as in the repository."""
    folder = tmp_path_factory.mktemp("lab")
    shutil.copytree(ROOT / "notebooks", folder / "notebooks")
    shutil.copytree(ROOT / "exercises" / "01_frames", folder / "exercises" / "01_frames")
    sheet = folder / SHEET
    sheet.write_text(sheet.read_text("utf-8").replace("back_5 = ...", "back_5 = np.eye(4)"), "utf-8")
    for name, cells in {
        "placing": PLACING,
        "viewer": cells_of(VIEWER),
        "by_hand": cells_of(BY_HAND),
        "predictions": cells_of(PREDICTIONS),
    }.items():
        notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL})
        nbformat.write(notebook, folder / f"{name}.ipynb")
    themes = folder / "config" / "lab" / "user-settings" / THEMES
    themes.parent.mkdir(parents=True)
    themes.write_text('{"theme": "JupyterLab Dark"}', "utf-8")
    with jupyterlab(folder) as address, watched(chromium_without_webgl, viewport=SIZE) as page:
        for _ in range(1200):
            with contextlib.suppress(Exception):
                page.request.get(f"{address}/api", timeout=TIMEOUT_MS)
                break
            page.wait_for_timeout(500)

        def open_file(path):
            page.goto(f"{address}/lab/tree/{path}?reset", timeout=TIMEOUT_MS)
            page.locator(".jp-Notebook .jp-Cell").first.wait_for(timeout=TIMEOUT_MS)
            return page

        yield open_file


def cell(page, source):
    return page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=source)).first


def run(page, *sources):
    page.get_by_text("| Idle").first.wait_for(timeout=TIMEOUT_MS)
    for source in sources:
        cell(page, source).locator(".jp-InputArea-editor").click()
        page.keyboard.press("Control+Enter")


def test_an_explanation_opens_with_the_answer_or_when_it_is_asked_for(lab):
    page = lab("predictions.ipynb")
    page.get_by_text("| Idle").first.wait_for(timeout=TIMEOUT_MS)
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    names = ["00/joint-3", "03/climb"]
    cards = [cell(page, f'explain("{name}")') for name in names]
    for name, card in zip(names, cards, strict=True):
        card.get_by_text("You have not committed to an answer yet").wait_for(timeout=TIMEOUT_MS)
        assert words_of(name) not in page.locator(".jp-Notebook").text_content()
    right = find_question(names[0]).right
    row = cell(page, f'ask("{names[0]}")').locator(".misstep-option-row").nth(int(right == 0))
    row.scroll_into_view_if_needed()
    row.click(position={"x": row.bounding_box()["width"] - 9, "y": 9})  # far from the button
    cards[0].get_by_text(words_of(names[0])).wait_for()
    assert (
        f"but {'ABCDEF'[right]} is right" in cards[0].text_content()
    )  # inner_text leaves out a cell that is not drawn
    assert words_of(names[1]) not in page.locator(".jp-Notebook").text_content()
    cards[1].get_by_role("button", name="Show anyway").click()
    cards[1].get_by_text(words_of(names[1])).wait_for()
    assert "Shown without a prediction" in cards[1].text_content()


def test_one_click_on_the_section_to_reread_arrives_there(lab):
    page = lab(SHEET)
    run(page, "open_sheet")
    page.get_by_text("11 problems, ").wait_for(timeout=TIMEOUT_MS)
    run(page, "given = sheet.given(5)", "sheet.check(5")
    link = page.get_by_role("link", name="Re-read: section “The inverse” of lecture 01, Frames.")
    link.wait_for(timeout=TIMEOUT_MS)
    assert page.locator(".jp-CodeCell [role=status] a").count() == 1
    link.click()
    page.wait_for_url("**/lab/tree/notebooks/01_frames.ipynb", timeout=TIMEOUT_MS)
    page.wait_for_function(
        f"(() => {{ const top = ({HEADING_TOP})(); return 0 < top && top < innerHeight; }})()", timeout=TIMEOUT_MS
    )


def test_frames_placed_by_hand_stay_when_a_blank_is_checked_and_the_cell_runs_again(lab):
    page = lab("placing.ipynb")
    run(page, "by_hand = view.assign")
    placing = cell(page, "by_hand = view.assign")
    chosen = placing.locator(".kv-assign select").nth(1)
    chosen.wait_for(timeout=TIMEOUT_MS)
    chosen.focus()
    page.keyboard.press("ArrowDown")
    name = chosen.input_value()
    assert name
    run(page, "row_3 = ...")
    cell(page, "row_3 = ...").get_by_text("Nothing here yet").wait_for(timeout=TIMEOUT_MS)
    assert chosen.input_value() == name
    old = chosen.element_handle()
    run(page, "by_hand = view.assign")
    page.wait_for_function("select => !select.isConnected", arg=old, timeout=TIMEOUT_MS)
    chosen.wait_for(timeout=TIMEOUT_MS)
    assert chosen.input_value() == name


# --- viewers ---

MODEL = "document.querySelector('.kv').viewer.model"


def run_first(page):
    """Run the first cell, and wait for its viewer."""
    page.get_by_text("| Idle").first.wait_for(timeout=TIMEOUT_MS)
    run_cell(page, 0)
    page.wait_for_selector(".kv-canvas[data-pictures]", timeout=TIMEOUT_MS)
    return page


def printed(page, which):
    output = page.locator(".jp-CodeCell").nth(which).locator(".jp-OutputArea-output")
    output.wait_for()
    return output.inner_text().strip()


def until_printed(page, which, end):
    """Run a cell until its output has this end: the page sends a value only when the kernel has answered the one before."""
    for _ in range(600):
        run_cell(page, which)
        if (text := printed(page, which)).endswith(end):
            return text
        page.wait_for_timeout(500)
    raise AssertionError(f"{text} does not end in {end}")


def test_python_and_the_page_are_synchronized_without_echoes(lab):
    page = run_first(lab("viewer.ipynb"))
    page.evaluate(f"window.changes = 0; {MODEL}.on('change:q', () => {{ window.changes += 1; }})")
    run_cell(page, 1)
    page.wait_for_function(f"{MODEL}.get('q')[4] === 0.5", timeout=TIMEOUT_MS)
    np.testing.assert_allclose(pose(page), kl.robots.youbot().fk([0.1, 0.2, 0.3, 0.4, 0.5]), atol=1e-12)
    page.locator(".kv input[type=range]").nth(1).focus()
    for _ in range(5):  # the lab would use the arrow keys itself if the slider did not handle them
        page.keyboard.press("ArrowRight")
    # While the kernel is busy with a value, the page waits; then it sends only the last of the values since.
    wanted = str([0.1, round(0.2 + 5 * np.pi / 180, 3), 0.3, 0.4, 0.5])
    assert 2 <= int(until_printed(page, 2, f" last {wanted}").split()[1]) <= 6
    assert page.evaluate("window.changes") == 6, "no echo has arrived"


def test_python_checks_placed_frames_the_sheet_accepts_them_and_a_player_handles_arrow_keys(lab):
    page = run_first(lab("by_hand.ipynb"))
    check = page.get_by_role("button", name="Check the rules")
    page.get_by_label("Direction of z 0", exact=True).select_option(index=1)
    check.click()
    page.get_by_text("No rule is broken so far. Not complete yet: frame 0, frame 1, frame 2, frame 3.").wait_for()
    run_cell(page, 1)
    page.get_by_role("button", name="Frame 3, placed").wait_for()
    check.click()
    breach = page.get_by_role("button", name="✕ joint 2")
    breach.wait_for()
    assert page.get_by_role("button", name="Frame 1, breaks a rule").is_visible()
    run_cell(page, 2)
    assert printed(page, 2).startswith("[(1, 'origin on axis')")
    breach.click()
    page.get_by_label("Origin of frame 1", exact=True).select_option(index=1)
    page.get_by_text("Check again.").wait_for()
    run_cell(page, 3)
    assert printed(page, 3) == "right True"
    check.click()
    page.get_by_text("Every rule holds:").wait_for()
    assert page.locator(".kv-dh tr").count() == 4
    run_cell(page, 4)
    player = page.locator(".kv").nth(1)
    player.get_by_role("button", name="Next step").click()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    player.get_by_text("step 4 of").wait_for()
    until_printed(page, 5, "3")


def test_a_viewer_follows_the_theme_of_the_lab(lab):
    page = run_first(lab("viewer.ipynb"))
    assert page.locator(".kv").get_attribute("data-theme") == "dark"
    page.get_by_role("menuitem", name="Settings").click()
    page.get_by_text("Theme", exact=True).hover()
    page.get_by_text("JupyterLab Light", exact=True).click()
    page.locator(".kv[data-theme=light]").wait_for()
