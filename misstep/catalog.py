"""Courses: how the sheets, the blank steps and the questions of a course are found.

A course is a Python package. Each lecture has a folder in it:

    circuits/
        __init__.py                  COURSE = Course("circuits"), and for students: open_sheet = COURSE.open_sheet
        lecture_01_ohm/
            problems.py              SHEET, the sheet "01_ohm"
            blanks.py                BLANKS, the steps that the lecture leaves blank
            questions.toml           its questions, as misstep.questions.item describes them

An installed course is found by its entry point in the group "misstep.courses". Any other course is found by the path of
its folder. A lecture is imported only when it is used.
"""

import importlib
import os
import sys
from argparse import ArgumentParser
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.metadata import entry_points
from importlib.resources import files
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import TYPE_CHECKING, Any

from misstep.display.lecture_address import lecture_address
from misstep.display.static_output import is_page
from misstep.judge import judge
from misstep.problem import Template
from misstep.questions.item import Item, read_questions
from misstep.sheet import SAMPLE_ID, OpenSheet, Sheet
from misstep.verdict import Verdict

if TYPE_CHECKING:
    from misstep.questions.widget import Explanation, Question

ENTRY_POINT_GROUP = "misstep.courses"
"""The group of entry points by which installed courses are found."""

READER_VARIABLE = "JUPYTERHUB_USER"
"""The environment variable in which a JupyterHub says whose server this is."""

FOLDER_PREFIX = "lecture_"
"""The beginning of the name of each lecture's folder."""


