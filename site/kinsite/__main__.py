"""Build the site into build/site/html: `python course.py site`. A second run does only what has changed.

python site/kinsite [folder]     builds into another folder
"""

import shutil
import subprocess
import sys
from pathlib import Path

SITE = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SITE))

from sphinx.cmd.build import main as sphinx  # noqa: E402

from kinsite.execute import ROOT, LectureRaised  # noqa: E402
from kinsite.sources import prepare  # noqa: E402

BUILD = ROOT / "build" / "site"
FONTS = SITE / "node_modules" / "katex" / "dist"


def build(folder: Path = BUILD) -> int:
    """Build everything into a folder: the pages are in html, what they are made of in source. Gives Sphinx's exit code."""
    fetch()
    prepare(folder / "source")
    words = [
        "-n",
        "-W",
        "--keep-going",
        "-q",
        "-c",
        SITE,
        "-d",
        folder / "doctrees",
        folder / "source",
        folder / "html",
    ]
    return int(sphinx(["-b", "html", *map(str, words)]))


def fetch() -> None:
    """Fetch KaTeX's style and fonts, unless they are there.

    Raises SystemExit where there is no Node, which sets the formulas.
    """
    if shutil.which("node") is None or shutil.which("npm") is None:
        sys.exit("The site's formulas are set by Node 20 or newer, and there is none on the path. See nodejs.org.")
    lock, installed = SITE / "package-lock.json", SITE / "node_modules" / ".package-lock.json"
    if not FONTS.exists() or installed.stat().st_mtime < lock.stat().st_mtime:
        npm = shutil.which("npm") or "npm"
        if subprocess.call([npm, "ci", "--silent"], cwd=SITE):
            sys.exit("npm could not fetch KaTeX's fonts: see above. Check the network, then try again.")


if __name__ == "__main__":
    try:
        sys.exit(build(*map(Path, sys.argv[1:2])))
    except (LectureRaised, ValueError) as error:
        sys.exit(f"The site was not built. {error}")
