"""The time from opening a page in a new browser to the first checked answer, in the course and in stock JupyterLite.

Stock JupyterLite has the same release, Python, wheels and sheet, but nothing that the course adds. The course is visited twice:
lecture 00, whose code runs on its page, and sheet 03 in the lab. In each round every place is opened once with no stored file,
by a script that reads and types in no time. All files come from this machine, so no time of a download is included.

    python course.py site                    the site, which must have a lab
    python -m benchmarks first_answer
"""

import json
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from browser import CHROMIUM, NO_CHROMIUM, browsers
from built_site import FOLDER, ROOT, served
from kinsite.browser_lab.lab import EXTENSIONS
from lab_page import cell, run, write

from benchmarks.measure import MissingRequirementError, Row, timed_row

SHEET = "exercises/03_poe_space/03_poe_space.ipynb"
STOCK = "the sheet in stock JupyterLite"
TARGETS = {"page of a lecture": (4.0, 1.0), "sheet in the course's lab": (2.0, 1.0)}
"""How many times sooner than in stock JupyterLite there must be text to read, and a checked answer."""

TIMEOUT_MS = 600_000
"""How long to wait for anything: a busy machine is slow."""

WINDOW = {"width": 1280, "height": 1000}

Seconds = tuple[float, float]
"""From opening a page to text that can be read, and to the card of a checked answer."""


def rows(quick: bool = False) -> Iterator[Row]:
    """Open the three places in turns, and compare the times.

    Raises MissingRequirementError if there is no Chromium, or no site with a lab.
    """
    if CHROMIUM is None:
        raise MissingRequirementError(NO_CHROMIUM)
    if not (FOLDER / "lab").exists():
        raise MissingRequirementError(f"{FOLDER.relative_to(ROOT)} has no lab. Build it: python course.py site")
    with tempfile.TemporaryDirectory() as name, browsers() as start:
        stock = build_stock(Path(name))
        with served(FOLDER) as site, served(stock) as other, start(webgl=False) as browser:
            places = {
                "page of a lecture": lambda page: answer_on_page(page, f"{site}/lectures/00_start_here.html"),
                "sheet in the course's lab": lambda page: answer_in_lab(
                    page, f"{site}/lab/notebooks/index.html?path={SHEET}", "Problem 1"
                ),
                STOCK: lambda page: answer_in_lab(page, f"{other}/lab/index.html?path={SHEET}", ""),
            }
            times = time_visits(browser, places, 1 if quick else 3)
    for which, what in enumerate(("text to read", "first checked answer")):
        peer = [seconds[which] for seconds in times[STOCK]]
        for place, targets in TARGETS.items():
            own = [seconds[which] for seconds in times[place]]
            yield timed_row(f"{what}: {place}", own, STOCK, peer, target=targets[which])


def build_stock(folder: Path) -> Path:
    """Build JupyterLite with the sheet, and with the Python of the course's lab. Returns the folder to serve."""
    lab = FOLDER / "lab"
    shutil.copytree(lab / "static" / "pyodide", folder / "static" / "pyodide")
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


def time_visits(browser: Any, places: dict[str, Any], rounds: int) -> dict[str, list[Seconds]]:
    """Visit every place once per round, in another order each time, each time as a new reader without stored files."""
    times: dict[str, list[Seconds]] = {place: [] for place in places}
    for number in range(rounds):
        for turn in range(len(places)):
            place = list(places)[(turn + number) % len(places)]
            with browser.new_context(viewport=WINDOW) as context:
                page = context.new_page()
                page.set_default_timeout(TIMEOUT_MS)
                times[place].append(places[place](page))
    return times


def answer_on_page(page: Any, address: str) -> Seconds:
    """Run the cell of a lecture that checks an answer."""
    begun = time.perf_counter()
    page.goto(address, wait_until="commit")
    page.get_by_role("heading", level=1).wait_for()
    readable = time.perf_counter()
    answer = page.locator("div.cell").filter(has=page.locator(".cell_input", has_text="position = [")).first
    answer.get_by_role("button", name="Run").click()
    answer.get_by_text("Done.").wait_for()
    answer.locator("[role=status]", has_text="Not yet").wait_for()
    return readable - begun, time.perf_counter() - begun


def answer_in_lab(page: Any, address: str, preview: str) -> Seconds:
    """Type an answer into a sheet, and check it.

    preview  a heading of what is shown before JupyterLab; empty if nothing is
    """
    begun = time.perf_counter()
    page.goto(address, wait_until="commit")
    if preview:
        page.frame_locator("iframe").get_by_role("heading", name=preview).first.wait_for()
        readable = time.perf_counter()
    cell(page, "screws_1 =").wait_for()
    if not preview:
        readable = time.perf_counter()
    run(page, cell(page, "open_sheet"), done=False)
    write(page, cell(page, "screws_1 ="), "screws_1 = np.zeros((3, 6))")
    run(page, cell(page, "screws_1 ="), done=False)
    run(page, cell(page, "sheet.check(1"), done=False)
    cell(page, "sheet.check(1").locator("[role=status]", has_text="Not yet").wait_for()
    return readable - begun, time.perf_counter() - begun
