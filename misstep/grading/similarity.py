"""Answers beside each other: to the right one, so that wrong answers that are alike are one row, and to those of other students.

Everybody has other numbers, so two answers are alike if each of their numbers has the same relation to the right one: equal,
with the other sign, 0, or a multiple. And two students with other numbers who gave the same wrong answer share it.
"""

import json
from collections import defaultdict
from collections.abc import Iterable, Sequence
from itertools import combinations
from typing import Any

from misstep.answers.base import TOLERANCE
from misstep.grading.result import Result

MIN_SHARED = 2
"""How many answers two students must share. One alone may be the same by chance, or by the same mistake."""

MAX_GROUP = 5
"""An answer that more students share is an obvious one, such as a matrix of zeros."""


def split_numbers(data: Any) -> tuple[str, list[float]]:
    """Return the form of stored data without its numbers, and the numbers in order.

    >>> split_numbers({"array": [1.0, 2.0], "shape": [2]})
    ('{"array": [0, 0], "shape": [0]}', [1.0, 2.0, 2.0])
    """
    numbers: list[float] = []

    def form(part: Any) -> Any:
        if isinstance(part, list):
            return [form(item) for item in part]
        if isinstance(part, dict):
            return {name: form(item) for name, item in sorted(part.items())}
        if isinstance(part, int | float) and not isinstance(part, bool):
            numbers.append(float(part))
            return 0
        return part

    try:
        return json.dumps(form(data)), numbers
    except OverflowError:  # an integer that is no floating-point number
        return "", []


def relation(answer: Any, right: Any) -> str:
    """Return the relation of each number of an answer to the right one, as text that is equal for answers that are alike.

    >>> relation([1.0, -2.0, 0.0, 6.0], [1.0, 2.0, 3.0, 4.0])
    '= - 0 x1.5'
    >>> relation({"text": "b"}, [1.0])
    'of another form'
    """
    (form, mine), (right_form, others) = split_numbers(answer), split_numbers(right)
    if not mine or form != right_form:
        return "of another form"
    said = []
    for one, other in zip(mine, others, strict=True):
        near = TOLERANCE * max(abs(other), 1.0)
        cases = {"=": abs(one - other), "-": abs(one + other), "0": abs(one)}
        multiple = f"x{one / other:.2g}" if abs(other) > near else "not 0"
        said.append(next((name for name, distance in cases.items() if distance <= near), multiple))
    return " ".join(said)


def unnamed_rows(results: Iterable[Result]) -> list[list[str]]:
    """Return a row for each group of wrong answers without a name that are alike: the largest groups of each problem first."""
    alike: dict[tuple[str, str], list[tuple[Any, Any]]] = defaultdict(list)
    for result in results:
        for one in result.problems:
            if one.unnamed:
                alike[one.number, one.unnamed[0]].append((one.answer, one.unnamed[1]))
    ordered = sorted(alike.items(), key=lambda item: (item[0][0], -len(item[1]), item[0][1]))
    return [[number, str(len(ones)), said, *map(json.dumps, ones[0])] for (number, said), ones in ordered]


def shared_answers(results: Sequence[Result]) -> dict[str, str]:
    """Return the students who share several answers of which one is wrong, with whom and where.

    Only answers with a number that is not whole are compared, because others are the same by chance.
    """
    pairs: dict[tuple[int, int], list[str]] = defaultdict(list)
    for k in range(len(results[0].problems) if results else 0):
        groups: dict[str, list[int]] = defaultdict(list)
        for place, result in enumerate(results):
            form, numbers = split_numbers(result.problems[k].answer)
            if any(number % 1 for number in numbers):
                groups[f"{form} {[f'{number:.6g}' for number in numbers]}"].append(place)
        for group in groups.values():
            for one, other in combinations(group, 2) if len(group) <= MAX_GROUP else ():
                if {results[one].problems[k].state, results[other].problems[k].state} != {"right"}:
                    pairs[one, other].append(results[one].problems[k].number)
    found: dict[str, list[str]] = defaultdict(list)
    for pair, problems in pairs.items():
        for one, other in (pair, pair[::-1]) if len(problems) >= MIN_SHARED else ():
            found[results[one].student].append(f"{results[other].student} ({', '.join(problems)})")
    return {student: "; ".join(others) for student, others in found.items()}
