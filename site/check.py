"""Check a built site: every page, a lab whose Python and packages are complete, no literal markup.

The folder is build/site/html, or the one that is given: `.venv/bin/python site/check.py`.
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from kinsite.sphinx_source import LECTURES, SHEETS

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
FILES = ("index.html", "404.html", "search.html", "sitemap.xml", "lab/notebooks/index.html")
LOCK_FILE = "lab/static/pyodide/pyodide-lock.json"
RUN_LINK = 'class="kinlib-run"'


def missing(built: Path) -> Iterator[str]:
    """Yield what a site lacks, one line for each file, package and link."""
    notebooks = [f"{folder}/{path.stem}.html" for folder, paths in NOTEBOOKS.items() for path in paths]
    for name in (*FILES, *notebooks, LOCK_FILE):
        if not (built / name).is_file():
            yield name
        elif name in notebooks and RUN_LINK not in (built / name).read_text("utf-8"):
            yield f"{name}: the link that runs it in the browser"
    if (lock := built / LOCK_FILE).is_file():
        packages = json.loads(lock.read_text("utf-8"))["packages"]
        if "kincourse" not in packages:
            yield f"{LOCK_FILE}: kincourse"
        files = [f"lab/static/pyodide/{package['file_name']}" for package in packages.values()]
        yield from (name for name in files if not (built / name).is_file())


NOT_PROSE = re.compile(r'<(script|style|pre|code|svg|math|textarea)\b.*?</\1>|<dt class="sig.*?</dt>', re.DOTALL)
INLINE_TAG = re.compile(r"</?(?:a|em|strong|b|span)\b[^>]*>")
ANY_TAG = re.compile(r"<[^>]+>")
LITERAL = re.compile(
    r"(?<![\w*])\*{1,2}\w[^*\n]*\*|`|\$|\\[(\[A-Za-z]|(?<!\w)_\w+_(?!\w)|\]\((?:https?:|[\w./]+\.(?:md|ipynb|html))|\b([a-z]{2,}) \1\b"
)
"""Markdown, LaTeX or a doubled word that a reader would see. Doubled words in quotations are the source's."""


def literal_markup(built: Path) -> Iterator[str]:
    """Yield each place where a page shows the marks of Markdown or LaTeX themselves, or a word twice."""
    for path in sorted(built.rglob("*.html")):
        name = path.relative_to(built).as_posix()
        if name.startswith(("lab/", "_static/", "files/")):
            continue
        _, _, article = path.read_text("utf-8").partition('<article role="main"')
        text = ANY_TAG.sub("\n", INLINE_TAG.sub("", NOT_PROSE.sub("\u2026", article)))
        for line in text.splitlines():
            if (found := LITERAL.search(line)) and not (found[1] and "\u201c" in line):
                yield f"{name}: {found[0]!r} in {line.strip()[:100]!r}"


NOTEBOOKS = {"lectures": LECTURES, "sheets": SHEETS}
"""The notebooks whose pages must offer to run them, by the folder of their pages."""


if __name__ == "__main__":
    built = Path(sys.argv[1]) if sys.argv[1:] else BUILT
    if faults := list(missing(built)):
        sys.exit(f"The site in {built} must be complete. It lacks:\n" + "\n".join(faults))
    if faults := list(literal_markup(built)):
        sys.exit(f"No page of {built} may show literal markup. Found:\n" + "\n".join(faults))
    print(f"The site in {built} is complete.")
