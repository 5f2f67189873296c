"""Problems: written once, with individual numbers for each student, the right answer and the common mistakes.

A mistake has a name and the wrong answer to which it leads. If a student gives this answer, the mistake explains it, and the
feedback says so in words.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any, TypeVar

from misstep.answers.base import TOLERANCE, Answer
from misstep.mistakes import Mistake
from misstep.sampling import Sampler

S = TypeVar("S", bound=Sampler)

MAX_DRAWS = 100
"""How many variants are drawn before a problem is refused as degenerate."""

MIN_MISTAKES = 3
"""The least number of mistakes that a problem must have."""

SEPARATION_TOLERANCES = 10
"""The least distance, in tolerances, between the right answer and a mistake, and between any two mistakes."""


@dataclass(frozen=True, eq=False)
class Problem:
    """One student's problem, with its numbers: the statement, the given values, the right answer and the mistakes.

    statement  Markdown with $...$ for mathematics
    given      the given values by name; students get them by sheet.given(k), so they need not type them
    figure     a function that draws the figure; it is called only when the problem is shown

    Raises ValueError for a mistake whose value is not an answer of this kind, because no student could give it.

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> from misstep.mistakes import mistake
    >>> values = {"twice": 6, "half": 1.5, "half again": 1.5, "sign": -3}
    >>> wrong = [mistake(name, np.array(value), "A sentence.") for name, value in values.items()]
    >>> drawn = Problem("How many?", Numbers(np.array(3.0)), wrong)
    >>> drawn.is_discriminating()
    False
    >>> [kept.name for kept in drawn.without_duplicates().mistakes]
    ['twice', 'half', 'sign']
    >>> drawn.with_inputs(seed=1) is drawn  # because the answer is not a function
    True
    """

    statement: str
    answer: Answer
    mistakes: Sequence[Mistake]
    given: Mapping[str, Any] = field(default_factory=dict)
    figure: Callable[[], Any] | None = None

    def __post_init__(self) -> None:
        read = [replace(wrong, value=self.answer.read(wrong.value)) for wrong in self.mistakes]
        object.__setattr__(self, "mistakes", read)

    def with_inputs(self, seed: int) -> "Problem":
        """Return the same problem; if the answer is a function, with other inputs at which it is compared."""
        answer = self.answer.with_inputs(seed)
        return self if answer is self.answer else replace(self, answer=answer)

    def is_discriminating(self) -> bool:
        """Return whether the right answer and the answers of all mistakes differ from each other."""
        reached = [self.answer.value, *(wrong.value for wrong in self.mistakes)]
        return not any(self._same(one, other) for one, other in combinations(reached, 2))

    def without_duplicates(self) -> "Problem":
        """Return the same problem without the mistakes whose answer is the right one or that of an earlier mistake.

        Some mistakes are impossible for some variants: where nothing is an angle, degrees cannot be taken for radians. If fewer
        than MIN_MISTAKES would be left, all are kept, so that the problem does not count as discriminating.
        """
        kept: list[Mistake] = []
        for wrong in self.mistakes:
            if not any(self._same(wrong.value, value) for value in [self.answer.value, *(one.value for one in kept)]):
                kept.append(wrong)
        return replace(self, mistakes=kept) if len(kept) >= MIN_MISTAKES else self

    def _same(self, one: Any, other: Any) -> bool:
        return all(self.answer.agrees(one, other, SEPARATION_TOLERANCES * TOLERANCE))


@dataclass(frozen=True)
class Template:
    """A problem before the numbers of a student are drawn; the decorator `problem` makes one from a function.

    number        sheet and position, "03.2"; the student's numbers depend on it
    points        the full score, shared equally among the parts of the answer
    lecture       where to re-read, "01_ohm#Parallel circuits": notebook and heading
    make_problem  the function from a sampler to a Problem
    sampler       the class of the sampler that the function gets

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> def make_problem(sampler):
    ...     x = sampler.integer(1, 9)
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)), [])
    >>> half = Template("01.1", "A half", points=1, lecture="01_fractions#Halves", make_problem=make_problem)
    >>> half.variant("ada").statement == half.variant("Ada ").statement
    True
    """

    number: str
    title: str
    points: int
    lecture: str
    make_problem: Callable[[Any], Problem]
    sampler: type[Sampler] = Sampler

    def variant(self, student: str) -> Problem:
        """Draw one student's problem: the first variant in which the mistakes and the right answer all differ.

        Raises ValueError if there is no such variant in MAX_DRAWS draws, because then the problem itself is degenerate.
        """
        for attempt in range(MAX_DRAWS):
            problem = self.make_problem(self.sampler(student, self.number, attempt))
            if problem.is_discriminating():
                return problem
        raise ValueError(
            f"Problem {self.number}: in each of {MAX_DRAWS} draws, two mistakes gave the same answer, or a mistake gave the right "
            "one. Draw from a wider range, or remove a mistake that does not change the answer."
        )


def problem(
    number: str,
    title: str,
    points: int,
    lecture: str,
    sampler: type[S] = Sampler,  # type: ignore[assignment]
) -> Callable[[Callable[[S], Problem]], Template]:
    """Decorate a function from a sampler to a Problem, and so make it a Template.

    number   sheet and position, "03.2"; the student's numbers depend on it
    points   the full score, shared equally among the parts of the answer
    lecture  where to re-read, "01_ohm#Parallel circuits": notebook and heading
    sampler  the class of the sampler that the function gets

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> from misstep.mistakes import mistake
    >>> @problem("01.1", "A half", points=1, lecture="01_fractions#Halves")
    ... def half(sampler):
    ...     x = sampler.length(0.1, 0.5)
    ...     ways = {"doubled": 2 * x, "kept": x, "sign": -x / 2}
    ...     wrong = [mistake(name, np.array(value), "A sentence.") for name, value in ways.items()]
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)), wrong)
    >>> half.title, len(half.variant("ada").mistakes)
    ('A half', 3)
    """

    def decorate(make_problem: Callable[[S], Problem]) -> Template:
        return Template(number, title, points, lecture, make_problem, sampler)

    return decorate
