"""Texts as answers: a word or a short phrase, which is compared, and prose, which a person marks."""

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from misstep import validation
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Answer, Unreadable

MAX_LENGTH = 300
"""The most characters of a word or a short phrase."""

MAX_PROSE = 10_000
"""The most characters of a text that a person marks."""

MIN_SPELLING = 5
"""From so many letters on, a word with one wrong letter is that word."""


def forgiving(text: str) -> str:
    """Return a text without what does not matter: case, accents, quotes, hyphens, signs at its end and further spaces.

    >>> forgiving(" Köln–Straße. "), forgiving("“NOT a  well-known word”"), forgiving("C++") == forgiving("C")
    ('koln strasse', 'not a well known word', False)
    """
    letters = unicodedata.normalize("NFKD", text.casefold())
    letters = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return " ".join(re.sub(r"[\s\-‐‑–_]+", " ", re.sub(r"[\"'`‘’“”„«»]", "", letters)).strip(" .,;:!?").split())


@dataclass(frozen=True, eq=False)
class Text(Answer):
    """A word or a short phrase.

    value   the right text
    also    other right texts, such as synonyms
    strict  whether each letter and sign counts, apart from spaces at both ends: for a formula or a line of code

    >>> answer = Text("Ohm's law", also=["law of Ohm"])
    >>> answer.agrees(answer.read(" OHMS LAW. "), answer.value), answer.agrees(answer.read("law of ohm"), answer.value)
    ([True], [True])
    """

    value: str
    also: Sequence[str] = ()
    strict: bool = False

    parts = ("the text",)

    @property
    def expected(self) -> str:
        return (
            "a text in quotes, in which each letter and sign counts"
            if self.strict
            else "a word or a short text in quotes"
        )

    def read(self, given: Any) -> str:
        if not isinstance(given, str) or len(given) > MAX_LENGTH:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return str(given)

    def agrees(self, one: str, other: str, tolerance: float = TOLERANCE) -> list[bool]:
        return [self._key(one) == self._key(other)]

    def explanation(self, given: str, part: int) -> tuple[str, str] | None:
        mine, right = self._key(given), [self._key(text) for text in (self.value, *self.also)]
        if self.strict:
            if forgiving(f"x{given.strip()}x") in (forgiving(f"x{text}x") for text in right):  # signs at the end count
                return (
                    "letter case or spaces",
                    "The words are right. Look at capital letters, spaces, accents and small digits.",
                )
            return None
        if mine and any(mine.replace(" ", "") == text.replace(" ", "") for text in right):
            return "spaces", "The letters are right. Look at the spaces between the words."
        if any(len(text) >= MIN_SPELLING and _is_one_letter_off(mine, text) for text in right):
            return "spelling", "This is right but for one letter: it is wrong, missing, or one too many."
        return None

    def _key(self, text: str) -> str:
        plain: Any = str.strip if self.strict else forgiving
        return str(plain(self.value if plain(text) in map(plain, self.also) else text))


@dataclass(frozen=True, eq=False)
class Prose(Answer):
    """A text that a person marks, by criteria: it has no points until then.

    value  the points of each criterion; together they are those of the problem

    >>> Prose({"names the law": 1, "explains its limits": 2}).expected
    'a text in quotes, marked for: names the law (1), explains its limits (2)'
    """

    value: Mapping[str, float]

    def __post_init__(self) -> None:
        if not self.value or not all(points > 0 for points in self.value.values()):
            raise ValueError(f"A rubric needs criteria, each with its points; got {dict(self.value)!r}.")
        object.__setattr__(self, "rubric", self.value)

    parts = ("the text",)

    @property
    def expected(self) -> str:
        return "a text in quotes, marked for: " + ", ".join(
            f"{name} ({points:g})" for name, points in self.value.items()
        )

    def read(self, given: Any) -> Any:
        if given is self.value:
            return given
        if not isinstance(given, str) or len(given) > MAX_PROSE:
            size = f" of {len(given)} characters" if isinstance(given, str) else ""
            raise Unreadable(f"Expected {self.expected}; got {type(given).__name__}{size}. At most {MAX_PROSE} fit.")
        return str(given)

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        return [one == other]


def _is_one_letter_off(one: str, other: str) -> bool:
    if abs(len(one) - len(other)) > 1 or one == other:
        return False
    start = next((i for i, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))
    return one[start + (len(one) >= len(other)) :] == other[start + (len(other) >= len(one)) :]
