"""Redacted sheets: a student's sheet without its answers, as it is sent to the process that runs the submission.

Only the judge draws variants, so only the judge writes redacted sheets. Where student code runs, `open_sheet` returns the
redacted sheet: the same titles, statements and given values, and no answers and no mistakes.
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


class AnswerWithheld(AttributeError):
    """The right answer is not in this process."""


@dataclass(frozen=True, eq=False)
class RedactedAnswer(Answer):
    """An answer whose right value is not in this process."""

    inputs: Sequence[Any] = ()

    @property
    def value(self) -> Any:
        """Raises AnswerWithheld, because the right answer is not in this process."""
        raise AnswerWithheld("The right answers are not available while a sheet is graded. Compute your own.")

    @property
    def expected(self) -> str:
        return "your answer"

    @property
    def parts(self) -> Sequence[str]:
        return ["your answer"]

    def read(self, given: Any) -> Any:
        raise Unreadable("Your answer is recorded. Its points are computed after the whole sheet has run.")

    def agrees(self, one: Any, other: Any, tolerance: float = 0.0) -> list[bool]:
        return [False]


class RedactedProblem(Problem):
    """A problem without its answer and its mistakes. The judge has already checked that its mistakes can be told apart."""

    def is_discriminating(self) -> bool:
        return True


def redact(sheet: Sheet, problems: Sequence[Problem]) -> str:
    """Write a student's redacted sheet: everything of the problems but answers, mistakes and figures."""
    contents = [
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
    return base64.b64encode(pickle.dumps((sheet.name, sheet.title, contents))).decode()


def load_redacted(text: str) -> Sheet:
    """Read a redacted sheet. The text comes from the judge, never from a submission, so it may be unpickled."""
    name, title, contents = pickle.loads(base64.b64decode(text))  # noqa: S301
    templates = [
        Template(number, title, points, "", partial(_redacted_problem, *rest))
        for number, title, points, *rest in contents
    ]
    return Sheet(name, title, templates)


def _redacted_problem(statement: str, given: Mapping[str, Any], inputs: Sequence[Any], _: Sampler) -> Problem:
    return RedactedProblem(statement, RedactedAnswer(inputs), given=given)
