"""The site for tests: built once by whoever comes first, and served to this machine only."""

import os
import sqlite3
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path

import pytest
from browser import CHROMIUM

ROOT = Path(__file__).parents[1]
SITE = ROOT / "site"
sys.path.insert(0, str(SITE))

from kinsite import lab  # noqa: E402
from serve import serve  # noqa: E402

FOLDER = ROOT / "build" / "site" / "html"
PATIENCE = 900
"""How long to wait, in seconds, for another worker that builds."""


def build_site() -> Path:
    """Build the pages and, where a browser could open it, the lab that needs package registries only."""
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    # a lock that every system knows, and that goes when its owner goes
    lock = sqlite3.connect(FOLDER.parent / "lock", timeout=PATIENCE, isolation_level=None)
    lock.execute("BEGIN EXCLUSIVE")
    try:
        done = run("offline" if CHROMIUM else "none")
        if done.returncode and "could not fetch" in done.stderr and not os.environ.get("CI"):
            done = run("none")
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
