"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The motions decide. First the poses are compared as they are; then under the maps that the axes admit, which
`kinlib.dh.joint_maps` finds. A map is checked at random configurations, and it is part of the answer, so it can be checked again.
What no map makes equal is explained by the angle or the length that differs most.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import pairwise
from typing import Literal

import numpy as np

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_different, format_number, format_vector
from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    INTERMEDIATE_TOL_FACTOR,
    NEARLY_PARALLEL_RAD,
    PARALLEL_TOL_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, random_configurations
from kinlib.dh.invariants import AxisInvariants, Booleans
from kinlib.dh.joint_maps import CHOICES, JointMap, identity_map, joint_maps
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import cross, log
from kinlib.rigid.screw import Line

NEARLY_PARALLEL_LOSS = 1e-5
"""By how much the poses of a right description may be off, on an arm of one metre, if some of its axes are nearly parallel."""

MEASURED_CONFIGURATIONS = 1000
"""At how many random configurations a difference of poses that is told was measured."""

Verdict = Literal["same", "different", "undecided"]


@dataclass(frozen=True, eq=False, repr=False)
class Equivalence:
    """The answer, with the map between the mechanisms or the reason why there is none; str() says it in words.

    verdict                      "same"; "different"; or "undecided", if the poses differ by more than the tolerance, but axes are
                                 nearly parallel, so that a right description may have lost as many digits
    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry of a pose, over random configurations; inf if no map was found
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
        These are the same mechanism, up to these choices of the second:
        tool: rotated by 120° about (0.5774, 0.5774, 0.5774), translated by (-1, 0, 0) m
        """
        if self.verdict == "same":
            choices = [text for _, text in self.choices(self.tolerance)]
            of = ", up to these choices of the second:" if choices else "."
            return "\n".join([f"These are the same mechanism{of}", *choices])
        words = (
            "These mechanisms differ" if self.verdict == "different" else "Whether these are the same cannot be decided"
        )
        return f"{words}. {self.reason}"

    def choices(self, tolerance: float) -> list[tuple[str, str]]:
        """Describe the choices in which the two differ by more than the tolerance, each with its name in `fixed`.

        >>> from kinlib.chains.robots import rpr
        >>> found = equivalent(rpr(), rpr().changed(screws=rpr().screws * [[-1], [1], [1]]))
        >>> found.choices(1e-8)
        [('signs', 'joint 1: q counts in the opposite direction')]
        """
        found = []
        for joint, letter in enumerate(self.joint_types, start=1):
            sign, offset = self.signs[joint - 1], float(self.offsets[joint - 1])
            if sign < 0:
                found.append(("signs", f"joint {joint}: q counts in the opposite direction"))
            text = format_offset(letter, offset, tolerance)
            if text:
                found.append(("zeros", f"joint {joint}: its zero is {text} away"))
        for name, T in (("base", self.base), ("tool", self.tool)):
            if (text := describe_pose(T, tolerance)) != "the identity":
                found.append((name, f"{name}: {text}"))
        return found

    @cached_property
    def reason(self) -> str:
        """Why the verdict is not "same"; computed when it is read, because that takes longer than the verdict."""
        return self.explain()


def format_offset(letter: str, offset: float, tolerance: float) -> str:
    """Write the offset of a joint, less full turns; "" if it is below the tolerance.

    >>> format_offset("R", 3 * np.pi / 2, 1e-8), format_offset("P", 0.25, 1e-8), format_offset("R", 2 * np.pi, 1e-8)
    ('-90°', '0.25 m', '')
    """
    value = offset if letter == "P" else math.pi - (math.pi - offset + 1e-9) % (2 * math.pi) + 1e-9
    if abs(value) <= tolerance:
        return ""
    return f"{format_number(value, 6)} m" if letter == "P" else f"{format_number(math.degrees(value), 6, zero=1e-6)}°"


