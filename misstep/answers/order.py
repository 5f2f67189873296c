"""Orders as answers: names in a sequence, each used once."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Unreadable


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
            raise Unreadable(f"Expected {self.expected}; {missing[0]} appears {given.count(missing[0])} times.")
        return list(given)

    def agrees(self, one: Sequence[str], other: Sequence[str], tolerance: float = TOLERANCE) -> list[bool]:
        return [list(one) == list(other)]
