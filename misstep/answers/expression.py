"""Formulas as answers: a formula is right if it has the same values as the right one, however it is written."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from misstep.answers.accuracy import TOLERANCE
from misstep.answers.base import Quantifier, Unreadable
from misstep.answers.entries import Entries, Slip, entries_hint, place_of, scale_of, wrong_slips
from misstep.answers.likeness import Likeness, Named
from misstep.display.sentences import NEGATED_FORMULAS
from misstep.display.text import number
from misstep.formulas.evaluation import Formula, Reader, shaped
from misstep.mistakes import Mistake
from misstep.mutants.expression import Expression
from misstep.validation import Array

EXACT_TOLERANCE = 1e-12
"""The tolerance for formulas without decimals, relative to their values or their scale: only the values were rounded."""


@dataclass(frozen=True, eq=False)
class ClosedForm(Entries):
    """A formula, or a vector or matrix of formulas, given as SymPy or as text.

    value    the right formula; its symbols may be used
    symbols  further symbols that may be used

    Formulas are compared to twelve digits; if one of them contains decimals, to the three that a person types. The formula is
    one part, unless a subclass overrides `parts` and `part_indices`.

    >>> q = sp.Symbol("q")
    >>> right = ClosedForm(sp.sin(2 * q))
    >>> right.agrees(right.read("2 sin(q) cos(q)"), right.value), right.agrees(right.read("2 sin(q)"), right.value)
    ([True], [False])
    """

    value: Any
    symbols: Sequence[sp.Symbol] = ()

    @property
    def expected(self) -> str:
        names = [symbol.name for symbol in self._declared]
        entry = f"2*sin({names[-1]})" if names else "1/2"
        example = (entry, f"[{entry}, 0, ...]", f"[[{entry}, 0, ...], ...]")[len(self._shape)]
        return f"{shaped(self._shape)} in {', '.join(names) or 'numbers'}: text such as '{example}', or SymPy"

    @property
    def parts(self) -> Sequence[str]:
        return ["the formula"]

    def read(self, given: Any) -> Formula:
        if isinstance(given, Formula) and given.values.shape == self._right.values.shape:
            return given
        if isinstance(given, str):
            given = re.sub(r"^[^=(\[]*(\([^=()]*\))?\s*=\s*(?!=)", "", given)  # y = or f(x) = before the formula
        try:
            return self._reader.read(given, self._shape)
        except ValueError as error:
            raise Unreadable(f"Expected {self.expected}. {error}") from error
        except Exception as error:  # reading a student's object may raise any error
            raise Unreadable(f"Expected {self.expected}; got {type(given).__name__}.") from error

    def appearance(self, given: Formula, part: int | None) -> Named | None:
        return self.likeness(given, part).placeholder()

    def arrangement(self, given: Formula) -> Named | None:
        return self.likeness(given, None).order() if self.rows_are_alike else None

    def explanation(self, given: Formula, part: int) -> Named | None:
        return self.likeness(given, part).resemblance()

    def description(self, given: Formula, part: int) -> Named | None:
        same = self.same_entries(given, self.value)[self.core_indices()[part]]
        if np.size(same) > 1 and np.count_nonzero(~same) == 1:
            return "one entry", self.hint(given, part)
        if same.ndim == 2 and same.shape[0] == same.shape[1] and (same | np.eye(len(same), dtype=bool)).all():
            return "the diagonal", "Only entries of the diagonal are wrong."
        names = [sp.latex(symbol) for symbol in self._declared]
        wanted = dict(zip(self._reader.points[0], names, strict=True))
        for name, symbols, which in (
            ("letters missing", self._right.symbols - given.symbols, "contain {}, and yours do not"),
            ("letters too many", given.symbols - self._right.symbols, "do not contain {}, and yours do"),
        ):
            if symbols and given.given is not None:
                *others, last = [f"${wanted[symbol]}$" for symbol in sorted(symbols)]
                listed = f"{', '.join(others)} and {last}" if others else last
                trial = "" if same.ndim else f" {self.hint(given, part)}"
                return name, f"The right formulas {which.format(listed)}.{trial}"
        return None

    def likeness(self, given: Formula, part: int | None) -> Likeness:
        """Return a part of an answer, or with None the whole, beside the right one, by their values."""
        piece = ... if part is None else self.core_indices()[part]
        places = np.moveaxis(np.indices(self._shape), 0, -1)[piece]
        tolerance = TOLERANCE if given.rounded or self._right.rounded else EXACT_TOLERANCE * 10
        return Likeness(
            given.values[piece],
            self._right.values[piece],
            place=lambda index: place_of(places[tuple(index)]),
            tolerance=tolerance,
            is_formula=True,
        )

    def hint(self, given: Formula, part: int) -> str:
        same = self.same_entries(given, self.value)[self.part_indices()[part]]
        if same.ndim:
            return entries_hint(same)
        far = np.abs(given.values - self._right.values) / (np.abs(given.values) + np.abs(self._right.values) + 1e-300)
        k = int(np.argmax(far))  # at some points two formulas look the same when they are rounded
        point = ", ".join(f"{name} = {number(value)}" for name, value in self._reader.points[k].items())
        yours, right = given.values[k], self._right.values[k]
        return f"Try numbers: at {point} your formula gives {number(yours)}, and {number(right)} is right."

    def expressions(self, solution: Callable[..., Expression]) -> Iterator[Expression]:
        return (solution(**point) for point in self._reader.points)

    def collect(self, values: Sequence[Any]) -> Formula:
        shape = self._right.values.shape[:-1]
        try:
            return Formula(
                None, np.stack([np.reshape(np.asarray(value, dtype=float), shape) for value in values], axis=-1), False
            )
        except (TypeError, ValueError) as error:
            raise Unreadable(f"Expected {self.expected}.") from error

    def may_share(self, given: Any, value: Any, tolerance: float = TOLERANCE, parts: Quantifier = any) -> bool:
        own = (self._right if given is self.value else given).values[..., 0]
        try:
            value = np.reshape(np.asarray(value, dtype=float), own.shape)
        except (TypeError, ValueError):
            return False
        size = np.maximum(self._scales[..., 0], np.maximum(np.abs(own), np.abs(value)))
        near = np.abs(own - value) <= tolerance * size
        return parts(near[piece].all() for piece in self.part_indices())

    def same_entries(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        """Return, for each entry, whether the values agree at all points."""
        first, second = (self._right if formula is self.value else self.read(formula) for formula in (one, other))
        a, b = first.values, second.values
        # With a wider tolerance than the usual one, the question is whether two formulas are roughly equal.
        allowed = tolerance if first.rounded or second.rounded or tolerance > TOLERANCE else EXACT_TOLERANCE
        near = np.abs(a - b) <= allowed * np.maximum(self._scales, np.maximum(np.abs(a), np.abs(b)))
        return np.asarray(near.all(axis=-1))

    @cached_property
    def _scales(self) -> Array:
        """The scale of the values of each formula, which is that of all formulas in the same part, for each of the points."""
        values = self._right.values
        scales = np.ones((*values.shape[:-1], 1))
        for piece in self.part_indices():
            scales[piece] = scale_of(values[piece])
        return scales

    def slips(self) -> Iterator[Mistake]:
        """Yield what the likeness of one part cannot show: the right formulas with every sign wrong, and transposed."""
        whole = self._whole_slips() if len(self.parts) > 1 else []
        return wrong_slips(self, whole, lambda formula: formula.values, self.part_indices())

    def _whole_slips(self) -> Iterator[Slip]:
        right, values = self._right, self._right.values
        yield ("all signs", replace(right, values=-values), NEGATED_FORMULAS, NEGATED_FORMULAS)
        if len(self._shape) == 2 and self._shape[0] == self._shape[1]:
            turned = replace(right, values=values.swapaxes(0, 1))
            yield ("transposed", turned, "This is the transpose of the right one.", "")

    @cached_property
    def _declared(self) -> list[sp.Symbol]:
        return sorted({*sp.sympify(self.value, strict=True).free_symbols, *self.symbols}, key=str)

    @cached_property
    def _reader(self) -> Reader:
        return Reader(self._declared)

    @cached_property
    def _right(self) -> Formula:
        return self._reader.read(self.value)

    @property
    def _shape(self) -> tuple[int, ...]:
        return self._right.values.shape[:-1]
