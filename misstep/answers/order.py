"""Orders as answers: names in a sequence, each used once."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Unreadable
from misstep.answers.number import wrong_slips
from misstep.mistakes import Mistake


@dataclass(frozen=True, eq=False)
class Ordering(Answer):
    """Names in an order, each used once.

    >>> Ordering(["M", "e1"]).read(["e1", "M"])
    ['e1', 'M']
    """

    value: Sequence[str]

    @property
    def expected(self) -> str:
        return f"a list of the {len(self.value)} names {', '.join(sorted(self.value))}, each once"

    @property
    def parts(self) -> Sequence[str]:
        return ["the order"]

    def read(self, given: Any) -> list[str]:
        if not isinstance(given, (list, tuple)) or len(given) > 10 * len(self.value):
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        unknown = [name for name in given if not isinstance(name, str) or name not in self.value]
        if unknown:
            raise Unreadable(
                f"Expected {self.expected}; {validation.brief(unknown[0])} is none of them. Did you leave out the quotes?"
            )
        missing = [name for name in self.value if given.count(name) != 1]
        if missing:
            count = given.count(missing[0])
            found = f"{missing[0]} appears {count} times" if count else f"{missing[0]} is missing"
            raise Unreadable(f"Expected {self.expected}; {found}.")
        return list(given)

    def agrees(self, one: Sequence[str], other: Sequence[str], tolerance: float = TOLERANCE) -> list[bool]:
        return [list(one) == list(other)]

    def slips(self) -> Iterator[Mistake]:
        """Yield the right order with the changes that people make by hand."""
        right = list(self.value)
        changes = [("reversed", right[::-1], "Your order is the right one, reversed.")]
        for i in range(len(right) - 1):
            one, other = right[i : i + 2]
            swapped = [*right[:i], other, one, *right[i + 2 :]]
            changes.append(("neighbours swapped", swapped, f"Only {one} and {other} are swapped."))
        for i, one in enumerate(right):
            rest = right[:i] + right[i + 1 :]
            for end in range(len(right)):
                if abs(end - i) > 1:
                    where = {0: ": at the beginning", len(rest): ": at the end"}.get(end, "")
                    text = f"Only {one} is in the wrong place{where}."
                    changes.append(("one in the wrong place", [*rest[:end], one, *rest[end:]], text))
        return wrong_slips(self, ((name, value, text, text) for name, value, text in changes))
