"""Explanations: the mistakes that lead to an answer, or to some of its parts.

The fewest changes win. First the whole answer is compared with each mistake, because one mistake is more likely than one in each
part; then each wrong part, because a mistake is often made in one part and not in the next; then two mistakes at once. Where
several mistakes lead to the same answer, it does not show which one was made, and the explanation names them all.
"""

from collections.abc import Iterable, Sequence
from typing import Any

from misstep.mistakes import Mistake
from misstep.problem import Problem

MAX_ALTERNATIVES = 3
"""How many mistakes that lead to the same answer are named."""

Explanation = tuple[list[int], Sequence[Mistake]]
"""Wrong parts, and the mistakes each of which explains them."""


def explain(problem: Problem, value: Any, wrong: Sequence[int]) -> list[Explanation]:
    """Return explanations of wrong parts. Parts that no mistake explains are in none of them.

    value  an answer that was read
    wrong  the indices of its wrong parts, at least one
    """
    groups = [problem.mistakes, list(problem.mutants_near(value)), problem.slips]
    for group in groups:
        if whole := [mistake for mistake in group if all(problem.answer.agrees(value, mistake.value))]:
            return [(list(wrong), _distinct(whole))]
    answer, is_single = problem.answer, len(problem.answer.parts) == 1
    by_part = [] if is_single else _explain_parts(problem, value, set(wrong), groups)
    explained = {part for parts, _ in by_part for part in parts}
    left = {part for part in wrong if part not in explained}
    if problem.solution is not None and (left := {part for part in left if answer.pins_down(value, part)}):
        doubles = [
            wrong_twice for wrong_twice in problem.double_mutants(value) if any(answer.agrees(value, wrong_twice.value))
        ]
        if whole := [wrong_twice for wrong_twice in doubles if all(answer.agrees(value, wrong_twice.value))]:
            return [(list(wrong), _distinct(whole))]
        by_part += [] if is_single else _explain_parts(problem, value, left, [doubles])
    return by_part


def _explain_parts(
    problem: Problem, value: Any, wrong: set[int], groups: Iterable[Sequence[Mistake]]
) -> list[Explanation]:
    """Explain each wrong part by the mistakes that explain the most of the parts that are left."""
    matching = [
        [
            (mistake, {part for part, is_same in enumerate(problem.answer.agrees(value, mistake.value)) if is_same})
            for mistake in group
            if mistake.part
        ]
        for group in groups
    ]
    left = set(wrong)
    found: list[Explanation] = []
    while left:
        count, rank = max(
            ((len(parts & left), -rank) for rank, group in enumerate(matching) for _, parts in group), default=(0, 0)
        )
        if not count:
            break
        candidates = [(mistake, parts & left) for mistake, parts in matching[-rank] if len(parts & left) == count]
        explained = candidates[0][1]
        found.append((sorted(explained), _distinct([mistake for mistake, parts in candidates if parts == explained])))
        left -= explained
    return found


def _distinct(mistakes: Sequence[Mistake]) -> list[Mistake]:
    """Return the mistakes without those that are an earlier one in other words."""
    return list({mistake.key: mistake for mistake in reversed(mistakes)}.values())[::-1]


def name_of(mistakes: Sequence[Mistake]) -> str:
    """Return the name of mistakes that cannot be told apart: "reversed or order".

    >>> name_of([Mistake("order", 1, ""), Mistake("order", 1, ""), Mistake("sign", 1, "")])
    'order or sign'
    """
    return " or ".join(dict.fromkeys(mistake.name for mistake in mistakes[:MAX_ALTERNATIVES]))


def message_of(mistakes: Sequence[Mistake], whole: bool) -> str:
    r"""Return the message for mistakes that cannot be told apart.

    whole  whether they explain the whole answer, rather than a part of it

    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("sign", 1, "You forgot a sign.")], whole=True)
    'Several mistakes lead to this answer. Either: You swapped them. Or: You forgot a sign.'
    >>> message_of([Mistake("order", 1, "You swapped them."), Mistake("swap", 1, "You swapped them. The base is first.")], whole=True)
    'You swapped them. The base is first.'
    >>> print(message_of([Mistake(name, 1, f"You forgot {name}.") for name in "abcd"], whole=True).replace(" Or: ", "\nOr: "))
    Several mistakes lead to this answer. Either: You forgot a.
    Or: You forgot b.
    Or: You forgot c.
    Or: You made another mistake with the same result.
    """
    texts = list(dict.fromkeys(mistake.message if whole else mistake.part for mistake in mistakes))
    # The same sentence with advice behind it says it all.
    texts = [text for text in texts if not any(other.startswith(f"{text} ") for other in texts)]
    if len(texts) == 1:
        return texts[0]
    if len(texts) > MAX_ALTERNATIVES:
        texts = [*texts[:MAX_ALTERNATIVES], "You made another mistake with the same result."]
    return f"Several mistakes lead to this {'answer' if whole else 'part'}. Either: {' Or: '.join(texts)}"
