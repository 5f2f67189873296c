"""Problems: written once, with individual numbers for each student, the right answer and the common mistakes.

A mistake has a name and the wrong answer to which it leads. If a student gives this answer, the mistake explains it, and the
feedback says so in words. Most mistakes are mutants of the solution: the problem gives its solution as an expression, and the
changes by which people go wrong are made in it (`misstep.mutants`). A problem adds the mistakes that belong to it alone.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import combinations, islice
from types import ModuleType
from typing import Any, Literal, TypeVar

import numpy as np

from misstep.answers.base import TOLERANCE, Answer, Unreadable
from misstep.answers.choice import ReasonedChoice
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression
from misstep.mutants.mutants import MutableSolution, mutant, value_of
from misstep.sampling import Sampler

S = TypeVar("S", bound=Sampler)

MAX_DRAWS = 300
"""How many variants are drawn before a problem is refused as degenerate."""

SEPARATION_TOLERANCES = 10
"""The least distance, in tolerances, between the right answer and a mistake, and between any two mistakes."""


@dataclass(frozen=True, eq=False)
class Problem:
    """One student's problem, with its numbers: the statement, the given values, the right answer and the mistakes.

    statement  Markdown with `$...$` for mathematics
    answer     the right answer; if its value is an expression, this is the solution
    mistakes   the mistakes that are no mutants of the solution
    given      the given values by name; students get them by sheet.given(k), so they need not type them
    shown      further values by name that stand in the statement or the drawing, and that students read there
    method     how the answer is found, in words and formulas; its lines are the first steps of the worked solution
    further    a question for a student who has solved it, which changes something
    figure     a function that draws the figure; it is called only when the problem is shown
    solution   the solution as an expression over the given values (`misstep.mutants`), if it is not in the answer; for a function or a
               formula, a function from its arguments to an expression. Its mutants are mistakes of the problem
    advice     for names of mutants, or the texts of their changes, a sentence on what is right in this problem
    invisible  the names of mutants that cannot be seen in this problem, because they always lead to the right answer

    Raises ValueError for an answer that is no Answer, for a mistake whose value is not an answer of this kind, because no
    student could give it, and if the solution does not lead to the answer.

    >>> from misstep.answers.number import Numbers
    >>> from misstep.mutants.expression import given
    >>> drawn = Problem("How many?", Numbers(given("n", 6.0) / 2))
    >>> [(one.did, float(one.value)) for one in drawn.mutants(np.array(12.0))]
    [('multiply by $2$ instead of dividing by it', 12.0)]
    >>> drawn.collision(), [*drawn.hidden_mutants()], drawn.without_duplicates().mistakes
    (None, [], [])
    """

    statement: str
    answer: Answer
    mistakes: Sequence[Mistake] = ()
    given: Mapping[str, Any] = field(default_factory=dict)
    shown: Mapping[str, Any] = field(default_factory=dict)
    method: str = ""
    further: str = ""
    figure: Callable[[], Any] | None = None
    solution: Expression | Callable[..., Expression] | None = None
    advice: Mapping[str, str] = field(default_factory=dict)
    invisible: Collection[str] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.answer, Answer):
            raise ValueError(f"answer must be an Answer, such as Numbers(...); got {type(self.answer).__name__}.")
        if isinstance(root := self.answer.value, Expression):
            object.__setattr__(self, "solution", root)
            object.__setattr__(self, "answer", replace(self.answer, value=np.asarray(root.value)))  # type: ignore[type-var]
        read = [replace(wrong, value=self.answer.read(wrong.value)) for wrong in self.mistakes]
        object.__setattr__(self, "mistakes", read)

    @cached_property
    def slips(self) -> Sequence[Mistake]:
        """The mistakes that people make with any answer of this kind, without those that are right for these numbers."""
        found = []
        for slip in self.answer.slips:
            try:
                value = self.answer.collect([slip.wrong(right) for right in self.answer.at_inputs()])
            except Unreadable:
                continue
            if not all(self.answer.agrees(value, self.answer.value)):
                found.append(mutant(slip, value, self.advice, spoils=slip.spoils))
        return found

    def mutants(self, near: Any = None, *, separating: bool = False) -> Iterator[Mistake]:
        """Yield a mistake for each change of the solution that leads to an answer at all.

        near        an answer that was read, with which they must share a part at the first input
        separating  whether they must share all parts, and not by chance
        """
        is_near, tolerance = (all, SEPARATION_TOLERANCES * TOLERANCE) if separating else (any, TOLERANCE)
        told = set[Expression]()
        for k, mutation in enumerate(() if self.solution is None else self._first_solution.mutations):
            slip = mutation.slip
            first = None if separating and slip.may_coincide else self._first_solution.mutant(k)
            if first is None or first in told:
                continue
            told.add(first)  # the inverse of an inverse is an inverse left out
            try:
                at_first = None if near is None else self.answer.collect([value_of(first)])
                if at_first is not None and not is_near(self.answer.agrees(at_first, near, tolerance)):
                    continue
                solutions = self._solutions
                value = self.answer.collect([value_of(one.mutant(k)) for one in solutions])
            except Unreadable:
                continue
            # A change belongs to the method for all rows, if each row has no expression of its own.
            root = solutions[0].root
            is_method = root.operation.name != "stack" or root in mutation.replaced
            spoils = slip.spoils or (self.answer.has_alike_rows and is_method)
            yield mutant(slip, value, self.advice, spoils=spoils)

    @cached_property
    def known_mistakes(self) -> Sequence[Mistake]:
        """The mistakes of the author, and the mutants that are not right for these numbers by chance."""
        right = partial(self.answer.agrees, self.answer.value)
        mutants = (one for one in self.mutants() if one.name in self.invisible or not all(right(one.value)))
        return [*self.mistakes, *mutants]

    def collision(self) -> tuple[str, str] | None:
        """Return what gives the same answer: two mistakes of the author, or one mistake and the solution; None if nothing does.

        Mutants need to differ from the right answer only: where two of them lead to the same answer, feedback names both.
        """
        named = [("the right answer", self.answer.value)]
        named += [(f"the mistake {one.name!r}", one.value) for one in self.mistakes]
        for (one, value), (other, same) in combinations(named, 2):
            if self._same(value, same):
                return one, other
        # Only the first of them, because many draws are refused.
        hidden = next(self.hidden_mutants(), None)
        return ("the right answer", f"the mutant {hidden.name!r} ({hidden.message})") if hidden else None

    def hidden_mutants(self) -> Iterator[Mistake]:
        """Yield the mutants that lead to the right answer, apart from those that are declared to be invisible."""
        for wrong in self.mutants(self.answer.value, separating=True):
            if wrong.name not in self.invisible and self._same(wrong.value, self.answer.value):
                yield wrong

    def without_duplicates(self) -> "Problem":
        """Return the same problem without the mistakes whose answer is the right one, or that of an earlier mistake, or which
        looks like something else at sight: a placeholder, or the right answer in another unit.

        Some mistakes are impossible for some variants: where nothing is an angle, degrees cannot be taken for radians.
        """
        kept: list[Mistake] = []
        for wrong in self.mistakes:
            known = [self.answer.value, *(one.value for one in kept)]
            if not (self.answer.at_sight(wrong.value) or any(self._same(wrong.value, one) for one in known)):
                kept.append(wrong)
        return replace(self, mistakes=kept)

    def with_reason(self, reason: Answer, called: str) -> "Problem":
        """Return the same problem, whose choice earns points only with a reason; its mistakes are those of the choice.

        called  what the reason is, for cards: "the length"

        >>> from misstep.answers.choice import Choice
        >>> from misstep.answers.number import Numbers
        >>> side = Problem("Which?", Choice("b", {"a": "left", "b": "right"}))
        >>> side.with_reason(Numbers(np.array(0.5)), "the height").answer.parts
        ['the choice', 'the height']
        """
        wrong = [replace(one, value=(one.value, reason.value), in_parts=True) for one in self.mistakes]
        return replace(self, answer=ReasonedChoice(self.answer, reason, called), mistakes=wrong)  # type: ignore[arg-type]

    @cached_property
    def _first_solution(self) -> MutableSolution:
        """The solution at the first input, which is often enough to see that a mistake is not the one that was made."""
        return MutableSolution(next(self.answer.at_inputs(self.solution)))

    @cached_property
    def _solutions(self) -> Sequence[MutableSolution]:
        """The solution at each input, of which there is one as a rule."""
        others = islice(self.answer.at_inputs(self.solution), 1, None)
        solutions = [self._first_solution, *map(MutableSolution, others)]
        reached = self.answer.collect([one.root.value for one in solutions])
        if not self._same(reached, self.answer.value):
            raise ValueError(
                f"The solution must lead to the answer; it gives {reached}, and the answer is {self.answer.value}."
            )
        if len({len(one.mutations) for one in solutions}) > 1:
            raise ValueError("The solution must have the same changes at each input; their numbers differ.")
        return solutions

    def _same(self, one: Any, other: Any) -> bool:
        return all(self.answer.agrees(one, other, SEPARATION_TOLERANCES * TOLERANCE))


Level = Literal["Warm-up", "Usual", "Hard", "Open"]


@dataclass(frozen=True)
class Template:
    """A problem before the numbers of a student are drawn; the decorator `problem` makes one from a function.

    number        sheet and position, "03.2"; the student's numbers depend on it
    points        the full score, shared equally among the parts of the answer
    lecture       where to re-read, "01_ohm#Parallel circuits": notebook and heading
    make_problem  the function from a sampler to a Problem
    sampler       the class of the sampler that the function gets
    level         how hard it is; a hard one has no hints, and an open one is marked by an instructor

    >>> from kincourse.lecture_03_poe_space import problems
    >>> first = templates_in(problems)[0]
    >>> first.variant("ada").statement == first.variant("Ada ").statement, first.number
    (True, '03.1')
    """

    number: str
    title: str
    points: int
    lecture: str
    make_problem: Callable[[Any], Problem]
    sampler: type[Sampler] = Sampler
    level: Level = "Usual"

    def variant(self, student: str) -> Problem:
        """Draw one student's problem: the first variant in which the mistakes and the right answer all differ.

        Raises ValueError if there is no such variant in MAX_DRAWS draws, because then the problem itself is degenerate.
        """
        one = other = ""
        for attempt in range(MAX_DRAWS):
            problem = self.make_problem(self.sampler(student, self.number, attempt))
            if (same := problem.collision()) is None:
                return problem
            one, other = same
        raise ValueError(
            f"Problem {self.number}: in each of {MAX_DRAWS} draws, two answers that must differ were the same. In the last draw, "
            f"{other} gave the same answer as {one}. Draw from a wider range, or remove a mistake that does not change the "
            "answer; a mutant that never does is declared as invisible."
        )


def problem(
    number: str,
    title: str,
    points: int,
    lecture: str,
    sampler: type[S] = Sampler,  # type: ignore[assignment]
    *,
    level: Level = "Usual",
) -> Callable[[Callable[[S], Problem]], Template]:
    """Decorate a function from a sampler to a Problem, and so make it a Template, whose fields the arguments are.

    >>> import numpy as np
    >>> from misstep.answers.number import Numbers
    >>> @problem("01.1", "A half", points=1, lecture="01_fractions#Halves")
    ... def half(sampler):
    ...     x = sampler.length(0.1, 0.5)
    ...     return Problem(f"What is half of {x}?", Numbers(np.array(x / 2)))
    >>> half.title
    'A half'
    """
    return lambda make_problem: Template(number, title, points, lecture, make_problem, sampler, level)


def templates_in(module: ModuleType) -> list[Template]:
    """Return the problems of a module, in the order of their numbers: "03.2" comes before "03.10".

    Raises ValueError for a number that two problems have.

    >>> from kincourse.lecture_03_poe_space import problems
    >>> [template.number for template in templates_in(problems)][::9]
    ['03.1', '03.10']
    """
    found = [value for value in vars(module).values() if isinstance(value, Template)]
    numbers = [template.number for template in found]
    if twice := {number for number in numbers if numbers.count(number) > 1}:
        raise ValueError(f"Each problem must have its own number; {', '.join(sorted(twice))} is there twice.")
    return sorted(found, key=lambda template: (len(template.number), template.number))
