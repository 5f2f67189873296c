"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

`kinlib.dh.alignment` finds such maps. The poses at random configurations decide, and the map is part of the answer, so it can be
checked again.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_degrees, format_different, format_number, format_vector
from kinlib.arrays.tolerances import EQUIVALENCE_TOL, NEARLY_PARALLEL_RAD, PARALLEL_TOL_RAD, ROUNDING_ERROR
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.alignment import Booleans, Map, nearest_maps, neighbours
from kinlib.dh.parsing import COLUMNS, MAX_LENGTH_M, joint_entries
from kinlib.dh.slips import CHOICES, Fault
from kinlib.dh.table import DHTable, snapped
from kinlib.rigid.lie import homogeneous, log, nearest_rotation, wrap_angle

Verdict = Literal["same", "different", "undecided"]

NEARLY_PARALLEL_LOSS = 1e-5
"""By how much the poses of a right description may be off, on an arm of one metre, if some of its axes are nearly parallel."""

ROUGH = 0.05
"""How far axes may be off, in metres and radians, where the nearest map is sought to describe a difference."""


@dataclass(frozen=True, eq=False, repr=False)
class Equivalence(Map):
    """The answer, with the map between the mechanisms or the reason why there is none; str() says it in words.

    verdict                      "same"; "different"; or "undecided", if the poses differ by more than the tolerance, but axes are
                                 nearly parallel, so that a right description may have lost as many digits
    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry of a pose, over random configurations; inf if no map was found
    reason                       unless they are the same: what differs
    joint_types, tolerance       of the mechanisms, a letter for each joint; and of the comparison

    bool() of it is True or False, and for "undecided" a ValueError, because both would be wrong.
    """

    verdict: Verdict = "same"
    reason: str = ""
    joint_types: str = ""
    tolerance: float = EQUIVALENCE_TOL

    def __bool__(self) -> bool:
        """Whether the two are the same; ValueError if that is undecided."""
        if self.verdict == "undecided":
            raise ValueError(f"The comparison must be decided to be used as True or False. {self.reason}")
        return self.verdict == "same"

    def __repr__(self) -> str:
        return f"Equivalence({self.verdict!r}: {' '.join(str(self).splitlines())})"

    def __str__(self) -> str:
        """Say in words up to which choices the two are the same, or what differs.

        >>> print(equivalent(kl.robots.rpr(), kl.robots.rpr().changed(home=np.eye(4)), fixed=["zeros"]))
        These are the same mechanism, up to these choices of the second:
        tool: rotated by 120° about (0.5774, 0.5774, 0.5774), translated by (-1, 0, 0) m.
        """
        if self.verdict == "same":
            choices = [fault.text for fault in self.choices()]
            of = ", up to these choices of the second:" if choices else "."
            return "\n".join([f"These are the same mechanism{of}", *choices])
        differ = self.verdict == "different"
        words = "These mechanisms differ" if differ else "Whether these are the same cannot be decided"
        return f"{words}. {self.reason}"

    def choices(self, table: DHTable | None = None, names: Collection[str] = CHOICES) -> list[Fault]:
        """Describe the choices of these names in which the two differ; if the first is a table, as corrections of its entries and ends.

        >>> found = equivalent(kl.robots.rpr(), kl.robots.rpr().changed(screws=kl.robots.rpr().screws * [[-1], [1], [1]]))
        >>> found.choices()[0].text
        'joint 1: q counts in the opposite direction.'
        """
        found, accuracy = list[Fault](), min(self.tolerance, max(self.difference, EQUIVALENCE_TOL))
        entries = joint_entries(table.joints if table else self.joint_types.replace("H", "R"))
        for joint, ((row, column), offset) in enumerate(zip(entries, self.offsets, strict=True)):
            place, name, sign = f"joint {joint + 1}", COLUMNS[column], table.signs[row] if table else 1.0
            # Less full turns, which a fit may have made; half a turn is positive.
            value = float(sign * offset if name == "d" else wrap_angle(sign * offset - ROUNDING_ERROR) + ROUNDING_ERROR)
            if "zeros" in names and abs(value) > ROUNDING_ERROR:
                size = f"{format_number(value, 6)} m" if name == "d" else format_degrees(value, 6)
                other = " (or rotate the base by as much about axis 1)" * (joint == 0 and name == "theta")
                text = f"add {size} to {name}{other}" if table else f"its zero is {size} away"
                found.append(Fault(CHOICES["zeros"], f"{place}: {text}.", row + 1, name))
            if "signs" in names and self.signs[joint] < 0:
                write = f"write {'-' if sign > 0 else '+'}q in {name}, because " * bool(table)
                text = f"{place}: {write}q counts in the opposite direction."
                found.append(Fault(CHOICES["signs"], text, row + 1, name))
        base, tool = (table.base, table.tool) if table else (np.eye(4), np.eye(4))
        for name, end, own, T in (
            ("base", "The base T_s0", base, self.base @ base),
            ("tool", "The tool transform", tool, tool @ self.tool),
        ):
            if name in names and (own != T).any():
                is_missing = np.abs(own - np.eye(4)).max() < EQUIVALENCE_TOL
                is_inverted = np.abs(own @ T - np.eye(4)).max() < 1e-6  # as a person types it
                what = "is missing" if is_missing else "is inverted" if is_inverted else "is wrong"
                what = f"{end} {what}: it should be" if table else f"{name}:"
                found.append(Fault(CHOICES[name], f"{what} {describe_pose(T, accuracy)}."))
        return found


