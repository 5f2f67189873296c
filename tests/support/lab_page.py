"""A notebook of the browser lab, as a person handles it: found on its page, run, typed into, read."""

import re

BOOT = 240_000
"""How long Python may take to come, in milliseconds: a cold start is slow where cores are shared."""

LOOK = 60_000
"""How long JupyterLab may take to draw itself."""


def visit(page, address, notebook):
    page.set_default_timeout(LOOK)
    page.goto(f"{address}/lab/notebooks/index.html?path={notebook}")
    page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=LOOK)


def cell(page, text):
    """The one code cell that holds a text."""
    return page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=text)).first


def run(page, which, done=True):
    """Run one cell, and wait until it has run."""
    before = prompt(which)
    which.locator(".cm-content").click()
    page.keyboard.press("Control+Enter")
    if done:
        wait_for(page, lambda: re.fullmatch(r"\[\d+\]:", prompt(which)) and prompt(which) != before, BOOT)


def prompt(which):
    return which.locator(".jp-InputPrompt").inner_text().strip()


def write(page, which, text):
    """Replace what a cell says."""
    which.locator(".cm-content").click()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


def run_all(page):
    """Run every cell, and wait for the last. Gives what went wrong: tracebacks, and what was said on stderr."""
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    prompts = page.locator(".jp-CodeCell .jp-InputPrompt")
    wait_for(page, lambda: all(re.fullmatch(r"\[\d+\]:", text.strip()) for text in prompts.all_inner_texts()), BOOT)
    return faults(page)


def faults(page):
    wrong = page.locator(".jp-OutputArea-output[data-mime-type$=error], .jp-OutputArea-output[data-mime-type$=stderr]")
    return [text for text in wrong.all_inner_texts() if "building the font cache" not in text]


def wait_for(page, holds, milliseconds):
    """Wait until something holds; polled, since it may be asked of Python."""
    for _ in range(milliseconds // 100):
        if holds():
            return
        page.wait_for_timeout(100)
    raise TimeoutError(f"waited {milliseconds / 1000:.0f} s in vain; on the page: {faults(page)}")
