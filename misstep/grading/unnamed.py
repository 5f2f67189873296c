"""The wrong answers of a graded class that have no name: grouped by problem and likeness, without the names of students.

Everybody has other numbers, so two answers are alike if each of their numbers stands in the same relation to the right one: equal,
with the other sign, left at 0, or a multiple. A group of several is a mistake that the sheet does not know yet.
"""

import json
from argparse import ArgumentParser, Namespace
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from misstep.answers.accuracy import TOLERANCE
from misstep.grading.judging.result import ProblemResult
from misstep.grading.publish.result_store import stored_results
from misstep.grading.publish.shared_answers import WRONG_STATES, split_numbers

MAX_FLOAT = 10**300
"""A larger number is no floating-point number."""


@dataclass(frozen=True)
class Group:
    """Answers to one problem that are alike: how many, in what relation to the right one, and one of them as data."""

    problem: str
    count: int
    relation: str
    answer: Any
    right: Any


def relation(answer: Any, right: Any) -> str:
    """Return the relation of each number of an answer to the right one, as text that is equal for answers that are alike.

    >>> relation([1.0, -2.0, 0.0, 6.0], [1.0, 2.0, 3.0, 4.0])
    '= - 0 x1.5'
    >>> relation("b", [1.0])
    'of another form'
    >>> relation({"number": 0.25}, {"exact": "1/2"})
    'x0.5'
    """
    (form, mine), (right_form, others) = (split_numbers(_as_mapping(_in_decimals(x))) for x in (answer, right))
    if not form or form != right_form or not mine:
        return "of another form"
    return " ".join(_relation_of(one, other) for one, other in zip(mine, others, strict=True))


def _in_decimals(data: Any) -> Any:
    """Return stored data with its exact numbers as others: a student types 0.25 where the author has 1/4."""
    if isinstance(data, Mapping):
        if set(data) == {"exact"}:
            exact = Fraction(data["exact"])
            return {"number": float(exact)} if abs(exact) < MAX_FLOAT else data
        return {name: _in_decimals(value) for name, value in data.items()}
    return list(map(_in_decimals, data)) if isinstance(data, list) else data


def _as_mapping(data: Any) -> Any:
    return {"value": data} if isinstance(data, list | str | int | float) else data


def _relation_of(one: float, other: float) -> str:
    near = TOLERANCE * max(abs(other), 1.0)
    if abs(one - other) <= near:
        return "="
    if abs(one + other) <= near:
        return "-"
    if abs(one) <= near:
        return "0"
    return f"x{one / other:.2g}" if abs(other) > near else "not 0"


def groups(problems: Iterable[ProblemResult]) -> list[Group]:
    """Group the wrong answers without a name, the largest groups first within each problem."""
    alike: dict[tuple[str, str], list[ProblemResult]] = defaultdict(list)
    for one in problems:
        if one.state in WRONG_STATES and not one.mistakes:
            alike[one.number, relation(one.answer, one.right)].append(one)
    found = [Group(number, len(ones), said, ones[0].answer, ones[0].right) for (number, said), ones in alike.items()]
    return sorted(found, key=lambda group: (group.problem, -group.count, group.relation))


def add_arguments(parser: ArgumentParser) -> None:
    """Add the arguments of `misstep unnamed`."""
    parser.add_argument("results", type=Path, help="the folder that `misstep grade --out` wrote")


def run(options: Namespace) -> int:
    """Print the groups as a table, and return 0."""
    results = list(stored_results(options.results))
    if not results:
        raise ValueError(f"{options.results} has no results. Give the folder that `misstep grade --out` wrote.")
    print("| problem | answers | each number beside the right one | an example | right there |")
    print("| --- | ---: | --- | --- | --- |")
    for group in groups(problem for result in results for problem in result.problems):
        cells = (json.dumps(_rounded(data)) for data in (group.answer, group.right))
        print(f"| {group.problem} | {group.count} | {group.relation} | {' | '.join(cells)} |")
    return 0


def _rounded(data: Any) -> Any:
    if isinstance(data, float):
        return round(data, 4)
    if isinstance(data, list):
        return [_rounded(item) for item in data]
    return {key: _rounded(item) for key, item in data.items()} if isinstance(data, dict) else data
