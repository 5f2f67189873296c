"""Check every page of the site with axe, in the light and in the dark theme.

The ordinary tests check one page of each kind; all pages take minutes, so pytest does not collect this file by itself. Run it with:

    .venv/bin/python -m nox -s axe
"""

from accessibility import violations
from browser import watched


def test_axe_finds_no_violation_on_any_page(chromium_without_webgl, site_address, site_folder):
    found = {}
    for path in sorted(site_folder.rglob("*.html")):
        name = path.relative_to(site_folder).as_posix()
        if name.startswith(("_static/", "lab/")):
            continue
        with watched(chromium_without_webgl, viewport={"width": 1200, "height": 900}) as page:
            page.context.set_default_timeout(120_000)
            page.goto(f"{site_address}/{name}")
            if faults := violations(page):
                found[name] = faults
    assert not found
