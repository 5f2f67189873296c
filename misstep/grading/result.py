"""Results: what one submission earned, problem by problem, and what an instructor has to look at."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from misstep.diagnosis.bugs import Observation, Recurrence, recurrences

GRADED, NOT_RUN, UNREADABLE, ABSENT = "graded", "not run", "unreadable", "absent"
"""The states of a submission. Not run: the notebook is of this sheet, and stores no answer."""

FLAGS = {
    "not run": "No answer is stored. The student must open the notebook, run all cells, save, and hand it in again",
    "partly run": "Some check cells were not run, so these problems have no stored answer",
    "unreadable": "Could not be read",
    "not graded": "Could not be graded",
    "changed": "An answer cell was run after its check, so another answer may be stored than the one in the cell",
    "other id": "The id that was typed is not the student's",
    "same id": "One id was typed in the notebooks of several students",
    "same answers": "Several answers are the same as those of another student, although their numbers differ",
    "several ids": "The notebooks under this name are of several ids. Is it the folder of a section or a group?",
    "absent": "Nothing was handed in",
}
"""What needs the eyes of an instructor, and the sentence for it, in the order in which it is said."""


@dataclass(frozen=True)
class ProblemResult:
    """What one problem earned.

    state     right, partly, wrong, blank, unreadable; or missing, if no answer is stored
    lines     of the card, the last one with its address if there is a section to re-read
    answer    the answer as data, in the form of misstep.storage.deserialize; None if it has no such form
    unnamed   for a wrong answer that no mistake explains: how each number is related to the right one, and the right answer
    seen      which mistakes can be made and which were
    note      what the instructor decided
    """

    number: str
    title: str
    points: float
    max: float
    state: str
    lines: Sequence[str] = ()
    address: str = ""
    statement: str = ""
    answer: Any = None
    mistakes: Sequence[str] = ()
    unnamed: tuple[str, Any] | None = None
    seen: Observation | None = None
    note: str = ""


@dataclass(frozen=True)
class Result:
    """The grade of one submission, with its reasons.

    reason  one sentence for the student, "" if there was no fault
    notes   remarks for the student
    flags   for each of FLAGS that applies, what it is about
    typed   the ids for which the answers were checked
    file    the name of the notebook that counts
    page    the page of feedback, as HTML
    """

    student: str
    points: float
    max: float
    status: str
    problems: Sequence[ProblemResult]
    reason: str = ""
    notes: Sequence[str] = ()
    flags: Mapping[str, str] = field(default_factory=dict)
    typed: Sequence[str] = ()
    file: str = ""
    page: str = field(default="", repr=False)

    @property
    def recurrences(self) -> list[Recurrence]:
        """The mistakes of this student across the problems of the sheet."""
        return recurrences([one.seen for one in self.problems if one.seen])

    @property
    def changes(self) -> list[str]:
        """What the instructor decided."""
        return [f"{one.number}: {one.note}" for one in self.problems if one.note]
