"""Texts as answers: they are kept for an instructor, who marks them by a rubric. No machine judges them."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from misstep import validation
from misstep.answers.base import TOLERANCE, Answer, Unreadable

MIN_WORDS = 5
"""A text of fewer words is no answer to an open question."""


@dataclass(frozen=True, eq=False)
class Prose(Answer):
    """A text in a student's own words.

    value   a model answer
    rubric  what earns points, each with how many

    >>> Prose("It is the same rotation.", {"says why": 2}).read(" Both are a half turn. ")
    'Both are a half turn.'
    """

    value: str
    rubric: Mapping[str, int]

    parts = ("the text",)
    expected = "a text of a few sentences, in quotation marks"

    def read(self, given: Any) -> str:
        if not isinstance(given, str) or len(given.split()) < MIN_WORDS:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.")
        return given.strip()

    def agrees(self, one: str, other: str, tolerance: float = TOLERANCE) -> list[bool]:
        return [one == other]
