"""A real browser for tests: Chromium, drawing without a graphics card, that reaches nothing but this machine.

Every page is watched: an error on its console or a request to another host fails the test that used it.
"""

import contextlib
import os
import re
import shutil
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")
CHROMIUM = os.environ.get("KINLIB_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
NONE = "NOT RUN IN A BROWSER: there is no Chromium on the path. Install one (apt install chromium), or name it in KINLIB_CHROMIUM."

LOCAL = [
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    "--disable-background-networking",
    "--no-first-run",
]
DRAWN = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
NOT_DRAWN = ["--disable-3d-apis"]
SECONDS = 20_000
"""How long to wait for anything, in milliseconds: every wait ends."""


@contextmanager
def browsers():
    """Give a function that starts browsers, with WebGL or without; or skip, loudly, where there is none."""
    if CHROMIUM is None:
        pytest.skip(NONE)
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        started = []

        def start(webgl=True):
            arguments = ["--no-sandbox", *LOCAL, *(DRAWN if webgl else NOT_DRAWN)]
            started.append(playwright.chromium.launch(executable_path=CHROMIUM, args=arguments))
            return started[-1]

        yield start
        for browser in started:
            browser.close()


NOT_AT_HOME = "Shared module @jupyterlite/services doesn't exist"
"""What the kernel of the browser lab says in JupyterLab, which loads every extension of the environment."""


@contextmanager
def watched(browser, **settings):
    """Open a page, and fail if it complains or asks anybody but this machine."""
    context = browser.new_context(**{"viewport": {"width": 720, "height": 560}, **settings})
    context.set_default_timeout(SECONDS)
    page = context.new_page()
    complaints, strangers = [], []
    page.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    local = ("file:", "data:", "blob:", "http://127.0.0.1", "ws://127.0.0.1")
    page.on("request", lambda request: None if request.url.startswith(local) else strangers.append(request.url))
    yield page
    context.close()
    complaints = [complaint for complaint in complaints if NOT_AT_HOME not in complaint]
    assert not complaints, f"the page complains: {complaints[:3]}"
    assert not strangers, f"the page asks other hosts: {strangers[:3]}"


def static_page(folder: Path, *viewers, style="background:white") -> Path:
    """Write a page without a kernel that holds viewers, with the files that it needs beside it."""
    from kinlib.view.viewer.viewer import STATIC

    shutil.copytree(STATIC, folder / "static", dirs_exist_ok=True)
    page = folder / "page.html"
    body = "\n".join(viewer if isinstance(viewer, str) else viewer.html() for viewer in viewers)
    head = '<!doctype html><html lang="en"><meta charset="utf-8"><title>Arms</title><link rel="icon" href="data:,">'
    loader = '<script src="static/loader.js"></script>'
    page.write_text(f'{head}<body style="{style}"><main>{body}</main>{loader}</body></html>', "utf-8")
    return page


def pictures(page, which=0):
    """How many pictures a viewer has painted."""
    return int(page.locator(".kv-canvas").nth(which).get_attribute("data-pictures") or 0)


def awake(page, count=1):
    """Wait until so many viewers have drawn a picture."""
    page.wait_for_function(f"document.querySelectorAll('.kv-canvas[data-pictures]').length >= {count}", timeout=SECONDS)


def pose(page, which=0):
    """The tool's pose of a viewer, every digit of it."""
    return page.evaluate(f"document.querySelectorAll('.kv')[{which}].viewer.stage.tree.pose()")


def texts(page):
    """Every text of the viewers on a page, with its colour and that of the paper behind it."""
    return page.evaluate(
        """(() => {
            const paper = (node) => { for (; node; node = node.parentElement) {
                const colour = getComputedStyle(node).backgroundColor; if (!/, 0\\)$|transparent/.test(colour)) return colour; } };
            const texts = [...document.querySelectorAll('.kv *')].filter((node) => node.offsetParent
                && [...node.childNodes].some((child) => child.nodeType === 3 && child.data.trim()));
            return texts.map((node) => [node.textContent, getComputedStyle(node).color, paper(node)]); })()"""
    )


def contrast(ink, paper):
    """Of two colours, by WCAG 2: from 1 to 21."""

    def luminance(colour):
        if colour.startswith("#"):
            values = [int(colour[k : k + 2], 16) for k in (1, 3, 5)]
        else:
            values = [float(x) for x in re.findall(r"[\d.]+", colour)[:3]]
        shares = np.array(values) / 255
        return np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4) @ (0.2126, 0.7152, 0.0722)

    light, dark = sorted((luminance(ink), luminance(paper)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def cut_off(page):
    """What of the viewers reaches beyond the right border of a page."""
    return page.evaluate(
        """[...document.querySelectorAll('.kv *')].filter((node) => node.getBoundingClientRect().right > innerWidth
            && !node.closest('.kv-spoken')).map((node) => node.className)"""
    )


@contextmanager
def jupyterlab(folder: Path):
    """Serve a folder in JupyterLab on a port of its own. Gives the address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    settings = {
        "PYTHONPATH": str(ROOT),
        "JUPYTER_CONFIG_DIR": str(folder / "config"),
        "JUPYTER_DATA_DIR": str(folder / "data"),
    }
    server = subprocess.Popen(
        [
            *(sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", f"--port={port}"),
            *("--ServerApp.port_retries=0", "--IdentityProvider.token=", f"--ServerApp.root_dir={folder}"),
            *("--LabApp.news_url=", "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate"),
        ],
        env={**os.environ, **settings},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield f"http://127.0.0.1:{port}"
    finally:
        server.terminate()
        server.wait(20)


def open_notebook(page, address: str, folder: Path, cells):
    """Write a notebook, open it in a lab that has just been started, and wait for its kernel."""
    import nbformat

    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), folder / "notebook.ipynb")
    for _ in range(120):
        with contextlib.suppress(Exception):
            page.request.get(f"{address}/api", timeout=1000)
            break
        time.sleep(0.5)
    page.goto(f"{address}/doc/tree/notebook.ipynb?reset", timeout=60_000)
    page.locator(".jp-Notebook .jp-CodeCell").nth(len(cells) - 1).wait_for(timeout=60_000)
    page.get_by_text("| Idle").wait_for(timeout=60_000)


def run_cell(page, which: int):
    """Run one cell of the open notebook."""
    page.locator(".jp-CodeCell").nth(which).locator(".jp-InputArea-editor").click()
    page.keyboard.press("Control+Enter")
