"""Write results into the gradebook of an nbgrader course.

Afterwards formgrader, generate_feedback and export find what `nbgrader autograde` would have written: the points in
gradebook.db, and a notebook in autograded/ for each student. Grades that were entered by hand stay.
"""

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path
from typing import Any

from nbgrader.api import Gradebook, MissingEntry, SubmittedNotebook
from nbgrader.coursedir import CourseDirectory
from traitlets.config.loader import PyFileConfigLoader

from misstep.grading.collect.run_plan import ReleasedSheet
from misstep.grading.judging.result import Result
from misstep.grading.publish.overrides import Override

FOLDER_NAME = re.compile(r"[^./\\\0+][^/\\\0+]{0,79}")
"""An id that can be the name of a student's folder; nbgrader does not allow a + either."""

GENERATE = "nbgrader generate_assignment {} --force"
"""Without --force, nbgrader skips an assignment whose released notebook is there already, as it is in a checkout."""


def read_course(folder: Path) -> CourseDirectory:
    """The nbgrader course in a folder, with the settings of its nbgrader_config.py.

    Raises ValueError for a folder without that file.
    """
    if not (folder / "nbgrader_config.py").is_file():
        raise ValueError(f"{folder} must have an nbgrader_config.py; is it the top folder of the nbgrader course?")
    config = PyFileConfigLoader("nbgrader_config.py", path=str(folder.resolve())).load_config()
    config.CourseDirectory.root = str(folder.resolve())
    return CourseDirectory(config=config)


class GradebookWriter:
    """Writes the results of one sheet into the open gradebook of a course.

    invalid_ids  the students whose ids cannot be names of folders; nothing is written for them
    """

    def __init__(self, course: CourseDirectory, gradebook: Gradebook, released: Path, overwrite: bool) -> None:
        self._course, self._gradebook, self._released, self._overwrite = course, gradebook, released, overwrite
        self.invalid_ids: list[str] = []

    def record(self, result: Result) -> dict[str, Any]:
        """Write the points of a result. Returns the arguments of `write_notebook`; none if there is no place for it."""
        if not FOLDER_NAME.fullmatch(result.student):
            self.invalid_ids.append(result.student)
            return {}
        folder = self._course.format_path(self._course.autograded_directory, result.student, result.sheet)
        self._record_points(result, _submission_time(self._course, result))
        return {"released": self._released, "target": Path(folder, f"{result.sheet}.ipynb")}

    def _record_points(self, result: Result, submitted: datetime | None) -> None:
        """Write all points and comments. Where points change, a grade given by hand is to be looked at again."""
        problems = {f"check-{k}": problem for k, problem in enumerate(result.problems, start=1)}
        blank = {
            f"answer-{k}" for k, problem in enumerate(result.problems, start=1) if problem.state in {"blank", "missing"}
        }
        notebook = self._submission_notebook(result)
        names = {cell.id: cell.name for cell in [*notebook.notebook.grade_cells, *notebook.notebook.solution_cells]}
        notebook.assignment.timestamp = submitted or notebook.assignment.timestamp
        for grade in notebook.grades:
            points = problems[names[grade.cell_id]].points
            if self._overwrite or grade.auto_score != points:
                grade.auto_score = points
                grade.needs_manual_grade = grade.manual_score is not None
        for comment in notebook.comments:
            comment.auto_comment = "No response." if names[comment.cell_id] in blank else None
        self._gradebook.db.commit()

    def _submission_notebook(self, result: Result) -> SubmittedNotebook:
        names = (result.sheet, result.sheet, result.student)
        with suppress(MissingEntry):
            return self._gradebook.find_submission_notebook(*names)
        self._gradebook.update_or_create_student(result.student)
        with self._gradebook.db.no_autoflush:  # nbgrader adds a submission to its assignment, and then to the session
            self._gradebook.update_or_create_submission(result.sheet, result.student)
        return self._gradebook.find_submission_notebook(*names)

    def entered(self, problems: Sequence[str]) -> dict[str, list[Override]]:
        """The points and comments that were entered in formgrader, by student.

        problems  the numbers of the sheet's problems, such as "03.1"
        """
        found: dict[str, list[Override]] = {}
        cells = self._gradebook.find_notebook(self._released.stem, self._released.stem)
        numbers = {
            cell.id: problems[int(cell.name.rpartition("-")[2]) - 1]
            for cell in [*cells.grade_cells, *cells.solution_cells]
        }
        for notebook in cells.submissions:
            points = {numbers[one.cell_id]: one.manual_score for one in notebook.grades if one.manual_score is not None}
            comments = {numbers[one.cell_id]: one.manual_comment for one in notebook.comments if one.manual_comment}
            student = notebook.assignment.student_id
            for number in sorted({*points, *comments}):
                override = Override(student, number, points.get(number), comments.get(number, ""))
                found.setdefault(student, []).append(override)
        return found


@contextmanager
def open_gradebook(folder: Path, sheet: ReleasedSheet, overwrite: bool = False) -> Iterator[GradebookWriter]:
    """Open the gradebook of an nbgrader course.

    overwrite  whether results that are already there are written again

    Raises ValueError for a folder that is no nbgrader course, and for an assignment that is not generated.
    """
    course = read_course(folder)
    released = Path(course.format_path(course.release_directory, ".", sheet.name), f"{sheet.name}.ipynb")
    database = Path(course.db_url.removeprefix("sqlite:///"))
    for path in (released, database) if course.db_url.startswith("sqlite:///") else (released,):
        if not path.is_file():
            raise ValueError(f"{path} must exist; it does not. First run: {GENERATE.format(sheet.name)}")
    with Gradebook(course.db_url, course.course_id) as gradebook:
        try:
            gradebook.find_notebook(sheet.name, sheet.name)
        except MissingEntry as error:
            raise ValueError(
                f"The gradebook must have the assignment {sheet.name}; it has not. First run: {GENERATE.format(sheet.name)}"
            ) from error
        yield GradebookWriter(course, gradebook, released, overwrite)


def _submission_time(course: CourseDirectory, result: Result) -> datetime | None:
    """When the notebook was submitted, if there is a timestamp file beside it."""
    collected = course.format_path(course.submitted_directory, result.student, result.sheet)
    try:
        submitted: datetime | None = course.get_existing_timestamp(collected)
    except (
        OSError,
        ValueError,
        AttributeError,
    ):  # an invalid time, or an error of nbgrader in its own message about it
        submitted = None
    return submitted
