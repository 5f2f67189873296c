"""Build the site: `python course.py site`. A second run rebuilds only what has changed.

The pages are written to build/site/html, or to the folder html in the folder that is given as the only argument.
"""

import sys
from pathlib import Path

from kinsite import npm_packages
from kinsite.browser_lab import lab
from kinsite.browser_lab.wheels import Unreachable
from kinsite.execute import ROOT, NotebookError
from kinsite.sphinx_source import write_source
from sphinx.cmd.build import main as sphinx

HERE = Path(__file__).resolve().parent
STRICT = ("-n", "-W", "--keep-going")
"""Options of Sphinx: every warning fails the build, after all of them have been reported."""


def build(folder: Path = ROOT / "build" / "site") -> int:
    """Build the pages and the lab into a folder. Returns Sphinx's exit code: every warning counts as an error."""
    npm_packages.install()
    write_source(folder / "source")
    built_lab = lab.build()
    values = (f"kinlib_lab={'lab' if built_lab else ''}", f"kinlib_python_mb={lab.megabytes(built_lab)}")
    settings = [word for value in values for word in ("-D", value)]
    arguments = (*STRICT, "-q", "-c", HERE, "-d", folder / "doctrees", *settings, folder / "source", folder / "html")
    failed = int(sphinx(["-b", "html", *map(str, arguments)]))
    lab.copy_to_site(built_lab, folder / "html" / "lab")
    return failed


if __name__ == "__main__":
    try:
        failed = build(*map(Path, sys.argv[1:2]))
    except (NotebookError, Unreachable, ValueError) as error:
        sys.exit(f"The site was not built. {error}")
    sys.exit(failed)
