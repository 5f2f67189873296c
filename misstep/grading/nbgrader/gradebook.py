"""The gradebook of an nbgrader course, filled with results: one transaction a submission.

Formgrader, generate_feedback and export find there what `nbgrader autograde` would have left: the points in gradebook.db,
and a notebook in autograded/ for each student. A grade that a person gave by hand stays.
"""

import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from copy import deepcopy
from dataclasses import replace
from datetime import datetime
from hashlib import sha256
from pathlib import Path
from typing import Any

from traitlets.config.loader import PyFileConfigLoader

from misstep.grading.collect.gather import Handed
from misstep.grading.collect.submission import Master
from misstep.grading.judging.result import Result
from misstep.grading.nbgrader.lazy_nbgrader import lean
from misstep.grading.publish.result_store import write

with lean():
    import nbformat
    from nbformat import NotebookNode
    from nbgrader.api import (
        Assignment,
        Comment,
        Grade,
        Gradebook,
        MissingEntry,
        Student,
        SubmittedAssignment,
        SubmittedNotebook,
    )
    from nbgrader.coursedir import CourseDirectory

    from misstep.grading.nbgrader.cells import filled, restored

FOLDER = re.compile(r"[^./\\\0+][^/\\\0+]{0,79}")
"""An id that can be the name of a student's folder; nbgrader allows no + either."""

KEY = "kinlib"
"""Where an autograded notebook says, in its metadata, from which result it was made."""


def course(folder: Path) -> CourseDirectory:
    """The course in a folder, with the settings of its nbgrader_config.py.

    Raises ValueError for a folder without one.
    """
    if not (folder / "nbgrader_config.py").is_file():
        raise ValueError(f"{folder} holds no nbgrader_config.py. Is it the top of the course?")
    config = PyFileConfigLoader("nbgrader_config.py", path=str(folder.resolve())).load_config()
    config.CourseDirectory.root = str(folder.resolve())
    return CourseDirectory(config=config)


class Ledger:
    """The gradebook of a course, open for the results of one sheet.

    unfit  the students whose ids cannot name a folder; nothing is written for them
    """

    def __init__(
        self, place: CourseDirectory, book: Gradebook, assignment: Assignment, released: NotebookNode, is_anew: bool
    ) -> None:
        self._place, self._book, self._assignment, self._released = place, book, assignment, released
        self._is_anew = is_anew
        self.unfit: list[str] = []

    def enter(self, handed: Handed, result: Result) -> None:
        """Write a result down, in one transaction, with the notebook that belongs to it. One that is there is left as it is."""
        if not FOLDER.fullmatch(result.student):
            self.unfit.append(result.student)
            return
        folder = self._place.format_path(self._place.autograded_directory, result.student, result.sheet)
        target = Path(folder, f"{result.sheet}.ipynb")
        mark = sha256(json.dumps(result.data()).encode()).hexdigest()
        if self._is_anew or _mark(target) != mark:
            _record(self._book, self._assignment, result, _handed_in(self._place, result))
            write(target, _autograded(handed, result, self._released, mark))


@contextmanager
def ledger(folder: Path, sheet: Master, is_anew: bool = False) -> Iterator[Ledger]:
    """Open the gradebook of a course; is_anew, to write down also what it has already.

    Raises ValueError for a folder that is no course, and for an assignment that was never generated.
    """
    place = course(folder)
    released = Path(place.format_path(place.release_directory, ".", sheet.name), f"{sheet.name}.ipynb")
    kept = Path(place.db_url.removeprefix("sqlite:///"))
    for path in (released, kept) if place.db_url.startswith("sqlite:///") else (released,):
        if not path.is_file():
            raise ValueError(f"{path} is not there. First: nbgrader generate_assignment {sheet.name}")
    with Gradebook(place.db_url, place.course_id) as book:
        book.db().expire_on_commit = False  # the assignment stays what it is from one submission to the next
        try:
            assignment = book.find_assignment(sheet.name)
            book.find_notebook(sheet.name, sheet.name)
        except MissingEntry as error:
            raise ValueError(
                f"The gradebook knows no {sheet.name}. First: nbgrader generate_assignment {sheet.name}"
            ) from error
        yield Ledger(place, book, assignment, nbformat.read(released, as_version=4), is_anew)


def _handed_in(place: CourseDirectory, result: Result) -> datetime | None:
    """When it was handed in, if a file beside it says so."""
    collected = place.format_path(place.submitted_directory, result.student, result.sheet)
    try:
        when: datetime | None = place.get_existing_timestamp(collected)
    except (OSError, ValueError, AttributeError):  # a time that is none, and nbgrader's own slip when it says so
        when = None
    return when


def _autograded(handed: Handed, result: Result, released: NotebookNode, mark: str) -> str:
    """The notebook that was graded; where nbformat, which is stricter than we are, cannot read it, the one handed out."""
    try:
        notebook = filled(restored(handed.content(), result, released), result)
        nbformat.validate(notebook)
    except Exception:  # there is no end to what may be wrong with it
        notebook = filled(deepcopy(released), replace(result, cells=()))
    notebook.metadata[KEY] = {"result": mark}
    return json.dumps(notebook, ensure_ascii=False) + "\n"  # nbformat's own form, indented, takes five times as long


def _mark(path: Path) -> str | None:
    try:
        return str(json.loads(path.read_bytes())["metadata"][KEY]["result"])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _record(book: Gradebook, assignment: Assignment, result: Result, when: datetime | None) -> None:
    """All points and comments of one submission, or none of them."""
    problems = {f"check-{k}": problem for k, problem in enumerate(result.problems, start=1)}
    blank = {
        f"answer-{k}" for k, problem in enumerate(result.problems, start=1) if problem.state in {"blank", "missing"}
    }
    try:
        notebook = _submitted(book.db, assignment, result)
        names = {cell.id: cell.name for cell in [*notebook.notebook.grade_cells, *notebook.notebook.solution_cells]}
        notebook.assignment.timestamp = when or notebook.assignment.timestamp
        for grade in notebook.grades:
            grade.auto_score = problems[names[grade.cell_id]].points
            grade.needs_manual_grade = grade.manual_score is not None  # somebody should look at it again
        for comment in notebook.comments:
            comment.auto_comment = "No response." if names[comment.cell_id] in blank else None
        book.db.commit()
    except BaseException:
        book.db.rollback()
        raise


def _submitted(session: Any, assignment: Assignment, result: Result) -> SubmittedNotebook:
    """The student's notebook in the gradebook; made, with a place for each grade and comment, if it is not there."""
    with session.no_autoflush:
        student = session.get(Student, result.student) or Student(id=result.student)
        submission = next((found for found in student.submissions if found.assignment_id == assignment.id), None)
        if submission is None:
            submission = SubmittedAssignment(assignment=assignment, student=student)
            for notebook in assignment.notebooks:
                empty = SubmittedNotebook(notebook=notebook, assignment=submission)
                session.add_all(Grade(cell_id=cell.id, notebook=empty) for cell in notebook.grade_cells)
                session.add_all(Comment(cell_id=cell.id, notebook=empty) for cell in notebook.solution_cells)
            session.add(submission)
    return next(found for found in submission.notebooks if found.notebook.name == result.sheet)
