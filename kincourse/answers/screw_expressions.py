"""Screw axes in closed form, that is, as rows of formulas, as answers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from kincourse.answers.screws import ENTRY_NAMES
from misstep.answers.expression import ClosedForm
from misstep.answers.number import entries_hint
from misstep.formulas.evaluation import Formula


@dataclass(frozen=True, eq=False)
class ScrewExpressionsAnswer(ClosedForm):
    """Screw axes (omega, v) as rows of formulas, shape (n, 6); each screw axis is a part.

    >>> import sympy as sp
    >>> ScrewExpressionsAnswer(sp.eye(2, 6)).parts
    ['screw 1', 'screw 2']
    """

    @property
    def rows_are_alike(self) -> bool:
        return True

    @property
    def parts(self) -> Sequence[str]:
        return [f"screw {i + 1}" for i in range(len(self.part_indices()))]

    def part_indices(self) -> list[Any]:
        return list(range(self.value.shape[0]))

    def description(self, given: Formula, part: int) -> tuple[str, str] | None:
        if one := super().description(given, part):
            return one
        omega, v = self.same_entries(given, self.value)[part].reshape(2, 3).all(axis=1)
        if omega == v:
            return None
        return ("another point" if omega else "another direction"), self.hint(given, part)

    def hint(self, given: Formula, part: int) -> str:
        same = self.same_entries(given, self.value)[part]
        if same[:3].all():
            return f"The omega is right, but the v is not. {entries_hint(same, ENTRY_NAMES)}".rstrip()
        return "The v is right, but the omega is not." if same[3:].all() else entries_hint(same, ENTRY_NAMES)
