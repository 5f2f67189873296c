"""The site of a new course is built by the lines of its README, and has its pages, its notebooks and its wheels.

It needs package registries, Python 3.12 or newer and some minutes, so `nox -s new_course_site` runs it on demand. Where the
address of Pyodide cannot be reached, the site is built without the wheels for the browser, and their test is skipped.
"""

import json
import os
import re
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from test_new_course import RIGHT, SET_UP, SITE

from misstep.new_course import write_course

ENGINE = Path(__file__).parents[2] / "misstep"
PYTHONS = ("python3.14", "python3.13", "python3.12")
PYODIDE = "cdn.jsdelivr.net"


def reaches_pyodide():
    try:
        return bool(socket.getaddrinfo(PYODIDE, 443))
    except OSError:
        return False


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The site of a new course called circuits, built as its README says."""
    python = sys.executable if sys.version_info >= (3, 12) else next(filter(None, map(shutil.which, PYTHONS)), None)
    assert python, f"Python 3.12 or newer must be on the path; none of {', '.join(PYTHONS)} is"
    folder = tmp_path_factory.mktemp("new") / "circuits"
    write_course(folder)
    if not reaches_pyodide():
        settings = folder / "jupyter_lite_config.json"
        settings.write_text(settings.read_text("utf-8").replace('"enabled": true', '"enabled": false'), "utf-8")
    subprocess.run([python, "-m", "venv", ".venv"], cwd=folder, check=True)
    # as the README says for as long as misstep is not published
    run(folder, f".venv/bin/python -m pip install --quiet {ENGINE}")
    for line in (SET_UP[1], *SITE):
        run(folder, re.sub(r"(?<= \.) misstep$", f" {ENGINE}", line))
    return folder / "build" / "site"


def run(folder, line):
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")}
    done = subprocess.run(line, shell=True, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"


def test_every_page_shows_the_results_of_its_cells_and_no_solution(site):
    assert "data-misstep-question" in (site / "notebooks" / "01_ohm.html").read_text("utf-8")
    sheet = re.sub("<[^>]+>", "", (site / "exercises" / "01_ohm" / "01_ohm.html").read_text("utf-8"))
    assert "resistance_1 = ..." in sheet
    assert "Problem 2" in sheet
    assert not any(solution in sheet for solution in RIGHT.values())
    assert (site / "instructors.html").exists()


def test_the_notebooks_for_the_browser_are_those_of_the_pages(site):
    found = {
        path.relative_to(site / "lite" / "files").as_posix() for path in (site / "lite" / "files").rglob("*.ipynb")
    }
    assert found == {"notebooks/01_ohm.ipynb", "exercises/01_ohm/01_ohm.ipynb"}


@pytest.mark.skipif(not reaches_pyodide(), reason=f"{PYODIDE} cannot be reached")
def test_the_python_of_the_browser_has_the_wheels_of_course_and_engine(site):
    lock = json.loads((site / "lite" / "static" / "pyodide-lock" / "pyodide-lock.json").read_text("utf-8"))
    assert {"circuits", "misstep"} <= set(lock["packages"])
