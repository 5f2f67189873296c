"""Decide whether two descriptions are the same mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The invariants of the axes decide the signs. Frames along the common normals then give the offsets: in each chain, the angle about
axis k from the normal before it to the normal after it; c_k is the difference. What remains, base, tool and the zeros of prismatic
joints, is linear, so a least-squares step on the poses finds it. The poses at random configurations decide, and the map is part of
the answer, so it can be checked again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from kinlib.arrays import validation
from kinlib.arrays.formatting import format_different, format_number, format_vector
from kinlib.arrays.tolerances import (
    CLEARLY_NOT_PARALLEL_COS,
    EQUIVALENCE_TOL,
    NEARLY_PARALLEL_RAD,
    PARALLEL_TOL_RAD,
    SAME_DISTANCE_RAD,
)
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.table import DHTable
from kinlib.rigid.angles import wrap_angle
from kinlib.rigid.lie import adjoint, cross, exp, hat, homogeneous, inverse, log, perpendicular, vee

Booleans = NDArray[np.bool_]

CHOICES = ("base", "tool", "zeros", "signs")
"""What two descriptions of one mechanism may choose: the frames at both ends, the zero and the sign of each joint."""

COMPARED_CONFIGURATIONS, MEASURED_CONFIGURATIONS = 16, 1000
"""At how many random configurations chains are compared, and a difference of poses that is told is measured."""

NEARLY_PARALLEL_LOSS = 1e-5
"""By how much the poses of a right description may be off, on an arm of one metre, if some of its axes are nearly parallel."""

SEARCHED_AS_PARALLEL_RAD, PARALLEL_COS, MAX_ROTATION_OF_FIXED = 2e-5, 1 - 1e-9, 0.1
"""Axes at a smaller angle are searched as parallel ones; a joint that is fixed may be off by so many radians before the search."""

ROUGH = 0.05
"""How far axes may be off, in metres and radians, where the nearest map is sought to describe a difference."""

MAX_OFFERED_TOL = 1e-2
"""No tolerance above this, in metres and radians, is offered as one with which two arms are the same."""

MAX_JOINTS = 9
"""Of so many joints all signs are tried, and of more joints at most two with the sign -1."""

MAX_MAPS, EXACT, MAX_STEPS, LARGEST_STEP = 4, 1e-12, 6, 1e3
"""How many maps are compared; and a map whose poses differ by more is improved, in so many steps, none longer than the last."""


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

    verdict: Literal["same", "different", "undecided"]
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
        differ = self.verdict == "different"
        words = "These mechanisms differ" if differ else "Whether these are the same cannot be decided"
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
            if self.signs[joint - 1] < 0:
                found.append(("signs", f"joint {joint}: q counts in the opposite direction"))
            if text := format_offset(letter, float(self.offsets[joint - 1]), tolerance):
                found.append(("zeros", f"joint {joint}: its zero is {text} away"))
        for name, T in (("base", self.base), ("tool", self.tool)):
            if (text := describe_pose(T, tolerance)) != "the identity":
                found.append((name, f"{name}: {text}"))
        return found

    @cached_property
    def reason(self) -> str:
        """Why the verdict is not "same"; computed when it is read, because that takes longer than the verdict."""
        return self.explain()

    def poses(self, one: Chain, q: Array) -> Array:
        """Compute X T_a(s q + c) Y, for q (..., n).

        >>> from kinlib.chains.robots import rpr
        >>> equivalent(rpr(), rpr()).poses(rpr(), np.zeros(3)).shape
        (4, 4)
        """
        return np.asarray(self.base @ one.fk(self.signs * q + self.offsets) @ self.tool)


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
    least = max(tolerance, 1e-9)
    omega, p = log(T[:3, :3]), T[:3, 3]
    angle, parts = float(np.linalg.norm(omega)), []
    if angle > least:
        axis = np.where(np.abs(omega) <= least, 0.0, omega) / angle
        largest = int(np.argmax(np.abs(axis)))
        about = format_vector(axis)
        if np.abs(axis[largest]) > 1 - 1e-9:
            about, angle = "xyz"[largest], math.copysign(angle, axis[largest] if angle < math.pi - 1e-9 else 1.0)
        parts.append(f"rotated by {format_number(math.degrees(angle), 6)}° about {about}")
    if np.abs(p).max() > least:
        # Below the tolerance, digits are noise.
        shown = np.where(np.abs(p) <= tolerance, 0.0, p.round(max(0, math.ceil(-math.log10(least)))))
        parts.append(f"translated by {format_vector(shown, 6)} m")
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
    is "undecided". Of several maps, the one with the shortest description is returned: the fewest changes.

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
    near = _nearly_parallel(one, other)
    same_q = Equivalence("same", signs=np.ones(one.n), offsets=np.zeros(one.n), joint_types=one.joint_types)
    found = [_measured(same_q, one, other)]
    if found[0].difference > tolerance and len({*fixed}) < len(CHOICES):
        loose = max(10 * tolerance, NEARLY_PARALLEL_LOSS * near.any())
        found += nearest_maps(one, other, frozenset(fixed), loose, tolerance)
    same = [each for each in found if each.difference <= tolerance]
    if same:
        return replace(min(same, key=lambda each: _description_length(each, tolerance)), tolerance=tolerance)
    best = replace(min(found, key=lambda each: each.difference), tolerance=tolerance)
    size = 1 + max(np.abs(np.append(arm.joint_points, arm.home[None, :3, 3], axis=0)).max() for arm in (one, other))
    is_lost = best.difference <= NEARLY_PARALLEL_LOSS * size or len(found) > 1
    if near.any() and is_lost:
        return replace(best, verdict="undecided", explain=lambda: _why_undecided(near, best.difference))
    return replace(best, verdict="different", explain=lambda: _why_different(one, other, frozenset(fixed), best))


def _description_length(found: Equivalence, tolerance: float) -> tuple[int, float]:
    """Count the changes that a map makes (signs, zeros, base, tool), and measure how far base and tool are from identity."""
    distances = [float(np.abs(T - np.eye(4)).sum()) for T in (found.base, found.tool)]
    joints = np.sum(found.signs < 0) + np.sum(np.abs(found.offsets) > tolerance)
    return int(joints) + sum(distance > tolerance for distance in distances), sum(distances)


def nearest_maps(
    one: Chain, other: Chain, fixed: frozenset[str], loose: float, tolerance: float = 0.0
) -> list[Equivalence]:
    """Find maps from one chain to another with the same joint types whose axes agree to within `loose`, in metres and radians.

    Those that change the fewest joints come first; after one to within the tolerance, no map with two changes more is sought.

    >>> from kinlib.chains.robots import rpr
    >>> nearest_maps(rpr(), rpr(), frozenset(CHOICES), 1e-6)[0].difference
    0.0
    """
    found, most = list[Equivalence](), 2 * one.n
    for signs, offsets, R in _starts(one, other, fixed, loose):
        changes = int(np.sum(signs < 0) + np.sum(np.abs(offsets) > SAME_DISTANCE_RAD))
        if changes > most:
            break
        X = homogeneous(R, np.zeros(3))
        start = Equivalence("same", X, signs=signs, offsets=offsets, joint_types=one.joint_types)
        found += _completed(start, one, other, fixed)
        if found[-1].difference <= tolerance:
            most = min(most, changes + 2)  # base and tool may take up two changes
    return found


def _starts(one: Chain, other: Chain, fixed: frozenset[str], loose: float) -> Iterator[tuple[Array, Array, Array]]:
    """Yield signs (n,), offsets (n,) and the rotation of the base for all signs that the axes admit, the fewest changes first."""
    invariants = AxisInvariants(other, 100 * loose)
    u, v, letters = one.lines.axis, other.lines.axis, one.joint_types
    s = invariants.sign_patterns(invariants.of(u, one.joint_points))
    s = s[(s > 0).all(axis=1)] if "signs" in fixed else s
    for end, joint, R, Q in (("base", 0, np.eye(3), np.eye(3)), ("tool", -1, one.home[:3, :3], other.home[:3, :3])):
        if end in fixed:
            s = s[np.linalg.norm(s[:, [joint]] * (u[joint] @ R) - v[joint] @ Q, axis=1) <= 100 * loose]
    x, y, source, is_cross = _normals(one, other, fixed, 10 * loose)
    flips = np.where(is_cross, np.pad(s[:, :-1] * s[:, 1:], ((0, 0), (1, 1)), constant_values=1.0), 1.0)[:, source]
    offsets = s * _angles(v, y) - _angles(u, x) - np.pi * (flips[:, :-1] != flips[:, 1:])
    offsets = np.asarray(wrap_angle(offsets))
    possible = np.ones(len(s), bool)
    for k in range(len(letters) - 1, -1, -1):
        if letters[k] == "P" or "zeros" in fixed:
            # What a prismatic joint cannot rotate, the joint before it does, if its axis is parallel.
            if letters[k] == "P" and k and abs(cosine := u[k - 1] @ u[k]) > PARALLEL_COS:
                offsets[:, k - 1] = wrap_angle(offsets[:, k - 1] + np.sign(cosine) * offsets[:, k])
            else:
                possible &= np.abs(offsets[:, k]) < MAX_ROTATION_OF_FIXED
            offsets[:, k] = 0.0
    zeros = (np.abs(offsets) > max(loose, SAME_DISTANCE_RAD)).sum(axis=1)
    for k in [k for k in np.lexsort((zeros, (s < 0).sum(axis=1) + zeros)) if possible[k]][:MAX_MAPS]:
        theirs, ours = _frame(v[0], y[0]), _frame(s[k, 0] * u[0], flips[k, 0] * x[0])
        yield s[k], offsets[k], np.eye(3) if "base" in fixed else theirs @ ours.T


def _normals(
    one: Chain, other: Chain, fixed: frozenset[str], near: float
) -> tuple[Array, Array, NDArray[np.int_], Booleans]:
    """Choose directions before, between and after the axes of two chains, (n + 1, 3) each, that correspond to each other.

    Between two axes it is their common normal. Where that is free, the direction is the one before, or the first that is not free;
    at an end that is fixed it is a direction of {s} or of {b}. Returns them with the index that each was taken from, and whether it
    is a cross product, which has the opposite direction if one of the axes has.
    """
    n, arms = one.n, (one, other)
    x, source = np.zeros((2, n + 1, 3)), np.full(n + 1, -1)
    is_cross: Booleans = np.zeros(n + 1, bool)
    if "base" in fixed:
        x[:, 0], source[0] = perpendicular(one.lines.axis[0]), 0
    if "tool" in fixed:
        across = perpendicular(one.lines.axis[-1] @ one.home[:3, :3])
        x[:, n], source[n] = [arm.home[:3, :3] @ across for arm in arms], n
    anchor = 0 if one.joint_types[0] != "P" else None  # the last line that is parallel to the axis
    for k in range(1, n):
        is_line = one.joint_types[k] != "P"
        both = np.array([cross(arm.lines.axis[k - 1], arm.lines.axis[k]) for arm in arms])
        is_cross[k] = np.linalg.norm(both, axis=1).min() > SEARCHED_AS_PARALLEL_RAD
        if not is_cross[k]:
            is_known = is_line and anchor is not None
            between = [arm.joint_points[k] - arm.joint_points[anchor or 0] for arm in arms]
            axes = [arm.lines.axis[k] for arm in arms]
            both = np.array([cross(axis, cross(p, axis)) for axis, p in zip(axes, between, strict=True)]) * is_known
        length = np.linalg.norm(both, axis=1, keepdims=True)
        if is_cross[k] or length.min() > near:
            x[:, k], source[k] = both / length, k
        anchor = k if is_line else None if is_cross[k] else anchor
    known = np.flatnonzero(source >= 0)
    if not known.size:
        x[:, 0], known = [perpendicular(arm.lines.axis[0]) for arm in arms], np.array([0])
    source = known[np.maximum(np.searchsorted(known, np.arange(n + 1), side="right") - 1, 0)]
    return x[0, source], x[1, source], source, is_cross


def _angles(axis: Array, x: Array) -> Array:
    """Compute the angle about each axis (n, 3) from the direction before it to the one after it, of (n + 1, 3) -> (n,)."""
    before, after = x[:-1], x[1:]
    return np.asarray(np.arctan2(np.sum(axis * cross(before, after), axis=1), np.sum(before * after, axis=1)))


def _frame(z: Array, x: Array) -> Array:
    """Compute the axes of a frame with this z and an x near the given one."""
    y = cross(z, x) / np.linalg.norm(cross(z, x))
    return np.transpose([cross(y, z), y, z])


def _completed(start: Equivalence, one: Chain, other: Chain, fixed: frozenset[str]) -> list[Equivalence]:
    """Find the translations of base and tool and the zeros of the prismatic joints.

    A motion of the base along the first axis is an offset of joint 1, and one of the tool along the last axis an offset of joint n.
    So there is another map whose base and tool are as near the identity as possible.
    """
    Y = np.eye(4) if "tool" in fixed else inverse(start.base @ one.fk(start.offsets)) @ other.home
    found = _improved(_measured(replace(start, tool=Y), one, other), one, other, fixed)
    X, Y, offsets = found.base, found.tool, found.offsets.copy()
    if not fixed & {"base", "zeros"}:
        shift = _shift_to_identity(X, one.screws[0])
        X, offsets[0] = X @ exp(shift * one.screws[0]), offsets[0] - shift
    if not fixed & {"tool", "zeros"}:
        shift = _shift_to_identity(inverse(Y), one.body_screws[-1])
        Y, offsets[-1] = exp(-shift * one.body_screws[-1]) @ Y, offsets[-1] + shift
    shifted = _measured(replace(found, base=X, tool=Y, offsets=offsets), one, other)
    return [found] if "zeros" in fixed else [shifted, found]


def _measured(found: Equivalence, one: Chain, other: Chain) -> Equivalence:
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    return replace(found, difference=largest_difference(other.fk(q), found.poses(one, q)))


def _improved(found: Equivalence, one: Chain, other: Chain, fixed: frozenset[str]) -> Equivalence:
    """Improve a map by least-squares steps on the poses themselves, for all configurations at once."""
    q = random_configurations(one.n, COMPARED_CONFIGURATIONS)
    target = other.fk(q)
    is_free = np.repeat([name not in fixed for name in ("base", "zeros", "tool")], [6, one.n, 6])
    # The zero of the first joint is a motion of the base, and that of the last one a motion of the tool.
    is_free[6] &= "base" in fixed
    is_free[-7] &= "tool" in fixed
    # Translations first: for them the problem is linear, and where rotations are redundant they would share the error.
    slides = [letter == "P" for letter in one.joint_types]
    translates = np.array([*[False] * 3, *[True] * 3, *slides, *[False] * 3, *[True] * 3])
    for free in (is_free & translates, *[is_free] * MAX_STEPS):
        if found.difference <= EXACT:
            break
        error, J = linearized(found.base, one, found.signs * q + found.offsets, found.tool, target)
        step = np.linalg.lstsq(J * free, -error, rcond=1e-10)[0] * free
        if np.abs(step).max() > LARGEST_STEP:
            break
        X, Y = exp(step[:6]) @ found.base, found.tool @ exp(step[-6:])
        moved = _measured(replace(found, base=X, tool=Y, offsets=found.offsets + step[6:-6]), one, other)
        if moved.difference < found.difference:
            found = moved
        elif free is is_free:
            break
    return found


def linearized(X: Array, chain: Chain, values: Array, Y: Array, target: Array) -> tuple[Array, Array]:
    """Compute the errors (6 N,) of the poses X T(values) Y, and their Jacobian (6 N, 6 + n + 6).

    values (N, n), target (N, 4, 4). The error is the small twist of target^-1 X T Y; with M = X T Y and the body Jacobian J of the
    chain, it changes by Ad(M^-1) dX + Ad(Y^-1) J dvalues + dY.

    >>> from kinlib.chains.robots import rpr
    >>> q = np.zeros((2, 3))
    >>> error, J = linearized(np.eye(4), rpr(), q, np.eye(4), rpr().fk(q))
    >>> bool(error.any()), J.shape
    (False, (12, 15))
    """
    M = X @ chain.fk(values) @ Y
    E = inverse(target) @ M
    R = E[..., :3, :3]
    error = np.concatenate([vee((R - np.swapaxes(R, -1, -2)) / 2), E[..., :3, 3]], axis=-1)
    by_values = adjoint(inverse(Y)) @ chain.body_jacobian(values)
    J = np.concatenate([adjoint(inverse(M)), by_values, np.broadcast_to(np.eye(6), (len(values), 6, 6))], axis=-1)
    return error.ravel(), J.reshape(-1, J.shape[-1])


def _shift_to_identity(T: Array, S: Array) -> float:
    """Compute the q for which T e^[S]q is as near the identity as possible."""
    R, omega = T[:3, :3], S[:3]
    if not omega.any():
        return float(-(R @ S[3:]) @ T[:3, 3])
    # The trace of R e^[omega]q is a cosine in q, with its maximum at this q.
    even, odd = np.trace(R) - omega @ R @ omega, np.trace(R @ hat(omega))
    return float(np.arctan2(odd, even)) if np.hypot(odd, even) > SEARCHED_AS_PARALLEL_RAD else 0.0


def neighbours(chain: Chain) -> tuple[Array, Array, Array]:
    """Compute how each axis lies to the next one, (n - 1,) each.

    Returns the sine of the angle between them, the acute angle in radians, and the length of their common normal in metres.

    >>> from kinlib.chains.robots import youbot
    >>> neighbours(youbot())[2]
    array([0.033, 0.155, 0.135, 0.   ])
    """
    u, v, between = chain.lines.axis[:-1], chain.lines.axis[1:], np.diff(chain.joint_points, axis=0)
    normal = cross(u, v)
    sine = np.linalg.norm(normal, axis=-1)
    along_normal = np.abs(np.sum(between * normal, axis=-1)) / np.maximum(sine, PARALLEL_TOL_RAD)
    distance = np.where(sine <= PARALLEL_TOL_RAD, np.linalg.norm(cross(between, u), axis=-1), along_normal)
    return sine, np.arctan2(sine, np.abs(np.sum(u * v, axis=-1))), distance


def _nearly_parallel(*arms: Chain) -> Booleans:
    """Which pairs of neighbouring axes are nearly parallel in an arm, (n - 1,): a description of them has lost digits."""
    sines = np.array([neighbours(arm)[0] for arm in arms])
    return np.asarray(((sines > PARALLEL_TOL_RAD) & (sines < NEARLY_PARALLEL_RAD)).any(axis=0))


def _why_undecided(near: Booleans, difference: float) -> str:
    pair = int(np.argmax(near)) + 1
    return (
        f"The poses differ by {difference:.1e} under the nearest map that was found, and a better one is not excluded, because axes "
        f"{pair} and {pair + 1} are nearly parallel."
        + (f" With tolerance={_rounded_up(difference):g} the two are the same." if difference < 1e-3 else "")
    )


def _why_different(one: Chain, other: Chain, fixed: frozenset[str], found: Equivalence) -> str:
    """Describe the largest difference, and offer the tolerance with which the two would be the same, if there is a small one."""
    reason = _largest_axis_difference(one, other, found.tolerance) or (
        "The angles and the distances of neighbouring axes agree; what differs is a distance along an axis, or a choice that is fixed."
    )
    nearest = min((each.difference for each in [found, *nearest_maps(one, other, fixed, ROUGH)]), default=np.inf)
    if (
        nearest < MAX_OFFERED_TOL
        and equivalent(one, other, fixed=fixed, tolerance=_rounded_up(nearest)).verdict == "same"
    ):
        return f"{reason} With tolerance={_rounded_up(nearest):g} the two are called the same."
    return reason


def _rounded_up(value: float) -> float:
    """Round a positive number up to one digit more than it needs, so that it is a tolerance with which the value passes."""
    unit = 10.0 ** math.floor(math.log10(value))
    return float(f"{(math.floor(value / unit) + 1) * unit:.0e}")


def _largest_axis_difference(one: Chain, other: Chain, tolerance: float) -> str:
    """Describe the pair of neighbouring axes whose angle or distance differs most; "" if they all agree."""
    is_near = _nearly_parallel(one, other)
    _, angles, distances = np.array([neighbours(one), neighbours(other)]).swapaxes(0, 1)
    found = [(tolerance, "")]
    for i, near in enumerate(is_near):
        if (off := abs(float(np.diff(angles[:, i])[0]))) > tolerance:
            first, second = format_different(*np.degrees(angles[:, i]).tolist())
            text = f"make an angle of {first} degrees in the first, and of {second} degrees in the second."
            found.append((off, f"Axes {i + 1} and {i + 2} {text}"))
        if "P" not in one.joint_types[i : i + 2] and not near:
            first, second = format_different(*distances[:, i].tolist())
            text = f"are {first} m apart in the first, and {second} m in the second."
            found.append((abs(float(np.diff(distances[:, i])[0])), f"Axes {i + 1} and {i + 2} {text}"))
    return max(found)[1]


@dataclass(frozen=True, eq=False)
class AxisInvariants:
    """The invariants of a reference, with which those of other mechanisms with the same joint types are compared.

    Two neighbouring axes u, v have the cosine u . v; two that are lines have the mutual moment, the distance along u x v, or, if they
    are parallel, their distance; and an axis with a common normal on either side has the distance between these two along the axis.
    If a joint changes its sign, its axis has the opposite direction: the cosine and the moment change their signs with that of either
    axis, the distance along an axis with that of the axis.

    tolerance   how far cosines may differ, and lengths on an arm of one metre
    """

    reference: Chain
    tolerance: float

    def of(self, axis: Array, point: Array) -> Array:
        """Compute the invariants of mechanisms, directions and points of their axes (..., n, 3) each -> (..., k).

        >>> from kinlib.chains.robots import rpr
        >>> AxisInvariants(rpr(), 1e-9).of(rpr().lines.axis, rpr().joint_points) + 0.0
        array([0., 0.])
        """
        u, v, between = axis[..., :-1, :], axis[..., 1:, :], np.diff(point, axis=-2)
        across = cross(u, v)
        moment, distance = _dot(between, across), np.linalg.norm(cross(between, u), axis=-1)
        # The places of the feet of each common normal on its two axes, measured from the points.
        squared_sine = np.maximum(_dot(across, across), np.finfo(float).tiny)
        start, end = _dot(cross(between, v), across) / squared_sine, _dot(cross(between, u), across) / squared_sine
        i, j = np.array(self._runs, dtype=int).reshape(-1, 2).T
        foot = point[..., j, :] + start[..., j, None] * axis[..., j, :] - point[..., i + 1, :]
        along = _dot(axis[..., i + 1, :], foot) - end[..., i]
        parts = [_dot(u, v), moment[..., self._skew], distance[..., self._parallel], along]
        return np.concatenate(parts, axis=-1)

    def violated(self, values: Array) -> Booleans:
        """Return which invariants (..., k) differ from those of the reference for every choice of signs.

        >>> from kinlib.chains.robots import rpr
        >>> AxisInvariants(rpr(), 1e-9).violated(np.array([0.0, 0.5]))
        array([False,  True])
        """
        violated: Booleans = np.abs(np.abs(values) - np.abs(self._values)) > self._tolerances
        return violated

    def agree(self, values: Array, signs_are_fixed: bool = False) -> Booleans:
        """Return for which mechanisms (N,) all invariants (N, k) agree for one choice of the joint signs.

        >>> from kinlib.chains.robots import rpr
        >>> AxisInvariants(rpr(), 1e-9).agree(np.array([[0.0, 0.0], [0.0, 0.5]]))
        array([ True, False])
        """
        if signs_are_fixed:
            return np.asarray(np.all(np.abs(values - self._values) <= self._tolerances, axis=-1))
        possible = np.all(~self.violated(values), axis=-1)
        return np.array([each and len(self.sign_patterns(own)) > 0 for each, own in zip(possible, values, strict=True)])

    def sign_patterns(self, values: Array) -> Array:
        """Return all signs of the joints (P, n) for which all invariants (k,) agree, those with the fewest -1 first.

        >>> from kinlib.chains.robots import rpr
        >>> AxisInvariants(rpr(), 1e-9).sign_patterns(np.zeros(2))[0].tolist()
        [1.0, 1.0, 1.0]
        """
        agree = np.abs(self._factors * values - self._values) <= self._tolerances
        return self._patterns[agree.all(axis=1)]

    @cached_property
    def _patterns(self) -> Array:
        n = self.reference.n
        flips = [flip for count in range(n + 1 if n <= MAX_JOINTS else 3) for flip in combinations(range(n), count)]
        return np.array([[-1.0 if joint in flip else 1.0 for joint in range(n)] for flip in flips])

    @cached_property
    def _factors(self) -> Array:
        """The sign of each invariant for each pattern (P, k); distances of parallel lines have none."""
        s = self._patterns
        pairs, along = s[:, :-1] * s[:, 1:], s[:, [i + 1 for i, _ in self._runs]]
        return np.hstack([pairs, pairs[:, self._skew], np.ones((len(s), len(self._parallel))), along])

    @cached_property
    def _sines(self) -> Array:
        return neighbours(self.reference)[0]

    def _pairs_of_lines(self, has_angle: Booleans) -> list[int]:
        """The pairs (k, k + 1) of axes at some angles, without those of a prismatic joint, which has no line."""
        types = self.reference.joint_types
        return [k for k in np.flatnonzero(has_angle).tolist() if "P" not in types[k : k + 2]]

    @cached_property
    def _skew(self) -> list[int]:
        return self._pairs_of_lines(self._sines > np.sqrt(1 - CLEARLY_NOT_PARALLEL_COS**2))

    @cached_property
    def _parallel(self) -> list[int]:
        """The pairs of parallel lines. The distance of nearly parallel ones depends on the last digits."""
        return self._pairs_of_lines(self._sines < SAME_DISTANCE_RAD)

    @cached_property
    def _runs(self) -> list[tuple[int, int]]:
        """The pairs i < j between which all lines are parallel: the two normals are a fixed distance apart along these lines.

        A helical joint changes this distance with its zero.
        """
        types, parallel = self.reference.joint_types, {*self._parallel}
        pairs = combinations(self._skew, 2)
        return [(i, j) for i, j in pairs if {*range(i + 1, j)} <= parallel and {*types[i + 1 : j + 1]} == {"R"}]

    @cached_property
    def _tolerances(self) -> Array:
        length = self.tolerance * (1 + float(np.ptp(self.reference.joint_points, axis=0).max()))
        along = [length / min(self._sines[i], self._sines[j]) ** 2 for i, j in self._runs]
        return np.array([self.tolerance] * len(self._sines) + [length] * len(self._skew + self._parallel) + along)

    @cached_property
    def _values(self) -> Array:
        return self.of(self.reference.lines.axis, self.reference.joint_points)


def _dot(u: Array, v: Array) -> Array:
    products: Array = np.sum(u * v, axis=-1)
    return products
