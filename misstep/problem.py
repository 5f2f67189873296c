"""Problems: written once, with numbers of each student's own, the right answer and the mistakes that people make.

A mistake is a named transformation of the right answer. If a student's answer is what the mistake would give, the
mistake explains it, and the sheet says so in words.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any, TypeVar

from misstep.answers.base import TOLERANCE, Answer
from misstep.mistakes import Mistake
from misstep.sampling import Sampler

S = TypeVar("S", bound=Sampler)

ATTEMPTS = 100
"""How many variants are drawn before a problem is called degenerate."""

LEAST = 3
"""How many mistakes a problem names at least."""

APART = 10
"""How many tolerances must lie between the right answer and each mistake, and between any two mistakes."""


@dataclass(frozen=True, eq=False)
class Problem:
    """One student's problem: the statement, what is given, the right answer and the mistakes, all with their numbers.

    statement  Markdown with $...$ for mathematics
    given      the same data as values, so that nobody has to type them: sheet.given(k).home
    figure     a function that draws, called only when somebody looks

    Raises ValueError for a mistake whose value is no answer of this kind: nobody could ever make it.

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> from misstep.mistakes import mistake
    >>> values = {"twice": 6, "half": 1.5, "half again": 1.5, "sign": -3}
    >>> wrong = [mistake(name, np.array(value), "A sentence.") for name, value in values.items()]
    >>> drawn = Problem("How many?", Numbers(np.array(3.0)), wrong)
    >>> drawn.telling()
    False
    >>> [kept.name for kept in drawn.sifted().mistakes]
    ['twice', 'half', 'sign']
    >>> drawn.again(seed=1) is drawn  # it asks for no function
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

    def again(self, seed: int) -> "Problem":
        """The same problem; where it asks for a function, with other inputs to call it at."""
        answer = self.answer.at(seed)
        return self if answer is self.answer else replace(self, answer=answer)

    def telling(self) -> bool:
        """Whether every mistake leads away from the right answer, and each to a place of its own."""
        reached = [self.answer.value, *(wrong.value for wrong in self.mistakes)]
        return not any(self._same(one, other) for one, other in combinations(reached, 2))

    def sifted(self) -> "Problem":
        """The same problem with those mistakes only that tell something, each where no earlier one leads already.

        What an arm is may spoil a mistake for good: where all joints slide, nobody can confuse degrees with radians. If
        fewer than LEAST are left, nothing is sifted, and so the problem does not count as telling.
        """
        kept: list[Mistake] = []
        for wrong in self.mistakes:
            if not any(self._same(wrong.value, value) for value in [self.answer.value, *(one.value for one in kept)]):
                kept.append(wrong)
        return replace(self, mistakes=kept) if len(kept) >= LEAST else self

    def _same(self, one: Any, other: Any) -> bool:
        return all(self.answer.agrees(one, other, APART * TOLERANCE))


@dataclass(frozen=True)
class Template:
    """A problem before anybody's numbers are drawn; `problem` makes one of a function.

    number   its place, "03.2"; the student's numbers depend on it
    points   full score, shared equally among the parts of the answer
    lecture  where to re-read, "03_poe_space#Prismatic joints": notebook and heading
    write    the function from a sampler to a Problem
    sampler  the class of the sampler that the function is given

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> def write(sampler):
    ...     x = sampler.integer(1, 9)
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)), [])
    >>> half = Template("01.1", "A half", points=1, lecture="01_fractions#Halves", write=write)
    >>> half.variant("ada").statement == half.variant("Ada ").statement
    True
    """

    number: str
    title: str
    points: int
    lecture: str
    write: Callable[[Any], Problem]
    sampler: type[Sampler] = Sampler

    def variant(self, student: str) -> Problem:
        """Draw one student's problem: the first one in which no mistake happens to give the right answer.

        Raises ValueError when none is found: then the problem itself is degenerate.
        """
        for attempt in range(ATTEMPTS):
            problem = self.write(self.sampler(student, self.number, attempt))
            if problem.telling():
                return problem
        raise ValueError(
            f"Problem {self.number}: in {ATTEMPTS} draws, two mistakes always gave the same answer, or one the right one. "
            "Draw from a wider range, or drop a mistake that is none."
        )


def problem(
    number: str,
    title: str,
    points: int,
    lecture: str,
    sampler: type[S] = Sampler,  # type: ignore[assignment]
) -> Callable[[Callable[[S], Problem]], Template]:
    """Make a template of a function from a sampler to a Problem.

    number   its place, "03.2"; the student's numbers depend on it
    points   full score, shared equally among the parts of the answer
    lecture  where to re-read, "03_poe_space#Prismatic joints": notebook and heading
    sampler  the class of the sampler that the function is given

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

    def wrap(write: Callable[[S], Problem]) -> Template:
        return Template(number, title, points, lecture, write, sampler)

    return wrap
