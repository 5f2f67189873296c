"""Quantities as answers: a number with a unit, in any unit that fits. The units are those of Pint, `pip install misstep[units]`."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from math import log10
from typing import Any

import numpy as np

from misstep import validation
from misstep.answers.accuracy import TOLERANCE, Accuracy
from misstep.answers.base import Answer, Unreadable
from misstep.answers.number import Numbers
from misstep.formulas.numerals import numeral
from misstep.mistakes import Mistake

MAX_LENGTH = 100
"""The most characters of a quantity."""


_UNIT = re.compile(r"(1\s*/)?([^\W\d]|[°%'\"]|(\*\*|\^)\s*-?\d(?!\d|\s*(\*\*|\^))|[⁻⁰¹²³⁴-⁹]|[\s*/·()])+")
"""A unit with powers of one digit. Pint computes what it reads, and a tower of powers would take for ever."""


@cache
def _registry() -> Any:
    try:
        import pint
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError("Units need Pint: pip install 'misstep[units]'") from missing
    return pint.UnitRegistry(cache_folder=None)


@dataclass(frozen=True)
class Measured:
    """A quantity that was read.

    number     as it was typed
    unit       as it was typed; "" if there was none
    converted  the number in the unit of the right answer; None if there is no unit, or one of another quantity
    """

    number: Any
    unit: str
    converted: Any


@dataclass(frozen=True, eq=False)
class Quantity(Answer):
    """A number with a unit, real or complex.

    value     the right number, in the unit
    unit      the unit of the author; a student may take any other one of the same quantity
    accuracy  how far the number may be off, in the unit of the author, as in Numbers

    >>> answer = Quantity(1200.0, "ohm")
    >>> [answer.agrees(answer.read(given), answer.value) for given in ("1200 ohm", "1.2 kΩ", "1.2 ohm", "1200 V", 1200)]
    [[True], [True], [False], [False], [False]]
    """

    value: Any
    unit: str
    accuracy: Accuracy | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        try:
            _registry().Unit(self.unit)
        except ModuleNotFoundError:
            raise
        except Exception as error:
            raise ValueError(f"Pint does not know the unit {self.unit!r}: {error}") from error

    @cached_property
    def _numbers(self) -> Numbers:
        return Numbers(self.value, accuracy=self.accuracy)

    parts = ("the quantity",)

    @property
    def expected(self) -> str:
        number = self._numbers.expected.removeprefix("one ")
        return f"a {number}, with its unit, as text such as '12.5 m/s'"

    @property
    def precision(self) -> str:
        return self._numbers.precision

    def read(self, given: Any) -> Measured:
        if isinstance(given, Measured):
            return given
        if hasattr(given, "magnitude") and hasattr(given, "units"):
            return self._measured(self._number(given.magnitude), str(given.units))
        if not isinstance(given, str):
            return Measured(self._number(given), "", None)
        number, unit = self._split(given)
        return self._measured(self._number(number), unit)

    def from_author(self, value: Any) -> Measured:
        """Read a value of the author or of a mutant, whose number is in the unit of the answer."""
        if isinstance(value, Measured | str):
            return self.read(value)
        number = self._number(value)
        return Measured(number, self.unit, number)

    def shown(self, value: Any) -> str:
        measured = self.from_author(value)
        return f"{_shown(measured.number)} {measured.unit}".strip()

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        mine, right = self.from_author(one).converted, self.from_author(other).converted
        return [mine is not None and right is not None and all(self._numbers.agrees(mine, right, tolerance))]

    def remark(self, given: Measured) -> str:
        same = _unit(given.unit) == _registry().Unit(self.unit)
        return "" if same else f"In the unit of our solution, this is {_shown(given.converted)} {self.unit}."

    def is_rounded(self, given: Measured, part: int) -> bool:
        return given.converted is not None and self._numbers.is_rounded(given.converted, 0)

    def explanation(self, given: Measured, part: int) -> tuple[str, str] | None:
        is_number = all(self._numbers.agrees(given.number, self._numbers.read(self.value)))
        if not given.unit:
            return "unit missing", f"{'The number is right, but its' if is_number else 'The'} unit is missing."
        if given.converted is None:
            also = " The number is right." if is_number else ""
            if given.unit in ("C", "F") and _registry().Unit(self.unit).is_compatible_with("kelvin"):
                also += f" For degrees, type °{given.unit}."
            return "wrong unit", f"{given.unit} is no unit of the quantity that is asked for.{also}"
        if is_number:
            return "another unit", f"The number is right in another unit than {given.unit}."
        ratio = abs(complex(given.converted) / complex(self.value)) if complex(self.value) else 0.0
        power = round(log10(ratio)) if ratio else 0
        if power and all(
            self._numbers.agrees(self._number(given.converted / 10.0**power), self._numbers.read(self.value))
        ):
            text = f"Your answer is wrong by the factor 10^{power}. Look at the prefix of the unit and at the powers of ten."
            return "power of ten", text
        return None

    def slips(self) -> Iterator[Mistake]:
        """Yield the slips of the number, in the unit of the author; `explanation` says more of a power of ten."""
        slips = (slip for slip in self._numbers.slips() if slip.name != "power of ten")
        return (replace(slip, value=self.from_author(slip.value)) for slip in slips)

    def _number(self, given: Any) -> Any:
        try:
            return self._numbers.read(given)
        except Unreadable as error:
            raise Unreadable(f"Expected {self.expected}; got {validation.brief(given)}.") from error

    def _split(self, text: str) -> tuple[Any, str]:
        """Split a text into its number, the longest there is, and its unit."""
        for end in range(min(len(text), MAX_LENGTH), 0, -1):
            try:
                number = numeral(text[:end], may_compute=False)  # 2 eV is no multiple of e
            except ValueError:
                continue
            if text[end:].startswith(",") or text[:end].endswith(","):
                break
            if not isinstance(number, complex) or np.iscomplexobj(self.value):  # 3 J is an energy
                return number, text[end:].strip()
        comma = re.match(r"\s*[-+−]?\d+,\d", text)
        advice = (
            "Write a point before the decimals, and nothing between thousands" if comma else "The number comes first"
        )
        raise Unreadable(f"Expected {self.expected}; got {validation.brief(text)}. {advice}.")

    def _measured(self, number: Any, unit: str) -> Measured:
        unit = unit.removesuffix(".")
        if not unit:
            return Measured(number, "", None)
        try:
            if len(unit) > MAX_LENGTH or not _UNIT.fullmatch(unit):
                raise ValueError("this is no unit")
            known = _unit(unit)
        except Exception as error:  # Pint raises errors of many kinds for what is no unit
            raise Unreadable(f"Expected {self.expected}; {unit[:40]!r} is no unit that we know.") from error
        if not known.is_compatible_with(self.unit):
            return Measured(number, unit, None)
        plain = complex(number) if np.iscomplexobj(number) else float(number)
        return Measured(number, unit, self._number(_registry().Quantity(plain, known).to(self.unit).magnitude))


def _unit(text: str) -> Any:
    """The unit that a text writes; where there is none, the one in other letters that it means: Ohm, MOhm, KΩ."""
    small = text[:1] if text[:1] in "MPZY" else text[:1].lower()  # a capital one is another prefix there
    for spelling in (text, small + text[1:], small + text[1:].lower()):
        try:
            return _registry().Unit(spelling)
        except Exception as error:  # Pint raises errors of many kinds for what is no unit
            unknown = error
    raise unknown


def _shown(number: Any) -> str:
    return f"{complex(number):.6g}" if np.iscomplexobj(number) else f"{float(number):.6g}"
