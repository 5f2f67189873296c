"""Lectures and sheets in JupyterLab: links to a section, explanations that wait for a prediction, and what is folded."""

import contextlib
import shutil

import nbformat
import pytest
from browser import ROOT, contrast, jupyterlab, watched
from lessons import words_of

from kincourse import find_question

SHEET = "exercises/01_frames/01_frames.ipynb"
LECTURE = "notebooks/00_start_here.ipynb"
KERNEL = {"name": "python3", "display_name": "Python 3", "language": "python"}
PLACING = [
    nbformat.v4.new_code_cell(
        "from kinlib import view\nfrom kinlib.chains.robots import rpr\n\nby_hand = view.assign(rpr(), 'standard')\nby_hand"
    ),
    nbformat.v4.new_code_cell("from kincourse import attempt\n\nrow_3 = ...\nattempt('07.a', row_3)"),
]
FOLDS = [
    nbformat.v4.new_code_cell(
        "'visible'; 'folded'\n'hidden'", metadata={"jupyter": {"source_hidden": True}, "tags": ["hide-input"]}
    ),
    nbformat.v4.new_markdown_cell("## Side track: more", metadata={"jp-MarkdownHeadingCollapsed": True}),
    nbformat.v4.new_markdown_cell("It may be skipped."),
    nbformat.v4.new_markdown_cell("## The main line"),
]

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
    for name, cells in {"folds": FOLDS, "placing": PLACING}.items():
        notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL})
        nbformat.write(notebook, folder / f"{name}.ipynb")
    themes = folder / "config" / "lab" / "user-settings" / THEMES
    themes.parent.mkdir(parents=True)
    themes.write_text('{"theme": "JupyterLab Dark"}', "utf-8")
    with jupyterlab(folder) as address, watched(chromium_without_webgl, viewport=SIZE) as page:
        for _ in range(120):
            with contextlib.suppress(Exception):
                page.request.get(f"{address}/api", timeout=1000)
                break
            page.wait_for_timeout(500)

        def open_file(path):
            page.goto(f"{address}/lab/tree/{path}?reset", timeout=60_000)
            page.locator(".jp-Notebook .jp-Cell").first.wait_for(timeout=60_000)
            return page

        yield open_file


def cell(page, source):
    return page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=source)).first


def run(page, *sources):
    page.get_by_text("| Idle").first.wait_for(timeout=60_000)
    for source in sources:
        cell(page, source).locator(".jp-InputArea-editor").click()
        page.keyboard.press("Control+Enter")


def test_code_and_side_tracks_are_folded_when_a_notebook_is_opened(lab):
    page = lab("folds.ipynb")
    page.get_by_role("heading", name="The main line").wait_for()
    assert page.get_by_role("heading", name="Side track: more").is_visible()
    assert not page.locator("p", has_text="It may be skipped.").is_visible()
    assert page.locator(".jp-Placeholder-content", has_text="visible").is_visible()
    assert not page.locator(".cm-line", has_text="hidden").is_visible()


def test_an_explanation_opens_with_the_answer_or_when_it_is_asked_for(lab):
    page = lab(LECTURE)
    page.get_by_text("| Idle").first.wait_for(timeout=60_000)
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    names = ["00/joint-3", "00/joint-5"]
    cards = [cell(page, f'explain("{name}")') for name in names]
    for name, card in zip(names, cards, strict=True):
        card.get_by_text("You have not committed to an answer yet").wait_for(timeout=60_000)
        assert words_of(name) not in page.locator(".jp-Notebook").text_content()
    right = find_question(names[0]).right
    cell(page, f'ask("{names[0]}")').get_by_role("button", name="AB"[right == 0], exact=True).click()
    cards[0].get_by_text(words_of(names[0])).wait_for()
    assert "is right" in cards[0].text_content()  # inner_text leaves out a cell that is not drawn
    assert words_of(names[1]) not in page.locator(".jp-Notebook").text_content()
    cards[1].get_by_role("button", name="Show anyway").click()
    cards[1].get_by_text(words_of(names[1])).wait_for()
    assert "Shown without a prediction" in cards[1].text_content()
    assert_readable(page, cards[0].locator("[role=status]"))


def assert_readable(page, card):
    """In the dark theme a card is dark, and its title and text contrast with it."""
    background = painted(page, card, "backgroundColor")
    assert max(background) < 100
    for text in (card, card.locator("p").first):
        colour = painted(page, text, "color")
        assert contrast(f"rgb{colour}", f"rgb{background}") >= 4.5


def painted(page, element, style):
    """Return a colour of an element as it is painted on a black page, in whole numbers from 0 to 255."""
    return tuple(
        page.evaluate(
            """([element, style]) => {
                const pen = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d');
                for (const colour of ['black', getComputedStyle(element)[style]]) {
                    pen.fillStyle = colour;
                    pen.fillRect(0, 0, 1, 1);
                }
                return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3); }""",
            [element.element_handle(), style],
        )
    )


def test_one_click_on_the_section_to_reread_arrives_there(lab):
    page = lab(SHEET)
    run(page, "open_sheet")
    page.get_by_text("9 problems, ").wait_for(timeout=60_000)
    run(page, "given = sheet.given(5)", "sheet.check(5")
    link = page.get_by_role("link", name="Re-read: lecture 01_frames, section “The inverse”.")
    link.wait_for(timeout=60_000)
    assert page.locator(".jp-CodeCell [role=status] a").count() == 1
    link.click()
    page.wait_for_url("**/lab/tree/notebooks/01_frames.ipynb", timeout=60_000)
    page.wait_for_function(
        f"(() => {{ const top = ({HEADING_TOP})(); return 0 < top && top < innerHeight; }})()", timeout=60_000
    )


def test_frames_placed_by_hand_stay_when_a_blank_is_checked_and_the_cell_runs_again(lab):
    page = lab("placing.ipynb")
    run(page, "by_hand = view.assign")
    placing = cell(page, "by_hand = view.assign")
    chosen = placing.locator(".kv-assign select").nth(1)
    chosen.wait_for(timeout=60_000)
    chosen.focus()
    page.keyboard.press("ArrowDown")
    name = chosen.input_value()
    assert name
    run(page, "row_3 = ...")
    cell(page, "row_3 = ...").get_by_text("Nothing here yet").wait_for(timeout=60_000)
    assert chosen.input_value() == name
    old = chosen.element_handle()
    run(page, "by_hand = view.assign")
    page.wait_for_function("select => !select.isConnected", arg=old, timeout=60_000)
    chosen.wait_for(timeout=60_000)
    assert chosen.input_value() == name
