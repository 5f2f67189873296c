"""A robot as data for the viewer: its geometry at home, which the page moves by the exponentials of the screws.

Each branch of a robot is an arm on the page; most robots have one. Every part is fixed to a body of its arm: body 0 is the base,
body i is what joint i moves. Parts are given at home, in {s}.
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
from kinlib.dh.common_normal import CommonNormal, common_normal
from kinlib.rigid.lie import homogeneous, inverse, perpendicular
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.canvas import VIEWS, axes_of_view
from kinlib.view.figures.arm import body_motions
from kinlib.view.figures.bodies import solid_data
from kinlib.view.figures.frame_assignment import MAX_DISTANCE_IN_ARM_SIZES
from kinlib.view.figures.joint_bodies import axial_offsets, carried_axes, stations
from kinlib.view.figures.tree import Branch, branches, joint_share, robot_body

MAX_DETOUR_RATIO = 2.5
"""The lengths of a link are along its axes and their common normal, unless that is longer than the straight line by this factor."""

MIN_SIZE_IN_ROOM_RADII = 0.95
"""Joints, frames and arrows are drawn as for an arm of at least this size, relative to the radius of what is in view."""

HEIGHT_PER_WIDTH = 0.78
"""The shape of the picture on the page, as in js/viewer.js."""

COINCIDENT_TOL_M = 1e-9

FRAME_LAYERS = ("base", "tool", "links", "standard", "modified")
LAYERS = (*("axes", "body axes", "home axes"), *FRAME_LAYERS, *("normals", "dimensions", "trail"))
"""The layers that the viewer can show: screw axes, frames, normals, dimensions and the path of the tool."""

DEFAULT_ANGLE_RAD, DEFAULT_TRAVEL_M = np.pi, 1.0
"""The range of a slider to either side of 0 if the joint has no limits: 180 degrees, or one metre."""


def scene(
    robot: Chain | Tree,
    start: Array,
    *,
    joints: Sequence[int] | None = None,
    span: tuple[float, float] | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
) -> dict[str, Any]:
    """Return all that the page needs of a robot: its geometry, its sliders, and the region in view.

    start   (n,) the first values of the (independent) joints
    joints  the joints that get a slider, counted from 1
    span    the range of the sliders; by default the limits of each joint, or 180 degrees or one metre if it has none
    frames  {"0": T, "1": T, ...} poses (4, 4) at start of frames that replace those of an arm; each is a layer "frame i"

    Raises ValueError if the robot does not have one of the joints, span does not contain the start, or a frame is not a pose or is
    named otherwise than by its link.

    >>> from kinlib.chains.robots import rpr
    >>> scene(rpr(), np.zeros(3), joints=[2])["sliders"][0]["unit"]
    'm'
    """
    found = branches(robot)
    slides = {int(k): kind == "P" for one in found for k, kind in zip(one.columns, one.chain.joint_types, strict=True)}
    joints = [column + 1 for column in sorted(slides)] if joints is None else list(joints)
    if wrong := [joint for joint in joints if joint not in range(1, robot.n + 1)]:
        raise ValueError(f"{robot.name} has joints 1 to {robot.n}; got {wrong[0]!r}.")
    limits = np.full((robot.n, 2), (-np.inf, np.inf)) if robot.limits is None else robot.limits
    titles = robot.joint_names or [""] * robot.n
    body, bodies = robot_body(robot, found)
    size = extent(*found)
    seen = [body.extent(np.concatenate([branch.motions(start) for branch in found])), 0.2 * size * np.eye(3)]
    for branch in found:
        poses, tool = (f(branch.values(start)) for f in (branch.chain.link_poses, branch.chain.fk))
        axes = carried_axes(branch.chain, poses)
        seen += [stations(branch.chain), branch.stations(start), poses[:, :3, 3] + 0.36 * size * axes]
        seen.append(tool[:3, 3] + 0.2 * size * tool[:3, :3].T)
    points = np.concatenate(seen)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = half_height(points - centre) + 0.1 * size  # a margin for labels
    arms = [arm_data(branch) | {"body": solid_data(own.links)} for branch, own in zip(found, bodies, strict=True)]
    if frames and isinstance(robot, Chain):
        arms[0]["frames"] = frames_on_links(robot, start, frames)
    elif isinstance(robot, Tree):
        arms[0]["frames"]["base"] = [frame_data("s", 0, np.eye(4))]
        for arm, own in zip(arms, bodies, strict=True):
            arm["rule"] = list(own.by_rule)
    return {
        "name": robot.name,
        # If an arm is small compared with what is in view, its marks must stay large enough to be distinguished.
        "size": max(size, MIN_SIZE_IN_ROOM_RADII * radius) * joint_share(found),
        "arms": arms,
        "sliders": [
            _slider(k, slides[k], limits[k], float(start[k]), span) | {"title": titles[k]}
            for k in (joint - 1 for joint in joints)
        ],
        # JSON has no infinity
        "limits": [] if robot.limits is None else [[_finite(end) for end in pair] for pair in limits],
        "room": {"centre": centre.tolist(), "radius": radius},
        "floor": body.lowest,
        **({"offered": ["axes", "dimensions"]} if isinstance(robot, Tree) else {}),
    }


def bare_scene(chain: Chain, points: Array, share: float) -> dict[str, Any]:
    """Return the scene of the arm at home without sliders, with a view that also contains points (m, 3), see `still_room`."""
    data = scene(chain, np.zeros(chain.n), joints=[])
    room = still_room(np.concatenate([points, stations(chain)]), share)
    data["arms"][0].pop("body")  # the axes are to be seen
    data["arms"][0]["links"] = skeleton(chain)
    size, lowest = extent(*branches(chain)), float(stations(chain)[:, 2].min())
    floor = lowest - (0.1 if lowest > -0.05 * size else 0.2) * size
    return {**data, "size": max(size, room["radius"]), "room": room, "floor": floor, "offered": ["dimensions"]}


def arm_data(branch: Branch) -> dict[str, Any]:
    """Return a branch as data: joints, links, home, frames and common normals.

    What an earlier branch shows too moves with this one, but is hidden. Only an arm has frames in each convention.
    """
    chain, is_arm = branch.chain, not branch.tip
    size = extent(branch)
    tool = {"tool": [frame_data(branch.tip or "b", chain.n, chain.home)]}
    paths = _link_paths(chain) if is_arm else skeleton(chain)
    return {
        **({} if is_arm else {"tip": branch.tip}),
        "columns": branch.columns.tolist(),
        "joints": _joints(branch),
        "links": [[] if i < branch.shared else path for i, path in enumerate(paths)],
        "home": chain.home.ravel().tolist(),
        "frames": _frames(chain, size) if is_arm else {"base": [], **tool},
        "normals": _normals(chain, size) if is_arm else [],
    }


def skeleton(chain: Chain) -> list[list[list[float]]]:
    """Return the lines of links 0 to n at home, straight from joint to joint: a bend would show a common normal."""
    return [np.array(pair).tolist() for pair in pairwise(stations(chain))]


def frames_on_links(chain: Chain, q: Array, frames: Mapping[str, ArrayLike]) -> dict[str, Any]:
    """Return frames that are given at q, each fixed to its link, as layers for the page: their poses at home.

    frames  {"0": T, "1": T, "1'": T, ..., "s": T, "b": T} poses (4, 4) in {s}: frame i is fixed to link i, or to the last link if
            i > n; {s} and frame 0 are fixed to the base, {b} to the last link. A frame with a prime is grey, to be compared with

    Raises ValueError if a frame is not a pose, or its name is not a number, with or without a prime, "s" or "b".
    """
    moved = body_motions(chain, q)
    layers: dict[str, Any] = {}
    origins: list[Array] = []
    for name, T in frames.items():
        link = name.removesuffix("'")
        if not (link.isdigit() or name in {"s", "b"}):
            raise ValueError(
                f"frames must be named by the number of their link, or 's' or 'b'; got {name!r}. "
                'Name the frame on link 1 "1": frames={"1": T_01}.'
            )
        body = min(int(link), chain.n) if link.isdigit() else {"s": 0, "b": chain.n}[name]
        pose = validation.poses(T, f"frame {name}")
        # Frames with the same origin have arrows of different length, so that none hides another.
        rank = sum(bool(np.allclose(pose[:3, 3], origin, atol=1e-6)) for origin in origins)
        origins.append(pose[:3, 3])
        layers[f"frame {name}"] = [
            {**frame_data(name, body, inverse(moved[body]) @ pose), "rank": rank, "grey": name != link}
        ]
    return layers


def extent(*arms: Branch) -> float:
    """Return the longest side of a robot at home, in metres: the unit of length of what is not drawn to scale; 1 if it is 0."""
    side = float(np.ptp(np.concatenate([stations(branch.chain) for branch in arms]), axis=0).max())
    return side if side > COINCIDENT_TOL_M else 1.0


def half_height(points: Array, look: Sequence[float] = VIEWS["default"]) -> float:
    """Return half the height of a picture in which points (m, 3) about its centre are in view, from `look` and in all named views."""
    views = [look, *VIEWS.values()]
    seen = [np.abs(points @ axes_of_view(*view)[1].T).max(axis=0) for view in views]
    return max(float(max(HEIGHT_PER_WIDTH * right, up)) for right, up in seen)


def still_room(points: Array, share: float) -> dict[str, Any]:
    """Return the region in view of what does not leave its place: a share of the sphere around points (m, 3)."""
    low, high = points.min(axis=0), points.max(axis=0)
    radius = share * float(np.linalg.norm(high - low)) / 2
    return {"centre": ((low + high) / 2).tolist(), "radius": radius, "constant": True}


def frame_data(name: str, body: int, pose: Array) -> dict[str, Any]:
    """Return a frame on a body as data: its pose (4, 4) at home."""
    return {"name": name, "body": body, "pose": (np.asarray(pose) + 0.0).ravel().tolist()}


def _slider(
    column: int, is_prismatic: bool, limits: Array, value: float, span: tuple[float, float] | None
) -> dict[str, Any]:
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
    ends = {"low": float(low), "high": float(high)}
    return {"column": column, "name": f"q_{column + 1}", "unit": unit, **ends}


def _finite(end: float) -> float | None:
    return float(end) if np.isfinite(end) else None


def _link_paths(chain: Chain) -> list[list[list[float]]]:
    """Return the lines of links 0 to n at home: along an axis, along the common normal, along the next axis."""
    z, last, tool = chain.lines.axis[-1], chain.joint_points[-1], chain.home[:3, 3]
    first = _normal((np.eye(3)[2], np.zeros(3)), (chain.lines.axis[0], chain.joint_points[0]))
    paths = [
        [start, normal.start, normal.end, end]
        for (start, end), normal in zip(
            pairwise([np.zeros(3), *chain.joint_points]), [first, *_consecutive(chain)], strict=True
        )
    ]
    return [_path(path).tolist() for path in [*paths, [last, last + z * (z @ (tool - last)), tool]]]


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


def _joints(branch: Branch) -> list[dict[str, Any]]:
    """Return the joints of a branch: their screws for the values that move them, and where and how they are drawn."""
    chain = branch.chain
    axis, _, pitch = chain.lines
    shifts = axial_offsets(axis, chain.joint_points)
    return [
        {
            "kind": letter,
            "screw": (branch.multipliers[i] * chain.screws[i]).tolist(),
            "axis": axis[i].tolist(),
            "point": chain.joint_points[i].tolist(),
            "shift": float(shifts[i]),
            # JSON has no infinity; a prismatic joint translates by 1 for each unit of its value
            "travel": float(branch.multipliers[i]) * {"P": 1.0, "R": 0.0}.get(letter, float(pitch[i])),
            **(
                {"number": int(branch.columns[i]) + 1, "name": branch.names[i], "hidden": i < branch.shared}
                if branch.tip
                else {}
            ),
        }
        for i, letter in enumerate(chain.joint_types)
    ]


def _frames(chain: Chain, size: float) -> dict[str, Any]:
    """Return the frames of an arm that can be shown, each with its name, its body and its pose at home."""
    n = chain.n
    ends = {"s": frame_data("s", 0, np.eye(4)), "b": frame_data("b", n, chain.home)}
    on_links = homogeneous(np.eye(3), chain.joint_points)
    links = [frame_data(str(i + 1), i + 1, T) for i, T in enumerate(on_links)]
    shown: dict[str, Any] = {"base": [ends["s"]], "tool": [ends["b"]], "links": links}
    # A DH row has one variable, and a helical joint would need two.
    for convention in () if "H" in chain.joint_types else ("standard", "modified"):
        frames = assign_frames(chain, convention=convention).frames
        drawable = [frame_data(str(i), i, T) for i, T in enumerate(frames) if _near(T[:3, 3], size)]
        drawable += [ends["s"]] * (not np.allclose(frames[0], np.eye(4)))
        drawable += [ends["b"]] * (not np.allclose(frames[-1], chain.home))
        shown[convention] = drawable
    return shown


def _normals(chain: Chain, size: float) -> list[dict[str, Any]]:
    """Return the common normals of consecutive axes; the one from axis i to axis i + 1 is fixed to body i."""
    return [
        {"body": i, "from": normal.start.tolist(), "to": normal.end.tolist(), "along": normal.x.tolist()}
        for i, normal in enumerate(_consecutive(chain), start=1)
        if _near(normal.start, size) and _near(normal.end, size)
    ]


def _consecutive(chain: Chain) -> list[CommonNormal]:
    return [_normal(*pair) for pair in pairwise(zip(chain.lines.axis, chain.joint_points, strict=True))]


def _normal(first: tuple[Array, Array], second: tuple[Array, Array]) -> CommonNormal:
    return common_normal(first, second, perpendicular(first[0]), at_other_point=True)


def _near(point: Array, size: float) -> bool:
    return bool(np.abs(point).max() < MAX_DISTANCE_IN_ARM_SIZES * size)
