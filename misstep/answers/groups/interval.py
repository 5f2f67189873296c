"""Intervals as answers: with open and closed ends, without bounds, and several of them together."""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import inf
from typing import Any

from misstep import validation
from misstep.answers.accuracy import TOLERANCE, Accuracy, exact
from misstep.answers.base import Answer, Unreadable
from misstep.formulas.numerals import numeral, on_one_line

MAX_LENGTH = 300
"""The most characters of an interval."""

_INFINITY = {"oo": inf, "inf": inf, "infty": inf, "infinity": inf, "∞": inf}
_BRACKETS = re.compile(r"([\[(\]])([^\[\](){}]+?)[,;]([^\[\](){}]+?)([\])\[])")
_CONDITION = re.compile(r"(?:(?P<before>[^<>=]+)(?P<one><=?|>=?))?[a-z](?:(?P<two><=?|>=?)(?P<after>[^<>=]+))?")
_EQUAL = re.compile(r"[a-z]=([^<>=]+)")
_IN = re.compile(r"[a-z]in(?=[\[\](){}])")
_POINTS = re.compile(r"\{([^{}]*)\}")
_SIGNS = {
    "≤": "<=",
    "≥": ">=",
    "⩽": "<=",
    "⩾": ">=",
    "\\leq": "<=",
    "\\geq": ">=",
    "\\le": "<=",
    "\\ge": ">=",
    "−": "-",
    "∪": " u ",
    "∨": " u ",
    " or ": " u ",
    "union": " u ",
    "\\cup": " u ",
    "cup": " u ",
    "∧": " and ",
    "∈": " in ",
    "\\infty": "oo",
    "\\in": " in ",
}
"""Signs, words and commands of LaTeX, with what is read in their place."""


@dataclass(frozen=True)
class Piece:
    """One interval: its bounds, and whether they belong to it."""

    low: Fraction | float
    has_low: bool
    high: Fraction | float
    has_high: bool


Pieces = tuple[Piece, ...]


@dataclass(frozen=True, eq=False)
class Interval(Answer):
    """An interval, or the union of some, given as text.

    value     for example "[0, 1)", "(-oo, 1/2] u {3}", "0 <= x < 1"
    accuracy  how far a bound may be off

    >>> answer = Interval("[0, 1)")
    >>> [answer.agrees(answer.read(text), answer.value) for text in ("[0; 1[", "0 <= x < 1", "(0, 1]")]
    [[True], [True], [False]]
    """

    value: str
    accuracy: Accuracy = exact

    def __post_init__(self) -> None:
        pieces(self.value)  # a mistake of the author is one of now, not of the first answer

    parts = ("the interval",)
    expected = "an interval as text, such as '[2, 5)' or '(-oo, 1/2] u (3, oo)'"

    def read(self, given: Any) -> Pieces:
        if isinstance(given, tuple) and all(isinstance(one, Piece) for one in given):
            return given
        if not isinstance(given, str):
            shown = validation.brief(given)
            raise Unreadable(f"Expected {self.expected}; got {shown}. Write it in quotes: its brackets matter.")
        try:
            return pieces(given)
        except ValueError as error:
            raise Unreadable(f"Expected {self.expected}. {error}") from error

    def shown(self, value: Any) -> str:
        found = [
            f"{{{piece.low}}}"
            if piece.low == piece.high
            else f"{'(['[piece.has_low]}{piece.low}, {piece.high}{')]'[piece.has_high]}"
            for piece in self.read(value)
        ]
        return " u ".join(found).replace("inf", "oo") or "{}"

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        one, other = self.read(one), self.read(other)
        ends = [(piece.has_low, piece.has_high) for piece in one] == [
            (piece.has_low, piece.has_high) for piece in other
        ]
        return [ends and self._has_bounds_of(one, other, tolerance)]

    def explanation(self, given: Pieces, part: int) -> tuple[str, str] | None:
        if given and self._has_bounds_of(given, self._right, TOLERANCE):
            return "ends of an interval", "The bounds are right. Look at which of them belong to it: [ or (, ] or )."
        if all(self.agrees(given, _complement(self._right))):
            return "complement", "You gave the complement: all numbers that do not belong to the right answer."
        return None

    def _has_bounds_of(self, one: Pieces, other: Pieces, tolerance: float) -> bool:
        bounds = [[bound for piece in some for bound in (piece.low, piece.high)] for some in (one, other)]
        return len(one) == len(other) and all(
            mine == right or abs(mine - right) <= tolerance / TOLERANCE * self.accuracy.bound(right)
            for mine, right in zip(*bounds, strict=True)
        )


