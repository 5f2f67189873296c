"""Mutants: the expressions to which one change of a solution leads, or two changes.

A change is made where it belongs, at one place, and where people make it everywhere at once, at all places. A value that is used
twice is changed in both places, because people compute it once.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations, permutations
from operator import is_
from typing import Any

import numpy as np

from misstep.mistakes import Mistake, Step
from misstep.mutants.expression import Change, Expression

MAX_SIBLINGS = 7
"""How many given values of one kind are taken for one another."""

SYMBOLS = re.compile(r"\$[^$]*\$")
"""The symbols in the text of a change."""

FILLERS = frozenset({"and", "in", "every", "each", "all", "of", "the"})
"""The words of a text that only join its symbols."""

Built = dict[tuple[Any, ...], tuple[tuple[Expression, ...], Expression]]
"""Parts of mutants by their operation and the ids of their arguments, with these arguments, so that the ids stay theirs."""


@dataclass(frozen=True, eq=False)
class Mutation:
    """A change, and the expressions that it puts in the place of others, by their id.

    on_the_way  the ids of the parts that it changes in another way to a value, which as a whole is put in the place
    """

    change: Change
    replaced: Mapping[int, Expression]
    on_the_way: frozenset[int] = frozenset()


@dataclass(frozen=True, eq=False)
class MutableSolution:
    """A solution at one input, and its changes, which are looked for when they are needed.

    built  the parts that were built for its mutants; each is built and computed once
    """

    root: Expression
    built: Built = field(default_factory=dict, repr=False)

    @cached_property
    def single(self) -> Sequence[tuple[Mutation, ...]]:
        """Each change alone."""
        return [(mutation,) for mutation in mutations(self.root)]

    @cached_property
    def separating(self) -> Sequence[tuple[Mutation, ...]]:
        """The single changes that must not lead to the right answer: two given values may be equal by chance."""
        return [changes for changes in self.single if not changes[0].change.alone]

    @cached_property
    def double(self) -> Sequence[tuple[Mutation, ...]]:
        """Every two changes."""
        return list(pairs(self.root, [mutation for (mutation,) in self.separating]))

    def is_in_every_row(self, mutation: Mutation) -> bool:
        """Return whether a change belongs to the method for all rows: rows that are put on top of each other have one each."""
        return self.root.operation.name != "stack" or id(self.root) in mutation.replaced

    def steps(self, changes: Sequence[Mutation]) -> tuple[Step, ...]:
        """Return what changes do, and where, so that two that are one story can be seen to be one."""
        return tuple(map(self._step, changes))

    def _step(self, mutation: Mutation) -> Step:
        change, changed = mutation.change, mutation.on_the_way.union(mutation.replaced)
        within = changed.union(*(self._parts[key] for key in changed if key in self._parts))
        words = " ".join(word for word in SYMBOLS.sub("", change.text).split() if word not in FILLERS)
        values = sorted({str(value_of(new)) for new in mutation.replaced.values()}) if change.alone else []
        return Step(change.name, words, changed, within, " ".join(values))

    @cached_property
    def _parts(self) -> Mapping[int, frozenset[int]]:
        return {id(node): node.part_ids for node in _nodes(self.root)}

    def mutant(self, changes: Sequence[Mutation]) -> Expression:
        """Return the solution with these changes."""
        return mutate(self.root, *(mutation.replaced for mutation in changes), built=self.built)


def mutate(root: Expression, *replacements: Mapping[int, Expression], built: Built | None = None) -> Expression:
    """Return the expression with some of its parts replaced; all other parts are shared with the original one.

    built  the parts that were built for other mutants of the same expression; they are shared too, and new ones are added

    The parts of all replacements are replaced in one pass, because a part that is rebuilt is found by its id no more.
    """
    replaced = {key: node for one in replacements for key, node in one.items()}
    if replaced.keys().isdisjoint(root.part_ids):
        return root
    return _replace_parts(root, replaced, {} if built is None else built)


def _replace_parts(root: Expression, replaced: Mapping[int, Expression], built: Built) -> Expression:
    # A replacement is searched for further parts to replace, but not for the part that it replaces: that may stand within it.
    new = root
    while id(new) in replaced:
        done, new = id(new), replaced[id(new)]
        replaced = {key: node for key, node in replaced.items() if key != done}
    if not replaced:
        return new
    ids = replaced.keys()
    arguments = tuple(
        [node if ids.isdisjoint(node.part_ids) else _replace_parts(node, replaced, built) for node in new.arguments]
    )
    if all(map(is_, arguments, new.arguments)):
        return new
    key = (new.operation, *map(id, arguments))
    if key not in built:
        built[key] = arguments, new.operation(*arguments)
    return built[key][1]


def mutations(root: Expression) -> list[Mutation]:
    """Return every change of an expression, and of each other way to one of its parts.

    >>> from misstep.mutants.expression import given
    >>> A, B = given("A", np.eye(2)), given("B", np.ones((2, 2)))
    >>> [mutation.change.past for mutation in mutations(A @ B)][:2]
    ['swapped $A$ and $B$', 'left out $A$']
    """
    nodes = _nodes(root)
    single = [Mutation(change, {id(node): new}) for node in nodes for change, new in node.changes()]
    everywhere: dict[tuple[str, str], list[Mutation]] = {}
    for mutation in single:
        if text := mutation.change.everywhere:
            everywhere.setdefault((mutation.change.name, text), []).append(mutation)
    for (name, text), several in everywhere.items():
        first = several[0].change
        replaced = {key: node for mutation in reversed(several) for key, node in mutation.replaced.items()}
        if len(replaced) > 1:
            single = [mutation for mutation in single if mutation not in several or mutation.change.one_by_one]
            single.append(Mutation(Change(name, text, advice=first.advice, in_parts=first.in_parts), replaced))
    detours = [
        Mutation(mutation.change, {id(node): mutate(way, mutation.replaced)}, frozenset(mutation.replaced))
        for node in nodes
        for way in node.ways
        for mutation in mutations(way)
    ]
    return [*single, *detours, *_siblings_confused(root)]


def _siblings_confused(root: Expression) -> Iterator[Mutation]:
    """Yield the changes by which a given value takes the place of another one of its kind: q_2 for q_1, or each the next one.

    Values are of one kind if they have the same letter, such as q_1 and q_2, and the same shape.
    """
    families: dict[Any, dict[str, list[Expression]]] = {}
    for node in _nodes(root):
        # An angle that is given in degrees is taken for another one in radians.
        leaf = node.arguments[0] if node.operation.name == "radians" and len(node.arguments) == 1 else node
        letter, underscore, _ = leaf.label.partition("_")
        if underscore and not leaf.arguments:
            families.setdefault((letter, np.shape(node.value)), {}).setdefault(leaf.label, []).append(node)
    for family in families.values():
        labels = sorted(family)
        # A copy has an id of its own, so that it is not replaced again; the leaf of a conversion goes with it.
        outer = {label: max(nodes, key=lambda node: len(node.arguments)) for label, nodes in family.items()}

        def put(changes: Mapping[str, str], outer: Mapping[str, Expression] = outer) -> Mapping[int, Expression]:
            return {id(outer[one]): replace(outer[other]) for one, other in changes.items()}

        if not 1 < len(labels) <= MAX_SIBLINGS:
            continue
        for one, other in permutations(labels, 2):
            text = f"use ${other}$, where ${one}$ belongs"
            yield Mutation(Change("another given value", text, alone=True), put({one: other}))
        for one, other in combinations(labels, 2):
            text = f"swap ${one}$ and ${other}$"
            yield Mutation(Change("given values swapped", text, alone=True), put({one: other, other: one}))
        if len(labels) == 2:
            continue
        listed = ", ".join(f"${label}$" for label in labels)
        for by, where in ((1, "early"), (-1, "late")):
            moved = {one: labels[(k + by) % len(labels)] for k, one in enumerate(labels)}
            text = f"take each of {listed} one place too {where}"
            yield Mutation(Change("given values shifted", text, alone=True), put(moved))
        for one in labels:
            text = f"use ${one}$ for all of {listed}"
            yield Mutation(
                Change("one value for all", text, alone=True), put(dict.fromkeys([x for x in labels if x != one], one))
            )


def pairs(root: Expression, single: Sequence[Mutation]) -> Iterator[tuple[Mutation, Mutation]]:
    """Yield every two changes: of two parts, or one after the other where the first change has put new parts."""
    for one, other in combinations(single, 2):
        if one.replaced.keys().isdisjoint(other.replaced.keys()):
            yield one, other
    old = {id(node) for node in _nodes(root)}
    for mutation in single:
        if len(mutation.replaced) == 1:
            [new] = mutation.replaced.values()
            for node in _nodes(new):
                if id(node) not in old:
                    for change, newer in node.changes():
                        yield mutation, Mutation(change, {id(node): newer})


def mutant(
    changes: Sequence[Change],
    value: Any,
    advice: Mapping[str, str],
    key: Any = None,
    *,
    steps: tuple[Step, ...] = (),
    spoils: bool = False,
) -> Mistake:
    """Return the mistake of some changes that lead to a value.

    advice  for names or texts of changes, a sentence on what is right, instead of their own
    key     equal for mutants that are the same expression
    steps   what the changes do, and where
    spoils  whether they belong to the method for all parts of the answer

    >>> mutant([Change("degrees", "use degrees as radians")], 3.0, {}).message
    'You used degrees as radians.'
    """
    names = tuple(change.name for change in changes)
    advice_of = dict.fromkeys(advice.get(change.text, advice.get(change.name, change.advice)) for change in changes)
    further = list(filter(None, advice_of))
    texts = list(dict.fromkeys(change.text for change in changes))
    twice = ", twice" * (len(texts) < len(changes))
    sentence = f"You {', and you '.join(dict.fromkeys(change.past for change in changes))}{twice}."
    also = "also " * (len(changes) > 1)
    part = f"This is {also}what you get if you {', and you '.join(texts)}{twice}."
    in_parts = part * all(change.in_parts for change in changes)
    return Mistake(
        " and ".join(names),
        value,
        " ".join([sentence, *further]),
        in_parts,
        names,
        key,
        spoils=spoils,
        credit=min(change.credit for change in changes),
        possible=" ".join([part, *further[: 2 - len(changes)]]),
        steps=steps,
    )


def value_of(expression: Expression) -> Any:
    """Return the value of an expression, or None where it has none: a mutant need not be computable."""
    try:
        with np.errstate(all="ignore"):
            return expression.value
    except (ValueError, TypeError, IndexError, ArithmeticError, np.linalg.LinAlgError):
        return None


def _nodes(root: Expression) -> list[Expression]:
    """Return the different parts of an expression, each before its own parts."""
    found: dict[int, Expression] = {}

    def visit(node: Expression) -> None:
        if id(node) not in found:
            found[id(node)] = node
            for argument in node.arguments:
                visit(argument)

    visit(root)
    return list(found.values())
