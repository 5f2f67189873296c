"""Judging: from a student's answer to a fraction of the points and a reason.

The judge only computes. It neither draws nor prints, so it can run in a process in which no student code ever ran.
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
    """Why some parts of an answer are wrong: the name and the message of a mistake, or a hint if no mistake explains them."""

    parts: Sequence[str]
    message: str
    mistake: str | None = None


@dataclass(frozen=True)
class Judgement:
    """The result of judging one answer: its state, the fraction of the points, the right parts, and why the others are wrong."""

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

    First each mistake is compared with the whole answer, then with each wrong part separately, because a mistake is often made
    in one part and not in the next.
    """
    answer = problem.answer
    if is_blank(given):
        return Judgement("blank", findings=[Finding(answer.parts, f"Expected: {answer.expected}.")])
    try:
        value = answer.read(given)
    except Unreadable as error:
        return Judgement("unreadable", findings=[Finding(answer.parts, str(error))])
    right = answer.agrees(value, answer.value)
    wrong = [part for part, is_right in enumerate(right) if not is_right]
    if not wrong:
        return Judgement("right", 1.0, answer.parts)
    names = answer.parts
    return Judgement(
        "partly" if any(right) else "wrong",
        sum(right) / len(right),
        [names[part] for part, is_right in enumerate(right) if is_right],
        _findings(problem, value, wrong),
    )


def _findings(problem: Problem, value: Any, wrong: list[int]) -> list[Finding]:
    """Return a finding for the whole answer if a mistake explains it; otherwise for each mistake, and each unexplained part."""
    answer, names = problem.answer, problem.answer.parts
    for mistake in problem.mistakes:
        if all(answer.agrees(value, mistake.value)):
            return [Finding([names[part] for part in wrong], mistake.message, mistake.name)]
    parts_by_cause: dict[Mistake | None, list[int]] = {}
    for part in wrong:
        cause = next((m for m in problem.mistakes if answer.agrees(value, m.value)[part]), None)
        parts_by_cause.setdefault(cause, []).append(part)
    findings = []
    for cause, parts in parts_by_cause.items():
        if cause:
            findings.append(Finding([names[part] for part in parts], cause.message, cause.name))
        else:
            findings += [Finding([names[part]], _hint(answer, value, part)) for part in parts]
    return findings


def _hint(answer: Answer, value: Any, part: int) -> str:
    """Return a true statement about a wrong part that no mistake explains, as a first step towards finding the error."""
    if answer.agrees(value, answer.value, ROUNDING_TOLERANCE)[part]:
        return "This is close, but off in the second or third digit: it looks rounded on the way. Keep all digits until the end."
    return (
        answer.hint(value, part)
        or "None of the mistakes that we know gives this. Go back to what is given, and check one step at a time."
    )
