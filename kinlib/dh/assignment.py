"""DH frame assignment: from joint axes to frames and table, in both conventions, with every step and its reason.

The axes decide most of it. What they leave open is decided as the decks do, and each step says what else was legal:
parallel axes put the origin at joint i+1 (standard) or keep d_i = 0 (modified), axes that meet keep x close to the x
before, the last z of the standard convention is parallel to the one before, and {0} matches {1} in the modified.

Nearly parallel axes are where DH itself is singular. Their normal runs away like 1 / angle, and with it the last digits
of d. There the assignment compares the exact row with one that takes the axes as parallel, keeps the better one, and
says how accurate the table is.
"""

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from kinlib.arrays.batching import cross
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain, largest_difference, random_configurations
from kinlib.dh.common_normal import MEETS, Normal, common_normal
from kinlib.dh.explanation import PROBES, Step, told
from kinlib.dh.table import Convention, DHTable, convention_of, joint_step, normal_step
from kinlib.rigid.lie import homogeneous

SPARED = 1e-3
"""A slide less apart than this from its neighbour, in radians, is laid across it: then their normal cannot run away."""


@dataclass(frozen=True, eq=False)
class FrameAssignment:
    """Frames for an arm: the table, the frames that it came from, and the way there.

    table    exactly one row a joint, with base and tool
    frames   (n + 1, 4, 4), frames 0 to n in {s} at home
    normals  the common normal of each pair of neighbouring axes
    """

    chain: Chain
    table: DHTable
    frames: Array = field(repr=False)
    normals: tuple[Normal, ...] = field(repr=False)

    @cached_property
    def accuracy(self) -> float:
        """The largest difference in an entry between the table's poses and the chain's, measured in many postures."""
        q = random_configurations(self.chain.n, PROBES)
        return largest_difference(self.table.fk(q), self.chain.fk(q))

    @property
    def base(self) -> Array:
        """Frame 0 in {s}: what stands before the first row."""
        return self.table.base

    @property
    def tool(self) -> Array:
        """{b} in frame n: what stands after the last row."""
        return self.table.tool

    @cached_property
    def steps(self) -> list[Step]:
        """The assignment as a person makes it, in the order of the decks: each step with its case, choice and numbers."""
        return told(self.chain, self.table, self.frames, self.normals, self.accuracy)


def assign_frames(chain: Chain, *, convention: Convention) -> FrameAssignment:
    """Assign DH frames to an arm, and read off its table.

    The product of the table equals chain.fk to about 1e-12; for nearly parallel axes `accuracy` tells how closely.

    Raises ValueError for another convention, and for a helical joint, which no DH row can hold.
    Source: EduFill module, steps I to IX; Chapter 4 review deck, seven steps (standard); deck n = 5, eight steps (modified).

    >>> from kinlib.chains.robots import youbot
    >>> assign_frames(youbot(), convention="standard").table.columns["d"].round(4) + 0.0
    array([0.147 , 0.    , 0.    , 0.    , 0.2175])
    """
    convention = convention_of(convention)
    if "H" in chain.joint_types:
        joint = chain.joint_types.index("H") + 1
        raise ValueError(
            f"Joint {joint} of {chain.name} is helical: it turns and climbs at once, and a DH row has one variable. "
            "Keep its screw axis."
        )
    exact = _assigned(chain, convention, MEETS)
    if not any(normal.nearly_parallel for normal in exact.normals):
        return exact
    # One bound for the whole arm: an axis taken as parallel passes its small fault on to the next comparison.
    bounds = 10.0 ** np.arange(-10.5, -5.0, 0.5)
    return min([exact, *(_assigned(chain, convention, bound) for bound in bounds)], key=lambda found: found.accuracy)


