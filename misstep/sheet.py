"""Sheets: problems that are shown, checked and counted in a notebook or in a plain Python session."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

from misstep.diagnosis.explanation import Finding
from misstep.display.failed_answer import FailedAnswer, current_shell
from misstep.display.lecture_address import lecture_address
from misstep.judge import Judgement, judge
from misstep.problem import Problem, Template
from misstep.storage import to_data
from misstep.verdict import Tally, Verdict, returning
from misstep.worked_solution import worked_solution

SAMPLE_ID = "your id"
"""The id in a sheet as it is released. Its numbers are valid, but they are the same for everybody."""


@dataclass(frozen=True)
class Sheet:
    """The problems of one sheet, before the numbers of a student are drawn."""

    name: str
    title: str
    problems: Sequence[Template]

    @property
    def points(self) -> int:
        """The full score."""
        return sum(template.points for template in self.problems)


class OpenSheet:
    """A sheet of one student: it shows problems, checks answers and keeps the verdicts.

    Problems are numbered from 1, as in the notebook.

    site  the address of the course's site, for links to lectures whose notebooks are not there; "" if it has none

    Raises ValueError for an empty id.

    >>> import numpy as np
    >>> from misstep import Mistake, problem
    >>> from misstep.answers.number import Numbers
    >>> @problem("01.1", "A half", points=2, lecture="01_fractions#Halves")
    ... def half(sampler):
    ...     x = sampler.integer(1, 9)
    ...     wrong = [Mistake("doubled", np.array(2.0 * x), "You multiplied by 2. Divide by 2.")]
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)), wrong, given={"x": x})
    >>> sheet = OpenSheet(Sheet("01_fractions", "Fractions", [half]), "ada")
    >>> sheet.show(1)
    **A half** (Usual, 2 points)
    <BLANKLINE>
    What is half of ...?
    <BLANKLINE>
    From `given = sheet.given(1)` you have `given.x`.
    >>> x = sheet.given(1).x
    >>> sheet.check(1, 2 * x).judgement.mistakes
    ['doubled']
    >>> sheet.check(1, x / 2).score, sheet.tally().score
    (2.0, 2.0)
    >>> bool(sheet.problem(1).answer.value == x / 2)
    True
    """

    def __init__(self, sheet: Sheet, student: Any, site: str = "") -> None:
        # Many ids are numbers, and students type them with or without quotes.
        student = str(student) if isinstance(student, int) and not isinstance(student, bool) else student
        if not isinstance(student, str) or not student.strip():
            raise ValueError(
                f"student must be your id, a text such as 'ada'; got {student!r}. Your numbers depend on it."
            )
        self.sheet, self.site = sheet, site
        self.student = student.strip()
        self.verdicts: dict[int, Verdict] = {}
        self._judgements: dict[int, list[Judgement]] = defaultdict(list)
        self._drawn: dict[int, Problem] = {}

    def problem(self, k: int) -> Problem:
        """Return problem k with this student's numbers.

        Raises ValueError for a number that the sheet does not have.
        """
        if k not in self._drawn:
            self._drawn[k] = self._template(k).variant(self.student)
        return self._drawn[k]

    def given(self, k: int) -> SimpleNamespace:
        """Return the given values of problem k as attributes, for example sheet.given(1).home."""
        return SimpleNamespace(**self.problem(k).given)

    def show(self, k: int) -> None:
        """Display the statement and the figure of problem k; outside of IPython, print the statement."""
        template, problem = self._template(k), self.problem(k)
        given = ", ".join(f"`given.{name}`" for name in problem.given)
        note = f"\n\nFrom `given = sheet.given({k})` you have {given}." if given else ""
        text = (
            f"**{template.title}** ({template.level}, {template.points} point{'s' * (template.points != 1)})\n\n"
            f"{problem.statement}{note}"
        )
        if current_shell() is None:
            print(text)
            return
        from IPython.display import Markdown, display  # not a dependency: sheets also work in a plain interpreter

        display(Markdown(text))
        if problem.figure:
            display(problem.figure())

    def check(self, k: int, answer: Any) -> Verdict:
        """Judge an answer to problem k, and explain the result. You can check as often as you like; the last answer counts."""
        template, problem = self._template(k), self.problem(k)
        failed = answer if isinstance(answer, FailedAnswer) else None
        answer = ... if failed else answer
        stored = to_data(answer, problem.answer.inputs)  # for a grader, which judges it again
        emission = {"sheet": self.sheet.name, "problem": k, "student": self.student, "answer": stored}
        judgement = judge(problem, answer)
        if failed:
            judgement = Judgement("unreadable", findings=[Finding(problem.answer.parts, failed.why)])
        is_first = not any(one.state in {"partly", "wrong"} for one in self._judgements[k])
        self._judgements[k].append(judgement)
        address = lecture_address(template.lecture, self.site)
        worked = worked_solution(problem) if judgement.state == "right" and (problem.method or problem.solution) else ()
        self.verdicts[k] = Verdict(template, judgement, emission, address, is_first, worked, problem.further)
        return self.verdicts[k]

    def tally(self) -> Tally:
        """Return the points so far, problem by problem, and the mistakes that returned, also those that were corrected."""
        judged = ((self._template(k).number, one) for k, ones in self._judgements.items() for one in ones)
        found = returning((number, name) for number, one in judged for name in one.mistakes)
        return Tally(self.sheet.problems, dict(self.verdicts), self._note, found)

    def _template(self, k: int) -> Template:
        if k not in range(1, len(self.sheet.problems) + 1):
            raise ValueError(f"{self.sheet.name} has problems 1 to {len(self.sheet.problems)}; got {k!r}.")
        return self.sheet.problems[k - 1]

    @property
    def _note(self) -> str:
        """A reminder for students who have not typed their own id yet, or of the points that no check gives."""
        if SAMPLE_ID in self.student.casefold():
            return f"these are the numbers of {self.student!r}: type your own id at the top"
        marked = sum(one.points for one in self.sheet.problems if one.level == "Open")
        return f"{marked} of them are given by your instructor" if marked else ""

    def __repr__(self) -> str:
        text = (
            f"{self.sheet.title}: {len(self.sheet.problems)} problems, {self.sheet.points} points, for {self.student!r}"
        )
        return f"{text} ({self._note})" if self._note else text
