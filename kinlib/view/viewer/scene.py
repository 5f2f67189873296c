"""A robot as data for the page: joints, links, frames, sliders, and the region in view."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import assign_frames
from kinlib.rigid.lie import homogeneous, inverse
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.canvas import VIEWS, view_axes
from kinlib.view.figures.bodies import solid_data
from kinlib.view.figures.branches import Branch, branches, joint_share, robot_body
from kinlib.view.figures.joint_bodies import are_near, arm_size, axial_offsets, body_motions, stations
from kinlib.view.figures.parts import ranks

MIN_SIZE_IN_ROOM_RADII = 0.95
"""Joints, frames and arrows are drawn as for an arm of at least this size, relative to the radius of what is in view."""

HEIGHT_PER_WIDTH = 0.78
"""The shape of the picture on the page, as in js/viewer.js."""

LAYERS = ("axes", "body axes", "home axes", "base", "tool", "links", "standard", "modified", "dimensions", "trail")
"""The layers that the viewer can show: screw axes, frames, distances from joint to joint and the path of the tool."""

DEFAULT_ANGLE_RAD, DEFAULT_TRAVEL_M = np.pi, 1.0
"""The range of a slider to either side of 0 if the joint has no limits: 180 degrees, or one metre."""


def scene(
    robot: Chain | Tree,
    found: Sequence[Branch],
    start: Array,
    *,
    joints: Sequence[int] | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
) -> dict[str, Any]:
    """Return all that the page needs of a robot at start (n,), but its meshes; the arguments are those of `explore`.

    found  its branches

    Raises ValueError if the robot does not have one of the joints, or a frame is not a pose or is named otherwise than by its link.
    """
    kinds = {int(k): kind for one in found for k, kind in zip(one.columns, one.chain.joint_types, strict=True)}
    joints = [column + 1 for column in sorted(kinds)] if joints is None else list(joints)
    if wrong := [joint for joint in joints if joint not in range(1, robot.n + 1)]:
        raise ValueError(f"{robot.name} has joints 1 to {robot.n}; got {wrong[0]!r}.")
    limits = np.full((robot.n, 2), (-np.inf, np.inf)) if robot.limits is None else robot.limits
    titles = robot.joint_names or [""] * robot.n
    sliders = []
    for k in (joint - 1 for joint in joints):
        unit, far = ("m", DEFAULT_TRAVEL_M) if kinds[k] == "P" else ("rad", DEFAULT_ANGLE_RAD)
        low, high = np.where(np.isfinite(limits[k]), limits[k], (min(-far, start[k]), max(far, start[k]))).tolist()
        sliders.append({"column": k, "name": f"q_{k + 1}", "title": titles[k], "unit": unit, "low": low, "high": high})
    body, by_rule = robot_body(found)
    size = arm_size(*(branch.chain for branch in found))
    moved = np.concatenate([body_motions(one.chain, one.values(start)) for one in found])
    seen = [body.extent(moved), np.zeros((1, 3))]
    seen += [stations(one.chain, one.values(q)) for one in found for q in (start, np.zeros(robot.n))]
    given = frames_on_links(robot, start, frames) if frames and isinstance(robot, Chain) else {}
    places = np.reshape([np.asarray(T)[:3, 3] for T in (frames or {}).values()], (-1, 3))
    seen.append(places[are_near(places, size)])
    region = room(np.concatenate(seen), 0.2 * size)  # a margin for axes and labels
    solids, arms = iter(solid_data(body.links)), []
    for branch, rule in zip(found, by_rule, strict=True):
        arms.append(arm_data(branch) | {"body": [next(solids) for _ in rule], "rule": rule})
    if given:
        arms[0]["frames"] = given
    elif isinstance(robot, Tree):
        arms[0]["frames"]["base"] = [frame_data("s", 0, np.eye(4))]
    return {
        "name": robot.name,
        # If an arm is small compared with what is in view, its marks must stay large enough to be distinguished.
        "size": max(size, MIN_SIZE_IN_ROOM_RADII * region["radius"]) * joint_share(found),
        "arms": arms,
        "sliders": sliders,
        # JSON has no infinity
        "limits": [] if robot.limits is None else np.where(np.isfinite(limits), limits, np.array(None)).tolist(),
        "room": region,
        "floor": body.lowest,
        **({"offered": ["axes", "dimensions"]} if isinstance(robot, Tree) else {}),
    }


def bare_scene(chain: Chain, points: Array) -> dict[str, Any]:
    """Return the scene of the arm at home without a body and sliders, with a view that also contains points (m, 3)."""
    seen = np.concatenate([points, stations(chain)])
    arm = arm_data(branches(chain)[0], bare=True)
    return scene_of_parts(chain.name, seen, arm_size(chain)) | {"arms": [arm], "offered": ["dimensions"]}


def scene_of_parts(name: str, points: Array, size: float) -> dict[str, Any]:
    """Return the scene of parts and of a frame that moves, without a robot, with points (m, 3) in view."""
    frame = {"columns": [], "joints": [], "home": np.eye(4).ravel().tolist()}
    region = room(points, 0.1 * float(np.ptp(points, axis=0).max())) | {"constant": True}
    return {
        "name": name,
        "size": size,
        "arms": [frame],
        "room": region,
        "floor": float(points[:, 2].min()) - 0.1 * size,
        "offered": [],
    }


def arm_data(branch: Branch, *, bare: bool = False) -> dict[str, Any]:
    """Return a branch as data: joints, links, home and frames.

    A joint has its screw for the value that moves it, and where and how it is drawn. What an earlier branch shows too moves with
    this one, but is hidden. A bare arm, and a branch of a tree, have no frames but those of base and tool.
    """
    chain, joints = branch.chain, []
    axis, points = chain.lines.axis, chain.joint_points
    screws, shifts = branch.multipliers[:, None] * chain.screws, axial_offsets(axis, points)
    for i, letter in enumerate(chain.joint_types):
        place = {"axis": axis[i].tolist(), "point": points[i].tolist(), "shift": float(shifts[i])}
        named = {"number": int(branch.columns[i]) + 1, "name": branch.names[i], "hidden": i < branch.shared}
        joints.append({"kind": letter, "screw": screws[i].tolist()} | place | (named if branch.tip else {}))
    base, tool = frame_data("s", 0, np.eye(4)), frame_data(branch.tip or "b", chain.n, chain.home)
    frames = {"base": [] if branch.tip else [base], "tool": [tool]}
    if not (bare or branch.tip):
        links = enumerate(homogeneous(np.eye(3), points), start=1)
        frames |= {"links": [frame_data(str(i), i, T) for i, T in links]}
        # A DH row has one variable, and a helical joint would need two.
        for convention in () if "H" in chain.joint_types else ("standard", "modified"):
            assigned = assign_frames(chain, convention=convention).frames
            near = are_near(assigned[:, :3, 3], arm_size(chain))
            shown = [frame_data(str(i), i, T) for i, T in enumerate(assigned) if near[i]]
            shown += [base] * (not np.allclose(assigned[0], np.eye(4)))
            frames[convention] = shown + [tool] * (not np.allclose(assigned[-1], chain.home))
    return ({"tip": branch.tip} if branch.tip else {}) | {
        "columns": branch.columns.tolist(),
        "joints": joints,
        "links": [
            [] if i < branch.shared else link for i, link in enumerate(map(list, pairwise(stations(chain).tolist())))
        ],
        "home": chain.home.ravel().tolist(),
        "frames": frames,
    }


def frames_on_links(chain: Chain, q: Array, frames: Mapping[str, ArrayLike]) -> dict[str, Any]:
    """Return frames that are given at q, as `explore` takes them, as layers for the page: their poses at home.

    {s} and frame 0 are fixed to the base, {b} to the last link.

    Raises ValueError if a frame is not a pose, or its name is not a number, with or without a prime, "s" or "b".
    """
    moved, layers = body_motions(chain, q), {}
    poses = {name: validation.poses(T, f"frame {name}") for name, T in frames.items()}
    # Frames with the same origin have arrows of different length, so that none hides another.
    for (name, pose), rank in zip(poses.items(), ranks([T[:3, 3] for T in poses.values()]), strict=True):
        link = name.removesuffix("'")
        if not (link.isdigit() or name in {"s", "b"}):
            raise ValueError(
                f"frames must be named by the number of their link, or 's' or 'b'; got {name!r}. "
                'Name the frame on link 1 "1": frames={"1": T_01}.'
            )
        body = min(int(link), chain.n) if link.isdigit() else {"s": 0, "b": chain.n}[name]
        data = frame_data(name, body, inverse(moved[body]) @ pose)
        layers[f"frame {name}"] = [{**data, "rank": rank, "grey": name != link}]
    return layers


def room(points: Array, margin: float, look: Sequence[float] = VIEWS["default"]) -> dict[str, Any]:
    """Return the region in view: the middle of points (m, 3), and half its height with a margin in metres, for all named views."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    sheets = np.array([view_axes(look)[1], *(view_axes(view)[1] for view in VIEWS)])
    seen = np.abs((points - centre) @ sheets.swapaxes(-1, -2)).max(axis=(0, 1))
    return {"centre": centre.tolist(), "radius": max(HEIGHT_PER_WIDTH * float(seen[0]), float(seen[1])) + margin}


def frame_data(name: str, body: int, pose: Array) -> dict[str, Any]:
    """Return a frame on a body as data: its pose (4, 4) at home."""
    return {"name": name, "body": body, "pose": (np.asarray(pose) + 0.0).ravel().tolist()}
