"""Arms, drawn: links, joints, screw axes and frames, in any configuration, with words that say the same."""

from collections.abc import Collection

import numpy as np
from numpy.typing import ArrayLike

from kinlib.chain import Chain
from kinlib.check import Array
from kinlib.screw import line
from kinlib.view.canvas import GREY, INK, ORANGE, VIOLET, Canvas
from kinlib.view.picture import Picture, spoken

SHOWN = {"axes", "body axes", "home axes", "links", "tool", "base"}
KINDS = {"R": "revolute", "P": "prismatic", "H": "helical"}
STEEL, PAPER = "#5b7083", "#f3d9a4"


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
    show    any of "axes" S_i where the joints have carried them, "home axes" where they were read, "body axes" the same
            lines named B_i, "links" frames on the links, "base" {s}, "tool" {b}
    ghost   (n,) another configuration, in grey
    around  points (..., 3) to keep in view, so that pictures of several configurations share one scale

    Raises ValueError for joint values of another size and for something to show that there is not.

    >>> from kinlib.robots import youbot
    >>> print(draw_arm(youbot()).alt)                     # doctest: +NORMALIZE_WHITESPACE
    youBot, 5 joints (RRRRR), at home. Joint 1 revolute along z; joint 2 revolute along -y; joint 3 revolute along -y;
    joint 4 revolute along -y; joint 5 revolute along x. The tool is at (0.54, 0, 0.147) m.
    """
    if unknown := set(show) - SHOWN:
        raise ValueError(f"show knows {', '.join(sorted(SHOWN))}; got {', '.join(map(repr, sorted(unknown)))}.")
    home = np.zeros(chain.n)
    q = home if q is None else np.asarray(q, dtype=float)
    path, shadow = _path(chain, q), _path(chain, q if ghost is None else np.asarray(ghost, dtype=float))
    seen = np.concatenate([path, shadow]) if around is None else around
    canvas = Canvas(seen, view)
    canvas.floor(seen)
    if ghost is not None:
        canvas.line(shadow, GREY, 4.0, level=1)
    canvas.line(path, STEEL, 5.0)
    frames = chain.link_poses(q)
    _draw_joints(canvas, chain, frames)
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
    return canvas.picture(alt or describe(chain, q), caption)


def draw_joints(chain: Chain, caption: str = "", view: str = "default") -> Picture:
    """Draw an arm at home for reading: each joint with its number and its positive direction, on a numbered grid.

    A dotted line drops from each joint to the floor, and its height stands beside it, so that the point can be read off.

    >>> from kinlib.robots import rpr
    >>> "joint 2 prismatic along z" in draw_joints(rpr()).alt
    True
    """
    home = np.zeros(chain.n)
    path = np.concatenate([np.zeros((1, 3)), chain.joint_points])
    canvas = Canvas(np.concatenate([path, path * (1, 1, 0)]), view)
    canvas.floor(path, numbers=True)
    for point in chain.joint_points:
        foot = point * (1, 1, 0)
        canvas.line([foot, point], ORANGE, 1.2, ":", level=1)
        canvas.dot(foot, ORANGE, 3, level=1)
        if point[2]:
            canvas.label((foot + point) / 2, f"{point[2]:g}", ORANGE, [(8, 0), (-8, 0), (8, 10), (-8, -10)], 8)
        canvas.label(foot, f"({foot[0]:g}, {foot[1]:g})", ORANGE, [(0, -9), (0, 9), (24, 0), (-24, 0)], 8)
    _draw_joints(canvas, chain, chain.link_poses(home))
    _draw_axes(canvas, chain, chain.link_poses(home), "", VIOLET)
    canvas.triad(np.eye(4), "s", 0.16 * canvas.size)
    points = "; ".join(f"joint {i + 1} at {spoken(p)}" for i, p in enumerate(chain.joint_points))
    return canvas.picture(f"{describe(chain, home)} Points on the axes: {points}.", caption)


def describe(chain: Chain, q: Array) -> str:
    """Say in words what a drawing of the arm shows.

    >>> from kinlib.robots import hrr
    >>> describe(hrr(), np.zeros(3))[:24]
    'HRR arm, 3 joints (HRR),'
    """
    axis = line(chain.screws).axis
    joints = "; ".join(
        f"joint {i + 1} {KINDS[letter]} along {_direction(axis[i])}" for i, letter in enumerate(chain.letters)
    )
    values = "at home" if not np.any(q) else f"at q = {spoken(q)}"
    tool = spoken(chain.fk(q)[:3, 3])
    return (
        f"{chain.name}, {chain.n} joints ({chain.letters}), {values}. {joints.capitalize()}. The tool is at {tool} m."
    )


def reach(chain: Chain, low: Array, high: Array) -> Array:
    """Points (m, 3) that the arm may touch between two configurations: what a picture of all of them should hold.

    >>> from kinlib.robots import rpr
    >>> reach(rpr(), np.zeros(3), np.ones(3)).shape[1]
    3
    """
    mix = np.random.default_rng(0).random((200, chain.n))
    q = low + (high - low) * mix
    points = np.concatenate([chain.link_poses(q)[..., :3, 3], chain.fk(q)[:, None, :3, 3]], axis=1)
    return np.concatenate([points.reshape(-1, 3), np.zeros((1, 3))])


def _path(chain: Chain, q: Array) -> Array:
    """The points through which the links run: the base, every joint, the tool."""
    joints = chain.link_poses(q)[:, :3, 3]
    return np.concatenate([np.zeros((1, 3)), joints, chain.fk(q)[None, :3, 3]])


def _draw_axes(canvas: Canvas, chain: Chain, frames: Array, name: str, colour: str) -> None:
    """Each axis as a dashed arrow through its joint, in the positive direction, named at its tip."""
    for i, T in enumerate(frames):
        direction = T[:3, :3] @ line(chain.screws[i]).axis
        before, after = T[:3, 3] - 0.16 * canvas.size * direction, T[:3, 3] + 0.3 * canvas.size * direction
        canvas.line([before, after], colour, 1.3, "--", level=3.5)
        canvas.arrow(after - 0.01 * canvas.size * direction, after, colour, 1.3, level=3.6)
        if name:
            canvas.label(after, f"${name}_{i + 1}$", colour)


def _draw_joints(canvas: Canvas, chain: Chain, frames: Array) -> None:
    """Each joint as its kind: a cylinder about its axis, a box along it, a cylinder with a thread; and its number."""
    size = 0.035 * canvas.size
    angles = np.linspace(0, 2 * np.pi, 33)
    for i, (T, letter) in enumerate(zip(frames, chain.letters, strict=True)):
        z = T[:3, :3] @ line(chain.screws[i]).axis
        x = np.cross(np.eye(3)[np.argmin(np.abs(z))], z)
        x /= np.linalg.norm(x)
        y = np.cross(z, x)
        sides = 4 if letter == "P" else 32
        turn = np.linspace(0, 2 * np.pi, sides + 1) + np.pi / 4
        ring = size * (np.cos(turn)[:, None] * x + np.sin(turn)[:, None] * y)
        half = 1.5 * size * z
        level = 3.0 + 0.001 * float(canvas.eye @ T[:3, 3])
        canvas.body(np.concatenate([T[:3, 3] + ring - half, T[:3, 3] + ring + half]), PAPER, level)
        near = half if canvas.eye @ z > 0 else -half
        canvas.line(T[:3, 3] + ring + near, INK, 1.0, level=level + 0.0002)
        if letter == "H":
            thread = (
                size * (np.cos(3 * angles)[:, None] * x + np.sin(3 * angles)[:, None] * y)
                + np.linspace(-1, 1, 33)[:, None] * half
            )
            canvas.line(T[:3, 3] + thread, INK, 1.2, level=level + 0.0004)
        canvas.label(
            T[:3, 3],
            str(i + 1),
            INK,
            [(14, 10), (-14, 10), (14, -12), (-14, -12), (26, 0), (-26, 0), (0, 22), (0, -24)],
            10,
        )


def _direction(axis: Array) -> str:
    """Name a direction: "x", "-z", or its components."""
    for letter, unit in zip("xyz", np.eye(3), strict=True):
        if np.allclose(np.abs(axis), unit):
            return letter if axis @ unit > 0 else f"-{letter}"
    return spoken(axis)
