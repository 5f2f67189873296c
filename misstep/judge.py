"""Judging: from what a student typed to a score and a reason.

The judge computes; it does not draw and does not print, so that it can run where no student code ever ran.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from misstep.answers.base import ROUNDING_TOLERANCE, Answer, Unreadable
from misstep.mistakes import Mistake
from misstep.problem import Problem
from misstep.validation import is_blank

State = Literal["right", "partly", "wrong", "blank", "unreadable"]


@dataclass(frozen=True)
class Finding:
    """Why some parts of an answer are wrong: the mistake that explains them, or a hint where none does."""

    parts: Sequence[str]
    message: str
    mistake: str | None = None


@dataclass(frozen=True)
class Judgement:
    """What the judge says of one answer: the state, the fraction of the points, what is right, why the rest is not."""

    state: State
    fraction: float = 0.0
    right_parts: Sequence[str] = ()
    findings: Sequence[Finding] = field(default_factory=tuple)

    @property
    def mistakes(self) -> list[str]:
        """The names of the mistakes that were recognised."""
        return [finding.mistake for finding in self.findings if finding.mistake]


def judge(problem: Problem, given: Any) -> Judgement:
    """Compare an answer with the right one, and explain the difference.

    First each mistake is tried on the answer as a whole; then on each wrong part by itself, for people make a mistake
    in one joint and not in the next.
    """
    answer = problem.answer
    if is_blank(given):
        return Judgement("blank", findings=[Finding(answer.parts, f"Expected: {answer.expected}.")])
    try:
        value = answer.read(given)
    except Unreadable as fault:
        return Judgement("unreadable", findings=[Finding(answer.parts, str(fault))])
    right = answer.agrees(value, answer.value)
    wrong = [part for part, fine in enumerate(right) if not fine]
    if not wrong:
        return Judgement("right", 1.0, answer.parts)
    names = answer.parts
    return Judgement(
        "partly" if any(right) else "wrong",
        sum(right) / len(right),
        [names[part] for part, fine in enumerate(right) if fine],
        _explained(problem, value, wrong),
    )


def _explained(problem: Problem, value: Any, wrong: list[int]) -> list[Finding]:
    answer, names = problem.answer, problem.answer.parts
    for mistake in problem.mistakes:
        if all(answer.agrees(value, mistake.value)):
            return [Finding([names[part] for part in wrong], mistake.message, mistake.name)]
    explained_by: dict[Mistake | None, list[int]] = {}
    for part in wrong:
        culprit = next((m for m in problem.mistakes if answer.agrees(value, m.value)[part]), None)
        explained_by.setdefault(culprit, []).append(part)
    findings = []
    for culprit, parts in explained_by.items():
        if culprit:
            findings.append(Finding([names[part] for part in parts], culprit.message, culprit.name))
        else:
            findings += [Finding([names[part]], _foothold(answer, value, part)) for part in parts]
    return findings


def _foothold(answer: Answer, value: Any, part: int) -> str:
    """Something true and useful about a wrong part that no mistake explains."""
    if answer.agrees(value, answer.value, ROUNDING_TOLERANCE)[part]:
        return "This is close, but off in the second or third digit: it looks rounded on the way. Keep all digits until the end."
    return (
        answer.hint(value, part)
        or "None of the mistakes that we know gives this. Go back to what is given, and check one step at a time."
    )
