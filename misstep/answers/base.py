"""Kinds of answers: how each is read from whatever a student typed, compared, and shown.

An answer has parts (the screws of an arm, the rotation and the position of a pose), so that a sheet can say which part
is right and a mistake in one part does not cost the others. Reading never trusts: what cannot be read is `Unreadable`,
which says what was expected and what came.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.validation import Array

TOLERANCE = 1e-3
"""How far a number may be off, relative to its size where that is above 1: three printed decimals are enough."""

LARGEST = 1e12
"""No answer of the course is larger; what is has lost its way, and its square would not fit into a number."""

NEAR = 3e-2
"""Within this an answer was rounded on the way rather than misunderstood, and feedback says so."""


class Unreadable(ValueError):
    """What came is no answer of the kind that was asked for."""


class Answer(ABC):
    """The right answer of a problem, and the way to read and compare others of its kind."""

    value: Any
    inputs: Sequence[Any] = ()
    """What a function is called with, where the answer is one."""

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
        """Read what a student typed. Raises Unreadable with what was expected and what came."""

    @abstractmethod
    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        """Compare two values that were read, part by part."""

    def at(self, seed: int) -> "Answer":
        """The same answer, asked for at inputs drawn anew. Only a function has inputs."""
        return self

    def hint(self, given: Any, part: int) -> str:
        """What is right about a wrong part, if anything is: a first foothold for a mistake that nobody foresaw."""
        return ""


@dataclass(frozen=True, eq=False)
class Numbers(Answer):
    """An array of real numbers of one shape, in one part unless a subclass cuts it.

    >>> Numbers(np.array([1.0, 2.0]), unit="m").read([1, 2])
    array([1., 2.])
    """

    value: Array
    unit: str = ""
    noun: ClassVar[str] = "an array"

    @property
    def expected(self) -> str:
        shape = np.shape(self.value)
        what = f"{self.noun} of shape {shape}" if shape else "one number"
        return f"{what} in {self.unit}" if self.unit else what

    @property
    def parts(self) -> Sequence[str]:
        return ["the answer"]

    def read(self, given: Any) -> Array:
        wanted = np.shape(self.value)
        try:
            shape = np.shape(given)
        except Exception as error:  # a student's object may raise anything when it is asked for its shape
            raise Unreadable(f"Expected {self.expected}; got {_kind(given)} whose rows differ in length.") from error
        if shape != wanted:
            came = f"{_kind(given)} of shape {shape}" if shape else validation.brief(given)
            raise Unreadable(f"Expected {self.expected}; got {came}.{_remedy(shape, wanted)}")
        try:
            values = validation.array(given, "your answer")
        except ValueError as error:
            raise Unreadable(f"Expected {self.expected}. {_sentence(str(error))}") from error
        except Exception as error:
            raise Unreadable(
                f"Expected {self.expected}; got {_kind(given)} that does not turn into numbers."
            ) from error
        if (largest := np.abs(values).max(initial=0.0)) > LARGEST:
            raise Unreadable(f"Expected {self.expected}; got {largest:.3g}. Was there a division by almost zero?")
        return values

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        allowed = tolerance * np.maximum(1.0, np.maximum(np.abs(one), np.abs(other)))
        same = np.abs(one - other) <= allowed
        return [bool(np.all(same[piece])) for piece in self._pieces()]

    def _pieces(self) -> list[Any]:
        """An index for each part."""
        return [...]


@dataclass(frozen=True, eq=False)
class Screws(Numbers):
    """Screw axes in rows, (n, 6), or a single one, (6,); each is a part.

    >>> Screws(np.eye(2, 6)).parts
    ['screw 1', 'screw 2']
    """

    names: Sequence[str] = ()
    noun: ClassVar[str] = "screw axes (omega, v), an array"

    @property
    def expected(self) -> str:
        several = super().expected
        return several if np.ndim(self.value) > 1 else several.replace("screw axes", "a screw axis")

    @property
    def parts(self) -> Sequence[str]:
        rows = 1 if self.value.ndim == 1 else len(self.value)
        return self.names or [f"screw {i + 1}" for i in range(rows)]

    def hint(self, given: Array, part: int) -> str:
        theirs, right = np.atleast_2d(given)[part], np.atleast_2d(self.value)[part]
        omega, v = (bool(np.allclose(theirs[half], right[half], atol=TOLERANCE)) for half in (slice(3), slice(3, 6)))
        if omega:
            return "Its omega is right, its v is not."
        return "Its v is right, its omega is not." if v else ""

    def _pieces(self) -> list[Any]:
        return [...] if self.value.ndim == 1 else list(range(len(self.value)))


@dataclass(frozen=True, eq=False)
class Pose(Numbers):
    """One pose, (4, 4); its rotation and its position are the parts, each with its share of the last row.

    >>> Pose(np.eye(4)).agrees(np.eye(4), np.diag([1, -1, -1, 1.0]))
    [False, True]
    """

    noun: ClassVar[str] = "a pose, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["rotation", "position"]

    def hint(self, given: Array, part: int) -> str:
        R = given[:3, :3]
        # Entries typed with three decimals make R^T R stray by a few thousandths; a real fault makes it stray by more.
        rigid = np.allclose(R.T @ R, np.eye(3), atol=NEAR) and np.linalg.det(R) > 0
        if part == 0 and not rigid:
            return "It is no rotation at all: its columns should be unit, square and right-handed."
        closed = np.allclose(given[3], (0, 0, 0, 1), atol=TOLERANCE)
        return "" if closed else "The last row of a pose is 0 0 0 1, whatever stands above it."

    def _pieces(self) -> list[Any]:
        return [np.s_[:, :3], np.s_[:, 3]]


@dataclass(frozen=True, eq=False)
class Ordering(Answer):
    """Names to be put in order, each used once.

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
        odd = [name for name in given if not isinstance(name, str) or name not in self.value]
        if odd:
            raise Unreadable(
                f"Expected {self.expected}; {validation.brief(odd[0])} is none of them. Did you leave out the quotes?"
            )
        missing = [name for name in self.value if given.count(name) != 1]
        if missing:
            raise Unreadable(f"Expected {self.expected}; {missing[0]} appears {given.count(missing[0])} times.")
        return list(given)

    def agrees(self, one: Sequence[str], other: Sequence[str], tolerance: float = TOLERANCE) -> list[bool]:
        return [list(one) == list(other)]


