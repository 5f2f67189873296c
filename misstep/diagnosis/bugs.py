"""From single answers to a student: which mistakes return from problem to problem, and which occurred once.

A *bug* is a mistake that returns wherever it can be made; a *slip* occurs once and is not repeated. Bugs are primitive and
combine, and different bugs may lead to the same answer, so an answer has alternatives: ("a",) or ("b",), or ("a", "b") for two
mistakes made together. Among the alternatives, those are preferred which also explain answers to other problems.

Nothing here knows an answer or a problem: mistakes are names, and one name is one misconception in every problem.

Sources: J. S. Brown and R. R. Burton, Diagnostic models for procedural bugs in basic mathematical skills, Cognitive Science 2
(1978), 155-192. R. R. Burton, Diagnosing bugs in a simple procedural skill (DEBUGGY), in Intelligent Tutoring Systems, Academic
Press 1982, 157-183. K. VanLehn, Bugs are not enough: empirical studies of bugs, impasses and repairs in procedural skills,
Journal of Mathematical Behavior 3 (1982), 3-71.
"""

from collections import defaultdict
from collections.abc import Collection, Sequence
from dataclasses import dataclass

Alternatives = Sequence[Sequence[str]]
"""The explanations of one wrong answer between which it does not decide, each as the names of mistakes made together."""

MIN_SLIP_OPPORTUNITIES = 3
"""In how many problems a mistake must have been possible before one occurrence counts as a slip."""


@dataclass(frozen=True)
class Observation:
    """What the answers to one problem show: the mistakes that can be made in it, and the alternatives for each that was."""

    problem: str
    possible: Collection[str]
    explanations: Sequence[Alternatives] = ()


@dataclass(frozen=True)
class Recurrence:
    """A mistake across the problems of a student.

    name           of the mistake; "a or b" if no answer decides between them
    problems       the problems in which it was recognised
    opportunities  the number of answered problems in which it can be made; 0 if that is not known, as for rounding
    """

    name: str
    problems: Sequence[str]
    opportunities: int

    @property
    def returns(self) -> bool:
        """Whether it was recognised in at least two problems."""
        return len(self.problems) > 1

    @property
    def is_slip(self) -> bool:
        """Whether it was recognised once, where it could have been made several times."""
        return len(self.problems) == 1 and self.opportunities >= MIN_SLIP_OPPORTUNITIES

    def __str__(self) -> str:
        kind = "Returning mistake" if self.returns else "Probably a slip" if self.is_slip else "Mistake"
        possible = (
            f"of the {self.opportunities} answered problems in which it can be made"
            if self.opportunities
            else "problems"
        )
        return (
            f"{kind}: “{self.name}” explains answers in {len(self.problems)} {possible} ({', '.join(self.problems)})."
        )


def recurrences(observations: Sequence[Observation]) -> list[Recurrence]:
    """Return each recognised mistake with its problems and opportunities, the most frequent first.

    Of the alternatives for an answer, those are kept whose mistakes were recognised in the most problems on average, and among
    these the ones that were possible in the fewest. A mistake in all kept alternatives is certain; the rest stays undecided.
    """

    def support(names: Sequence[str]) -> tuple[float, float]:
        recognised = sum(name in _recognised(one) for name in names for one in observations)
        possible = sum(name in one.possible for name in names for one in observations)
        return recognised / len(names), -possible / len(names)

    problems: dict[frozenset[frozenset[str]], set[str]] = defaultdict(set)
    for one in observations:
        for alternatives in one.explanations:
            most = max(map(support, alternatives))
            kept = {frozenset(names) for names in alternatives if support(names) == most}
            certain = frozenset.intersection(*kept)
            undecided = frozenset(names - certain for names in kept)
            for cause in [
                *(frozenset({frozenset({name})}) for name in certain),
                *([undecided] if all(undecided) else ()),
            ]:
                problems[cause].add(one.problem)
    found = []
    for cause, where in problems.items():
        name = " or ".join(sorted(" and ".join(sorted(names)) for names in cause))
        possible = {one.problem for one in observations if any(names <= set(one.possible) for names in cause)}
        found.append(Recurrence(name, sorted(where), len(possible | where) if possible else 0))
    return sorted(found, key=lambda one: (-len(one.problems), one.opportunities, one.name))


def _recognised(one: Observation) -> set[str]:
    return {name for alternatives in one.explanations for names in alternatives for name in names}
