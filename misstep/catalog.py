"""The course: how its sheets, blank steps and questions are found.

Each lecture has a folder in the package of the course:

    lecture_03_poe_space/
        problems.py              the problems of the sheet "03_poe_space", and its TITLE
        blanks.py                the steps that the lecture leaves blank
        questions.toml           its questions, as misstep.questions.item describes them

A lecture is imported only when it is used.
"""

import importlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from importlib.metadata import entry_points
from importlib.resources import files
from pathlib import Path
from typing import Any

from misstep.display.failed_answer import watch_cells
from misstep.problem import Template, templates_in
from misstep.questions.item import Item, read_questions
from misstep.questions.widget import Explanation, Question
from misstep.sheet import SAMPLE_ID, OpenSheet, Sheet
from misstep.verdict import Verdict

FOLDER_PREFIX = "lecture_"
"""The beginning of the name of each lecture's folder."""


@dataclass(frozen=True, eq=False)
class Course:
    """The sheets, blank steps and questions of one course.

    package   the name of the Python package, from which students import open_sheet
    requires  the names of further packages that its sheets import
    fallback  returns the sheet of a name that no lecture has, for example from a file beside the notebook, or a hint what to try
    site      the address of the course's site, https://..., which has the pages lectures/01_frames.html; "" if it has none

    >>> course = find_course()
    >>> course.sheets()[2], course.find_sheet("03_poe_space").points > 0, "03.a" in course.blanks()
    ('03_poe_space', True, True)
    >>> sheet = course.open_sheet("03_poe_space", "ada")
    >>> sheet.check(1, None).judgement.state, course.attempt("03.a", None).judgement.state
    ('blank', 'blank')
    >>> course.questions()["03"]["order"] is course.find_question("03/order")
    True
    >>> type(course.ask("03/order")).__name__, type(course.explain("03/order")).__name__
    ('Question', 'Explanation')
    """

    package: str
    requires: Sequence[str] = ()
    fallback: Callable[[str], Sheet | str] = lambda _: ""
    site: str = ""
    _asked: dict[str, Question] = field(default_factory=dict, init=False, repr=False)

    @property
    def folder(self) -> Path:
        """The folder of the package."""
        return Path(str(files(self.package)))

    @cached_property
    def lectures(self) -> list[str]:
        """The names of the lectures, in order: "01_frames" is the one in the folder lecture_01_frames."""
        return sorted(path.name.removeprefix(FOLDER_PREFIX) for path in self.folder.glob(f"{FOLDER_PREFIX}*/"))

    def _lectures_with(self, file: str) -> list[str]:
        return [name for name in self.lectures if (self.folder / f"{FOLDER_PREFIX}{name}" / file).is_file()]

    def sheets(self) -> list[str]:
        """The names of all sheets, in the order of the lectures."""
        return self._lectures_with("problems.py")

    def find_sheet(self, name: str) -> Sheet:
        """Find a sheet by its name.

        Raises ValueError if there is no sheet of this name; the message lists those that exist.
        """
        if name in self.sheets():
            module = self._module(name, "problems")
            return Sheet(name, module.TITLE, templates_in(module))
        own = self.fallback(name)
        if isinstance(own, Sheet):
            return own
        raise ValueError(f"There is no sheet {name!r}. The sheets are: {', '.join(self.sheets())}. {own}".rstrip())

    def open_sheet(self, name: str, student: str) -> OpenSheet:
        """Open a sheet for one student, whose id seeds the numbers.

        Raises ValueError for an unknown sheet, and for an empty id.
        """
        sheet = OpenSheet(self.find_sheet(name), student, self.site)
        watch_cells()
        return sheet

    def blanks(self) -> dict[str, Template]:
        """The steps that the lectures leave blank, by number: "03.a" is the first one of lecture 03."""
        modules = [self._module(name, "blanks") for name in self._lectures_with("blanks.py")]
        return {template.number: template for module in modules for template in templates_in(module)}

    def attempt(self, number: str, answer: Any) -> Verdict:
        """Check a step that a lecture leaves blank. The numbers are the same for everybody; the feedback is that of a sheet.

        Raises ValueError for an unknown number; the message lists those that exist.
        """
        blanks = self.blanks()
        if number not in blanks:
            raise ValueError(f"There is no blank step {number!r}. The blank steps are: {', '.join(blanks)}.")
        checked = self._blank_steps.check([*blanks].index(number) + 1, answer)
        return replace(checked, emission=None)  # nobody grades a lecture

    @cached_property
    def _blank_steps(self) -> OpenSheet:
        return OpenSheet(Sheet("blanks", "Blank steps", [*self.blanks().values()]), SAMPLE_ID, self.site)

    def questions(self) -> dict[str, dict[str, Item]]:
        """The questions of each lecture, by the number of the lecture and the name of the question.

        Raises ValueError for an invalid file; the message names the file and the key.
        """
        folders = {name: self.folder / f"{FOLDER_PREFIX}{name}" for name in self._lectures_with("questions.toml")}
        return {name.partition("_")[0]: _questions(folder / "questions.toml") for name, folder in folders.items()}

    def find_question(self, name: str) -> Item:
        """Find a question by its name, "lecture/question", for example "03/order".

        Raises ValueError for an unknown name; the message lists those that exist.
        """
        lecture, _, key = name.partition("/")
        items = self.questions().get(lecture, {})
        if key not in items:
            raise ValueError(f"There is no question {name!r}. Lecture {lecture} has: {', '.join(items) or 'none'}.")
        return items[key]

    def ask(self, name: str) -> Question:
        """Return a question of a lecture, which displays itself; name is "lecture/question", for example "03/order".

        Pass the result as `after=` to a figure to cover the figure until the reader has answered. The question that is asked
        again is the same one, so an answer survives running a cell again.
        """
        return self._asked.setdefault(name, Question(self.find_question(name), name))

    def explain(self, name: str, output: str = "") -> Explanation:
        """Return the explanation of the prediction at ask(name), which displays itself and opens when the reader has answered.

        output  text that a computation has given; it is shown with the explanation, because it tells the answer
        """
        return Explanation(self.ask(name), output)

    def _module(self, lecture: str, name: str) -> Any:
        return importlib.import_module(f"{self.package}.{FOLDER_PREFIX}{lecture}.{name}")


@cache
def _questions(file: Path) -> dict[str, Item]:
    return read_questions(file.read_text(encoding="utf-8"), f"{file.parent.name}/{file.name}")


def find_course() -> Course:
    """Return the installed course, found by its entry point, because this package does not import the course that uses it.

    >>> find_course().package
    'kincourse'
    """
    (installed,) = entry_points(group="misstep.courses")
    return installed.load()  # type: ignore[no-any-return]
