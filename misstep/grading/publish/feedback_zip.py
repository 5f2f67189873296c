"""Returns: all pages of feedback in one zip, each under the name by which the platform finds whose it is.

Moodle  Ada Lovelace_1815_assignfeedback_file_03_poe_space.html
        Name, participant, kind of plugin and plugin, then the name that the student sees. What Moodle has already in the same
        words, it leaves alone.
Canvas  lovelaceada_1815_99_feedback.html
        The first two numbers between underscores: whose it is, and the file that was handed in.

Source: mod/assign/feedback/file/importziplib.php of Moodle; infer_comment_context_from_filename of Canvas.
"""

import filecmp
from pathlib import Path, PurePosixPath
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from misstep.grading.collect.gather import Gathered
from misstep.grading.collect.layouts import CANVAS, MOODLE
from misstep.grading.publish.result_store import file_name


def give_back(out: Path, gathered: Gathered, sheet: str) -> bool:
    """Write feedback.zip from the pages of whoever handed something in. False, and none, where no platform takes one."""
    pages = {}
    for handed in gathered.handed:
        page = out / "feedback" / f"{file_name(handed.student)}.html"
        if handed.notebook and page.exists() and (name := returned_name(gathered.kind, handed.notebook.path, sheet)):
            pages[name] = page
    if not pages:
        return False
    whole = out / "feedback.zip"
    half = whole.with_name(f".{whole.name}.half")
    with ZipFile(half, "w") as archive:
        for name, page in sorted(pages.items()):
            # Every file is of 1980: a zip of the same pages is the same zip.
            archive.writestr(ZipInfo(name), page.read_bytes(), ZIP_DEFLATED)
    if whole.exists() and filecmp.cmp(half, whole, shallow=False):
        half.unlink()
    else:
        half.replace(whole)
    return True


def returned_name(kind: str, path: PurePosixPath, sheet: str) -> str | None:
    """The name of a page, from where the submission lay in the platform's download; None where nothing is taken back.

    >>> returned_name("moodle", PurePosixPath("Ada Lovelace_1815_assignsubmission_file_/x.ipynb"), "03_poe_space")
    'Ada Lovelace_1815_assignfeedback_file_03_poe_space.html'
    >>> returned_name("canvas", PurePosixPath("lovelaceada_LATE_1815_99_x-2.ipynb"), "03_poe_space")
    'lovelaceada_LATE_1815_99_feedback.html'
    """
    top = path.parts[0]
    if kind == "moodle" and (found := MOODLE.fullmatch(top)):
        return f"{found['name'].replace('_', ' ')}_{found['key']}_assignfeedback_file_{sheet}.html"
    if kind == "canvas" and (found := CANVAS.fullmatch(top)):
        return f"{top[: found.start('file')]}feedback.html"
    return None
