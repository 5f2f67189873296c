"""The course as a submission sees it: a module of the same name that opens the redacted sheet and knows no answer.

Where submissions run, neither the package of the course nor the engine is on the disk. `from kincourse import open_sheet`
finds this module instead. Everything else that a notebook may import from the course, such as a quiz, exists and does
nothing.
"""

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.metadata import entry_points
from pathlib import Path
from types import ModuleType
from typing import Any

import misstep
from misstep import catalog
from misstep.catalog import ENTRY_POINT_GROUP, Course, forget_package
from misstep.sheet import SAMPLE_ID, OpenSheet, Sheet


@dataclass(frozen=True)
class CourseSetup:
    """What the server of submissions needs to know about a course.

    package   the name under which notebooks import it
    readable  folders that submissions may read: the packages that the course requires
    hidden    folders that they must not read: the engine and every course
    warm_up   cells to run once before the first submission, because first imports are slow
    """

    package: str
    readable: Sequence[str]
    hidden: Sequence[str]
    warm_up: Sequence[str]


def setup_for(course: Course, *more_hidden: Path) -> CourseSetup:
    """What the server needs to know about this course.

    more_hidden  further folders that submissions must not read, such as the folder of the released sheet

    Raises ValueError if the course is not a folder on the disk, or requires a package that is not installed.
    """
    if not course.folder.is_dir():
        raise ValueError(
            f"The course {course.package} must be a folder on the disk, so that submissions can be kept from reading it; "
            f"it is in {course.folder}. Install it unpacked, or pass its folder with --course."
        )
    readable = [str(folder) for folder in required_folders(course)]
    hidden = {engine_folder(), course.folder, *more_hidden, *_folders(course.package)}
    for entry in entry_points(group=ENTRY_POINT_GROUP):
        hidden |= {*_folders(entry.module.partition(".")[0])}
    return CourseSetup(
        course.package, readable, sorted({str(folder.resolve()) for folder in hidden}), tuple(course.warm_up)
    )


def engine_folder() -> Path:
    """The folder of the package misstep."""
    return Path(__file__).parents[2]


def required_folders(course: Course) -> list[Path]:
    """The folders of the packages that a course requires. Raises ValueError for one that is not installed."""
    found = {package: sorted({*_folders(package)}) for package in course.requires}
    if missing := [package for package, folders in found.items() if not folders]:
        raise ValueError(f"The course requires the package {missing[0]!r}, which is not installed here.")
    return [folder for folders in found.values() for folder in folders]


def _folders(package: str) -> Iterator[Path]:
    """Every folder from which this package can be imported.

    The import system itself would stop at the first one, and at a module that is loaded from another folder.
    """
    for finder in sys.meta_path:
        for path in ([entry] for entry in sys.path):
            spec = finder.find_spec(package, path)
            if spec and spec.origin:  # without an origin, it is only a folder that happens to have this name
                for folder in spec.submodule_search_locations or ():
                    yield Path(folder).resolve()
    for folder in getattr(sys.modules.get(package), "__path__", ()):
        yield Path(folder).resolve()


class Withheld(ValueError):
    """Something of the student's notebook is not available while a sheet is graded."""


class Unavailable:
    """The value of a name that could not be set while a sheet is graded. Whatever uses it raises Withheld, and says why."""

    def __init__(self, reason: str) -> None:
        self.__dict__["reason"] = reason

    def __repr__(self) -> str:
        return str(self.__dict__["reason"])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        raise Withheld(repr(self))


def _withhold(self: Unavailable, *_: Any, **__: Any) -> Any:
    raise Withheld(repr(self))


BINARY = ("add", "sub", "mul", "truediv", "matmul", "pow", "mod", "floordiv")
USES = ("call", "getitem", "contains", "iter", "len", "enter", "exit", "neg", "bool", "float", "int", "index", "array")
for _name in (*BINARY, *(f"r{name}" for name in BINARY), *USES):
    setattr(Unavailable, f"__{_name}__", _withhold)


class CourseStub(ModuleType):
    """A module in place of the course's package."""

    def __init__(self, package: str) -> None:
        super().__init__(
            package, "The course while a sheet is graded: open_sheet works, and everything else does nothing."
        )
        self.__path__: list[str] = []
        self._sheet: Sheet | None = None

    @property
    def COURSE(self) -> "CourseStub":
        """The stub itself, for notebooks that use the course object."""
        return self

    def set_sheet(self, sheet: Sheet) -> None:
        """Set the redacted sheet, the only one that can be opened from now on."""
        self._sheet = sheet

    def open_sheet(self, name: str, student: Any) -> OpenSheet:
        """Open the redacted sheet. It has the numbers of the student who is graded, whatever the id.

        student  if it is empty, or could not be asked for, the sheet is opened without an id

        Raises Withheld for the name of any other sheet.
        """
        if self._sheet is None or name != self._sheet.name:
            raise Withheld(
                f"While sheet {self._sheet and self._sheet.name!r} is graded, no other sheet can be opened; got {name!r}."
            )
        if not isinstance(student, Unavailable) and student != "":
            return OpenSheet(self._sheet, student)
        sheet = OpenSheet(self._sheet, SAMPLE_ID)
        sheet.student = ""
        return sheet

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return _do_nothing


def _do_nothing(*_: Any, **__: Any) -> None:
    """Do nothing: questions and quizzes have no reader while a sheet is graded."""


def install_stub(package: str) -> CourseStub:
    """Put a stub in the place of the course, for imports of its package and for courses that are loaded by their path."""
    stub = CourseStub(package)
    forget_package(package)
    sys.modules[package] = stub
    for module in (misstep, catalog):
        for function in ("load_course", "find_course"):
            setattr(module, function, lambda _: stub)
    return stub