@dataclass(frozen=True, eq=False)
class Course:
    r"""The sheets, blank steps and questions of one course.

    package   the name of the Python package, from which students import open_sheet
    requires  the names of packages outside of site-packages that submissions may import
    warm_up   cells that the grader runs once, before the first submission, because first imports are slow
    fallback  returns the sheet of a name that no lecture has, for example from a file beside the notebook; None if there is none
    fallback_hint  what to try if the fallback finds nothing, with {name} for the name of the sheet
    site      the address of the course's site, https://..., which has the pages lectures/01_frames.html; "" if it has none

    A complete course, with one problem, one blank step and one question:

    >>> from tempfile import TemporaryDirectory
    >>> temporary = TemporaryDirectory()
    >>> lecture = Path(temporary.name, "halves_course", "lecture_01_halves")
    >>> lecture.mkdir(parents=True)
    >>> problem = '''
    ... import numpy as np
    ... from misstep import Problem, Sheet, mistake, problem
    ... from misstep.answers.number import Numbers
    ...
    ... @problem("01.1", "A half", points=2, lecture="01_halves#Halves")
    ... def half(sampler):
    ...     x = sampler.integer(1, 9)
    ...     wrong = [mistake("doubled", np.array(2.0 * x), "You multiplied by 2. Divide by 2.")]
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)), wrong, given={"x": x})
    ... '''
    >>> question = '''
    ... [even]
    ... kind = "check"
    ... text = "Half of which number is a whole number?"
    ... options = [{text = "4", right = true, why = "It is even."}, {text = "3", why = "It is odd."}]
    ... '''
    >>> definition = 'from misstep import Course\nCOURSE = Course("halves_course")'
    >>> files = {
    ...     lecture.parent / "__init__.py": definition,
    ...     lecture / "problems.py": problem + 'SHEET = Sheet("01_halves", "Halves", [half])',
    ...     lecture / "blanks.py": problem.replace("01.1", "01.a") + "BLANKS = [half]",
    ...     lecture / "questions.toml": question,
    ... }
    >>> for file, text in files.items():
    ...     _ = file.write_text(text)
    >>> course = load_course(lecture.parent)
    >>> course.sheets(), course.find_sheet("01_halves").points, list(course.blanks())
    (['01_halves'], 2, ['01.a'])
    >>> sheet = course.open_sheet("01_halves", "ada")
    >>> sheet.check(1, 2 * sheet.given(1).x).judgement.mistakes
    ['doubled']
    >>> course.attempt("01.a", None).judgement.state
    'blank'
    >>> course.questions()["01"]["even"] is course.find_question("01/even")
    True
    >>> type(course.ask("01/even")).__name__, type(course.explain("01/even")).__name__
    ('Question', 'Explanation')
    >>> temporary.cleanup()
    """

    package: str
    requires: Sequence[str] = ()
    warm_up: Sequence[str] = ()
    fallback: Callable[[str], Sheet | None] | None = None
    fallback_hint: str = ""
    site: str = ""
    _asked: dict[str, Any] = field(default_factory=dict, init=False, repr=False)
    _tried: set[str] = field(default_factory=set, init=False, repr=False)

    @property
    def folder(self) -> Path:
        """The folder of the package."""
        return Path(str(files(self.package)))

    @property
    def reference(self) -> str:
        """The argument of find_course that finds this course in another process: its package if it is installed, or its folder."""
        return (
            self.package
            if self.package in {entry.name for entry in entry_points(group=ENTRY_POINT_GROUP)}
            else str(self.folder)
        )

    @cached_property
    def lectures(self) -> list[str]:
        """The names of the lectures, in order: "01_frames" is the one in the folder lecture_01_frames."""
        names = (entry.name for entry in files(self.package).iterdir() if entry.is_dir())
        return sorted(name.removeprefix(FOLDER_PREFIX) for name in names if name.startswith(FOLDER_PREFIX))

    def _lectures_with(self, file: str) -> list[str]:
        package = files(self.package)
        return [name for name in self.lectures if (package / f"{FOLDER_PREFIX}{name}" / file).is_file()]

    def sheets(self) -> list[str]:
        """The names of all sheets, in the order of the lectures."""
        return self._lectures_with("problems.py")

    def find_sheet(self, name: str) -> Sheet:
        """Find a sheet by its name.

        Raises ValueError if there is no sheet of this name; the message lists those that exist.
        """
        if name in self.sheets():
            return self._module(name, "problems").SHEET  # type: ignore[no-any-return]
        if self.fallback and (own := self.fallback(name)):
            return own
        hint = self.fallback_hint.format(name=name)
        raise ValueError(f"There is no sheet {name!r}. The sheets are: {', '.join(self.sheets())}. {hint}".rstrip())

    def open_sheet(self, name: str, student: str) -> OpenSheet:
        """Open a sheet for one student, whose id seeds the numbers.

        Raises ValueError for an unknown sheet, and for an empty id.
        """
        return OpenSheet(self.find_sheet(name), student, self.site)

    def blanks(self) -> dict[str, Template]:
        """The steps that the lectures leave blank, by number: "03.a" is the first one of lecture 03."""
        modules = [self._module(name, "blanks") for name in self._lectures_with("blanks.py")]
        return {template.number: template for module in modules for template in module.BLANKS}

    def attempt(self, number: str, answer: Any) -> Verdict:
        """Check a step that a lecture leaves blank. The numbers are the same for everybody; the feedback is that of a sheet.

        Raises ValueError for an unknown number; the message lists those that exist.
        """
        blanks = self.blanks()
        if number not in blanks:
            raise ValueError(f"There is no blank step {number!r}. The blank steps are: {', '.join(blanks)}.")
        template, is_first = blanks[number], number not in self._tried
        judgement = judge(template.variant(SAMPLE_ID), answer)
        if judgement.state in {"partly", "wrong"}:
            self._tried.add(number)
        return Verdict(template, judgement, address=lecture_address(template.lecture, self.site), is_first=is_first)

    def questions(self) -> dict[str, dict[str, Item]]:
        """The questions of each lecture, by the number of the lecture and the name of the question.

        Raises ValueError for an invalid file; the message names the file and the key.
        """
        package = files(self.package)
        found = {
            name: package / f"{FOLDER_PREFIX}{name}" / "questions.toml"
            for name in self._lectures_with("questions.toml")
        }
        return {name.partition("_")[0]: _questions(str(file)) for name, file in found.items()}

    def find_question(self, name: str) -> Item:
        """Find a question by its name, "lecture/question", for example "03/order".

        Raises ValueError for an unknown name; the message lists those that exist.
        """
        lecture, _, key = name.partition("/")
        items = self.questions().get(lecture)
        if items is None:
            raise ValueError(
                f"A question must be named lecture/question, for example 03/order; got {name!r}, and there are no "
                f"questions of a lecture {lecture!r}."
            )
        if key not in items:
            raise ValueError(f"Lecture {lecture} has no question {key!r}. It has: {', '.join(items)}.")
        return items[key]

    def ask(self, name: str) -> "Question":
        """Return a question of a lecture, which displays itself; name is "lecture/question", for example "03/order".

        Pass the result as `after=` to a figure to cover the figure until the reader has answered. The question that is asked
        again is the same one, so an answer survives running a cell again.

        Raises ValueError for an unknown name.
        """
        from misstep.questions.widget import Question

        item, asked = self._question_of_reader(name), self._asked.get(name)
        if asked is None or asked.item != item:
            asked = self._asked[name] = Question(item, name)
        return asked

    def explain(self, name: str, output: str = "") -> "Explanation":
        """Return the explanation of the prediction at ask(name), which displays itself and opens when the reader has answered.

        output  text that a computation has given; it is shown with the explanation, because it tells the answer

        Raises ValueError for an unknown name.
        """
        from misstep.questions.widget import Explanation, Question

        return Explanation(self._asked.get(name) or Question(self._question_of_reader(name), name), output)

    def _question_of_reader(self, name: str) -> Item:
        """The question with its options in the order of this reader, where a JupyterHub says who it is."""
        item, reader = self.find_question(name), os.environ.get(READER_VARIABLE)
        return item.shuffled(f"{name} {reader}") if reader and not is_page() else item

    def _module(self, lecture: str, name: str) -> Any:
        return importlib.import_module(f"{self.package}.{FOLDER_PREFIX}{lecture}.{name}")