def describe_pose(T: Array, tolerance: float = ROUNDING_ERROR) -> str:
    """Describe a pose: axis and angle of its rotation, and its translation, without the digits that are below the tolerance.

    >>> describe_pose(np.diag([-1.0, -1, 1, 1])), describe_pose(np.eye(4))
    ('rotated by 180° about z', 'the identity')
    """
    omega, p = log(T[:3, :3]), T[:3, 3]
    angle, parts = float(np.linalg.norm(omega)), []
    if angle > ROUNDING_ERROR:
        axis = omega / angle
        largest = int(np.argmax(np.abs(axis)))
        about = format_vector(axis)
        if np.abs(axis[largest]) > 1 - 1e-9:
            about, angle = "xyz"[largest], math.copysign(angle, axis[largest] if angle < math.pi - 1e-9 else 1.0)
        parts.append(f"rotated by {format_number(math.degrees(angle), 6)}° about {about}")
    if np.abs(p).max() > ROUNDING_ERROR:
        parts.append(f"translated by {format_vector(p.round(max(0, math.ceil(-math.log10(tolerance)))), 6)} m")
    return ", ".join(parts) or "the identity"


def measured_difference(one: Chain, other: Chain) -> tuple[float, float]:
    """Measure by how much the poses of two chains differ for the same q: the largest distance in metres, and angle in radians.

    >>> measured_difference(kl.robots.rpr(), kl.robots.rpr())
    (0.0, 0.0)
    """
    q = random_configurations(one.n, 1000)
    T, U = one.fk(q), other.fk(q)
    angles = np.linalg.norm(log(np.swapaxes(T[:, :3, :3], -1, -2) @ U[:, :3, :3]), axis=-1)
    return float(np.linalg.norm(T[:, :3, 3] - U[:, :3, 3], axis=-1).max()), float(angles.max())


