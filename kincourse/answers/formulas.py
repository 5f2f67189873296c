"""Poses and screw axes in closed form, that is, as matrices of formulas, as answers."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from kincourse.answers.point import REORDERED
from kincourse.answers.pose import PoseParts
from kincourse.answers.screws import CHECK_TOLERANCE, THUMB
from misstep.answers.base import Named
from misstep.answers.expression import ClosedForm
from misstep.answers.likeness import Likeness
from misstep.formulas.evaluation import Formula


@dataclass(frozen=True, eq=False)
class PoseExpressionAnswer(PoseParts, ClosedForm):
    """A pose as a 4x4 matrix of formulas, in two parts: the rotation and the position, each with its entries of the last row."""

    def likeness(self, given: Formula, part: int | None) -> Likeness:
        found = super().likeness(given, part)
        return replace(found, reordered=REORDERED.format("coordinates")) if part == 1 else found


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
        mine, right = (np.linalg.norm(X.values[part, :3], axis=0) for X in (given, self._right))
        if right.any() and np.abs(mine - 1).max() > CHECK_TOLERANCE:
            return "The $\\omega$ of a screw axis has the length 1; yours has another one."
        pitch = (given.values[part, :3] * given.values[part, 3:]).sum(axis=0)
        if right.any() and np.abs(pitch).max() > CHECK_TOLERANCE:
            return "A revolute joint has $\\omega \\cdot v = 0$; multiply out yours."
        is_opposite = np.allclose(given.values[part, :3], -self._right.values[part, :3])
        return THUMB if right.any() and is_opposite else ""

    def resemblance(self, given: Formula, part: int) -> Named | None:
        found = super().resemblance(given, part)
        if found and found[0]:
            return found
        omega, v = self.same_entries(given, self.value)[part].reshape(2, 3).all(axis=1)
        if omega:
            return "another point", "$\\omega$ is right, but $v$ is not."
        return ("another direction", "$v$ is right, but $\\omega$ is not.") if v else found
