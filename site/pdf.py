"""Print the built site as one PDF, and add it to the site: `nox -s pdf`. Chromium must be installed."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from kinsite.pdf_document import compose_document, squeeze
from pypdf import PdfReader, PdfWriter

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
ADDRESS = re.sub("/*$", "/", os.environ.get("KINLIB_SITE_URL", ""), count=1).removeprefix("/")
CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")

PLACEHOLDER = "<!-- course.pdf -->"
"""What the front page contains until a PDF is printed."""
LINK = '<p><a href="course.pdf">The lectures as one PDF</a>, to print or to keep.</p>'
"""What replaces the placeholder."""

OFFLINE = "--host-resolver-rules=MAP * ~NOTFOUND"
# The browser's sandbox protects from pages of strangers. This page is our own, and loads nothing from other hosts.
HEADLESS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run", OFFLINE)
DESCRIPTION = {
    "/Author": "The kinlib authors",
    "/Subject": "Lectures on the forward kinematics of robots",
    "/Creator": "",
}


def write_pdf(document: Path, pdf: Path) -> None:
    """Print an HTML document with Chromium; the PDF has an outline, an author and a subject.

    Raises SystemExit if there is no Chromium, and if it prints nothing.
    """
    chromium = os.environ.get("KINLIB_CHROMIUM") or next(filter(None, map(shutil.which, CHROMIUM_NAMES)), None)
    if chromium is None:
        sys.exit("Printing the PDF needs Chromium, and there is none on the path. Set KINLIB_CHROMIUM to its path.")
    options = ("--no-pdf-header-footer", "--generate-pdf-document-outline", f"--print-to-pdf={pdf}", document.as_uri())
    pdf.unlink(missing_ok=True)
    done = subprocess.run([chromium, *HEADLESS, *options], capture_output=True, text=True, check=False)
    if not pdf.exists():
        sys.exit(f"{chromium} printed nothing:\n{done.stderr[-2000:]}")
    described = PdfWriter(clone_from=pdf)
    described.add_metadata(DESCRIPTION)
    described.write(pdf)


def page_numbers(pdf: Path) -> dict[str, int]:
    """Read from the outline of a PDF on which sheet of paper each heading of the first level begins, by the squeezed headings."""
    reader = PdfReader(pdf)
    headings = [entry for entry in reader.outline if not isinstance(entry, list)]
    return {squeeze(str(one.title)): (reader.get_destination_page_number(one) or 0) + 1 for one in headings}


if __name__ == "__main__":
    if not (BUILT / "index.html").exists():
        sys.exit("The site is not built yet. Try: python course.py site")
    document = BUILT.parent / "course.html"
    numbers: dict[str, int] = {}
    # Chromium cannot write the number of another page, so the first print is read for the second one
    for _ in range(2):
        document.write_text(compose_document(BUILT, BUILT.name, ADDRESS, numbers=numbers), "utf-8")
        write_pdf(document, BUILT / "course.pdf")
        numbers = page_numbers(BUILT / "course.pdf")
    front = BUILT / "index.html"
    front.write_text(front.read_text("utf-8").replace(PLACEHOLDER, LINK), "utf-8")
    print(f"The course has been printed to {BUILT / 'course.pdf'}.")
