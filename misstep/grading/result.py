"""Results: what one submission earned, problem by problem, and what an instructor has to look at."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from misstep.verdict import returning

GRADED, NOT_RUN, UNREADABLE, ABSENT = "graded", "not run", "unreadable", "absent"
"""The states of a submission. Not run: the notebook is of this sheet, and stores no answer."""

FLAGS = {
    "not run": "No answer is stored. The student must open the notebook, run all cells, save, and hand it in again",
    "partly run": "Some check cells were not run or ended with an error, so these problems have no stored answer",
    "unreadable": "Could not be read",
    "not graded": "Could not be graded",
    "changed": "An answer cell was run after its check, so another answer may be stored than the one in the cell",
    "other id": "The id that was typed is not the student's (--roster gives them, --typed-ids takes those that were typed)",
    "same id": "One id was typed in the notebooks of several students",
    "same answers": "Several answers are the same as those of another student, although their numbers differ",
    "several ids": "The notebooks under this name are of several ids, and one counts. Grade a section, or a class in a zip file, by itself",
    "absent": "Nothing was handed in",
    "unmarked": "A text waits for your points in overrides.csv",
}
"""What needs the eyes of an instructor, and the sentence for it, in the order in which it is said."""


@dataclass(frozen=True)
class ProblemResult:
    """What one problem earned."""

    number: str
    title: str
    points: float
    max: float
    state: str  # right, partly, wrong, open, blank, unreadable; marked by hand; or missing, if no answer is stored
    lines: Sequence[str] = ()  # of the card
    address: str = ""  # of the section to re-read, which the last line names
    answer: Any = None  # as data; None if it has no known form
    mistakes: Sequence[str] = ()
    unnamed: tuple[str, Any] | None = None  # of a wrong answer without a name: its relation to the right one, and that
    note: str = ""  # what the instructor decided


@dataclass(frozen=True)
class Result:
    """The grade of one submission, with its reasons."""

    student: str
    points: float
    max: float
    status: str
    problems: Sequence[ProblemResult]
    reason: str = ""  # for the student, "" if there was no fault
    notes: Sequence[str] = ()  # for the student
    flags: Mapping[str, str] = field(default_factory=dict)  # for each of FLAGS that applies, what it is about
    typed: Sequence[str] = ()  # the ids for which the answers were checked
    file: str = ""  # the name of the notebook that counts
    page: str = field(default="", repr=False)  # of feedback, as HTML

    @property
    def returning(self) -> list[str]:
        """A sentence on each mistake of this student in several problems."""
        return returning((one.number, name) for one in self.problems for name in one.mistakes)
