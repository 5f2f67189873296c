"""Whether two descriptions are one mechanism: the same motions, up to base, tool, joint zero and joint sign.

Two chains a and b are equivalent if there are poses X and Y, signs s and offsets c with

    T_b(q) = X T_a(s q + c) Y      for every q.

The directions of the axes decide the turns, one joint after the other: the next direction of a can reach the next of b
only by turning about the axis before, and that gives the offset. Where axes are parallel, the step from one to the next
gives it instead. Once all turns are known, places are a linear problem. What is found is checked on random postures, so a
yes is never wrong; and it carries X, Y, s and c, so anybody can check it again.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from kinlib.arrays.batching import cross
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.common_normal import NEARLY
from kinlib.dh.table import DHTable
from kinlib.rigid.lie import exp, hat, homogeneous, inverse, perpendicular
from kinlib.rigid.screw import line

SAME = 1e-8
"""How far two mechanisms may differ, in an entry of a pose, and still be called one."""

LOOSE = 10
"""How many tolerances a part may be off on the way: what counts is the whole map, which is tried at the end."""

PLAIN = 0.99
"""Axes whose angle has a smaller cosine are plainly not parallel."""

PARALLEL = 1e-9
"""Axes that make a smaller angle are as far apart everywhere, to a micrometre along a kilometre."""

POSTURES = 16
"""In how many random postures an answer is checked."""


@dataclass(frozen=True, eq=False)
class Equivalence:
    """The answer, which counts as True or False, with the map that shows it or the reason why there is none.

    base, tool, signs, offsets   X, Y, s, c with T_b(q) = X T_a(s q + c) Y
    difference                   the largest difference in an entry, over random postures; inf where no map was found
    reason                       why not, in words
    """

    same: bool
    base: Array = field(default_factory=lambda: np.eye(4), repr=False)
    tool: Array = field(default_factory=lambda: np.eye(4), repr=False)
    signs: Array = field(default_factory=lambda: np.ones(0))
    offsets: Array = field(default_factory=lambda: np.zeros(0))
    difference: float = np.inf
    reason: str = ""

    def __bool__(self) -> bool:
        return self.same


def equivalent(
    a: Chain | DHTable, b: Chain | DHTable, *, tolerance: float = SAME, simplest: bool = True
) -> Equivalence:
    """Decide whether two descriptions move alike, up to base, tool, joint zero and joint sign.

    a, b are chains, or tables in either convention. The position of a prismatic axis plays no part, for a slide has none.
    simplest  among several maps give the one that takes the fewest words; False takes the first, for a bare yes or no

    Raises ValueError for a tolerance that is not positive.

    >>> from kinlib.chains.robots import puma560
    >>> from kinlib.dh.assignment import assign_frames
    >>> bool(equivalent(puma560(), assign_frames(puma560(), convention="standard").table))
    True
    """
    if not tolerance > 0:
        raise ValueError(f"tolerance should be a positive number of metres and radians; got {tolerance!r}.")
    one, other = (thing.to_chain() if isinstance(thing, DHTable) else thing for thing in (a, b))
    if one.joint_types != other.joint_types:
        return Equivalence(
            False, reason=f"The joints differ in kind: {one.joint_types} here, {other.joint_types} there."
        )
    if _plainly_apart(one, other, LOOSE * tolerance):
        return Equivalence(False, reason=_first_difference(one, other))
    right, closest = [], np.inf
    for match in _turned_alike(one, other, LOOSE * tolerance):
        found = _placed_alike(one, other, match, LOOSE * tolerance)
        closest = min(closest, found.difference)
        if found.difference <= tolerance:
            right.append(found)
            if not simplest:
                break
    if right:
        return min(right, key=lambda found: _length(found, tolerance))
    return Equivalence(False, difference=closest, reason=_first_difference(one, other))


@dataclass(frozen=True, eq=False)
class _Match:
    """How far the directions are matched: joints 0 to len(signs) - 1.

    base   the turn from link 0 of a to link 0 of b, (3, 3)
    link   the same for the link behind the last matched joint
    free   whose turn may still be chosen without spoiling what is matched: a joint, -1 for the base, or None
    """

    base: Array
    link: Array
    signs: tuple[float, ...]
    offsets: Array
    free: int | None


def _turned_alike(one: Chain, other: Chain, loose: float) -> Iterator[_Match]:
    """Every way to turn the joints of one so that its axes point as those of the other."""
    u, v = one.lines.axis, other.lines.axis
    for sign in (1.0, -1.0):
        R = _onto(u[0], sign * v[0])
        first = 0 if one.joint_types[0] == "R" else -1
        yield from _continued(_Match(R, R, (sign,), np.zeros(one.n), first), one, other, loose)


def _continued(match: _Match, one: Chain, other: Chain, loose: float) -> Iterator[_Match]:
    joint = len(match.signs)
    if joint == one.n:
        yield match
        return
    u, v = one.lines.axis, other.lines.axis
    axis, now = match.signs[-1] * v[joint - 1], match.link @ u[joint]
    sine = np.linalg.norm(cross(axis, now))
    turns = one.joint_types[joint] == "R"
    for sign in (1.0, -1.0):
        wanted = sign * v[joint]
        if abs(axis @ (now - wanted)) > loose:
            continue
        tries = []
        if sine < NEARLY + loose:
            # Parallel: the direction says nothing about the turn before, but the step from axis to axis does.
            step = _side_step(match, joint, axis, one, other) if turns else match
            tries.append(replace(step, free=joint if turns else step.free))
        if sine > loose / 10:
            step = _turned(match, axis, now, wanted, other)
            tries.append(replace(step, free=joint if turns else None))
        for step in tries:
            if np.linalg.norm(step.link @ u[joint] - wanted) <= loose:
                yield from _continued(replace(step, signs=(*match.signs, sign)), one, other, loose)


def _side_step(match: _Match, joint: int, axis: Array, one: Chain, other: Chain) -> _Match:
    """Use the turn of a joint to bring the next parallel axis to the side on which it should be."""
    before = match.free
    if before is None or before < 0:
        return match
    now = match.link @ (one.joint_points[joint] - one.joint_points[before])
    wanted = other.joint_points[joint] - other.joint_points[before]
    return _turned(match, axis, now, wanted, other)


def _turned(match: _Match, axis: Array, now: Array, wanted: Array, other: Chain) -> _Match:
    """Turn all behind the free joint about an axis, until `now` stands at the side of `wanted`."""
    if match.free is None:
        return match
    angle = np.arctan2(axis @ cross(now, wanted), now @ wanted - (axis @ now) * (axis @ wanted))
    R = exp(angle * axis)
    if match.free == -1:
        return replace(match, base=R @ match.base, link=R @ match.link)
    offsets = match.offsets.copy()
    own = match.signs[match.free] * other.lines.axis[match.free]
    offsets[match.free] += angle * np.sign(own @ axis)
    return replace(match, link=R @ match.link, offsets=offsets)


def _placed_alike(one: Chain, other: Chain, match: _Match, loose: float) -> Equivalence:
    """Find the shift of the base and the zeros of the slides, which are a linear problem, and try the whole map."""
    # Two configurations are a batch. For a single one the chain would write a program first, which does not pay for one use.
    carried, wanted = line(one.jacobian(np.stack([match.offsets, match.offsets]))[0].T), other.lines
    slides = [joint for joint, letter in enumerate(one.joint_types) if letter == "P"]
    rows, right = [np.zeros((0, 3 + len(slides)))], [np.zeros(0)]
    for joint in range(one.n):
        if joint not in slides:
            moves = [match.base @ carried.axis[slide] * (slide < joint) for slide in slides]
            # Along its own direction an axis may lie anywhere.
            across = np.eye(3) - np.outer(wanted.axis[joint], wanted.axis[joint])
            rows.append(across @ np.column_stack([np.eye(3), *moves]))
            right.append(across @ (wanted.point[joint] - match.base @ carried.point[joint]))
    equations, sides = np.concatenate(rows), np.concatenate(right)
    solved = np.linalg.lstsq(equations, sides, rcond=1e-9)[0]
    missed = float(np.abs(equations @ solved - sides).max(initial=0))
    if missed > loose:
        return Equivalence(False, difference=missed)
    X = homogeneous(match.base, solved[:3])
    signs, offsets = np.array(match.signs), match.offsets.copy()
    offsets[slides] = solved[3:]
    # The first joint may take over a turn of the base, and the last one of the tool: leave as little in both as can be.
    spare = _nearest_home(X, one.screws[0])
    X, offsets[0] = X @ exp(spare * one.screws[0]), offsets[0] - spare
    Y = inverse(X @ one.fk(np.stack([offsets, offsets]))[0]) @ other.home
    spare = _nearest_home(inverse(Y), one.body_screws[-1])
    Y, offsets[-1] = exp(-spare * one.body_screws[-1]) @ Y, offsets[-1] + spare
    q = random_configurations(one.n, POSTURES)
    difference = largest_difference(other.fk(q), X @ one.fk(signs * q + offsets) @ Y)
    return Equivalence(True, X, Y, signs, offsets, difference)


def _nearest_home(T: Array, S: Array) -> float:
    """How far to move along a screw axis so that T e^[S]q comes as near the identity as it can."""
    R, omega = T[:3, :3], S[:3]
    if not omega.any():
        return float(-(R @ S[3:]) @ T[:3, 3])
    # The trace of R e^[omega]q is a cosine in q, and it is largest here.
    even, odd = np.trace(R) - omega @ R @ omega, np.trace(R @ hat(omega))
    return float(np.arctan2(odd, even)) if np.hypot(odd, even) > NEARLY else 0.0


def _length(found: Equivalence, tolerance: float) -> tuple[int, float]:
    """How much there is to tell of a map: signs, zeros, a base, a tool; and how far these two are from nothing."""
    moved = [float(np.abs(T - np.eye(4)).sum()) for T in (found.base, found.tool)]
    told = np.sum(found.signs < 0) + np.sum(np.abs(found.offsets) > tolerance) + sum(far > tolerance for far in moved)
    return int(told), sum(moved)


def _plainly_apart(one: Chain, other: Chain, loose: float) -> bool:
    """Whether two neighbouring axes stand at another angle, or at another distance: then there is nothing to search for."""
    for i in range(one.n - 1):
        pairs = [(lines.axis[i : i + 2], lines.point[i : i + 2]) for lines in (one.lines, other.lines)]
        cosines = [abs(float(axes[0] @ axes[1])) for axes, _ in pairs]
        if abs(cosines[0] - cosines[1]) > loose:
            return True
        # Nearly parallel axes have a distance that hangs on the last digits, and slides have none.
        told = "P" not in one.joint_types[i : i + 2] and (
            cosines[0] < PLAIN or all(np.linalg.norm(cross(*axes)) < PARALLEL for axes, _ in pairs)
        )
        if told and abs(_distance(*pairs[0]) - _distance(*pairs[1])) > loose / (1 - PLAIN):
            return True
    return False


def _first_difference(one: Chain, other: Chain) -> str:
    """Name the first pair of neighbours that stand to each other in another way: what a person would look at first."""
    here, there = one.lines, other.lines
    for i in range(one.n - 1):
        # Acute, for either axis may point the other way.
        angles = [_acute_degrees(lines.axis[i], lines.axis[i + 1]) for lines in (here, there)]
        if abs(angles[0] - angles[1]) > 1e-3:
            return (
                f"Axes {i + 1} and {i + 2} make an angle of {angles[0]:.4g} degrees here, and of {angles[1]:.4g} there."
            )
        if "P" not in one.joint_types[i : i + 2]:
            apart = [_distance(lines.axis[i : i + 2], lines.point[i : i + 2]) for lines in (here, there)]
            if abs(apart[0] - apart[1]) > SAME:
                return f"Axes {i + 1} and {i + 2} are {apart[0]:.4g} m apart here, and {apart[1]:.4g} m there."
    return "Neighbouring axes agree two by two, but no turn of the joints brings all of them together."


def _acute_degrees(u: Array, v: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(cross(u, v)), abs(u @ v))))


def _distance(axes: Array, points: Array) -> float:
    normal, between = cross(*axes), points[1] - points[0]
    sine = float(np.linalg.norm(normal))
    if sine > NEARLY:
        return float(abs(between @ normal)) / sine
    return float(np.linalg.norm(cross(between, axes[0])))


def _onto(u: Array, v: Array) -> Array:
    """A turn that takes the unit vector u to the unit vector v."""
    across = cross(u, v)
    sine = float(np.linalg.norm(across))
    if sine < 1e-9:
        # Opposite vectors leave the axis open: any that is perpendicular to u will do.
        across, sine = perpendicular(u), 0.0
    return exp(across / np.linalg.norm(across) * np.arctan2(sine, u @ v))