def describe_pose(T: Array, tolerance: float = 0.0) -> str:
    """Describe a pose: axis and angle of its rotation, and its translation, without what is below the tolerance.

    >>> describe_pose(np.diag([-1.0, -1, 1, 1])), describe_pose(np.eye(4))
    ('rotated by 180° about z', 'the identity')
    """
    omega, p = log(T[:3, :3]), T[:3, 3]
    angle, parts = float(np.linalg.norm(omega)), []
    if angle > max(tolerance, 1e-9):
        axis = np.where(np.abs(omega) <= max(tolerance, 1e-9), 0.0, omega) / angle
        largest = int(np.argmax(np.abs(axis)))
        if np.abs(axis[largest]) > 1 - 1e-9:
            about, angle = "xyz"[largest], math.copysign(angle, axis[largest] if angle < math.pi - 1e-9 else 1.0)
        else:
            about = format_vector(axis)
        parts.append(f"rotated by {format_number(math.degrees(angle), 6)}° about {about}")
    if np.abs(p).max() > max(tolerance, 1e-9):
        # Below the tolerance, digits are noise.
        decimals = 9 if tolerance < 1e-9 else max(0, math.ceil(-math.log10(tolerance)))
        parts.append(f"translated by {format_vector(np.where(np.abs(p) <= tolerance, 0.0, p.round(decimals)), 6)} m")
    return ", ".join(parts) or "the identity"


def measured_difference(one: Chain, other: Chain) -> tuple[float, float]:
    """Measure by how much the poses of two chains differ for the same q: the largest distance in metres, and angle in radians.

    >>> from kinlib.chains.robots import rpr
    >>> measured_difference(rpr(), rpr())
    (0.0, 0.0)
    """
    q = random_configurations(one.n, MEASURED_CONFIGURATIONS)
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

    def answer(verdict: Verdict, found: JointMap, explain: Callable[[], str] = str) -> Equivalence:
        parts = found.base, found.tool, found.signs, found.offsets, found.difference
        return Equivalence(verdict, *parts, explain, one.joint_types, tolerance)

    # 1. Motion: the poses as they are.
    found = [identity_map(one, other)]
    if found[0].difference <= tolerance:
        return answer("same", found[0])

    # 2. Motion under each map that the axes admit, unless an angle or a length that no map changes is another one.
    loose = INTERMEDIATE_TOL_FACTOR * tolerance
    near = _nearly_parallel(one) | _nearly_parallel(other)
    is_another = _has_other_invariants(one, other, max(loose, 10 * NEARLY_PARALLEL_LOSS if near.any() else 0.0))
    if not is_another:
        within = max(loose, NEARLY_PARALLEL_LOSS if near.any() else 0.0)
        found += joint_maps(one, other, frozenset(fixed), within, tolerance=tolerance)
        if same := [each for each in found if each.difference <= tolerance]:
            shortest = min(same, key=lambda each: description_length(each, tolerance))
            return answer("same", shortest)

    # 3. Geometry says what differs.
    nearest = min(found, key=lambda each: each.difference)
    size = 1 + max(np.abs(np.append(arm.joint_points, arm.home[None, :3, 3], axis=0)).max() for arm in (one, other))
    is_lost = nearest.difference <= NEARLY_PARALLEL_LOSS * size or set(fixed) < set(CHOICES)
    if near.any() and not is_another and is_lost:
        return answer("undecided", nearest, partial(_why_undecided, one, other, nearest.difference))
    why = partial(_why_different, one, other, frozenset(fixed), tolerance)
    return Equivalence("different", difference=nearest.difference, explain=why)


def description_length(result: JointMap | Equivalence, tolerance: float) -> tuple[int, float]:
    """Count the differences that a map consists of (signs, zeros, base, tool), and how far base and tool are from identity.

    >>> from kinlib.chains.robots import rpr
    >>> description_length(equivalent(rpr(), rpr()), 1e-9)
    (0, 0.0)
    """
    distances = [float(np.abs(T - np.eye(4)).sum()) for T in (result.base, result.tool)]
    joints = np.sum(result.signs < 0) + np.sum(np.abs(result.offsets) > tolerance)
    return int(joints + sum(distance > tolerance for distance in distances)), sum(distances)


def _nearly_parallel(chain: Chain) -> Booleans:
    """Which pairs of neighbouring axes are nearly parallel, (n - 1,): a description of them has lost digits."""
    sine = neighbours(chain.lines)[0]
    near: Booleans = (sine > PARALLEL_TOL_RAD) & (sine < NEARLY_PARALLEL_RAD)
    return near


