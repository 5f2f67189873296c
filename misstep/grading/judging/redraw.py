"""Redraw: other numbers for the problems of a student, by which an answer that was computed is told from one that was typed.

With the instructor's key, a submission runs again with numbers that only the key gives. An answer that a cell computes from
`sheet.given(k)` is right again. A number that was typed stays the same, and the right answer is another one.
"""

import hmac
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np

from misstep.problem import MAX_DRAWS, Problem, Template

CANDIDATES = 16
"""How many variants are drawn, of which the one is taken that is most like the student's own. If none can be used, more are drawn."""


@dataclass(frozen=True)
class Draw:
    """Other numbers: the instructor's key, the number of the draw, from 0, and the problems that get them."""

    key: str
    number: int
    problems: frozenset[int] = frozenset()


def redraw(template: Template, own: Problem, student: str, draw: Draw) -> Problem | None:
    """A variant with other numbers and another right answer, as much like the student's own as possible.

    A student may have written only the case that is in the own numbers, a prismatic joint or a negative angle, so the
    texts, shapes, zeros and signs of the given values stay the same where that is possible.

    Returns None if no variant has another answer, because then nothing can be told from it; so also for a problem without
    given values, which is read from a drawing.
    """
    if not own.given:
        return None
    features = set(_features(own.given))

    def likeness(problem: Problem) -> float:
        others = set(_features(problem.given))
        return len(features & others) / max(len(features | others), 1)

    variants = (_variant(template, student, draw.key, f"{draw.number}/{candidate}") for candidate in range(MAX_DRAWS))
    first = sorted((next(variants) for _ in range(CANDIDATES)), key=likeness, reverse=True)
    usable = (one for one in chain(first, variants) if one.is_discriminating() and _has_other_answer(own, one))
    return next(usable, None)


def _variant(template: Template, student: str, key: str, name: str) -> Problem:
    secret = hmac.new(key.encode(), f"{student.strip().casefold()}/{name}".encode(), "sha256").hexdigest()
    return template.make_problem(template.sampler(secret, template.number))


def _has_other_answer(own: Problem, other: Problem) -> bool:
    """Whether an answer that is right for the one is wrong, in each part, for the other."""
    if callable(own.answer.value) or callable(other.answer.value):
        return True  # a function is right for other numbers only if it uses them
    try:
        return not all(own.answer.agrees(own.answer.value, other.answer.value))
    except (TypeError, ValueError):  # of another shape
        return True


def _features(value: Any, path: str = "") -> Iterator[str]:
    """What a student's code may depend on: texts, truth values, shapes, and for each number whether it is 0, 1, or negative."""
    if isinstance(value, dict):
        for name, part in value.items():
            yield from _features(part, f"{path}.{name}")
    elif isinstance(value, list | tuple):
        yield f"{path} {len(value)}"
        for place, part in enumerate(value):
            yield from _features(part, f"{path}.{place}")
    elif isinstance(value, np.ndarray):
        yield from _features(value.tolist(), path)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield f"{path} {np.sign(value)} {abs(value) == 1}"
    else:
        yield f"{path} {str(value)[:80]}"
