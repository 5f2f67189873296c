"""Answers from outside: what people may hand in, made from the statement and the given values alone.

Where the right answer stands in a drawing, or is one of many, they are made from ours. No module here imports the engine, the
problems or kinlib, but for the one that judges, and the test. Each answer carries the sentence of what its maker did, and the
words by which feedback may name it. A card that says something else as a fact is false, even if its numbers agree.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

NAMELESS = frozenset({"-"})
"""The words of an answer that has no name: a guess, or the answer of a neighbour. Only a false claim counts."""

EARNS_NOTHING = frozenset({
    "left the zeros of np.zeros", "left the ones of np.ones", "left the identity of np.eye", "wrote the last row first",
    "wrote the rows one down", "moved the rows one down, and left 0 above", "moved the rows one down, and repeated the first",
    "carried the wrong way", "forgot .T after the rows", "position left out", "used R for R^T", "put the block at the top",
    "swapped a and d in every row", "swapped alpha and theta in every row", "left every number at 0",
    "wrote the columns in the order d, theta, a, alpha", "wrote the columns in the order theta, d, a, alpha",
    "moved a and alpha one row down", "moved a and alpha one row up", "moved a and alpha one row, with 0 in the empty row",
})  # fmt: skip
"""The kinds whose maker found nothing: guesses, and one wrong method for all rows. A mark for one of them is undeserved."""


@dataclass(frozen=True, eq=False)
class OutsideAnswer:
    """An answer, the sentence of what its maker did, and the words by which feedback may name it."""

    label: str
    value: Any
    did: frozenset[str] = frozenset()
    right: bool = False


Kinds = dict[str, tuple[Any, str]]
"""What was done -> the answer, and the words for it, separated by |."""

SPECIFIC: dict[str, Callable[..., Kinds]] = {}
"""For a problem, the function from its given values and its right answer to the kinds that belong to it alone."""

RIGHT_FORMS: dict[str, Callable[..., dict[str, Any]]] = {}
"""For a problem, the function from its given values and its right answer to right answers with other numbers."""


def kinds_of(*numbers: str) -> Callable[[Callable[..., Kinds]], Callable[..., Kinds]]:
    """Register the kinds that belong to some problems alone."""
    return lambda make: SPECIFIC.update(dict.fromkeys(numbers, make)) or make


def right_forms_of(*numbers: str) -> Callable[[Callable[..., dict[str, Any]]], Callable[..., dict[str, Any]]]:
    """Register the right answers with other numbers, such as a table with an axis reversed."""
    return lambda make: RIGHT_FORMS.update(dict.fromkeys(numbers, make)) or make


def outside_answers(number: str, given: Any, drawn: Any, neighbour: Any = None) -> Iterator[OutsideAnswer]:
    """Yield the answers to one student's problem.

    given      the given values
    drawn      the right answer, which is used only where it must be read from a drawing
    neighbour  the given values of another student
    """
    # They register their kinds.
    from outside import drawings, sheets_01_to_05, sheets_06_to_10, tables  # noqa: F401
    from outside.right import RIGHT, read_from_a_drawing
    from outside.shared import differs, legal_forms, shared_kinds
    from outside.slips import slips_of_given

    if number not in RIGHT:
        return
    kind, solve = RIGHT[number]
    value = solve(given) if number not in read_from_a_drawing else drawn
    own_forms = RIGHT_FORMS[number](given, value) if number in RIGHT_FORMS else {}
    for label, form in {**legal_forms(kind, value), **own_forms}.items():
        yield OutsideAnswer(label, form, right=True)
    own = SPECIFIC[number](given, value) if number in SPECIFIC else {}
    if neighbour is not None and kind != "letter" and number not in read_from_a_drawing:  # letters are all tried
        own["copied the answer of a neighbour"] = (solve(neighbour), "-")
    made = shared_kinds(kind, value) | {label: case for label, case in own.items() if differs(kind, case[0], value)}
    for label, case in slips_of_given(given, kind, solve).items() if number not in read_from_a_drawing else ():
        if all(differs(kind, case[0], known) for known in (value, *(known for known, _ in made.values()))):
            made[label] = case
    for label, (wrong, words) in made.items():
        yield OutsideAnswer(label, wrong, frozenset(word.strip() for word in words.split("|")))
