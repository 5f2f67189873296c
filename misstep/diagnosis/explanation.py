"""Findings on a wrong answer, in four stages.

What is seen at sight comes first: a placeholder, another unit, too few digits are no method, and a method must not be told for
them. Then one slip for the whole answer, because one slip is more likely than one in each part; then one for each wrong part;
and then how a part resembles the right one: by signs, a factor, an order, one entry.
"""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from misstep.answers.base import Answer, Named
from misstep.answers.likeness import REORDERED
from misstep.mistakes import Mistake
from misstep.problem import Problem

MAX_ALTERNATIVES = 2
"""How many mistakes that lead to the same answer are told."""

UNCHECKED = {"another row", "millimetres", "centimetres", "degrees"}
"""The names of what needs no check: the numbers are right, at another place or in another unit."""

SENTENCE_END = re.compile(r"(?<=[.!?]) ")
"""The space between two sentences."""

FORMULA, EVERYWHERE = re.compile(r"\$([^$]*)\$"), re.compile(r"\b(every|all|each)\b")

MAX_LENGTH = 400
"""How many characters the message of a finding has; further stories and advice are left out."""


@dataclass(frozen=True)
class Finding:
    """Why some parts of an answer are wrong: the mistakes each of which explains them, or a hint if none does.

    message    its first line is the idea; what follows is the place, or the number itself, which is told from the second try on
    check      what the student can check on the own numbers, and what these numbers give
    is_method  whether it says how the answer came about, and not only how it differs from the right one
    spoils     whether the parts that are right are what a wrong method gives as well
    """

    parts: Sequence[str]
    message: str
    mistakes: Sequence[Mistake] = ()
    check: str = ""
    is_method: bool = False
    spoils: bool = False

    @property
    def mistake(self) -> str | None:
        """The name; "a or b" if the answer does not show which mistake was made."""
        return " or ".join(dict.fromkeys(one.name for one in self.mistakes[:MAX_ALTERNATIVES])) or None

    @property
    def text(self) -> str:
        """The message and the check."""
        return f"{self.message} {self.check}".replace("\n", " ").strip()


def explain(problem: Problem, value: Any, wrong: Sequence[int]) -> list[Finding]:
    """Return findings on wrong parts. Parts that nothing explains are in none of them.

    value  an answer that was read
    wrong  the indices of its wrong parts, at least one
    """
    answer, names = problem.answer, [problem.answer.parts[part] for part in wrong]
    if seen := answer.at_sight(value):
        return [replace(_seen(names, seen), spoils=True)]
    groups = [problem.mistakes, list(problem.mutants(value)), problem.slips]
    is_moved = answer.has_alike_rows and len(wrong) >= len(answer.parts) - 1 > 1
    for group in groups:
        if mistakes := _distinct([one for one in group if all(answer.agrees(value, one.value))]):
            is_method, is_reordered = group is not problem.slips, is_moved and bool(answer.order(value))
            if len(answer.parts) == 1 and (seen := answer.seen(value, 0)):  # whole numbers may be both
                mistakes.insert(1, Mistake(seen[0], None, seen[1]))
            spoils = is_reordered or all(one.spoils for one in mistakes)
            told = Finding(names, message_of(mistakes), mistakes, "", is_method, spoils)
            return [_checked(answer, value, told)]
    sights = {part: seen for part in wrong if (seen := answer.seen(value, part))}
    is_single = len(answer.parts) == 1
    if not is_single and (order := answer.order(value)):
        is_reordered = order[0] in REORDERED
        # As is the gap where rows are moved.
        if is_reordered or all(name == "placeholder" for name, _ in sights.values()):
            return [replace(_seen(names, order), spoils=is_reordered or is_moved)]
    found, left = _joined(answer, sights), [part for part in wrong if part not in sights]
    for parts, mistakes in () if is_single else _explain_parts(answer, value, left, groups):
        told = Finding(parts, message_of(mistakes), mistakes, is_method=mistakes[0] not in problem.slips)
        found.append(_checked(answer, value, told))
    explained = {part for one in found for part in one.parts}
    left = [part for part in left if answer.parts[part] not in explained]
    alike = {part: seen for part in left if (seen := answer.resemblance(value, part))}
    return found + [_checked(answer, value, one) for one in _joined(answer, alike)]


def _seen(parts: Sequence[str], seen: Named) -> Finding:
    name, text = seen
    return Finding(list(parts), text, [Mistake(name, None, text)])


