"""Answers that are wrong for who gave them, and right for somebody else.

Numbers differ from student to student, so such an answer was hardly computed from the student's own. It is a reason to ask,
never a proof: where an answer is one of few, two people meet by chance, and the count of those whom it would fit says so.
Answers are compared as data. Nothing of a submission is run or read as a formula here.
"""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import table
from misstep.validation import Array

SAME = 1e-3
"""How far numbers may be apart, relative to their size where that is above 1: as far as the judge lets them be."""

WRONG = {"wrong", "partly"}


@dataclass(frozen=True)
class Match:
    """A wrong answer that is right for others.

    others    for whom it is right; where there are many, it says little
    together  how many of the student's answers are right for one and the same of them; where there are many, it says much
    """

    student: str
    problem: str
    others: Sequence[str]
    together: int = 1


def matches(results: Sequence[Result]) -> list[Match]:
    """Every such answer, those first that say most."""
    count = len(results[0].problems) if results else 0
    found = [match for place in range(count) for match in _of_problem(results, place)]
    pairs = Counter((match.student, other) for match in found for other in match.others)
    told = [replace(match, together=max(pairs[match.student, other] for other in match.others)) for match in found]
    return sorted(told, key=lambda match: (-match.together, match.student.casefold(), match.problem))


def _of_problem(results: Sequence[Result], place: int) -> Iterable[Match]:
    """Compare answers of one form at a time, each form's numbers as rows of one array."""
    owners: dict[str, list[str]] = {}
    rows: dict[str, list[list[float]]] = {}
    for result in results:
        problem = result.problems[place]
        for right in [problem.right, problem.answer if problem.state == "right" else None]:
            form, numbers = _form(right)
            if form:
                owners.setdefault(form, []).append(result.student)
                rows.setdefault(form, []).append(numbers)
    arrays = {form: np.array(numbers, dtype=float) for form, numbers in rows.items()}
    for result in results:
        problem = result.problems[place]
        # What the judge could not read may be any JSON at all.
        form, numbers = _form(problem.answer if problem.state in WRONG else None)
        if form in arrays:
            fits = _near(arrays[form], np.array(numbers, dtype=float))
            others = {owners[form][row] for row in np.flatnonzero(fits)} - {result.student}
            if others:
                yield Match(result.student, problem.number, sorted(others))


def _near(rights: Array, numbers: Array) -> Array:
    return np.asarray((np.abs(rights - numbers) <= SAME * np.maximum(np.abs(rights), 1.0)).all(axis=-1))


def _form(data: Any) -> tuple[str, list[float]]:
    """What an answer says besides its numbers, and its numbers in order; "" for what nobody can compare."""
    numbers: list[float] = []

    def bare(part: Any) -> Any:
        if isinstance(part, bool) or part is None or isinstance(part, str):
            return part
        if isinstance(part, int | float):
            numbers.append(float(part))
            return 0
        if isinstance(part, list):
            return [bare(item) for item in part]
        return {str(key): bare(item) for key, item in sorted(part.items(), key=str)}

    if data is None or "other" in data or "function" in data:
        return "", []
    return json.dumps(bare(data)), numbers


def matches_table(found: Sequence[Match]) -> str:
    """The list as CSV."""
    header = ["student", "problem", "right for", "how many others", "answers right for one of them"]
    rows = ([m.student, m.problem, ", ".join(m.others[:5]), str(len(m.others)), str(m.together)] for m in found)
    return table(header, rows)
