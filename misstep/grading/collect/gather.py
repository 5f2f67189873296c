"""Gather submissions: from a folder or a download to one submission for each student, with remarks on its files."""

import re
import unicodedata
from collections import defaultdict
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path

from misstep.grading.collect.files import File, UnreadableFile, list_files, list_names
from misstep.grading.collect.layouts import StudentFiles, detect_layout
from misstep.grading.collect.roster import Roster

MAX_NOTEBOOKS = 3
"""How many notebooks of one student are graded, of which the best one counts. More of them would be guesses."""


PLATFORMS = frozenset({"canvas", "moodle", "gradescope"})
"""The kinds of downloads whose files are assigned by the key of a platform, and not by an id."""


class WrongRoster(RuntimeError):
    """Most submissions are of students who are not in the roster, so nothing is graded."""


@dataclass(frozen=True)
class Submission:
    """What one student submitted.

    student    the course id, or without a roster the name that the platform gives
    seed_id    the id from which the numbers are drawn; "" for the one that is typed in the notebook
    notebooks  the files to grade, of which the best one counts; none if nothing was submitted
    notes      remarks on the files
    """

    student: str
    seed_id: str
    notebooks: Sequence[File] = ()
    notes: Sequence[str] = ()

    def notebook_with(self, digest: str) -> File | None:
        """The notebook that has this SHA-256, or else the first one; None if nothing was submitted."""
        for file in self.notebooks[1:]:
            with suppress(UnreadableFile):
                if sha256(file.read()).hexdigest() == digest:
                    return file
        return self.notebooks[0] if self.notebooks else None


@dataclass(frozen=True)
class Gathered:
    """The submissions of all students, ordered by student, the kind of the download, and remarks for the instructor."""

    kind: str
    submissions: Sequence[Submission]
    remarks: Sequence[str] = ()


def gather(source: Path, sheet: str, roster: Roster | None = None) -> Gathered:
    """Find what each student submitted.

    With a roster, every student in it gets a submission, and students who are not in it are listed in the remarks.

    Raises ValueError if there are no submissions, and WrongRoster if more than half of them are not in the roster.
    """
    kind, students = detect_layout(list_files(source), sheet)
    remarks: list[str] = []
    tests = [student for student in students if roster and student.key and student.key in roster.test_keys]
    submissions = [_submission(student, sheet, kind, roster) for student in students if student not in tests]
    if kind in PLATFORMS and roster is None:
        remarks.append(
            f"This is a download from {kind.capitalize()}, and there is no --roster with the students' ids. So each "
            "sheet is graded with the numbers of the id that is typed in it, and if a student typed another student's id, "
            "it is not noticed."
        )
    if roster:
        submissions = _with_ids_of(roster, submissions)
        submitted = {submission.student for submission in submissions}
        submissions += [Submission(student, student) for student in roster.ids if student not in submitted]
        unlisted = sorted(submitted - set(roster.ids))
        known = {name.lower() for name in roster.ids}
        if 2 * sum(name.lower() not in known for name in unlisted) > len(submitted):
            column = roster.key_column if kind in PLATFORMS else roster.id_column
            keys = [row[column].strip() for row in roster.rows[:3]]
            raise WrongRoster(
                f"{len(unlisted)} of {len(submitted)} submissions are not in the roster, for example "
                f"{', '.join(unlisted[:3])}. Its column {roster.columns[column]!r} has, for example, "
                f"{', '.join(keys)}. Is it the list of this course, exported by the same platform as the submissions? "
                "Nothing was graded."
            )
        if unlisted:
            remarks.append(f"Not in the roster, and so not in the file for the platform: {', '.join(unlisted)}.")
        if roster.unsure_of:
            remarks.append(
                f"The ids are read from the column {roster.columns[roster.id_column]!r} of the roster, and not from "
                f"{', '.join(map(repr, roster.unsure_of))}. Name another column with --id-column."
            )
    if tests:
        remarks.append(f"Left out, because it is the platform's test student: {', '.join(one.name for one in tests)}.")
    unique = _one_per_student(submissions)
    remarks += _remarks_on_ids(unique, kind)
    return Gathered(kind, sorted(unique, key=lambda one: (one.student.casefold(), one.student)), remarks)


