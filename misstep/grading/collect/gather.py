"""Gather submissions: from a folder or a download to one submission for each student, with remarks on its files."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from misstep.grading.collect.files import File, UnreadableFile, list_files, list_names
from misstep.grading.collect.layouts import Layout, StudentFiles, detect_layout
from misstep.grading.collect.notebook import UnusableNotebook, code_cells
from misstep.grading.collect.roster import Roster

STUDENT_ASSIGNMENT = re.compile(r"^student\s*=\s*([\"'])(.{1,200}?)\1", re.MULTILINE)
"""The line of a sheet in which the student's id is typed."""


@dataclass(frozen=True)
class Submission:
    """What one student submitted.

    student   the course id, or without a roster the name that the platform gives
    seed_id   the id from which the numbers are drawn; "" for the one that is typed in the notebook
    notebook  the file to grade; None if nothing was submitted
    notes     remarks on the files
    """

    student: str
    seed_id: str
    notebook: File | None
    notes: Sequence[str] = ()

    def read(self) -> bytes | None:
        """The bytes of the notebook; None if nothing was submitted.

        Raises UnreadableFile for a file that is not read.
        """
        return self.notebook.read() if self.notebook else None


@dataclass(frozen=True)
class Gathered:
    """The submissions of all students, ordered by student, the kind of the download, and remarks for the instructor."""

    kind: str
    submissions: Sequence[Submission]
    remarks: Sequence[str] = ()


def gather(source: Path, sheet: str, roster: Roster | None = None) -> Gathered:
    """Find what each student submitted.

    With a roster, every student in it gets a submission, and students who are not in it are listed in the remarks.

    Raises ValueError if there are no submissions.
    """
    layout = detect_layout(list_files(source), sheet)
    remarks: list[str] = []
    submissions = [_submission(student, sheet, layout, roster) for student in layout.students]
    if layout.kind in {"canvas", "moodle", "gradescope"} and roster is None:
        remarks.append(
            f"This is a download from {layout.kind.capitalize()}, and there is no --roster with the students' ids. So each "
            "sheet is graded with the numbers of the id that is typed in it, and if a student typed another student's id, "
            "it is not noticed."
        )
    if roster:
        submitted = {submission.student.casefold() for submission in submissions}
        listed = {student.casefold() for student in roster.ids}
        submissions += [
            Submission(student, student, None) for student in roster.ids if student.casefold() not in submitted
        ]
        unlisted = sorted(
            submission.student for submission in submissions if submission.student.casefold() not in listed
        )
        if unlisted:
            remarks.append(f"Not in the roster, and so not in the file for the platform: {', '.join(unlisted)}.")
    unique = _one_per_student(submissions)
    return Gathered(layout.kind, sorted(unique, key=lambda submission: submission.student.casefold()), remarks)


def typed_id(content: bytes) -> str:
    """The id that is typed in a notebook, found in its code; "" if there is none."""
    try:
        cells = code_cells(content)
    except UnusableNotebook:
        return ""
    match = next((match for cell in cells if (match := STUDENT_ASSIGNMENT.search(cell.source))), None)
    return match[2].strip() if match else ""


def _submission(student: StudentFiles, sheet: str, layout: Layout, roster: Roster | None) -> Submission:
    notebook, notes = _choose_notebook(student.files, sheet)
    if not student.key:
        return Submission(student.name, student.name, notebook, notes)
    if roster is None:
        name = student.key if layout.kind == "gradescope" else f"{student.name}_{student.key}"
        return Submission(name, "", notebook, notes)
    if course_id := roster.id_for_key(student.key):
        return Submission(course_id, course_id, notebook, notes)
    return Submission(f"{student.name}_{student.key}", "", notebook, notes)


def _choose_notebook(files: Sequence[tuple[str, File]], sheet: str) -> tuple[File | None, list[str]]:
    """The newest file with the sheet's name, or else of its copies, or else of those that open the sheet."""
    notebooks = [(name, file) for name, file in files if name.lower().endswith(".ipynb")]
    if not notebooks:
        others = [file for _, file in files]
        return (others[0], [f"No notebook was handed in, only: {list_names(others)}."]) if others else (None, [])
    exact = [file for name, file in notebooks if name.casefold() == f"{sheet}.ipynb".casefold()]
    copy = re.compile(rf"{re.escape(sheet)}[-_ ]*(\(?\d+\)?|copy\d*|kopie\d*)\.ipynb", re.IGNORECASE)
    copies = [file for name, file in notebooks if copy.fullmatch(name)]
    others = [file for _, file in notebooks]
    if not exact and not copies and len(others) > 1:
        others = [file for file in others if _mentions(file, sheet)] or others
    newest = max(exact or copies or others, key=lambda file: (file.modified, file.path))
    if len(notebooks) == 1:
        return newest, []
    return newest, [f"{len(notebooks)} notebooks were handed in; {newest.path} was graded."]


def _mentions(file: File, sheet: str) -> bool:
    try:
        return sheet.encode() in file.read()
    except UnreadableFile:
        return False


def _one_per_student(submissions: Sequence[Submission]) -> list[Submission]:
    """Each student once: if two submissions have the same id, the one with the newer notebook."""
    by_id: dict[str, list[Submission]] = {}
    for submission in submissions:
        by_id.setdefault(submission.student.strip().casefold(), []).append(submission)
    return [_newest(same_id) for same_id in by_id.values()]


def _newest(same_id: Sequence[Submission]) -> Submission:
    newest = max(
        same_id,
        key=lambda submission: (
            submission.notebook is not None,
            submission.notebook.modified if submission.notebook else 0.0,
        ),
    )
    if len(same_id) == 1 or newest.notebook is None:
        return newest
    note = f"{len(same_id)} submissions have this id; the newest, {newest.notebook.path}, was graded."
    return Submission(newest.student, newest.seed_id, newest.notebook, [*newest.notes, note])
