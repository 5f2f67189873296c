"""Rotations and poses as answers."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from kincourse.answers.point import REORDERED, XYZ
from kinlib.rigid.lie import homogeneous, inverse, log, nearest_rotation
from kinlib.rigid.rpy import origin
from misstep.answers.accuracy import TOLERANCE
from misstep.answers.entries import Slip, entries_hint
from misstep.answers.equivalent import Equivalent
from misstep.answers.likeness import Likeness, Named
from misstep.answers.number import LENGTH, PURE, Numbers
from misstep.display.sentences import IDENTITY, UNTOUCHED
from misstep.validation import Array

NOT_A_ROTATION = "This is not a rotation matrix."

INVERSE = (
    "The rotation is that of the inverse pose, and the position has only its signs changed. The inverse of $(R, p)$ is "
    "$(R^T, -R^T p)$."
)

OTHER_FRAME = (
    "The position is written in the axes of the rotated frame. It is wanted in those of the frame of reference."
)

OTHER_AXES = "The {} are right up to their order and their signs."

ORTHONORMAL_TOLERANCE = 0.03
"""Entries typed with three decimals change R^T R by a few thousandths, and a real mistake changes it by more."""


@dataclass(frozen=True, eq=False)
class RotationAnswer(Numbers):
    """One rotation matrix, shape (3, 3), in one part.

    >>> RotationAnswer(np.eye(3)).expected
    'a rotation, an array of shape (3, 3)'
    """

    noun: ClassVar[str] = "a rotation, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["the rotation"]

    def kinds(self) -> NDArray[np.int_]:
        return np.full((3, 3), PURE)

    def hint(self, given: Array, part: int) -> str:
        return _rotation_hint(given, self.same_entries(given, self.value))

    def check(self, given: Array, part: int) -> str:
        if text := rotation_check(given):
            return text
        mine, right = (np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1)) for R in (given, self.value))
        text = f"The trace of a rotation is $1 + 2 \\cos\\theta$, and yours belongs to $\\theta$ = {np.degrees(mine):.4g} degrees."
        return text if abs(mine - right) > ORTHONORMAL_TOLERANCE else ""

    def description(self, given: Array, part: int) -> Named | None:
        return _rotation_description(given, self.value) or super().description(given, part)

    def whole_slips(self) -> Iterator[Slip]:
        yield ("R^T", self.value.T, "Your rotation is the transpose of the right one.", "")
        yield from super().whole_slips()


@dataclass(frozen=True, eq=False)
class PoseAnswer(Numbers):
    """One pose, shape (4, 4), in two parts: the rotation and the position, each with its entries of the last row.

    >>> PoseAnswer(np.eye(4)).agrees(np.eye(4), np.diag([1, -1, -1, 1.0]))
    [False, True]
    """

    noun: ClassVar[str] = "a pose, an array"

    @property
    def parts(self) -> Sequence[str]:
        return ["rotation", "position"]

    def hint(self, given: Array, part: int) -> str:
        same = self.same_entries(given, self.value)
        if part == 0 and (text := _rotation_hint(given[:3, :3], same[:3, :3])):
            return text
        if part == 1 and np.count_nonzero(~same[:3, 3]) == 1:
            return entries_hint(same[:3, 3], XYZ)
        closed = np.allclose(given[3], (0, 0, 0, 1), atol=TOLERANCE)
        return "" if closed else "The last row of a pose is 0 0 0 1, whatever is above it."

    def kinds(self) -> NDArray[np.int_]:
        kinds = np.full((4, 4), PURE)
        kinds[:3, 3] = LENGTH
        return kinds

    def part_indices(self) -> list[Any]:
        return [np.s_[:, :3], np.s_[:, 3]]

    def core_indices(self) -> list[Any]:
        return [np.s_[:3, :3], np.s_[:3, 3]]

    def slip_indices(self) -> list[Any]:
        return self.core_indices()

    def length_entries(self) -> NDArray[np.bool_]:
        return np.asarray(self.kinds() == LENGTH)

    def likeness(self, given: Array, part: int | None) -> Likeness:
        found = super().likeness(given, part)
        return replace(found, reordered=REORDERED.format("coordinates")) if part == 1 else found

    def place(self, index: Sequence[Any]) -> str:
        row, column = map(int, index)
        return f"{XYZ[row]} of the position" if column == 3 > row else super().place(index)

    def check(self, given: Array, part: int) -> str:
        return rotation_check(given[:3, :3]) if part == 0 else ""

    def description(self, given: Array, part: int) -> Named | None:
        if not np.allclose(given[3], (0, 0, 0, 1), atol=TOLERANCE) and self._core_is_right(given, part):
            return "last row", "The numbers above the last row are right, but the last row of a pose is 0 0 0 1."
        named = _rotation_description(given[:3, :3], self.value[:3, :3]) if part == 0 else None
        if named and named[1] in (OTHER_AXES.format("columns"), OTHER_AXES.format("rows")):
            return named[0], f"{named[1][:-1]}, so the axes of a frame are named or directed in another way."
        return named or super().description(given, part)

    def _core_is_right(self, given: Array, part: int) -> bool:
        return bool(self.same_entries(given, self.value)[self.core_indices()[part]].all())

    def whole_slips(self) -> Iterator[Slip]:
        T = np.asarray(self.value, dtype=float)
        R, p = T[:3, :3], T[:3, 3]
        back = inverse(T)
        yield (
            "R^T",
            homogeneous(R.T, p),
            "The position is right; the rotation is the transpose of the right one.",
            "The rotation is the transpose of the right one.",
        )
        yield (
            "inverse",
            back,
            "Your pose is the inverse of the right one: it says where the frame of reference lies, seen from the other one.",
            "",
        )
        yield (
            "not rotated back",
            homogeneous(R, back[:3, 3]),
            "The rotation is right; the position is that of the inverse pose.",
            "This is the position of the inverse pose.",
        )
        yield ("transposed", T.T, "Your matrix is the transpose of the right one, last row included.", "")
        yield (
            "position negated",
            homogeneous(R, -p),
            "The rotation is right; every sign of the position is wrong.",
            "The position has the right sizes, but every sign is wrong.",
        )
        yield (
            "not rotated",
            homogeneous(np.eye(3), p),
            "The position is right; the rotation is left at the identity.",
            IDENTITY,
        )
        yield (
            "position left at 0",
            homogeneous(R, 0 * p),
            "The rotation is right; the position is left at 0.",
            UNTOUCHED.format("Every number is 0"),
        )
        yield ("R^T and -p", homogeneous(R.T, -p), INVERSE, "")
        yield (
            "millimetres",
            homogeneous(R, 1000 * p),
            "The rotation is right; the position is in millimetres. Give it in metres.",
            "The position is in millimetres. Give it in metres.",
        )
        yield (
            "position in the other frame",
            homogeneous(R, R.T @ p),
            f"The rotation is right, but not the position. {OTHER_FRAME}",
            OTHER_FRAME,
        )
        for i, j in ((0, 1), (1, 2), (0, 2)):
            order = np.arange(4)
            order[[i, j]] = j, i
            text = f"Columns {i + 1} and {j + 1} of the rotation are swapped."
            yield ("columns swapped", T[:, order], text, text)


def _origin_pose(rows: Array) -> Array:
    return origin(*rows)


@dataclass(frozen=True, eq=False)
class OriginAnswer(Equivalent):
    """The `xyz` and `rpy` of the origin of a joint in a URDF, shape (2, 3), in metres and radians, compared as a pose.

    >>> OriginAnswer(np.zeros((2, 3))).agrees(np.array([[0, 0, 0], np.pi * np.ones(3)]), np.zeros((2, 3)))
    [True]
    """

    noun: ClassVar[str] = "xyz and rpy in two rows, an array"

    def length_entries(self) -> NDArray[np.bool_]:
        return np.array([[True] * 3, [False] * 3])

    def angle_entries(self) -> NDArray[np.bool_]:
        return np.array([[False] * 3, [True] * 3])

    meaning: Callable[[Array], Array] = field(default=_origin_pose, kw_only=True)

    @property
    def parts(self) -> Sequence[str]:
        return ["the origin"]

    def explanation(self, given: Array, part: int) -> Named | None:
        right = np.asarray(self.value)
        if np.allclose(origin(*given), inverse(origin(*right)), atol=TOLERANCE):
            return "inverse", "This is the inverse: the origin of the parent, seen from the child."
        return super().explanation(given, part)

    def description(self, given: Array, part: int) -> Named | None:
        right = np.asarray(self.value)
        if self.agrees(np.stack([given[0], right[1]]), right)[0]:
            return "another rpy", "The xyz is right, but the rpy is another rotation."
        if not self.agrees(np.stack([right[0], given[1]]), right)[0]:
            return None
        same = self.same_entries(given, right)[0]
        return "another xyz", f"The rpy is right, but the xyz is not. {entries_hint(same, XYZ)}".rstrip()


def _rotation_hint(R: Array, same: NDArray[np.bool_]) -> str:
    """Say which entry is wrong, if it is one or two; or that it is no rotation; "" otherwise."""
    if 0 < np.count_nonzero(~same) <= 2:
        return entries_hint(same)
    return NOT_A_ROTATION if rotation_check(R) else ""


def rotation_check(R: Array) -> str:
    """Return the first property of rotations that a matrix does not have, with its own numbers; "" if it is a rotation.

    >>> rotation_check(np.diag([1, 1, 2.0])), rotation_check(np.diag([-1, 1, 1.0]))[-16:], rotation_check(np.eye(3))
    ('No entry of a rotation is larger than 1, and one of yours is 2.', 'and yours is -1.', '')
    """
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


def _rotation_description(R: Array, right: Array) -> Named | None:
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