def _with_ids_of(roster: Roster, submissions: Sequence[Submission]) -> list[Submission]:
    """The submissions with the ids as the roster spells them, where capitals are the only difference, and only for one of them."""
    taken = {submission.student for submission in submissions}
    free = defaultdict(list)
    for student in roster.ids:
        if student not in taken:
            free[student.lower()].append(student)
    counts: dict[str, int] = defaultdict(int)
    for submission in submissions:
        counts[submission.student.lower()] += submission.student not in roster.ids
    spelled = []
    for submission in submissions:
        name = submission.student
        same = free[name.lower()] if name not in roster.ids and counts[name.lower()] == 1 else []
        spelled.append(replace(submission, student=same[0], seed_id=same[0]) if len(same) == 1 else submission)
    return spelled


def _remarks_on_ids(submissions: Sequence[Submission], kind: str) -> list[str]:
    """Which ids are almost the same, and which students have files under several names: one may be somebody else's.

    In a download of a platform, the platform says whose a file is.
    """
    alike = defaultdict(list)
    for submission in submissions:
        alike[unicodedata.normalize("NFKC", submission.student).casefold()].append(submission.student)
    remarks = [
        f"These ids differ only in capitals or in the form of their letters, and are graded as different students: "
        f"{', '.join(map(repr, names))}."
        for names in alike.values()
        if len(names) > 1
    ]
    return remarks + [
        f"{submission.student!r} has {len(submission.notebooks)} notebooks ({list_names(submission.notebooks)}). The best one "
        "counts; look whether all are of this student."
        for submission in submissions
        if kind == "folder" and len({file.path.parts[0] for file in submission.notebooks}) > 1
    ]


def _submission(student: StudentFiles, sheet: str, kind: str, roster: Roster | None) -> Submission:
    notebooks, notes = _choose_notebooks(student.files, sheet)
    name = seed_id = student.name
    if student.key:
        if course_id := roster and roster.id_for_key(student.key):
            name = seed_id = course_id
        else:
            is_key_readable = roster is None and kind == "gradescope"
            name, seed_id = student.key if is_key_readable else f"{student.name}_{student.key}", ""
    return Submission(name, seed_id, notebooks, notes)


def _choose_notebooks(files: Sequence[tuple[str, File]], sheet: str) -> tuple[list[File], list[str]]:
    """Which files are graded: those that open the sheet, if any does. First those with its name or of its copies, the newest first.

    A browser calls the newer of two files "X (1).ipynb", and the older one is often still blank, so names do not decide.
    """
    notebooks = [(name, file) for name, file in files if name.lower().endswith(".ipynb")]
    if not notebooks:
        others = [file for _, file in files]
        return others[:1], [f"No notebook was handed in, only: {list_names(others)}."] if others else []
    if len(notebooks) > 1:
        notebooks = [(name, file) for name, file in notebooks if _mentions(file, sheet)] or notebooks
    named = re.compile(rf"{re.escape(sheet)}([-_ ]*(\(?\d+\)?|copy\d*|kopie\d*))?\.ipynb", re.IGNORECASE)
    ordered = sorted(
        notebooks, key=lambda one: (bool(named.fullmatch(one[0])), one[1].modified, one[1].path), reverse=True
    )
    notes = []
    if len(ordered) > MAX_NOTEBOOKS:
        left_out = list_names([file for _, file in ordered[MAX_NOTEBOOKS:]])
        notes = [f"{len(ordered)} notebooks were handed in; at most {MAX_NOTEBOOKS} are graded, so not: {left_out}."]
    return [file for _, file in ordered[:MAX_NOTEBOOKS]], notes


def _mentions(file: File, sheet: str) -> bool:
    try:
        return sheet.encode() in file.read()
    except UnreadableFile:
        return False


def _one_per_student(submissions: Sequence[Submission]) -> list[Submission]:
    """Each student once: if two submissions have the same id, the notebooks of both are graded."""
    by_id: dict[str, list[Submission]] = {}
    for submission in submissions:
        by_id.setdefault(submission.student, []).append(submission)
    return [_merged(same_id) for same_id in by_id.values()]


def _merged(same_id: Sequence[Submission]) -> Submission:
    files = [file for submission in same_id for file in submission.notebooks]
    if len(same_id) == 1 or not files:
        return same_id[0]
    newest = sorted(files, key=lambda file: (file.modified, file.path), reverse=True)[:MAX_NOTEBOOKS]
    notes = [note for submission in same_id for note in submission.notes]
    return replace(same_id[0], notebooks=newest, notes=[*notes, f"{len(same_id)} submissions have this id."])
