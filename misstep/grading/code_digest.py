"""The code that the results of a sheet depend on. If a problem is corrected later, the class is graded again."""

from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from pathlib import Path

from misstep.catalog import FOLDER_PREFIX, Course, find_course
from misstep.grading.sandbox.course_stub import code_folders, engine_folder

PUBLISHING = ("publish", "nbgrader")
"""Folders of grading that do not matter, because pages and tables are written again in each run."""


@cache
def code_digest(course: str, sheet: str) -> str:
    """A digest of the engine, the course and its required packages, without the sheets of other lectures."""
    return sha256(b"\0".join(file.read_bytes() for file in _files(find_course(course), sheet))).hexdigest()


def _files(course: Course, sheet: str) -> Iterator[Path]:
    own = course.folder / f"{FOLDER_PREFIX}{sheet}"
    left_out = {engine_folder() / "grading" / name for name in PUBLISHING}
    if own.is_dir():  # a sheet that no lecture has, such as that of a robot, may need each of them
        left_out |= {*course.folder.glob(f"{FOLDER_PREFIX}*")} - {own}
    for folder in code_folders(course):
        yield from sorted(file for file in folder.rglob("*.py") if not left_out & {*file.parents})
