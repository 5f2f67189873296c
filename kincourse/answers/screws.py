"""Screw axes (omega, v) as answers."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep.answers.entries import ROUND_OFF, Slip
from misstep.answers.likeness import Likeness, Named
from misstep.answers.number import LENGTH, PURE, Numbers
from misstep.validation import Array

ENTRY_NAMES = tuple(f"${half}_{axis}$" for half in (r"\omega", "v") for axis in "xyz")

THUMB = "Point the thumb of your right hand along $\\omega$: your fingers curl the way in which the joint turns."

CHECK_TOLERANCE = 0.01
"""Screws typed with three decimals fulfil $|\\omega| = 1$ and $\\omega \\cdot v = 0$ to this, times the length of $v$."""


@dataclass(frozen=True, eq=False)
class ScrewsAnswer(Numbers):
    """Screw axes (omega, v) in rows, shape (n, 6), or a single one, shape (6,); each screw axis is a part.

    >>> ScrewsAnswer(np.eye(2, 6)).parts
    ['screw 1', 'screw 2']
    """

    names: Sequence[str] = ()
    single: str = "a screw axis"  # or "a twist", which need not be normalized
    noun: ClassVar[str] = "screw axes (omega, v), an array"

    @property
    def expected(self) -> str:
        several = super().expected
        return several if np.ndim(self.value) > 1 else several.replace("screw axes", self.single)

    @property
    def parts(self) -> Sequence[str]:
        rows = 1 if self.value.ndim == 1 else len(self.value)
        return self.names or [f"screw {i + 1}" for i in range(rows)]

    def hint(self, given: Array, part: int) -> str:
        same = np.atleast_2d(self.same_entries(given, self.value))[part]
        omega, v = same[:3], same[3:]
        wrong = [name for name, fine in zip(ENTRY_NAMES, same, strict=True) if not fine]
        place = f" Look at {wrong[0]}: all other entries are right." if len(wrong) == 1 else ""
        if omega.all():
            return f"$\\omega$ is right, but $v$ is not.{place}"
        return f"$v$ is right, but $\\omega$ is not.{place}" if v.all() else ""

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether more is right than translations, beside whose screws a rotation is wrong."""
        rotates = np.abs(np.atleast_2d(self.value)[:, :3]).max(axis=1) > ROUND_OFF
        return bool(rotates[np.array(right)].any() or not rotates[~np.array(right)].any())

    @property
    def rows_are_alike(self) -> bool:
        return bool(self.value.ndim > 1)

    def length_entries(self) -> NDArray[np.bool_]:
        return np.asarray(self.kinds() == LENGTH)

    def likeness(self, given: Array, part: int | None) -> Likeness:
        return replace(super().likeness(given, part), unit="moments")

    def check(self, given: Array, part: int) -> str:
        mine, right = (np.atleast_2d(S)[part] for S in (given, self.value))
        return screw_check(mine, right)

    def description(self, given: Array, part: int) -> Named | None:
        """Say what is right and wrong about the axis as a line in space."""
        if one := super().description(given, part):
            return one
        mine, right = (np.atleast_2d(S)[part] for S in (given, self.value))
        omega, v = np.atleast_2d(self.same_entries(given, self.value))[part].reshape(2, 3).all(axis=1)
        (w, m), (direction, moment) = mine.reshape(2, 3), right.reshape(2, 3)
        size, right_size = float(np.linalg.norm(w)), float(np.linalg.norm(direction))
        along, of_moment = abs(m @ w - moment @ direction), max(1.0, float(np.linalg.norm(m)))
        no_unit = abs(right_size - 1) < 1e-6 and abs(size - 1) > 1e-2
        cases = (
            (v and not no_unit, "another direction", "$v$ is right, but $\\omega$ is not."),
            (v, "not a unit vector", "$v$ is right, but $\\omega$ is not."),
            (right_size > ROUND_OFF >= size, "omega left at 0", "$\\omega$ is 0, as if nothing rotated."),
            (
                right_size <= ROUND_OFF < size,
                "omega for a translation",
                "This is a translation, so $\\omega$ is 0, and the direction is in $v$.",
            ),
            (no_unit, "not a unit vector", "$\\omega$ is not a unit vector."),
            (
                omega and abs(moment @ direction) < 1e-9 and along > 2e-3 * of_moment,
                "moment along the axis",
                "$\\omega$ is right. $v$ is not perpendicular to it, as the moment $-\\omega \\times q$ must be.",
            ),
            (
                omega,
                "another point",
                "$\\omega$ is right, so the axis has the right direction. It passes through other points.",
            ),
            (
                np.linalg.norm(np.cross(w, direction)) < 1e-3 * max(size * right_size, 1e-9),
                "another line",
                "The axis is parallel to the right one, but it lies elsewhere.",
            ),
            (
                right_size > ROUND_OFF,
                "another axis",
                "$\\omega$ is not right. Begin with the direction of the axis; the moment depends on it.",
            ),
        )
        return next(((name, text) for is_so, name, text in cases if is_so), None)

    def kinds(self) -> NDArray[np.int_]:
        # The v of a prismatic joint is a direction, that of any other joint a moment, whose size is that of the lengths.
        turns = np.abs(self.value[..., :3]).max(axis=-1, keepdims=True, initial=0.0) > ROUND_OFF
        return np.where(turns & (np.arange(6) >= 3), LENGTH, PURE)

    def whole_slips(self) -> Iterator[Slip]:
        for name, value, text, part_text in self._changes():
            yield (name, value, text if self.value.ndim > 1 else part_text, part_text)

    def _changes(self) -> Iterator[Slip]:
        S = np.asarray(self.value, dtype=float)
        omega, v, moments = S[..., :3], S[..., 3:], self.kinds() == LENGTH
        zero = np.zeros_like(v)
        yield (
            "halves swapped",
            np.roll(S, 3, axis=-1),
            "Every screw axis has $v$ in front of $\\omega$. The order is $(\\omega, v)$.",
            "It has $v$ in front of $\\omega$. The order is $(\\omega, v)$.",
        )
        yield (
            "opposite direction",
            -S,
            "Every screw axis has the opposite direction: every sign is wrong.",
            "It has the opposite direction: every sign is wrong.",
        )
        yield (
            "sign of v",
            np.where(moments, -S, S),
            "Every $\\omega$ is right; every moment $v$ has the wrong sign.",
            "Its $\\omega$ is right; its moment $v$ has the wrong sign.",
        )
        yield (
            "sign of omega",
            np.concatenate([-omega, v], axis=-1),
            "Every $v$ is right; every $\\omega$ has the wrong sign.",
            "Its $v$ is right; its $\\omega$ has the wrong sign.",
        )
        yield (
            "no moment",
            np.where(moments, 0.0, S),
            "Every $\\omega$ is right; every moment $v$ is left at 0.",
            "Its $\\omega$ is right; its moment $v$ is left at 0.",
        )
        yield (
            "direction in v",
            np.where(moments.any(axis=-1, keepdims=True), np.concatenate([zero, omega], axis=-1), S),
            "Every direction is in $v$, and $\\omega$ is 0, as if all joints were prismatic.",
            "Its direction is in $v$, and $\\omega$ is 0, as if the joint were prismatic.",
        )
        yield (
            "direction in omega",
            np.where(moments.any(axis=-1, keepdims=True), S, np.concatenate([v, zero], axis=-1)),
            "The direction of a translation is in $\\omega$. It belongs in $v$, and $\\omega$ is 0.",
            "The direction of the translation is in $\\omega$. It belongs in $v$, and $\\omega$ is 0.",
        )
        yield (
            "millimetres",
            np.where(moments, 1000 * S, S),
            "The moments $v$ are in millimetres. Give them in metres.",
            "The moment $v$ is in millimetres. Give it in metres.",
        )
        if S.ndim > 1:
            yield ("reversed", S[::-1], "The screw axes are right, but their order is reversed.", "")
            for i in range(len(S) - 1):
                order = np.arange(len(S))
                order[[i, i + 1]] = i + 1, i
                yield "rows swapped", S[order], f"The rows of {self.parts[i]} and {self.parts[i + 1]} are swapped.", ""

    def place(self, index: Sequence[Any]) -> str:
        name = ENTRY_NAMES[int(index[-1])]
        return f"{name} of {self.parts[int(index[0])]}" if len(index) > 1 else name

    def remedy(self, shape: tuple[int, ...]) -> str:
        if shape == (3,) and np.shape(self.value) == (6,):
            return " A screw axis is (omega, v), six numbers: is the other half missing?"
        return super().remedy(shape)

    def part_indices(self) -> list[Any]:
        return [...] if self.value.ndim == 1 else list(range(len(self.value)))


