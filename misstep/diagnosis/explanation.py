"""Explanations of a wrong answer, in four stages.

What is seen at sight comes first: a placeholder, another unit, too few digits are no method, and a method must not be told for
them. Then one slip for the whole answer, because one slip is more likely than one in each part; then one for each wrong part;
and then how a part resembles the right one: by signs, a factor, an order, one entry.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from misstep.answers.base import Answer, Named, has_alike_rows, seen_at_sight
from misstep.answers.likeness import REORDERED
from misstep.mistakes import Mistake
from misstep.problem import Problem

MAX_ALTERNATIVES = 2
"""How many mistakes that lead to the same answer are told."""

UNCHECKED = {"another row", "millimetres", "degrees"}
"""The names of what needs no check: the numbers are right, at another place or in another unit."""

SENTENCE_END = re.compile(r"(?<=[.!?]) ")
"""The space between two sentences."""

MAX_LENGTH = 400
"""How many characters the message of a finding has; further stories and advice are left out."""


@dataclass(frozen=True)
class Explanation:
    """Wrong parts, the mistakes each of which explains them, and the message.

    is_whole      whether they explain the whole answer
    is_reordered  whether the rows are the right ones in an order in which at most one keeps its place
    is_method     whether it says how the answer came about, and not only how it differs from the right one
    check         what the student can check on the own numbers
    """

    parts: Sequence[int]
    mistakes: Sequence[Mistake]
    message: str
    is_whole: bool = False
    is_reordered: bool = False
    is_method: bool = False
    check: str = ""

    @property
    def spoils(self) -> bool:
        """Whether the parts that are right are what a wrong method gives as well."""
        return self.is_reordered or (self.is_whole and all(mistake.spoils for mistake in self.mistakes))


def explain(problem: Problem, value: Any, wrong: Sequence[int]) -> list[Explanation]:
    """Return explanations of wrong parts. Parts that nothing explains are in none of them.

    value  an answer that was read
    wrong  the indices of its wrong parts, at least one
    """
    answer = problem.answer
    if seen := seen_at_sight(answer, value):
        return [_seen(wrong, value, seen, spoils=True)]
    groups = [problem.mistakes, list(problem.mutants_near(value)), problem.slips]
    for group in groups:
        if whole := [one for one in group if all(answer.agrees(value, one.value))]:
            mistakes = _distinct(whole)
            text = message_of(mistakes, whole=True)
            is_general = group is problem.slips
            told = Explanation(list(wrong), mistakes, text, True, _is_reordered(answer, value, wrong), not is_general)
            return [_checked(answer, value, told) if is_general else told]
    sights = {part: seen for part in wrong if (seen := answer.seen(value, part))}
    is_single, order = len(answer.parts) == 1, None
    if not is_single and all(
        name == "placeholder" for name, _ in sights.values()
    ):  # as is the gap where rows are moved
        order = answer.resemblance(value, None)
    elif not is_single and (order := answer.resemblance(value, None)) and order[0] not in REORDERED:
        order = None
    if order:
        is_reordered = order[0] in REORDERED or _is_reordered(answer, value, wrong)
        return [replace(_checked(answer, value, _seen(wrong, value, order)), is_whole=True, is_reordered=is_reordered)]
    found, left = _joined(sights, value), [part for part in wrong if part not in sights]
    for parts, mistakes in () if is_single else _explain_parts(answer, value, set(left), groups):
        told = Explanation(
            parts, mistakes, message_of(mistakes, whole=False), is_method=mistakes[0] not in problem.slips
        )
        found.append(told if told.is_method else _checked(answer, value, told))
    explained = {part for one in found for part in one.parts}
    alike = {part: seen for part in left if part not in explained and (seen := answer.resemblance(value, part))}
    return found + [_checked(answer, value, one) for one in _joined(alike, value)]


def _is_reordered(answer: Answer, value: Any, wrong: Sequence[int]) -> bool:
    return has_alike_rows(answer) and len(wrong) >= len(answer.parts) - 1 > 1 and bool(answer.resemblance(value, None))


def _seen(parts: Sequence[int], value: Any, seen: Named, *, spoils: bool = False) -> Explanation:
    name, text = seen
    return Explanation(list(parts), [Mistake(name, value, text, text, spoils=spoils)], text, is_whole=spoils)


def _joined(seen: dict[int, Named], value: Any) -> list[Explanation]:
    """Return one explanation for all parts of which the same is to be said."""
    by_text = sorted(seen.items(), key=lambda item: item[1])
    return [
        _seen([part for part, _ in group], value, text) for text, group in groupby(by_text, key=lambda item: item[1])
    ]


def _checked(answer: Answer, value: Any, told: Explanation) -> Explanation:
    """Return an explanation with what the student can check, of the first of its parts that does not pass."""
    if told.mistakes[0].name in UNCHECKED or told.is_reordered:
        return told
    found = [(answer.parts[part], check) for part in told.parts if (check := answer.check(value, part))]
    if not found:
        return told
    name, check = found[0]
    is_clear = len(told.parts) == 1 or (len(found) > 1 and len({text for _, text in found}) == 1)
    return replace(told, check=check if is_clear else f"{name[:1].upper()}{name[1:]}: {check}")


def _explain_parts(
    answer: Answer, value: Any, left: Collection[int], groups: Iterable[Sequence[Mistake]]
) -> Iterator[tuple[list[int], list[Mistake]]]:
    """Explain each wrong part by the mistakes that explain the most of the parts that are left."""
    left = set(left)
    matching = [
        [
            (mistake, parts)
            for mistake in group
            if mistake.part
            and (parts := {k for k, is_same in enumerate(answer.agrees(value, mistake.value)) if is_same} & left)
        ]
        for group in groups
    ]
    while left:
        count, rank = max(
            ((len(parts & left), -rank) for rank, group in enumerate(matching) for _, parts in group), default=(0, 0)
        )
        if not count:
            break
        candidates = [(mistake, parts & left) for mistake, parts in matching[-rank] if len(parts & left) == count]
        explained = candidates[0][1]
        yield sorted(explained), _distinct([mistake for mistake, parts in candidates if parts == explained])
        left -= explained


def _distinct(mistakes: Sequence[Mistake]) -> list[Mistake]:
    """Return one mistake of each name, the first one that leaves points to the right parts if there is one."""
    by_name = {mistake.names: mistake for mistake in reversed(mistakes) if mistake.spoils}
    by_name |= {mistake.names: mistake for mistake in reversed(mistakes) if not mistake.spoils}
    return [mistake for mistake in mistakes if by_name[mistake.names] is mistake]


def name_of(mistakes: Sequence[Mistake]) -> str:
    """Return the name of mistakes that cannot be told apart: "reversed or order".

    >>> name_of([Mistake("order", 1, ""), Mistake("sign", 1, "")])
    'order or sign'
    """
    return " or ".join(dict.fromkeys(mistake.name for mistake in mistakes[:MAX_ALTERNATIVES]))


def message_of(mistakes: Sequence[Mistake], whole: bool) -> str:
    r"""Return the message for mistakes that cannot be told apart: at most two of them, with different names.

    whole  whether they explain the whole answer, rather than a part of it

    >>> took = [Mistake(f"an {x}", 1, f"This is what you get if you take {x}.", did=f"take {x}") for x in "ab"]
    >>> message_of(took, whole=True)
    'This is what you get if you take a, or if you take b.'
    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("sign", 1, "You forgot a sign.")], whole=True)
    'You swapped them. Or: You forgot a sign.'
    """
    first, *others = mistakes
    other = next((one for one in others if one.did != first.did or not first.did), None)
    if other is None:
        return first.message if whole else first.part
    if not (first.did and other.did):
        texts = [one.message if whole else one.part for one in (first, other)]
        return texts[0] if texts[0] == texts[1] else f"{texts[0]} Or: {texts[1]}"
    text = f"This is what you get if you {first.did}, or if you {other.did}."
    for advice in dict.fromkeys(filter(None, (first.advice, other.advice))):
        text = f"{text} {advice}" if len(text) + len(advice) < MAX_LENGTH else text
    return text
