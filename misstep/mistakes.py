"""Mistakes: named errors, the wrong answers to which they lead, and the feedback for them."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Step:
    """What was changed in a solution, so that two mistakes can be seen to be one story.

    name     of the mistake
    words    what was done, without its symbols
    changed  the ids of the parts that were changed
    within   the ids of these parts and of all that they are made of
    values   the given values that were put in the place of others; "" for any other change

    >>> whole = Step("sign", "take with the opposite sign", frozenset({1}), frozenset({1, 2, 3}))
    >>> factor = Step("sign of an angle", "take with the opposite sign", frozenset({3}), frozenset({3}))
    >>> whole.is_like(factor), whole.is_like(Step("sign", "", frozenset({4}), frozenset({4})))
    (True, False)
    """

    name: str
    words: str
    changed: frozenset[int]
    within: frozenset[int]
    values: str = ""

    def is_like(self, other: "Step") -> bool:
        """Return whether another step does the same to a part of this part, or to what this is a part of.

        Two given values are the same one if they are equal.
        """
        is_nested = bool(self.changed & other.within or other.changed & self.within)
        if self.values and other.values:
            return is_nested and (self.name, self.values) == (other.name, other.values)
        is_nested = is_nested and self.changed != other.changed
        return is_nested and (self.name == other.name or self.words == other.words)


@dataclass(frozen=True, eq=False)
class Mistake:
    """A named error, the wrong answer to which it leads, and the feedback for a student who gave this answer.

    name     the name, the same in every problem in which the error occurs
    value    the wrong answer
    message  the feedback if the whole answer is this one
    part     the feedback if one part of the answer is that of this one; it speaks of this part alone. If it is empty, the
             mistake explains only whole answers
    names    the names of the errors, if several of them lead to this answer together
    key      equal for two mistakes that are the same one, described in two ways
    spoils   whether it is a wrong method for the whole answer, so that a part that comes out right earns nothing
    credit   the fraction of the points for what follows rightly, if it is a mistake of a problem before
    possible the feedback where the answer does not show that it was made; by default the message
    steps    what was changed in a solution, if it is a mutant
    """

    name: str
    value: Any
    message: str
    part: str = ""
    names: tuple[str, ...] = ()
    key: Any = None
    spoils: bool = False
    credit: float = 0.0
    possible: str = ""
    steps: tuple[Step, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "names", self.names or (self.name,))
        object.__setattr__(self, "key", id(self) if self.key is None else self.key)

    def retells(self, other: "Mistake") -> bool:
        """Return whether this is the story of another mistake: of a part or the whole of what it changes, or in other symbols.

        Of two changes one may be the same, and the other be told in the same words.

        >>> Mistake("order", 6, "You swapped them.").retells(Mistake("order", 6, "You swapped them."))  # no mutants
        False
        """
        pairs = list(zip(self.steps, other.steps, strict=False))
        if not pairs or len(self.steps) != len(other.steps):
            return False
        same = sum(one.changed == its.changed and one.words == its.words for one, its in pairs)
        alike = sum(one.words == its.words or one.is_like(its) for one, its in pairs)
        return alike == len(pairs) > same > 0 or all(one.is_like(its) for one, its in pairs)


def mistake(name: str, value: Any, message: str, part: str = "", *, spoils: bool = False) -> Mistake:
    """Make a Mistake; the value is the wrong answer, or a function that computes it.

    spoils  whether it is a wrong method for the whole answer, so that a part that comes out right earns nothing

    >>> mistake("sign", lambda: -1, "You turned the wrong way.").value
    -1
    """
    return Mistake(name, value() if callable(value) else value, message, part, spoils=spoils)
