"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The motions decide. First the poses are compared as they are; then under the maps that the axes admit, which
`kinlib.chains.joint_maps` finds. A map is checked at random configurations, so a positive answer is never wrong; it includes X, Y,
s and c, so it can be checked again. Only what no map makes equal is explained, by the first angle or length that differs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, Literal

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_different
from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    INTERMEDIATE_TOL_FACTOR,
    PARALLEL_TOL_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.chains.joint_maps import JointMap, identity_map, joint_maps
from kinlib.dh.invariants import AxisInvariants, neighbours
from kinlib.dh.mistakes import THETA, D, format_entry
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import log

ILL_CONDITIONED_ABOVE = 1e-3
"""If poses are known only to this fraction of the tolerance, the axes alone prove nothing."""

LOOSENED = (1, 100)
"""How many times the usual bound the axes may be off in a search, if some are nearly parallel; tried in turn."""

EPS = float(np.finfo(float).eps)

CHOICES = ("base", "tool", "zeros", "signs")
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint."""


Verdict = Literal["same", "different", "undecided"]


@dataclass(frozen=True, eq=False, repr=False)
class Equivalence:
    """The answer, with the map between the mechanisms or the reason why there is none; str() says it in words.

    verdict                      "same"; "different"; or "undecided", if the poses differ by more than the tolerance, but by no
                                 more than a right description may, because axes are nearly parallel
    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry of a pose, over random configurations; inf if no map was found
    accuracy                     how far the poses of a right description may be off
    reason                       unless they are the same: what differs, and the tolerance with which the answer would be "same"
    joint_types, tolerance       of the mechanisms, a letter for each joint; and of the comparison

    bool() of it is True or False, and for "undecided" a ValueError, because both would be wrong.
    """

    verdict: Verdict
    base: Array = field(default_factory=lambda: np.eye(4))
    tool: Array = field(default_factory=lambda: np.eye(4))
    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    difference: float = np.inf
    accuracy: float = 0.0
    explain: Callable[[], str] = str
    joint_types: str = ""
    tolerance: float = EQUIVALENCE_TOL

    def __post_init__(self) -> None:
        for name in ("base", "tool", "signs", "offsets"):
            object.__setattr__(self, name, validation.read_only_copy(getattr(self, name)))

    def __bool__(self) -> bool:
        """Whether the two are the same.

        Raises ValueError if that is undecided.
        """
        if self.verdict == "undecided":
            raise ValueError(f"The comparison must be decided to be used as True or False. {self.reason}")
        return self.verdict == "same"

    def __repr__(self) -> str:
        return f"Equivalence({self.verdict!r}: {' '.join(str(self).splitlines())})"

    def __str__(self) -> str:
        """Say in words up to which choices the two are the same, or what differs.

        >>> from kinlib.chains.robots import rpr
        >>> print(equivalent(rpr(), rpr().changed(home=np.eye(4)), fixed=["zeros"]))
        These are the same mechanism, up to these choices:
        The tool frames differ: rotated by 120 degrees, translated by 1 m.
        """
        if self.verdict == "same":
            choices = [text for _, text in self.choices(self.tolerance)]
            return "\n".join([f"These are the same mechanism{', up to these choices:' if choices else '.'}", *choices])
        words = (
            "These mechanisms differ" if self.verdict == "different" else "Whether these are the same cannot be decided"
        )
        return f"{words}. {self.reason}"

    def choices(self, tolerance: float) -> list[tuple[str, str]]:
        """Describe the choices in which the two differ by more than the tolerance, each with its name in `fixed`.

        >>> from kinlib.chains.robots import rpr
        >>> found = equivalent(rpr(), rpr().changed(screws=rpr().screws * [[-1], [1], [1]]))
        >>> found.choices(1e-8)
        [('signs', 'Joint 1 has the opposite sign.')]
        """
        found = []
        for joint, (letter, sign, offset) in enumerate(
            zip(self.joint_types, self.signs, self.offsets, strict=True), start=1
        ):
            distance = (offset + np.pi) % (2 * np.pi) - np.pi if letter == "R" else offset
            if sign < 0:
                found.append(("signs", f"Joint {joint} has the opposite sign."))
            if abs(distance) > tolerance:
                away = f"{format_entry(offset, D)} m" if letter == "P" else format_entry(offset, THETA)
                found.append(("zeros", f"Joint {joint} has another zero, {away} away."))
        for name, T in (("base", self.base), ("tool", self.tool)):
            if np.abs(T - np.eye(4)).max() > tolerance:
                found.append((name, f"The {name} frames differ: {describe_pose(T)}."))
        return found

    @cached_property
    def reason(self) -> str:
        """Why the verdict is not "same"; computed when it is read, because that takes longer than the verdict."""
        return self.explain()


def equivalent(
    a: Chain | DHTable, b: Chain | DHTable, *, fixed: Collection[str] = (), tolerance: float = EQUIVALENCE_TOL
) -> Equivalence:
    """Decide whether two descriptions have the same motions, up to base, tool, joint zero and joint sign.

    a, b are chains, or tables in either convention. The position of a prismatic axis has no effect, because it has no line.
    fixed  what may not differ: any of "base", "tool", "zeros" and "signs", for example ["tool"]

    If axes of the arm are nearly parallel, a table that was derived from them has lost digits; what differs by no more than that
    is "undecided". Of several maps, the one with the shortest description is returned.

    Raises ValueError for anything but chains and tables, for a tolerance that is not positive, and for a name in fixed that is none
    of the four.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> equivalent(puma560(), assign_frames(puma560(), convention="standard").table).verdict
    'same'
    """
    for name, arm in (("a", a), ("b", b)):
        validation.instance(arm, name, Chain, DHTable)
    if not tolerance > 0:
        raise ValueError(f"tolerance must be a positive number, in metres and radians; got {tolerance!r}.")
    if isinstance(fixed, str) or not set(fixed) <= set(CHOICES):
        advice = f' Try fixed=["{fixed}"].' if isinstance(fixed, str) and fixed in CHOICES else ""
        raise ValueError(f"fixed must be a collection of names from {', '.join(CHOICES)}; got {fixed!r:.80}.{advice}")
    one, other = (arm.to_chain() if isinstance(arm, DHTable) else arm for arm in (a, b))
    if one.joint_types != other.joint_types:
        types = f"The joint types differ: {one.joint_types} in the first, {other.joint_types} in the second."
        return Equivalence("different", explain=lambda: types)

    # 1. Motion: the poses as they are.
    answer = partial(_answer, joint_types=one.joint_types, tolerance=tolerance)
    found = [identity_map(one, other)]
    if found[0].difference <= tolerance:
        return answer("same", found[0])

    # 2. Motion under each map that the axes admit, unless an angle or a length that no map changes is another one.
    # Tables are derived from arms: how nearly parallel the axes of the arm are decides how accurate a table of it can be.
    arms = [arm for arm in (a, b) if isinstance(arm, Chain)] or [one, other]
    accuracy = max(map(derived_accuracy, arms))
    is_ill_conditioned = accuracy > ILL_CONDITIONED_ABOVE * tolerance
    loose = INTERMEDIATE_TOL_FACTOR * max(tolerance, accuracy)
    is_another = _has_other_invariants(one, other, loose)
    for factor in () if is_another else LOOSENED[: 1 + is_ill_conditioned]:
        found += joint_maps(one, other, frozenset(fixed), factor * loose)
        if same := [each for each in found if each.difference <= tolerance]:
            return answer("same", min(same, key=lambda each: _description_length(each, tolerance)), accuracy)

    # 3. Geometry says what differs.
    nearest = min(found, key=lambda each: each.difference)
    is_proved = is_another or not is_ill_conditioned or set(fixed) == set(CHOICES)
    if nearest.difference <= accuracy or not (is_proved or _first_difference(one, other, tolerance + accuracy)):
        return answer("undecided", nearest, accuracy, partial(_why_undecided, one, nearest.difference, accuracy))
    why = partial(_why_different, one, other, frozenset(fixed), tolerance)
    return Equivalence("different", difference=nearest.difference, accuracy=accuracy, explain=why)


def _answer(
    verdict: Verdict, found: JointMap, accuracy: float = 0.0, explain: Callable[[], str] = str, **context: Any
) -> Equivalence:
    map_and_difference = found.base, found.tool, found.signs, found.offsets, found.difference
    return Equivalence(verdict, *map_and_difference, accuracy, explain, **context)


def describe_pose(T: Array) -> str:
    """Say how far a pose is from the identity.

    >>> describe_pose(np.diag([-1.0, -1, 1, 1]))
    'rotated by 180 degrees, translated by 0 m'
    """
    degrees, metres = np.degrees(np.linalg.norm(log(T[:3, :3]))), np.linalg.norm(T[:3, 3])
    # Rounding removes errors such as 1e-17.
    return f"rotated by {round(float(degrees), 6):.4g} degrees, translated by {round(float(metres), 9):.4g} m"


def _has_other_invariants(one: Chain, other: Chain, loose: float) -> bool:
    """Whether an angle or a length that no choice can change differs."""
    invariants = AxisInvariants(other, loose / (1 - CLEARLY_NOT_PARALLEL_COS))
    # The frames of nearly parallel axes are far away, so the points that are compared are those next to the tool.
    points = one.joint_points + one.lines.axis * np.sum(
        one.lines.axis * (one.home[:3, 3] - one.joint_points), axis=1, keepdims=True
    )
    return bool(invariants.violated(invariants.of(one.lines.axis, points)).any())


def derived_accuracy(arm: Chain) -> float:
    """Estimate how accurate the poses of a description are that was derived from the axes of an arm, in metres and radians.

        4 reach sum_i min(s_i, 4 eps / s_i) + 16 eps size

    s_i is the sine of the angle between axes i and i+1. A description of two nearly parallel axes either takes them as parallel,
    which is wrong by s, or takes their common normal, whose direction has lost 1 / s of its digits. The factors were measured
    with tables of `assign_frames`.

    >>> from kinlib.chains.robots import puma560
    >>> derived_accuracy(puma560()) < 1e-13
    True
    """
    reach = 1 + np.linalg.norm(np.cross(arm.home[:3, 3] - arm.lines.point, arm.lines.axis), axis=1).max()
    return float(4 * reach * _lost_by_pairs(arm).sum() + 16 * EPS * max(np.abs(arm.joint_points).max(), reach))


def _lost_by_pairs(arm: Chain) -> Array:
    """What the description of each pair of neighbouring axes loses, (n - 1,): min(s, 4 eps / s)."""
    sine = neighbours(arm.lines).sine
    return np.minimum(sine, 4 * EPS / np.maximum(sine, EPS))


def _description_length(result: JointMap, tolerance: float) -> tuple[int, float]:
    """Count the differences that a map consists of (signs, zeros, base, tool), and how far base and tool are from identity."""
    distances = [float(np.abs(T - np.eye(4)).sum()) for T in (result.base, result.tool)]
    joints = np.sum(result.signs < 0) + np.sum(np.abs(result.offsets) > tolerance)
    return int(joints + sum(distance > tolerance for distance in distances)), sum(distances)


def _why_undecided(arm: Chain, difference: float, accuracy: float) -> str:
    pair = int(np.argmax(_lost_by_pairs(arm)))
    cause = "the coordinates are large"
    if (sine := neighbours(arm.lines).sine[pair]) > PARALLEL_TOL_RAD:
        cause = f"axes {pair + 1} and {pair + 2} are nearly parallel, {sine:.1e} rad apart"
    if difference > accuracy:
        return (
            f"Each map that was found leaves a difference of {difference:.1e} or more, but a better one is not excluded, because "
            f"{cause}."
        )
    return (
        f"The poses differ by {difference:.1e}, and those of a right description may be off by {accuracy:.1e}, because {cause}. "
        f"With tolerance={_rounded_up(difference):g} the two are the same."
    )


def _why_different(one: Chain, other: Chain, fixed: frozenset[str], tolerance: float) -> str:
    """Describe the first difference, and offer the tolerance with which the two would be the same, if there is a small one."""
    reason = _first_difference(one, other, tolerance) or (
        "Each pair of neighbouring axes agrees, but no rotation of the joints aligns all of them at once."
    )
    for power in range(math.ceil(np.log10(tolerance) + 1e-9), -1):
        found = equivalent(one, other, fixed=fixed, tolerance=10.0**power)
        if found.verdict == "same":
            offered = min(_rounded_up(found.difference), 10.0**power)
            return f"{reason} With tolerance={offered:g} the two are the same."
    return reason


def _rounded_up(value: float) -> float:
    """Round a positive number up to one digit more than it needs, so that it is a tolerance with which the value passes."""
    unit = 10.0 ** math.floor(math.log10(value))
    return float(f"{(math.floor(value / unit) + 1) * unit:.0e}")


def _first_difference(one: Chain, other: Chain, tolerance: float) -> str:
    """Describe the first pair of neighbouring axes whose angle or distance differs, which a person would check first; "" if none."""
    here, there = neighbours(one.lines), neighbours(other.lines)
    size = 1 + np.abs([one.lines.point, other.lines.point]).max(axis=(0, 2))
    rounding = 16 * EPS * np.maximum(size[:-1], size[1:]) / np.maximum(np.sin(here.angle), PARALLEL_TOL_RAD)
    for i in range(one.n - 1):
        if abs(here.angle[i] - there.angle[i]) > tolerance:
            first, second = format_different(*np.degrees([here.angle[i], there.angle[i]]))
            return f"Axes {i + 1} and {i + 2} make an angle of {first} degrees in the first, and of {second} degrees in the second."
        is_far = abs(here.distance[i] - there.distance[i]) > tolerance + rounding[i]
        if is_far and "P" not in one.joint_types[i : i + 2]:
            first, second = format_different(here.distance[i], there.distance[i])
            return f"Axes {i + 1} and {i + 2} are {first} m apart in the first, and {second} m in the second."
    return ""
