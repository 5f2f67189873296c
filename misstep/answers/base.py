"""The interface of a kind of answer: how an answer is read, compared, explained and stored.

A new kind of answer is one subclass of Answer. It defines what to type (`expected`), the `parts` that are judged one by one, and
how a value is read (`read`) and compared (`agrees`); of the other methods only those whose default is not enough.

A check cell stores the answer as JSON (`misstep.storage`), so that a grader reads data and never runs what made it. Numbers,
arrays, text, lists, dictionaries, SymPy expressions and the outputs of functions are stored without further ado; an object is
stored if it has a method to_dict(), and read back if its class is in `misstep.storage.OBJECTS`.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar

from misstep.mutants.expression import Slip

TOLERANCE = 1e-3
"""The accepted error of a number, relative to its size if that is above 1: three printed decimals are enough."""

MAX_NUMBER = 1e12
"""The largest number that an answer may have. A larger one is the result of an error, and its square might overflow."""

Named = tuple[str, str]
"""The name of what is wrong, and a sentence that is true of it; the name is "" if the sentence names no mistake."""


class Unreadable(ValueError):
    """A value is not an answer of the kind that the problem expects. The message says what was expected and what was given."""


class Answer(ABC):
    """The right answer of a problem, and the way to read and compare other answers of its kind.

    An answer has parts, for example the rotation and the position of a pose, so that feedback can say which part is right,
    and a mistake in one part does not cost the points of the others.

    value       the right answer
    inputs      the arguments of each call, if the answer is a function
    alike_rows  whether the parts come from one method, as the rows of a table of screws do, so that none counts alone
    """

    value: Any
    inputs: Sequence[Any] = ()
    alike_rows: ClassVar[bool] = False

    @property
    @abstractmethod
    def expected(self) -> str:
        """What to type, in words: "an array of shape (3, 6)"."""

    @property
    @abstractmethod
    def parts(self) -> Sequence[str]:
        """The names of the parts that are judged and scored one by one."""

    @abstractmethod
    def read(self, given: Any) -> Any:
        """Read what a student typed, or what was stored, as a value that `agrees` can compare.

        A value that was read before is returned unchanged. Objects of students may raise any error while they are read.

        Raises Unreadable with what was expected and what was given.
        """

    @abstractmethod
    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        """Compare two values that were read: for each part, whether they are the same answer."""

    @property
    def slips(self) -> Sequence[Slip]:
        """The slips that people make in any answer of this kind; each makes a wrong value from the right one."""
        return ()

    def placeholder(self, given: Any) -> Named | None:
        """Return what is seen in a whole wrong answer: that it was left as it was."""
        return None

    def seen(self, given: Any, part: int) -> Named | None:
        """Return what is seen in a wrong part: a placeholder, another unit, too few digits."""
        return None

    def at_sight(self, given: Any) -> Named | None:
        """Return what is seen in a whole wrong answer: a placeholder, or of a single part also another unit."""
        seen = self.placeholder(given) or (self.seen(given, 0) if len(self.parts) == 1 else None)
        return seen if seen and seen[0] != "rounded" else None

    def order(self, given: Any) -> Named | None:
        """Return whether the parts of a wrong answer are right, but in another order."""
        return None

    def resemblance(self, given: Any, part: int) -> Named | None:
        """Return how a wrong part resembles the right one: by signs, a factor, an order, one entry."""
        return None

    def check(self, given: Any, part: int) -> str:
        """Return what every right answer fulfils and this part does not, with its own numbers; "" if there is no such thing."""
        return ""

    def remark(self, given: Any) -> str:
        """Return how this right answer differs from ours, if several are right; "" if there is nothing to say."""
        return ""

    def counts(self, given: Any, right: Sequence[bool]) -> bool:
        """Return whether the right parts of a partly right answer earn their share: what a wrong method gives does not."""
        return True

    @property
    def has_alike_rows(self) -> bool:
        """Whether one method gives all parts, of which there are several."""
        return self.alike_rows and len(self.parts) > 1

    def at_inputs(self, solution: Any = None) -> Iterator[Any]:
        """Yield a solution, or without one the right value, at each input: once, if the answer is no function of inputs."""
        yield self.value if solution is None else solution

    def collect(self, values: Sequence[Any]) -> Any:
        """Return the answer with these values at the first inputs, as if it had been read. Raises Unreadable if there is none."""
        return self.read(values[0])
