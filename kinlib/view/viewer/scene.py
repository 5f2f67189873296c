"""What the viewer is told of an arm: geometry at home, as plain data. The page moves it, by the screws.

Every part rides on a body: body 0 is the base, body i what joint i carries. Parts are given where they are at home, in {s}.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.common_normal import common_normal
from kinlib.rigid.lie import homogeneous, perpendicular
from kinlib.view.figures.arm import describe_arm, reachable_points
from kinlib.view.figures.joint_bodies import axial_offsets

MAX_DETOUR_RATIO = 2.5
"""A link follows its axes and their common normal, as the links of real arms do, unless that is so much longer."""

MAX_DISTANCE_IN_ARM_SIZES = 4.0
"""Frames and normals farther out than this many sizes of the arm are left out: those of nearly parallel axes are."""

CLEARANCE = 3.3
"""From one joint to the next on the same axis, in radii of a joint: they would hide each other."""

MIN_SIZE_IN_ROOM_RADII = 0.95
"""Marks are drawn for an arm of at least this size, in radii of the room that is in view."""

Z = np.eye(3)[2]
COINCIDENT_TOL_M = 1e-9


LAYERS = (
    *("axes", "body axes", "home axes"),
    *("base", "tool", "links", "standard", "modified"),
    *("normals", "dimensions", "trail"),
)
"""What the viewer can show: screw axes, frames, and what lies between."""

DEFAULT_ANGLE_RAD, DEFAULT_TRAVEL_M = np.pi, 1.0
"""How far a slider goes to either side of 0 where the joint has no limits: half a turn in radians, one metre."""


def scene(
    chain: Chain,
    start: Array,
    *,
    joints: Sequence[int] | None = None,
    span: tuple[float, float] | None = None,
    ghost: Array | None = None,
) -> dict[str, Any]:
    """Say all that the page needs to know of an arm: its geometry, its sliders, the room that it moves in.

    start   (n,) joint values to begin with
    joints  which ones get a slider, counted from 1
    span    from where to where they go; the joint's limits, if not given, or what is common for its kind

    Raises ValueError for a joint that the arm does not have, a start of another size, a span that does not hold it.

    >>> from kinlib.chains.robots import rpr
    >>> scene(rpr(), np.zeros(3), joints=[2])["sliders"][0]["unit"]
    'm'
    """
    joints = list(range(1, chain.n + 1)) if joints is None else list(joints)
    if wrong := [joint for joint in joints if joint not in range(1, chain.n + 1)]:
        raise ValueError(f"{chain.name} has joints 1 to {chain.n}; got {wrong[0]!r}.")
    chain.fk(start)  # refuses a start of another size, in words
    sliders = [_slider(chain, joint - 1, float(start[joint - 1]), span) for joint in joints]
    low, high = start.copy(), start.copy()
    for slider in sliders:
        low[slider["column"]], high[slider["column"]] = slider["low"], slider["high"]
    postures = [_stations(chain, np.zeros(chain.n)), _stations(chain, start)]
    postures += [] if ghost is None else [_stations(chain, ghost)]
    room, floor = _room(np.concatenate(postures), reachable_points(chain, low, high), extent(chain))
    return {
        "name": chain.name,
        "words": describe_arm(chain, np.zeros(chain.n)).partition(" The tool is at")[0],
        # Where an arm is small in its room, its marks stay large enough to tell apart.
        "size": max(extent(chain), MIN_SIZE_IN_ROOM_RADII * room["radius"]),
        "arms": [arm_data(chain, range(chain.n))],
        "sliders": sliders,
        "limits": [[_finite(end) for end in pair] for pair in chain.limits] if chain.limits is not None else [],
        "room": room,
        "floor": floor,
        "foot": [0.0, 0.0, 0.0],
    }


def arm_data(chain: Chain, columns: Sequence[int]) -> dict[str, Any]:
    """Say an arm as data: joints, links, home, frames in each convention, common normals.

    columns  which of the viewer's joint values each joint follows: branches of a closed chain may share some

    >>> from kinlib.chains.robots import rpr
    >>> [joint["kind"] for joint in arm_data(rpr(), [0, 1, 2])["joints"]]
    ['R', 'P', 'R']
    """
    size = extent(chain)
    return {
        "columns": list(columns),
        "joints": _joints(chain),
        "links": [path.tolist() for path in link_paths(chain)],
        "home": chain.home.ravel().tolist(),
        "frames": _frames(chain, size),
        "normals": _normals(chain, size),
    }


def extent(chain: Chain) -> float:
    """The longest side of an arm at home, in metres: the measure for all that is drawn to look right, not to scale.

    An arm without any length has the extent 1.

    >>> from kinlib.chains.robots import youbot
    >>> extent(youbot())
    0.5405
    """
    stations = np.concatenate([np.zeros((1, 3)), chain.joint_points, chain.home[None, :3, 3]])
    side = float(np.ptp(stations, axis=0).max())
    return side if side > COINCIDENT_TOL_M else 1.0


def link_paths(chain: Chain) -> list[Array]:
    """The lines (k, 3) along which links 0 to n run at home: along an axis, over the common normal, along the next axis.

    >>> from kinlib.chains.robots import puma560
    >>> link_paths(puma560())[3].round(4).tolist()            # the elbow: out by a3, then down by d4
    [[0.4318, 0.15, 0.0], [0.4521, 0.15, 0.0], [0.4521, 0.15, -0.4318]]
    """
    tool = chain.home[:3, 3]
    axes = [Z, *chain.lines.axis]
    points = [np.zeros(3), *chain.joint_points]
    paths = []
    for i in range(chain.n):
        normal = common_normal((axes[i], points[i]), (axes[i + 1], points[i + 1]), perpendicular(axes[i]), slide=True)
        paths.append(_path([points[i], normal.start, normal.end, points[i + 1]]))
    z, last = axes[-1], points[-1]
    paths.append(_path([last, last + z * (z @ (tool - last)), tool]))
    return paths


def _slider(chain: Chain, i: int, value: float, span: tuple[float, float] | None) -> dict[str, Any]:
    slides = chain.joint_types[i] == "P"
    far = DEFAULT_TRAVEL_M if slides else DEFAULT_ANGLE_RAD
    least, most = chain.limits[i] if chain.limits is not None else (-np.inf, np.inf)
    low, high = span or (
        least if np.isfinite(least) else min(-far, value),
        most if np.isfinite(most) else max(far, value),
    )
    if span and not low <= value <= high:
        raise ValueError(
            f"span should hold the start of joint {i + 1}, {value:.3g}; got {low:.3g} to {high:.3g}. Is one in degrees?"
        )
    title = chain.joint_names[i] if chain.joint_names else ""
    unit = "m" if slides else "rad"
    return {"column": i, "name": f"q_{i + 1}", "title": title, "unit": unit, "low": float(low), "high": float(high)}


def _stations(chain: Chain, q: Array) -> Array:
    """The points through which an arm runs: the base, every joint, the tool."""
    return np.concatenate([np.zeros((1, 3)), chain.link_poses(q)[:, :3, 3], chain.fk(q)[None, :3, 3]])


def _room(postures: Array, touched: Array, size: float) -> tuple[dict[str, Any], float]:
    """The ball that should be in view, and the height of the floor.

    The postures fill it with room for their frames; where the arm may go much farther, the picture gives some way.
    """
    low, high = postures.min(axis=0), postures.max(axis=0)
    centre = (low + high) / 2
    near = float(np.linalg.norm(high - low)) / 2 + 0.22 * size
    far = float(np.linalg.norm(touched - centre, axis=-1).max()) + 0.15 * size
    radius = min(max(near, far), 1.15 * near)
    lowest = float(postures[:, 2].min())
    # The lowest joint stands on the floor, not in it; an arm that hangs from its base gets room below.
    floor = lowest - (0.1 if lowest > -0.05 * size else 0.2) * size
    return {"centre": centre.tolist(), "radius": radius}, floor


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _path(points: list[Array]) -> Array:
    """A way through points, without steps of no length; straight, where the way is a detour."""
    corners = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - corners[-1]) > COINCIDENT_TOL_M:
            corners.append(point)
    way = np.array(corners)
    straight = float(np.linalg.norm(points[-1] - points[0]))
    if np.linalg.norm(np.diff(way, axis=0), axis=-1).sum() > MAX_DETOUR_RATIO * straight:
        way = np.array([points[0], points[-1]] if straight > COINCIDENT_TOL_M else [points[0]])
    return way + 0.0


def _joints(chain: Chain) -> list[dict[str, Any]]:
    axis, _, pitch = chain.lines
    return [
        {
            "kind": letter,
            "screw": screw.tolist(),
            "axis": z.tolist(),
            "point": point.tolist(),
            "shift": float(shift),
            # infinity is no JSON; what a slide travels for each unit of its value is 1
            "travel": 1.0 if letter == "P" else float(h) if letter == "H" else 0.0,
        }
        for letter, screw, z, point, h, shift in zip(
            chain.joint_types,
            chain.screws,
            axis,
            chain.joint_points,
            pitch,
            axial_offsets(axis, chain.joint_points),
            strict=True,
        )
    ]


def _frames(chain: Chain, size: float) -> dict[str, Any]:
    """The frames that can be shown, each with its name, its body and its pose at home."""
    n = chain.n
    ends = {"s": _frame("s", 0, np.eye(4)), "b": _frame("b", n, chain.home)}
    on_links = homogeneous(np.eye(3), chain.joint_points)
    shown: dict[str, Any] = {
        "base": [ends["s"]],
        "tool": [ends["b"]],
        "links": [_frame(str(i + 1), i + 1, T) for i, T in enumerate(on_links)],
    }
    if "H" in chain.joint_types:
        return shown  # a DH row has one variable, and a helical joint turns and climbs
    for convention in ("standard", "modified"):
        frames = assign_frames(chain, convention=convention).frames
        found = [_frame(str(i), i, T) for i, T in enumerate(frames) if _near(T[:3, 3], size)]
        found += [ends["s"]] * (not np.allclose(frames[0], np.eye(4)))
        found += [ends["b"]] * (not np.allclose(frames[-1], chain.home))
        shown[convention] = found
    return shown


def _frame(name: str, body: int, pose: Array) -> dict[str, Any]:
    return {"name": name, "body": body, "pose": (np.asarray(pose) + 0.0).ravel().tolist()}


def _normals(chain: Chain, size: float) -> list[dict[str, Any]]:
    """The common normal of each pair of neighbouring axes; body i carries the one from axis i to axis i + 1."""
    axes, points = chain.lines.axis, chain.joint_points
    found = []
    for i in range(chain.n - 1):
        normal = common_normal((axes[i], points[i]), (axes[i + 1], points[i + 1]), perpendicular(axes[i]), slide=True)
        if _near(normal.start, size) and _near(normal.end, size):
            found.append(
                {"body": i + 1, "from": normal.start.tolist(), "to": normal.end.tolist(), "along": normal.x.tolist()}
            )
    return found


def _near(point: Array, size: float) -> bool:
    return bool(np.abs(point).max() < MAX_DISTANCE_IN_ARM_SIZES * size)