def _assigned(chain: Chain, convention: Convention, parallel_below: float) -> FrameAssignment:
    """Assign frames, with axes less apart than the bound taken as parallel."""
    standard = convention == "standard"
    axes, points = chain.lines.axis, _places(chain)
    frame = _first(axes[0], points[0])
    base, normals, turns, twists = frame, [], [], []
    frames = [frame]
    for i in range(chain.n - 1):
        other = axes[i + 1], points[i + 1]
        normal = common_normal(_axis(frame), other, frame[:3, 0], slide=standard, parallel_below=parallel_below)
        normals.append(normal)
        if i == 0 and not standard:
            # {0} matches {1} while the first joint is at 0, so the first frame goes where the normal wants it.
            frame = _turned_to(frame, normal.x, normal.start)[0]
            base, frames = frame, [frame]
        frame, turn = _turned_to(frame, normal.x, normal.start)
        turns.append(turn)
        frames += [] if standard else [frame]
        frame, twist = _twisted_to(frame, normal, axes[i + 1])
        twists.append(twist)
        frames += [frame] if standard else []
    if standard:
        frame, turn, a = _last(frame, chain.home)
        turns.append(turn)
        twists.append((a, 0.0))
    else:
        turns.append((0.0, 0.0))
        twists.insert(0, (0.0, 0.0))
    frames.append(frame)
    rows = [(a, alpha, d, theta) for (a, alpha), (d, theta) in zip(twists, turns, strict=True)]
    tool = _seen_from(frame, chain.home)
    table = DHTable(rows, convention=convention, joints=chain.joint_types, base=base, tool=tool, name=chain.name)
    return FrameAssignment(chain, table, np.array(frames), tuple(normals))


def _places(chain: Chain) -> Array:
    """A point on each axis. A slide may lie anywhere, so it goes where it spares the next joint a runaway normal."""
    places = np.array(chain.joint_points)
    axes = chain.lines.axis
    for i, letter in enumerate(chain.joint_types):
        if letter == "P":
            for neighbour in (i - 1, i + 1):
                if 0 <= neighbour < chain.n and MEETS < np.linalg.norm(cross(axes[i], axes[neighbour])) < SPARED:
                    places[i] = places[neighbour]
    return places


def _first(z: Array, point: Array) -> Array:
    """Frame 0 on the first axis: as close to {s} as an axis allows."""
    return _frame(_square(np.eye(3), z), z, point - z * (z @ point))


def _last(frame: Array, home: Array) -> tuple[Array, tuple[float, float], float]:
    """Frame n of the standard convention: z_n stays parallel, and the frame goes as near the tool as that allows."""
    z, origin = _axis(frame)
    foot = origin + z * (z @ (home[:3, 3] - origin))
    off = home[:3, 3] - foot
    a = float(np.linalg.norm(off))
    x = off / a if a > MEETS else _square(home[:3, :3].T, z)
    a = a if a > MEETS else 0.0
    frame, turn = _turned_to(frame, x, foot)
    return frame @ normal_step(a, 0.0), turn, a


def _turned_to(frame: Array, x: Array, origin: Array) -> tuple[Array, tuple[float, float]]:
    """Move a frame about and along its own z until its x and its origin are as wanted; give d and theta too."""
    d = float(frame[:3, 2] @ (origin - frame[:3, 3]))
    cos, sin, _ = x @ frame[:3, :3]
    theta = math.atan2(sin, cos)
    return frame @ joint_step(d, theta), (d, theta)


def _twisted_to(frame: Array, normal: Normal, z: Array) -> tuple[Array, tuple[float, float]]:
    """Move a frame about and along its own x onto the next axis; give a and alpha too."""
    a = float(frame[:3, 0] @ (normal.end - frame[:3, 3])) if normal.case not in _MEETING else 0.0
    straight = np.pi if normal.case.startswith("anti") else 0.0
    _, minus_sin, cos = z @ frame[:3, :3]
    alpha = straight if normal.free else math.atan2(-minus_sin, cos)
    return frame @ normal_step(a, alpha), (a, alpha)


_MEETING = {"intersecting", "coincident", "anti-coincident"}


def _seen_from(frame: Array, T: Array) -> Array:
    """A pose in a frame, which may lie far away: so their difference is taken first."""
    seen = T.copy()
    seen[:3, 3] -= frame[:3, 3]
    seen[:3] = frame[:3, :3].T @ seen[:3]
    return seen


def _axis(frame: Array) -> tuple[Array, Array]:
    return frame[:3, 2], frame[:3, 3]


def _frame(x: Array, z: Array, origin: Array) -> Array:
    return homogeneous(np.transpose([x, cross(z, x), z]), origin)


def _square(candidates: Array, z: Array) -> Array:
    """The first of the candidates that is not along z, made square to it."""
    for x in candidates:
        across = x - z * (z @ x)
        if (length := np.linalg.norm(across)) > 0.1:
            unit: Array = across / length
            return unit
    raise AssertionError("three axes cannot all be along z")
