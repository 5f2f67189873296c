"""Judging: from a student's answer to a fraction of the points and a reason.

Which right parts earn nothing alone is said by `Answer.counts`, and of rows in another order by REORDERED in answers/likeness.py.
The judge only computes. It neither draws nor prints, so it can run in a process in which no student code ever ran.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from misstep.answers.base import Answer, Remarking, Unreadable
from misstep.answers.prose import Prose
from misstep.diagnosis.explanation import MAX_LENGTH, Explanation, explain, name_of
from misstep.display.sentences import STEP_BY_STEP, UNKNOWN
from misstep.problem import Problem
from misstep.validation import is_blank

State = Literal["right", "partly", "wrong", "open", "blank", "unreadable"]
"""Open: a text that only an instructor can mark."""


@dataclass(frozen=True)
class Finding:
    """Why some parts of an answer are wrong: the name and the message of a mistake, or a hint if no mistake explains them.

    mistake       the name of the mistake; "a or b" if the answer does not show which one, "a and b" if both were made
    message       its first line is the idea; what follows is the place, or the number itself, which is told from the second try on
    alternatives  the names as data: for each explanation that fits, the mistakes that were made together
    check         what the student can check on the own numbers, and what these numbers give
    """

    parts: Sequence[str]
    message: str
    mistake: str | None = None
    alternatives: tuple[tuple[str, ...], ...] = ()
    check: str = ""

    @property
    def text(self) -> str:
        """What a student reads: the message, and the check if there is room."""
        message = self.message.replace("\n", " ")
        both = f"{message} {self.check}".strip()
        return both if len(both) <= MAX_LENGTH else message


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
        remark = answer.remark(value) if isinstance(answer, Remarking) else ""
        return Judgement("right", 1.0, answer.parts, [Finding(answer.parts, remark)] if remark else [])
    return _partly(answer, right, explain(problem, value, wrong), value)


def _partly(answer: Answer, right: list[bool], explanations: Sequence[Explanation], value: Any) -> Judgement:
    """Return the judgement of an answer with a wrong part: what it earns, and why not more."""
    fine = [part for part, is_right in zip(answer.parts, right, strict=True) if is_right]
    findings = _findings(answer, value, [k for k, is_right in enumerate(right) if not is_right], explanations)
    if fine and (spoiling := [one for one in explanations if one.spoils]):
        return Judgement("wrong", 0.0, fine if any(one.is_method for one in spoiling) else (), findings)
    if fine and not answer.counts(value, right):
        return Judgement("wrong", 0.0, fine, findings)
    credit = min((mistake.credit for one in explanations for mistake in one.mistakes), default=0.0)
    if credit and not fine and all(one.is_whole for one in explanations):
        return Judgement("partly", credit, ["what follows from it"], findings)
    return Judgement("partly" if fine else "wrong", len(fine) / len(right), fine, findings)


def _findings(answer: Answer, value: Any, wrong: list[int], explanations: Sequence[Explanation]) -> list[Finding]:
    """Return the findings on the wrong parts, in the order of the parts."""
    names = answer.parts
    found: list[tuple[Sequence[int], Finding]] = []
    for one in explanations:
        alternatives = tuple(dict.fromkeys(mistake.names for mistake in one.mistakes))
        told = [names[part] for part in one.parts]
        name = name_of(one.mistakes)
        found.append((one.parts, Finding(told, one.message, name or None, alternatives if name else (), one.check)))
    explained = {part for parts, _ in found for part in parts}
    for part in wrong:
        if part not in explained:
            check = answer.check(value, part) or STEP_BY_STEP
            found.append(([part], Finding([names[part]], UNKNOWN, check=check)))
    return [finding for _, finding in sorted(found, key=lambda pair: tuple(pair[0]))]
