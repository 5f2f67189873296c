"""Results: what one submission earned, problem by problem, and why."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class ProblemResult:
    """What one problem earned.

    number, title, max   of the problem, "03.1"
    points   earned
    state    right, partly, wrong, blank, unreadable; or missing, where its check cell never gave an answer
    verdict  what the card says, as text; html is the same card, made by the judge and safe to show
    mistakes the names of the mistakes that were recognised
    notes    what was odd about its cells
    answer   the answer as data, as misstep.storage.deserialize writes it
    right    the right answer as data, for whoever grades; None where the problem was not judged
    """

    number: str
    title: str
    points: float
    max: float
    state: str
    verdict: str
    html: str
    mistakes: Sequence[str] = ()
    notes: Sequence[str] = ()
    answer: Any = None
    right: Any = None


@dataclass(frozen=True)
class RanCell:
    """A cell as it ran: its source, the problem it checks, its place in what was handed in, its outputs.

    Outputs are those of a notebook (nbformat 4). They come from the student's code: escape whatever is shown of them.
    """

    source: str
    problem: int | None
    place: int | None
    outputs: Sequence[Mapping[str, Any]]


@dataclass(frozen=True)
class Result:
    """The grade of one submission, with its reasons.

    status    graded; or broken, where nothing could be run; or stopped, where the run ended before its last cell
    reason    one sentence for the student, "" where all went well
    notes     what else was odd: another id in the sheet, a cell that failed
    typed_id  the id that the notebook itself gives, "" if none was seen
    digest    SHA-256 of what was handed in
    is_safe   whether it ran in the sandbox
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
    seconds: float = 0.0
    cells: Sequence[RanCell] = field(default=(), repr=False)

    def data(self) -> dict[str, Any]:
        """The result as JSON holds it. Nothing is copied: this is asked for with every output in it."""
        return {**vars(self), "problems": [*map(vars, self.problems)], "cells": [*map(vars, self.cells)]}
