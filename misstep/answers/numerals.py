"""Numerals: numbers that are typed as text, such as 1/3, 12 %, 3+4j and 5∠53.13°."""

import re
import unicodedata
from cmath import rect
from fractions import Fraction
from math import radians

MAX_LENGTH = 300
"""A text of more characters is no numeral."""

_UNSIGNED = r"(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?(?:/\d+\.?\d*)?"
_REAL = re.compile(rf"([+-]?{_UNSIGNED})(%?)")
_SIGNS = rf"(?:(?P<real>[+-]?{_UNSIGNED})(?P<sign>[+-])|(?P<alone>[+-]?))"
_CARTESIAN = re.compile(rf"{_SIGNS}(?:(?P<before>{_UNSIGNED})?\*?1?[ij]|[ij]\*?(?P<after>{_UNSIGNED}))")
_POLAR = re.compile(rf"(?P<size>{_UNSIGNED})(?:∠|angle)(?P<angle>[+-]?{_UNSIGNED})(?P<unit>°|degrees|deg|rad|)")
_EXPONENTIAL = re.compile(rf"(?P<size>{_UNSIGNED})?\*?(?:exp|e\^)\((?P<minus>-?)1?[ij]\*?(?P<angle>{_UNSIGNED})\)")


def numeral(text: str) -> Fraction | complex:
    """Return the number that a text writes: a real one as the exact fraction that it is.

    Raises ValueError for any other text; the message says what to type.

    >>> numeral(" 1/3 "), numeral("−0.5"), numeral("12 %"), numeral("5 040")
    (Fraction(1, 3), Fraction(-1, 2), Fraction(3, 25), Fraction(5040, 1))
    >>> numeral("3 + 4i"), numeral("3-j4"), abs(numeral("5∠53.13°") - (3 + 4j)) < 1e-4
    ((3+4j), (3-4j), True)
    """
    try:
        return _number(text, _plain(text))
    except OverflowError as error:
        raise ValueError(f"{text[:40]!r} is too large.") from error


def _number(text: str, plain: str) -> Fraction | complex:
    if found := _REAL.fullmatch(plain):
        return _fraction(found[1]) / (100 if found[2] else 1)
    if found := _CARTESIAN.fullmatch(plain):
        imaginary = _fraction(found["before"] or found["after"] or "1")
        sign = -1 if "-" in (found["sign"], found["alone"]) else 1
        return complex(_fraction(found["real"] or "0"), sign * imaginary)
    if found := _POLAR.fullmatch(plain):
        if not found["unit"]:
            raise ValueError(f"{text!r} has an angle without a unit. Write 5∠53.13° for degrees, or 5∠0.927 rad.")
        angle = float(_fraction(found["angle"]))
        return rect(float(_fraction(found["size"])), angle if found["unit"] == "rad" else radians(angle))
    if found := _EXPONENTIAL.fullmatch(plain):
        angle = float(_fraction(found["angle"]))
        return rect(float(_fraction(found["size"] or "1")), -angle if found["minus"] else angle)
    if re.fullmatch(r"[+-]?[\d.]*(,\d+)+\.?\d*%?", plain):
        raise ValueError(f"{text!r} has a comma. Write a point before the decimals, and nothing between thousands.")
    raise ValueError(f"{text[:40]!r} is no number. Write, for example, 12, 0.5, 2/3, 1.2e-3, 3+4j or 5∠53.13°.")


def _plain(text: str) -> str:
    if len(text) > MAX_LENGTH:
        raise ValueError(f"A text of {len(text)} characters is no number.")
    text = unicodedata.normalize("NFKC", text.replace("°", "°")).strip().casefold()
    text = text.replace("−", "-").replace("⁄", "/").replace("·", "*").replace("×10^", "e").replace("*10^", "e")
    text = re.sub(r"\s*([-+*/∠^()%°]|angle|deg|rad|[ij](?![a-z]))\s*", r"\1", text)
    text = re.sub(r"(?<=\d)[ _](?=\d{3}(?!\d))", "", text)
    return text[1:-1] if re.fullmatch(r"\([^()]*\)", text) else text


def _fraction(text: str) -> Fraction:
    above, _, below = text.partition("/")
    if below and not Fraction(below):
        raise ValueError(f"{text} divides by zero.")
    return Fraction(above) / Fraction(below or "1")
