"""Run every lecture and every sheet in the lab of the site, from the first cell to the last, in one browser.

This takes long, so pytest does not collect this file by itself. Run it with:

    python course.py test tests/browser/every_notebook_in_the_browser.py --numprocesses=1
"""

import time

import pytest
from browser import watched
from built_site import ROOT
from lab_page import run_all, visit

NOTEBOOKS = [
    path.relative_to(ROOT).as_posix() for path in (*ROOT.glob("notebooks/*.ipynb"), *ROOT.glob("exercises/*/*.ipynb"))
]


@pytest.mark.parametrize("notebook", sorted(NOTEBOOKS))
def test_every_cell_runs_without_an_error(chromium_without_webgl, site_address, notebook):
    with watched(chromium_without_webgl, viewport={"width": 1200, "height": 1000}) as page:
        begun = time.perf_counter()
        visit(page, site_address, notebook)
        assert run_all(page) == []
        pictures = page.locator(".jp-OutputArea-output :is(img, canvas, svg)").count()
        print(f"{notebook}: {time.perf_counter() - begun:.0f} s, {pictures} pictures")
        assert page.locator(".jp-OutputArea-output").count() > 6