def screw_check(mine: Array, right: Array) -> str:
    r"""Return what every screw axis of this kind of joint fulfils and another one, (6,), does not; "" for twists of other lengths.

    >>> S = np.array([0, 0, 1.0, 2, 3, 0])
    >>> screw_check(S * (1, 1, 2, 1, 1, 1), S)
    'The $\\omega$ of a screw axis has the length 1; yours has 2.'
    >>> screw_check(S + (0, 0, 0, 0, 0, 4), S)
    'A revolute joint has $\\omega \\cdot v = 0$; your numbers give 4.'
    >>> screw_check(S, S), screw_check(3 * S, 2 * S), screw_check(-S, S) == THUMB
    ('', '', True)
    """
    (w, v), (direction, moment) = mine.reshape(2, 3), right.reshape(2, 3)
    letter, (own, ours) = ("\\omega", (w, direction)) if direction.any() else ("v", (v, moment))
    size = float(np.linalg.norm(own))
    if abs(np.linalg.norm(ours) - 1) > 1e-6:
        return ""
    if abs(size - 1) > CHECK_TOLERANCE:
        what = "screw axis" if letter != "v" else "translation"
        return f"The ${letter}$ of a {what} has the length 1; yours has {size:.3g}."
    pitch = float(w @ v)
    if (
        direction.any()
        and abs(direction @ moment) < 1e-9
        and abs(pitch) > CHECK_TOLERANCE * max(1.0, float(np.linalg.norm(v)))
    ):
        return f"A revolute joint has $\\omega \\cdot v = 0$; your numbers give {pitch:.3g}."
    return THUMB if direction.any() and np.allclose(w, -direction, atol=CHECK_TOLERANCE) else ""


@dataclass(frozen=True, eq=False)
class TwistAnswer(ScrewsAnswer):
    """One twist (omega, v), shape (6,), such as a logarithm, in one part.

    >>> TwistAnswer(np.ones(6)).expected
    'a twist (omega, v), an array of shape (6,)'
    """

    names: Sequence[str] = ("the twist",)
    noun: ClassVar[str] = "a twist (omega, v), an array"
