"""npm packages of the site: KaTeX's style and fonts, Pyodide, and axe, which tests the pages for accessibility."""

import shutil
import subprocess
import sys

from kinsite.execute import ROOT

SITE = ROOT / "site"
MODULES = SITE / "node_modules"
FONTS = MODULES / "katex" / "dist"


def install() -> None:
    """Install the packages of site/package-lock.json, unless they are installed already.

    Raises SystemExit if there is no Node, which typesets the formulas, and if npm fails.
    """
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        sys.exit(
            "The site's formulas are typeset by Node 20 or newer, and there is none on the path. Install it from nodejs.org."
        )
    installed = MODULES / ".package-lock.json"
    if installed.exists() and installed.stat().st_mtime >= (SITE / "package-lock.json").stat().st_mtime:
        return
    if subprocess.call([npm, "ci", "--silent"], cwd=SITE):
        sys.exit("npm could not install the packages of the site: see above. Check the network, then try again.")
