"""Screw axes (omega, v) as answers."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from misstep.answers.base import Named
from misstep.answers.likeness import LENGTH, PURE, ROUND_OFF, entries_hint
from misstep.answers.number import Numbers
from misstep.mutants.expression import Slip
from misstep.validation import Array

ENTRY_NAMES = tuple(f"${half}_{axis}$" for half in (r"\omega", "v") for axis in "xyz")

THUMB = "Point the thumb of your right hand along $\\omega$: your fingers curl the way in which the joint turns."

CHECK_TOLERANCE = 0.01
"""Screws typed with three decimals fulfil $|\\omega| = 1$ and $\\omega \\cdot v = 0$ to this, times the length of $v$."""


def _of_turns(change: Callable[[Array, Array], tuple[Any, Any]]) -> Callable[[Array], Array]:
    """Return a change of omega and v in the rows of joints that turn."""

    def changed(S: Array) -> Array:
        omega, v = S[..., :3], S[..., 3:]
        turns = np.abs(omega).max(axis=-1, keepdims=True, initial=0.0) > ROUND_OFF
        return np.where(turns, np.concatenate(np.broadcast_arrays(*change(omega, v)), axis=-1), S)

    return changed


SLIPS = (
    Slip(
        "halves swapped",
        "write $(v, \\omega)$",
        lambda S: np.roll(S, 3, axis=-1),
        advice="Here a screw is $(\\omega, v)$, the rotation first.",
    ),
    Slip("sign of v", "take the moment $v$ with the opposite sign", _of_turns(lambda w, v: (w, -v))),
    Slip("sign of omega", "take $\\omega$ with the opposite sign, but not $v$", _of_turns(lambda w, v: (-w, v))),
    Slip("no moment", "leave the moment $v$ at 0", _of_turns(lambda w, v: (w, 0 * v))),
)
"""The slips that people make in any screw axis."""


@dataclass(frozen=True, eq=False)
class ScrewsAnswer(Numbers):
    """Screw axes (omega, v) in rows, shape (n, 6), or a single one, shape (6,); each screw axis is a part."""

    names: Sequence[str] = ()
    noun: ClassVar[str] = "screw axes (omega, v), an array"
    alike_rows: ClassVar[bool] = True

    @property
    def expected(self) -> str:
        several = super().expected
        return several if np.ndim(self.value) > 1 else several.replace("screw axes", "a screw axis")

    @property
    def parts(self) -> Sequence[str]:
        rows = 1 if self.value.ndim == 1 else len(self.value)
        return self.names or [f"screw {i + 1}" for i in range(rows)]

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether more is right than translations, beside whose screws a rotation is wrong."""
        rotates = np.abs(np.atleast_2d(self.value)[:, :3]).max(axis=1) > ROUND_OFF
        return bool(rotates[np.array(right)].any() or not rotates[~np.array(right)].any())

    def check(self, given: Array, part: int) -> str:
        mine, right = (np.atleast_2d(S)[part] for S in (given, self.value))
        return screw_check(mine, right)

    @property
    def slips(self) -> Sequence[Slip]:
        return SLIPS

    def resemblance(self, given: Array, part: int) -> Named | None:
        """Return how a screw axis resembles the right one, entry by entry or as a line in space."""
        if (row := self._place(given, part)) and row[0] == "another row":
            return row
        alike = self.likeness(given, part).resemblance()
        same = np.atleast_2d(self.same_entries(given, self.value))[part]
        # Of one among several it is chance, and where omega is right it is said of v alone.
        if alike and not (alike[0].startswith("order") and same[:3].all()):
            return alike
        if np.count_nonzero(~same) == 1:
            return entries_hint(same, ENTRY_NAMES)
        mine, right = np.atleast_2d(given)[part], np.atleast_2d(self.value)[part]
        if same[:3].all() and np.allclose(np.sort(mine[3:]), np.sort(right[3:]), atol=1e-3):
            return "order of v", "$\\omega$ is right, and $v$ has the right numbers, but not in the right order."
        return self._as_a_line(mine, right, same)

    def _as_a_line(self, mine: Array, right: Array, same: NDArray[np.bool_]) -> Named | None:
        """Return what is right and wrong about one axis, (6,), as a line in space."""
        (w, _), (direction, _) = mine.reshape(2, 3), right.reshape(2, 3)
        turns, rotates = (bool(np.abs(x).max() > ROUND_OFF) for x in (direction, w))
        is_parallel = np.linalg.norm(np.cross(w, direction)) < 1e-3 * max(1e-9, float(np.linalg.norm(w)))
        cases = (
            (same[3:].all(), "another direction", "$v$ is right, but $\\omega$ is not."),
            (turns and not rotates, "omega left at 0", "$\\omega$ is 0, as if nothing rotated."),
            (
                rotates and not turns,
                "omega for a translation",
                "For a translation $\\omega$ is 0, and $v$ its direction.",
            ),
            (
                same[:3].all(),
                "another point",
                "$\\omega$ is right, so the axis has the right direction. It passes through other points.",
            ),
            (turns and is_parallel, "another line", "The axis is parallel to the right one, but it lies elsewhere."),
            (turns, "another axis", "$\\omega$ is not right. Begin with the direction: $v$ depends on it."),
        )
        wrong = [name for name, fine in zip(ENTRY_NAMES, same, strict=True) if not fine]
        where = f"\nLook at {' and '.join(wrong)}." if len(wrong) < 3 else ""
        return next(((name, text + where) for is_so, name, text in cases if is_so), None)

    def kinds(self) -> NDArray[np.int_]:
        # The v of a prismatic joint is a direction, that of any other joint a moment, whose size is that of the lengths.
        turns = np.abs(self.value[..., :3]).max(axis=-1, keepdims=True, initial=0.0) > ROUND_OFF
        return np.where(turns & (np.arange(6) >= 3), LENGTH, PURE)

    def place(self, index: Sequence[Any]) -> str:
        name = ENTRY_NAMES[int(index[-1])]
        return f"{name} of {self.parts[int(index[0])]}" if len(index) > 1 else name


def screw_check(mine: Array, right: Array) -> str:
    """Return what every screw axis of this kind of joint fulfils and another one, (6,), does not; "" for twists of other lengths."""
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
    """One twist (omega, v), shape (6,), such as a logarithm or a velocity, in one part. It need not be normalized."""

    names: Sequence[str] = ("the twist",)
    noun: ClassVar[str] = "a twist (omega, v), an array"

    def _as_a_line(self, mine: Array, right: Array, same: NDArray[np.bool_]) -> Named | None:
        """Return where few entries are wrong: a twist has no axis of its own."""
        return entries_hint(same, ENTRY_NAMES)
