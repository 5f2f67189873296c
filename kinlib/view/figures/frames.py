"""Drawings of frames: by name, of the arm of a DH table, and of each step of a frame assignment.

A step is a stop for a player: the parts that are drawn after it, of which the current ones are strong.
"""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinlib.arrays import validation
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.dh.table import Convention, DHTable
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import ORANGE, PALE_GREY
from kinlib.view.drawing.picture import Picture
from kinlib.view.figures.arm import describe_arm, frame_text, pose_text
from kinlib.view.figures.joint_bodies import are_near, arm_size, draw_joint_bodies
from kinlib.view.figures.parts import Part, draw_parts, frame_part, line_part, ranks, tips

ASSIGNED = {"first": "Oxyz", "origin": "Oz", "x": "x", "y": "y", "last": "Oxyz"}
"""What a step assigns of its frame: O for the origin, and axes."""

MARKED = {"normal": "line", "row": "line", "origin": "O", "x": "line x", "y": "y", "first": "Oxyz", "last": "Oxyz"}
"""What a step is about, which the page marks: strong lines, and O, x, y and z of its frame."""


def draw_frames(frames: Mapping[str, ArrayLike], *, numbers: bool = False) -> Picture:
    """Draw frames by name.

    frames   {"s": T_ss, "b": T_sb, ...}, poses (4, 4) in one common frame
    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off

    Raises ValueError if a frame is not a pose.

    >>> draw_frames({"s": np.eye(4)}).alt
    'Frame {s} at (0, 0, 0), x along x, y along y, z along z.'
    """
    poses = {name: validation.poses(T, f"frame {name}") for name, T in frames.items()}
    every = np.array([*poses.values()])
    origins = every[:, :3, 3]
    canvas = _on_floor(np.concatenate([origins, tips(every, 0.5)]), origins[origins.any(axis=1)], numbers)
    for name, T in poses.items():
        canvas.triad(T, name, 0.25 * canvas.size)
    return canvas.picture(" ".join(map(frame_text, poses.items())), cropped=True)