def _joined(answer: Answer, seen: dict[int, Named]) -> list[Finding]:
    """Return one finding for all parts of which the same is to be said."""
    groups = groupby(sorted(seen.items(), key=lambda item: item[1]), key=lambda item: item[1])
    return [_seen([answer.parts[part] for part, _ in group], text) for text, group in groups]


def _checked(answer: Answer, value: Any, told: Finding) -> Finding:
    """Return a finding that says no method with what the student can check, of the first of its parts that does not pass."""
    checks = [(part, answer.check(value, answer.parts.index(part))) for part in told.parts]
    found = [(part, check) for part, check in checks if check]
    if told.is_method or told.mistakes[0].name in UNCHECKED or not found:
        return told
    name, check = found[0]
    is_clear = len(told.parts) == 1 or (len(found) > 1 and len({text for _, text in found}) == 1)
    return replace(told, check=check if is_clear else f"{name[:1].upper()}{name[1:]}: {check}")


def _explain_parts(
    answer: Answer, value: Any, left: Collection[int], groups: Sequence[Sequence[Mistake]]
) -> Iterator[tuple[list[str], list[Mistake]]]:
    """Explain each wrong part by the mistakes that explain the most of the parts that are left.

    groups  of mistakes: those of the author, the mutants, and the slips in answers of this kind
    """
    left, right = set(left), answer.agrees(value, answer.value)
    fine, matching = {part for part, is_right in enumerate(right) if is_right}, []
    for rank, group in enumerate(groups):
        for mistake in (one for one in group if one.in_parts) if left else ():
            same = {part for part, is_same in enumerate(answer.agrees(value, mistake.value)) if is_same}
            # A change of the solution that would have changed a part that is right has not been made; one in every row is in all.
            is_everywhere = rank == 1 and fine <= same and EVERYWHERE.search(mistake.did)
            kept = answer.agrees(mistake.value, answer.value) if is_everywhere else ()
            if rank != 1 or fine | {k for k, is_kept in enumerate(kept) if not is_kept} <= same:
                matching.append((rank, mistake, same))
    while found := [(rank, mistake, same & left) for rank, mistake, same in matching if same & left]:
        best, _, explained = min(found, key=lambda one: (-len(one[2]), one[0]))
        alike = [mistake for rank, mistake, parts in found if rank == best and parts == explained]
        yield [answer.parts[part] for part in sorted(explained)], _distinct(alike)
        left -= explained


def _distinct(mistakes: Sequence[Mistake]) -> list[Mistake]:
    """Return one mistake of each name, the first one that leaves points to the right parts if there is one, and the same elsewhere."""
    by_name = {one.name: one for spoils in (True, False) for one in reversed(mistakes) if one.spoils == spoils}
    return [one for one in mistakes if (kept := by_name[one.name]) is one or (one.did and _is_elsewhere(one, kept))]


def _is_elsewhere(one: Mistake, other: Mistake) -> bool:
    """Return whether the same is done to two expressions, of which none is a part of the other."""
    return FORMULA.sub("$", one.did) == FORMULA.sub("$", other.did) and not _is_same_slip(one, other)


def _is_same_slip(one: Mistake, other: Mistake) -> bool:
    """Return whether the same is done to two expressions, one of which is a part of the other: a term, and its first factor."""
    (did, short), (same, long) = sorted((FORMULA.sub("$", x.did), FORMULA.findall(x.did)) for x in (one, other))
    return bool(did) and same.startswith(did) and all(a in b or b in a for a, b in zip(short, long, strict=False))


def message_of(mistakes: Sequence[Mistake]) -> str:
    """Return the message for mistakes that cannot be told apart: at most two of them, with different names.

    >>> took = [Mistake(f"an {x}", 1, f"This is what you get if you take {x}.", did=f"take {x}") for x in "ab"]
    >>> message_of(took)
    'This is what you get if you take a, or if you take b.'
    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("sign", 1, "You forgot a sign.")])
    'You swapped them. Or: You forgot a sign.'
    """
    same = [one for one in mistakes if one is mistakes[0] or _is_same_slip(one, mistakes[0])]
    first = min(same, key=lambda one: len(one.did))
    other = next((one for one in mistakes if one not in same and not _is_same_slip(one, first)), None)
    if other is None:
        return first.message
    if not (first.did and other.did):
        return first.message if first.message == other.message else f"{first.message} Or: {other.message}"
    text = f"This is what you get if you {first.did}, or if you {other.did}."
    for advice in dict.fromkeys(filter(None, (first.advice, other.advice))):
        text = f"{text} {advice}" if len(text) + len(advice) < MAX_LENGTH else text
    return text