@cache
def _questions(path: str) -> dict[str, Item]:
    file = Path(path)
    return read_questions(file.read_text(encoding="utf-8"), f"{file.parent.name}/{file.name}")


def installed_courses() -> list[Course]:
    """Return the installed courses, which are found by their entry points in the group "misstep.courses"."""
    return [entry.load() for entry in entry_points(group=ENTRY_POINT_GROUP)]


def load_course(folder: str | Path) -> Course:
    """Load a course from its folder, which need not be installed.

    Raises ValueError if the folder is not a package that defines COURSE, or has the name of another package.

    >>> from tempfile import TemporaryDirectory
    >>> temporary = TemporaryDirectory()
    >>> folder = Path(temporary.name, "empty_course")
    >>> (folder / "lecture_01_halves").mkdir(parents=True)
    >>> _ = (folder / "__init__.py").write_text('from misstep import Course; COURSE = Course("empty_course")')
    >>> load_course(folder).lectures
    ['01_halves']
    >>> temporary.cleanup()
    """
    path = Path(folder).resolve()
    if not (path / "__init__.py").is_file() or not path.name.isidentifier():
        raise ValueError(
            f"{folder} must be the folder of a course: a Python package whose __init__.py defines COURSE. "
            "Check the path; a relative path starts at the current folder."
        )
    known = sys.modules.get(path.name)
    if known is None or Path(str(known.__file__)).parent != path:
        if known is not None and not isinstance(getattr(known, "COURSE", None), Course):
            raise ValueError(
                f"A course must not have the name of another package; {path.name!r} is already imported from "
                f"{getattr(known, '__file__', 'Python itself')}. Rename the folder."
            )
        forget_package(path.name)  # the lectures of a course of the same name in another folder are cached, too
        spec = spec_from_file_location(path.name, path / "__init__.py", submodule_search_locations=[str(path)])
        known = module_from_spec(spec)  # type: ignore[arg-type]
        sys.modules[path.name] = known
        try:
            spec.loader.exec_module(known)  # type: ignore[union-attr]
        except BaseException:
            forget_package(path.name)  # otherwise the next attempt would find the half-made module
            raise
    course = getattr(known, "COURSE", None)
    if not isinstance(course, Course):
        raise ValueError(f"{path / '__init__.py'} must define COURSE = Course({path.name!r}); it defines {course!r}.")
    return course


def forget_package(package: str) -> None:
    """Remove a package and its modules from those that Python has imported, so that the next import reads them again.

    >>> sys.modules["no_such_course"] = sys.modules["no_such_course.lecture_01_halves"] = sys
    >>> forget_package("no_such_course")
    >>> [name for name in sys.modules if name.startswith("no_such_course")]
    []
    """
    for name in [name for name in sys.modules if name == package or name.startswith(f"{package}.")]:
        del sys.modules[name]


def find_course(reference: str | Path | None) -> Course:
    """Find a course by the name of its package, if it is installed, or by the path of its folder; without either, the one here.

    Raises ValueError if there is no such course, and without a reference if there is more than one.

    >>> find_course("no_such_course")
    Traceback (most recent call last):
        ...
    ValueError: no_such_course must be the folder of a course: ... a relative path starts at the current folder.
    """
    if reference is None:
        return course_in(Path.cwd())
    for entry in entry_points(group=ENTRY_POINT_GROUP):
        if entry.name == str(reference):
            return entry.load()  # type: ignore[no-any-return]
    return load_course(reference)


def add_course_argument(parser: ArgumentParser) -> None:
    """Add the option of a command whose value is the reference of a course."""
    parser.add_argument(
        "--course",
        help="the name of an installed course, or its folder (default: the one here, or the only installed one)",
    )


def course_of(sheet: str) -> Course:
    """Return the installed course that has a sheet of this name.

    Raises ValueError if no installed course has it.
    """
    courses = installed_courses()
    for course in courses:
        if sheet in course.sheets():
            return course
    for course in courses:
        if course.fallback and course.fallback(sheet):
            return course
    names = ", ".join(course.package for course in courses) or "none"
    hints = [course.fallback_hint.format(name=sheet) for course in courses if course.fallback_hint]
    raise ValueError(
        f"No installed course has a sheet {sheet!r}; the installed courses are: {names}. "
        + " ".join([*hints, "If the course is a folder, name it: --course path/to/the_course."])
    )


def course_in(folder: Path) -> Course:
    """Return the only course in a folder, or else the only one that is installed.

    Raises ValueError if there is none, or more than one.
    """
    found = [path.parent for path in sorted(folder.glob("*/__init__.py")) if "COURSE = " in path.read_text("utf-8")]
    if not found and len(installed := installed_courses()) == 1:
        return installed[0]
    if len(found) != 1:
        names = ", ".join(path.name for path in found) or "none"
        raise ValueError(
            f"The folder {folder} must have one course, a package that defines COURSE; it has {names}. "
            "Run the command in the folder of the course, or name the course by --course."
        )
    return find_course(found[0])
