"""Run every lecture and every sheet in the lab of the site, from the first cell to the last, in one browser.

This takes long, so pytest does not collect this file by itself. Run it with:

    python course.py test tests/browser/every_notebook_in_the_browser.py --numprocesses=1
"""

import time

import pytest
from browser import browsers, watched
from built_site import ROOT, build_site, served
from lab_page import run_all, visit

NOTEBOOKS = [
    path.relative_to(ROOT).as_posix() for path in (*ROOT.glob("notebooks/*.ipynb"), *ROOT.glob("exercises/*/*.ipynb"))
]


@pytest.fixture(scope="module")
def address():
    with served(build_site()) as address:
        yield address


@pytest.fixture(scope="module")
def chromium():
    with browsers() as start:
        yield start(webgl=False)  # a lecture of ten viewers would take minutes without a graphics card


@pytest.mark.parametrize("notebook", sorted(NOTEBOOKS))
def test_every_cell_runs_without_an_error(chromium, address, notebook):
    with watched(chromium, viewport={"width": 1200, "height": 1000}) as page:
        begun = time.perf_counter()
        visit(page, address, notebook)
        assert run_all(page) == []
        pictures = page.locator(".jp-OutputArea-output :is(img, canvas, svg)").count()
        print(f"{notebook}: {time.perf_counter() - begun:.0f} s, {pictures} pictures")
        assert page.locator(".jp-OutputArea-output").count() > 6
