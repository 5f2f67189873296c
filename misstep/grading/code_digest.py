"""The code that the results of a sheet depend on: what the sheet and the grader import, and nothing else.

Problems may be corrected later, and then the class is graded again; but not for a change in the sheet of another lecture.
"""

import ast
import re
from collections.abc import Iterator, Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path

from misstep.catalog import FOLDER_PREFIX, Course, find_course
from misstep.grading.sandbox.course_stub import engine_folder, required_folders

GRADER_MODULES = (
    "misstep.grading.judging.grader",
    "misstep.grading.judging.judge_process",
    "misstep.grading.judging.parse_output",
    "misstep.grading.sandbox.server",
    "misstep.grading.sandbox.submission_process",
)
"""The modules from which a submission gets its points."""

PUBLISHING = ("misstep.grading.publish", "misstep.grading.nbgrader")
"""Packages that do not matter, because pages and tables are written again in each run."""

MODULE_NAME = re.compile(r"(\w+(?:\.\w+)+)(?::\w+)?")
"""The name of a module in a string, for example for import_module."""


@cache
def code_digest(course: str, sheet: str) -> str:
    """A digest of the modules of the engine, the course and its required packages on which the results of a sheet depend."""
    files = imported_files(find_course(course), sheet)
    return sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()


def imported_files(course: Course, sheet: str) -> list[Path]:
    """The files that the sheet and the grader import, also inside of functions, ordered by path.

    A sheet that no lecture has, such as that of a robot, may need each module of the course.
    """
    folders = {folder.name: folder for folder in (engine_folder(), *required_folders(course))}
    own = course.folder / f"{FOLDER_PREFIX}{sheet}"
    if own.is_dir():
        course_modules = [f"{course.package}.{own.name}.problems"]
    else:
        course_modules = [
            ".".join([course.package, *file.relative_to(course.folder).with_suffix("").parts])
            for file in course.folder.rglob("*.py")
        ]
    folders[course.package] = course.folder
    todo, done = {course.package, *course_modules, *GRADER_MODULES}, dict[str, Path]()
    while todo:
        name = todo.pop()
        if name in done or name.startswith(PUBLISHING) or (file := _file_of(name, folders)) is None:
            continue
        done[name] = file
        parents = name.split(".")
        todo |= {".".join(parents[:length]) for length in range(1, len(parents))}
        todo |= set(_imports(name, file)) - {*done}
    return sorted(set(done.values()))


def _file_of(name: str, folders: Mapping[str, Path]) -> Path | None:
    top, *rest = name.split(".")
    if top not in folders:
        return None
    place = folders[top].joinpath(*rest)
    candidates = (place / "__init__.py", *([place.with_name(f"{place.name}.py")] if rest else []))
    return next((file for file in candidates if file.is_file()), None)


def _imports(name: str, file: Path) -> Iterator[str]:
    """The names of all modules that a file may import; what it imports from a module may be a module too."""
    package = name.split(".") if file.name == "__init__.py" else name.split(".")[:-1]
    for node in ast.walk(ast.parse(file.read_bytes())):
        match node:
            case ast.Import(names=names):
                yield from (one.name for one in names)
            case ast.ImportFrom(module=module, names=names, level=level):
                base = ".".join(
                    [*(package[: len(package) - level + 1] if level else []), *([module] if module else [])]
                )
                yield base
                yield from (f"{base}.{one.name}" for one in names)
            case ast.Constant(value=str() as text) if found := MODULE_NAME.fullmatch(text):
                yield found[1]