def _has_other_invariants(one: Chain, other: Chain, loose: float) -> bool:
    """Whether an angle or a length that no choice can change differs."""
    invariants = AxisInvariants(other, loose / (1 - CLEARLY_NOT_PARALLEL_COS))
    # The frames of nearly parallel axes are far away, so the points that are compared are those next to the tool.
    points = one.joint_points + one.lines.axis * np.sum(
        one.lines.axis * (one.home[:3, 3] - one.joint_points), axis=1, keepdims=True
    )
    return bool(invariants.violated(invariants.of(one.lines.axis, points)).any())


def neighbours(lines: Line) -> tuple[Array, Array, Array]:
    """Compute how each axis lies to the next one, (n - 1,) each.

    Returns the sine of the angle between them, the acute angle in radians, and the length of their common normal in metres.

    >>> from kinlib.chains.robots import youbot
    >>> neighbours(youbot().lines)[2]
    array([0.033, 0.155, 0.135, 0.   ])
    """
    u, v, between = lines.axis[:-1], lines.axis[1:], np.diff(lines.point, axis=0)
    normal = cross(u, v)
    sine = np.linalg.norm(normal, axis=-1)
    is_parallel = sine <= PARALLEL_TOL_RAD
    along_normal = np.abs(np.sum(between * normal, axis=-1)) / np.where(is_parallel, 1.0, sine)
    distance = np.where(is_parallel, np.linalg.norm(cross(between, u), axis=-1), along_normal)
    return sine, np.arctan2(sine, np.abs(np.sum(u * v, axis=-1))), distance


def _why_undecided(one: Chain, other: Chain, difference: float) -> str:
    pair = int(np.argmax(_nearly_parallel(one) | _nearly_parallel(other)))
    sine = max(neighbours(arm.lines)[0][pair] for arm in (one, other))
    return (
        f"The poses differ by {difference:.1e} under the nearest map that was found, and a better one is not excluded, because axes "
        f"{pair + 1} and {pair + 2} are nearly parallel, {sine:.1e} rad apart."
        + (f" With tolerance={_rounded_up(difference):g} the two are the same." if difference < 1e-3 else "")
    )


def _why_different(one: Chain, other: Chain, fixed: frozenset[str], tolerance: float) -> str:
    """Describe the largest difference, and offer the tolerance with which the two would be the same, if there is a small one."""
    reason = _largest_axis_difference(one, other, tolerance) or (
        "The angles and the distances of neighbouring axes agree; what differs is a distance along an axis, or a choice that is fixed."
    )
    for power in range(math.ceil(np.log10(tolerance) + 1e-9), -1):
        found = equivalent(one, other, fixed=fixed, tolerance=10.0**power)
        if found.verdict == "same":
            offered = min(_rounded_up(found.difference), 10.0**power)
            return f"{reason} With tolerance={offered:g} the two are called the same."
    return reason


def _rounded_up(value: float) -> float:
    """Round a positive number up to one digit more than it needs, so that it is a tolerance with which the value passes."""
    unit = 10.0 ** math.floor(math.log10(value))
    return float(f"{(math.floor(value / unit) + 1) * unit:.0e}")


def _largest_axis_difference(one: Chain, other: Chain, tolerance: float) -> str:
    """Describe the pair of neighbouring axes whose angle or distance differs most; "" if they all agree."""
    here, there = neighbours(one.lines), neighbours(other.lines)
    is_near = _nearly_parallel(one) | _nearly_parallel(other)
    found = [(0.0, "")]
    for i, _ in enumerate(pairwise(one.joint_types)):
        angles, distances = (here[1][i], there[1][i]), (here[2][i], there[2][i])
        if (off := abs(angles[0] - angles[1])) > tolerance:
            first, second = format_different(*map(math.degrees, angles))
            text = f"Axes {i + 1} and {i + 2} make an angle of {first} degrees in the first, and of {second} degrees in the second."
            found.append((float(off), text))
        off = abs(distances[0] - distances[1])
        if off > tolerance and "P" not in one.joint_types[i : i + 2] and not is_near[i]:
            first, second = format_different(*distances)
            text = f"Axes {i + 1} and {i + 2} are {first} m apart in the first, and {second} m in the second."
            found.append((float(off), text))
    return max(found)[1]
