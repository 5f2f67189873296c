"""Judging: from a student's answer to a fraction of the points and a reason.

The judge only computes. It neither draws nor prints, so it can run in a process in which no student code ever ran.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from misstep.answers.base import Answer, Unreadable
from misstep.explanation import explain, message_of, name_of
from misstep.problem import Problem
from misstep.validation import is_blank

State = Literal["right", "partly", "wrong", "blank", "unreadable"]


@dataclass(frozen=True)
class Finding:
    """Why some parts of an answer are wrong: the name and the message of a mistake, or a hint if no mistake explains them.

    mistake       the name of the mistake; "a or b" if the answer does not show which one, "a and b" if both were made
    alternatives  the names as data: for each explanation that fits, the mistakes that were made together
    """

    parts: Sequence[str]
    message: str
    mistake: str | None = None
    alternatives: tuple[tuple[str, ...], ...] = ()


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
    right = answer.agrees(value, answer.value)
    wrong = [part for part, is_right in enumerate(right) if not is_right]
    if not wrong:
        remark = answer.remark(value)
        return Judgement("right", 1.0, answer.parts, [Finding(answer.parts, remark)] if remark else [])
    return Judgement(
        "partly" if any(right) else "wrong",
        sum(right) / len(right),
        [answer.parts[part] for part, is_right in enumerate(right) if is_right],
        _findings(problem, value, wrong),
    )


def _findings(problem: Problem, value: Any, wrong: list[int]) -> list[Finding]:
    """Return the findings on the wrong parts, in the order of the parts."""
    names = problem.answer.parts
    found: list[tuple[list[int], Finding]] = []
    for parts, mistakes in explain(problem, value, wrong):
        is_whole = parts == wrong and all(problem.answer.agrees(value, mistakes[0].value))
        alternatives = tuple(dict.fromkeys(mistake.names for mistake in mistakes))
        text, name = message_of(mistakes, is_whole), name_of(mistakes)
        found.append((parts, Finding([names[part] for part in parts], text, name, alternatives)))
    explained = {part for parts, _ in found for part in parts}
    found += [([part], _unexplained(problem.answer, value, part)) for part in wrong if part not in explained]
    return [finding for _, finding in sorted(found, key=lambda pair: pair[0])]


def _unexplained(answer: Answer, value: Any, part: int) -> Finding:
    """Return a true statement about a wrong part that no mistake of the problem explains."""
    parts = [answer.parts[part]]
    if answer.is_rounded(value, part):
        return Finding(
            parts,
            "These are the right numbers, but rounded too much. Keep at least four significant digits.",
            "rounded",
            (("rounded",),),
        )
    if named := answer.explanation(value, part):
        return Finding(parts, named[1], named[0], ((named[0],),))
    return Finding(
        parts,
        answer.hint(value, part)
        or "None of the mistakes that we know gives this. Go back to what is given, and check one step at a time.",
    )