@dataclass(frozen=True, eq=False)
class Choice(Answer):
    """One of several named options; each wrong one is a mistake of the problem.

    >>> Choice("b", {"a": "to the left", "b": "to the right"}).read(" B ")
    'b'
    """

    value: str
    options: Mapping[str, str]

    @property
    def expected(self) -> str:
        return f"one of {', '.join(map(repr, self.options))}"

    @property
    def parts(self) -> Sequence[str]:
        return ["the choice"]

    def read(self, given: Any) -> str:
        letter = given.strip().lower() if isinstance(given, str) and len(given) < 100 else given
        if not isinstance(letter, str) or letter not in self.options:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return letter

    def agrees(self, one: str, other: str, tolerance: float = TOLERANCE) -> list[bool]:
        return [one == other]


def is_blank(given: Any) -> bool:
    """Whether nothing has been typed yet: the ... of a fresh sheet, or None."""
    return given is None or given is ...


def _kind(given: Any) -> str:
    name = type(given).__name__
    return f"{'an' if name == 'ndarray' or name[:1] in 'aeiouAEIOU' else 'a'} {name}"


def _remedy(shape: tuple[int, ...], wanted: tuple[int, ...]) -> str:
    if len(shape) == 2 and shape[::-1] == wanted:
        return " Rows and columns are swapped: try .T."
    if shape == (3,) and wanted == (6,):
        return " A screw axis is (omega, v), six numbers: is the other half missing?"
    if np.prod(shape) == np.prod(wanted):
        return f" The count of numbers is right, the arrangement is not: try np.reshape(..., {wanted})."
    return ""


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:]
