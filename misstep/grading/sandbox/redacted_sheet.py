"""The paper: a student's sheet without its answers, as it travels to the process that runs the submission.

The judge writes it, for only the judge draws variants. Where code of students runs, `open_sheet` finds the paper in place
of the sheet: the same titles, statements and given values, and nothing to find behind them.
"""

import base64
import pickle
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from misstep.answers.base import Answer, Unreadable
from misstep.problem import Problem, Template
from misstep.sampling import Sampler
from misstep.sheet import Sheet


@dataclass(frozen=True, eq=False)
class Withheld(Answer):
    """The place of an answer that is not here."""

    inputs: Sequence[Any] = ()

    @property
    def value(self) -> Any:
        """Raises AttributeError for whoever looks here for it."""
        raise AttributeError("While a sheet is graded, its answers are somewhere else. Your own is what counts.")

    @property
    def expected(self) -> str:
        return "your answer"

    @property
    def parts(self) -> Sequence[str]:
        return ["your answer"]

    def read(self, given: Any) -> Any:
        raise Unreadable("It was written down. The points come when all of the sheet is graded.")

    def agrees(self, one: Any, other: Any, tolerance: float = 0.0) -> list[bool]:
        return [False]


class Side(Problem):
    """A problem on a paper. Whoever drew it has seen that its mistakes lead somewhere."""

    def is_discriminating(self) -> bool:
        return True


def written(sheet: Sheet, problems: Sequence[Problem]) -> str:
    """Write the paper of a student: everything of the problems but answers, mistakes and figures."""
    sides = [
        (
            template.number,
            template.title,
            template.points,
            problem.statement,
            dict(problem.given),
            problem.answer.inputs,
        )
        for template, problem in zip(sheet.problems, problems, strict=True)
    ]
    return base64.b64encode(pickle.dumps((sheet.name, sheet.title, sides))).decode()


def laid_out(text: str) -> Sheet:
    """Read a redacted sheet. The judge wrote it: no submission ever has a say in it."""
    name, title, sides = pickle.loads(base64.b64decode(text))  # noqa: S301
    templates = [Template(number, title, points, "", partial(_side, *rest)) for number, title, points, *rest in sides]
    return Sheet(name, title, templates)


def _side(statement: str, given: Mapping[str, Any], inputs: Sequence[Any], _: Sampler) -> Problem:
    return Side(statement, Withheld(inputs), (), given)
