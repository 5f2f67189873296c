"""Build the site: `python course.py site`. A second run rebuilds only what has changed.

The pages are written to build/site/html, or to the folder html in the folder that is given as the only argument.
"""

import shutil
import subprocess
import sys
import time
from pathlib import Path

from kinsite import npm_packages
from kinsite.browser_lab import lab
from kinsite.browser_lab.wheels import Unreachable
from kinsite.execute import ROOT, NotebookError
from kinsite.sphinx_source import write_source
from sphinx.cmd.build import main as sphinx

HERE = Path(__file__).resolve().parent


def build(folder: Path) -> int:
    """Build the pages and the lab into a folder. Returns Sphinx's exit code: every warning counts as an error."""
    npm_packages.install()
    print("Running the notebooks that are not kept from before, and writing the source of the pages.", flush=True)
    write_source(folder / "source")
    print("Building the lab, that is, Python for the pages, unless it is kept from before.", flush=True)
    built_lab = lab.build()
    values = (f"kinlib_lab={'lab' if built_lab else ''}", f"html_context.kinlib_python_mb={lab.megabytes(built_lab)}")
    settings = [word for value in values for word in ("-D", value)]
    strict = ["-n", "-W", "--keep-going"]  # every warning fails the build, after all of them have been reported
    arguments = ("-c", HERE, "-d", folder / "doctrees", *settings, folder / "source", folder / "html")
    print("Writing the pages that have changed.", flush=True)
    failed = int(sphinx([*strict, "-b", "html", *map(str, arguments)]))
    if not failed:
        index_words(folder / "html")
    shutil.rmtree(folder / "html" / "lab", ignore_errors=True)
    if built_lab:
        shutil.copytree(built_lab, folder / "html" / "lab")
    return failed


def index_words(html: Path) -> None:
    """Let Pagefind write the index of the search, of the text and not of the code, and each formula once."""
    pages = "{*,{lectures,mistakes,reference,robots,sheets}/*}.html"
    left_out = ".cell, .headerlink, .katex-html, .katex-mathml mrow, .kinlib-bar, .kinlib-elsewhere"
    options = ("--glob", pages, "--root-selector", "article[role=main]", "--exclude-selectors", left_out)
    subprocess.run(
        [sys.executable, "-m", "pagefind", "--quiet", "--keep-index-url", "--site", html, *options], check=True
    )


def summarize(html: Path, seconds: float) -> None:
    """Say what was built, and how to look at it."""
    sizes = [path.stat().st_size for path in html.rglob("*") if path.is_file()]
    pages = sum("lab" not in path.relative_to(html).parts for path in html.rglob("*.html"))
    lab = "with Python for their cells" if (html / "lab").exists() else "without Python for their cells"
    print(f"{pages} pages in {html}, {sum(sizes) / 1e6:.0f} MB {lab}, in {seconds:.0f} s.")
    print("To look at them: python course.py serve")


if __name__ == "__main__":
    start = time.monotonic()
    try:
        folder = Path(sys.argv[1]) if sys.argv[1:] else ROOT / "build" / "site"
        failed = build(folder)
    except (NotebookError, Unreachable, ValueError) as error:
        sys.exit(f"The site was not built. {error}")
    if not failed:
        summarize(folder / "html", time.monotonic() - start)
    sys.exit(failed)
