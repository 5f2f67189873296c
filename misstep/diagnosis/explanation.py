"""Explanations: what is seen in an answer, and the mistakes that lead to it or to some of its parts.

What is seen comes first: a placeholder, another unit, too few digits are no method, and a method must not be told for them. Then
the fewest changes win. The whole answer is compared with each mistake, because one mistake is more likely than one in each part;
then each wrong part, because a mistake is often made in one part and not in the next. Then the answer itself is compared with
the right one, and only then two mistakes at once are tried: two changes lead to so many answers that they are never a fact.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from misstep.answers.base import Answer
from misstep.answers.likeness import REORDERED
from misstep.mistakes import Mistake
from misstep.problem import Problem

MAX_ALTERNATIVES = 2
"""How many mistakes that lead to the same answer are told."""

UNCHECKED = {"another row", "unit of length", "degrees"}
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
        """Whether the parts that are right are right by chance only."""
        return self.is_reordered or (self.is_whole and all(mistake.spoils for mistake in self.mistakes))


def explain(problem: Problem, value: Any, wrong: Sequence[int]) -> list[Explanation]:
    """Return explanations of wrong parts. Parts that nothing explains are in none of them.

    value  an answer that was read
    wrong  the indices of its wrong parts, at least one
    """
    answer, is_single = problem.answer, len(problem.answer.parts) == 1
    if seen := answer.at_sight(value):
        return [_seen(wrong, value, seen, spoils=True)]
    sights = {part: seen for part in wrong if (seen := answer.appearance(value, part))}
    groups = [problem.mistakes, list(problem.mutants_near(value)), problem.slips]
    for group in groups:
        if whole := [one for one in group if all(answer.shows(value, one.value))]:
            return [_told(problem, value, wrong, _distinct(whole), is_whole=True)]
    is_seen_through = all(name == "placeholder" for name, _ in sights.values())  # as is the gap where rows are moved
    seen = None if is_single else answer.arrangement(value)
    if seen and (is_seen_through or seen[0] in REORDERED):
        told = _checked(answer, value, _seen(wrong, value, seen))
        is_reordered = seen[0] in REORDERED or _is_reordered(answer, value, wrong)
        return [replace(told, is_whole=True, is_reordered=is_reordered)]
    found, wrong = _joined(sights, value), [part for part in wrong if part not in sights]
    by_part = [] if is_single else _explain_parts(problem, value, set(wrong), groups)
    found += [_told(problem, value, parts, mistakes) for parts, mistakes in by_part]
    left = _left(wrong, found)
    compared = _joined({part: seen for part in left if (seen := answer.explanation(value, part))}, value)
    found += [_checked(answer, value, one) for one in compared]
    described = _joined({p: seen for p in _left(wrong, found) if (seen := answer.description(value, p))}, value)
    return found + [_checked(answer, value, one) for one in described]


def _is_reordered(answer: Answer, value: Any, wrong: Sequence[int]) -> bool:
    return answer.rows_are_alike and len(wrong) >= len(answer.parts) - 1 > 1 and bool(answer.arrangement(value))


def _left(wrong: Sequence[int], found: Sequence[Explanation]) -> list[int]:
    explained = {part for one in found for part in one.parts}
    return [part for part in wrong if part not in explained]


def _seen(parts: Sequence[int], value: Any, seen: tuple[str, str], *, spoils: bool = False) -> Explanation:
    name, text = seen
    return Explanation(list(parts), [Mistake(name, value, text, text, spoils=spoils)], text, is_whole=spoils)


def _joined(seen: dict[int, tuple[str, str]], value: Any) -> list[Explanation]:
    """Return one explanation for all parts of which the same is to be said."""
    by_text = sorted(seen.items(), key=lambda item: item[1])
    return [
        _seen([part for part, _ in group], value, text) for text, group in groupby(by_text, key=lambda item: item[1])
    ]


def _checked(answer: Answer, value: Any, told: Explanation) -> Explanation:
    """Return an explanation with what the student can check, of the first of its parts that does not pass."""
    if told.mistakes[0].name in UNCHECKED or (answer.rows_are_alike and answer.arrangement(value)):
        return told
    found = [(answer.parts[part], check) for part in told.parts if (check := answer.check(value, part))]
    if not found:
        return told
    name, check = found[0]
    is_clear = len(told.parts) == 1 or (len(found) > 1 and len({text for _, text in found}) == 1)
    return replace(told, check=check if is_clear else f"{name[:1].upper()}{name[1:]}: {check}")


def _told(
    problem: Problem, value: Any, parts: Sequence[int], mistakes: Sequence[Mistake], *, is_whole: bool = False
) -> Explanation:
    is_slip = mistakes[0] in problem.slips
    # A card gives the name of the part, so that a slip need not say which one is right.
    is_reordered = is_whole and _is_reordered(problem.answer, value, parts)
    is_labelled = is_slip and not is_reordered and len(parts) < len(problem.answer.parts)
    text = message_of(mistakes, is_whole and not (is_labelled and mistakes[0].part))
    told = Explanation(list(parts), mistakes, text, is_whole, is_reordered, is_method=not is_slip)
    return _checked(problem.answer, value, told) if is_slip else told


def _explain_parts(
    problem: Problem, value: Any, wrong: Collection[int], groups: Iterable[Sequence[Mistake]]
) -> Iterator[tuple[list[int], list[Mistake]]]:
    """Explain each wrong part by the mistakes that explain the most of the parts that are left."""
    answer, left = problem.answer, set(wrong)
    matching = [
        [
            (mistake, parts)
            for mistake in group
            if mistake.part
            and (parts := {part for part, is_same in enumerate(answer.shows(value, mistake.value)) if is_same} & left)
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
    """Return the mistakes without those that are an earlier one in other words."""
    return list({mistake.key: mistake for mistake in reversed(mistakes)}.values())[::-1]


def name_of(mistakes: Sequence[Mistake]) -> str:
    """Return the name of mistakes that cannot be told apart: "reversed or order".

    >>> name_of([Mistake("order", 1, ""), Mistake("order", 1, ""), Mistake("sign", 1, "")])
    'order or sign'
    """
    return " or ".join(dict.fromkeys(mistake.name for mistake in mistakes[: MAX_ALTERNATIVES + 1]))


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
    other = next((one for one in others if one.name != first.name and one.did != first.did), None)
    if other is None:
        return first.message if whole else first.part
    if first.did and other.did:
        advice = [] if first.advice == other.advice else [other.advice]
        for further in ([first.advice, *advice], [first.advice], []):
            text = " ".join(
                filter(None, [f"This is what you get if you {first.did}, or if you {other.did}.", *further])
            )
            if len(text) <= MAX_LENGTH:
                break
        return text
    texts = [one.message if whole else one.part for one in (first, other)]
    return texts[0] if texts[0] == texts[1] else f"{texts[0]} Or: {texts[1]}"
