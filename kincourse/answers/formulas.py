"""Poses and screw axes in closed form, that is, as matrices of formulas, as answers."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from kincourse.answers.pose import PoseParts
from kincourse.answers.screws import screw_check
from misstep.answers.base import Named
from misstep.answers.expression import ClosedForm
from misstep.formulas.evaluation import Formula


@dataclass(frozen=True, eq=False)
class PoseExpressionAnswer(PoseParts, ClosedForm):
    """A pose as a 4x4 matrix of formulas, in two parts: the rotation and the position, each with its entries of the last row."""


@dataclass(frozen=True, eq=False)
class ScrewExpressionsAnswer(ClosedForm):
    """Screw axes (omega, v) as rows of formulas, shape (n, 6); each screw axis is a part."""

    alike_rows: ClassVar[bool] = True

    @property
    def parts(self) -> Sequence[str]:
        return [f"screw {i + 1}" for i in range(len(self.part_indices()))]

    def part_indices(self) -> list[Any]:
        return list(range(self.value.shape[0]))

    def check(self, given: Formula, part: int) -> str:
        points = zip(*(formula.values[part].T for formula in (given, self._right)), strict=True)
        found = next(filter(None, (screw_check(mine, right) for mine, right in points)), "")
        return re.sub(r"; your.*", "; check yours.", found)  # the numbers are those of one point

    def resemblance(self, given: Formula, part: int) -> Named | None:
        found = super().resemblance(given, part)
        if found and found[0]:
            return found
        omega, v = self.same_entries(given, self.value)[part].reshape(2, 3).all(axis=1)
        if omega:
            return "another point", "$\\omega$ is right, but $v$ is not."
        return ("another direction", "$v$ is right, but $\\omega$ is not.") if v else found
