"""Check frames drawn on an arm against the rules of Denavit and Hartenberg, and report which rule each frame breaks.

Frames are checked against the rules alone. There are many correct assignments, and each of them passes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.chains.chain import Chain
from kinlib.dh.table import Convention, validate_convention


@dataclass(frozen=True)
class Breach:
    """One broken rule: the frame, the name of the rule in the list of `check_frames`, and a sentence that says by how much."""

    frame: int
    rule: str
    text: str


def check_frames(chain: Chain, frames: ArrayLike, convention: Convention, tolerance: float = 1e-6) -> list[Breach]:
    """Check frames 0 to n of an arm, given in {s} at home; the list of breaches of a correct assignment is empty.

    tolerance  how far a frame may deviate from a rule, in metres or as the sine of an angle
    frames (n + 1, 4, 4); their axes are columns and may fail to form a rotation, because that is one of the rules.

    right-handed     x, y, z are unit vectors perpendicular to each other, and y = z x x
    z along axis     z_{i-1} (standard) or z_i (modified) is along the axis of joint i, in either direction
    origin on axis   and its origin lies on that axis; for a prismatic joint, which has no line, only the direction is checked
    x perpendicular to z   x_i is perpendicular to z_{i-1} (standard); x_{i-1} is perpendicular to z_i (modified)
    x meets z        and the line of that x intersects the line of that z

    Source: EduFill manipulation module, steps II to V; Chapter 4 review, steps 1 to 3; DH example with n = 5, steps 3 to 6.

    >>> check_frames(kl.robots.youbot(), kl.assign_frames(kl.robots.youbot(), convention="standard").frames, "standard")
    []
    """
    validation.instance(chain, "chain", Chain)
    standard = validate_convention(convention) == "standard"
    T = validation.array(frames, "frames")
    if T.shape != (chain.n + 1, 4, 4):
        raise ValueError(
            f"frames must have shape ({chain.n + 1}, 4, 4), from 0 to {chain.n}; got {T.shape}. Is the first or the last one missing?"
        )
    found = list[tuple[int, str, str]]()
    for i, R in enumerate(T[:, :3, :3]):
        if np.abs(R.T @ R - np.eye(3)).max() > tolerance:
            text = f"The axes of frame {i} must be unit vectors perpendicular to each other."
            found.append((i, "right-handed", text))
        elif np.linalg.det(R) < 0:
            found.append((i, "right-handed", f"Frame {i} is left-handed: y_{i} must be z_{i} x x_{i}. Negate y_{i}."))
    for joint, (axis, point) in enumerate(zip(chain.lines.axis, chain.joint_points, strict=True), start=1):
        i = joint - standard
        z, origin = T[i, :3, 2], T[i, :3, 3]
        distance = np.linalg.norm(np.cross(origin - point, axis))
        if np.linalg.norm(np.cross(z, axis)) > tolerance:
            found.append((i, "z along axis", f"z_{i} must be along the axis of joint {joint}, but is not."))
        elif chain.joint_types[joint - 1] != "P" and distance > tolerance:
            text = f"The origin of frame {i} must lie on the axis of joint {joint}; it is {distance:.3g} m away."
            found.append((i, "origin on axis", text))
    for i in range(1, len(T)):
        # The x of a row is that of the frame after it in the standard convention, and of the frame before it in the modified one.
        own, other = (i, i - 1) if standard else (i - 1, i)
        x, z = T[own, :3, 0], T[other, :3, 2]
        between = T[other, :3, 3] - T[own, :3, 3]
        if abs(float(x @ z)) > tolerance:
            angle = np.degrees(np.arccos(np.clip(x @ z, -1, 1)))
            text = f"x_{own} must be perpendicular to z_{other}; the angle is {angle:.4g} degrees."
            found.append((own, "x perpendicular to z", text))
        elif (gap := abs(float(between @ np.cross(x, z)))) > tolerance:
            text = f"The line of x_{own} must intersect the axis z_{other}; it passes at a distance of {gap:.3g} m."
            found.append((own, "x meets z", f"{text} Is x_{own} on the common normal?"))
    return [Breach(*each) for each in found]
