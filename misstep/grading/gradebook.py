"""nbgrader: write results into the gradebook of a course, which formgrader and `nbgrader export` read.

A grade that was entered by hand in formgrader stays. `nbgrader autograde` would give everybody full points, because a check
cell raises no error; nbgrader_config.py therefore names `Refuse` as its preprocessor.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nbgrader.api import Gradebook, MissingEntry
from nbgrader.coursedir import CourseDirectory
from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets.config.loader import PyFileConfigLoader

from misstep.grading.result import ABSENT, Result


class Refuse(NbGraderPreprocessor):  # type: ignore[misc]  # nbgrader ships no types
    """Stops `nbgrader autograde` with a sentence that says what to do."""

    def preprocess(self, nb: Any, resources: Any) -> Any:
        """Raise RuntimeError."""
        raise RuntimeError(
            "In this course, nbgrader autograde would give everybody full points. "
            "Run: misstep grade submitted --sheet NAME --out results --gradebook ."
        )


def open_course(folder: Path, sheet: str) -> CourseDirectory:
    """Return the nbgrader course in a folder, which has the sheet's assignment.

    Raises ValueError for a folder that is no nbgrader course, and for an assignment that is not generated.
    """
    if not (folder / "nbgrader_config.py").is_file():
        raise ValueError(f"{folder} must have an nbgrader_config.py; is it the top folder of the nbgrader course?")
    config = PyFileConfigLoader("nbgrader_config.py", path=str(folder.resolve())).load_config()
    config.CourseDirectory.root = str(folder.resolve())
    course = CourseDirectory(config=config)
    try:
        with Gradebook(course.db_url, course.course_id) as gradebook:
            gradebook.find_notebook(sheet, sheet)
    except MissingEntry as error:
        command = f"nbgrader generate_assignment {sheet} --force"
        raise ValueError(f"The gradebook must have the assignment {sheet}. First run: {command}") from error
    return course


def record(course: CourseDirectory, sheet: str, results: Sequence[Result]) -> list[str]:
    """Write the points of all students who handed something in. Returns remarks for the instructor.

    Where points change, a grade that was given by hand is marked as one to be looked at again.
    """
    remarks = []
    with Gradebook(course.db_url, course.course_id) as gradebook:
        for result in results:
            student, problems = result.student, result.problems
            if result.status == ABSENT:
                continue
            if abs(result.points - sum(one.points for one in problems)) > 1e-9:
                remarks.append(f"{student} has points for the whole sheet by hand, which a gradebook cannot hold.")
            gradebook.update_or_create_student(student)
            with gradebook.db.no_autoflush:  # nbgrader adds a submission to its assignment, and then to the session
                gradebook.update_or_create_submission(sheet, student)
            for grade in gradebook.find_submission_notebook(sheet, sheet, student).grades:
                one = problems[int(grade.name.rpartition("-")[2]) - 1]  # of the cell check-3, or answer-3 if it is open
                if one.state == "open":
                    grade.needs_manual_grade = grade.manual_score is None
                elif grade.auto_score != one.points:
                    grade.auto_score = one.points
                    grade.needs_manual_grade = grade.manual_score is not None
            gradebook.db.commit()
    return remarks
