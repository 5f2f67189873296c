"""Formulas as answers: a formula is right if it has the same values as the right one, however it is written."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from misstep.answers.base import TOLERANCE, Answer, Named, Unreadable
from misstep.answers.likeness import Likeness, entries_hint, place_of
from misstep.answers.number import scale_of
from misstep.formulas.evaluation import Formula, Reader, shaped
from misstep.mutants.expression import Expression
from misstep.validation import Array

EXACT_TOLERANCE = 1e-10
"""The tolerance for formulas without decimals, relative to their values or their scale: only the values were rounded."""


@dataclass(frozen=True, eq=False)
class ClosedForm(Answer):
    """A formula, or a vector or matrix of formulas, given as SymPy or as text.

    value    the right formula; its symbols may be used
    symbols  further symbols that may be used

    Formulas are compared to ten digits; if one of them contains decimals, to the three that a person types. The formula is
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

    def agrees(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> list[bool]:
        same = self.same_entries(one, other, tolerance)
        return [bool(same[piece].all()) for piece in self.part_indices()]

    def part_indices(self) -> list[Any]:
        """Return, for each part, the index of its entries in the array."""
        return [...]

    def core_indices(self) -> list[Any]:
        """Return, for each part, the index of the entries that make it up, without those that are always the same."""
        return self.part_indices()

    def placeholder(self, given: Formula) -> Named | None:
        return self.likeness(given, None).placeholder()

    def seen(self, given: Formula, part: int) -> Named | None:
        return self.likeness(given, part).placeholder()

    def order(self, given: Formula) -> Named | None:
        return self.likeness(given, None).order() if self.has_alike_rows else None

    def resemblance(self, given: Formula, part: int) -> Named | None:
        found = self.likeness(given, part).resemblance()
        same = self.same_entries(given, self.value)[self.core_indices()[part]]
        return found or (entries_hint(same) if same.ndim else None)

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
        )

    def at_inputs(self, solution: Callable[..., Expression] | None = None) -> Iterator[Expression | Any]:
        if solution is None:
            return (self._right.values[..., k] for k in range(self._right.values.shape[-1]))
        return (solution(**point) for point in self._reader.points)

    def collect(self, values: Sequence[Any]) -> Formula:
        shape = self._right.values.shape[:-1]
        try:
            entries = [np.reshape(np.asarray(value, dtype=float), shape) for value in values]
            return Formula(np.stack(entries, axis=-1), False)
        except (TypeError, ValueError) as error:
            raise Unreadable(f"Expected {self.expected}.") from error

    def same_entries(self, one: Any, other: Any, tolerance: float = TOLERANCE) -> NDArray[np.bool_]:
        """Return, for each entry, whether the values agree at all points."""
        first, second = (self._right if formula is self.value else formula for formula in (one, other))
        count = min(first.values.shape[-1], second.values.shape[-1])
        a, b, scales = (values[..., :count] for values in (first.values, second.values, self._scales))
        # With a wider tolerance than the usual one, the question is whether two formulas are roughly equal.
        allowed = tolerance if first.rounded or second.rounded or tolerance > TOLERANCE else EXACT_TOLERANCE
        near = np.abs(a - b) <= allowed * np.maximum(scales, np.maximum(np.abs(a), np.abs(b)))
        return np.asarray(near.all(axis=-1))

    @cached_property
    def _scales(self) -> Array:
        """The scale of the values of each formula, which is that of all formulas in the same part, for each of the points."""
        values = self._right.values
        scales = np.ones((*values.shape[:-1], 1))
        for piece in self.part_indices():
            scales[piece] = scale_of(values[piece])
        return scales

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
