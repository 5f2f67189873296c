"""Print the site that was built as one PDF, into the site: `nox -s pdf`. It needs a Chromium on the path."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from kinsite.book import book

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
ADDRESS = os.environ.get("KINLIB_SITE_URL", "http://127.0.0.1:8000/").rstrip("/") + "/"
NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")
MARK = "<!-- course.pdf -->"
LINK = '<p><a href="course.pdf">The lectures as one PDF</a>, to print or to keep.</p>'
"""What stands on the front page until there is a PDF, and then."""
OFFLINE = "--host-resolver-rules=MAP * ~NOTFOUND"
HEADLESS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run", OFFLINE)
"""The sandbox is for strangers' pages: this one is our own, and asks nobody."""


def write_pdf(document: Path, pdf: Path) -> None:
    """Print an HTML document, with an outline and page numbers.

    Raises SystemExit where there is no Chromium, and where it prints nothing.
    """
    chromium = os.environ.get("KINLIB_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
    if chromium is None:
        sys.exit("The PDF is printed by Chromium, and there is none on the path. Name one in KINLIB_CHROMIUM.")
    words = ("--no-pdf-header-footer", "--generate-pdf-document-outline", f"--print-to-pdf={pdf}", document.as_uri())
    pdf.unlink(missing_ok=True)
    done = subprocess.run([chromium, *HEADLESS, *words], capture_output=True, text=True, check=False)
    if not pdf.exists():
        sys.exit(f"{chromium} printed nothing:\n{done.stderr[-2000:]}")


if __name__ == "__main__":
    if not (BUILT / "index.html").exists():
        sys.exit("The site is not built yet. Try: python course.py site")
    document = BUILT.parent / "book.html"
    document.write_text(book(BUILT, BUILT.name, ADDRESS), "utf-8")
    write_pdf(document, BUILT / "course.pdf")
    front = BUILT / "index.html"
    front.write_text(front.read_text("utf-8").replace(MARK, LINK), "utf-8")
    print(f"The course is printed to {BUILT / 'course.pdf'}.")
