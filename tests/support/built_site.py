"""The site for tests: built once in a test run, by the worker that needs it first, and served to this machine only."""

import os
import sqlite3
import subprocess
import sys
import threading
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest
from browser import CHROMIUM

ROOT = Path(__file__).parents[2]
SITE = ROOT / "site"
sys.path.insert(0, str(SITE))

from kinsite import lab  # noqa: E402
from serve import serve  # noqa: E402

FOLDER = ROOT / "build" / "site" / "html"
BUILT_BY = FOLDER.parent / "test_run.txt"
"""Which test run has built the site: the other workers of the same run need not build it again."""
PATIENCE = 3600
"""How long to wait, in seconds, for a build, by this worker or by another: a build that never ends must not hold up CI."""


@cache
def build_site() -> Path:
    """Build the pages and, where a browser could open it, the lab that needs package registries only.

    The first caller in a test run builds; the others wait for it, and take what it has built.
    """
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    test_run = os.environ.get("PYTEST_XDIST_TESTRUNUID", "")
    # a lock that every system knows, and that goes when its owner goes
    lock = sqlite3.connect(FOLDER.parent / "lock", timeout=PATIENCE, isolation_level=None)
    lock.execute("BEGIN EXCLUSIVE")
    try:
        if test_run and BUILT_BY.exists() and BUILT_BY.read_text("utf-8") == test_run:
            return FOLDER
        BUILT_BY.unlink(missing_ok=True)
        done = run("offline" if CHROMIUM else "none")
        if done.returncode and "could not download" in done.stderr and not os.environ.get("CI"):
            done = run("none")
        if done.returncode == 0:
            BUILT_BY.write_text(test_run, "utf-8")
    finally:
        lock.close()
    if "none on the path" in done.stderr:
        pytest.skip(f"NO SITE WAS BUILT: {done.stderr}")
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return FOLDER


def run(kind):
    settings = {"PYTHONPATH": str(ROOT), lab.VARIABLE: os.environ.get(lab.VARIABLE, kind)}
    return subprocess.run(
        [sys.executable, SITE / "build.py"], cwd=ROOT, env={**os.environ, **settings},
        capture_output=True, text=True, check=False, timeout=PATIENCE,
    )  # fmt: skip


@contextmanager
def served(folder: Path):
    """Serve a folder on a port of its own. Gives the address."""
    server = serve(folder, 0)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()
    thread.join()
