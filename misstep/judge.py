"""Judging: from a student's answer to a fraction of the points and a reason.

Which right parts earn nothing alone is said by `Answer.counts`, and of rows in another order by REORDERED in answers/likeness.py.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from misstep.answers.base import Unreadable
from misstep.answers.prose import Prose
from misstep.diagnosis.explanation import Finding, explain
from misstep.problem import Problem
from misstep.validation import is_blank

UNKNOWN = "We do not recognise what happened here."

STEP_BY_STEP = "Go back to what is given, and check one step at a time."

State = Literal["right", "partly", "wrong", "open", "blank", "unreadable"]
"""Open: a text that only an instructor can mark."""


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


def judge(problem: Problem, given: Any) -> Judgement:  # noqa: PLR0911 - one for each state
    """Compare an answer with the right one, and explain the difference."""
    answer = problem.answer
    if is_blank(given):
        return Judgement("blank", findings=[Finding(answer.parts, f"Expected: {answer.expected}.")])
    try:
        value = answer.read(given)
    except Unreadable as error:
        return Judgement("unreadable", findings=[Finding(answer.parts, str(error))])
    if isinstance(answer, Prose):
        return Judgement("open")
    right = answer.agrees(value, answer.value)
    wrong = [part for part, is_right in enumerate(right) if not is_right]
    if not wrong:
        remark = answer.remark(value)
        return Judgement("right", 1.0, answer.parts, [Finding(answer.parts, remark)] if remark else [])
    findings = explain(problem, value, wrong)
    explained = {part for one in findings for part in one.parts}
    for part in (part for part in wrong if answer.parts[part] not in explained):
        findings.append(Finding([answer.parts[part]], UNKNOWN, check=answer.check(value, part) or STEP_BY_STEP))
    findings.sort(key=lambda one: [list(answer.parts).index(part) for part in one.parts])
    fine = [part for part, is_right in zip(answer.parts, right, strict=True) if is_right]
    if fine and (spoiling := [one for one in findings if one.spoils]):
        return Judgement("wrong", 0.0, fine if any(one.is_method for one in spoiling) else (), findings)
    if fine and not answer.counts(value, right):
        return Judgement("wrong", 0.0, fine, findings)
    return Judgement("partly" if fine else "wrong", len(fine) / len(right), fine, findings)
