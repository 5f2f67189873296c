"""All feedback pages in one zip file, each under the name by which the learning platform assigns it to its student.

Moodle  Ada Lovelace_1815_assignfeedback_file_03_poe_space.html
        Name, participant, kind of plugin and plugin, then the name that the student sees. Moodle skips files whose content it
        already has.
Canvas  lovelaceada_1815_99_feedback.html
        The first two numbers between underscores are the student and the submitted file.

Source: mod/assign/feedback/file/importziplib.php of Moodle; infer_comment_context_from_filename of Canvas.
"""

import filecmp
from pathlib import Path, PurePosixPath
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from misstep.grading.collect.gather import Gathered
from misstep.grading.collect.layouts import CANVAS, MOODLE
from misstep.grading.publish.result_store import file_name


def write_feedback_zip(out: Path, gathered: Gathered, sheet: str) -> None:
    """Write feedback.zip with the page of every student who submitted something, if it was a download of Moodle or Canvas."""
    pages = {}
    for submission in gathered.submissions:
        page = out / "feedback" / f"{file_name(submission.student)}.html"
        paths = [file.path for file in submission.notebooks[:1]]
        if paths and page.exists() and (name := feedback_name(gathered.kind, paths[0], sheet)):
            pages[name] = page
    if not pages:
        return
    target = out / "feedback.zip"
    partial = target.with_name(f".{target.name}.partial")
    with ZipFile(partial, "w") as archive:
        for name, page in sorted(pages.items()):
            # Every member has the date 1980-01-01, so that the same pages give the same zip file.
            archive.writestr(ZipInfo(name), page.read_bytes(), ZIP_DEFLATED)
    if target.exists() and filecmp.cmp(partial, target, shallow=False):
        partial.unlink()
    else:
        partial.replace(target)


def feedback_name(kind: str, path: PurePosixPath, sheet: str) -> str | None:
    """The name of a page, from the path of the submission in the download; None if the platform takes no pages back.

    >>> feedback_name("moodle", PurePosixPath("Ada Lovelace_1815_assignsubmission_file_/x.ipynb"), "03_poe_space")
    'Ada Lovelace_1815_assignfeedback_file_03_poe_space.html'
    >>> feedback_name("canvas", PurePosixPath("lovelaceada_LATE_1815_99_x-2.ipynb"), "03_poe_space")
    'lovelaceada_LATE_1815_99_feedback.html'
    """
    top = path.parts[0]
    if kind == "moodle" and (match := MOODLE.fullmatch(top)):
        return f"{match['name'].replace('_', ' ')}_{match['key']}_assignfeedback_file_{sheet}.html"
    if kind == "canvas" and (match := CANVAS.fullmatch(top)):
        return f"{top[: match.start('file')]}feedback.html"
    return None
