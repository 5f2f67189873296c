"""Build the site: `python course.py site`. A second run does only what has changed.

The pages are written to build/site/html, or with a folder as the only argument, to html in there.
"""

import sys
from pathlib import Path

from kinsite import STRICT, lab
from kinsite.execute import ROOT, NotebookRaised
from kinsite.fonts import fetch
from kinsite.sources import prepare
from kinsite.wheels import Unreachable
from sphinx.cmd.build import main as sphinx

HERE = Path(__file__).resolve().parent


def build(folder: Path = ROOT / "build" / "site") -> int:
    """Build everything into a folder. Gives Sphinx's exit code: any warning is an error."""
    fetch()
    prepare(folder / "source")
    browser_lab = lab.build()
    words = (
        *STRICT,
        "-q",
        "-c",
        HERE,
        "-d",
        folder / "doctrees",
        "-D",
        f"kinlib_lab={'lab' if browser_lab else ''}",
        folder / "source",
        folder / "html",
    )
    failed = int(sphinx(["-b", "html", *map(str, words)]))
    lab.bring(browser_lab, folder / "html" / "lab")
    return failed


if __name__ == "__main__":
    try:
        failed = build(*map(Path, sys.argv[1:2]))
    except (NotebookRaised, Unreachable, ValueError) as error:
        sys.exit(f"The site was not built. {error}")
    sys.exit(failed)
