"""From opening a page in a new browser to the first checked answer: on a page and in the lab of the course, and in stock JupyterLite.

Stock JupyterLite has the same release, Python, wheels and sheet, but nothing that the course adds or compiles. Each place is opened with no
stored file, by a script that reads, types and scrolls in no time. All files come from this machine, so no time of a download is included.
`python course.py site` must have built the site with its lab.
"""

import json
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from browser import CHROMIUM, NO_CHROMIUM, browsers
from built_site import FOLDER, ROOT, served
from kinsite.browser_lab.lab import EXTENSIONS, LABS, hash_file
from lab_page import cell, run, write

SHEET = "exercises/03_poe_space/03_poe_space.ipynb"
PAGE, LAB, STOCK = "the page of the sheet", "the sheet in the lab of the course", "the sheet in stock JupyterLite"

TIMEOUT_MS = 600_000
"""How long to wait for anything: a busy machine is slow."""


@pytest.mark.skipif(CHROMIUM is None, reason=NO_CHROMIUM)
@pytest.mark.skipif(not (FOLDER / "lab").exists(), reason="the site has no lab; build it: python course.py site")
@pytest.mark.benchmark(timer=time.perf_counter)
@pytest.mark.parametrize("place", [PAGE, LAB, STOCK])
def test_first_checked_answer(place, benchmark, tmp_path):
    folder = build_stock(tmp_path) if place == STOCK else FOLDER
    with browsers() as start, served(folder) as address, start(webgl=False) as browser:

        def visit():
            with browser.new_context(viewport={"width": 1280, "height": 1000}, reduced_motion="reduce") as context:
                page = context.new_page()
                page.set_default_timeout(TIMEOUT_MS)
                if place == PAGE:
                    answer_on_page(page, f"{address}/sheets/{Path(SHEET).stem}.html")
                else:
                    lab = "lab/notebooks" if place == LAB else "lab"
                    answer_in_lab(page, f"{address}/{lab}/index.html?path={SHEET}")

        benchmark.extra_info |= {"section": "first answer", "library": place, "size": 1}
        benchmark.pedantic(visit, rounds=3, iterations=1)


def build_stock(folder):
    """Build JupyterLite with the sheet, and with the Python of the course's lab. Returns the folder to serve."""
    lab = FOLDER / "lab"
    built = hash_file(lab).read_bytes()
    (kind,) = (path for path in LABS.iterdir() if hash_file(path).exists() and hash_file(path).read_bytes() == built)
    shutil.copytree(kind / "python", folder / "static" / "pyodide")
    (folder / "contents" / SHEET).parent.mkdir(parents=True)
    shutil.copy(ROOT / SHEET, folder / "contents" / SHEET)
    settings = json.loads((lab / "jupyter-lite.json").read_text("utf-8"))["jupyter-config-data"]["litePluginSettings"]
    (kernel,) = settings.values()
    kept = {name: kernel[name] for name in ("disablePyPIFallback", "loadPyodideOptions")}
    data = {
        "jupyter-lite-schema-version": 0,
        "jupyter-config-data": {"litePluginSettings": dict.fromkeys(settings, kept)},
    }
    (folder / "jupyter-lite.json").write_text(json.dumps(data), "utf-8")
    config = {
        "contents": [str(folder / "contents")],
        "federated_extensions": list(map(str, EXTENSIONS[:-1])),  # without that of the course
        "ignore_sys_prefix": ["federated_extensions"],
        "output_dir": str(folder / "html"),
    }
    (folder / "jupyter_lite_config.json").write_text(json.dumps({"LiteBuildConfig": config}), "utf-8")
    command = [sys.executable, "-m", "jupyterlite_core", "build", f"--lite-dir={folder}"]
    subprocess.run(command, cwd=folder, capture_output=True, check=True)
    return folder / "html"


def answer_on_page(page, address):
    """Type an answer into the page of a sheet, agree to load Python, and check it."""
    page.goto(address, wait_until="commit")
    page.locator(".kinlib-cell-answer-1 textarea").fill("screws_1 = np.zeros((3, 6))")
    check = page.locator(".kinlib-cell-check-1")
    check.get_by_role("button", name="Check").click()
    page.get_by_role("button", name="Load Python and run").click()
    check.locator("[role=status]", has_text="Not yet").wait_for()


def answer_in_lab(page, address):
    """Type an answer into a sheet, and check it."""
    page.goto(address, wait_until="commit")
    cell(page, "screws_1 =").wait_for()
    run(page, cell(page, "open_sheet"), done=False)
    write(page, cell(page, "screws_1 ="), "screws_1 = np.zeros((3, 6))")
    run(page, cell(page, "screws_1 ="), done=False)
    run(page, cell(page, "sheet.check(1"), done=False)
    cell(page, "sheet.check(1").locator("[role=status]", has_text="Not yet").wait_for()
