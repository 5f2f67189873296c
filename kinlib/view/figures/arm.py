"""Drawings of arms in any configuration: links, joints, screw axes and frames, and the text alternative of such a drawing."""

from collections.abc import Collection

import numpy as np
from numpy.typing import ArrayLike

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GHOST_GREY, GREY, LINK_GREY, ORANGE, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies

ARM_LAYERS = {"axes", "body axes", "home axes", "links", "tool", "base"}
JOINT_KINDS = {"R": "revolute", "P": "prismatic", "H": "helical"}


def draw_arm(
    chain: Chain,
    q: ArrayLike | None = None,
    *,
    show: Collection[str] = ("axes", "base", "tool"),
    alt: str | None = None,
    caption: str = "",
    ghost: ArrayLike | None = None,
    around: ArrayLike | None = None,
    view: str = "default",
) -> Picture:
    """Draw an arm in a configuration.

    q       (n,) joint values, home by default
    show    any of "axes" (the screw axes S_i as the joints have moved them), "home axes" (the same axes at home), "body axes"
            (as "axes", but named B_i), "links" (a frame on each link), "base" ({s}) and "tool" ({b})
    ghost   (n,) another configuration, drawn in grey
    around  points (..., 3) to keep in view, so that pictures of several configurations have the same scale

    Raises ValueError if q or ghost does not have n values, or if show has another entry.

    >>> from kinlib.chains.robots import youbot
    >>> print(draw_arm(youbot()).alt)                     # doctest: +NORMALIZE_WHITESPACE
    youBot, 5 joints (RRRRR), at home. Joint 1 revolute along z; joint 2 revolute along -y; joint 3 revolute along -y;
    joint 4 revolute along -y; joint 5 revolute along x. The tool is at (0.54, 0, 0.147) m.
    """
    if unknown := set(show) - ARM_LAYERS:
        raise ValueError(
            f"show may contain {', '.join(sorted(ARM_LAYERS))}; got {', '.join(map(repr, sorted(unknown)))}."
        )
    home = np.zeros(chain.n)
    q = home if q is None else np.asarray(q, dtype=float)
    path, shadow = _path(chain, q), _path(chain, q if ghost is None else np.asarray(ghost, dtype=float))
    seen = np.concatenate([path, shadow]) if around is None else around
    canvas = Canvas(seen, view, sizes=_path(chain, home))
    canvas.floor(seen)
    if ghost is not None:
        canvas.line(shadow, GHOST_GREY, 6.0, level=1)
    canvas.line(path, LINK_GREY, 6.0)
    frames = chain.link_poses(q)
    draw_joint_bodies(canvas, chain, frames)
    if "home axes" in show:
        _draw_axes(canvas, chain, chain.link_poses(home), "S", GREY)
    if "axes" in show or "body axes" in show:
        _draw_axes(canvas, chain, frames, "S" if "axes" in show else "B", VIOLET)
    if "base" in show:
        canvas.triad(np.eye(4), "s", 0.2 * canvas.size)
    if "links" in show:
        for i, T in enumerate(frames):
            canvas.triad(T, str(i + 1), 0.13 * canvas.size)
    if "tool" in show:
        canvas.triad(chain.fk(q), "b", 0.2 * canvas.size)
    return canvas.picture(alt or describe_arm(chain, q), caption)


def draw_joints(chain: Chain, tool: bool = False, caption: str = "", view: str = "default") -> Picture:
    """Draw an arm at home so that its screw axes can be read off: each joint with its number and its positive direction.

    The grid has numbers. A dotted line runs from each joint's point down to the floor; its foot is labelled with x and y, and
    the line with the height. If tool is true, the frame {b} is drawn and its origin is labelled in the same way.

    >>> from kinlib.chains.robots import rpr
    >>> "joint 2 prismatic along z" in draw_joints(rpr()).alt
    True
    """
    home = np.zeros(chain.n)
    measured = np.concatenate([chain.joint_points, chain.home[None, :3, 3]]) if tool else chain.joint_points
    seen = np.concatenate([np.zeros((1, 3)), measured, measured * (1, 1, 0)])
    canvas = Canvas(seen, view)
    canvas.floor(seen, numbers=True)
    canvas.measure(measured, ORANGE)
    draw_joint_bodies(canvas, chain, chain.link_poses(home))
    _draw_axes(canvas, chain, chain.link_poses(home), "", VIOLET)
    canvas.triad(np.eye(4), "s", 0.16 * canvas.size)
    if tool:
        canvas.triad(chain.home, "b", 0.16 * canvas.size)
    points = "; ".join(f"joint {i + 1} at {vector_text(p)}" for i, p in enumerate(chain.joint_points))
    return canvas.picture(f"{describe_arm(chain, home)} Points on the axes: {points}.", caption)


def describe_arm(chain: Chain, q: Array) -> str:
    """Return the text alternative of a drawing of an arm: its joints, its configuration, and where its tool is.

    >>> from kinlib.chains.robots import hrr
    >>> describe_arm(hrr(), np.zeros(3))[:24]
    'HRR arm, 3 joints (HRR),'
    """
    axis = chain.lines.axis
    joints = "; ".join(
        f"joint {i + 1} {JOINT_KINDS[letter]} along {_direction(axis[i])}" for i, letter in enumerate(chain.joint_types)
    )
    values = "at home" if not np.any(q) else f"at q = {vector_text(q)}"
    tool = vector_text(chain.fk(q)[:3, 3])
    return f"{chain.name}, {chain.n} joints ({chain.joint_types}), {values}. {joints.capitalize()}. The tool is at {tool} m."


def reachable_points(chain: Chain, low: Array, high: Array) -> Array:
    """Return points (m, 3) that the arm reaches between two configurations, so that a picture can keep all of them in view.

    >>> from kinlib.chains.robots import rpr
    >>> reachable_points(rpr(), np.zeros(3), np.ones(3)).shape[1]
    3
    """
    mix = np.random.default_rng(0).random((200, chain.n))
    q = low + (high - low) * mix
    points = np.concatenate([chain.link_poses(q)[..., :3, 3], chain.fk(q)[:, None, :3, 3]], axis=1)
    return np.concatenate([points.reshape(-1, 3), np.zeros((1, 3))])


def _path(chain: Chain, q: Array) -> Array:
    """Return the points through which the links run: the base, every joint, the tool."""
    joints = chain.link_poses(q)[:, :3, 3]
    return np.concatenate([np.zeros((1, 3)), joints, chain.fk(q)[None, :3, 3]])


def _draw_axes(canvas: Canvas, chain: Chain, frames: Array, name: str, colour: str) -> None:
    """Draw each axis as a dashed arrow through its joint, in the positive direction, labelled at its tip."""
    for i, T in enumerate(frames):
        direction = T[:3, :3] @ chain.lines.axis[i]
        before, after = T[:3, 3] - 0.16 * canvas.size * direction, T[:3, 3] + 0.3 * canvas.size * direction
        canvas.arrow(before, after, colour, 1.5, style="--", level=3.5)
        if name:
            canvas.label(after, f"${name}_{i + 1}$", colour)


def _direction(axis: Array) -> str:
    """Write a direction as "x", "-z", or by its components."""
    for letter, unit in zip("xyz", np.eye(3), strict=True):
        if np.allclose(np.abs(axis), unit):
            return letter if axis @ unit > 0 else f"-{letter}"
    return vector_text(axis)
