"""The course as a submission sees it: a module of the same name that opens the redacted sheet, and knows no answer.

Where submissions run, the package of the course is not on the disk, nor is the engine. `from kincourse import open_sheet`
finds this module instead. What a notebook may import besides, such as a quiz, is there by name and does nothing.
"""

import importlib.util
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import misstep
from misstep import catalog
from misstep.catalog import Course, installed_courses
from misstep.sheet import OpenSheet, Sheet


@dataclass(frozen=True)
class CourseSetup:
    """What the server of submissions needs of a course.

    package   the name under which notebooks import it
    readable  folders on the disk that submissions may read: the packages that the course requires
    hidden    folders that they may not read: the engine and every course
    warm_up   cells to run once before the first submission
    """

    package: str
    readable: Sequence[str]
    hidden: Sequence[str]
    warm_up: Sequence[str]

    def to_json(self) -> str:
        """The setup as the text of an argument."""
        return json.dumps(asdict(self))


def setup_for(course: Course) -> CourseSetup:
    """What the server needs of this course."""
    courses = [course, *(other for other in installed_courses() if other.package != course.package)]
    hidden = [str(Path(__file__).parents[2]), *(str(each.folder) for each in courses)]
    return CourseSetup(course.package, [_folder(name) for name in course.requires], hidden, course.warm_up)


def _folder(package: str) -> str:
    spec = importlib.util.find_spec(package)
    if spec is None or not spec.submodule_search_locations:
        raise ValueError(f"The course requires the package {package!r}, which is not installed here.")
    return str(Path(next(iter(spec.submodule_search_locations))).resolve())


class CourseStub(ModuleType):
    """A module in place of the course's package."""

    def __init__(self, package: str) -> None:
        super().__init__(package, "The course, while a sheet is graded: open_sheet works, and the rest does nothing.")
        self.__path__: list[str] = []
        self._sheet: Sheet | None = None

    def lay_out(self, sheet: Sheet) -> None:
        """Take the redacted sheet, the only one that can be opened from now on."""
        self._sheet = sheet

    def open_sheet(self, name: str, student: Any) -> OpenSheet:
        """Open the redacted sheet. Raises ValueError for another one."""
        if self._sheet is None or name != self._sheet.name:
            raise ValueError(
                f"There is no sheet {name!r} here; the one that is graded is {self._sheet and self._sheet.name!r}."
            )
        return OpenSheet(self._sheet, student)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return _nothing


def _nothing(*_: Any, **__: Any) -> None:
    """Do nothing: a question or a quiz has no reader while a sheet is graded."""


def install(package: str) -> CourseStub:
    """Put the stub in the place of the course, for imports of its package and for courses that are loaded by a path."""
    stub = CourseStub(package)
    for name in [name for name in sys.modules if name == package or name.startswith(f"{package}.")]:
        del sys.modules[name]
    sys.modules[package] = stub
    for module in (misstep, catalog):
        module.load_course = module.find_course = lambda _: stub  # type: ignore[assignment]
    return stub
