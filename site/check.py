"""Check a built site before it is published: every page, the PDF, and a lab whose Python and packages are complete.

The folder is build/site/html, or the only argument: `.venv/bin/python site/check.py`.
"""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

from kinsite.execute import PACKAGES
from kinsite.sphinx_source import LECTURES, SHEETS

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
FILES = ("index.html", "404.html", "search.html", "sitemap.xml", "course.pdf", "lab/notebooks/index.html")
LOCK_FILE = "lab/static/pyodide/pyodide-lock.json"
RUN_LINK = 'class="kinlib-run"'


def missing(built: Path) -> Iterator[str]:
    """Yield what a site lacks that must be published with it, one line for each file, package and link."""
    notebooks = [f"{folder}/{path.stem}.html" for folder, paths in NOTEBOOKS.items() for path in paths]
    for name in (*FILES, *notebooks, LOCK_FILE):
        if not (built / name).is_file():
            yield name
        elif name in notebooks and RUN_LINK not in (built / name).read_text("utf-8"):
            yield f"{name}: the link that runs it in the browser"
    if (lock := built / LOCK_FILE).is_file():
        packages = json.loads(lock.read_text("utf-8"))["packages"]
        yield from (f"{LOCK_FILE}: {name}" for name in PACKAGES if name not in packages)
        files = [f"lab/static/pyodide/{package['file_name']}" for package in packages.values()]
        yield from (name for name in files if not (built / name).is_file())


NOTEBOOKS = {"lectures": LECTURES, "sheets": SHEETS}
"""The notebooks whose pages must offer to run them, by the folder of their pages."""


if __name__ == "__main__":
    built = Path(sys.argv[1]) if len(sys.argv) > 1 else BUILT
    if faults := list(missing(built)):
        sys.exit(f"The site in {built} must be complete before it is published. It lacks:\n" + "\n".join(faults))
    print(f"The site in {built} is complete.")
