"""Drawings of lecture 03: a body that slides along either of two parallel rails, and the workspace of an arm."""

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.view.drawing.canvas import Canvas
from kinlib.view.drawing.figure_colours import GREY, INK, JOINT_FILL, PALE_GREY, VIOLET
from kinlib.view.drawing.picture import Picture, picture_from_figure


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
