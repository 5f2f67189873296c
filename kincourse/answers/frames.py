"""DH frames as answers: every choice of frames that obeys the rules of the convention is right."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.rules import Breach, check_frames
from kinlib.dh.slips import OTHER_CONVENTION
from kinlib.dh.table import Convention
from kinlib.rigid.lie import homogeneous, inverse
from misstep.answers.base import TOLERANCE, Named, Unreadable
from misstep.answers.likeness import UNTOUCHED
from misstep.answers.number import Numbers
from misstep.mutants.expression import Slip

FRAMES_SLIPS = (
    Slip(
        "rotation transposed",
        "give each pose with $R^T$ for $R$",
        lambda T: homogeneous(T[:, :3, :3].swapaxes(1, 2), T[:, :3, 3]),
    ),
    Slip("inverse", "give the inverse of each pose, {s} seen from the frame", inverse),
    Slip(
        "relative",
        "give each frame in the frame before, and not in {s}",
        lambda T: np.concatenate([T[:1], inverse(T[:-1]) @ T[1:]]),
    ),
    Slip("rows reversed", "list the frames from the last to the first", lambda T: T[::-1], in_parts=False),
)
"""The slips that people make in frames as poses in {s}."""


@dataclass(frozen=True, eq=False)
class DHFramesAnswer(Numbers):
    """DH frames 0 to n of an arm at home, shape (n + 1, 4, 4), as poses in {s}; each frame is a part.

    A student's frames are judged by the rules of the convention, because the choice of frames is not unique. Frames are
    compared entry by entry only with the frames of a mistake, which break a rule.
    """

    chain: Chain = field(kw_only=True)
    convention: Convention = field(kw_only=True)
    noun: ClassVar[str] = "frames 0 to n in {s}, an array"

    @property
    def parts(self) -> Sequence[str]:
        return [f"frame {i}" for i in range(self.chain.n + 1)]

    def counts(self, given: Array, right: Sequence[bool]) -> bool:
        """Return whether two frames are right, because a single one is by chance, and not all by the rules of the other convention."""
        other = OTHER_CONVENTION[self.convention]
        return sum(right) > 1 and bool(check_frames(self.chain, given, other, tolerance=10 * TOLERANCE))

    def read(self, given: Any) -> Array:
        if unplaced := _unplaced_frames(given):
            listed = ", ".join(map(str, unplaced))
            raise Unreadable(
                f"Expected {self.expected}. Not placed yet: {'frames' if len(unplaced) > 1 else 'frame'} {listed}. "
                "If you placed them by hand, press Copy there and paste the list here: a frame that is only in the picture is lost "
                "when the notebook is run again."
            )
        return super().read(given)

    def agrees(self, one: Array, other: Array, tolerance: float = TOLERANCE) -> list[bool]:
        if not self._breaches(other):
            return [not self._breaches_of(one, i) for i in range(len(one))]
        return [bool(np.allclose(mine, yours, rtol=0, atol=tolerance)) for mine, yours in zip(one, other, strict=True)]

    def resemblance(self, given: Array, part: int) -> Named | None:
        return next(((breach.rule, breach.text) for breach in self._breaches_of(given, part)), None)

    def placeholder(self, given: Array) -> Named | None:
        is_untouched = (np.ptp(given, axis=0) == 0).all()
        return ("placeholder", UNTOUCHED.format("All frames are the same")) if is_untouched else None

    def seen(self, given: Array, part: int) -> Named | None:
        return None  # a single frame may well have the axes of {s}

    def _breaches_of(self, frames: Array, i: int) -> list[Breach]:
        """The breaches of frame i that are its own: it is held against right frames where others are wrong."""
        breaches = self._breaches(frames)
        others = {breach.frame for breach in breaches} - {i}
        if others and any(breach.frame == i for breach in breaches):
            mended = np.array(frames)
            mended[list(others)] = np.asarray(self.value)[list(others)]
            breaches = self._breaches(mended)
        return [breach for breach in breaches if breach.frame == i]

    @property
    def slips(self) -> Sequence[Slip]:
        return FRAMES_SLIPS

    def _breaches(self, frames: Array) -> list[Breach]:
        # Entries may be typed with three decimals, and a link of several metres multiplies the error of a direction.
        return check_frames(self.chain, frames, self.convention, tolerance=10 * TOLERANCE)


def _unplaced_frames(given: Any) -> list[int]:
    """The numbers of the frames that are not placed yet: `...`, or with NaN entries, as in frames placed by hand."""
    try:
        arrays = [np.asarray(np.nan if T is ... else T) for T in given]
        return [i for i, T in enumerate(arrays) if T.dtype.kind in "fc" and np.isnan(T).any()]
    except Exception:  # any other malformed answer is reported by Numbers.read
        return []
