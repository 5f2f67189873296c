"""An arm as data for the viewer: its geometry at home, which the page moves by the exponentials of the screws.

Every part is fixed to a body: body 0 is the base, body i is what joint i moves. Parts are given at home, in {s}.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.dh.common_normal import common_normal
from kinlib.rigid.lie import homogeneous, inverse, perpendicular
from kinlib.view.drawing.canvas import VIEWS, axes_of_view
from kinlib.view.figures.bodies import body_of, solid_data
from kinlib.view.figures.frame_assignment import MAX_DISTANCE_IN_ARM_SIZES
from kinlib.view.figures.joint_bodies import axial_offsets, carried_axes, stations

MAX_DETOUR_RATIO = 2.5
"""The lengths of a link are along its axes and their common normal, unless that is longer than the straight line by this factor."""

MIN_SIZE_IN_ROOM_RADII = 0.95
"""Joints, frames and arrows are drawn as for an arm of at least this size, relative to the radius of what is in view."""

HEIGHT_PER_WIDTH = 0.78
"""The shape of the picture on the page, as in js/viewer.js."""

Z = np.eye(3)[2]
COINCIDENT_TOL_M = 1e-9


FRAME_LAYERS = ("base", "tool", "links", "standard", "modified")
LAYERS = (*("axes", "body axes", "home axes"), *FRAME_LAYERS, *("normals", "dimensions", "trail"))
"""The layers that the viewer can show: screw axes, frames, normals, dimensions and the path of the tool."""

DEFAULT_ANGLE_RAD, DEFAULT_TRAVEL_M = np.pi, 1.0
"""The range of a slider to either side of 0 if the joint has no limits: 180 degrees, or one metre."""


def scene(
    chain: Chain,
    start: Array,
    *,
    joints: Sequence[int] | None = None,
    span: tuple[float, float] | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
) -> dict[str, Any]:
    """Return all that the page needs of an arm: its geometry, its sliders, and the region in view.

    start   (n,) the first joint values
    joints  the joints that get a slider, counted from 1
    span    the range of the sliders; by default the limits of each joint, or 180 degrees or one metre if it has none
    frames  {"0": T, "1": T, ...} poses (4, 4) at start of frames that replace those of the arm; each is a layer "frame i"

    Raises ValueError if the arm does not have one of the joints, start does not have n values, span does not contain them, or
    a frame is not a pose or is named otherwise than by its link.

    >>> from kinlib.chains.robots import rpr
    >>> scene(rpr(), np.zeros(3), joints=[2])["sliders"][0]["unit"]
    'm'
    """
    joints = list(range(1, chain.n + 1)) if joints is None else list(joints)
    if wrong := [joint for joint in joints if joint not in range(1, chain.n + 1)]:
        raise ValueError(f"{chain.name} has joints 1 to {chain.n}; got {wrong[0]!r}.")
    chain.fk(start)  # raises ValueError if start has another size
    limits = [(-np.inf, np.inf)] * chain.n if chain.limits is None else chain.limits
    titles = chain.joint_names or [""] * chain.n
    sliders = [
        joint_slider(i, chain.joint_types[i] == "P", limits[i], float(start[i]), title=titles[i], span=span)
        for i in (joint - 1 for joint in joints)
    ]
    body = body_of(chain)
    moved = body_motions(chain, np.asarray(start))
    configurations = np.concatenate([stations(chain), stations(chain, start), body.extent(moved)])
    view = room(configurations, _tips(chain, start), extent(chain))
    arm = arm_data(chain) | {"body": solid_data(body.links)}
    if frames:
        arm["frames"] = frames_on_links(chain, start, frames)
    return {
        "name": chain.name,
        # If an arm is small compared with what is in view, its marks must stay large enough to be distinguished.
        "size": max(extent(chain), MIN_SIZE_IN_ROOM_RADII * view["radius"]),
        "arms": [arm],
        "sliders": sliders,
        "limits": finite_limits(chain.limits) if chain.limits is not None else [],
        "room": view,
        "floor": body.lowest,
        "foot": [0.0, 0.0, 0.0],
    }


def bare_scene(chain: Chain, points: Array, share: float) -> dict[str, Any]:
    """Return the scene of the arm at home without sliders, with a view that also contains points (m, 3), see `still_room`."""
    data = scene(chain, np.zeros(chain.n), joints=[])
    room = still_room(np.concatenate([points, stations(chain)]), share)
    data["arms"][0].pop("body")  # the axes are to be seen
    data["arms"][0]["links"] = skeleton(chain)
    lowest = float(stations(chain)[:, 2].min())
    floor = lowest - (0.1 if lowest > -0.05 * extent(chain) else 0.2) * extent(chain)
    return {**data, "size": max(extent(chain), room["radius"]), "room": room, "floor": floor, "offered": ["dimensions"]}


def arm_data(chain: Chain) -> dict[str, Any]:
    """Return an arm as data: joints, links, home, frames in each convention, common normals.

    >>> from kinlib.chains.robots import rpr
    >>> [joint["kind"] for joint in arm_data(rpr())["joints"]]
    ['R', 'P', 'R']
    """
    size = extent(chain)
    return {
        "columns": list(range(chain.n)),
        "joints": joint_data(chain),
        "links": [path.tolist() for path in link_paths(chain)],
        "home": chain.home.ravel().tolist(),
        "frames": _frames(chain, size),
        "normals": _normals(chain, size),
    }


def skeleton(chain: Chain) -> list[list[list[float]]]:
    """Return the lines of links 0 to n at home, straight from joint to joint: a bend would show a common normal.

    >>> from kinlib.chains.robots import rpr
    >>> len(skeleton(rpr()))
    4
    """
    return [np.array(pair).tolist() for pair in pairwise(stations(chain))]


def frames_on_links(chain: Chain, q: Array, frames: Mapping[str, ArrayLike]) -> dict[str, Any]:
    """Return frames that are given at q, each fixed to its link, as layers for the page: their poses at home.

    frames  {"0": T, "1": T, ..., "s": T, "b": T} poses (4, 4) in {s}: frame i is fixed to link i, or to the last link if i > n;
            {s} and frame 0 are fixed to the base, {b} to the last link

    Raises ValueError if a frame is not a pose, or its name is not a number, "s" or "b".

    >>> from kinlib.chains.robots import rpr
    >>> layers = frames_on_links(rpr(), np.array([0, 0.5, 0]), {"2": rpr().link_poses([0, 0.5, 0])[1]})
    >>> np.reshape(layers["frame 2"][0]["pose"], (4, 4))[:3, 3] - rpr().joint_points[1]      # at home, where joint 2 is 0
    array([0., 0., 0.])
    """
    moved = body_motions(chain, q)
    layers: dict[str, Any] = {}
    origins: list[Array] = []
    for name, T in frames.items():
        if not (name.isdigit() or name in {"s", "b"}):
            raise ValueError(
                f"frames must be named by the number of their link, or 's' or 'b'; got {name!r}. "
                'Name the frame on link 1 "1": frames={"1": T_01}.'
            )
        body = min(int(name), chain.n) if name.isdigit() else {"s": 0, "b": chain.n}[name]
        pose = validation.poses(T, f"frame {name}")
        # Frames with the same origin have arrows of different length, so that none hides another.
        rank = sum(bool(np.allclose(pose[:3, 3], origin, atol=1e-6)) for origin in origins)
        origins.append(pose[:3, 3])
        layers[f"frame {name}"] = [{**frame_data(name, body, inverse(moved[body]) @ pose), "rank": rank}]
    return layers


def body_motions(chain: Chain, q: Array) -> Array:
    """Return the motion of each body from home to q, (n + 1, 4, 4): body 0 is the base, body i is what joint i moves.

    >>> from kinlib.chains.robots import rpr
    >>> body_motions(rpr(), np.array([0, 0.5, 0]))[2, :3, 3]
    array([0. , 0. , 0.5])
    """
    moved = chain.link_poses(q) @ inverse(chain.link_poses(np.zeros(chain.n)))
    return np.concatenate([np.eye(4)[None], moved])


def extent(chain: Chain) -> float:
    """Return the longest side of an arm at home, in metres: the unit of length of what is not drawn to scale.

    An arm of zero length has the extent 1.

    >>> from kinlib.chains.robots import youbot
    >>> extent(youbot())
    0.5405
    """
    side = float(np.ptp(stations(chain), axis=0).max())
    return side if side > COINCIDENT_TOL_M else 1.0


def half_height(points: Array, look: Sequence[float] = VIEWS["default"]) -> float:
    """Return half the height of a picture in which points (m, 3) about its centre are in view, from `look` and in all named views.

    >>> half_height(np.array([[0.0, 0, 2], [0, 0, -2]]))
    2.0
    """
    views = [look, *VIEWS.values()]
    seen = [np.abs(points @ axes_of_view(*view)[1].T).max(axis=0) for view in views]
    return max(float(max(HEIGHT_PER_WIDTH * right, up)) for right, up in seen)


def link_paths(chain: Chain) -> list[Array]:
    """Return the lines (k, 3) of links 0 to n at home: along an axis, along the common normal, along the next axis.

    >>> from kinlib.chains.robots import puma560
    >>> link_paths(puma560())[3].round(4).tolist()            # the elbow: out by a3, then down by d4
    [[0.4318, 0.15, 0.0], [0.4521, 0.15, 0.0], [0.4521, 0.15, -0.4318]]
    """
    tool = chain.home[:3, 3]
    axes = [Z, *chain.lines.axis]
    points = [np.zeros(3), *chain.joint_points]
    paths = []
    for i in range(chain.n):
        normal = common_normal(
            (axes[i], points[i]), (axes[i + 1], points[i + 1]), perpendicular(axes[i]), at_other_point=True
        )
        paths.append(_path([points[i], normal.start, normal.end, points[i + 1]]))
    z, last = axes[-1], points[-1]
    paths.append(_path([last, last + z * (z @ (tool - last)), tool]))
    return paths


def joint_slider(
    column: int,
    is_prismatic: bool,
    limits: ArrayLike,
    value: float,
    *,
    title: str = "",
    span: tuple[float, float] | None = None,
) -> dict[str, Any]:
    """Return the slider of the joint value in a column of q, from 0; its range is span, or its limits where it has them.

    Raises ValueError if span does not contain the value.

    >>> joint_slider(0, True, (0, np.inf), 0.5)
    {'column': 0, 'name': 'q_1', 'title': '', 'unit': 'm', 'low': 0.0, 'high': 1.0}
    """
    far = DEFAULT_TRAVEL_M if is_prismatic else DEFAULT_ANGLE_RAD
    least, most = np.asarray(limits, dtype=float)
    low, high = span or (
        least if np.isfinite(least) else min(-far, value),
        most if np.isfinite(most) else max(far, value),
    )
    if span and not low <= value <= high:
        raise ValueError(
            f"span must contain the start of joint {column + 1}, {value:.3g}; got {low:.3g} to {high:.3g}. "
            "Is one of them in degrees?"
        )
    unit = "m" if is_prismatic else "rad"
    return {
        "column": column,
        "name": f"q_{column + 1}",
        "title": title,
        "unit": unit,
        "low": float(low),
        "high": float(high),
    }


def finite_limits(limits: Array) -> list[list[float | None]]:
    """Return limits (n, 2) for JSON, which has no infinity.

    >>> finite_limits(np.array([[0, np.inf]]))
    [[0.0, None]]
    """
    return [[float(end) if np.isfinite(end) else None for end in pair] for pair in limits]


def _tips(chain: Chain, q: Array) -> Array:
    """Return the tips of the arrows along the joint axes, and of the axes of {s} and {b}."""
    links, tool, size = chain.link_poses(q), chain.fk(q), extent(chain)
    axes = links[:, :3, 3] + 0.36 * size * carried_axes(chain, links)
    return np.concatenate([axes, 0.2 * size * np.eye(3), tool[:3, 3] + 0.2 * size * tool[:3, :3].T])


def room(configurations: Array, tips: Array, size: float) -> dict[str, Any]:
    """Return the region that must be in view.

    The configurations shown (m, 3) and the tips of their arrows (k, 3) fill the picture, with a margin for labels. If the arm
    moves farther, the page zooms out.

    >>> room(np.eye(3), np.zeros((1, 3)), size=1.0)["centre"]
    [0.5, 0.5, 0.5]
    """
    seen = np.concatenate([configurations, tips])
    centre = (seen.min(axis=0) + seen.max(axis=0)) / 2
    return {"centre": centre.tolist(), "radius": half_height(seen - centre) + 0.1 * size}


def still_room(points: Array, share: float) -> dict[str, Any]:
    """Return the region in view of what does not leave its place: a share of the sphere around points (m, 3).

    >>> still_room(np.array([[0, 0, 0], [0, 0, 2.0]]), 0.5)
    {'centre': [0.0, 0.0, 1.0], 'radius': 0.5, 'constant': True}
    """
    low, high = points.min(axis=0), points.max(axis=0)
    radius = share * float(np.linalg.norm(high - low)) / 2
    return {"centre": ((low + high) / 2).tolist(), "radius": radius, "constant": True}


def _path(points: list[Array]) -> Array:
    """Return the path through points without repeated ones, or the straight line if the path is a detour."""
    corners = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - corners[-1]) > COINCIDENT_TOL_M:
            corners.append(point)
    path = np.array(corners)
    straight = float(np.linalg.norm(points[-1] - points[0]))
    if np.linalg.norm(np.diff(path, axis=0), axis=-1).sum() > MAX_DETOUR_RATIO * straight:
        path = np.array([points[0], points[-1]] if straight > COINCIDENT_TOL_M else [points[0]])
    return path + 0.0


def joint_data(chain: Chain) -> list[dict[str, Any]]:
    """Return the joints of an arm as data: their screws, and where and how they are drawn.

    >>> from kinlib.chains.robots import rpr
    >>> [joint["travel"] for joint in joint_data(rpr())]
    [0.0, 1.0, 0.0]
    """
    axis, _, pitch = chain.lines
    return [
        {
            "kind": letter,
            "screw": screw.tolist(),
            "axis": z.tolist(),
            "point": point.tolist(),
            "shift": float(shift),
            # JSON has no infinity; a prismatic joint translates by 1 for each unit of its value
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
    """Return the frames that can be shown, each with its name, its body and its pose at home."""
    n = chain.n
    ends = {"s": frame_data("s", 0, np.eye(4)), "b": frame_data("b", n, chain.home)}
    on_links = homogeneous(np.eye(3), chain.joint_points)
    shown: dict[str, Any] = {
        "base": [ends["s"]],
        "tool": [ends["b"]],
        "links": [frame_data(str(i + 1), i + 1, T) for i, T in enumerate(on_links)],
    }
    if "H" in chain.joint_types:
        return shown  # a DH row has one variable, and a helical joint would need two
    for convention in ("standard", "modified"):
        frames = assign_frames(chain, convention=convention).frames
        drawable = [frame_data(str(i), i, T) for i, T in enumerate(frames) if _near(T[:3, 3], size)]
        drawable += [ends["s"]] * (not np.allclose(frames[0], np.eye(4)))
        drawable += [ends["b"]] * (not np.allclose(frames[-1], chain.home))
        shown[convention] = drawable
    return shown


def frame_data(name: str, body: int, pose: Array) -> dict[str, Any]:
    """Return a frame on a body as data: its pose (4, 4) at home.

    >>> frame_data("b", 3, np.eye(4))["name"]
    'b'
    """
    return {"name": name, "body": body, "pose": (np.asarray(pose) + 0.0).ravel().tolist()}


def _normals(chain: Chain, size: float) -> list[dict[str, Any]]:
    """Return the common normals of consecutive axes; the one from axis i to axis i + 1 is fixed to body i."""
    axes, points = chain.lines.axis, chain.joint_points
    normals = []
    for i in range(chain.n - 1):
        normal = common_normal(
            (axes[i], points[i]), (axes[i + 1], points[i + 1]), perpendicular(axes[i]), at_other_point=True
        )
        if _near(normal.start, size) and _near(normal.end, size):
            normals.append(
                {"body": i + 1, "from": normal.start.tolist(), "to": normal.end.tolist(), "along": normal.x.tolist()}
            )
    return normals


def _near(point: Array, size: float) -> bool:
    return bool(np.abs(point).max() < MAX_DISTANCE_IN_ARM_SIZES * size)
