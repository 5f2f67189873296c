"""Whether frames drawn on an arm obey the rules of Denavit and Hartenberg, and which rule is broken where.

Frames are judged by the rules alone. There are many right assignments, and each of them passes.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.table import Convention, convention_of

DRAWN = 1e-6
"""How far a frame may stray from a rule, in metres or as the sine of an angle."""


@dataclass(frozen=True)
class Breach:
    """One broken rule: which frame, which rule, by how much, in words.

    rule  "right-handed", "z on axis", "z along axis", "origin on axis", "x square to z" or "x meets z"
    """

    frame: int
    rule: str
    text: str


def check_frames(chain: Chain, frames: ArrayLike, convention: Convention, tolerance: float = DRAWN) -> list[Breach]:
    """Judge frames 0 to n of an arm, given in {s} at home: an empty list is a right assignment.

    frames (n + 1, 4, 4); their axes are columns and need not be a rotation, for that is one of the rules.

    right-handed     x, y, z are unit, square to each other, and y = z x x
    z along axis     z_{i-1} (standard) or z_i (modified) points along the axis of joint i, either way
    origin on axis   and its origin lies on that axis; a slide has no place, so there only the direction counts
    x square to z    x_i is perpendicular to z_{i-1} (standard); x_{i-1} is perpendicular to z_i (modified)
    x meets z        and its line meets the line of that z

    Raises ValueError for frames of another shape, and for another convention.
    Source: EduFill module, steps II to V; Chapter 4 review deck, steps 1 to 3; deck n = 5, steps 3 to 6.

    >>> from kinlib.dh.assignment import assign_frames
    >>> from kinlib.chains.robots import youbot
    >>> check_frames(youbot(), assign_frames(youbot(), convention="standard").frames, "standard")
    []
    """
    standard = convention_of(convention) == "standard"
    T = validation.array(frames, "frames")
    if T.shape != (chain.n + 1, 4, 4):
        raise ValueError(
            f"frames should have shape ({chain.n + 1}, 4, 4), frames 0 to {chain.n} of {chain.name}; got {T.shape}. "
            "Is frame 0 or the last frame missing?"
        )
    return [*_handed(T, tolerance), *_on_axes(chain, T, standard, tolerance), *_linked(T, standard, tolerance)]


def _handed(T: Array, tolerance: float) -> Iterator[Breach]:
    for i, R in enumerate(T[:, :3, :3]):
        if np.abs(R.T @ R - np.eye(3)).max() > tolerance:
            yield Breach(i, "right-handed", f"The axes of frame {i} are not unit vectors square to each other.")
        elif np.linalg.det(R) < 0:
            yield Breach(
                i, "right-handed", f"Frame {i} is left-handed: y_{i} should be z_{i} x x_{i}. Turn y_{i} round."
            )


def _on_axes(chain: Chain, T: Array, standard: bool, tolerance: float) -> Iterator[Breach]:
    axes = chain.lines.axis
    for joint, (axis, point) in enumerate(zip(axes, chain.joint_points, strict=True), start=1):
        i = joint - 1 if standard else joint
        z, origin = T[i, :3, 2], T[i, :3, 3]
        if np.linalg.norm(np.cross(z, axis)) > tolerance:
            elsewhere = joint - 1 if standard else joint + 1
            other = elsewhere if 1 <= elsewhere <= chain.n else None
            swapped = other is not None and np.linalg.norm(np.cross(z, axes[other - 1])) <= tolerance
            hint = f" It lies along the axis of joint {other}, as in the other convention." if swapped else ""
            yield Breach(i, "z along axis", f"z_{i} should lie along the axis of joint {joint}; it does not.{hint}")
        elif (
            chain.joint_types[joint - 1] != "P" and (off := np.linalg.norm(np.cross(origin - point, axis))) > tolerance
        ):
            yield Breach(
                i,
                "origin on axis",
                f"The origin of frame {i} should lie on the axis of joint {joint}; it is {off:.3g} m off.",
            )


def _linked(T: Array, standard: bool, tolerance: float) -> Iterator[Breach]:
    for i in range(1, len(T)):
        # The x of a row is the one behind it in the standard convention, and the one before it in the modified.
        own, other = (i, i - 1) if standard else (i - 1, i)
        x, z = T[own, :3, 0], T[other, :3, 2]
        between = T[other, :3, 3] - T[own, :3, 3]
        if abs(x @ z) > tolerance:
            angle = np.degrees(np.arccos(np.clip(x @ z, -1, 1)))
            yield Breach(
                own, "x square to z", f"x_{own} should be perpendicular to z_{other}; the angle is {angle:.4g} degrees."
            )
        elif (miss := abs(between @ np.cross(x, z))) > tolerance:
            yield Breach(
                own,
                "x meets z",
                f"The line of x_{own} should meet the axis z_{other}; it passes {miss:.3g} m beside it. "
                f"Is x_{own} on the common normal?",
            )
