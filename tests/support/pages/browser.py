"""A real browser for tests: Chromium without a graphics card, with no access to any host but this machine.

An error on the console of a page, or a request to another host, fails the test that used the page.
"""

import os
import re
import shutil
import socket
import subprocess
import sys
from contextlib import ExitStack, contextmanager
from functools import cache
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[3]

CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")
CHROMIUM = os.environ.get("KINLIB_CHROMIUM") or next(filter(None, map(shutil.which, CHROMIUM_NAMES)), None)
NO_CHROMIUM = (
    "NOT RUN IN A BROWSER: there is no Chromium on the path. Install it (apt install chromium), or set KINLIB_CHROMIUM."
)

LOCAL = [
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    "--disable-background-networking",
    "--no-first-run",
]
WEBGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
NO_WEBGL = ["--disable-3d-apis"]
TIMEOUT_MS = 300_000
"""How long to wait for anything: every wait ends, but only after what a machine takes that is ten times as slow."""
PYTHON_TIMEOUT_MS = 1_200_000
"""How long Python may take to start on a page: the first start is slow on a busy machine."""


OPENED = ExitStack()
"""Closes Playwright and the browsers that are running."""


@cache
def playwright():
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=TIMEOUT_MS)
    return OPENED.enter_context(sync_playwright())


@cache
def running_browser(webgl):
    """Return the browser with WebGL, or the one without, which starts once. Skip the test if there is no browser."""
    if CHROMIUM is None:
        pytest.skip(NO_CHROMIUM)
    arguments = ["--no-sandbox", *LOCAL, *(WEBGL if webgl else NO_WEBGL)]
    browser = playwright().chromium.launch(executable_path=CHROMIUM, args=arguments)
    OPENED.callback(browser.close)
    return browser


def close_browsers():
    """Close them, because asyncio.run fails while Playwright runs. The next test that needs a browser starts it again."""
    OPENED.close()
    running_browser.cache_clear()
    playwright.cache_clear()


KNOWN_ERRORS = ("Shared module @jupyterlite/services doesn't exist", "Ignored attempt to cancel a touchstart event")
"""Errors of the browser lab's kernel in JupyterLab, which loads every extension of the environment, and of Chromium's own slider
under a finger while the page still scrolls; no script of a page listens to this event."""


@contextmanager
def unwatched(browser, **settings):
    """Open a page that may write errors to its console, because the test breaks something on purpose."""
    context = browser.new_context(**{"viewport": {"width": 640, "height": 480}, **settings})
    context.set_default_timeout(TIMEOUT_MS)
    yield context.new_page()
    context.close()


@contextmanager
def watched(browser, **settings):
    """Open a page, and fail if it writes an error to its console or sends a request to another host."""
    errors, other_hosts = [], []
    with unwatched(browser, **settings) as page:
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        local = ("file:", "data:", "blob:", "http://127.0.0.1", "ws://127.0.0.1")
        page.on("request", lambda request: None if request.url.startswith(local) else other_hosts.append(request.url))
        yield page
    errors = [error for error in errors if not any(known in error for known in KNOWN_ERRORS)]
    assert not errors, f"errors on the console of the page: {errors[:3]}"
    assert not other_hosts, f"the page sent requests to other hosts: {other_hosts[:3]}"


def pose(page, which=0):
    """Read the pose of the tool from a viewer, with all digits."""
    return page.evaluate(f"document.querySelectorAll('.kv')[{which}].viewer.stage.tree.pose()")


def emulate_theme(page, theme):
    """Show a page in a theme, and wait until its colours have faded to it."""
    page.emulate_media(color_scheme=theme)
    page.evaluate(
        """async () => { await new Promise(requestAnimationFrame);
            const fades = document.getAnimations().filter((one) => one instanceof CSSTransition);
            await Promise.all(fades.map((one) => one.finished.catch(() => {}))); }"""
    )


def contrast(text, background):
    """Compute the contrast of two colours by WCAG 2, from 1 to 21."""

    def luminance(colour):
        if colour.startswith("#"):
            values = [int(colour[k : k + 2], 16) for k in (1, 3, 5)]
        else:
            values = [float(x) for x in re.findall(r"[\d.]+", colour)[:3]]
        shares = np.array(values) / 255
        return np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4) @ (0.2126, 0.7152, 0.0722)

    light, dark = sorted((luminance(text), luminance(background)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@contextmanager
def jupyterlab(folder: Path):
    """Serve a folder in JupyterLab on a free port. Yields the address."""
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
        try:
            server.wait(60)
        except subprocess.TimeoutExpired:  # it waits for its kernels, which end by themselves when it is gone
            server.kill()
            server.wait()


def run_cell(page, which: int):
    """Run one cell of the open notebook."""
    page.locator(".jp-CodeCell").nth(which).locator(".jp-InputArea-editor").click()
    page.keyboard.press("Control+Enter")
