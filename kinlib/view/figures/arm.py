"""Drawings of robots in any configuration: bodies, joints, screw axes and frames, and the text alternative of such a drawing."""

from collections.abc import Collection, Mapping

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.chains.chain import Chain
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, GREY, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.branches import Branch, branches, joint_share, robot_body
from kinlib.view.figures.joint_bodies import body_motions, carried_axes, draw_joint_bodies, stations

ARM_LAYERS = {"axes", "body axes", "home axes", "links", "tool", "base"}
JOINT_KINDS = {"R": "revolute", "P": "prismatic", "H": "helical"}


def draw_arm(
    robot: Chain | Tree,
    q: JointValues | None = None,
    *,
    show: Collection[str] = ("axes", "base", "tool"),
    caption: str = "",
    ghost: JointValues | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw an arm, or a robot with branches, in a configuration.

    q       (n,) joint values, or a mapping from joint names to values; home by default
    show    any of "axes" (the screw axes S_i as the joints have moved them), "home axes" (the same axes at home), "body axes"
            (as "axes", but named B_i), "links" (a frame on each link), "base" ({s}) and "tool" ({b}, or the tip of each branch)
    ghost   (n,) another configuration, drawn in grey
    frames  {"0": T_00, "1": T_01, ...} frames to draw, poses (4, 4) in {s} at q; those with a prime, "1'", in grey
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    The text alternative describes the axes and the end-effector at q, as they are drawn.

    Raises ValueError if q or ghost does not have n values, if a frame is not a pose, if show has another entry, or if no joint
    moves by one value.

    >>> print(draw_arm(kl.robots.youbot()).alt)                     # doctest: +NORMALIZE_WHITESPACE
    youBot, 5 joints (RRRRR), at home. Joint 1 revolute along z at (0, 0, 0); joint 2 revolute along -y at (0.033, 0,
    0.147); joint 3 revolute along -y at (0.188, 0, 0.147); joint 4 revolute along -y at (0.323, 0, 0.147); joint 5 revolute
    along x at (0.323, 0, 0.147). The end-effector is at (0.54, 0, 0.147) m.
    """
    if unknown := set(show) - ARM_LAYERS:
        names = ", ".join(map(repr, sorted(unknown)))
        raise ValueError(f"show may contain {', '.join(sorted(ARM_LAYERS))}; got {names}.")
    validation.instance(robot, "robot", Chain, Tree)
    q = np.zeros(robot.n) if q is None else validation.single(robot.in_order(q), "q")
    ghost = None if ghost is None else validation.single(robot.in_order(ghost), "ghost")
    found = branches(robot)
    body, moved = robot_body(found)[0], np.concatenate([body_motions(one.chain, one.values(q)) for one in found])
    paths, ghosts = ([stations(one.chain, one.values(p)) for one in found if p is not None] for p in (q, ghost))
    seen = np.concatenate([*paths, *ghosts, body.extent(moved)]) if around is None else np.reshape(around, (-1, 3))
    canvas = Canvas(seen, view, sizes=np.concatenate([stations(branch.chain) for branch in found]))
    canvas.floor(seen, height=body.lowest)
    canvas.size *= joint_share(found)
    for path in ghosts:
        canvas.line(path, GHOST_GREY, 6.0, level=1)
    draw_body(canvas, body, moved)
    triads = [("s", np.eye(4), 0.2)] if "base" in show else []
    for branch in found:
        links = branch.chain.link_poses(branch.values(q))
        if "home axes" in show:
            _draw_axes(canvas, branch, branch.chain.link_poses(np.zeros(branch.chain.n)), "S", GREY)
        if "axes" in show or "body axes" in show:
            _draw_axes(canvas, branch, links, "S" if "axes" in show else "B", VIOLET)
        triads += [(str(i), T, 0.13) for i, T in enumerate(links, start=1)] if "links" in show else []
        triads += [(branch.tip or "b", branch.chain.fk(branch.values(q)), 0.2)] if "tool" in show else []
    triads += [(name, validation.poses(T, f"frame {name}"), 0.17) for name, T in (frames or {}).items()]
    for name, T, length in triads:
        canvas.triad(T, name, length * canvas.size, [GREY] * 3 if name.endswith("'") else AXIS_COLOURS)
    text = describe_arm(robot, q, ghost=ghost, home_axes="home axes" in show, frames=frames)
    return canvas.picture(text, caption, cropped=around is None)


def draw_joints(chain: Chain, tool: bool = False) -> Picture:
    """Draw an arm at home so that its screw axes can be read off: each joint with its number and its positive direction.

    tool  whether the links are drawn, and the frame {b}

    A dotted line runs from each joint's point, and from the origin of {b}, down to the floor; its foot is labelled with x and y,
    and the line with the height.

    >>> "joint 2 prismatic along z" in draw_joints(kl.robots.rpr()).alt
    True
    """
    (branch,), path, home = branches(chain), stations(chain), np.zeros(chain.n)
    measured = path[1:] if tool else path[1:-1]
    seen = np.concatenate([np.zeros((1, 3)), measured, measured * (1, 1, 0)])
    canvas = Canvas(seen)
    canvas.floor(seen, numbers=True)
    canvas.measure(measured, ORANGE)
    if tool:
        canvas.line(path, LINK_GREY, 5.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(home))
    _draw_axes(canvas, branch, chain.link_poses(home), "", VIOLET)
    for name, T in [("s", np.eye(4)), *[("b", chain.home)] * tool]:
        canvas.triad(T, name, 0.16 * canvas.size)
    return canvas.picture(describe_arm(chain, home, frames={"b": chain.home} if tool else None), cropped=True)


def describe_arm(
    robot: Chain | Tree,
    q: JointValues,
    *,
    ghost: JointValues | None = None,
    home_axes: bool = False,
    frames: Mapping[str, ArrayLike] | None = None,
) -> str:
    """Return the text alternative of a drawing of a robot: the axis of each joint, and the ends, as they are at q.

    ghost      (n,) the configuration that is drawn in grey
    home_axes  whether the axes at home are drawn in grey
    frames     the frames that are drawn, poses (4, 4) in {s}

    js/scene/describe.js says the same of the robot in the viewer.
    """
    found, q = branches(robot), robot.in_order(q)
    if isinstance(robot, Tree):
        count = f"{len(found)} branch{'es'[: 2 * (len(found) != 1)]}"
        kinds = f"{robot.n} independent joint{'s'[: robot.n != 1]}, {count}"
        said = [f"To {one.tip}: {'; '.join([*_joints(one, q), f'its end is at {_end(one, q)} m'])}." for one in found]
    else:
        kinds = f"{robot.n} joint{'s'[: robot.n != 1]} ({robot.joint_types})"
        said = [f"{'; '.join(_joints(found[0], q)).capitalize()}.", f"The end-effector is at {_end(found[0], q)} m."]
    sentences = [f"{robot.name}, {kinds}, {_configuration(q)}.", *said]
    if home_axes:
        axes = [direction_text(axis) for one in found for axis in one.chain.lines.axis[one.shared :]]
        sentences.append(f"In grey, the axes at home: {', '.join(axes)}.")
    if ghost is not None:
        ends = " and ".join(_end(one, robot.in_order(ghost)) for one in found)
        sentences.append(f"In grey, the arm {_configuration(robot.in_order(ghost))}, its end-effector at {ends} m.")
    return " ".join([*sentences, *map(frame_text, (frames or {}).items())])


def _joints(branch: Branch, q: Array) -> list[str]:
    """Write what each joint of a branch that no earlier one has is at q: its number, its name in a tree, its kind, axis and point."""
    links = branch.chain.link_poses(branch.values(q))
    rows = zip(branch.chain.joint_types, carried_axes(branch.chain, links), links[:, :3, 3], strict=True)
    told = [f"{JOINT_KINDS[kind]} along {direction_text(axis)} at {vector_text(point)}" for kind, axis, point in rows]
    names = [
        f"{column + 1} {name}" if branch.tip else f"{column + 1}"
        for column, name in zip(branch.columns, branch.names, strict=True)
    ]
    return [f"joint {name} {text}" for name, text in zip(names, told, strict=True)][branch.shared :]


def _end(branch: Branch, q: Array) -> str:
    return vector_text(branch.chain.fk(branch.values(q))[:3, 3])


def frame_text(frame: tuple[str, ArrayLike]) -> str:
    """Return a sentence about a frame: its name, its origin and the directions of its axes."""
    return f"Frame {{{frame[0]}}} {pose_text(frame[1])}."


def pose_text(pose: ArrayLike, letters: str = "xyz") -> str:
    """Write where the origin of a frame is, and the directions of some of its axes."""
    T = np.asarray(pose, dtype=float)
    axes = ", ".join(f"{letter} along {direction_text(T[:3, 'xyz'.index(letter)])}" for letter in letters)
    return f"at {vector_text(T[:3, 3])}, {axes}"


def _draw_axes(canvas: Canvas, branch: Branch, frames: Array, name: str, colour: str) -> None:
    """Draw each axis as a dashed arrow through its joint, in the positive direction, labelled at its tip."""
    shown = zip(branch.columns, carried_axes(branch.chain, frames), frames[:, :3, 3], strict=True)
    for column, axis, point in list(shown)[branch.shared :]:
        low, high = point - 0.16 * canvas.size * axis, point + 0.3 * canvas.size * axis
        canvas.axis(low, high, name and f"${name}_{column + 1}$", colour)


def direction_text(axis: Array) -> str:
    """Write a direction as "x", "-z", or by its components."""
    for letter, unit in zip("xyz", np.eye(3), strict=True):
        if np.abs(np.abs(axis) - unit).max() < tolerances.TYPED_PI_ERROR:
            return letter if axis @ unit > 0 else f"-{letter}"
    return vector_text(axis)


def _configuration(q: ArrayLike) -> str:
    """Write a configuration as "at home" or by its values."""
    return f"at q = {vector_text(q)}" if np.abs(q).max() > tolerances.TYPED_PI_ERROR else "at home"
