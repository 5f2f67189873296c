"""Results: what one submission earned, problem by problem, and why."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from misstep.diagnosis.bugs import Alternatives, Observation, Recurrence, recurrences

ABSENT = "absent"
"""The status of a student who submitted nothing."""


@dataclass(frozen=True)
class ProblemResult:
    """What one problem earned.

    number, title, max   of the problem; a number is text such as "03.1"
    points   the points earned
    state    right, partly, wrong, blank, unreadable; or missing, if its check cell gave no answer
    verdict  the text of the card
    statement, figure   of the problem: Markdown, and HTML by the author of the course; a figure is there only if there is
             something to mend
    mistakes the names of the recognised mistakes
    notes    remarks on its cells
    answer   the answer as data, in the form of misstep.storage.deserialize
    right    the right answer as data, for the instructor; None if the problem was not judged
    possible, explanations   which mistakes can be made and which were, as an Observation of misstep.diagnosis.bugs has them
    address  the address of the section to re-read, which the last line of the verdict names; "" if there is none
    own_points  with an instructor's key: the points for the student's own numbers; None if the key does not apply
    """

    number: str
    title: str
    points: float
    max: float
    state: str
    verdict: str
    statement: str = ""
    mistakes: Sequence[str] = ()
    notes: Sequence[str] = ()
    answer: Any = None
    right: Any = None
    possible: Sequence[str] = ()
    explanations: Sequence[Alternatives] = ()
    address: str = ""
    figure: str = ""
    own_points: float | None = None


@dataclass(frozen=True)
class RanCell:
    """A cell that ran: its source, the problem that it checks, its index in the submission, its outputs.

    Outputs are those of a notebook (nbformat 4). They come from the student's code, so escape whatever is shown of them.
    """

    source: str
    problem: int | None
    index: int | None
    outputs: Sequence[Mapping[str, Any]]


@dataclass(frozen=True)
class Result:
    """The grade of one submission, with its reasons.

    status    graded; or broken, if nothing could be run; or stopped, if the run ended before its last cell; or absent, if nothing
              was submitted
    reason    one sentence for the student, "" if there was no fault
    notes     further remarks: another id in the sheet, a cell that failed
    typed_id  the id that is typed in the notebook, "" if none was found
    digest    SHA-256 of the submitted file
    is_safe   whether it ran in the sandbox
    limits    the limits that it reached, in words; without them, it might have more points
    changes   what the instructor decided otherwise, in words; it is never stored with the result
    """

    student: str
    sheet: str
    points: float
    max: float
    status: str
    reason: str
    problems: Sequence[ProblemResult]
    notes: Sequence[str] = ()
    typed_id: str = ""
    digest: str = ""
    is_safe: bool = True
    cells: Sequence[RanCell] = field(default=(), repr=False)
    limits: Sequence[str] = ()
    changes: Sequence[str] = ()

    @property
    def typed(self) -> list[ProblemResult]:
        """With an instructor's key: the problems whose answer is right only for the student's own numbers."""
        return [one for one in self.problems if one.own_points is not None and one.own_points > one.points]

    @property
    def recurrences(self) -> list[Recurrence]:
        """The mistakes of this student across the problems of the sheet."""
        return recurrences([Observation(one.number, one.possible, one.explanations) for one in self.problems])

    def keeping(self, old: "Result", regraded: Sequence[str]) -> "Result":
        """This result with the problems of an old one, except those that were to be graded again.

        Raises ValueError for a problem that the sheet does not have.
        """
        numbers = [problem.number for problem in self.problems]
        if unknown := set(regraded) - set(numbers):
            raise ValueError(
                f"Sheet {self.sheet} has the problems {', '.join(numbers)}; got {', '.join(sorted(unknown))}."
            )
        kept = {problem.number: problem for problem in old.problems if problem.number not in regraded}
        problems = [kept.get(problem.number, problem) for problem in self.problems]
        return replace(self, problems=problems, points=sum(problem.points for problem in problems))

    def to_dict(self) -> dict[str, Any]:
        """The result as JSON holds it. It is not copied, because its cells have all outputs in them."""
        return {**vars(self), "problems": [*map(vars, self.problems)], "cells": [*map(vars, self.cells)]}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> "Result":
        """Read the dictionary of `to_dict`. Raises KeyError or TypeError for any other."""
        problems = [ProblemResult(**problem) for problem in data["problems"]]
        return cls(**{**data, "problems": problems, "cells": [RanCell(**cell) for cell in data["cells"]]})
