"""Drawings of arms in any configuration: links, joints, screw axes and frames, and the text alternative of such a drawing."""

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays import tolerances, validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import inverse
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import AXIS_COLOURS, GHOST_GREY, GREY, INK, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.labels import LABEL_OFFSETS, Offset
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import carried_axes, draw_joint_bodies, stations

LETTER_LEAD_PX = 2.0
"""By how much nearer a letter is to its own link than to any other one."""

ARM_LAYERS = {"axes", "body axes", "home axes", "links", "tool", "base"}
JOINT_KINDS = {"R": "revolute", "P": "prismatic", "H": "helical"}


def draw_arm(
    chain: Chain,
    q: JointValues | None = None,
    *,
    show: Collection[str] = ("axes", "base", "tool"),
    caption: str = "",
    ghost: JointValues | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw an arm in a configuration.

    q       (n,) joint values, or a mapping from joint names to values; home by default
    show    any of "axes" (the screw axes S_i as the joints have moved them), "home axes" (the same axes at home), "body axes"
            (as "axes", but named B_i), "links" (a frame on each link), "base" ({s}) and "tool" ({b})
    ghost   (n,) another configuration, drawn in grey
    frames  {"0": T_00, "1": T_01, ...} frames to draw, poses (4, 4) in {s} at q; those with a prime, "1'", in grey
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    The text alternative describes the axes and the end-effector at q, as they are drawn.

    Raises ValueError if q or ghost does not have n values, if a frame is not a pose, or if show has another entry.

    >>> print(draw_arm(kl.robots.youbot()).alt)                     # doctest: +NORMALIZE_WHITESPACE
    youBot, 5 joints (RRRRR), at home. Joint 1 revolute along z at (0, 0, 0); joint 2 revolute along -y at (0.033, 0,
    0.147); joint 3 revolute along -y at (0.188, 0, 0.147); joint 4 revolute along -y at (0.323, 0, 0.147); joint 5 revolute
    along x at (0.323, 0, 0.147). The end-effector is at (0.54, 0, 0.147) m.
    """
    if unknown := set(show) - ARM_LAYERS:
        names = ", ".join(map(repr, sorted(unknown)))
        raise ValueError(f"show may contain {', '.join(sorted(ARM_LAYERS))}; got {names}.")
    validation.instance(chain, "chain", Chain)
    q = np.zeros(chain.n) if q is None else validation.single(chain.in_order(q), "q")
    ghost = None if ghost is None else validation.single(chain.in_order(ghost), "ghost")
    shadow, body, moved = stations(chain, q if ghost is None else ghost), body_of(chain), body_motions(chain, q)
    whole = np.concatenate([stations(chain, q), shadow, body.extent(moved)])
    seen = whole if around is None else np.reshape(around, (-1, 3))
    canvas = Canvas(seen, view, sizes=stations(chain))
    canvas.floor(seen, height=body.lowest)
    if ghost is not None:
        canvas.line(shadow, GHOST_GREY, 6.0, level=1)
    draw_body(canvas, body, moved)
    links = chain.link_poses(q)
    if "home axes" in show:
        _draw_axes(canvas, chain, chain.link_poses(np.zeros(chain.n)), "S", GREY)
    if "axes" in show or "body axes" in show:
        _draw_axes(canvas, chain, links, "S" if "axes" in show else "B", VIOLET)
    triads = [("s", np.eye(4), 0.2)] if "base" in show else []
    triads += [(str(i), T, 0.13) for i, T in enumerate(links, start=1)] if "links" in show else []
    triads += [("b", chain.fk(q), 0.2)] if "tool" in show else []
    triads += [(name, validation.poses(T, f"frame {name}"), 0.17) for name, T in (frames or {}).items()]
    for name, T, length in triads:
        canvas.triad(T, name, length * canvas.size, [GREY] * 3 if name.endswith("'") else AXIS_COLOURS)
    text = describe_arm(chain, q, ghost=ghost, home_axes="home axes" in show, frames=frames)
    return canvas.picture(text, caption, cropped=around is None)


def body_motions(chain: Chain, q: Array) -> Array:
    """Return the motion of each body from home to q, (n + 1, 4, 4): body 0 is the base, body i is what joint i moves."""
    moved = chain.link_poses(q) @ inverse(chain.link_poses(np.zeros(chain.n)))
    return np.concatenate([np.eye(4)[None], moved])


def draw_joints(chain: Chain, tool: bool = False) -> Picture:
    """Draw an arm at home so that its screw axes can be read off: each joint with its number and its positive direction.

    The grid has numbers. A dotted line runs from each joint's point down to the floor; its foot is labelled with x and y, and
    the line with the height. If tool is true, the links are drawn and the frame {b}, whose origin is labelled in the same way.

    >>> "joint 2 prismatic along z" in draw_joints(kl.robots.rpr()).alt
    True
    """
    home = np.zeros(chain.n)
    measured = np.concatenate([chain.joint_points, chain.home[None, :3, 3]]) if tool else chain.joint_points
    seen = np.concatenate([np.zeros((1, 3)), measured, measured * (1, 1, 0)])
    canvas = Canvas(seen)
    canvas.floor(seen, numbers=True)
    canvas.measure(measured, ORANGE)
    if tool:
        canvas.line(stations(chain), LINK_GREY, 5.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(home))
    _draw_axes(canvas, chain, chain.link_poses(home), "", VIOLET)
    canvas.triad(np.eye(4), "s", 0.16 * canvas.size)
    if tool:
        canvas.triad(chain.home, "b", 0.16 * canvas.size)
    return canvas.picture(describe_arm(chain, home, frames={"b": chain.home} if tool else None), cropped=True)


def draw_lettered_chain(chain: Chain, letters: Sequence[str], home: bool = True) -> Picture:
    """Draw a chain at home with a letter beside each link, an arrow S_i for each axis, and the frames {s} and {b}.

    letters  (n + 1,) the lengths, "L_1" and so on: from the origin of {s} to joint 1, from joint to joint, and to {b}; "" for
             points that coincide
    home     whether to draw M as a dashed arrow from {s} to {b}

    >>> print(draw_lettered_chain(kl.robots.plain_arm(), ["", "L_1", "", "L_2", "L_3"]).alt)      # doctest: +NORMALIZE_WHITESPACE
    An arm with 4 joints (RRPR) at home. From the origin of {s}: there joint 1 (revolute, axis along z);
    L_1 along z to joint 2 (revolute, axis along -y); there joint 3 (prismatic, axis along x);
    L_2 along x to joint 4 (revolute, axis along x); L_3 along x to the origin of {b}.
    In {s}, the axes of {b} are x = (1, 0, 0), y = (0, 1, 0), z = (0, 0, 1).
    """
    path = stations(chain)
    steps = np.diff(path, axis=0)
    canvas = Canvas(path)
    canvas.line(path, LINK_GREY, 5.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(np.zeros(chain.n)))
    _draw_axes(canvas, chain, chain.link_poses(np.zeros(chain.n)), "S", VIOLET)
    if home:
        canvas.arrow(path[0], path[-1], GREY, 1.4, style="--", level=1)
        canvas.label(path[[0, -1]].mean(axis=0), "$M$", INK, size=12)
    canvas.triad(np.eye(4), "s", 0.17 * canvas.size)
    canvas.triad(chain.home, "b", 0.17 * canvas.size)
    for k, letter in enumerate(letters):
        if letter:
            canvas.label(path[k : k + 2].mean(axis=0), f"${letter}$", ORANGE, _offsets_beside(canvas, path, k), size=12)
    return canvas.picture(_describe_lettered(chain, letters, steps), cropped=True)


def _offsets_beside(canvas: Canvas, path: Array, k: int) -> Sequence[Offset]:
    """Return the offsets from the middle of link k at which a letter is nearer to this link than to any other one."""
    start, along = canvas.to_pixels(path)[:-1], np.diff(canvas.to_pixels(path), axis=0)
    ways = np.concatenate(
        [LABEL_OFFSETS * np.array([1, -1]) + share * along[k] for share in (0, 0.2, -0.2, 0.35, -0.35)]
    )
    from_start = start[k] + along[k] / 2 + ways[:, None] - start
    shares = ((from_start * along).sum(axis=-1) / np.maximum((along**2).sum(axis=-1), 1e-9)).clip(0, 1)
    far = np.linalg.norm(from_start - shares[..., None] * along, axis=-1)
    is_own = far[:, k] + LETTER_LEAD_PX < np.delete(far, k, axis=1).min(axis=1, initial=np.inf)
    return [(x, -y) for x, y in ways[is_own].tolist()] or LABEL_OFFSETS


def _describe_lettered(chain: Chain, letters: Sequence[str], steps: Array) -> str:
    kinds = zip(chain.joint_types, chain.lines.axis, strict=True)
    joints = [
        f"joint {i} ({JOINT_KINDS[kind]}, axis along {direction_text(axis)})" for i, (kind, axis) in enumerate(kinds, 1)
    ]
    walk = "; ".join(
        f"{letter} along {direction_text(step / np.linalg.norm(step))} to {there}" if letter else f"there {there}"
        for letter, step, there in zip(letters, steps, [*joints, "the origin of {b}"], strict=True)
    )
    axes = ", ".join(
        f"{name} = {vector_text(axis)}" for name, axis in zip("xyz", chain.home[:3, :3].T.round(6), strict=True)
    )
    head = f"An arm with {chain.n} joints ({chain.joint_types}) at home. From the origin of {{s}}: {walk}."
    return f"{head} In {{s}}, the axes of {{b}} are {axes}."


def describe_arm(
    chain: Chain,
    q: JointValues,
    *,
    ghost: JointValues | None = None,
    home_axes: bool = False,
    frames: Mapping[str, ArrayLike] | None = None,
) -> str:
    """Return the text alternative of a drawing of an arm: the axis of each joint and the end-effector, as they are at q.

    ghost      (n,) the configuration that is drawn in grey
    home_axes  whether the axes at home are drawn in grey
    frames     the frames that are drawn, poses (4, 4) in {s}

    js/scene/describe.js says the same of the arm in the viewer.
    """
    q = chain.in_order(q)
    joints = "; ".join(f"joint {i} {text}" for i, text in enumerate(joint_texts(chain, q), start=1))
    sentences = [
        f"{chain.name}, {chain.n} joint{'s'[: chain.n != 1]} ({chain.joint_types}), {configuration_text(q)}.",
        f"{joints.capitalize()}.",
        f"The end-effector is at {vector_text(chain.fk(q)[:3, 3])} m.",
    ]
    if home_axes:
        sentences.append(f"In grey, the axes at home: {', '.join(map(direction_text, chain.lines.axis))}.")
    if ghost is not None:
        ghost = chain.in_order(ghost)
        tool = vector_text(chain.fk(ghost)[:3, 3])
        sentences.append(f"In grey, the arm {configuration_text(ghost)}, its end-effector at {tool} m.")
    return " ".join([*sentences, *map(frame_text, (frames or {}).items())])


def joint_texts(chain: Chain, q: Array) -> list[str]:
    """Write what each joint is at q: its kind, its axis and its point."""
    links = chain.link_poses(q)
    rows = zip(chain.joint_types, carried_axes(chain, links), links[:, :3, 3], strict=True)
    return [f"{JOINT_KINDS[kind]} along {direction_text(axis)} at {vector_text(point)}" for kind, axis, point in rows]


def frame_text(frame: tuple[str, ArrayLike]) -> str:
    """Return a sentence about a frame: its name, its origin and the directions of its axes."""
    name, T = frame[0], np.asarray(frame[1], dtype=float)
    axes = ", ".join(f"{letter} along {direction_text(axis)}" for letter, axis in zip("xyz", T[:3, :3].T, strict=True))
    return f"Frame {{{name}}} at {vector_text(T[:3, 3])}, {axes}."


def _draw_axes(canvas: Canvas, chain: Chain, frames: Array, name: str, colour: str) -> None:
    """Draw each axis as a dashed arrow through its joint, in the positive direction, labelled at its tip."""
    for i, T in enumerate(frames):
        direction = T[:3, :3] @ chain.lines.axis[i]
        before, after = T[:3, 3] - 0.16 * canvas.size * direction, T[:3, 3] + 0.3 * canvas.size * direction
        canvas.arrow(before, after, colour, 1.5, style="--", level=3.5)
        if name:
            canvas.label(after, f"${name}_{i + 1}$", colour)


def pose_text(T: Array) -> str:
    """Write where a DH frame is: its origin, and the directions of x and z, from which y follows."""
    return f"at {vector_text(T[:3, 3])}, x along {vector_text(T[:3, 0])}, z along {vector_text(T[:3, 2])}"


def direction_text(axis: Array) -> str:
    """Write a direction as "x", "-z", or by its components."""
    for letter, unit in zip("xyz", np.eye(3), strict=True):
        if np.abs(np.abs(axis) - unit).max() < tolerances.TYPED_PI_ERROR:
            return letter if axis @ unit > 0 else f"-{letter}"
    return vector_text(axis)


def configuration_text(q: ArrayLike) -> str:
    """Write a configuration as "at home" or by its values."""
    return f"at q = {vector_text(q)}" if np.abs(q).max() > tolerances.TYPED_PI_ERROR else "at home"
