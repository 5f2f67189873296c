"""An open chain at home with its screw axes, its home pose M and letters for its lengths: all that its formula needs."""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, LINK_GREY, ORANGE
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.figures.arm import JOINT_KINDS, direction_text
from kinlib.view.figures.joint_bodies import draw_joint_bodies, stations


def draw_lettered_chain(chain: Chain, letters: Sequence[str], home: bool = True) -> Picture:
    """Draw a chain at home with a letter beside each link, an arrow S_i for each axis, and the frames {s} and {b}.

    letters  (n + 1,) the lengths, "L_1" and so on: from the origin of {s} to joint 1, from joint to joint, and to {b}; "" for
             points that coincide
    home     whether to draw M as a dashed arrow from {s} to {b}

    Raises ValueError if the number of letters is not n + 1, or if a link with a letter has no length, or the other way round.

    >>> from kinlib.chains.robots import plain_arm
    >>> print(draw_lettered_chain(plain_arm(), ["", "L_1", "", "L_2", "L_3"]).alt)      # doctest: +NORMALIZE_WHITESPACE
    An arm with 4 joints (RRPR) at home. From the origin of {s}: there joint 1 (revolute, axis along z);
    L_1 along z to joint 2 (revolute, axis along -y); there joint 3 (prismatic, axis along x);
    L_2 along x to joint 4 (revolute, axis along x); L_3 along x to the origin of {b}.
    In {s}, the axes of {b} are x = (1, 0, 0), y = (0, 1, 0), z = (0, 0, 1).
    """
    path = stations(chain)
    steps = np.diff(path, axis=0)
    if [bool(letter) for letter in letters] != (np.linalg.norm(steps, axis=-1) > 1e-9).tolist():
        raise ValueError(
            f"letters must have {len(steps)} entries, one for each link, with '' where two points coincide; got {list(letters)}."
        )
    canvas = Canvas(path)
    canvas.line(path, LINK_GREY, 5.0)
    draw_joint_bodies(canvas, chain, chain.link_poses(np.zeros(chain.n)))
    for i, (axis, point) in enumerate(zip(chain.lines.axis, chain.joint_points, strict=True), start=1):
        ends = point - 0.13 * canvas.size * axis, point + 0.27 * canvas.size * axis
        canvas.axis(*ends, f"$S_{i}$", width=1.6, size=12)
    if home:
        canvas.arrow(path[0], path[-1], GREY, 1.4, style="--", level=1)
        canvas.label(path[[0, -1]].mean(axis=0), "$M$", INK, size=12)
    canvas.triad(np.eye(4), "s", 0.17 * canvas.size)
    canvas.triad(chain.home, "b", 0.17 * canvas.size)
    for letter, start, end in zip(letters, path[:-1], path[1:], strict=True):
        if letter:
            canvas.label((start + end) / 2, f"${letter}$", ORANGE, size=12)
    return canvas.picture(_description(chain, letters, steps), cropped=True)


def _description(chain: Chain, letters: Sequence[str], steps: Array) -> str:
    joints = [
        f"joint {i} ({JOINT_KINDS[kind]}, axis along {direction_text(axis)})"
        for i, (kind, axis) in enumerate(zip(chain.joint_types, chain.lines.axis, strict=True), start=1)
    ]
    walk = "; ".join(
        f"{letter} along {direction_text(step / np.linalg.norm(step))} to {there}" if letter else f"there {there}"
        for letter, step, there in zip(letters, steps, [*joints, "the origin of {b}"], strict=True)
    )
    axes = ", ".join(
        f"{name} = {vector_text(axis)}" for name, axis in zip("xyz", chain.home[:3, :3].T.round(6), strict=True)
    )
    return (
        f"An arm with {chain.n} joints ({chain.joint_types}) at home. From the origin of {{s}}: {walk}. In {{s}}, the axes of "
        f"{{b}} are {axes}."
    )
