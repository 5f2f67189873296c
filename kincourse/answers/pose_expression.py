"""Poses in closed form, that is, as matrices of formulas, as answers."""

from dataclasses import dataclass, replace

from kincourse.answers.point import REORDERED
from kincourse.answers.pose import PoseParts
from misstep.answers.expression import ClosedForm
from misstep.answers.likeness import Likeness
from misstep.formulas.evaluation import Formula


@dataclass(frozen=True, eq=False)
class PoseExpressionAnswer(PoseParts, ClosedForm):
    """A pose as a 4x4 matrix of formulas, in two parts: the rotation and the position, each with its entries of the last row."""

    def likeness(self, given: Formula, part: int | None) -> Likeness:
        found = super().likeness(given, part)
        return replace(found, reordered=REORDERED.format("coordinates")) if part == 1 else found