def draw_table(
    table: DHTable,
    q: ArrayLike | None = None,
    *,
    numbers: bool = False,
    caption: str = "",
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw the arm that a table describes at q (n,), zero by default, with the frames of the table: x_i and z_i, without y_i.

    numbers  whether the grid has numbers and each origin a dotted line down to it, so that its coordinates can be read off
    around   points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    The translations of the rows lead from frame to frame: d along z in violet, a along x in orange.

    >>> draw_table(DHTable([[1, 0, 0, 0]], convention="standard")).alt
    'table. Frame {0} at (0, 0, 0), x along x, y along y, z along z. Frame {1} at (1, 0, 0), x along x, y along y, z along z.'
    """
    q = np.zeros(table.n) if q is None else validation.vectors(q, "q", table.n)
    frames = table.frames(q)
    origins, tip, chain = frames[:, :3, 3], frames[-1] @ table.tool, table.to_chain()
    ways = translations(frames, table.convention)
    seen = np.array([np.zeros(3), *origins, *(part["to"] for part in ways), tip[:3, 3]])
    canvas = _on_floor(seen if around is None else np.reshape(around, (-1, 3)), origins, numbers, view)
    canvas.line([np.zeros(3), origins[0]], PALE_GREY, 5.0, level=1)
    canvas.line([origins[-1], tip[:3, 3]], PALE_GREY, 5.0, level=1)
    draw_joint_bodies(canvas, chain, chain.link_poses(q))
    numbered = enumerate(zip(frames, ranks(origins), strict=True))
    shown = [frame_part(T, "xz", sub=str(i), rank=rank) for i, (T, rank) in numbered]
    draw_parts(canvas, [*(part | {"name": ""} for part in ways), *shown], canvas.size)
    for name, T, own in (("s", np.eye(4), frames[0]), ("b", tip, frames[-1])):
        if not np.allclose(T, own):
            canvas.triad(T, name, 0.16 * canvas.size)
    said = " ".join([f"{table.name}.", *(frame_text((str(i), T)) for i, T in enumerate(frames))])
    return canvas.picture(said, caption, cropped=around is None)


def _on_floor(seen: Array, measured: Array, numbers: bool, view: str = "default") -> Canvas:
    """Return a canvas with a floor; with numbers, the coordinates of the measured points (m, 3) can be read off."""
    seen = np.concatenate([seen, measured * (1, 1, 0)]) if numbers else seen
    canvas = Canvas(seen, view)
    canvas.floor(seen, numbers=numbers)
    if numbers:
        canvas.measure(measured, ORANGE)
    return canvas


def draw_assignment(assignment: FrameAssignment, until: int | None = None, *, caption: str = "") -> Picture:
    """Draw a frame assignment after the step `until` of its steps, counted from 0: that is strong, what came before is pale; or all.

    Joint axes are violet and dashed, common normals orange; a normal of length zero is a short line along its direction.
    y is drawn only while its frame is strong. While a row is read off, its a is a thick orange line and its d a violet one.

    >>> print(draw_assignment(kl.assign_frames(kl.robots.youbot(), convention="standard"), 3).alt)    # doctest: +NORMALIZE_WHITESPACE
    youBot, standard convention, step 4 of 25. O_1 lies on axis 2, where the common normal meets it: (0.033, 0, 0.147).
    Drawn so far: frame 0 at (0, 0, 0), x along x, z along z.
    """
    steps, chain = assignment.steps, assignment.chain
    stop = assignment_stop(assignment, len(steps) - 1 if until is None else until)
    near, feet = visible_features(assignment)
    seen = np.concatenate([chain.joint_points, chain.home[None, :3, 3], assignment.frames[near, :3, 3], feet])
    canvas = Canvas(seen)
    canvas.floor(seen)
    draw_joint_bodies(canvas, chain, chain.link_poses(np.zeros(chain.n)))
    # The joints have their numbers, so only lengths are named.
    parts = [part | {"name": part["name"] * (part.get("width") == 4)} for part in stop["parts"]]
    draw_parts(canvas, parts, canvas.size)
    return canvas.picture(stop["alt"], caption, cropped=True)


def assignment_stop(assignment: FrameAssignment, k: int, count: int | None = None) -> dict[str, Any]:
    """Return what is drawn and said after step k of an assignment, counted from 0: a stop for a page that shows count of them."""
    chain, frames, n = assignment.chain, assignment.frames, assignment.chain.n
    step, i = assignment.steps[k], assignment.steps[k].frame
    done = {(one.kind, one.frame) for one in assignment.steps[: k + 1]}
    finished = step.kind == "accuracy"
    beside = () if i is None else (i - 1, i)
    near, feet = visible_features(assignment)
    size = arm_size(chain)
    parts = []
    for axis, ends in enumerate(axis_ends(chain, feet)):
        strong = step.kind in {"axes", "accuracy"} or (step.kind == "normal" and axis in beside)
        parts.append(line_part(*ends, "axis", name=f"axis {axis + 1}", dashed=True, tip=True, strong=strong))
    for pair, normal in enumerate(assignment.normals, start=1):
        if ("normal", pair) in done:
            strong = finished or (step.kind in {"normal", "x"} and i == pair)
            half = 0.16 * size * normal.x * (np.linalg.norm(normal.end - normal.start) < 1e-6 * size)
            ends, name = (normal.start - half, normal.end + half), f"normal {pair}–{pair + 1}"
            width = 3 if strong else 2
            parts.append(line_part(*ends, "normal", name=name * strong, width=width, dashed=True, strong=strong))
    if step.kind == "row" and i is not None:
        parts += translations(frames[i - 1 : i + 1], assignment.table.convention, first=i)
    assigned = {
        j: "".join(sorted("".join(on for kind, on in ASSIGNED.items() if (kind, j) in done))) for j in range(n + 1)
    }
    shown = [j for j in range(n + 1) if assigned[j] and near[j]]
    for j, rank in zip(shown, ranks(frames[shown, :3, 3]), strict=True):
        T, strong = frames[j], finished or j == i or (step.kind == "row" and j in beside)
        # y follows from z and x
        letters = assigned[j] if strong and not finished else assigned[j].replace("y", "")
        parts.append(frame_part(T, letters, sub=str(j), rank=rank, strong=strong))
    axes = f" {describe_arm(chain, np.zeros(n))}" if step.kind == "axes" else ""
    whole = "; ".join(f"frame {j} {pose_text(frames[j], 'xz')}" for j in assigned if "y" in assigned[j])
    head = f"{chain.name}, {assignment.table.convention} convention, step {k + 1} of {count or len(assignment.steps)}."
    return {
        "text": step.text,
        "others": step.others,
        "alt": f"{head} {step.text}{axes} Drawn so far: {whole or 'the joints and their axes'}.",
        "parts": parts,
        "marked": MARKED.get(step.kind, ""),
        "row": i if step.kind == "row" else None,
    }


def translations(frames: Array, convention: Convention, first: int = 1) -> list[Part]:
    """Return the translations of rows between frames (m + 1, 4, 4): d along z and a along x, in the order of the convention.

    first  the number of the first row; those of length zero are left out
    """
    parts = []
    for i, (before, after) in enumerate(pairwise(frames), start=first):
        start, end = before[:3, 3], after[:3, 3]
        along = before[:3, 2 if convention == "standard" else 0]
        corner = start + along @ (end - start) * along
        names = (f"d_{i}", f"a_{i}") if convention == "standard" else (f"a_{i - 1}", f"d_{i}")
        for name, ends in zip(names, ((start, corner), (corner, end)), strict=True):
            if np.linalg.norm(ends[1] - ends[0]) > 1e-9:
                parts.append(line_part(*ends, "axis" if name[0] == "d" else "normal", name=name, width=4))
    return parts


def visible_features(assignment: FrameAssignment) -> tuple[NDArray[np.bool_], Array]:
    """Return which frames are near enough to the arm to be shown, (n + 1,), and the feet of normals that are, (m, 3)."""
    size = arm_size(assignment.chain)
    feet = np.reshape([foot for normal in assignment.normals for foot in (normal.start, normal.end)], (-1, 3))
    return are_near(assignment.frames[:, :3, 3], size), feet[are_near(feet, size)]


def ends_on_axis(z: Array, point: Array, places: ArrayLike, before: float, beyond: float) -> tuple[Array, Array]:
    """Return both ends of an axis, so far before and beyond its point and those of the places that are on it."""
    off = np.reshape(places, (-1, 3)) - point
    along = [0.0, *(off[np.linalg.norm(np.cross(z, off), axis=-1) < 1e-9] @ z).tolist()]
    return point + (min(along) - before) * z, point + (max(along) + beyond) * z


def axis_ends(chain: Chain, feet: Array) -> list[tuple[Array, Array]]:
    """Return both ends of each joint axis, long enough to contain the tool and the feet (m, 3) of normals that are on it."""
    size, places = arm_size(chain), [*feet, chain.home[:3, 3]]
    lines = zip(chain.lines.axis, chain.joint_points, strict=True)
    return [ends_on_axis(z, point, places, 0.24 * size, 0.34 * size) for z, point in lines]
