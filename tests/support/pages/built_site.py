"""The site for tests: built once in each test run, by the first worker that needs it, and served to this machine only."""

import os
import sqlite3
import subprocess
import sys
import threading
from contextlib import contextmanager
from functools import cache, partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from browser import CHROMIUM
from kinsite.browser_lab import lab

ROOT = Path(__file__).parents[3]
SITE = ROOT / "site"

FOLDER = ROOT / "build" / "site" / "html"
TEST_RUN_FILE = FOLDER.parent / "test_run.txt"
"""Contains the id of the test run that has built the site, so that the other workers of the same run do not build it again."""
PHONE = {"width": 360, "height": 780}
DESKTOP = {"width": 1200, "height": 900}
"""Sizes of the windows in which tests open its pages."""
TIMEOUT_S = 3600
"""How long to wait for a build, by this worker or another: a build that never ends must not block CI."""


@cache
def build_site() -> Path:
    """Build the pages and, if there is a browser to open it, the lab that needs package registries only.

    The first caller in a test run builds the site; the others wait for it, and use the same folder.
    """
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    test_run = os.environ.get("PYTEST_XDIST_TESTRUNUID", "")
    # a lock that works on every system, and that is released when its owner ends
    lock = sqlite3.connect(FOLDER.parent / "lock", timeout=TIMEOUT_S, isolation_level=None)
    lock.execute("BEGIN EXCLUSIVE")
    try:
        if test_run and TEST_RUN_FILE.exists() and TEST_RUN_FILE.read_text("utf-8") == test_run:
            return FOLDER
        TEST_RUN_FILE.unlink(missing_ok=True)
        done = build("offline" if CHROMIUM else "none")
        if done.returncode and "could not download" in done.stderr and not os.environ.get("CI"):
            done = build("none")
        if done.returncode == 0:
            TEST_RUN_FILE.write_text(test_run, "utf-8")
    finally:
        lock.close()
    if "none on the path" in done.stderr:
        pytest.skip(f"NO SITE WAS BUILT: {done.stderr}")
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return FOLDER


def build(kind):
    settings = {"PYTHONPATH": str(ROOT), lab.VARIABLE: os.environ.get(lab.VARIABLE, kind)}
    return subprocess.run(
        [sys.executable, SITE / "build.py"], cwd=ROOT, env={**os.environ, **settings},
        capture_output=True, text=True, check=False, timeout=TIMEOUT_S,
    )  # fmt: skip


class QuietHandler(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        """Write no log of the requests."""


@contextmanager
def served(folder: Path):
    """Serve a folder on a free port. Yields the address."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(QuietHandler, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()
    thread.join()