def pieces(text: str) -> Pieces:
    """Read intervals from a text, as pieces in order that do not touch.

    Raises ValueError for any other text.

    >>> pieces("[0, 1) u [1, 2)") == pieces("0 <= x < 2")
    True
    """
    if len(text) > MAX_LENGTH:
        raise ValueError(f"A text of {len(text)} characters is no interval.")
    text = unicodedata.normalize("NFKC", on_one_line(text)).casefold()
    for sign, plain in _SIGNS.items():
        text = text.replace(sign, plain)
    found: list[Piece] = []
    for part in re.split(r"(?<=[^a-z]) *u *(?=[^a-z]|[a-z] *(?:[<>=]|in))", text):
        # What fulfils all conditions is the complement of what fails one of them.
        outside = [piece for one in part.split(" and ") for piece in _complement(_united(_piece(one)))]
        found += _complement(_united(outside)) if " and " in part else _piece(part)
    return _united(found)


def _piece(text: str) -> list[Piece]:
    typed, text = " ".join(text.split())[:40], _IN.sub("", "".join(text.split()))
    if text in ("∅", "{}", "empty"):
        return []
    if text in ("r", "ℝ"):
        return [Piece(-inf, False, inf, False)]
    if match := _BRACKETS.fullmatch(text):
        piece = Piece(_bound(match[2]), match[1] == "[", _bound(match[3]), match[4] == "]")
    elif (match := _CONDITION.fullmatch(text)) and (sides := _sides(match)):
        piece = Piece(*sides.get("low", (-inf, False)), *sides.get("high", (inf, False)))
    elif match := _EQUAL.fullmatch(text) or _POINTS.fullmatch(text):
        return [Piece(bound, True, bound, True) for bound in map(_bound, re.split("[,;]", match[1]))]
    else:
        raise ValueError(f"{typed!r} is no interval.")
    if piece.low > piece.high:
        raise ValueError(f"The lower bound comes first; {typed!r} has the larger number there.")
    if (piece.has_low and piece.low == -inf) or (piece.has_high and piece.high == inf):
        raise ValueError("Infinity does not belong to an interval: write ( or ) there.")
    return [piece] if piece.low < piece.high or (piece.has_low and piece.has_high) else []


def _sides(condition: re.Match[str]) -> dict[str, tuple[Fraction | float, bool]]:
    """Return the bounds of a condition such as 0 <= x < 1, each with whether it belongs; none if the signs contradict each other."""
    before, one, two, after = condition.group("before", "one", "two", "after")
    if one and two and one[0] != two[0]:
        return {}
    bounds = [(before, one, "<"), (after, two, ">")]
    return {"low" if sign[0] == below else "high": (_bound(text), "=" in sign) for text, sign, below in bounds if sign}


def _bound(text: str) -> Fraction | float:
    sign, size = (-1, text[1:]) if text.startswith("-") else (1, text.removeprefix("+"))
    if size in _INFINITY:
        return sign * _INFINITY[size]
    value = numeral(text)
    if not isinstance(value, Fraction):
        raise ValueError(f"A bound must be a real number; got {text[:40]!r}.")
    return value


def _united(found: Sequence[Piece]) -> Pieces:
    united: list[Piece] = []
    for piece in sorted(found, key=lambda one: (one.low, not one.has_low)):
        last = united[-1] if united else None
        if last and (piece.low < last.high or (piece.low == last.high and (piece.has_low or last.has_high))):
            high, has_high = max((last.high, last.has_high), (piece.high, piece.has_high))
            united[-1] = Piece(last.low, last.has_low, high, has_high)
        else:
            united.append(piece)
    return tuple(united)


def _complement(some: Pieces) -> Pieces:
    outer = [Piece(-inf, False, -inf, False), *some, Piece(inf, False, inf, False)]
    gaps = [
        Piece(one.high, not one.has_high and one.high != -inf, other.low, not other.has_low and other.low != inf)
        for one, other in pairwise(outer)
    ]
    return tuple(gap for gap in gaps if gap.low < gap.high or (gap.has_low and gap.has_high and abs(gap.low) != inf))