def equivalent(
    a: Chain | DHTable, b: Chain | DHTable, *, fixed: Collection[str] = (), tolerance: float = EQUIVALENCE_TOL
) -> Equivalence:
    """Decide whether two descriptions have the same motions, up to base, tool, joint zero and joint sign.

    a, b are chains, or tables in either convention. The position of a prismatic axis has no effect, because it has no line.
    fixed  what may not differ: any of "base", "tool", "zeros" and "signs", for example ["tool"]

    If axes of the arm are nearly parallel, a table that was derived from them has lost digits; what differs by no more than that
    is "undecided". Of several maps, the one with the shortest description is returned: the fewest changes.

    >>> equivalent(kl.robots.puma560(), kl.assign_frames(kl.robots.puma560(), convention="standard").table).verdict
    'same'
    """
    for name, arm in (("a", a), ("b", b)):
        validation.instance(arm, name, Chain, DHTable)
    if not tolerance > 0:
        raise ValueError(f"tolerance must be a positive number, in metres and radians; got {tolerance!r}.")
    if isinstance(fixed, str) or not set(fixed) <= set(CHOICES):
        raise ValueError(f"fixed must be names from {', '.join(CHOICES)}; got {fixed!r:.80}. Try fixed=[...].")
    one, other = (arm.to_chain() if isinstance(arm, DHTable) else arm for arm in (a, b))
    letters = one.joint_types
    if letters != other.joint_types:
        types = f"The joint types differ: {letters} in the first, {other.joint_types} in the second."
        return Equivalence(verdict="different", reason=types)
    angles = np.array([neighbours(one)[0], neighbours(other)[0]])
    near: Booleans = np.any((angles > PARALLEL_TOL_RAD) & (angles < NEARLY_PARALLEL_RAD), axis=0)
    loose = max(10 * tolerance, NEARLY_PARALLEL_LOSS * near.any())
    found = nearest_maps(one, other, frozenset(fixed), tolerance, loose)
    verdict: Verdict = "same"
    reason = ""
    if same := [each for each in found if each.difference <= tolerance]:
        best = min((_without_noise(each, letters, tolerance) for each in same), key=_description_length)
    else:
        best = min(found, key=lambda each: each.difference)
        size = 1 + max(np.abs(np.append(arm.joint_points, arm.home[None, :3, 3], axis=0)).max() for arm in (one, other))
        is_lost = near.any() and (best.difference <= NEARLY_PARALLEL_LOSS * size or len(found) > 1)
        verdict = "undecided" if is_lost else "different"
        reason = _largest_axis_difference(one, other, near, tolerance)
        if is_lost:
            reason = (
                f"The poses differ by {best.difference:.1e} under the nearest map that was found, and a better one is not excluded, "
                f"because axes {np.argmax(near) + 1} and {np.argmax(near) + 2} are nearly parallel."
            )
    return Equivalence(**vars(best), verdict=verdict, reason=reason, joint_types=letters, tolerance=tolerance)


def _without_noise(found: Map, joint_types: str, tolerance: float) -> Map:
    """Return a map whose angles are right angles, and whose numbers are 0, where this is within the tolerance."""
    units = np.where([letter == "P" for letter in joint_types], MAX_LENGTH_M, np.pi / 2)
    ends = np.array([found.base, found.tool])
    R = nearest_rotation(snapped(ends[:, :3, :3], 1, min(tolerance, 0.02)))  # of frames with parallel axes
    base, tool = homogeneous(R, snapped(ends[:, :3, 3], MAX_LENGTH_M, tolerance))
    return replace(found, offsets=snapped(found.offsets, units, tolerance), base=base, tool=tool)


def _description_length(found: Map) -> tuple[int, float]:
    """Count the changes that a map without noise makes, and measure how far base and tool are from the identity."""
    distances = [float(np.abs(T - np.eye(4)).sum()) for T in (found.base, found.tool)]
    return int(np.count_nonzero([*(found.signs < 0), *found.offsets, *distances])), sum(distances)


def _largest_axis_difference(one: Chain, other: Chain, is_near: Booleans, tolerance: float) -> str:
    """Describe the pair of neighbouring axes whose angle or distance differs most, if they do not all agree."""
    values = np.array([neighbours(one), neighbours(other)])
    difference = np.abs(values[1] - values[0])
    slides = np.array([*one.joint_types]) == "P"
    difference[1, is_near | slides[:-1] | slides[1:]] = 0.0
    if difference.max(initial=0.0) <= tolerance:
        agree = "The angles and the distances of neighbouring axes agree"
        return f"{agree}; what differs is a distance along an axis, or a choice that is fixed."
    kind, i = np.unravel_index(difference.argmax(), difference.shape)
    first, second = format_different(*(values[:, kind, i] * (1.0 if kind else 180 / np.pi)).tolist())
    if kind:
        return f"Axes {i + 1} and {i + 2} are {first} m apart in the first, and {second} m in the second."
    return f"Axes {i + 1} and {i + 2} make an angle of {first} degrees in the first, and of {second} degrees in the second."
