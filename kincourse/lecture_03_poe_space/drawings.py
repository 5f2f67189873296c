"""Drawings of lecture 03: a body on either of two parallel rails, an arm at a wall, and the workspace of an arm."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, JOINT_FILL, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, picture_from_figure
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.body_drawing import draw_body
from kinlib.view.figures.joint_bodies import body_motions


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
