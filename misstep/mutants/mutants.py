"""Mutants: the expressions to which one change of a solution leads.

A change is made where it belongs, at one place, and where people make it everywhere at once, at all places. A value that is used
twice is changed in both places, because people compute it once.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from operator import is_
from typing import Any

import numpy as np

from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression, Slip


@dataclass(frozen=True, eq=False)
class Mutation:
    """A change, and the expressions that it puts in the place of others."""

    slip: Slip
    replaced: Mapping[Expression, Expression]


@dataclass(frozen=True, eq=False)
class MutableSolution:
    """A solution at one input, and its changes, which are looked for when they are needed.

    built  the parts that were built for its mutants, by operation and arguments; each is built and computed once

    >>> from misstep.mutants.expression import given
    >>> A, B = given("A", np.eye(2)), given("B", np.ones((2, 2)))
    >>> [mutation.slip.did for mutation in MutableSolution(A @ B).mutations][:2]
    ['swap $A$ and $B$', 'leave out $A$']
    """

    root: Expression
    built: dict[tuple[Any, ...], Expression] = field(default_factory=dict, repr=False)

    @cached_property
    def mutations(self) -> Sequence[Mutation]:
        """Its changes, in the same order at each input."""
        single = [Mutation(slip, {node: slip.wrong}) for node in nodes(self.root) for slip in node.slips()]
        everywhere: dict[tuple[str, str], list[Mutation]] = {}
        for mutation in single:
            if text := mutation.slip.everywhere:
                everywhere.setdefault((mutation.slip.name, text), []).append(mutation)
        for (name, text), several in everywhere.items():
            first = several[0].slip
            replaced = {node: new for mutation in reversed(several) for node, new in mutation.replaced.items()}
            if len(replaced) > 1:
                single = [mutation for mutation in single if mutation not in several or mutation.slip.one_by_one]
                single.append(Mutation(Slip(name, text, advice=first.advice, in_parts=first.in_parts), replaced))
        return single

    def mutant(self, k: int) -> Expression:
        """Return the solution with the change of this index."""
        return self._changed(self.root, self.mutations[k].replaced)

    def _changed(self, root: Expression, replaced: Mapping[Expression, Expression]) -> Expression:
        """Return a part with some of its parts replaced; all other parts are shared with the original one."""
        if replaced.keys().isdisjoint(root.parts):
            return root
        # A replacement is searched for further parts to replace, but not for the part that it replaces: that may stand within it.
        new = root
        while new in replaced:
            done, new = new, replaced[new]
            replaced = {node: other for node, other in replaced.items() if node is not done}
        arguments = tuple([self._changed(node, replaced) for node in new.arguments])
        if all(map(is_, arguments, new.arguments)):
            return new
        key = (new.operation, *arguments)
        if key not in self.built:
            self.built[key] = new.operation(*arguments)
        return self.built[key]


def mutant(slip: Slip, value: Any, advice: Mapping[str, str], *, spoils: bool = False) -> Mistake:
    """Return the mistake of a change that leads to a value.

    advice  for names or texts of changes, a sentence on what is right, instead of their own
    spoils  whether it belongs to the method for all parts of the answer
    """
    further = advice.get(slip.did, advice.get(slip.name, slip.advice))
    is_sentence = slip.did.endswith(".")
    message = slip.did if is_sentence else f"This is what you get if you {slip.did}. {further}".rstrip()
    return Mistake(slip.name, value, message, slip.in_parts, "" if is_sentence else slip.did, further, spoils)


def value_of(expression: Expression) -> Any:
    """Return the value of an expression, or None where it has none: a mutant need not be computable."""
    try:
        with np.errstate(all="ignore"):
            return expression.value
    except (ValueError, TypeError, IndexError, ArithmeticError, np.linalg.LinAlgError):
        return None


def nodes(root: Expression) -> list[Expression]:
    """Return the different parts of an expression, each before its own parts."""
    found, left = dict[Expression, None](), [root]
    while left:
        if (node := left.pop()) not in found:
            found[node] = None
            left += node.arguments[::-1]
    return list(found)
