"""Numerals: numbers that are typed as text, such as 1/3, 12 %, 3+4j, 5∠53.13° and 2^10."""

import cmath
import operator
import re
import unicodedata
from cmath import rect
from collections.abc import Sequence
from fractions import Fraction
from math import factorial, radians

from misstep.formulas.parsing import parse
from misstep.formulas.walker import MAX_EXPONENT, Operation, Walker

MAX_LENGTH = 300
"""A text of more characters is no numeral."""

MAX_BITS = 4000
"""The most binary digits of a power, so that a tower of powers is refused at once."""

_UNSIGNED = r"(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?(?:/\d+\.?\d*)?"
_REAL = re.compile(rf"([+-]?{_UNSIGNED})(%?)")
_SIGNS = rf"(?:(?P<real>[+-]?{_UNSIGNED})(?P<sign>[+-])|(?P<alone>[+-]?))"
_CARTESIAN = re.compile(rf"{_SIGNS}(?:(?P<before>{_UNSIGNED})?\*?1?[ij]|[ij]\*?(?P<after>{_UNSIGNED}))")
_POLAR = re.compile(rf"(?P<size>{_UNSIGNED})(?:∠|angle|<|cis)(?P<angle>[+-]?{_UNSIGNED})(?P<unit>°|degrees|deg|rad|)")
_EXPONENTIAL = re.compile(rf"(?P<size>{_UNSIGNED})?\*?(?:exp|e\^)\((?P<minus>-?)1?[ij]\*?(?P<angle>{_UNSIGNED})\)")


def numeral(text: str, *, may_compute: bool = True) -> Fraction | complex:
    """Return the number that a text writes: a real one as the exact fraction that it is.

    may_compute  whether it may be computed from others, as in 2^10, sqrt(2) or 3pi/2; before a unit, e is no number

    Raises ValueError for any other text; the message says what to type.

    >>> numeral(" 1/3 "), numeral("−0.5"), numeral("12 %"), numeral("5 040")
    (Fraction(1, 3), Fraction(-1, 2), Fraction(3, 25), Fraction(5040, 1))
    >>> numeral("3 + 4i"), numeral("3-j4"), abs(numeral("5∠53.13°") - (3 + 4j)) < 1e-4
    ((3+4j), (3-4j), True)
    >>> numeral("10³"), numeral("1.2 · 10⁻³"), numeral("1/2 + 1/3"), numeral("8!/5!"), round(float(numeral("3pi/2").real), 4)
    (Fraction(1000, 1), Fraction(3, 2500), Fraction(5, 6), Fraction(336, 1), 4.7124)
    """
    try:
        plain = _plain(text)
        try:
            return _number(text, plain)
        except ValueError:
            if may_compute and (value := _computed(plain)) is not None:
                return value
            raise
    except OverflowError as error:
        raise ValueError(f"{text[:40]!r} is too large.") from error


def on_one_line(text: str) -> str:
    """Return a text with powers as ^3 and fractions as 1/2, because the usual normalization reads 10³ as 103 and 1½ as 11/2.

    >>> on_one_line("10³"), on_one_line("1½")
    ('10^3', '(1+1⁄2)')
    """
    text = re.sub(r"[⁺⁻]?[⁰¹²³⁴-⁹]+", lambda power: "^" + unicodedata.normalize("NFKC", power[0]), text)
    mixed = r"(\d+)([½⅓¼⅕⅙⅐⅛⅑⅒⅔⅖¾⅗⅜⅘⅚⅝⅞])"
    return re.sub(mixed, lambda both: f"({both[1]}+{unicodedata.normalize('NFKC', both[2])})", text)


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
    text = on_one_line(text)
    text = unicodedata.normalize("NFKC", text.replace("°", "°")).strip().casefold()
    text = (
        text.replace("−", "-").replace("⁄", "/").replace("÷", "/").replace("·", "*").replace("⋅", "*").replace("×", "*")
    )
    text = re.sub(r"\s*([-+*/∠<^()%°]|angle|cis|deg|rad|[ij](?![a-z]))\s*", r"\1", text)
    text = re.sub(r"(?<=\d)(?:\*| x )10\^\(?([+-]?\d+)\)?", r"e\1", text)
    text = re.sub(r"(?<=\d)[ _'’](?=\d{3}(?!\d))", "", text)
    return text[1:-1] if re.fullmatch(r"\([^()]*\)", text) else text


def _fraction(text: str) -> Fraction:
    above, _, below = text.partition("/")
    if below and not Fraction(below):
        raise ValueError(f"{text} divides by zero.")
    return Fraction(above) / Fraction(below or "1")


def _computed(plain: str) -> Fraction | complex | None:
    """Return the value of a text that computes a number from others; None if it does not."""
    if re.search(r"\de(?![\^*(x])|,", plain):  # 5e is a number that was not finished, and not 13.6
        return None
    if "°" in plain and not re.search(r"(sin|cos|tan|exp|e\^)[({]", plain):  # 30° alone is an angle, and not 0.52
        return None
    plain = re.sub(r"(?<![a-z])([ij])(?=[\d.])", r"\1*", plain)
    plain = re.sub(r"(?<![\w.])(\d{1,3})\s*!(?!!)", lambda number: str(factorial(int(number[1]))), plain)
    try:
        value = Walker(_Arithmetic(), 60).value(parse(plain, MAX_LENGTH + 100))
    except (ValueError, ArithmeticError, RecursionError):
        return None
    if isinstance(value, complex) and not value.imag:
        return Fraction(value.real) if cmath.isfinite(value) else None
    return value


class _Arithmetic:
    """The algebra of numbers: fractions as long as they are exact, then complex numbers."""

    functions = ("sin", "cos", "tan", "sqrt", "exp", "log", "ln", "abs")

    def number(self, number: int | float) -> Fraction | complex:
        return Fraction(str(number))

    def symbol(self, name: str) -> Fraction | complex:
        known = {"pi": cmath.pi, "e": cmath.e, "i": 1j, "j": 1j}
        if name not in known:
            raise ValueError(f"{name} is no number.")
        return complex(known[name])

    def apply(self, operation: Operation, *values: Fraction | complex) -> Fraction | complex:
        if operation is operator.pow:
            return self._power(*values)
        result: Fraction | complex = operation(*values)
        return result

    def _power(self, base: Fraction | complex, exponent: Fraction | complex) -> Fraction | complex:
        if not isinstance(base, Fraction) or not isinstance(exponent, Fraction) or exponent.denominator != 1:
            if abs(complex(exponent)) > MAX_EXPONENT:
                raise ValueError(f"Exponents go up to {MAX_EXPONENT} here.")
            return complex(complex(base) ** complex(exponent))
        size = max(abs(base.numerator), base.denominator).bit_length()
        if size * abs(exponent) > MAX_BITS:
            raise ValueError(f"A power has at most {MAX_BITS} binary digits here.")
        return base ** int(exponent)

    def call(self, function: str, arguments: Sequence[Fraction | complex]) -> Fraction | complex:
        if function == "abs":
            return abs(arguments[0]) if isinstance(arguments[0], Fraction) else complex(abs(arguments[0]))
        return complex(getattr(cmath, "log" if function == "ln" else function)(complex(arguments[0])))
