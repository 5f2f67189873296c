"""The interface of a kind of answer: how an answer is read, compared, stored and withheld.

A new kind of answer is one file with one subclass of Answer, in misstep/answers/ if it fits any subject, or in the folder
answers/ of a course. It defines:

    expected          what to type, in words, for feedback
    parts             the names of the parts that are judged and scored one by one
    read              how a student's value is read, or refused by Unreadable
    agrees            how two values are compared, part by part

and of the other methods of Answer only those whose default is not enough.

Storing: a check cell stores the answer as JSON (`misstep.storage`), so that a grader reads data and never runs what made it.
Numbers, arrays, text, lists, dictionaries, SymPy expressions and the outputs of functions are stored without further ado.
An object is stored if it has a method to_dict(); `stored_objects` registers its class when the subclass of Answer is defined.
`Course.requires` names the package of that class, so that submissions can import it.

Withholding: where submissions run, neither the answer nor its class is available. The only attribute that travels there is
`inputs`, so `inputs` must not contain anything that helps to find the answer.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, ClassVar

from misstep.answers.accuracy import TOLERANCE
from misstep.display.sentences import FOUR_DIGITS
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression
from misstep.storage.deserialize import register_object

MAX_NUMBER = 1e12
"""The largest number that an answer may have. A larger one is the result of an error, and its square might overflow."""


Quantifier = Callable[[Iterable[bool]], bool]
"""The function any, or the function all."""

StoredObjects = Mapping[type, Callable[[Mapping[str, Any]], Any]]
"""For each class of objects, the function that makes an object from its fields by name."""


class Unreadable(ValueError):
    """A value is not an answer of the kind that the problem expects. The message says what was expected and what was given."""


class Answer(ABC):
    """The right answer of a problem, and the way to read and compare other answers of its kind.

    An answer has parts, for example the rotation and the position of a pose, so that feedback can say which part is right,
    and a mistake in one part does not cost the points of the others.

    value   the right answer
    inputs  the arguments of each call, if the answer is a function

    >>> class Gain:
    ...     def __init__(self, decibel): self.decibel = decibel
    ...     def to_dict(self): return {"decibel": self.decibel}
    >>> class GainAnswer(Answer):
    ...     stored_objects = {Gain: lambda fields: Gain(float(fields["decibel"]))}
    ...     expected, parts = "a gain", ["the gain"]
    ...     def __init__(self, value): self.value = value
    ...     def read(self, given):
    ...         if not isinstance(given, Gain):
    ...             raise Unreadable(f"Expected {self.expected}; got {given!r}.")
    ...         return given
    ...     def agrees(self, one, other, tolerance=TOLERANCE):
    ...         return [abs(one.decibel - other.decibel) <= tolerance]
    >>> from misstep.storage.deserialize import from_data
    >>> from misstep.storage.serialize import to_data
    >>> answer = GainAnswer(Gain(20.0))
    >>> stored = to_data(Gain(20.0))
    >>> stored
    {'object': 'Gain', 'fields': {'decibel': 20.0}}
    >>> answer.agrees(answer.read(from_data(stored)), answer.value)
    [True]
    """

    value: Any
    inputs: Sequence[Any] = ()
    stored_objects: ClassVar[StoredObjects] = {}
    """Classes of objects that are answers. Each has a method to_dict(), and its function makes an object from these fields."""

    def __init_subclass__(cls, **options: Any) -> None:
        """Register the objects of a new kind of answer, so that they can be read back from storage."""
        super().__init_subclass__(**options)
        for kind, read in cls.stored_objects.items():
            register_object(kind, read)

    @property
    @abstractmethod
    def expected(self) -> str:
        """What to type, in words: "an array of shape (3, 6)"."""

    @property
    def precision(self) -> str:
        """What to do about an answer that is the right one, rounded too much."""
        return FOUR_DIGITS

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

    @cached_property
    def _right(self) -> Any:
        """The right answer, as `agrees` compares it."""
        return self.read(self.value)

    def from_author(self, value: Any) -> Any:
        """Read a wrong answer of the author, or the value of a mutant; by default like one of a student."""
        return self.read(value)

    def shown(self, value: Any) -> str:
        """Return a value as an author reads it in a preview."""
        return str(value)

    @abstractmethod
    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        """Compare two values that were read: for each part, whether they are the same answer."""

    def with_inputs(self, seed: int) -> "Answer":
        """Return the same answer with other inputs, which depend on the seed. Only a function has inputs."""
        return self

    def counts(self, given: Any, right: Sequence[bool]) -> bool:
        """Return whether the right parts of a partly right answer earn their share: what comes out right by luck does not."""
        return True

    def slips(self) -> Iterable[Mistake]:
        """Return wrong answers that people give to any problem of this kind, as mistakes."""
        return ()

    def shows(self, given: Any, value: Any) -> list[bool]:
        """Return for each part whether an answer shows the value of a mistake, which may need more than that they agree."""
        return self.agrees(given, value)

    def appearance(self, given: Any, part: int | None) -> tuple[str, str] | None:
        """Return the name of what is seen in a wrong part, or with None in the whole answer, and a sentence on it.

        It is looked at before any mistake, so that a placeholder is never explained as a method.
        """
        return None

    def at_sight(self, given: Any) -> tuple[str, str] | None:
        """Return what is told of a whole wrong answer before any mistake: a placeholder, or of a single part also another unit."""
        if (seen := self.appearance(given, None)) or len(self.parts) > 1:
            return seen
        seen = self.appearance(given, 0)
        return seen if seen and seen[0] != "rounded" else None

    def arrangement(self, given: Any) -> tuple[str, str] | None:
        """Return how the whole answer is the right one in another order, with other signs or multiplied by a factor."""
        return None

    def explanation(self, given: Any, part: int) -> tuple[str, str] | None:
        """Return the name and the message of the mistake in a wrong part, if the answer itself shows it."""
        return None

    def description(self, given: Any, part: int) -> tuple[str, str] | None:
        """Return a name and a sentence for how a wrong part differs from the right one, if nothing else explains it."""
        return None

    def check(self, given: Any, part: int) -> str:
        """Return what every right answer fulfils and this part does not, with its own numbers; "" if there is no such thing.

        It goes with what is said of the difference from the right answer, so that nobody only copies a sign or a factor.
        """
        return ""

    def is_rounded(self, given: Any, part: int) -> bool:
        """Return whether a wrong part is the right one, rounded to fewer digits than are asked for."""
        return False

    @property
    def rows_are_alike(self) -> bool:
        """Whether one method gives all parts, as the rows of a table of screws: a wrong method earns nothing for one of them."""
        return False

    def remark(self, given: Any) -> str:
        """Return a sentence on how a right answer differs from ours; "" if there is nothing to say."""
        return ""

    def expressions(self, solution: Any) -> Iterator[Expression]:
        """Yield the solution, or if it is a function, the expression at each input."""
        yield solution

    def collect(self, values: Sequence[Any]) -> Any:
        """Return the answer that has these values at the inputs, as if it had been read. Raises Unreadable if there is none."""
        return self.from_author(values[0])

    def may_share(self, given: Any, value: Any, tolerance: float = TOLERANCE, parts: Quantifier = any) -> bool:
        """Return whether any part of an answer, or all of them, may be those of one that has a value at the first input."""
        return True

    def hint(self, given: Any, part: int) -> str:
        """Return what is right about a wrong part, for an error that no mistake explains; "" if there is nothing to say."""
        return ""
