"""KaTeX's style and fonts, and the tool that tests pages for accessibility: fetched from npm when they are not there."""

import shutil
import subprocess
import sys

from kinsite.execute import ROOT

SITE = ROOT / "site"
MODULES = SITE / "node_modules"
FONTS = MODULES / "katex" / "dist"


def fetch() -> None:
    """Fetch what site/package-lock.json names, unless it is there.

    Raises SystemExit where there is no Node, which sets the formulas, and where npm fails.
    """
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        sys.exit("The site's formulas are set by Node 20 or newer, and there is none on the path. See nodejs.org.")
    installed = MODULES / ".package-lock.json"
    if installed.exists() and installed.stat().st_mtime >= (SITE / "package-lock.json").stat().st_mtime:
        return
    if subprocess.call([npm, "ci", "--silent"], cwd=SITE):
        sys.exit("npm could not fetch KaTeX's fonts: see above. Check the network, then try again.")
