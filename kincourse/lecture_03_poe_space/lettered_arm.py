"""The drawing of an arm whose lengths are letters, as in the exercises of a textbook."""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import JOINT_KINDS, direction_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies, stations


def draw_lettered_joints(chain: Chain, letters: Sequence[str]) -> Picture:
    """Draw an arm at home with its screw axes, the frame {b}, and beside each link the letter of its length.

    letters  (n + 1,) "L_1" and so on: from the origin of {s} to joint 1, from joint to joint, and to {b}; "" for points that coincide

    >>> print(draw_lettered_joints(kl.robots.plain_arm(), ["", "L_1", "", "L_2", "L_3"]).alt)      # doctest: +NORMALIZE_WHITESPACE
    An arm with 4 joints (RRPR) at home. From the origin of {s}: there joint 1 (revolute, axis along z);
    L_1 along z to joint 2 (revolute, axis along -y); there joint 3 (prismatic, axis along x);
    L_2 along x to joint 4 (revolute, axis along x); L_3 along x to the origin of {b}.
    In {s}, the axes of {b} are x = (1, 0, 0), y = (0, 1, 0), z = (0, 0, 1).
    """
    path = stations(chain)
    canvas = Canvas(path)
    canvas.line(path, LINK_GREY, 5.0)
    for start, end, letter in zip(path[:-1], path[1:], letters, strict=True):
        right, up = canvas.along(start, end)  # across its link, a letter is nearer to it than to any other one
        places = [(-far * up, far * right) for far in (14, -14, 21, -21, 28, -28)]
        if letter:
            canvas.label((start + end) / 2, f"${letter}$", ORANGE, places, size=12)
    draw_joint_bodies(canvas, chain, chain.link_poses(np.zeros(chain.n)))
    for i, (axis, point) in enumerate(zip(chain.lines.axis, chain.joint_points, strict=True), start=1):
        canvas.axis(point - 0.16 * canvas.size * axis, point + 0.3 * canvas.size * axis, f"$S_{i}$")
    for name, T in (("s", np.eye(4)), ("b", chain.home)):
        canvas.triad(T, name, 0.16 * canvas.size)
    return canvas.picture(_describe(chain, letters, np.diff(path, axis=0)), cropped=True)


def _describe(chain: Chain, letters: Sequence[str], steps: Array) -> str:
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
