"""Rotations and poses as answers: as matrices, and as the angles and the `xyz` and `rpy` that give them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kincourse.answers.point import XYZ
from kinlib.rigid.lie import homogeneous, inverse, log, nearest_rotation
from kinlib.rigid.rpy import origin
from misstep.answers.base import TOLERANCE, Named
from misstep.answers.likeness import ANGLE, LENGTH, PURE, entries_hint
from misstep.answers.number import Equivalent, Numbers
from misstep.mutants.expression import Slip
from misstep.validation import Array

NOT_A_ROTATION = "This is not a rotation matrix."

OTHER_AXES = "The {} are right up to their order and their signs."

ORTHONORMAL_TOLERANCE = 0.03
"""Entries typed with three decimals change R^T R by a few thousandths, and a real mistake changes it by more."""

ANGLES_TOLERANCE_FACTOR = 3
"""How many times the tolerance of one entry a rotation may be off: the rounding errors of three angles add up."""


@dataclass(frozen=True, eq=False)
class RotationAnswer(Numbers):
    """One rotation matrix, shape (3, 3), in one part."""

    noun: ClassVar[str] = "a rotation, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["the rotation"]

    def kinds(self) -> NDArray[np.int_]:
        return np.full((3, 3), PURE)

    def check(self, given: Array, part: int) -> str:
        return rotation_check(given)

    def resemblance(self, given: Array, part: int) -> Named | None:
        alike = self.likeness(given, part).resemblance()
        same = self.same_entries(given, self.value)
        return alike or entries_hint(same) or rotation_resemblance(given, self.value)


POSE_SLIPS = (
    Slip("inverse", "give the inverse of the pose", inverse, in_parts=False),
    Slip("transposed", "give the transpose of the whole matrix, last row included", np.transpose, in_parts=False),
    Slip(
        "negative for inverse",
        "give $R^T$ and $-p$, the inverse without the rotation of its position",
        lambda T: homogeneous(T[:3, :3].T, -T[:3, 3]),
        advice="The inverse of $(R, p)$ is $(R^T, -R^T p)$.",
        in_parts=False,
    ),
    Slip(
        "position of the inverse",
        "give the position of the inverse pose, $-R^T p$",
        lambda T: homogeneous(T[:3, :3], inverse(T)[:3, 3]),
    ),
    Slip(
        "position in the other frame",
        "write the position in the axes of the rotated frame",
        lambda T: homogeneous(T[:3, :3], T[:3, :3].T @ T[:3, 3]),
        advice="It is wanted in the axes of the frame of reference.",
    ),
)
"""The slips that people make in any pose."""


class PoseParts:
    """The two parts of a pose, each with its entries of the last row, and without them."""

    parts = ("rotation", "position")

    def part_indices(self) -> list[Any]:
        return [np.s_[:, :3], np.s_[:, 3]]

    def core_indices(self) -> list[Any]:
        return [np.s_[:3, :3], np.s_[:3, 3]]


@dataclass(frozen=True, eq=False)
class PoseAnswer(PoseParts, Numbers):
    """One pose, shape (4, 4), in two parts: the rotation and the position, each with its entries of the last row."""

    noun: ClassVar[str] = "a pose, an array"

    def kinds(self) -> NDArray[np.int_]:
        kinds = np.full((4, 4), PURE)
        kinds[:3, 3] = LENGTH
        return kinds

    def place(self, index: Sequence[Any]) -> str:
        row, column = map(int, index)
        return f"{XYZ[row]} of the position" if column == 3 > row else super().place(index)

    def check(self, given: Array, part: int) -> str:
        return rotation_check(given[:3, :3]) if part == 0 else ""

    @property
    def slips(self) -> Sequence[Slip]:
        return POSE_SLIPS

    def resemblance(self, given: Array, part: int) -> Named | None:
        core = self.same_entries(given, self.value)[self.core_indices()[part]]
        if core.all():
            return "last row", "The numbers above the last row are right, but the last row of a pose is 0 0 0 1."
        if found := self.likeness(given, part).resemblance() or entries_hint(core, None if part == 0 else XYZ):
            return found
        return rotation_resemblance(given[:3, :3], self.value[:3, :3]) if part == 0 else None


@dataclass(frozen=True, eq=False)
class OriginAnswer(Equivalent):
    """The `xyz` and `rpy` of the origin of a joint in a URDF, shape (2, 3), in metres and radians, compared as a pose."""

    noun: ClassVar[str] = "xyz and rpy in two rows, an array"

    def kinds(self) -> NDArray[np.int_]:
        return np.array([[LENGTH] * 3, [ANGLE] * 3])

    meaning: Callable[[Array], Array] = field(default=lambda rows: origin(*rows), kw_only=True)

    @property
    def parts(self) -> Sequence[str]:
        return ["the origin"]

    def resemblance(self, given: Array, part: int) -> Named | None:
        right = np.asarray(self.value)
        if np.allclose(origin(*given), inverse(origin(*right)), atol=TOLERANCE):
            return "inverse", "This is the inverse: the origin of the parent, seen from the child."
        if found := super().resemblance(given, part):
            return found
        if self.agrees(np.stack([given[0], right[1]]), right)[0]:
            return "another rpy", "The xyz is right, but the rpy is another rotation."
        if not self.agrees(np.stack([right[0], given[1]]), right)[0]:
            return None
        hint = entries_hint(self.same_entries(given, right)[0], XYZ)
        return "another xyz", f"The rpy is right, but the xyz is not. {hint[1] if hint else ''}".rstrip()


@dataclass(frozen=True, eq=False)
class EulerAnglesAnswer(Equivalent):
    """Three angles for each of two rotations, in rows and in radians; the second rotation is at the singular case.

    Each row is a part, and right if it gives the right rotation.
    """

    noun: ClassVar[str] = "roll, pitch and yaw in radians, one row for each rotation, an array"
    meaning: Callable[[Array], Array] = field(default=lambda angles: origin(rpy=angles), kw_only=True)

    @property
    def parts(self) -> Sequence[str]:
        return ["the angles for $R_1$", "the angles for $R_2$"]

    def kinds(self) -> NDArray[np.int_]:
        return np.full(np.shape(self.value), ANGLE)

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        off = [np.abs(self.meaning(mine) - self.meaning(yours)).max() for mine, yours in zip(one, other, strict=True)]
        return [bool(distance <= ANGLES_TOLERANCE_FACTOR * tolerance) for distance in off]


def rotation_check(R: Array) -> str:
    """Return the first property of rotations that a matrix does not have, with its own numbers; "" if it is a rotation."""
    largest = R.flat[np.abs(R).argmax()]
    if abs(largest) > 1 + ORTHONORMAL_TOLERANCE:
        beyond = "larger than 1" if largest > 0 else "smaller than -1"
        return f"No entry of a rotation is {beyond}, and one of yours is {largest:.4g}."
    products = R.T @ R
    for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)):
        if abs(products[i, j] - (i == j)) > ORTHONORMAL_TOLERANCE:
            size = np.sqrt(products[i, i])
            if i == j:
                return f"Each column of a rotation has the length 1; your column {i + 1} has {size:.3g}."
            columns = f"columns {i + 1} and {j + 1} have the dot product {products[i, j]:.2g}"
            return f"The columns of a rotation are perpendicular; your {columns}."
    return "" if np.linalg.det(R) > 0 else f"The determinant of a rotation is 1, and yours is {np.linalg.det(R):.3g}."


def rotation_resemblance(R: Array, right: Array) -> Named | None:
    """Say how a rotation differs from the right one as a motion: by a right angle, by its angle alone, by its axis alone."""
    if rotation_check(R):
        return "not a rotation", NOT_A_ROTATION
    for turn, columns in ((right.T @ R, "columns"), (R @ right.T, "rows")):
        if np.allclose(np.abs(turn), np.abs(turn).round(), atol=ORTHONORMAL_TOLERANCE):
            return f"{columns} in another order", OTHER_AXES.format(columns)
    mine, other = (log(nearest_rotation(X)) for X in (R, right))
    sizes = np.linalg.norm(mine), np.linalg.norm(other)
    if min(sizes) > ORTHONORMAL_TOLERANCE:
        if np.linalg.norm(np.cross(mine, other)) < 0.01 * sizes[0] * sizes[1]:
            return "angle of the rotation", "Your rotation has the right axis; its angle is not right."
        if abs(sizes[0] - sizes[1]) < 5 * TOLERANCE:
            return "axis of the rotation", "Your rotation has the right angle; its axis is not right."
    return None
