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

CONSEQUENCES = ("This is what you get if ", "This is also what you get if ")
"""The beginnings of what is said of one change of the solution, and of two."""

UNCHECKED = {"another row", "copied row", "unit of length", "degrees"}
"""The names of what needs no check: the numbers are right, at another place or in another unit."""

SAME_CONSEQUENCE = "You get the same if "

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
    if left and len(left) == len(answer.parts):
        copied = next((name for name, given in problem.given.items() if _is_copy(problem, value, given)), None)
        if copied:
            text = f"These are the numbers that are given as `{copied}`, unchanged."
            return [_seen(left, value, ("given unchanged", text), spoils=True)]
    compared = _joined({part: seen for part in left if (seen := answer.explanation(value, part))}, value)
    found += [_checked(answer, value, one) for one in compared]
    if problem.solution is not None and (left := [p for p in _left(wrong, found) if answer.pins_down(value, p)]):
        doubles = [twice for twice in problem.double_mutants(value) if any(answer.shows(value, twice.value))]
        whole = _distinct([twice for twice in doubles if all(answer.shows(value, twice.value))])
        if whole and len(left) == len(wrong):
            found.append(_told(problem, value, left, whole, is_whole=True))
        elif not is_single:
            pairs = _explain_parts(problem, value, set(left), [doubles])
            found += [_told(problem, value, parts, mistakes) for parts, mistakes in pairs]
    described = _joined({p: seen for p in _left(wrong, found) if (seen := answer.description(value, p))}, value)
    return found + [_checked(answer, value, one) for one in described]


def _is_reordered(answer: Answer, value: Any, wrong: Sequence[int]) -> bool:
    return answer.rows_are_alike and len(wrong) >= len(answer.parts) - 1 > 1 and bool(answer.arrangement(value))


def _left(wrong: Sequence[int], found: Sequence[Explanation]) -> list[int]:
    explained = {part for one in found for part in one.parts}
    return [part for part in wrong if part not in explained]


def _is_copy(problem: Problem, value: Any, given: Any) -> bool:
    """Return whether an answer is a given array, and not one that is right or 0 in the parts that count."""
    try:
        copy = problem.answer.read(given)
    except Exception:  # most given values are no answers at all
        return False
    return hasattr(given, "shape") and len(given.shape) > 0 and all(problem.answer.agrees(value, copy))


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
    # Where the answer is the right one but for signs or an order, other ways lead to it as easily.
    is_sure = all(problem.answer.pins_down(value, part) and not problem.answer.is_near(value, part) for part in parts)
    is_slip = mistakes[0] in problem.slips
    # A card gives the name of the part, so that a slip need not say which one is right.
    is_reordered = is_whole and _is_reordered(problem.answer, value, parts)
    is_labelled = is_slip and not is_reordered and len(parts) < len(problem.answer.parts)
    text = message_of(mistakes, is_whole and not (is_labelled and mistakes[0].part), is_sure)
    told = Explanation(list(parts), mistakes, text, is_whole, is_reordered, is_method=not is_slip)
    return _checked(problem.answer, value, told) if is_slip else told


def _explain_parts(
    problem: Problem, value: Any, wrong: Collection[int], groups: Iterable[Sequence[Mistake]]
) -> Iterator[tuple[list[int], list[Mistake]]]:
    """Explain each wrong part by the mistakes that explain the most of the parts that are left."""
    answer, left = problem.answer, set(wrong)
    # A single number is too often that of some mutant, which is told only if no part that is right speaks against it.
    is_short = not any(answer.pins_down(value, part) for part in wrong)

    def is_refuted(mistake: Mistake) -> bool:
        kept = answer.agrees(mistake.value, answer.value)
        return (
            bool(mistake.steps)
            and is_short
            and any(part not in wrong and not is_kept for part, is_kept in enumerate(kept))
        )

    matching = [
        [
            (mistake, parts)
            for mistake in group
            if mistake.part
            and (parts := {part for part, is_same in enumerate(answer.shows(value, mistake.value)) if is_same} & left)
            and not is_refuted(mistake)
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


def message_of(mistakes: Sequence[Mistake], whole: bool, is_sure: bool = True) -> str:
    r"""Return the message for mistakes that cannot be told apart: at most two of them, and each sentence once.

    whole    whether they explain the whole answer, rather than a part of it
    is_sure  whether the answer has so many digits that a single mistake has been made, and not only leads to it

    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("sign", 1, "You forgot a sign.")], whole=True)
    'Several mistakes lead to this answer. Either: You swapped them. Or: You forgot a sign.'
    >>> message_of([Mistake(x, 1, f"You took {x}.", possible=f"This is what you get if you take {x}.") for x in "ab"], whole=True)
    'This is what you get if you take a. You get the same if you take b.'
    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("swap", 1, "You swapped them. The base is first.")], whole=True)
    'You swapped them. The base is first.'
    >>> message_of([Mistake(name, 1, f"You forgot {name}.") for name in "abcd"], whole=True)
    'Several mistakes lead to this answer, for example these. Either: You forgot a. Or: You forgot b.'
    >>> halved = Mistake("halved", 1, "You took half.", possible="This is what you get if you take half.")
    >>> message_of([halved], whole=True, is_sure=False)
    'This is what you get if you take half.'
    """
    mistakes = [one for k, one in enumerate(mistakes) if not any(one.retells(other) for other in mistakes[:k])]
    texts = [mistake.message if whole else mistake.part for mistake in mistakes]
    if whole and not (is_sure and len(mistakes[0].names) == 1 and len(set(texts)) == 1):
        texts = [mistake.possible or mistake.message for mistake in mistakes]
    texts = list(dict.fromkeys(texts))
    # The same sentence with advice behind it says it all.
    texts = [text for text in texts if not any(other.startswith(f"{text} ") for other in texts)]
    if len(texts) == 1:
        return texts[0]
    kept, what = texts[:MAX_ALTERNATIVES], "answer" if whole else "part"
    some = ", for example these" if len(texts) > len(kept) else ""
    first, second = kept
    if len(first) + len(second) > MAX_LENGTH - 80:
        first, second = (f"{text.partition('. ')[0].removesuffix('.')}." for text in kept)
    said = set(SENTENCE_END.split(first))
    second = " ".join(sentence for sentence in SENTENCE_END.split(second) if sentence not in said)
    for begin in CONSEQUENCES:
        if first.startswith(begin) and second.startswith(begin):
            return f"{first} {SAME_CONSEQUENCE}{second.removeprefix(begin)}"
    return f"Several mistakes lead to this {what}{some}. Either: {first} Or: {second}"
