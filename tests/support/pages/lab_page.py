"""Use a notebook of the browser lab as a student does: open it, run cells, type, read the outputs."""

PYTHON_TIMEOUT_MS = 1_200_000
"""How long Python may take to start: the first start is slow on a busy machine."""

PAGE_TIMEOUT_MS = 600_000
"""How long JupyterLab may take to draw its page."""


def visit(page, address, notebook):
    page.set_default_timeout(PAGE_TIMEOUT_MS)
    page.goto(f"{address}/lab/notebooks/index.html?path={notebook}")
    page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=PAGE_TIMEOUT_MS)


def cell(page, text):
    """Find the first code cell that contains a text."""
    return page.locator(".jp-CodeCell").filter(has=page.locator(".cm-content", has_text=text)).first


def write(page, which, text):
    """Replace the text of a cell."""
    which.locator(".cm-content").click()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


def failures(page):
    wrong = page.locator(".jp-OutputArea-output[data-mime-type$=error], .jp-OutputArea-output[data-mime-type$=stderr]")
    return [text for text in wrong.all_inner_texts() if "building the font cache" not in text]


def wait_for(page, holds, milliseconds):
    """Wait until a condition holds. It is polled from Python, because it may depend on more than the page."""
    for _ in range(milliseconds // 100):
        if holds():
            return
        page.wait_for_timeout(100)
    raise TimeoutError(f"waited {milliseconds / 1000:.0f} s without success; on the page: {failures(page)}")
