"""npm packages of the site: KaTeX's style and fonts, the fonts of the text, Pyodide, and axe, which tests the pages for accessibility."""

import shutil
import subprocess
import sys

from kinsite.execute import ROOT

SITE = ROOT / "site"
MODULES = SITE / "node_modules"
FONTS = MODULES / "katex" / "dist"

FONTSOURCE = MODULES / "@fontsource-variable"
TEXT_FONTS = {
    "serif.woff2": FONTSOURCE / "source-serif-4/files/source-serif-4-latin-wght-normal.woff2",
    "serif-italic.woff2": FONTSOURCE / "source-serif-4/files/source-serif-4-latin-wght-italic.woff2",
    "sans.woff2": FONTSOURCE / "source-sans-3/files/source-sans-3-latin-wght-normal.woff2",
    "LICENSE": FONTSOURCE / "source-serif-4/LICENSE",
}
"""The fonts of the text and their licence, by their names on the site."""


def install() -> None:
    """Install the packages of site/package-lock.json, unless they are installed already.

    Raises SystemExit if there is no Node, which typesets the formulas, and if npm fails.
    """
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        sys.exit("The site needs Node 20 or newer, and there is none on the path. Install it from nodejs.org.")
    installed = MODULES / ".package-lock.json"
    if installed.exists() and installed.stat().st_mtime >= (SITE / "package-lock.json").stat().st_mtime:
        return
    if subprocess.call([npm, "ci", "--silent"], cwd=SITE):
        sys.exit("npm could not install the packages of the site: see above. Check the network, then try again.")
