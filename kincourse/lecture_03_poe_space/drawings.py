"""Drawings of lecture 03: an arm with letters, a body on either of two parallel rails, an arm at a wall, and a workspace."""

from collections.abc import Sequence

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, JOINT_FILL, LINK_GREY, ORANGE, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, vector_text
from kinlib.view.drawing.plot import picture_from_figure
from kinlib.view.figures.arm import JOINT_KINDS, direction_text
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import body_motions, draw_joint_bodies, stations


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
    return canvas.picture(_describe_lettered(chain, letters, np.diff(path, axis=0)), cropped=True)


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


def draw_two_rails(travel: float = 0.6) -> Picture:
    """Draw a carriage that has moved by `travel` metres on a rail, and the same motion on a rail that is mounted further back.

    >>> draw_two_rails(0.5).alt[:53]
    'A carriage on a rail along x has moved by 0.5 m; behi'
    """
    d, back = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.7, 0.0])
    box = np.array([(x, y, z) for x in (0, 0.35) for y in (-0.12, 0.12) for z in (0.04, 0.26)])
    canvas = Canvas(np.array([(-0.2, -0.3, 0), (1.6, 1.0, 0.6)]))
    canvas.floor(np.array([(-0.2, -0.3, 0), (1.6, 1.0, 0.6)]))
    for side, colour in ((np.zeros(3), INK), (back, GREY)):
        canvas.line([side - 0.1 * d, side + 1.5 * d], colour, 3.0)
        canvas.body(box + side, PALE_GREY, 2.0)
        canvas.body(box + side + travel * d, JOINT_FILL, 3.0)
        for corner in (box[1], box[3], box[7]):
            canvas.arrow(side + corner + travel * d, side + corner + travel * d + 0.4 * d, VIOLET, 1.6)
        canvas.label(side + 1.5 * d, "rail" if side is not back else "another rail, the same S", colour)
    canvas.label(box[7] + (travel + 0.4) * d, "$d$", VIOLET)
    return canvas.picture(
        f"A carriage on a rail along x has moved by {travel:.2g} m; behind it, the same on a second, parallel rail. "
        "All its points have the same velocity, along d."
    )


def draw_workspace(positions: Array) -> Picture:
    """Draw positions (n, 3) from the side: their height over their distance from the z axis.

    >>> draw_workspace(np.array([[3, 4, 1.0], [1, 0, 2]])).alt
    '2 positions of the tool, from the side: 1.00 to 5.00 m from the z axis, and 1.00 to 2.00 m high.'
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    radius, height = np.hypot(positions[:, 0], positions[:, 1]), positions[:, 2]
    figure = Figure(figsize=(4.2, 4.6), layout="constrained")
    with rc_context({"axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK}):
        axes = figure.subplots()
    axes.scatter(radius, height, s=3, color=VIOLET)
    axes.set(xlabel="distance from the z axis (m)", ylabel="height (m)", aspect="equal", xlim=(0, None))
    alt = (
        f"{len(positions)} positions of the tool, from the side: {radius.min():.2f} to {radius.max():.2f} m from the z axis, "
        f"and {height.min():.2f} to {height.max():.2f} m high."
    )
    return picture_from_figure(figure, alt)


def draw_wall(arm: Chain, q: Array, wall: float, *, elbow: Array) -> Picture:
    """Draw an arm from the side, whose elbow has passed a wall at x = wall.

    elbow  (3,) its position

    >>> draw_wall(kl.robots.ur5e(), np.zeros(6), 0.3, elbow=np.array([0.4, 0, 0.2])).alt[-76:]
    'A wall is at x = 0.3 m. The elbow is at x = 0.4 m, the tool at x = -0.817 m.'
    """
    canvas = Canvas(np.array([(-0.7, -0.4, 0), (0.6, 0.3, 0.9)]), "front")
    body, moved = body_of(arm), body_motions(arm, q)
    draw_body(canvas, body, moved)
    canvas.body(np.array([(wall + w, y, z) for w in (0, 0.02) for y in (-0.4, 0.3) for z in (0, 0.85)]), PALE_GREY, 4.0)
    canvas.line([(wall, -0.4, 0), (wall, -0.4, 0.85)], INK, 2.0, level=4.5)
    canvas.label(np.array([wall, -0.4, 0.85]), "wall", INK)
    canvas.dot(elbow, VIOLET, 8)
    canvas.label(elbow, "elbow", VIOLET)
    canvas.triad(arm.fk(q), "b", 0.12)
    where = f"The elbow is at x = {elbow[0]:.3g} m, the tool at x = {arm.fk(q)[0, 3]:.3g} m."
    text = f"{arm.name}, from the side. A wall is at x = {wall:.3g} m. {where}"
    return canvas.picture(text, where, cropped=True)
