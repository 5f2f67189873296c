"""Answers that are wrong for the student who gave them, and right for another student.

Numbers differ from student to student, so such an answer was probably not computed from the student's own numbers. It is a
reason to ask, never a proof: if a problem has few possible answers, two students agree by chance, and the number of students
for whom the answer would be right shows it. Answers are compared as data. Nothing of a submission is run here.
"""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from misstep.answers.accuracy import TOLERANCE
from misstep.grading.judging.result import Result
from misstep.grading.publish.csv_table import format_csv

WRONG_STATES = {"wrong", "partly"}


@dataclass(frozen=True)
class Match:
    """A wrong answer that is right for other students.

    others        the students for whom it is right; if there are many, the match means little
    shared_count  how many of the student's wrong answers are right for one and the same of them; if there are many, the match
                  means much
    """

    student: str
    problem: str
    others: Sequence[str]
    shared_count: int = 1


def find_matches(results: Sequence[Result]) -> list[Match]:
    """Every such answer, the most significant first."""
    count = len(results[0].problems) if results else 0
    matches = [match for k in range(count) for match in _matches_of_problem(results, k)]
    pairs = Counter((match.student, other) for match in matches for other in match.others)
    counted = [
        replace(match, shared_count=max(pairs[match.student, other] for other in match.others)) for match in matches
    ]
    return sorted(counted, key=lambda match: (-match.shared_count, match.student.casefold(), match.problem))


def _matches_of_problem(results: Sequence[Result], k: int) -> Iterable[Match]:
    """Compare answers of the same form: for each form, the numbers of the right answers are rows of an array."""
    owners: dict[str, list[str]] = {}
    rows: dict[str, list[list[float]]] = {}
    for result in results:
        problem = result.problems[k]
        for right in [problem.right, problem.answer if problem.state == "right" else None]:
            form, numbers = split_numbers(right)
            if form:
                owners.setdefault(form, []).append(result.student)
                rows.setdefault(form, []).append(numbers)
    arrays = {form: np.array(numbers, dtype=float) for form, numbers in rows.items()}
    for result in results:
        problem = result.problems[k]
        # An answer that the judge could not read may be any JSON, so only wrong and partly right ones are compared.
        form, numbers = split_numbers(problem.answer if problem.state in WRONG_STATES else None)
        if form in arrays:
            right = arrays[form]
            is_equal = (np.abs(right - numbers) <= TOLERANCE * np.maximum(np.abs(right), 1.0)).all(axis=-1)
            others = {owners[form][row] for row in np.flatnonzero(is_equal)} - {result.student}
            if others:
                yield Match(result.student, problem.number, sorted(others))


def split_numbers(data: Any) -> tuple[str, list[float]]:
    """The form of an answer without its numbers, and the numbers in order; "" for answers that cannot be compared."""
    numbers: list[float] = []

    def without_numbers(part: Any) -> Any:
        if isinstance(part, bool) or part is None or isinstance(part, str):
            return part
        if isinstance(part, int | float):
            numbers.append(float(part))
            return 0
        if isinstance(part, list):
            return [without_numbers(item) for item in part]
        return {str(key): without_numbers(item) for key, item in sorted(part.items(), key=str)}

    if data is None or "other" in data or "function" in data:
        return "", []
    return json.dumps(without_numbers(data)), numbers


def matches_table(matches: Sequence[Match]) -> str:
    """The matches as CSV."""
    header = ["student", "problem", "right for", "how many others", "answers right for one of them"]
    rows = ([m.student, m.problem, ", ".join(m.others[:5]), str(len(m.others)), str(m.shared_count)] for m in matches)
    return format_csv(header, rows)
